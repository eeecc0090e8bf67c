"""Variables of C++ that several files have: what a function assigns to one, all of them read.

An include copies the names of a header, as a star import does.  A function that assigns to a variable at the top of a
file changes it for the file that defines it, and for all that include that file.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.interpreter.declared import defining_scope, note_definition
from archlint.interpreter.values import Declared, Unknown, Value
from archlint.syntax import facts
from archlint.syntax.parts import once_for

if TYPE_CHECKING:
    from archlint.interpreter.heap import Store
    from archlint.interpreter.modules import Module, ModuleIndex, Scope


def bind(index: ModuleIndex, store: Store, scope: Scope, name: str, value: Value, in_function: bool) -> None:
    """Bind a name at the top of a file; a function may assign to one of its file, or of one that this includes."""
    if not (in_function and scope.module.file.kind == "cpp"):
        note_definition(index, store, scope, name, value)
        store.set(scope.key, name, value)
        return
    before = store.get(scope.key, name)
    home = scope.module
    if isinstance(before, Declared):
        defining = defining_scope(index, before)
        if defining is None:
            store.set(scope.key, name, value)
            return
        home, name = defining.module, before.name
    else:
        home = _home(store, home, name)
    short = name.rpartition("::")[2]
    rows = _variables(home.facts)
    names = list(dict.fromkeys([name, *(row for row in rows if row.rpartition("::")[2] == short)]))
    # Of variables of one name in several namespaces, nobody says here which one is meant by the name alone.
    several = rows.count(short) > 1
    unknown = Unknown(f"'{short}' is a variable of several namespaces")
    for module in [home, *_includers(home)]:
        if module.scope is None:
            continue
        for each in names if not several or name == short else [name, short]:
            if module is home or _has_copy(store, module, each, home):
                is_meant = not several or (each == name and name != short)
                store.set(module.scope.key, each, value if is_meant else unknown)


def _home(store: Store, module: Module, name: str) -> Module:
    """The file that defines a variable which a file has."""
    seen: set[str] = set()
    while name not in _variables(module.facts) and module.path not in seen:
        seen.add(module.path)
        # Of several that have the name, the last one that was included gave it.
        rows = (row for row in reversed(module.includes) if row.scope is not None)
        module = next((row for row in rows if row.scope and store.get(row.scope.key, name) is not None), module)
    return module


def _has_copy(store: Store, module: Module, name: str, home: Module) -> bool:
    value = None if module.scope is None else store.get(module.scope.key, name)
    return value is not None and not isinstance(value, Declared) and _home(store, module, name) is home


def _includers(module: Module) -> Iterator[Module]:
    """The files that include a file, directly or not."""
    seen, left = {module.path}, [module]
    while left:
        for includer in left.pop().includers:
            if includer.path not in seen:
                seen.add(includer.path)
                left.append(includer)
                yield includer


@once_for
def _variables(code: facts.Facts) -> tuple[str, ...]:
    """The names that a file gives to what is at its top, each as often as it does."""
    return tuple(_assigned(code.body))


def _assigned(body: list[facts.Stmt]) -> Iterator[str]:
    for statement in body:
        match statement:
            case facts.Assign(targets=targets):
                yield from (target.id for target in targets if isinstance(target, facts.Name))
            case facts.If(body=inner, orelse=other):
                yield from _assigned(inner)
                yield from _assigned(other)
            case _:
                pass


__all__ = ["bind"]
