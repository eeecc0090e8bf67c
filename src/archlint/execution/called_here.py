"""The methods of a class and the functions of a file that code of that file calls by their names."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import called_name

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.model import Callback


def called_here(call: facts.Call, caller: facts.Function, file: facts.Facts) -> facts.Function | None:
    """The method of the caller's class, or the function of the file, that a call means by its name; None where it may
    be another one, or a decorator changes what it does."""
    match call.func:
        case facts.Attribute(value=facts.Name(id=owner), attr=name) if caller.params and owner == caller.params[0].name:
            cls = _class_of(caller, file)
            return None if cls is None else _only(cls.body, name)
        case facts.Name(id=name):
            return _only(file.body, name)
    return None


def is_called_directly(code: SourceCode, callback: Callback) -> bool:
    """Whether a line of its file calls a callback, too, and does not await it: made async, it would not run there."""
    file, name = code.facts_at(callback.file), callback.name.rpartition(".")[2]
    if file is None:
        return False
    awaited = {id(part.value) for part in everything_in(file.body, facts.Await)}
    called = (call for call in everything_in(file.body, facts.Call) if called_name(call) == name)
    return any(id(call) not in awaited for call in called)


def _class_of(method: facts.Function, file: facts.Facts) -> facts.Class | None:
    classes = everything_in(file.body, facts.Class)
    return next((cls for cls in classes if any(member is method for member in cls.body)), None)


def _only(body: Sequence[facts.Stmt], name: str) -> facts.Function | None:
    named = [member for member in body if isinstance(member, facts.Function) and member.name == name]
    return named[0] if len(named) == 1 and not named[0].decorators else None


__all__ = ["called_here", "is_called_directly"]
