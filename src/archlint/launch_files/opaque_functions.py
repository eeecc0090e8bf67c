"""Functions that launch files give to an ``OpaqueFunction`` and that launch cannot use.

Source: ``OpaqueFunction.execute`` of launch calls the function with the context, and launch goes through what it
returns.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from archlint.launch_files.wrong_launch_descriptions import Wrong, WrongDescription
from archlint.syntax import facts
from archlint.syntax.parts import everything_in, parts_of

_ONE = frozenset(
    {"LaunchDescription", "Node", "IncludeLaunchDescription", "GroupAction", "ExecuteProcess", "TimerAction"}
)
"""The classes whose object nobody can go through."""


def wrong_functions(body: Sequence[facts.Stmt], class_of: Callable[[facts.Expr], str]) -> Iterator[WrongDescription]:
    """What is wrong with them in one file; ``class_of`` says of which class of launch a call makes an object."""
    functions: dict[str, list[facts.Function]] = {}
    for function in everything_in(body, facts.Function):
        functions.setdefault(function.name, []).append(function)
    for call in everything_in(body, facts.Call):
        if class_of(call) != "OpaqueFunction":
            continue
        for argument in call.args[:1] if call.args and call.args[0].keyword is None else call.args:
            if argument.keyword in (None, "function") and not argument.star:
                yield from _of_argument(argument.value, functions, class_of, len(call.args))


def _of_argument(
    value: facts.Expr, functions: dict[str, list[facts.Function]], class_of: Callable[[facts.Expr], str], arguments: int
) -> Iterator[WrongDescription]:
    match value:
        case facts.Name(id=name):
            match functions.get(name):
                case [facts.Function(decorators=[], is_generator=False, is_async=False) as function]:
                    if not function.params and arguments == 1:
                        yield WrongDescription(Wrong.OPAQUE_CONTEXT, function.name_span, name)
                    yield from _returned(function, class_of)
        case facts.Call(func=facts.Name(id=name), span=span):
            match functions.get(name):
                case [facts.Function() as function] if not _makes_functions(function):
                    yield WrongDescription(Wrong.OPAQUE_CALLED, span, name)


def _makes_functions(function: facts.Function) -> bool:
    """Whether what a function returns may be a function."""
    inner = any(parts_of(function.body, facts.Lambda)) or any(s.is_scope for s in everything_in(function.body))
    returns = list(parts_of(function.body, facts.Return))
    plain = (facts.Sequence, facts.Literal)
    return inner or not all(r.value is None or isinstance(r.value, plain) for r in returns)


def _returned(function: facts.Function, class_of: Callable[[facts.Expr], str]) -> Iterator[WrongDescription]:
    """A single action, or a launch description, that a function returns."""
    assigned: dict[str, list[facts.Expr]] = {}
    for assign in parts_of(function.body, facts.Assign):
        for target in assign.targets:
            assigned.setdefault(target.variable, []).append(assign.value)
    for statement in parts_of(function.body, facts.Return):
        value = statement.value
        if value is None:
            continue
        options = assigned.get(value.variable, []) if value.variable else [value]
        classes = {class_of(option) for option in options}
        if len(classes) == 1 and (name := classes.pop()) in _ONE:
            yield WrongDescription(Wrong.OPAQUE, statement.span, name, function.name)


__all__ = ["wrong_functions"]
