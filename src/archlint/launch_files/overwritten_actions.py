"""Launch actions that are lost: the variable that one is assigned to gets another before anything has read it."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence

from archlint.analysis.limit_sites import same_code
from archlint.launch_files.wrong_launch_descriptions import Wrong, WrongDescription
from archlint.syntax import facts
from archlint.syntax.parts import everything_in


def overwritten_actions(
    body: Sequence[facts.Stmt], class_of: Callable[[facts.Expr], str], actions: Collection[str]
) -> Iterator[WrongDescription]:
    """Each action in a block of statements that the next statement with a word for its variable replaces by another.
    ``class_of`` names the class of launch that a value makes, and ``actions`` are those of launch."""
    for number, statement in enumerate(body):
        match statement:
            case facts.Assign(targets=[facts.Name(id=name, span=span)], value=value) if class_of(value) in actions:
                following = next((later for later in body[number + 1 :] if _names(later, name)), None)
                other = None if following is None else _makes_another(following, name, value, class_of, actions)
                if other is not None:
                    line, twice = str(other.span[0]), _program(value) == _program(other.value) != {}
                    yield WrongDescription(Wrong.OVERWRITTEN, span, name, class_of(value), wanted=line, twice=twice)


def _makes_another(
    statement: facts.Stmt,
    name: str,
    first: facts.Expr,
    class_of: Callable[[facts.Expr], str],
    actions: Collection[str],
) -> facts.Assign | None:
    """A statement if it gives a variable another action than the first; of the same, nothing is lost."""
    match statement:
        case facts.Assign(targets=[facts.Name(id=assigned)], value=value) if assigned == name:
            is_other = class_of(value) in actions and not _names(value, name) and not same_code(value, first)
            return statement if is_other else None
    return None


def _program(action: facts.Expr) -> dict[str, object]:
    """The package and the executable that an action starts, where both are written, and the arguments that tell one
    program that is started from another."""
    given = {argument.keyword: argument.value for argument in action.args} if isinstance(action, facts.Call) else {}
    written = {key: value.value for key, value in given.items() if key and isinstance(value, facts.Literal)}
    tells = {"arguments", "namespace", "remappings", "ros_arguments"} & given.keys()
    return {key: written[key] for key in ("package", "executable")} if not tells and written.keys() >= _PROGRAM else {}


_PROGRAM = frozenset({"package", "executable"})


def _names(part: facts.Stmt | facts.Expr, name: str) -> bool:
    return any(each.id == name for each in everything_in([part], facts.Name))


__all__ = ["overwritten_actions"]
