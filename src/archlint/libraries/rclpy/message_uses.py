"""The fields of messages that code names."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint import model
from archlint.branches import ChoiceOfCallee
from archlint.interpreter.values import Value
from archlint.libraries.rclpy.guards import guard_of
from archlint.libraries.rclpy.messages import of_value
from archlint.libraries.values import MessageValue
from archlint.model import FieldUse, Passed

if TYPE_CHECKING:
    from archlint.interpreter.activation import Activation
    from archlint.libraries.run import Run
    from archlint.model import Access
    from archlint.syntax.facts import Span

OF_EVERY_MESSAGE = frozenset({"get_fields_and_field_types", "SLOT_TYPES", "structure_needs_at_least_one_member"})
"""What rosidl's generator gives each class beside its fields and constants."""
_CALLBACK = 2
"""How deep the stack of calls is in a callback itself: the module, and the callback."""


def note_use(run: Run, value: Value, name: str, span: Span, access: Access) -> None:
    """Note that the code uses an attribute of what is certainly a message; ``access`` is ``read``, ``write`` or
    ``keyword``."""
    message = of_value(value)
    if message is None or run.interfaces is None or not is_certain(run):
        return
    if name.startswith("_") or name in OF_EVERY_MESSAGE:
        return
    delivered = delivered_by(run, message)
    passed = _passed(run, message)
    client = run.messages.answered.get(message.key)
    key = (run.activation.module.path, span, message.type, message.section_name, id(delivered), id(client), passed)
    if key in run.messages.uses:
        return
    known = (
        None if may_be_of_another_type(run, message) else run.interfaces.has(message.type, message.section_name, name)
    )
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
            client=client,
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
    hops: list[Passed] = []
    for number in range(len(run.activations) - 1, 0, -1):
        activation = run.activations[number]
        if activation.scope.kind == "comprehension":
            continue
        if activation.function is None or activation.call_place is None or not _is_given(run, activation, keys):
            break
        place = activation.place(activation.function.ir.span)
        run.messages.passed_to[id(activation.function.ir)] = place
        hops.append(Passed(activation.call_place, activation.qualified, place))
    return tuple(hops)


def _is_given(run: Run, activation: Activation, keys: set[int]) -> bool:
    assert activation.function is not None
    for param in activation.function.ir.params:
        value = run.store.get(activation.scope.key, param.name)
        message = of_value(value) if isinstance(value, Value) else None
        if message is not None and message.key in keys:
            return True
    return False


def delivered_by(run: Run, message: MessageValue) -> model.Creation | None:
    """What calls with a message, if nothing precedes this use of it that may have asked for its type."""
    creation = run.messages.delivered.get(message.key)
    return None if creation is None or run.branch_arms or guard_of(run) else creation


def may_be_of_another_type(run: Run, message: MessageValue) -> bool:
    """Whether a helper that gets messages of several types is in a branch that may be for another type."""
    activation = run.activation
    is_passed = len(run.activations) > _CALLBACK and run.messages.made_in.get(message.key) is not activation
    chosen = any(isinstance(branch, ChoiceOfCallee) for branch, _ in run.branch_arms)
    return is_passed and (chosen or len(run.branch_arms) > activation.branch_arms)


def is_certain(run: Run) -> bool:
    """Whether an attribute that is not there would be noticed."""
    return bool(run.activations) and not any(activation.forgiving for activation in run.activations)
