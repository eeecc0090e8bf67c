"""What running a launch file yields: the processes it starts, and everything that rules ask about it."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import ClassVar

from archlint.branches import BranchArms
from archlint.finding import Place
from archlint.launch.kinds import FileKind, FileStatus, GapKind, StartedKind
from archlint.model import Text
from archlint.syntax.parameter_files import NotKnown, ParameterData


@dataclass(frozen=True)
class Remap:
    """``source:=target`` of one node, or of a group (``SetRemap``)."""

    source: Text
    target: Text
    place: Place
    group: bool = False


PARAMS_FILE = "--params-file"


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
        return not self.shared

    @property
    def option(self) -> str:
        """How it gets to the command line of the process."""
        return "-p" if self.shared else PARAMS_FILE


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
    """Where its name is written: another place than ``place`` where an argument or a variable hands it over."""
    optional: bool = False
    """Whether the launch file asks first if it is there."""


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
class MadeFile:
    """A file that a launch makes of another one: ``source`` is the path of that."""

    source: str
    changes: tuple[Rewriting | Replacing, ...]


@dataclass(frozen=True)
class ParameterFileUse:
    reference: FileReference
    place: Place
    substitutions: bool = False
    shared: bool = False
    configurations: tuple[tuple[str, str], ...] = ()
    """The launch configurations that are known where the file is read, for the ``$(var …)`` in it."""
    changes: tuple[Rewriting | Replacing, ...] = ()
    """What the launch changes in the file before a node reads it: it reads another, made of this one."""
    is_open: ClassVar[bool] = False
    in_dict: ClassVar[bool] = False
    option: ClassVar[str] = PARAMS_FILE

    @property
    def followed(self) -> bool:
        return self.reference.source is not None

    @property
    def sets_anything(self) -> bool:
        return not self.followed


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


@dataclass(eq=False)
class Started:
    """A process (or a component of one) that a launch file starts.

    ``name`` and ``namespace`` are what the
    launch file gives; None leaves the code's own.  A ``dormant`` one is started under other arguments only.
    ``arguments`` is its command line, None for a word that is not known; of one that is not ``whole_arguments`` not
    even the number of words is.  A ``bare`` one is started by that command line alone.
    """

    kind: StartedKind
    package: Text
    executable: Text
    place: Place
    file: str
    name: Text | None = None
    namespace: Text | None = None
    remaps: list[Remap] = field(default_factory=list)
    parameters: Parameters = field(default_factory=list)
    arguments: list[str | None] = field(default_factory=list)
    ros_arguments: list[str | None] = field(default_factory=list)
    whole_arguments: bool = True
    bare: bool = False
    branch_arms: BranchArms = frozenset()
    dormant: bool = False
    lifecycle: bool = False
    places: dict[str, Place] = field(default_factory=dict)
    container: Text | None = None
    includes: tuple[Place, ...] = ()
    """The includes that lead to the file it is in, outermost first."""
    visited: tuple[tuple[int, int], ...] = ()
    """The actions that lead to it, itself included, each with the number of its visit."""


def once_more(one: Started, other: Started) -> bool:
    """Whether two processes come from one action that was met twice, as in both arms of an ``if`` that nothing
    decides.  Launch refuses to execute such an action a second time: one of them is started.

    Source: launch 3.x, ``ExecuteLocal.execute`` raises RuntimeError ("executed more than once").
    """
    visits = dict(one.visited)
    return any(visits.get(action, visit) != visit for action, visit in other.visited)


def merge(one: Started, other: Started) -> bool:
    """Make one process of what is met twice and started alike, under what both visits have in common; False where
    it is not alike, or where no visit covers the other and they do not exclude each other."""
    if (
        not one.branch_arms <= other.branch_arms
        and not other.branch_arms <= one.branch_arms
        and not _opposite(one.branch_arms, other.branch_arms)
    ):
        return False
    if any(getattr(one, name) != getattr(other, name) for name in _ALIKE):
        return False
    one.branch_arms &= other.branch_arms
    one.dormant = one.dormant and other.dormant
    return True


_ALIKE = (
    "kind",
    "package",
    "executable",
    "name",
    "namespace",
    "remaps",
    "parameters",
    "arguments",
    "ros_arguments",
    "container",
    "includes",
)


def _opposite(one: BranchArms, other: BranchArms) -> bool:
    """Whether two sets of branches are the two sides of one condition, and otherwise the same."""
    return [branch for branch, _ in one - other] == [branch for branch, _ in other - one] != []


@dataclass(frozen=True)
class Included:
    """An include.  ``handed`` are the texts that the included file can read, of launch configurations, and the
    parameter files that are set for all nodes in it; None where not all of them are known."""

    reference: FileReference
    arguments: tuple[tuple[str, Place], ...]
    place: Place
    file: str
    dormant: bool = False
    handed: tuple[str, ...] | None = None
    own_process: bool = False
    """Whether a process of its own launches the file: ``ros2 launch``."""

    @property
    def is_missing(self) -> bool:
        """Whether this launch would read the file, and it is not there."""
        return self.reference.status == FileStatus.MISSING and not self.dormant and not self.own_process


@dataclass(frozen=True)
class DeclaredArgument:
    name: str
    default: Text | None
    place: Place
    file: str
    choices: tuple[str, ...] = ()
    dormant: bool = False


@dataclass(frozen=True)
class UndeclaredUse:
    """A launch configuration that is read and that nothing has declared or set.

    ``own_default`` is the declaration whose default value reads the argument that it declares; ``unseen`` is an include
    in front of the read whose file is not there: nobody can say what that one would have declared.
    """

    name: str
    place: Place
    file: str
    conditional: bool = False
    own_default: Place | None = None
    unseen: Place | None = None


@dataclass(frozen=True)
class UnknownAttribute:
    """A keyword or attribute that an action does not have; ``known`` are those that it does."""

    action: str
    name: str
    known: tuple[str, ...]
    place: Place
    of_element: bool = False
    """Whether the action is an element of XML or YAML."""


@dataclass(frozen=True)
class NotACondition:
    """What an action is given as its ``condition=`` that launch cannot ask: ``what`` names it."""

    action: str
    what: str
    callable: bool
    place: Place


@dataclass(frozen=True)
class WithoutContext:
    """A ``perform()`` that fails: a ``substitution`` is ``given`` what is no launch context, or (empty) a new one, in
    which no launch argument has a value."""

    substitution: str
    given: str
    place: Place


def why_unknown(reference: FileReference) -> str:
    return reference.reason or f"it is not known which file '{reference.written}' is"


def _why_not_followed(include: Included) -> str | None:
    """Of a file that is unknown there is a gap already."""
    reference = include.reference
    if reference.source is not None or reference.status == FileStatus.UNKNOWN:
        return None
    if reference.status == FileStatus.MISSING:
        return f"'{reference.written}' is not there"
    return f"the package '{reference.package}' is not in this workspace" if reference.package else reference.reason


@dataclass(frozen=True)
class Gap:
    """What could not be followed.  A ``dormant`` one is met under other arguments only."""

    reason: str
    place: Place
    kind: GapKind = GapKind.LAUNCH
    dormant: bool = False


@dataclass(eq=False)
class Launched:
    """One launch file with its includes, run under given arguments."""

    file: str
    package: str | None
    arguments: dict[str, str] = field(default_factory=dict)
    started: list[Started] = field(default_factory=list)
    included: list[Included] = field(default_factory=list)
    declared: list[DeclaredArgument] = field(default_factory=list)
    undeclared: list[UndeclaredUse] = field(default_factory=list)
    read: set[str] = field(default_factory=set)
    """The launch configurations that are read anywhere, ``reads_any`` where a name of one is not known."""
    reads_any: bool = False
    read_on: dict[Place, Place] = field(default_factory=dict)
    """The arguments of includes that the including file reads further down, where includes have set them: the first
    such place by that of the argument."""
    references: list[FileReference] = field(default_factory=list)
    unknown_attributes: list[UnknownAttribute] = field(default_factory=list)
    mistakes: list[NotACondition] = field(default_factory=list)
    without_context: list[WithoutContext] = field(default_factory=list)
    undefined: dict[Place, str] = field(default_factory=dict)
    """Names that a launch file reads and nothing defines, each where it stops the launch."""
    gaps: list[Gap] = field(default_factory=list)
    made: set[Place] = field(default_factory=set)
    """Where the run came past a node action, whether it is then started or not."""
    written: dict[tuple[str, str], Place] = field(default_factory=dict)
    """Where the run came past the declaration of an argument, by file and name, whether it is then used or not."""
    labels: dict[tuple[str, int], str] = field(default_factory=dict)
    """What a branch means to a user: ``use_sim:=true``."""
    why_open: dict[str, str] = field(default_factory=dict)
    """Why nothing decides a branch."""
    undecided: dict[str, list[str]] = field(default_factory=dict)
    """Arguments that conditions ask for and that nothing decides, with the values that make a difference."""
    ros1: bool = False
    is_launch_file: bool = True

    def not_followed(self) -> list[Gap]:
        """What is met on the way through the branches that are taken, and starts what is not seen."""
        includes = [
            Gap(why, i.place, GapKind.INCLUDE, i.dormant) for i in self.included if (why := _why_not_followed(i))
        ]
        return [gap for gap in [*self.gaps, *includes] if not gap.dormant]

    def condition(self, arms: BranchArms) -> str | None:
        """Under which arguments branches are taken, for people; None for no branch at all."""
        known = sorted(self.labels[arm] for arm in arms if arm in self.labels)
        if known or not arms:
            return " ".join(known) or None
        return " ".join(["a condition", *(f"({why})" for why in self.reasons(arms)[:1])])

    def reasons(self, arms: BranchArms) -> list[str]:
        """Why nothing decides some branches, as far as that is known."""
        return sorted({self.why_open[branch] for branch, _ in arms if branch in self.why_open})
