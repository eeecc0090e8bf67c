"""What a module shares with all of its functions, and which of these use it although nothing is seen to call them."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING

from archlint.interpreter.bindings import bound_in, bound_names
from archlint.libraries.interest import interesting
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in, names_in, once_for

if TYPE_CHECKING:
    from archlint.interpreter.modules import Module
    from archlint.libraries.run import Run
    from archlint.libraries.state import Root


def unseen_use(run: Run, root: Root) -> str | None:
    """The first function that uses what is shared and that this program is not seen to call, in words; None where
    there is none."""
    # Whoever runs a class or a function that nothing here runs may be any code.
    start = run.first_module if run.program.executable else None
    for module in run.index.loaded() if start is None else run.index.in_process(start):
        here = module is root.module
        if not here and root.module.name.rpartition(".")[2] not in _imported(module.facts):
            continue
        for function in _functions(Itself(module.facts)):
            if id(function) not in run.ran and _uses(function, root, here):
                return f"{function.name}() in {module.path} can access it, and nothing here calls that function"
    return None


def _uses(function: facts.Function, root: Root, here: bool) -> bool:
    names = names_in(function)
    if root.name not in names or (root.owner is not None and not here and root.owner not in names):
        return False
    if root.owner is None and here and root.name in bound_names(function)[0]:
        return False  # a variable of its own that is called the same
    return interesting(function) or bare(function, frozenset({root.name}))


@lru_cache(maxsize=20_000)
def _bare(key: Itself[facts.Function | facts.Lambda], names: frozenset[str]) -> bool:
    stack: list[facts.Base] = [key.fact]
    while stack:
        item = stack.pop()
        if item.last_name in names:
            return True
        if isinstance(item, facts.Attribute):
            # What only an attribute is read of stays where it is.
            stack += [] if item.dotted else [item.owner]
        else:
            stack += item.children()
    return False


def bare(function: facts.Function | facts.Lambda, names: frozenset[str]) -> bool:
    """Whether a function does more with one of these names (variables, or attributes of any object) than read
    attributes of it and call its methods."""
    return _bare(Itself(function), names)


@lru_cache(maxsize=4096)
def _functions(key: Itself[facts.Facts]) -> tuple[facts.Function, ...]:
    return tuple(everything_in(key.fact, facts.Function))


@once_for
def _imported(code: facts.Facts) -> frozenset[str]:
    """The words of which the imports in a file are made, wherever they stand: of modules, and of what they give."""
    words: set[str] = set()
    for item in everything_in(code, facts.Statement):
        match item:
            case facts.Import():
                words.update(item.module.split("."))
            case facts.ImportFrom():
                words.update(item.module.split("."), (name for name, _ in item.names))
    return frozenset(words)


def variables(module: Module) -> frozenset[str]:
    """The variables that a module's top level binds."""
    return _variables(Itself(module.facts))


@lru_cache(maxsize=4096)
def _variables(key: Itself[facts.Facts] | Itself[facts.Class]) -> frozenset[str]:
    return bound_in(key.fact.body)


def class_variables(ir: facts.Class) -> frozenset[str]:
    """The names that a class body binds."""
    return _variables(Itself(ir))


__all__ = ["bare", "class_variables", "unseen_use", "variables"]
