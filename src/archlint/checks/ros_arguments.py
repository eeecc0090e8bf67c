"""What LCH001 says of programs that end at the ``--ros-args`` of a launch file, or at what stands behind it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.checks.registry import finding
from archlint.finding import Finding, Related
from archlint.launch_files.ros_arguments import refused_words
from archlint.launch_files.words_for_ros import wrong_words

if TYPE_CHECKING:
    from archlint.systems.model import System


def refused_ros_arguments(system: System) -> Iterator[Finding]:
    """A finding for each place where a program of this workspace ends so."""
    for refused in refused_words(system):
        started = refused.started
        program, package = started.executable.text or "", started.package.text or ""
        why = "this counts" if refused.counts else "argparse does not know"
        yield finding(
            "LCH001",
            refused.place,
            f"'{program}' of package '{package}' ends here when a launch file starts it: {why} the --ros-args that "
            "launch adds",
            help="len(remove_ros_args(sys.argv)), with remove_ros_args of rclpy.utilities"
            if refused.counts
            else "parser.parse_args(remove_ros_args(sys.argv)[1:]), with remove_ros_args of rclpy.utilities, or "
            "parser.parse_known_args()",
            related=[Related(started.place, "a launch file starts it here")],
            identity=(package, program, "arguments"),
            group=(package, program, "arguments"),
        )


def refused_words_for_ros(system: System) -> Iterator[Finding]:
    """A finding for each word behind ``--ros-args`` at which a node ends, or that ROS does not see."""
    for row in wrong_words(system):
        what = (
            f"'{row.word}' is one word, and not the --ros-args that '{row.program}' is to be given: it has no effect"
            if row.ignored
            else f"'{row.word}' behind --ros-args is no argument of ROS: '{row.program}' ends with an "
            "UnknownROSArgsError"
        )
        yield finding(
            "LCH001",
            row.place,
            what,
            help=f"write {row.instead}" if row.instead else "write it in front of '--ros-args', or behind '--'",
            identity=(row.program, row.word),
            group=(row.place.file, row.word, "word"),
        )


__all__ = ["refused_ros_arguments", "refused_words_for_ros"]
