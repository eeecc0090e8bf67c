"""Names that code takes from modules of launch, launch_ros and rclpy, and that none has had there since Foxy."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Union

from archlint.analysis.kept import kept_for_each_file
from archlint.libraries.module_names import is_known, is_module, lacks
from archlint.place import Place
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in
from archlint.syntax.walk import main_guard

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_Import = Union[facts.Import, facts.ImportFrom]
_TOLERANT = frozenset({"AttributeError", "BaseException", "Exception", "ImportError", "ModuleNotFoundError"})
"""What an ``except`` names that goes on without a name."""


@dataclass(frozen=True)
class Absent:
    """A name that a module does not have, or a module that is not there: ``name`` is empty then, or what the code would
    have of it."""

    module: str
    name: str
    is_import: bool
    """Whether an import asks for it, and not an attribute of the module: ``rclpy.name``."""
    in_function: bool
    span: facts.Span
    in_except: bool = False
    """Whether an ``except`` names it, which is looked at only once something has been raised."""
    in_node: bool = False
    """Whether it is called without an argument in a method of a class whose base is called a node: ``self`` has what
    nodes have."""
    called_bare: bool = False
    """Whether it is called without an argument."""
    in_main: bool = False
    """Whether it runs only where the file is a program: behind ``if __name__ == '__main__':``."""
    written: str = ""
    """What the code calls the module of which it reads an attribute."""
    by_position: bool = False
    """Whether it is called with an argument by position."""

    @property
    def is_module(self) -> bool:
        """Whether the module itself is what is not there."""
        return not is_module(self.module)

    def place(self, file: str) -> Place:
        """Where it stands."""
        return Place(file, *self.span)


def absent_imports(workspace: WorkspaceIndex) -> Iterator[tuple[str, Absent]]:
    """Each such name in the files that were asked for, with its file; not in test code, nor where the workspace has
    modules of that name itself."""
    for file, _ in workspace.code.judged():
        if workspace.roles.is_test(file.relative):
            continue
        for absent in _absent(workspace, file.relative) or ():
            top = absent.module.partition(".")[0]
            if top not in workspace.code.top_modules and workspace.code.path_of_import(file.relative, top) is None:
                yield file.relative, absent


@kept_for_each_file
def _absent(file_facts: facts.Facts) -> list[Absent]:
    code = ModulesInCode(file_facts, KnownNames(is_module, lacks, _is_absent))
    if not any(is_known(statement.module) for statement in code.statements):
        return []
    return code.absent()


@dataclass(frozen=True)
class KnownNames:
    """What is known of some modules."""

    is_module: Callable[[str], bool]
    lacks: Callable[[str, str], bool]
    """Whether a module certainly has no such name."""
    is_absent: Callable[[str], bool] = lambda _: False
    """Whether a module is certainly not there."""


class ModulesInCode:
    """What one file imports, and which of its names are certainly modules."""

    def __init__(self, file_facts: facts.Facts, known: KnownNames) -> None:
        self._known = known
        self._body = file_facts.body
        self.statements: list[_Import] = [
            *everything_in(file_facts.body, facts.Import),
            *everything_in(file_facts.body, facts.ImportFrom),
        ]
        self._forgiven = {Itself(part) for block in forgiving(file_facts) for part in everything_in(block)}
        functions = everything_in(file_facts.body, facts.Function)
        self._in_functions = {Itself(part) for function in functions for part in everything_in(function.body)}
        caught = [h.type for t in everything_in(file_facts.body, facts.Try) for h in t.handlers if h.type is not None]
        self._caught = {Itself(part) for part in everything_in(caught)}
        self._never_run = {Itself(part) for hint in _unread_hints(file_facts) for part in everything_in([hint])}
        self._asked_of_nodes = {Itself(call.func) for call in _bare_calls_in_nodes(file_facts)}
        self._called_bare = {Itself(call.func) for call in everything_in(file_facts.body, facts.Call) if not call.args}
        calls = everything_in(file_facts.body, facts.Call)
        self._by_position = {
            Itself(call.func) for call in calls if any(not (given.keyword or given.star) for given in call.args)
        }
        main = main_guard(file_facts)
        self._in_main = set() if main is None else {Itself(part) for part in everything_in(main.body)}
        self._bound: dict[str, set[str]] = {}

    def absent(self) -> list[Absent]:
        """What the file asks modules for in vain, in the order of the source."""
        for part in everything_in(self._body):
            self._note(part)
        return sorted((*self._imports(), *self._attributes()), key=lambda absent: absent.span)

    def _imports(self) -> Iterator[Absent]:
        """The names and modules that imports ask for in vain."""
        for statement in self.statements:
            if Itself(statement) not in self._forgiven:
                for module, name in self._asked_for(statement):
                    yield Absent(
                        module,
                        name,
                        True,
                        Itself(statement) in self._in_functions,
                        statement.span,
                        in_main=Itself(statement) in self._in_main,
                    )

    def _attributes(self) -> Iterator[Absent]:
        """The attributes of modules that the code reads in vain."""
        for part in everything_in(self._body, facts.Attribute):
            module = self._module(part.value.dotted)
            left_out = Itself(part) in self._forgiven or Itself(part) in self._never_run
            if module and self._known.lacks(module, part.attr) and not left_out:
                in_function, in_except = (Itself(part) in parts for parts in (self._in_functions, self._caught))
                in_node = Itself(part) in self._asked_of_nodes
                bare, in_main = (Itself(part) in parts for parts in (self._called_bare, self._in_main))
                written = part.value.dotted
                given = Itself(part) in self._by_position
                yield Absent(
                    module, part.attr, False, in_function, part.span, in_except, in_node, bare, in_main, written, given
                )

    def _asked_for(self, statement: _Import) -> Iterator[tuple[str, str]]:
        """The modules that a statement imports and that are not there, and the names that modules do not have."""
        is_absent, lacks = self._known.is_absent, self._known.lacks
        match statement:
            case facts.Import(module=module) if is_absent(module):
                yield module, ""
            case facts.ImportFrom(module=module, level=0, names=[(name, _), *_]) if is_absent(module):
                yield module, "" if name == "*" else name
            case facts.ImportFrom(module=module, level=0, names=names):
                yield from ((module, name) for name, _ in names if name != "*" and lacks(module, name))

    def _module(self, path: str) -> str:
        """The module that a dotted name means; empty where it is none, or perhaps something else."""
        head, dot, rest = path.partition(".")
        meant = self._bound.get(head, set()) if head else set()
        module = f"{next(iter(meant))}{dot}{rest}" if len(meant) == 1 else ""
        return module if self._known.is_module(module) else ""

    def _note(self, part: facts.Base) -> None:
        """Note which modules a name stands for; the empty one where it stands for something else."""
        match part:
            case facts.Import(module=module, alias=alias):
                top = module.partition(".")[0]
                self._bind(alias or top, module if alias else top)
            case facts.ImportFrom(module=module, level=level, names=names):
                for name, bound in names:
                    self._bind(bound, "" if level else f"{module}.{name}")
            case facts.Function(name=name) | facts.Class(name=name) | facts.Param(name=name):
                self._bind(name, "")
            case facts.Handler(name=str(name)):
                self._bind(name, "")
        for target in part.assigned:
            for inner in everything_in(target):
                self._bind(inner.variable, "")

    def _bind(self, name: str, module: str) -> None:
        self._bound.setdefault(name, set()).add(module)


def _bare_calls_in_nodes(file_facts: facts.Facts) -> Iterator[facts.Call]:
    """The calls without an argument in methods of classes with a base that is called a node."""
    for cls in everything_in(file_facts.body, facts.Class):
        if any(base.value.last_name.endswith("Node") for base in cls.bases):
            methods = (part for part in cls.body if isinstance(part, facts.Function) and part.params)
            for method in methods:
                if method.params[0].name == "self":
                    yield from (call for call in everything_in(method.body, facts.Call) if not call.args)


def _is_absent(module: str) -> bool:
    private = any(part.startswith("_") for part in module.split("."))
    return is_known(module) and not is_module(module) and not private


def forgiving(file_facts: facts.Facts) -> Iterator[list[facts.Stmt]]:
    """The blocks of code that may ask for what is not there: tried ones, and those for type checkers alone."""
    for statement in everything_in(file_facts.body, facts.Statement):
        match statement:
            case facts.Try(body=body, handlers=handlers) if any(map(is_tolerant, handlers)):
                yield body
            case facts.If(test=test, body=body) if test.last_name == "TYPE_CHECKING":
                yield body


def _unread_hints(file_facts: facts.Facts) -> Iterator[facts.Expr]:
    """The annotations that Python does not evaluate: those of local variables, and all of a file that says so."""
    future = any(
        statement.module == "__future__" and any(name == "annotations" for name, _ in statement.names)
        for statement in everything_in(file_facts.body, facts.ImportFrom)
    )
    for function in everything_in(file_facts.body, facts.Function):
        yield from (hint.annotation for hint in everything_in(function.body, facts.Annotated))
    for part in everything_in(file_facts.body) if future else ():
        match part:
            case facts.Annotated(annotation=hint):
                yield hint
            case facts.Param(annotation=hint) | facts.Function(returns=hint) if hint is not None:
                yield hint


def is_tolerant(handler: facts.Handler) -> bool:
    """Whether code goes on where a name or a module is not there."""
    return handler.type is None or not handler.caught.isdisjoint(_TOLERANT)


__all__ = ["Absent", "KnownNames", "ModulesInCode", "absent_imports", "forgiving", "is_tolerant"]
