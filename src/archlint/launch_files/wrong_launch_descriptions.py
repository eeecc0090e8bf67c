"""What can be wrong with the launch description that a launch file makes, as data."""

from __future__ import annotations

from archlint.records import dataclass
from archlint.string_enum import StringEnum
from archlint.syntax import facts


class Wrong(StringEnum):
    """What is wrong with what a launch file makes."""

    NOTHING = "nothing"
    """``generate_launch_description()`` returns nothing."""
    LIST = "list"
    """It returns a list, or a single action."""
    NO_LIST = "no list"
    """A list is wanted, and something else is given."""
    IN_LIST = "in list"
    """Something is in a list that does not belong there."""
    MISNAMED = "misnamed"
    """What makes the launch description has another name than launch looks for."""
    PARAMETER = "parameter"
    """It wants an argument, and launch passes none."""
    NOT_ADDED = "not added"
    """An action that nothing adds to the launch description."""
    OVERWRITTEN = "overwritten"
    """An action in a variable that is given another before anything adds the first: ``wanted`` is the line."""
    TUPLE = "tuple"
    """A comma behind an action makes a tuple of it."""
    COMMA = "comma"
    """No comma stands between two actions."""
    OPAQUE = "opaque"
    """The function of an OpaqueFunction returns something else than a list."""
    OPAQUE_CALLED = "opaque called"
    """It is called, and what it returns is passed."""
    OPAQUE_CONTEXT = "opaque context"
    """It takes no argument, and launch passes the context."""


@dataclass(frozen=True)
class WrongDescription:
    """One place: ``given`` is what is there, ``wanted`` what launch takes, ``of`` the argument or class it is for.
    Of a declaration that is not added, ``argument`` is what it declares; ``twice`` is true of an action after which
    another starts the same program."""

    kind: Wrong
    span: facts.Span
    given: str
    of: str = ""
    wanted: str = ""
    argument: str = ""
    twice: bool = False


__all__ = ["Wrong", "WrongDescription"]
