"""Lists, tuples, dicts, texts and numbers that are called as they are written: mostly for want of a comma."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.place import Place
from archlint.python_code.tried_code import tried_for
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.model import SourceFile


@dataclass(frozen=True)
class CalledValue:
    """``('a', 1) ('b', 2)``; ``among`` says that it stands among the items of a list, or the arguments of a call."""

    place: Place
    kind: str
    among: bool
    builds: bool = False
    """Whether the file is a setup.py, so that the build stops."""


def called_values(workspace: WorkspaceIndex) -> Iterator[CalledValue]:
    """Every such call in the files that were asked for, and in each setup.py that colcon runs; not in test code."""
    for path, builds in files_that_run(workspace):
        for span, kind, among in _rows(workspace, path) or ():
            yield CalledValue(Place(path, *span), kind, among, builds)


def files_that_run(workspace: WorkspaceIndex) -> list[tuple[str, bool]]:
    """The files that were asked for, but for test code, and each setup.py that colcon runs: True of these."""
    judged = [file.relative for file, _ in workspace.code.judged() if not workspace.roles.is_test(file.relative)]
    setups = [file.relative for file, _ in workspace.code.setup_files if _is_run(workspace, file)]
    return [*((path, False) for path in judged), *((path, True) for path in setups)]


def _is_run(workspace: WorkspaceIndex, setup: SourceFile) -> bool:
    """Whether colcon runs a setup.py."""
    package = workspace.packages.get(setup.package or "")
    return package is not None and package.build_type == "ament_python"


@kept_for_each_file
def _rows(code: facts.Facts) -> list[tuple[facts.Span, str, bool]]:
    calls = [call for call in everything_in(code.body, facts.Call) if _kind(call.func)]
    expecting = tried_for(code.body, {"TypeError", "Exception"}) if calls else set()
    among = {Itself[facts.Base](each) for part in (everything_in(code.body) if calls else ()) for each in _items(part)}
    rows = [(call.span, _kind(call.func), Itself[facts.Base](call)) for call in calls]
    return [(span, kind, call in among) for span, kind, call in rows if call not in expecting]


def _items(part: facts.Base) -> Sequence[facts.Base]:
    match part:
        case facts.Sequence(elements=elements):
            return elements
        case facts.Mapping(values=values):
            return values
        case facts.Call(args=args):
            return [argument.value for argument in args]
    return ()


def _kind(called: facts.Expr) -> str:
    """What is called, in words; empty for what may be a function."""
    match called:
        case facts.Sequence(kind=kind):
            return f"a {kind}"
        case facts.Mapping():
            return "a dict"
        case facts.Literal(value=str()) | facts.FormatString():
            return "a text"
        case facts.Literal(value=bool() | None):
            return ""
        case facts.Literal(value=int() | float()):
            return "a number"
    return ""


__all__ = ["CalledValue", "called_values", "files_that_run"]
