"""Constructors of bases that get no object: ``super.__init__('talker')``, without the parentheses of ``super()``, and
``Talker.__init__('talker')`` without ``self``."""

from __future__ import annotations

from collections.abc import Iterator

from archlint.syntax import facts
from archlint.syntax.misspelt_constructor import CONSTRUCTOR
from archlint.syntax.parts import everything_in, once_for, parts_of
from archlint.syntax.walk import statements_of


@once_for
def bare_super_calls(cls: facts.Class) -> list[facts.Call]:
    """The calls in a class of the constructor of ``super`` itself.  It takes an object of ``super`` and raises a
    TypeError for anything else, be it ``self``."""
    return [call for call in everything_in(cls.body, facts.Call) if _is_of_bare_super(call)]


def _is_of_bare_super(call: facts.Call) -> bool:
    match call.func, call.args:
        case facts.Attribute(value=facts.Name(id="super"), attr="__init__"), []:
            return True
        case facts.Attribute(value=facts.Name(id="super"), attr="__init__"), [first, *_]:
            return not first.star and not isinstance(first.value, facts.Call)  # which may give an object of super
    return False


@once_for
def calls_without_self(cls: facts.Class) -> list[facts.Call]:
    """The calls in the constructor of a class of that of a base to which the object is not passed: what stands first is
    a constant, or another argument of the constructor."""
    bases = {base.value.dotted for base in cls.bases if base.keyword is None and not base.star} - {""}
    return [call for method in statements_of(cls.body, facts.Function) for call in _without_self(method, bases)]


def _without_self(method: facts.Function, bases: set[str]) -> Iterator[facts.Call]:
    names = [param.name for param in method.params if param.kind in ("positional_only", "normal", "keyword_only")]
    if method.name != CONSTRUCTOR or names[:1] != ["self"] or method.decorators:
        return
    for call in parts_of(method.body, facts.Call):
        match call.func, call.args:
            case facts.Attribute(value=owner, attr="__init__"), [first, *_] if owner.dotted in bases:
                if first.star or first.keyword is not None or _is_passed(call, "self"):
                    continue
                if isinstance(first.value, facts.Literal) or first.value.variable in names:
                    yield call


def _is_passed(call: facts.Call, name: str) -> bool:
    return any(part.id == name for argument in call.args for part in parts_of(argument.value, facts.Name))


__all__ = ["bare_super_calls", "calls_without_self"]
