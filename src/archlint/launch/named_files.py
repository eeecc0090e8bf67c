"""The files that a launch names, and those that it makes of others."""

from __future__ import annotations

from dataclasses import field

from archlint.finding import Place
from archlint.launch.kinds import FileKind, FileStatus
from archlint.records import dataclass
from archlint.syntax.parameter_files import NotKnown


@dataclass(frozen=True)
class FileReference:
    """A file that a launch file names: ``written`` after substitution, ``source`` where it is in this workspace."""

    kind: FileKind
    written: str | None
    source: str | None
    status: FileStatus
    package: str | None
    place: Place
    reason: str | None = None
    conditional: bool = False
    given: Place | None = None
    """Where its name is written: another place than ``place`` where an argument or a variable passes it."""
    optional: bool = False
    """Whether the launch file asks first if it is there."""
    dormant: bool = False
    """Whether the file is asked for under other arguments than those of the launch alone."""
    name: str | None = field(default=None, compare=False)
    """The parameter or the argument that is set to it, if it is known."""


@dataclass(frozen=True)
class Rewriting:
    """What nav2's ``RewrittenYaml`` changes in a parameter file, in its order.

    ``parameters`` are set wherever their name stands as a key, or at a path such as ``amcl.ros__parameters.alpha1``;
    ``keys`` get other names, ``values`` become others, and ``root_key`` is put above everything.
    """

    parameters: tuple[tuple[str, str | NotKnown], ...] = ()
    keys: tuple[tuple[str, str], ...] = ()
    values: tuple[tuple[str, str | NotKnown], ...] = ()
    root_key: str = ""
    convert_types: bool = False


@dataclass(frozen=True)
class Replacing:
    """The words that nav2's ``ReplaceString`` puts in for others."""

    words: tuple[tuple[str, str], ...]


@dataclass(frozen=True)
class Written:
    """The text that the code of a launch file writes into a file of its own."""

    text: str


@dataclass(frozen=True)
class MadeFile:
    """A file that a launch makes of another one: ``source`` is the path of that."""

    source: str
    changes: tuple[Rewriting | Replacing | Written, ...]


_MADE = "$(file-made-by-launch"


def path_made_by_launch(*words: object) -> str:
    """What stands for the path of a file that exists only while a launch runs; ``words`` tell it from others."""
    return f"{' '.join((_MADE, *map(str, words)))})"


def is_made_by_launch(path: str) -> bool:
    """Whether :func:`path_made_by_launch` gave the path."""
    return path.startswith(_MADE)


def why_unknown(reference: FileReference) -> str:
    return reference.reason or f"it is not known which file '{reference.written}' is"
