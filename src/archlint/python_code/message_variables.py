"""What code gives to objects other than ``self``: attributes of classes, and the fields of messages."""

from __future__ import annotations

from collections import Counter

from archlint.analysis.kept import kept_for_each_file
from archlint.libraries.rclpy.names import interface_and_section
from archlint.python_code.class_chains import targets_of
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in, once_for, parts_of


@kept_for_each_file
def given_to_others(file_facts: facts.Facts) -> frozenset[str]:
    """The attributes that a file assigns to an object that is not ``self``, and no message."""
    of_messages = _fields_given(file_facts)
    names: set[str] = set()
    for target in targets_of(file_facts.body):
        match target:
            case facts.Attribute(value=facts.Name(id="self")):
                continue
            case facts.Attribute(attr=attr) if Itself[facts.Base](target) not in of_messages:
                names.add(attr)
    return frozenset(names)


@once_for
def imported_messages(file_facts: facts.Facts) -> dict[str, str]:
    """What a file calls the classes of messages, services and actions that it imports, and their dotted names."""
    return {
        bound: f"{statement.module}.{name}"
        for statement in everything_in(file_facts.body, facts.ImportFrom)
        if not statement.level and statement.module.endswith((".msg", ".srv", ".action"))
        for name, bound in statement.names
    }


def _fields_given(file_facts: facts.Facts) -> frozenset[Itself[facts.Base]]:
    """The targets ``message.header.frame_id`` where ``message`` is only ever what a class of messages makes."""
    classes = imported_messages(file_facts)
    rows: set[Itself[facts.Base]] = set()
    for function in everything_in(file_facts.body, facts.Function) if classes else ():
        variables = variables_of_messages(function, classes)
        targets = targets_of(function.body) if variables else ()
        rows.update(Itself[facts.Base](target) for target in targets if _root(target) in variables)
    return frozenset(rows)


def fields_set(file_facts: facts.Facts, module: str, name: str) -> set[str]:
    """The fields that a file gives the messages which it makes of a class, ``name`` of ``robot.msg``: as it makes them,
    or to variables that are assigned nothing else."""
    imports = everything_in(file_facts.body, facts.ImportFrom)
    classes = {
        bound: f"{module}.{name}"
        for statement in imports
        if not statement.level and statement.module == module
        for imported, bound in statement.names
        if imported == name
    }
    calls = everything_in(file_facts.body, facts.Call) if classes else ()
    given = {argument.keyword for call in calls if makes_message(call, classes) for argument in call.args}
    for function in everything_in(file_facts.body, facts.Function) if classes else ():
        variables = variables_of_messages(function, classes)
        given.update(_first_attribute(target) for target in targets_of(function.body) if _root(target) in variables)
    return {field for field in given if field}


def _first_attribute(target: facts.Base) -> str:
    """``pose`` of ``message.pose.position``."""
    while isinstance(target, facts.Attribute) and isinstance(target.value, facts.Attribute):
        target = target.value
    return target.attr if isinstance(target, facts.Attribute) else ""


def variables_of_messages(function: facts.Function, classes: dict[str, str]) -> set[str]:
    """The variables of a function that are assigned nothing else."""
    times = Counter(
        part.targets[0].variable
        for part in parts_of(function.body, facts.Assign)
        if len(part.targets) == 1 and part.targets[0].variable and makes_message(part.value, classes)
    )
    bound = Counter(target.variable for target in targets_of(function.body))
    others = {param.name for param in everything_in(function, facts.Param)}
    others.update(name for part in everything_in(function.body, facts.Global) for name in part.names)
    return {name for name, count in times.items() if name and bound[name] == count and name not in others}


def makes_message(value: facts.Expr, classes: dict[str, str]) -> bool:
    """Whether an expression is ``Twist()``, or ``Trigger.Request()``, of such classes."""
    match value:
        case facts.Call(func=function):
            name, dot, part = function.dotted.partition(".")
            return name in classes and interface_and_section(f"{classes[name]}{dot}{part}")[0] is not None
    return False


def _root(target: facts.Base) -> str:
    """The variable that a chain of attributes begins with; empty for anything else."""
    match target:
        case facts.Attribute(value=facts.Name(id=name)):
            return name
        case facts.Attribute(value=facts.Attribute() as inner):
            return _root(inner)
    return ""


__all__ = ["fields_set", "given_to_others", "imported_messages", "makes_message", "variables_of_messages"]
