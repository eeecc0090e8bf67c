"""What sets the parameters of a started node: single settings, files, and what could not be followed."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import field
from typing import ClassVar

from archlint.finding import Place
from archlint.launch.named_files import FileReference, Replacing, Rewriting, Written
from archlint.records import dataclass
from archlint.syntax.parameter_files import ParameterData

PARAMS_FILE = "--params-file"
CURRENT_FOLDER = "."
"""What an empty path comes to: launch_ros makes a Path of it, and leaves out what is no file."""


@dataclass(frozen=True)
class ParameterSetting:
    """One parameter that a launch file sets.  ``name`` is None where only data decides it.  ``shared`` settings
    (``SetParameter``) are for all nodes of a group."""

    name: str | None
    value: ParameterData
    place: Place
    shared: bool = False
    within: tuple[tuple[str, Place], ...] = ()
    """The keys of the dicts around it, the outermost first: the name that launch makes of each, and its place."""
    in_file: bool = True
    """Whether launch writes it to a file under the name of the node.  A ``Parameter`` of launch_ros goes to the command
    line, where it is for all nodes of the process, as shared settings are."""
    given: Place | None = field(default=None, compare=False)
    """Where a text is written that an argument or a variable passes here."""
    is_open: ClassVar[bool] = False
    """Whether it stands for parameters of which not even the number is known."""

    @property
    def followed(self) -> bool:
        """Whether it is known what is set, be it to a value that is not."""
        return self.name is not None

    @property
    def sets_anything(self) -> bool:
        """Whether any parameter may be set by it."""
        return not self.followed

    @property
    def in_dict(self) -> bool:
        """Whether launch writes it to a file, together with those beside it."""
        return self.in_file and not self.shared

    @property
    def option(self) -> str:
        """How it gets to the command line of the process."""
        return PARAMS_FILE if self.in_dict else "-p"


@dataclass(frozen=True)
class ParameterFileUse:
    reference: FileReference
    place: Place
    substitutions: bool = False
    shared: bool = False
    configurations: tuple[tuple[str, str], ...] = ()
    """The launch configurations that are known where the file is read, for the ``$(var …)`` in it."""
    changes: tuple[Rewriting | Replacing | Written, ...] = ()
    """What the launch changes in the file before a node reads it: it reads another, made of this one.  What the launch
    has written comes first."""
    is_open: ClassVar[bool] = False
    in_dict: ClassVar[bool] = False
    option: ClassVar[str] = PARAMS_FILE

    @property
    def followed(self) -> bool:
        return self.reference.source is not None or isinstance(next(iter(self.changes), None), Written)

    @property
    def sets_anything(self) -> bool:
        return not self.followed and self.reference.written != CURRENT_FOLDER


Parameters = list["ParameterSetting | ParameterFileUse | OpenParameters"]


def files_among(parameters: Iterable[ParameterSetting | ParameterFileUse | OpenParameters]) -> list[ParameterFileUse]:
    """The parameter files among what sets parameters."""
    return [parameter for parameter in parameters if isinstance(parameter, ParameterFileUse)]


@dataclass(frozen=True)
class OpenParameters:
    """Parameters that could not be followed, and why.  Where they are ``of_several``, all that they may be follow."""

    reason: str
    place: Place
    of_several: bool = False
    is_open: ClassVar[bool] = True
    followed: ClassVar[bool] = False
    in_dict: ClassVar[bool] = False
    option: ClassVar[str] = PARAMS_FILE

    @property
    def sets_anything(self) -> bool:
        return not self.of_several
