"""Calls of the workspace's own functions, methods and classes with arguments that their parameters do not take.

What a name means is told by the text alone: a function or a class that a file defines once and binds to nothing else,
or imports from such a file, and a method of ``self`` that no class derived from its class and no assignment replaces.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept, kept_for_each_file
from archlint.libraries.rclpy.names import NODE_CLASSES
from archlint.model import Misuse
from archlint.place import Place
from archlint.python_code.class_chains import (
    ClassInFile,
    chain_of,
    classes_of,
    derived_from,
    files_with,
    methods_of,
    targets_of,
)
from archlint.python_code.imported_modules import bindings_of, imported_once, module_meant_by, path_of
from archlint.python_code.misfits import Misfit, OwnCall, by_position_of, misfit_of, needed_of
from archlint.python_code.offered_names import may_make_names, stars
from archlint.python_code.tried_code import tried_for
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.bindings import bound_by
from archlint.syntax.misspelt_constructor import CONSTRUCTOR, meant_as_constructor
from archlint.syntax.parts import Itself, everything_in, once_for
from archlint.syntax.walk import statements_of

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_PLAIN_DECORATORS = frozenset({"abstractmethod", "classmethod", "override", "staticmethod"})
_DEPTH = 4
"""How many imports are followed to a definition."""


@dataclass(frozen=True)
class FunctionInFile:
    """A function and the file that it is in; ``bound`` is how many of its parameters a call does not give."""

    file: str
    code: facts.Function
    bound: int = 0


@dataclass(frozen=True)
class RefusedOwnCall:
    """A call that fails, of ``name``, which is defined at a place with these parameters."""

    place: Place
    name: str
    misfit: Misfit
    defined: Place
    signature: tuple[str, ...]
    """The parameters to give: those that may not be left out, or where there are too many all that go by position."""
    keywords: tuple[str, ...] = ()
    """The parameters that the call does not give and that go by name."""
    lacks_self: bool = False
    """Whether it is a method whose first parameter is not called ``self``, but takes the object."""
    stray_self: bool = False
    """Whether it is no method, and every call of the file leaves out its parameter ``self``."""
    in_node: bool = False
    """Whether a method of a node makes the call."""
    instead: str = ""
    """For a class that has no constructor: the method that was to be one."""


def refused_own_calls(workspace: WorkspaceIndex) -> Iterator[RefusedOwnCall]:
    """Every such call in the files that were asked for, but for test code."""
    for file, _ in workspace.code.judged():
        if file.kind not in ("python", "launch_python") or workspace.roles.is_test(file.relative):
            continue
        for call in own_calls_of(workspace, file.relative) or ():
            refused = refusal_of(workspace, file.relative, call, function_meant(workspace, file.relative, call))
            if refused is not None:
                yield refused


def refusal_of(
    workspace: WorkspaceIndex, file: str, call: OwnCall, meant: FunctionInFile | None
) -> RefusedOwnCall | None:
    """What is to say of a call in a file, of a function that it is known to run; None where its arguments fit."""
    wrong = None if meant is None else misfit_of(meant.code.params[meant.bound :], call)
    if meant is None or wrong is None:
        return None
    params = meant.code.params
    lacks_self = call.cls is not None and meant.bound == 1 and params[0].name not in ("self", "cls")
    own = params[meant.bound :]
    signature = tuple(needed_of(own) if wrong.misuse is not Misuse.TOO_MANY else by_position_of(own))
    keywords = _left(own, call) if wrong.misuse is Misuse.UNKNOWN_KEYWORD else ()
    cls = class_meant_by(workspace, file, call.name) if meant.code.name == CONSTRUCTOR else None
    return RefusedOwnCall(
        Place(file, *call.span),
        call.name,
        wrong,
        Place(meant.file, *meant.code.name_span),
        signature,
        keywords,
        lacks_self,
        _has_stray_self(workspace, file, call, meant),
        _is_in_node(workspace, file, call),
        "" if cls is None else meant_as_constructor([cls.code]),
    )


def _has_stray_self(workspace: WorkspaceIndex, file: str, call: OwnCall, meant: FunctionInFile) -> bool:
    params = meant.code.params
    if meant.bound or meant.file != file or not params or params[0].name != "self":
        return False
    calls = [other for other in own_calls_of(workspace, file) or () if other.name == call.name]
    mentions = [name for name in everything_in(_body(workspace, file), facts.Name) if name.id == call.name]
    return len(mentions) == len(calls) and all(misfit_of(params[1:], other) is None for other in calls)


def _body(workspace: WorkspaceIndex, file: str) -> Sequence[facts.Stmt]:
    code = workspace.facts_at(file)
    return () if code is None else code.body


def _left(params: Sequence[facts.Param], call: OwnCall) -> tuple[str, ...]:
    """The parameters that go by name and that a call does not give."""
    given = {*by_position_of(params)[: call.given], *call.keywords}
    return tuple(param.name for param in params if param.kind in ("normal", "keyword_only") and param.name not in given)


def _is_in_node(workspace: WorkspaceIndex, file: str, call: OwnCall) -> bool:
    code = workspace.facts_at(file)
    if code is None or call.within is None:
        return False
    return not NODE_CLASSES.isdisjoint(chain_of(workspace, ClassInFile(file, classes_of(code)[call.within])).foreign)


# ----------------------------------------------------------------------------------------------- which calls there are


@kept_for_each_file
def own_calls_of(code: facts.Facts) -> list[OwnCall]:
    """The calls of functions and classes that the file defines or imports, those of what is in a module that it
    imports, and those of methods of ``self``."""
    if may_make_names(code):
        return []
    forgiven = tried_for(code.body, {"TypeError"})
    around = {Itself(call): number for number, cls in enumerate(classes_of(code)) for call in _on_self(cls)}
    inside = {Itself(call): number for number, cls in enumerate(classes_of(code)) for call in _with_self(cls)}
    defined = _defined_once(code)
    rows: list[OwnCall] = []
    for call in everything_in(code.body, facts.Call):
        cls = around.get(Itself(call))
        if any(argument.star for argument in call.args) or Itself[facts.Base](call) in forgiven:
            continue
        if cls is not None or call.func.variable in defined or _is_of_module(code, call.func):
            keywords = tuple(argument.keyword for argument in call.args if argument.keyword is not None)
            given, within = len(call.args) - len(keywords), inside.get(Itself(call))
            rows.append(OwnCall(call.func.dotted, call.span, cls, given, keywords, within))
    return rows


def _defined_once(code: facts.Facts) -> frozenset[str]:
    """The names of functions and classes that a file defines or imports at its top level, and binds nowhere else."""
    if stars(code):
        return frozenset()
    names: set[str] = set()
    for statement in code.body:
        match statement:
            case facts.Function(name=name) | facts.Class(name=name):
                names.add(name)
            case facts.ImportFrom(names=imported):
                names.update(bound for _, bound in imported)
    return frozenset(name for name in names if bindings_of(code)[name] == 1)


def _is_of_module(code: facts.Facts, called: facts.Expr) -> bool:
    """Whether something of a module may be called, ``words.greet()``: of a name that only an import binds."""
    match called:
        case facts.Attribute(value=facts.Name(id=name)):
            return name in imported_once(code)
    return False


def _on_self(cls: facts.Class) -> Iterator[facts.Call]:
    """The calls ``self.name(…)`` in the methods of a class."""
    for call in _with_self(cls):
        match call.func:
            case facts.Attribute(value=facts.Name(id="self")):
                yield call


def _with_self(cls: facts.Class) -> Iterator[facts.Call]:
    """The calls in the methods of a class in which ``self`` is its object."""
    for function in methods_of(cls):
        match function.params:
            case [facts.Param(name="self", annotation=None), *_] if not function.decorators:
                pass
            case _:
                continue
        if any(part.name == "self" for part in everything_in(function.body, facts.Param)):
            continue
        yield from everything_in(function.body, facts.Call)


# ---------------------------------------------------------------------------------------------------- what they mean


def function_meant(workspace: WorkspaceIndex, file: str, call: OwnCall) -> FunctionInFile | None:
    """The function that a call runs."""
    key = function_meant, file, call.cls, call.name  # many calls are of one function, and several rules ask
    return kept(workspace, key, lambda: _function_meant(workspace, file, call))


def _function_meant(workspace: WorkspaceIndex, file: str, call: OwnCall) -> FunctionInFile | None:
    if call.cls is None:
        return _function(workspace, file, call.name)
    code = workspace.facts_at(file)
    cls = None if code is None else ClassInFile(file, classes_of(code)[call.cls])
    return None if cls is None else method_meant(workspace, cls, call.name.rpartition(".")[2])


def _function(workspace: WorkspaceIndex, file: str, name: str) -> FunctionInFile | None:
    """The function that a name means in a file, or the constructor of the class."""
    match _definition(workspace, file, name):
        case path, facts.Function(decorators=[]) as function:
            return FunctionInFile(path, function)
        case path, facts.Class() as cls:
            return _constructor(workspace, ClassInFile(path, cls))
    return None


def class_meant_by(workspace: WorkspaceIndex, file: str, name: str) -> ClassInFile | None:
    """The class of the workspace that a name means in a file."""
    match _definition(workspace, file, name):
        case path, facts.Class() as cls:
            return ClassInFile(path, cls)
    return None


def _definition(
    workspace: WorkspaceIndex, file: str, name: str, depth: int = _DEPTH
) -> tuple[str, facts.Function | facts.Class] | None:
    """What defines a name that a file binds once, and the file that this is in."""
    owner, _, own_name = name.rpartition(".")
    if owner:
        path = module_meant_by(workspace, file, owner)
        sure = path is not None and not _is_assigned(workspace, own_name)
        return _definition(workspace, path, own_name, depth - 1) if path is not None and sure else None
    code = workspace.facts_at(file)
    if code is None or depth <= 0 or (_bindings(workspace, file) or {}).get(name) != 1:
        return None
    for statement in code.body:
        match statement:
            case facts.Function(name=defined) | facts.Class(name=defined) if defined == name:
                return file, statement
            case facts.ImportFrom(names=names) if any(bound == name for _, bound in names):
                own = next(own for own, bound in names if bound == name)
                path = path_of(workspace, file, statement.module, statement.level)
                return None if path is None else _definition(workspace, path, own, depth - 1)
    return None


@kept_for_each_file
def _bindings(code: facts.Facts) -> dict[str, int]:
    """The same; nothing for a file in which a star may bind any of them."""
    return {} if stars(code) else dict(bindings_of(code))


def _constructor(workspace: WorkspaceIndex, cls: ClassInFile) -> FunctionInFile | None:
    chain = chain_of(workspace, cls)
    if not chain.complete or any("__new__" in _methods(own.code) for own in chain.own):
        return None
    for own in chain.own:
        constructor = _methods(own.code).get("__init__")
        if constructor is not None:
            return FunctionInFile(own.file, constructor, 1) if _is_plain(own.code, constructor) else None
        if len(own.code.bases) > 1:
            return None
    return None if {*chain.foreign} - {"object"} else FunctionInFile(cls.file, _of_object(cls.code))


@once_for
def _of_object(code: facts.Class) -> facts.Function:
    """The constructor of a class that has none: it takes no argument."""
    return facts.Function("__init__", [], [], [], None, False, False, code.span, code.name_span)


def method_meant(workspace: WorkspaceIndex, cls: ClassInFile, name: str) -> FunctionInFile | None:
    """The method that ``self.name`` means in the methods of a class."""
    chain = chain_of(workspace, cls)
    own = next((each for each in chain.own if name in _methods(each.code)), None)
    if own is None or (own.code is not cls.code and not chain.complete) or cls.code.decorators:
        return None
    method = _methods(own.code)[name]
    if not _is_plain(own.code, method) or _is_replaced(workspace, cls, name):
        return None
    static = any(decorator.last_name == "staticmethod" for decorator in method.decorators)
    bound = 0 if static else 1
    return FunctionInFile(own.file, method, bound) if len(method.params) >= bound else None


@once_for
def _methods(code: facts.Class) -> dict[str, facts.Function]:
    return {function.name: function for function in methods_of(code)}


def _is_plain(code: facts.Class, function: facts.Function) -> bool:
    """Whether a method is what its definition says: nothing else in the body of the class has its name."""
    decorated = any(decorator.last_name not in _PLAIN_DECORATORS for decorator in function.decorators)
    return _times_bound(code)[function.name] == 1 and not decorated


@once_for
def _times_bound(code: facts.Class) -> Counter[str]:
    """How often the body of a class binds each name."""
    return Counter(name for statement in statements_of(code.body) for name in bound_by(statement))


def _is_replaced(workspace: WorkspaceIndex, cls: ClassInFile, name: str) -> bool:
    """Whether a derived class has something of its own by a name, or any code assigns it."""
    if any(_times_bound(derived.code)[name] for derived in derived_from(workspace, cls)):
        return True
    return _is_assigned(workspace, name, cls.file)


def _is_assigned(workspace: WorkspaceIndex, name: str, *more: str) -> bool:
    """Whether any code assigns an attribute of a name, of whatever object."""
    files = dict.fromkeys((*more, *files_with(workspace, name)))
    return any((assigned := assigned_attributes(workspace, file)) is None or name in assigned for file in files)


@kept_for_each_file
def assigned_attributes(code: facts.Facts) -> dict[str, int]:
    """How often a file assigns an attribute of each name, of whatever object."""
    return dict(Counter(target.attribute for target in targets_of(code.body) if target.attribute))


__all__ = [
    "FunctionInFile",
    "Misfit",
    "OwnCall",
    "RefusedOwnCall",
    "assigned_attributes",
    "bindings_of",
    "class_meant_by",
    "function_meant",
    "method_meant",
    "own_calls_of",
    "refusal_of",
    "refused_own_calls",
]
