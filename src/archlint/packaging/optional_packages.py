"""The packages that code of Python looks for and can do without: the look-up is tried, and code goes on without it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from archlint.syntax import facts
from archlint.syntax.parts import everything_in, once_for
from archlint.syntax.walk import called_name

_LOOK_UPS = frozenset({"get_package_share_directory", "get_package_share_path", "get_package_prefix"})
_CAUGHT = frozenset({"PackageNotFoundError", "KeyError", "LookupError", "Exception", "BaseException"})
"""What such a look-up raises, and the classes that this derives from."""
_ENDS = frozenset({"exit", "_exit", "abort"})


@once_for
def optional_packages(file_facts: facts.Facts) -> frozenset[str]:
    """The packages that a file looks for only where it catches that there is none, and goes on."""
    helpers = {function.name for function in everything_in(file_facts.body, facts.Function) if _is_helper(function)}
    tried = {call.span for attempt in _tolerant(file_facts.body) for call in everything_in(attempt.body, facts.Call)}
    optional: set[str] = set()
    needed: set[str] = set()
    for call in everything_in(file_facts.body, facts.Call):
        match call.args[:1]:
            case [facts.Argument(value=facts.Literal(value=str(name)))]:
                if called_name(call) in helpers or (called_name(call) in _LOOK_UPS and call.span in tried):
                    optional.add(name)
                elif called_name(call) in _LOOK_UPS:
                    needed.add(name)
    return frozenset(optional - needed)


def _tolerant(body: Sequence[facts.Stmt], may_return: bool = False) -> Iterator[facts.Try]:
    """The attempts after which code goes on without what it looked for."""
    for attempt in everything_in(body, facts.Try):
        handlers = [row for row in attempt.handlers if row.type is None or not row.caught.isdisjoint(_CAUGHT)]
        if handlers and not any(_ends(handler, may_return) for handler in handlers):
            yield attempt


def _ends(handler: facts.Handler, may_return: bool) -> bool:
    kinds = facts.Raise if may_return else (facts.Raise, facts.Return)
    return any(
        isinstance(part, kinds) or (isinstance(part, facts.Call) and called_name(part) in _ENDS)
        for part in everything_in(handler.body)
    )


def _is_helper(function: facts.Function) -> bool:
    """Whether a function looks for a package that it is given, and says if there is none."""
    given = {param.name for param in function.params}
    return any(
        called_name(call) in _LOOK_UPS and any(argument.value.variable in given for argument in call.args)
        for attempt in _tolerant(function.body, True)
        for call in everything_in(attempt.body, facts.Call)
    )


__all__ = ["optional_packages"]
