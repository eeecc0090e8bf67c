"""The transforms that nodes send and look up, by the names of their coordinate frames."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.reach import blueprints_of
from archlint.model import given
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.model import ApiCall
    from archlint.place import Place
    from archlint.systems.model import System
    from archlint.systems.nodes import Node

LOOK_UP = ("tf2_ros.buffer.Buffer.", "tf2_ros.buffer_h.Buffer.")
"""How the calls begin that read transforms, in Python and in C++."""
TRANSFORMS = "tf2_ros."
"""How the creations begin that bring transforms, or take them."""


@dataclass(frozen=True)
class Transform:
    """A transform that a node sends, from ``parent`` to ``child``, or that it looks up, from target to source.  A frame
    is None where it is not known; not ``certain`` is one of several."""

    node: Node | None
    parent: str | None
    child: str | None
    place: Place
    certain: bool = True

    @property
    def known(self) -> tuple[str, str] | None:
        """Both frames, where both are known."""
        return None if self.parent is None or self.child is None else (self.parent, self.child)


def transforms_of(node: Node | None, call: ApiCall) -> Iterator[Transform]:
    """The transforms that a call of a node sends or looks up."""
    for pair in call.frames:
        row = Transform(node, _frame(node, pair.parent), _frame(node, pair.child), call.place, pair.certain)
        if row.certain or row.parent != row.child or row.known is None:
            yield row  # of several pairs, none is a frame in itself


def _frame(node: Node | None, value: given.Given) -> str | None:
    """The name of a frame, with what a launch file sets for the parameters that it comes from.

    tf2 takes a slash at the start of a name away."""
    if not isinstance(value, given.Constant) or not isinstance(value.value, str):
        return None
    text = value.value
    overrides = {} if node is None else node.overrides
    for parameter in sorted(value.parameters & overrides.keys()):
        override = overrides[parameter]
        if override != text:
            is_the_value = len(value.parameters) == 1 and text in _defaults(node, parameter)
            if not is_the_value or not isinstance(override, str):
                return None  # it is made from the parameter, or what is set is not known
            text = override
    return text.removeprefix("/") or None


def _defaults(node: Node | None, parameter: str) -> Iterator[object]:
    for declaration in () if node is None else node.parameters:
        if declaration.name.text == parameter and declaration.known:
            yield declaration.default


# ------------------------------------------------------------------------------------ static_transform_publisher

_PACKAGE, _EXECUTABLE = "tf2_ros", "static_transform_publisher"
_OPTIONS = ("--frame-id", "--child-frame-id")
_OLD_FORMS = (8, 9)
"""``x y z yaw pitch roll parent child``, and the same with a quaternion.  Source: geometry2,
``static_transform_broadcaster_program.cpp``."""


def static_transform(node: Node) -> Transform | None:
    """What a launch file has ``static_transform_publisher`` send; None for any other node."""
    started = node.started
    if (node.package, node.executable) != (_PACKAGE, _EXECUTABLE) or started is None:
        return None
    words = started.arguments if started.knows_all_arguments else []
    words = words[: words.index("--ros-args")] if "--ros-args" in words else words
    if any(word is not None and word.startswith("--") for word in words):
        parent, child = (_after(words, option) for option in _OPTIONS)
    else:
        parent, child = words[-2:] if len(words) in _OLD_FORMS else (None, None)
    place = started.places.get("arguments", started.place)
    names = [None if name is None else name.removeprefix("/") or None for name in (parent, child)]
    return Transform(node, names[0], names[1], place, not started.dormant)


def _after(words: Sequence[str | None], option: str) -> str | None:
    at = words.index(option) + 1 if option in words else len(words)
    return words[at] if at < len(words) else None


# -------------------------------------------------------------------------------------------- of a whole system


@once
def sent_transforms(system: System) -> Sequence[Transform]:
    """All that the nodes of a system send, in the order of the source."""
    rows = list(_of_calls(system, looked_up=False))
    rows += [row for node in system.nodes if (row := static_transform(node)) is not None]
    return sorted(dict.fromkeys(rows), key=_order)


@once
def looked_up_transforms(system: System) -> Sequence[Transform]:
    """All that the nodes of a system look up, in the order of the source."""
    return sorted(dict.fromkeys(_of_calls(system, looked_up=True)), key=_order)


def _of_calls(system: System, *, looked_up: bool) -> Iterator[Transform]:
    nodes: dict[int, list[Node]] = {}
    for node in system.entries:
        for blueprint in node.blueprints:
            nodes.setdefault(id(blueprint), []).append(node)
    for program in system.programs:
        for call in program.calls:
            if call.frames and call.api.startswith(LOOK_UP) == looked_up:
                on = {id(node): node for blueprint in blueprints_of(call) for node in nodes.get(id(blueprint), ())}
                for node in on.values():
                    yield from transforms_of(node, call)


def _order(row: Transform) -> tuple[object, ...]:
    return row.place, "" if row.node is None else row.node.name or "", row.parent or "", row.child or ""


__all__ = [
    "LOOK_UP",
    "TRANSFORMS",
    "Transform",
    "looked_up_transforms",
    "sent_transforms",
    "static_transform",
    "transforms_of",
]
