"""What a program means to do at its end, and Ctrl-C keeps from happening, since nothing catches the KeyboardInterrupt
with which a spin ends then.

Source: as of late_publications.py.  What stands behind the spin is run only where a line of the program shuts rclpy
down, so that the spin returns.  Tried with rclpy of jazzy: SIGINT ends ``spin()`` of rclpy and of an executor, and
loops with ``spin_once()`` or ``sleep()``, with KeyboardInterrupt each time.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.place import Place
from archlint.python_code.class_chains import ClassInFile, classes_of
from archlint.python_code.made_objects import calls_of_objects, class_of_object
from archlint.python_code.own_calls import FunctionInFile, function_meant, method_meant, own_calls_of
from archlint.python_code.second_shutdowns import OF_SIGNALS, leaves, targets_of_threads
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import everything_in, parts_of
from archlint.syntax.walk import calls_in, given_to

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_DEPTH = 2
"""Through how many methods of an object that call each other it is looked."""
_AT_EXIT = frozenset({"KeyboardInterrupt", "atexit", "on_shutdown"})
"""Words of a program that has another way to do something at its end."""
_WAIT = frozenset({"sleep", "spin_once"})
_SHUT_DOWN = frozenset({"shutdown", "try_shutdown"})
_SAVE = frozenset(
    {
        *("json.dump", "pickle.dump", "yaml.dump", "yaml.safe_dump"),
        *(f"{numpy}.{save}" for numpy in ("np", "numpy") for save in ("save", "savetxt", "savez", "savez_compressed")),
        *("cv2.imwrite", "plt.savefig"),
    }
)
_SAVING_METHODS = frozenset({"to_csv", "to_json", "to_pickle", "write_text", "write_bytes"})


@dataclass(frozen=True)
class SkippedEnding:
    """A call behind a spin that publishes or writes a file, itself or in a function of the workspace."""

    place: Place
    spin: Place
    effect: str
    """What it does, in words."""
    in_loop: bool = False
    """Whether it is a loop that spins, ``while rclpy.ok()``, and not one call."""
    name: str = ""
    """The function or method that does it, where that is not the call itself."""
    done_at: Place | None = None


@dataclass(frozen=True)
class _Ending:
    spin: facts.Span
    in_loop: bool
    calls: tuple[tuple[facts.Span, str], ...]
    """The calls behind it, in order, each with what it does itself."""


def skipped_endings(workspace: WorkspaceIndex) -> Iterator[SkippedEnding]:
    """The first such call behind each spin in the files that were asked for, outside of test code."""
    for path in workspace.python_files(mentioning="rclpy"):
        for ending in _endings(workspace, path) or ():
            rows = (_skipped(workspace, path, ending, *call) for call in ending.calls)
            first = next((row for row in rows if row is not None), None)
            if first is not None:
                yield first


def _skipped(
    workspace: WorkspaceIndex, path: str, ending: _Ending, span: facts.Span, effect: str
) -> SkippedEnding | None:
    place, spin = Place(path, *span), Place(path, *ending.spin)
    if effect:
        return SkippedEnding(place, spin, effect, ending.in_loop)
    name, cls, meant = _meant(workspace, path, span)
    if meant is None or _ends_itself(workspace, meant.file):
        return None
    done = _done_in(workspace, meant, cls, _DEPTH)
    return None if done is None else SkippedEnding(place, spin, done[0], ending.in_loop, name, done[1])


def _meant(
    workspace: WorkspaceIndex, path: str, span: facts.Span
) -> tuple[str, ClassInFile | None, FunctionInFile | None]:
    """The function of the workspace that a call runs, by its name, and the class of the object if it is a method."""
    for of_object in calls_of_objects(workspace, path) or ():
        if of_object.call == span:
            cls = class_of_object(workspace, path, of_object)
            return of_object.name, cls, None if cls is None else method_meant(workspace, cls, of_object.name)
    code = workspace.facts_at(path)
    for call in own_calls_of(workspace, path) or ():
        if call.span == span:
            own = None if call.cls is None or code is None else ClassInFile(path, classes_of(code)[call.cls])
            return call.name.rpartition(".")[2], own, function_meant(workspace, path, call)
    return "", None, None


def _done_in(
    workspace: WorkspaceIndex, function: FunctionInFile, cls: ClassInFile | None, depth: int
) -> tuple[str, Place] | None:
    """What a function does that somebody waits for, or a method of the same object that it calls."""
    code = workspace.facts_at(function.file)
    publishers = frozenset[str]() if code is None else _publishers(code)
    for call in everything_in(function.code.body, facts.Call):
        effect = _effect(call, publishers)
        if effect:
            return effect, Place(function.file, *call.span)
        match call.func:
            case facts.Attribute(value=facts.Name(id="self"), attr=name) if cls is not None and depth > 0:
                meant = method_meant(workspace, cls, name)
                done = None if meant is None else _done_in(workspace, meant, cls, depth - 1)
                if done is not None:
                    return done
    return None


def _effect(call: facts.Call, publishers: frozenset[str]) -> str:
    """What a call does, in words; empty for what nobody waits for."""
    match call.func:
        case facts.Attribute(value=owner, attr="publish") if owner.last_name in publishers:
            return "publishes"
    written = call.func.dotted
    mode = given_to(call, "mode", 1) if written == "open" else None
    writes = isinstance(mode, facts.Literal) and not set("awx").isdisjoint(str(mode.value))
    saves = written in _SAVE or (call.func.attribute in _SAVING_METHODS and bool(call.args))
    return "writes a file" if writes or saves else ""


def _publishers(code: facts.Facts) -> frozenset[str]:
    """What a file calls publishers that it creates."""
    creations = (
        statement
        for statement in everything_in(code.body, facts.Assign)
        if isinstance(statement.value, facts.Call) and statement.value.func.attribute == "create_publisher"
    )
    return frozenset(target.last_name for statement in creations for target in statement.targets if target.last_name)


# ------------------------------------------------------------------------------------------------- by the text alone


@kept_for_each_file
def _endings(code: facts.Facts) -> list[_Ending]:
    """What stands behind each spin of a file, unless the file has another way to end."""
    if not OF_SIGNALS.isdisjoint(code.names) or not _AT_EXIT.isdisjoint(code.names) or shuts_down_elsewhere(code):
        return []
    publishers, threads = _publishers(code), targets_of_threads(code)
    blocks = [code.body, *(f.body for f in everything_in(code.body, facts.Function) if f.name not in threads)]
    return [ending for block in blocks for ending in _in_block(block, publishers)]


def _in_block(block: Sequence[facts.Stmt], publishers: frozenset[str]) -> Iterator[_Ending]:
    """The endings of a block, and of those in its ``with`` statements: a ``try`` catches what Ctrl-C raises, or has a
    ``finally``."""
    for at, statement in enumerate(block):
        if isinstance(statement, facts.With):
            yield from _in_block(statement.body, publishers)
        spin = spin_in(statement)
        if spin is not None:
            calls = tuple((call.span, _effect(call, publishers)) for call in _behind(block[at + 1 :]))
            yield _Ending(spin.span, isinstance(statement, facts.While), calls)
            return


def _behind(block: Sequence[facts.Stmt]) -> Iterator[facts.Call]:
    for statement in block:
        if isinstance(statement, facts.With):
            yield from (call for item in statement.items for call in everything_in([item], facts.Call))
            yield from _behind(statement.body)
        if not statement.blocks:
            yield from calls_in(statement)
        if leaves(statement):
            return


def spin_in(statement: facts.Stmt) -> facts.Call | None:
    """The call that spins until the end, or the condition of a loop that does; no other way leads out of that."""
    match statement:
        case facts.While(test=facts.Call(func=test) as asked, body=body, orelse=[]) if test.dotted == "rclpy.ok":
            inside = [*parts_of(body)]
            ends = any(isinstance(part, (facts.Return, facts.Try)) or _breaks(part) for part in inside)
            waits = any(isinstance(part, facts.Call) and part.func.attribute in _WAIT for part in inside)
            return asked if waits and not ends else None
        case facts.Expression(value=facts.Call(func=facts.Attribute(value=owner, attr="spin")) as call):
            return call if owner.variable == "rclpy" or "executor" in owner.last_name.lower() else None
    return None


def _breaks(part: facts.Base) -> bool:
    return isinstance(part, facts.Jump) and part.kind == "break"


@kept_for_each_file
def _ends_itself(code: facts.Facts) -> bool:
    return shuts_down_elsewhere(code)


def shuts_down_elsewhere(code: facts.Facts) -> bool:
    """Whether a function that does not spin itself shuts rclpy down: then the spin returns."""
    for function in everything_in(code.body, facts.Function):
        calls = [*everything_in(function.body, facts.Call)]
        spins = any(call.func.attribute in ("spin", "spin_once") for call in calls)
        if not spins and any(_is_shutdown(call) for call in calls):
            return True
    return False


def _is_shutdown(call: facts.Call) -> bool:
    match call.func:
        case facts.Attribute(value=owner, attr=name) if name in _SHUT_DOWN:
            return any(word in owner.dotted.lower() for word in ("rclpy", "context", "executor"))
        case facts.Name(id=name):
            return name in _SHUT_DOWN
    return False


__all__ = ["SkippedEnding", "shuts_down_elsewhere", "skipped_endings", "spin_in"]
