"""Messages in the symbolic run: what their fields are, and which of them the code uses.

Only what is certain is noted: plain attribute names on a value whose type is known, where no ``except`` may be
there for an attribute that is missing.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint import model
from archlint.branches import ChoiceOfCallee
from archlint.interpreter.values import EachValue, Known, OneOf, Unknown, Value
from archlint.libraries.rclpy import names
from archlint.libraries.rclpy.guards import guard_of
from archlint.libraries.values import MessageValue
from archlint.model import FieldUse, Passed, UnknownInterface
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.activation import Activation
    from archlint.libraries.run import Run
    from archlint.model import Access
    from archlint.ros.interfaces import InterfaceTable
    from archlint.syntax.facts import Span

_OF_EVERY_MESSAGE = frozenset({"get_fields_and_field_types", "SLOT_TYPES", "structure_needs_at_least_one_member"})
"""What rosidl's generator gives each class beside its fields and constants."""
_CONSTANT = re.compile(r"[A-Z][A-Z0-9_]*\Z")
_CALLBACK = 2
"""How deep the stack of calls is in a callback itself: the module, and the callback."""


def of_value(value: Value) -> MessageValue | None:
    """The message that a value certainly is when an attribute of it can be read: None is no other choice, for
    it has no attributes."""
    match value:
        case MessageValue():
            return value
        case OneOf(values=options):
            match [option for option in options if not option.is_none]:
                case [MessageValue() as message]:
                    return message
    return None


def nested(run: Run, value: MessageValue, name: str) -> MessageValue | EachValue | None:
    """The message, or array of messages, that a field holds, one and the same at each read; None for others."""
    if run.interfaces is None or not value.key:
        return None
    made = run.messages.fields.get((value.key, name))
    if made is None:
        kind = run.interfaces.field_type(value.type, value.section_name, name)
        if kind is None or kind.is_primitive or run.interfaces.get(kind.name) is None:
            return None
        inner = MessageValue(kind.name, "", run.store.new_key())
        run.messages.inside[inner.key] = value.key
        if value.key in run.messages.made_in:
            run.messages.made_in[inner.key] = run.messages.made_in[value.key]
        if value.key in run.messages.delivered:
            run.messages.delivered[inner.key] = run.messages.delivered[value.key]
        made = run.messages.fields[(value.key, name)] = EachValue(inner) if kind.array else inner
    return made


def note_use(run: Run, value: Value, name: str, span: Span, access: Access) -> None:
    """Note that the code uses an attribute of what is certainly a message; ``access`` is ``read``, ``write`` or
    ``keyword``."""
    message = of_value(value)
    if message is None or run.interfaces is None or not _certain(run):
        return
    if name.startswith("_") or name in _OF_EVERY_MESSAGE:
        return
    delivered = _delivered(run, message)
    passed = _passed(run, message)
    key = (run.activation.module.path, span, message.type, message.section_name, id(delivered), passed)
    if key in run.messages.uses:
        return
    known = None if _may_be_told_apart(run, message) else run.interfaces.has(message.type, message.section_name, name)
    run.messages.uses.add(key)
    section = run.interfaces.section(message.type, message.section_name)
    fields = () if known is not False or section is None else tuple(field.name for field in section.fields)
    run.program.field_uses.append(
        FieldUse(
            run.place(span),
            message.type,
            message.section_name,
            name,
            access,
            known,
            fields,
            run.context.node,
            delivered,
            inside=run.interfaces.inside(message.type, message.section_name, name) if known is False else None,
            passed=passed,
            certain=known is False and bool(passed) and not run.branch_arms and not guard_of(run),
        )
    )


def _passed(run: Run, message: MessageValue) -> tuple[Passed, ...]:
    """The calls that hand a message, or the one that it is in, on to the function that uses it."""
    if not message.key:
        return ()
    outer: int | None = message.key
    keys: set[int] = set()
    while outer is not None:
        keys.add(outer)
        outer = run.messages.inside.get(outer)
    found: list[Passed] = []
    for number in range(len(run.activations) - 1, 0, -1):
        one = run.activations[number]
        if one.scope.kind == "comprehension":
            continue
        if one.function is None or one.call_place is None or not _is_given(run, one, keys):
            break
        place = one.place(one.function.ir.span)
        run.messages.passed_to[id(one.function.ir)] = place
        found.append(Passed(one.call_place, one.qualified, place))
    return tuple(found)


def _is_given(run: Run, one: Activation, keys: set[int]) -> bool:
    assert one.function is not None
    given = (run.store.get(one.scope.key, param.name) for param in one.function.ir.params)
    messages = (of_value(value) for value in given if isinstance(value, Value))
    return any(message is not None and message.key in keys for message in messages)


def deliver(run: Run, arguments: Sequence[Value], creation: model.Creation) -> None:
    """Note which subscription, server or client calls a callback with these messages."""
    for value in arguments:
        if isinstance(value, MessageValue):
            run.messages.delivered[value.key] = creation


def _delivered(run: Run, message: MessageValue) -> model.Creation | None:
    """What calls with a message, if nothing stands in front of this use of it that may have asked for its type."""
    creation = run.messages.delivered.get(message.key)
    return None if creation is None or run.branch_arms or guard_of(run) else creation


