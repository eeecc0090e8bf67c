"""The functions in which a program may wait for a callback: callbacks, constructors of nodes, and what makes nodes."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept, once
from archlint.analysis.source_code import source_code
from archlint.execution.blocking import ONE, SAME
from archlint.execution.callback_roles import runs_in_executor
from archlint.execution.deadlock import group_relation, threads_of
from archlint.execution.event_waits import ONLY_THREAD, kept_out
from archlint.execution.spins import is_spun_in_sight
from archlint.execution.waits import asked_clients
from archlint.finding import Place
from archlint.model import Role
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import everything_in, once_for, parts_of
from archlint.syntax.walk import calls_in

if TYPE_CHECKING:
    from archlint.model import Blueprint, Callback, Frame, Program
    from archlint.systems.model import System

_CLIENT_KEPT_OUT = "the client whose response it takes is in the mutually exclusive callback group of this callback"
_NOBODY_SPINS = "nothing spins the node while this thread waits"


@dataclass(frozen=True)
class Waiting:
    """A function in which loops may wait, and which of its variables is the node."""

    function: facts.Function
    file: str
    variable: str
    node: Blueprint
    callback: Callback | None


@dataclass(frozen=True, kw_only=True)
class EndlessWait:
    """A wait for what only a callback does that cannot run meanwhile."""

    place: Place
    waiting: Callback | None
    """The callback that waits; None where a program does so at its start."""
    node: Blueprint
    attribute: str
    """With the variable that is the node: ``self.pose``."""
    setter: Callback
    why: str
    """Why the setter cannot run meanwhile."""


@once
def waiting_functions(system: System) -> list[tuple[Program, Waiting]]:
    """Those of each program, outside of test code."""
    return [
        (program, waiting)
        for program in system.programs
        for waiting in (*_in_callbacks(system, program), *_at_start(system, program))
        if not system.roles.is_test(waiting.file)
    ]


def _in_callbacks(system: System, program: Program) -> Iterator[Waiting]:
    """The callbacks that an executor runs, and the methods in which they sleep."""
    code = source_code(system)
    for callback in program.callbacks:
        function = code.definition(callback)
        if function is not None and runs_in_executor(callback) and callback.bound_arguments == 1:
            yield from _method(function, callback.file, callback.node, callback)
            yield from _own_methods(system, function, callback)
    for call in program.calls:
        if call.api != "time.sleep" or not call.loops or not call.chain or not runs_in_executor(call.context):
            continue
        function = code.function_at(call.place)
        if function is not None and call.context.bound_arguments == 1 and _on_itself(system, call.chain):
            yield from _method(function, call.file, call.context.node, call.context)


def _method(
    function: facts.Function, file: str, node: Blueprint | None, callback: Callback | None
) -> Iterator[Waiting]:
    if node is not None and function.params and not function.decorators:
        yield Waiting(function, file, function.params[0].name, node, callback)


def _own_methods(system: System, function: facts.Function, callback: Callback) -> Iterator[Waiting]:
    """The methods with loops that a callback of a node calls on it, be it through others of its methods."""
    node = callback.node
    methods = {} if node is None else kept(system, (_methods_of, node), lambda: _methods_of(system, node))
    if methods.get(function.name) != (callback.file, function):
        return
    seen, waiting = {function.name}, [function]
    while waiting:
        for name in _called_on_itself(waiting.pop()):
            if name in methods and name not in seen:
                seen.add(name)
                file, method = methods[name]
                waiting.append(method)
                if any(parts_of(method.body, facts.While)):
                    yield from _method(method, file, callback.node, callback)


@once_for
def _called_on_itself(method: facts.Function) -> tuple[str, ...]:
    """The methods that a method calls on its object, in the order of the source."""
    if not method.params or method.decorators:
        return ()
    own = method.params[0].name
    called = ((call.func.attribute, call.func.dotted) for call in calls_in(method.body))
    return tuple(dict.fromkeys(name for name, dotted in called if name and dotted == f"{own}.{name}"))


def _methods_of(system: System, node: Blueprint) -> dict[str, tuple[str, facts.Function]]:
    """The methods of a node that classes of the workspace define, by name, each with its file."""
    methods: dict[str, tuple[str, facts.Function]] = {}
    for cls in node.classes:
        code = source_code(system).facts_at(cls.place.file)
        for written in () if code is None else _classes_of(code):
            if Place.of(cls.place.file, written.name_span) == cls.place:
                own = (method for method in written.body if isinstance(method, facts.Function))
                methods = {method.name: (cls.place.file, method) for method in own} | methods
    return methods


@once_for
def _classes_of(code: facts.Facts) -> list[facts.Class]:
    return list(everything_in(code.body, facts.Class))


def _on_itself(system: System, chain: tuple[Frame, ...]) -> bool:
    """Whether each call of a chain is of a method of the object that the caller is a method of."""
    code = source_code(system)
    for frame in chain:
        call, caller = code.call_at(frame.place), code.function_at(frame.place)
        if call is None or caller is None or not caller.params:
            return False
        if not isinstance(call.func, facts.Attribute) or call.func.value.variable != caller.params[0].name:
            return False
    return True


def _at_start(system: System, program: Program) -> Iterator[Waiting]:
    """The constructors of nodes, and the functions that make nodes, of a program in which no other thread spins
    these."""
    for node in program.nodes:
        if program.executable and not program.exhausted and _is_spun_by_this_thread(program, node):
            for cls in node.classes:
                yield from _constructor(system, cls.place, node)
            yield from _maker(system, node)


def _is_spun_by_this_thread(program: Program, node: Blueprint) -> bool:
    """Whether it is known who spins a node, and that is no other thread: one may be made in a way that is not seen."""
    if not node.complete or not is_spun_in_sight(node):
        return False
    if any(use.in_thread or use.astray for use in program.executors if node in use.nodes or use.astray):
        return False
    here = {call.place for call in program.calls if call.context.role in (Role.INIT, Role.MAIN, Role.MODULE)}
    spins = [use.spins_at(node) for use in program.executors_of(node)]
    return bool(spins) and here.issuperset(spins)


def _constructor(system: System, place: Place, node: Blueprint) -> Iterator[Waiting]:
    code = source_code(system).facts_at(place.file)
    for cls in everything_in([] if code is None else code.body, facts.Class):
        if Place.of(place.file, cls.name_span) == place:
            for method in cls.body:
                if isinstance(method, facts.Function) and method.name == "__init__":
                    yield from _method(method, place.file, node, None)


def _maker(system: System, node: Blueprint) -> Iterator[Waiting]:
    """``main``, where it makes the node and keeps it in a variable."""
    if node.made_at is None or node.made_by is None or node.made_by.role not in (Role.MAIN, Role.MODULE):
        return
    code = source_code(system)
    function, statement = code.function_at(node.made_at), code.statement_at(node.made_at)
    match function, statement:
        case facts.Function(), facts.Assign(targets=[facts.Name(id=variable)], value=facts.Call()):
            stores = [
                target
                for assignment in everything_in(function.body, facts.Assign)
                for target in assignment.assigned
                if target.variable == variable
            ]
            if len(stores) == 1:
                yield Waiting(function, node.made_at.file, variable, node, None)


def classes_of(system: System, waiting: Waiting) -> set[Place]:
    """The classes of the node, where the function is a method of one or has the node in a variable; none where the
    object may be another."""
    classes = {cls.place for cls in waiting.node.classes}
    if waiting.callback is None:
        return classes
    code = source_code(system).facts_at(waiting.file)
    own = {
        Place.of(waiting.file, cls.name_span)
        for cls in everything_in([] if code is None else code.body, facts.Class)
        if any(method is waiting.function for method in cls.body)
    }
    return classes if own and own <= classes else set()


def why_kept_out(system: System, waiting: Waiting, setter: Callback, program: Program) -> str | None:
    """Why what changes the attribute cannot run while the loop goes on; None where it may."""
    if waiting.callback is not None and setter.role == Role.DONE:
        clients = () if setter.registered is None else asked_clients(system).get((program, setter.registered), ())
        own = bool(clients) and all(client.node is waiting.node for client in clients)
        if setter.node is not waiting.node or not (setter.creation is not None or own):
            return None
        if threads_of(waiting.node, program) == ONE:
            return ONLY_THREAD
        groups = [client.group for client in clients]
        kept = own and all(group_relation(waiting.callback.group, group) == SAME for group in groups)
        return _CLIENT_KEPT_OUT if kept else None
    if waiting.callback is not None:
        return kept_out(waiting.callback, setter, program)
    # Code that sets parameters calls what it is asked for, itself.
    return _NOBODY_SPINS if runs_in_executor(setter) and setter.role != Role.PARAMETER else None


__all__ = ["EndlessWait", "Waiting", "classes_of", "waiting_functions", "why_kept_out"]
