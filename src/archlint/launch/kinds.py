"""What kinds of files, processes and gaps there are in a launch."""

from __future__ import annotations

from archlint.string_enum import StringEnum


class FileKind(StringEnum):
    """What a launch file takes a file for."""

    LAUNCH = "launch"
    PARAMETERS = "parameters"
    RVIZ = "rviz"
    READ = "read"
    """What the code of a launch file opens itself, so that the launch ends where it is not there."""
    OTHER = "other"
    """Whatever else is named by a path in the share folder of a package."""
    ARGUMENT = "argument"
    """What a launch argument is set to, a path in the share folder of a package, whatever uses it."""


class FileStatus(StringEnum):
    """Whether a file that a launch file names is where it looks."""

    INSTALLED = "installed"
    NOT_INSTALLED = "not installed"
    """It is there, but no rule installs it."""
    MISSING = "missing"
    EXTERNAL = "external"
    """Of a package that is not here."""
    UNKNOWN = "unknown"


class StartedKind(StringEnum):
    """What a launch file starts."""

    NODE = "node"
    CONTAINER = "container"
    COMPONENT = "component"
    PROCESS = "process"
    """A command that is no node."""


class GapKind(StringEnum):
    """What could not be followed."""

    LAUNCH = "launch"
    """An action, or a file."""
    INCLUDE = "include"
