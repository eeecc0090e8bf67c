"""The packages whose folders code of Python looks for: which it needs, and which it can do without, as it tries the
look-up and goes on."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from archlint.analysis.kept import kept_for_each_file
from archlint.syntax import facts
from archlint.syntax.parts import everything_in, once_for
from archlint.syntax.walk import called_name

LOOK_UPS = frozenset({"get_package_share_directory", "get_package_share_path", "get_package_prefix"})
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
                if called_name(call) in helpers or (called_name(call) in LOOK_UPS and call.span in tried):
                    optional.add(name)
                elif called_name(call) in LOOK_UPS:
                    needed.add(name)
    return frozenset(optional - needed)


@kept_for_each_file
def packages_looked_up(file_facts: facts.Facts) -> list[tuple[str, facts.Span]]:
    """The packages that a file looks for in ament's index by their names, wherever no condition stands before that."""
    imports = (i for i in everything_in(file_facts.body, facts.ImportFrom) if i.module.startswith("ament_index_python"))
    bound = {bound for i in imports for name, bound in i.names if name in LOOK_UPS}
    if not bound:
        return []
    aside: list[facts.Call] = []
    for branch in everything_in(file_facts.body, facts.If):
        aside += everything_in([*branch.body, *branch.orelse], facts.Call)
    for attempt in everything_in(file_facts.body, facts.Try):
        aside += everything_in([attempt], facts.Call)
    conditional = {call.span for call in aside}
    looked: list[tuple[str, facts.Span]] = []
    for call in everything_in(file_facts.body, facts.Call):
        match call:
            case facts.Call(func=facts.Name(id=name), args=[facts.Argument(value=facts.Literal(value=str(package)))]):
                if name in bound and call.span not in conditional:
                    looked.append((package, call.span))
    return looked


def _tolerant(body: Sequence[facts.Stmt], may_return: bool = False) -> Iterator[facts.Try]:
    """The attempts after which code goes on without what it looked for."""
    for attempt in everything_in(body, facts.Try):
        handlers = [row for row in attempt.handlers if row.type is None or not row.caught.isdisjoint(_CAUGHT)]
        if handlers and not any(_ends(handler, may_return) for handler in handlers):
            yield attempt


def _ends(handler: facts.Handler, may_return: bool) -> bool:
    for part in everything_in(handler.body):
        match part:
            case facts.Return(value=value) if not may_return and not _describes(value):
                return True
            case facts.Raise():
                return True
            case facts.Call() if called_name(part) in _ENDS:
                return True
    return False


def _describes(value: facts.Expr | None) -> bool:
    """Whether a launch file returns what it starts without the package."""
    match value:
        case facts.Call(args=[facts.Argument(value=facts.Sequence(elements=items))]):
            return called_name(value) == "LaunchDescription" and bool(items)
    return False


def _is_helper(function: facts.Function) -> bool:
    """Whether a function looks for a package that it is given, and says if there is none."""
    given = {param.name for param in function.params}
    return any(
        called_name(call) in LOOK_UPS and any(argument.value.variable in given for argument in call.args)
        for attempt in _tolerant(function.body, True)
        for call in everything_in(attempt.body, facts.Call)
    )


__all__ = ["LOOK_UPS", "optional_packages", "packages_looked_up"]
