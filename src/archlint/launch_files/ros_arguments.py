"""Programs that end at the ``--ros-args`` which launch adds to the command line of each node.

Source: ``launch_ros/actions/node.py``: behind ``arguments`` comes ``--ros-args``, whether a name, a parameter or a
remapping follows or not, in all distributions from Foxy on.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.launch.kinds import StartedKind
from archlint.place import Place
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.launch.started import Started
    from archlint.model import Program
    from archlint.systems.model import System, WorkspaceIndex

_KNOW_OF_THEM = frozenset({"remove_ros_args", "ros_args"})
_CHANGES = frozenset({"append", "clear", "extend", "insert", "pop", "remove"})
_EXITS = frozenset({"exit", "quit", "_exit"})


@dataclass(frozen=True)
class RefusedWords:
    """Where a program ends as it is given more words than it knows of; ``counts`` where it only counts them."""

    started: Started
    place: Place
    counts: bool


@dataclass(frozen=True)
class _Count:
    """A condition of a ``main()`` that ends the program where there are more words than it ``takes``."""

    span: facts.Span
    takes: int


def refused_words(system: System) -> Iterator[RefusedWords]:
    """Every program of this workspace that a launch file starts as a node, and that ends so."""
    workspace = system.workspace
    for node in system.nodes if workspace is not None else ():
        started, program = node.started, node.program
        if workspace is None or started is None or program is None or started.bare:
            continue
        if started.kind is StartedKind.NODE and started.knows_all_arguments:
            yield from _of_program(workspace, started, program)


def _of_program(workspace: WorkspaceIndex, started: Started, program: Program) -> Iterator[RefusedWords]:
    if _changes_words(workspace, program.file) is not False:
        return
    for place in program.strict_parsers:
        if _changes_words(workspace, place.file) is False:
            yield RefusedWords(started, place, counts=False)
    rules = [name for name in (started.name, started.namespace) if name is not None]
    least = 2 + len(started.arguments) + 2 * len(rules)  # its own name, --ros-args, and a -r in front of each rule
    for count in _counts(workspace, program.file) or ():
        if count.takes < least:
            yield RefusedWords(started, Place(program.file, *count.span), counts=True)


# ---------------------------------------------------------------------------------------------------- by the text alone


@kept_for_each_file
def _changes_words(code: facts.Facts) -> bool:
    """Whether a file changes ``sys.argv``, or knows of the arguments of ROS."""
    return any(_is_change(part) for part in everything_in(code.body))


def _is_change(part: facts.Base) -> bool:
    match part:
        case facts.Literal(value=str(text)):
            return "--ros-args" in text
        case facts.Name() | facts.Attribute() if part.last_name in _KNOW_OF_THEM:
            return True
        case facts.Attribute(value=of, attr=name) if name in _CHANGES:
            return _is_words(of)
        case facts.Delete(targets=targets):
            return any(map(_is_words, targets))
    return any(map(_is_words, part.assigned))


def _is_words(part: facts.Base) -> bool:
    """Whether this is ``sys.argv``, or items of it."""
    while isinstance(part, facts.Subscript):
        part = part.value
    return part.last_name == "argv"


@kept_for_each_file
def _counts(code: facts.Facts) -> list[_Count]:
    """The conditions of ``main()`` that no other one decides about."""
    functions = [each for each in code.body if isinstance(each, facts.Function) and each.name == "main"]
    bodies = [function.body for function in functions if not function.decorators]
    return [count for body in bodies for count in _in(body)]


def _in(body: Sequence[facts.Stmt]) -> Iterator[_Count]:
    for statement in body:
        if statement.jumps:
            return
        if not isinstance(statement, facts.If):
            continue
        match statement.test:
            case facts.Compare(left=left, ops=[op], comparators=[facts.Literal(value=int(number))]) if _is_count(left):
                if _ends(statement.body) and op in ("!=", ">", ">="):
                    yield _Count(statement.test.span, number - (op == ">="))
                elif _ends(statement.orelse) and op in ("==", "<", "<="):
                    yield _Count(statement.test.span, number - (op == "<"))


def _is_count(part: facts.Expr) -> bool:
    match part:
        case facts.Call(func=facts.Name(id="len"), args=[argument]):
            return argument.value.dotted in ("sys.argv", "argv")
    return False


def _ends(body: Sequence[facts.Stmt]) -> bool:
    """Whether statements end the program, or ``main()``."""
    match body[-1] if body else None:
        case facts.Return() | facts.Raise():
            return True
        case facts.Expression(value=facts.Call(func=func)):
            return func.last_name in _EXITS
    return False


__all__ = ["RefusedWords", "refused_words"]
