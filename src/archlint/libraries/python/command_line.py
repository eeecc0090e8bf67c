"""The command line of a program: ``sys.argv``, what argparse makes of it, and what rclpy takes out of it.

Its words are known where a launch file starts the program.  argparse itself divides them up, on plain texts; no
function of the program is passed to it.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.interpreter import containers
from archlint.interpreter.values import (
    NONE,
    External,
    Known,
    ListValue,
    Unknown,
    Value,
    reason,
)

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.libraries.run import Run

WORDS = 400
"""How many words of a command line are divided up."""
ROS_ARGUMENTS, END_OF_ROS_ARGUMENTS = "--ros-args", "--"

_UNKNOWN_WORD = Unknown("a command-line argument that the launch file does not set")


# ------------------------------------------------------------------------------------------------ sys.argv


def program_arguments(run: Run) -> Value:
    """``sys.argv``."""
    run.program.reads_command_line = True
    return External("sys.argv") if run.argv is None else run.argv


def give_words(run: Run, words: Sequence[str | None]) -> None:
    """Start a run with the words after the program's name; None for those that are not known."""
    values = [Unknown("the path of the program"), *(_value_of_word(word) for word in words)]
    run.argv = containers.new_list(run, values)


def _value_of_word(word: str | None) -> Value:
    return _UNKNOWN_WORD if word is None else Known(word)


def remove_ros_args(run: Run, site: CallSite) -> Value:
    """``rclpy.utilities.remove_ros_args(args)``: what is outside of ``--ros-args … --``."""
    given = site.args[0] if site.args else site.keywords.get("args", NONE)
    words = _items(run, program_arguments(run) if given == NONE else given)
    if words is None:
        return Unknown(reason(given))
    return containers.new_list(run, without_ros_arguments(words))


def without_ros_arguments(words: Sequence[Value]) -> list[Value]:
    remaining, inside = [], False
    for word in words:
        text = word.text
        if text == ROS_ARGUMENTS or (inside and text == END_OF_ROS_ARGUMENTS):
            inside = text == ROS_ARGUMENTS
        elif not inside:
            remaining.append(word)
    return remaining


def _items(run: Run, value: Value) -> list[Value] | None:
    """The items of a list of which all are there; None for anything else."""
    items = value.items(run) if isinstance(value, ListValue) else None
    return None if items is None or items.open or len(items.values) > WORDS else list(items.values)


def known_words(run: Run, given: Value) -> list[Value] | None:
    """What a parser is given to divide up: without an argument all after the program's name."""
    run.program.parses_command_line = True
    if given != NONE:
        return _items(run, given)
    words = None if run.argv is None else _items(run, run.argv)
    return None if words is None else words[1:]


PLAIN = {"rclpy.utilities.remove_ros_args": remove_ros_args}
