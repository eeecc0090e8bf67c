"""Which branches of CMake's ``if`` blocks run: known where they compare what a loop or a call gives."""

from __future__ import annotations

import re
from collections.abc import Container, Sequence

from archlint.records import dataclass
from archlint.workspace.cmake import Argument, Command

_VARIABLE = re.compile(r"\$\{([\w.+/-]+)\}")
_PLAIN = re.compile(r"[a-z][\w./-]*")
"""A text without quotes that is hardly the name of a variable, which ``if`` would replace by its value."""

_EDITIONS = frozenset({"ROS1", "ROS2"})
"""What a variable of a package for both is compared with: ``if(ROS_EDITION STREQUAL "ROS1")``."""


@dataclass
class _Block:
    """An ``if`` block, in one of its branches: the ``condition`` of the first, empty behind an ``else``."""

    condition: str
    holds: bool | None
    """Whether the branch runs."""
    decided: bool | None
    """Whether a branch before the next one runs."""


class Branches:
    """The ``if`` blocks around the command that runs."""

    def __init__(self) -> None:
        self._blocks: list[_Block] = []

    def enter(
        self, command: Command, arguments: Sequence[Argument], variables: Container[str], known: Container[str]
    ) -> None:
        """Keep track of the blocks; ``arguments`` are those of the command with the values of ``variables``, of which
        those are sure that are ``known``."""
        if command.name == "if":
            holds = _holds(command.arguments, arguments, variables, known)
            self._blocks.append(_Block(" ".join(command.texts), holds, holds))
        elif command.name in ("else", "elseif") and self._blocks:
            block = self._blocks[-1]
            test = True if command.name == "else" else _holds(command.arguments, arguments, variables, known)
            block.condition = ""
            block.holds = _both(_opposite(block.decided), test)
            block.decided = _either(block.decided, test)
        elif command.name == "endif" and self._blocks:
            self._blocks.pop()

    @property
    def left_out(self) -> bool:
        """Whether what is here certainly does not run."""
        return any(block.holds is False for block in self._blocks)

    @property
    def conditional(self) -> bool:
        """Whether what is here may or may not run."""
        return bool(self._open)

    @property
    def of_tests(self) -> bool:
        """Whether only ``if(BUILD_TESTING)`` is around it."""
        return {block.condition for block in self._open} == {"BUILD_TESTING"}

    @property
    def _open(self) -> list[_Block]:
        return [block for block in self._blocks if block.holds is None]


def _holds(
    written: Sequence[Argument], arguments: Sequence[Argument], variables: Container[str], known: Container[str]
) -> bool | None:
    """Whether a comparison of two texts holds, None where it is another condition or one of its values is not sure."""
    negated = bool(written) and written[0].text == "NOT"
    if negated:
        written, arguments = written[1:], arguments[1:]
    match [argument.text for argument in written]:
        case ["$ENV{ROS_VERSION}", "STREQUAL" | "EQUAL", "1" | "2" as version]:
            return (version == "2") != negated
        case [_, "STREQUAL", _] if len(arguments) == len(written):
            left, _, right = zip(written, arguments, strict=True)
            if all(_is_sure(*side, variables, known) for side in (left, right)):
                return (left[1].text == right[1].text) != negated
            if written[2].text in _EDITIONS:
                return (written[2].text == "ROS2") != negated
    return None


def _is_sure(written: Argument, argument: Argument, variables: Container[str], known: Container[str]) -> bool:
    """Whether a side of a comparison is the text that it seems to be: ``if`` takes a word without quotes for the name
    of a variable first."""
    names = _VARIABLE.findall(written.text)
    if argument.open or not all(name in known for name in names):
        return False
    is_text = bool(names) or _PLAIN.fullmatch(written.text) is not None
    return written.quoted or (is_text and argument.text not in variables)


def _opposite(holds: bool | None) -> bool | None:
    return None if holds is None else not holds


def _both(left: bool | None, right: bool | None) -> bool | None:
    if left is False or right is False:
        return False
    return None if left is None or right is None else True


def _either(left: bool | None, right: bool | None) -> bool | None:
    return _opposite(_both(_opposite(left), _opposite(right)))


__all__ = ["Branches"]