def note_constant(run: Run, path: str, name: str, span: Span) -> None:
    """Note that the code reads what looks like a constant from an interface class; ``path`` is dotted.

    Other attributes of such a class are functions, descriptors of its fields, and default values.
    """
    interface, section_name = names.interface_and_section(path)
    if run.interfaces is None or interface is None or not _CONSTANT.match(name) or not _certain(run):
        return
    if name in _OF_EVERY_MESSAGE or name.endswith("__DEFAULT"):
        return
    section = run.interfaces.section(interface, section_name)
    known = run.interfaces.has(interface, section_name, name)
    if section is None or known is None:
        return
    constants = tuple(constant.name for constant in section.constants)
    use = FieldUse(
        run.place(span),
        interface,
        section_name,
        name,
        "constant",
        known,
        () if known else constants,
        run.context.node,
        inside=None if known else _section_with(run.interfaces, interface, name),
    )
    run.program.field_uses.append(use)


def _section_with(interfaces: InterfaceTable, interface: str, constant: str) -> str | None:
    """The class of a service or action that has a constant: ``Dock.Response``."""
    sections = ("Request", "Response", "Goal", "Result", "Feedback")
    having = (section for section in sections if interfaces.constant(interface, section, constant) is not None)
    return next((f"{interface.rpartition('/')[2]}.{section}" for section in having), None)


def _may_be_told_apart(run: Run, message: MessageValue) -> bool:
    """Whether a helper that is handed messages of several types is in a branch that may be for another type."""
    activation = run.activation
    handed_over = len(run.activations) > _CALLBACK and run.messages.made_in.get(message.key) is not activation
    chosen = any(isinstance(branch, ChoiceOfCallee) for branch, _ in run.branch_arms)
    return handed_over and (chosen or len(run.branch_arms) > activation.branch_arms)


def note_made(run: Run, message: MessageValue, expression: facts.Call | None) -> None:
    """Note that the code makes a message here, and the fields that the constructor call names."""
    if run.activations:
        run.messages.made_in[message.key] = run.activation
    for argument in expression.args if expression is not None else ():
        span = getattr(argument.value, "span", None)
        if argument.keyword is not None and not argument.star and span is not None:
            note_use(run, message, argument.keyword, span, "keyword")


def make(
    run: Run, interface: str, section_name: str, keywords: dict[str, Value], expression: facts.Call | None
) -> Value:
    """An object of an interface class, as its constructor is called."""
    made = MessageValue(interface, section_name, run.store.new_key())
    note_made(run, made, expression)
    for name, value in keywords.items():
        run.store.set(made.key, name, value)
    return made


def note_interface(run: Run, path: str, span: Span) -> None:
    """Note an interface that the code takes from a package which does not define it.  ``path`` is dotted."""
    interface, section_name = names.interface_and_section(path)
    if run.interfaces is None or interface is None or section_name or not _imported_for_sure(run) or run.branch_arms:
        return
    package, kind, name = interface.split("/")
    if not is_missing(run, path):
        return
    others = tuple(
        f"{package}/{other}/{name}"
        for other in ("msg", "srv", "action")
        if run.interfaces.defines(package, other, name)
    )
    run.program.unknown_interfaces.append(
        UnknownInterface(
            run.place(span),
            package,
            kind,
            name,
            (*others, *run.interfaces.of_package(package, kind)),
            run.interfaces.is_left_out(package, kind, name),
            run.interfaces.packages_with(kind, name),
            run.activation.scope.kind != "module",
        )
    )


def is_missing(run: Run, path: str) -> bool:
    """Whether a dotted path names an interface that its package certainly does not define: nothing is known of it."""
    interface, section_name = names.interface_and_section(path)
    if run.interfaces is None or interface is None or section_name:
        return False
    package, kind, name = interface.split("/")
    return not names.is_part_of_interface(name) and run.interfaces.defines(package, kind, name) is False


def missing_interface(run: Run, path: str) -> Value | None:
    """What stands for an interface that is missing; None where it is there, or not known."""
    if not is_missing(run, path):
        return None
    interface, _ = names.interface_and_section(path)
    package, _, name = path.split(".")[:3]
    return Unknown(f"{package} defines no '{name}'", interface=interface)


def has_field(run: Run, message: MessageValue, name: str) -> Value | None:
    """``hasattr(message, name)``; None where the definitions of messages are not known."""
    if run.interfaces is None:
        return None
    known = run.interfaces.has(message.type, message.section_name, name)
    return Unknown("hasattr() of a message that is not known") if known is None else Known(known)


def star_sources(run: Run, packages: Sequence[str], name: str) -> Sequence[str]:
    """Those of some foreign packages that a star import may take a name from.

    Interface packages hold class names only; where several could have it, the table of interfaces decides.
    """
    interfaces = [package for package in packages if package.endswith((".msg", ".srv", ".action"))]
    candidates = [p for p in packages if p in interfaces] if name[:1].isupper() and interfaces else list(packages)
    if len(candidates) > 1 and run.interfaces is not None:
        defines = run.interfaces.defines
        verdicts = {p: defines(p.partition(".")[0], p.partition(".")[2], name) for p in interfaces}
        sure = [p for p in candidates if verdicts.get(p)]
        candidates = sure or [p for p in candidates if verdicts.get(p) is not False]
    return candidates


def _certain(run: Run) -> bool:
    """Whether an attribute that is not there would be noticed."""
    return bool(run.activations) and not any(activation.forgiving for activation in run.activations)


def _imported_for_sure(run: Run) -> bool:
    return bool(run.activations) and not any(activation.tries for activation in run.activations)
