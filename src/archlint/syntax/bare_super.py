"""``super.__init__('talker')``, which lacks the parentheses of ``super()``."""

from __future__ import annotations

from archlint.syntax import facts
from archlint.syntax.parts import everything_in, once_for


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


__all__ = ["bare_super_calls"]
