"""Objects of the workspace's classes, where one call of the class is all that a variable of a function, or an attribute
of ``self``, is ever assigned, and what code calls them for."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.python_code.class_chains import ClassInFile, classes_of, files_with, targets_of
from archlint.python_code.offered_names import may_make_names
from archlint.python_code.own_calls import assigned_attributes, bindings_of, class_meant_by
from archlint.python_code.tried_code import tried_for
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.bindings import names_bound
from archlint.syntax.parts import Itself, everything_in, once_for

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex


@dataclass(frozen=True)
class CallOfObject:
    """A method that is called on such an object."""

    span: facts.Span
    """Where the method is named."""
    call: facts.Span
    written: str
    """What is called, as it is written."""
    made_by: str
    """The class that makes the object, as it is written."""
    attribute: str
    """The attribute of ``self`` that holds it; empty where it is a variable."""
    given: int
    """How many arguments are given by position."""
    keywords: tuple[str, ...]
    starred: bool
    """Whether some are not written out."""
    forgiven: tuple[str, ...]
    """Which of AttributeError and TypeError the code around expects."""

    @property
    def name(self) -> str:
        """The method."""
        return self.written.rpartition(".")[2]


@kept_for_each_file
def calls_of_objects(code: facts.Facts) -> list[CallOfObject]:
    """Every such call in a file."""
    if may_make_names(code):
        return []
    tried = {error: tried_for(code.body, {error}) for error in ("AttributeError", "TypeError")}
    rows = []
    for call, part, made_by, attribute in (*_of_variables(code), *_of_attributes(code)):
        keywords = tuple(argument.keyword for argument in call.args if argument.keyword is not None)
        forgiven = tuple(error for error, parts in tried.items() if Itself[facts.Base](part) in parts)
        starred = any(argument.star for argument in call.args)
        given = len(call.args) - len(keywords)
        rows.append(
            CallOfObject(part.span, call.span, part.dotted, made_by, attribute, given, keywords, starred, forgiven)
        )
    return rows


_Row = tuple[facts.Call, facts.Attribute, str, str]


def _of_variables(code: facts.Facts) -> Iterator[_Row]:
    """The calls of objects that variables hold, each in the function, or at the top of the module, that makes one."""
    seen: set[Itself[facts.Base]] = set()
    scopes: tuple[facts.Facts | facts.Function, ...] = (code, *everything_in(code.body, facts.Function))
    for scope in scopes:
        makers_of = _made(scope)
        for call in everything_in(scope.body, facts.Call) if makers_of else ():
            match call.func:
                case facts.Attribute(value=facts.Name(id=name)) as part if name in makers_of:
                    if Itself[facts.Base](part) not in seen:
                        seen.add(Itself[facts.Base](part))
                        yield call, part, makers_of[name], ""


@once_for
def _made(scope: facts.Facts | facts.Function) -> dict[str, str]:
    """The variables that are bound once, to what a call of a plain name makes, and that name: those that are nowhere
    else in the file, or are local to a function."""
    times = bindings_of(scope) if isinstance(scope, facts.Facts) else _bound_in(scope)
    return {
        statement.targets[0].variable: statement.value.func.variable
        for statement in everything_in(scope.body, facts.Assign)
        if len(statement.targets) == 1 and times[statement.targets[0].variable] == 1
        if isinstance(statement.value, facts.Call) and statement.value.func.variable
    }


@once_for
def _bound_in(function: facts.Function) -> Counter[str]:
    """How often a function, with what is defined in it, binds each name; one that it declares global counts, too."""
    return Counter(names_bound(function))


def _of_attributes(code: facts.Facts) -> Iterator[_Row]:
    """The calls of objects that attributes of ``self`` hold."""
    for cls in classes_of(code):
        makers_of = _made_for(cls)
        for call in everything_in(cls.body, facts.Call) if makers_of else ():
            match call.func:
                case facts.Attribute(value=facts.Attribute(value=facts.Name(id="self"), attr=attr)) as part:
                    if attr in makers_of:
                        yield call, part, makers_of[attr], attr


def _made_for(cls: facts.Class) -> dict[str, str]:
    """The attributes of ``self`` that the methods of a class assign once, to what a call of a plain name makes."""
    times = Counter(target.attribute for target in targets_of(cls.body) if target.attribute)
    makers = {}
    for statement in everything_in(cls.body, facts.Assign):
        match statement:
            case facts.Assign(
                targets=[facts.Attribute(value=facts.Name(id="self"), attr=attr)],
                value=facts.Call(func=facts.Name(id=name)),
            ) if times[attr] == 1:
                makers[attr] = name
    return makers


def class_of_object(workspace: WorkspaceIndex, file: str, called: CallOfObject) -> ClassInFile | None:
    """The class of the object that such a call in a file is of; None where something else may be there."""
    if called.attribute and _is_given_elsewhere(workspace, file, called.attribute):
        return None
    return class_meant_by(workspace, file, called.made_by)


def _is_given_elsewhere(workspace: WorkspaceIndex, file: str, attribute: str) -> bool:
    """Whether another class of the file, or another file, assigns an attribute of that name: it may be the same one."""
    rows = 0
    for path in dict.fromkeys((file, *files_with(workspace, attribute))):
        assigned = assigned_attributes(workspace, path)
        if assigned is None:
            return True
        rows += assigned.get(attribute, 0)
    return rows != 1


__all__ = ["CallOfObject", "calls_of_objects", "class_of_object"]
