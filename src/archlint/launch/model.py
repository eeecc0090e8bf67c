"""What running a launch file yields: the processes it starts, and everything that rules ask about it."""

from __future__ import annotations

from dataclasses import field

from archlint.branches import Branch, BranchArm, BranchArms
from archlint.finding import Place
from archlint.launch.kinds import FileStatus, GapKind
from archlint.launch.mistakes import (
    AbsentKey,
    IdleGroup,
    JoinedFolder,
    LeakedArgument,
    MissingArguments,
    NoAction,
    NotAChoice,
    NotACondition,
    NotAPath,
    RefusedExpression,
    RefusedValue,
    UndeclaredUse,
    UnknownAttribute,
    WithoutContext,
)
from archlint.launch.named_files import FileReference
from archlint.launch.started import Started
from archlint.model import Text
from archlint.records import dataclass


@dataclass(frozen=True)
class Included:
    """An include.  ``visible`` are the texts that the included file can read, of launch configurations, and the
    parameter files that are set for all nodes in it; None where not all of them are known."""

    reference: FileReference
    arguments: tuple[tuple[str, Place], ...]
    place: Place
    file: str
    dormant: bool = False
    visible: tuple[str, ...] | None = None
    own_process: bool = False
    """Whether a process of its own launches the file: ``ros2 launch``."""
    source_class: str = ""
    """The class that reads the file, ``PythonLaunchDescriptionSource`` …; empty where an include finds out itself."""
    called_at: Place | None = None
    """Where the function is called that makes the include of what it is given."""

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
    set_by_includes: set[tuple[str, str]] = field(default_factory=set)
    """Files, each with a launch configuration that it reads after an include and that has no other value there."""
    reach_later: set[Place] = field(default_factory=set)
    """The arguments of includes that a later include takes, or may take because its file is not here."""
    leaked: list[LeakedArgument] = field(default_factory=list)
    """What includes change for the actions behind them."""
    references: list[FileReference] = field(default_factory=list)
    unknown_attributes: list[UnknownAttribute] = field(default_factory=list)
    mistakes: list[NotACondition] = field(default_factory=list)
    refused: list[RefusedValue] = field(default_factory=list)
    no_actions: list[NoAction] = field(default_factory=list)
    incomplete: list[MissingArguments] = field(default_factory=list)
    idle_groups: list[IdleGroup] = field(default_factory=list)
    no_choices: list[NotAChoice] = field(default_factory=list)
    expressions: list[RefusedExpression] = field(default_factory=list)
    without_context: list[WithoutContext] = field(default_factory=list)
    absent_keys: list[AbsentKey] = field(default_factory=list)
    joined: list[NotAPath] = field(default_factory=list)
    joined_folders: list[JoinedFolder] = field(default_factory=list)
    undefined: dict[Place, str] = field(default_factory=dict)
    """Names that a launch file reads and nothing defines, each where it stops the launch."""
    gaps: list[Gap] = field(default_factory=list)
    node_actions: set[Place] = field(default_factory=set)
    """Where the run came past a node action, whether it is then started or not."""
    written: dict[tuple[str, str], Place] = field(default_factory=dict)
    """Where the run came past the declaration of an argument, by file and name, whether it is then used or not."""
    labels: dict[BranchArm, str] = field(default_factory=dict)
    """What a branch means to a user: ``use_sim:=true``."""
    why_open: dict[Branch, str] = field(default_factory=dict)
    """Why nothing decides a branch."""
    undecided: dict[str, list[str]] = field(default_factory=dict)
    """Arguments that conditions ask for and that nothing decides, with the values that make a difference."""
    ros1: bool = False
    is_launch_file: bool = True
    stands_alone: bool = True
    """Whether the modules that it imported are as any other launch would have them: not so where a function ran longer
    than can be followed, or where the command line was asked for."""

    @property
    def sources(self) -> list[str]:
        """The launch files that were run: this one, then what it includes and was found, each once."""
        included = (include.reference.source for include in self.included)
        return [file for file in dict.fromkeys((self.file, *included)) if file is not None]

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
