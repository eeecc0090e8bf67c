"""The coordinate frames of transforms that code sends and looks up.

Source: geometry2, ``transform_broadcaster.py``, ``static_transform_broadcaster.py``, ``buffer_interface.py`` and
``buffer.py`` of tf2_ros.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import product
from typing import TYPE_CHECKING

from archlint.interpreter.values import Known, ListValue, Unknown, Value, alternatives
from archlint.libraries.givens import given_by
from archlint.libraries.rclpy import messages
from archlint.libraries.values import MessageValue
from archlint.model import FramePair, given

if TYPE_CHECKING:
    from archlint.libraries.run import Run

_STAMPED = "geometry_msgs/msg/TransformStamped"
_MOST_PAIRS = 64
"""Of one call; one that sends more is not known."""
_NOT_KNOWN = FramePair(given.UNKNOWN, given.UNKNOWN)


def frames_of(run: Run, api: str, arguments: Mapping[str, Value]) -> Sequence[FramePair]:
    """The frames that a call is about; none where it is about none."""
    if api.endswith(".sendTransform"):
        pairs = list(_sent(run, arguments.get("transform", Unknown("nothing is sent"))))
    elif not api.startswith(("tf2_ros.buffer.Buffer.", "tf2_ros.buffer_h.Buffer.")):
        return ()
    else:
        target = arguments.get("target_frame")
        source = arguments.get("source_frame")
        if source is None:
            source = _field(run, _field(run, arguments.get("object_stamped"), "header"), "frame_id")
        pairs = list(_pairs(run, target, source))
    return pairs if 0 < len(pairs) <= _MOST_PAIRS else [_NOT_KNOWN]


def _sent(run: Run, value: Value) -> Iterator[FramePair]:
    """Of a message, or of each in a list."""
    if isinstance(value, ListValue):
        items = value.items(run)
        for item in items.values:
            yield from _sent(run, item)
        if items.open:
            yield _NOT_KNOWN
        return
    messages = alternatives(value)
    for message in messages:
        if isinstance(message, MessageValue) and message.type == _STAMPED:
            parent = _field(run, _field(run, message, "header"), "frame_id")
            yield from _pairs(run, parent, _field(run, message, "child_frame_id"), len(messages) == 1)
        else:
            yield _NOT_KNOWN


def _field(run: Run, message: Value | None, name: str) -> Value | None:
    """What a field of a message holds by now."""
    return messages.known_content(run, message, name) if isinstance(message, MessageValue) else None


def _pairs(run: Run, parent: Value | None, child: Value | None, certain: bool = True) -> Iterator[FramePair]:
    parents, children = _names(run, parent), _names(run, child)
    certain = certain and len(parents) == len(children) == 1
    return (FramePair(first, second, certain) for first, second in product(parents, children))


def _names(run: Run, value: Value | None) -> Sequence[given.Given]:
    options = () if value is None else alternatives(value)
    names = [
        given_by(option, run.program.process) if isinstance(option, Known) and isinstance(option.value, str) else None
        for option in options
    ]
    return [name or given.UNKNOWN for name in names] or [given.UNKNOWN]


__all__ = ["frames_of"]
