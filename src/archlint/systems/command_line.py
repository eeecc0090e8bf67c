"""The command line that a launch file gives to a process, in launch_ros' order."""

from __future__ import annotations

from archlint.launch.started import Started
from archlint.model import Text

Word = str | None
"""None stands for a word that is not known."""


def words_of(started: Started) -> tuple[Word, ...] | None:
    """The words after the executable's name; None where not even their number is known."""
    if not started.knows_all_arguments:
        return None
    if started.bare:
        return tuple(started.arguments)
    if any(parameter.is_open for parameter in started.parameters):
        return None
    words: list[Word] = [*started.arguments, "--ros-args", *started.ros_arguments]
    for rule, text in (("__node", started.name), ("__ns", started.namespace)):
        if text is not None:
            words += ["-r", _rule(Text(rule, "exact"), text)]
    words += _parameters(started)
    for remap in started.remaps:
        words += ["-r", _rule(remap.source, remap.target)]
    return tuple(words)


def _rule(source: Text, target: Text) -> Word:
    known = (
        source.text is not None and target.text is not None and "partial" not in (source.resolution, target.resolution)
    )
    return f"{source.text}:={target.text}" if known else None


def _parameters(started: Started) -> list[Word]:
    """Shared settings one by one, files by their paths; what a dict holds goes through a file that launch writes."""
    words: list[Word] = []
    in_dict = False
    for parameter in started.parameters:
        if not (parameter.in_dict and in_dict):
            words += [parameter.option, None]
        in_dict = parameter.in_dict
    return words
