"""Calls of rclpy, message_filters and tf2_ros that end in an exception: the arguments do not fit, or one is of another
kind than its parameter takes."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from archlint import model
from archlint.branches import ChoiceOfCallee
from archlint.interpreter.definitions import methods_of
from archlint.interpreter.values import Instance, Value, alternatives
from archlint.libraries.api_signatures import distros, needed, refusing_distros, signatures_of
from archlint.libraries.kinds_of_arguments import Kind, described, is_other, kinds_of
from archlint.libraries.rclpy import names, node_classes, refusals
from archlint.libraries.thread_arguments import number_given
from archlint.libraries.values import EntityValue
from archlint.syntax import facts
from archlint.syntax.bare_super import bare_super_calls, calls_without_self
from archlint.syntax.misspelt_constructor import CONSTRUCTOR, has_misspelt_call, meant_as_constructor
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.interpreter.call_site import CallSite
    from archlint.interpreter.values import ClassValue
    from archlint.libraries.run import Run
    from archlint.libraries.tables import Api


_UNSEEN = object()
_SUBSCRIBER = "message_filters.Subscriber"
_NEEDED_OF_ANY = {
    _SUBSCRIBER: ("node", "msg_type", "topic"),
    "rclpy.lifecycle.node.LifecycleNode.create_lifecycle_publisher": ("msg_type", "topic", "qos_profile"),
}
"""What is read of ``*args``: by message_filters (``__init__.py``: ``args[0]``, ``args[2]``), and by
``Node.create_publisher``, which ``create_lifecycle_publisher`` hands them to."""


def note(run: Run, api: Api, receiver: Value | None, site: CallSite, bound: Mapping[str, Value]) -> None:
    """Note a call that is refused each time that it is reached."""
    place = refusals.place_of(run, site) if _is_known(api, receiver) else None
    if place is None:
        return
    if run.noted.refused.get((place, api.path), _UNSEEN) is not None:
        refused = (
            _early(run, api, receiver, place) or _unmade(run, api, bound, place) or _misfit(api, receiver, site, place)
        )
        certain = {name: value for name, value in bound.items() if not _may_be_of_subclass(run, value)}
        refusals.keep(run, place, api.path, refused or _other_kind(api, site, certain, place))


def _may_be_of_subclass(run: Run, value: Value) -> bool:
    """Whether a value is ``self`` in a class that nothing here makes an object of: another may derive from it and from
    Node."""
    return not run.program.executable and any(activation.self_value is value for activation in run.activations)


_METHODS = {
    "rclpy.publisher.Publisher": "publish()",
    "rclpy.client.Client": "call_async()",
    "rclpy.action.client.ActionClient": "send_goal_async()",
}
"""What people mean who call an endpoint itself."""


def note_uncallable(run: Run, value: Value, site: CallSite) -> None:
    """Note that a publisher or a client is called like a function."""
    path = value.path if isinstance(value, EntityValue) else ""
    place = refusals.place_of(run, site) if path in _METHODS else None
    # Where one of several objects is called, code may have asked which it is.
    if place is not None and not any(isinstance(branch, ChoiceOfCallee) for branch, _ in run.branch_arms):
        given, wanted = described(value, None), _METHODS[path]
        misuse = model.Misuse.NO_FUNCTION
        refusals.keep(
            run, place, path, model.RefusedCall(place, path, misuse, given=given, wanted=wanted, distros=distros())
        )


def _is_known(api: Api, receiver: Value | None) -> bool:
    """Whether it is certainly this method that is called, or a function or class."""
    return not api.path.startswith(f"{names.NODE}.") if receiver is None else refusals.is_of_rclpy(receiver)


def _early(run: Run, api: Api, receiver: Value | None, place: Place) -> model.RefusedCall | None:
    """A method of a node that a constructor of its class calls before ``Node.__init__``, or without it."""
    cls = None if receiver is None else receiver.own_class
    if (
        cls is None
        or not isinstance(receiver, Instance)
        or api.effect == "destroy_node"
        or api.path.endswith(".__init__")
    ):
        return None
    if not node_classes.is_node(cls):
        return None  # it may be mixed into a node, whose constructor has run by then
    node = run.nodes.by_object.get(receiver.key)
    codes = [base.ir for base in cls.classes]
    if any(bare_super_calls(ir) or calls_without_self(ir) or has_misspelt_call(ir) for ir in codes):
        return None  # Python does not get further than that call
    making = [activation for activation in run.activations if activation.self_value is receiver]
    if (node is not None and node.constructed) or not any(a.qualified.endswith(".__init__") for a in making):
        return None
    return model.RefusedCall(place, api.path, model.Misuse.EARLY, given=cls.ir.name, distros=distros())


_SPINNING = frozenset({"rclpy.spin", "rclpy.spin_once", "rclpy.executors.Executor.add_node"})


def _unmade(run: Run, api: Api, bound: Mapping[str, Value], place: Place) -> model.RefusedCall | None:
    """A node that is spun and whose constructor never calls that of Node."""
    value = bound.get("node") if api.path in _SPINNING else None
    cls = None if value is None else value.own_class
    if cls is None or not isinstance(value, Instance) or not node_classes.is_node(cls):
        return None
    node = run.nodes.by_object.get(value.key)
    if (node is not None and node.constructed) or not node_classes.has_only(cls) or not _makes_itself(cls):
        return None
    return model.RefusedCall(place, api.path, model.Misuse.EARLY, given=cls.ir.name, distros=distros())


def _makes_itself(cls: ClassValue) -> bool:
    """Whether the constructor of a class is its own and calls no other."""
    constructors = [method for method in methods_of(cls) if method.name == "__init__"]
    return len(constructors) == 1 and not any(
        part.last_name in ("__init__", "super") for part in everything_in(constructors[0].body)
    )


def _misfit(api: Api, receiver: Value | None, site: CallSite, place: Place) -> model.RefusedCall | None:
    """A call whose arguments are too few, too many, or go by a name that is none."""
    refusing = refusing_distros(api.path, len(site.args), tuple(sorted(site.keywords)), not site.open, api.params)
    lacking = _lacking(api, site, place)
    if lacking is not None or not refusing:
        return lacking
    mismatch = refusing[-1][1]
    cls, instead = _inherits_constructor(receiver) if api.path.endswith(".__init__") else ("", "")
    return model.RefusedCall(
        place,
        api.path,
        mismatch.misuse,
        mismatch.parameters,
        takes=mismatch.takes,
        given=cls,
        wanted=instead,
        signature=needed(api.path),
        distros=tuple(distro for distro, _ in refusing),
    )


def _inherits_constructor(receiver: Value | None) -> tuple[str, str]:
    """The class of the workspace that is called where it has no constructor of its own, and which method of it was to
    be one: ``_init_``.  Both are empty otherwise."""
    cls = None if receiver is None else receiver.own_class
    if cls is None:
        return "", ""
    if any(method.name == CONSTRUCTOR for base in cls.classes for method in methods_of(base)):
        return "", ""
    return cls.ir.name, meant_as_constructor([base.ir for base in cls.classes])


def _lacking(api: Api, site: CallSite, place: Place) -> model.RefusedCall | None:
    """A call of what takes ``*args`` and needs some of them all the same."""
    wanted = _NEEDED_OF_ANY.get(api.path, ())
    missing = tuple(name for name in wanted[len(site.args) :] if name not in site.keywords)
    if site.open:
        return None
    if not missing and api.path == _SUBSCRIBER and len(site.args) > len(wanted):
        # They come in front of the callback, which takes the place of the profile: that has a value by name, too.
        takes_any = tuple(distro for distro, row in signatures_of(api.path).items() if row.any_positional)
        rest = (api.qos or "",)
        return model.RefusedCall(
            place, api.path, model.Misuse.TOO_MANY, rest, takes=len(wanted), signature=wanted, distros=takes_any
        )
    if not missing:
        return None
    return model.RefusedCall(place, api.path, model.Misuse.MISSING, missing, signature=wanted, distros=distros())


def _other_kind(api: Api, site: CallSite, bound: Mapping[str, Value], place: Place) -> model.RefusedCall | None:
    """A call that gives one parameter what it does not take, or two parameters what the other takes."""
    kinds = {name: kind for name, kind in kinds_of(api).items() if name in bound}
    if not kinds:
        return None
    written = _written(api, site)
    other = [name for name, kind in kinds.items() if _is_other(api, kind, bound[name], written.get(name))]
    number = number_given(bound, written) if kinds.get("args") is Kind.ARGUMENTS and not other else ""
    if not other and not number:
        return None
    other = other or ["args"]
    first = min(other, key=api.params.index)
    others = (name for name in other if name != first)
    swapped = next((name for name in others if _are_swapped(api, kinds, (first, name), bound, written)), None)
    value = alternatives(bound[first])[0]
    return model.RefusedCall(
        place,
        api.path,
        model.Misuse.KIND if swapped is None else model.Misuse.SWAPPED,
        (first,) if swapped is None else (first, swapped),
        given=f"the number '{number}'" if number else described(value, written.get(first)),
        wanted=kinds[first].value,
        signature=needed(api.path) or api.params,
        distros=distros(),
    )


def _is_other(api: Api, kind: Kind, value: Value, written: facts.Expr | None) -> bool:
    return all(is_other(api, kind, option, written) for option in alternatives(value))


def _are_swapped(
    api: Api,
    kinds: Mapping[str, Kind],
    pair: tuple[str, str],
    bound: Mapping[str, Value],
    written: Mapping[str, facts.Expr],
) -> bool:
    crossed = zip(pair, reversed(pair), strict=True)
    return not any(_is_other(api, kinds[name], bound[taken], written.get(taken)) for name, taken in crossed)


def _written(api: Api, site: CallSite) -> dict[str, facts.Expr]:
    """The arguments as they stand in the code, by their parameters; nothing where some are in ``*args``."""
    given = [] if site.expression is None else site.expression.args
    if any(argument.star for argument in given):
        return {}
    by_position = [argument.value for argument in given if argument.keyword is None]
    own = by_position[max(0, len(by_position) - len(site.args)) :]
    by_name = {argument.keyword: argument.value for argument in given if argument.keyword is not None}
    return dict(zip(api.positional, own, strict=False)) | by_name


__all__ = ["note", "note_uncallable"]
