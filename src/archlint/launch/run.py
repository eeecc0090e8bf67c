"""The state of the run of one launch file: a run with a launch context, and what it has found so far.

What a kind of action, substitution or condition does is in rooms of their own, which know the run; it knows none of
them (:mod:`archlint.launch.launcher` puts them together).
"""

from __future__ import annotations

import posixpath
from abc import abstractmethod
from collections.abc import Callable, Hashable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from typing import TYPE_CHECKING, TypeVar

from archlint import model
from archlint.branches import Branch, BranchArm, BranchArms, UnfollowedCondition
from archlint.finding import Place
from archlint.interpreter import containers, values
from archlint.interpreter.limits import FEW_STEPS, PROGRAM_STEPS
from archlint.interpreter.roots import enter_root
from archlint.interpreter.values import DictValue, Instance, Known, OneOf, Value
from archlint.launch.argument_names import AGAIN, ArgumentNames
from archlint.launch.context import Context
from archlint.launch.domains import Domains
from archlint.launch.given_arguments import GivenArguments
from archlint.launch.kinds import FileKind, FileStatus, GapKind
from archlint.launch.mistakes import (
    AbsentKey,
    IdleGroup,
    JoinedFolder,
    MissingArguments,
    NotAChoice,
    NotACondition,
    NotAPath,
    RefusedValue,
    UndeclaredUse,
    UnknownAttribute,
    WithoutContext,
)
from archlint.launch.model import Gap, Launched
from archlint.launch.named_files import FileReference, MadeFile
from archlint.launch.objects import known_text
from archlint.launch.started import Started, StartedProcesses
from archlint.libraries.run import Run
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.faults import Faults
    from archlint.interpreter.heap import Store
    from archlint.interpreter.library import Library
    from archlint.interpreter.modules import Module, ModuleIndex
    from archlint.launch.files import LaunchFiles
    from archlint.launch.paths import LaunchPaths
    from archlint.launch.verdict import Verdict


_Noted = TypeVar("_Noted")

LAUNCH_STEPS = 400_000
"""How many statements all functions of one launch may run: each OpaqueFunction is a run of its own."""

LAUNCH_RUNS = 4_000
"""How often one function of them may run a function: a helper converts each parameter of a driver, which has hundreds,
and each of its cameras has them all."""

LAUNCH_NESTED_CALLS = 20
"""How many calls of one function run at a time: a helper goes through what a file holds, which is nested."""


@dataclass(frozen=True)
class Surroundings:
    """What all launches of a workspace have in common."""

    index: ModuleIndex
    store: Store
    files: LaunchFiles
    paths: LaunchPaths
    faults: Faults
    distro: str | None


class LaunchRun(Run):
    """``launch`` is the launch context; ``file`` the launch file whose actions are visited now."""

    allowed_runs = LAUNCH_RUNS
    allowed_nesting = LAUNCH_NESTED_CALLS

    def __init__(
        self, library: Callable[[Run], Library], surroundings: Surroundings, file: str, result: Launched
    ) -> None:
        place = Place(file, 1, 1, 1, 1)
        super().__init__(
            library,
            surroundings.index,
            surroundings.store,
            model.Program(file, None, file),
            model.Callback(model.Role.LAUNCH, file, place, None, file=file),
        )
        self.files = surroundings.files
        self.paths = surroundings.paths
        self.distro = surroundings.distro
        self.faults = surroundings.faults
        self.launch = Context()
        self.file = file
        self.result = result
        self.place_now = place
        self.visits = self.nesting = 0
        self.current_arms: BranchArms = frozenset()
        self.code_arms: BranchArms = frozenset()
        """Branches of the code that have already been taken note of."""
        self.dormant = self.undecided = 0
        self.stack: list[str] = []
        self.includes: list[Place] = []
        """Where the files of the stack are included; nothing for the first."""
        self.included = 0
        """How many includes it has come to."""
        self.visiting: list[tuple[int, int]] = []
        """The actions around what is visited now, outermost first, each with the number of its visit."""
        self.given = GivenArguments(result)
        self.names = ArgumentNames()
        self.domains, self.gone, self.read_dicts = Domains(), dict[str, Value](), dict[Hashable, str]()
        self.declaring: str | None = None
        """The argument whose default value is performed now."""
        self._values: dict[str, list[str]] = {}
        self._seen: set[object] = set()
        self._processes = StartedProcesses(result.started)
        self.in_handler, self.ended = False, frozenset[int]()
        """Whether an event handler is around what is visited now, and which actions' processes have ended by then."""
        self.later, self.set_later = 0, dict[str, Value]()
        """How many timers and event handlers are around what is visited now, and what configurations such have set."""
        self.around_groups: Context | None = None
        """The context around the outermost group that is visited now."""
        self.without_namespace = False
        """Whether what is visited now starts when the groups around it, and the namespace that they push, have gone."""
        self.asked_files: set[str] = set()
        """The paths of which the code asks whether a file exists."""
        self.made_files, self.written_files = dict[str, MadeFile](), dict[str, Instance]()
        """The files that the launch makes of others, each under a path of its own, and those that its code writes."""
        self.performing = 0
        """How deep the text is nested that is performed now, and ``performed`` of how many parts it has been."""
        self.performed = 0
        self.left = LAUNCH_STEPS

    # ------------------------------------------------------------------------------ what the rooms implement

    @abstractmethod
    def perform(self, value: Value | None) -> Value:
        """The text of what launch takes for one: a text, a substitution, a path, or a list of these."""

    @abstractmethod
    def judge(self, condition: Value | None) -> Verdict:
        """The verdict on a ``condition=`` argument."""

    @abstractmethod
    def visit(self, entity: Value) -> None:
        """Run an action, or a list of them."""

    @abstractmethod
    def include(self, reference: FileReference, plain: bool = False, called_at: Place | None = None) -> None:
        """Run an included file in the same context: includes are not scoped.  A ``plain`` include gives no arguments,
        on which the included file might stop; one that a helper makes is ``called_at`` a place."""

    # -------------------------------------------------------------------------------------------- where

    @property
    def file_path(self) -> str:
        """The path of the current launch file, as its own code sees it."""
        return f"$(workspace)/{self.file}"

    def path_of(self, module: Module) -> Value:
        """A launch file runs from where it is installed; a Python module elsewhere, which is not known."""
        if module.file.kind == "launch_python" or module.path in self.stack:
            return Known(f"$(workspace)/{module.path}")
        return super().path_of(module)

    @property
    def is_dormant(self) -> bool:
        return self.dormant > 0

    @property
    def is_conditional(self) -> bool:
        return self.dormant > 0 or self.undecided > 0 or bool(self.branch_arms)

    def gap(self, reason: str, kind: GapKind = GapKind.LAUNCH, place: Place | None = None) -> None:
        self._note(Gap(reason, place or self.place_now, kind, self.is_dormant), self.result.gaps)

    def _note(self, item: _Noted, items: list[_Noted]) -> None:
        """Add what has not been noted before."""
        if item not in self._seen:
            self._seen.add(item)
            items.append(item)

    def note_fault(self, what: str, error: Exception, place: Place) -> None:
        super().note_fault(what, error, place)
        self.gap("archlint failed here", place=place)

    def start(self, started: Started) -> None:
        """Note a process."""
        self._processes.start(started, self.in_handler, tuple(self.includes), tuple(self.visiting))

    @property
    def words(self) -> Sequence[Value]:
        """The command line, as far as it is known."""
        self.result.stands_alone = False
        return [] if self.argv is None else self.items(self.argv)

    def note_undeclared(self, name: str, place: Place, conditional: bool) -> None:
        own = self.place_now if self.declaring == name else None
        unseen = next((include.place for include in self.result.included if include.is_missing), None)
        self._note(
            UndeclaredUse(name, place, self.place_now, self.file, conditional, own, unseen, self.later > 0),
            self.result.undeclared,
        )

    def note_read(self, name: str) -> None:
        """A launch configuration is read, perhaps one that an include in front has set."""
        self.result.read.add(name)
        value = self.launch.configurations.get(name)
        self.given.note_read(name, value, self.file, self.place_now, late=self.later > 0, dormant=self.is_dormant)
        if name in self.gone and value is self.gone[name]:
            self._note_gone(name)

    def _note_gone(self, name: str) -> None:
        """A timer or an event reads what only the group around it sets, which has ended by then: launch stops there.
        What comes after it is never seen to run along with anything."""
        branch = UnfollowedCondition(f"{name} at visit {self.visits}")
        self.result.why_open.setdefault(branch, f"the group that sets '{name}' has ended by then")
        self.current_arms |= {(branch, 0)}

    def note_unknown_attribute(self, wrong: UnknownAttribute) -> None:
        self._note(wrong, self.result.unknown_attributes)

    def note_mistake(self, mistake: NotACondition) -> None:
        self._note(mistake, self.result.mistakes)

    def note_refused_value(self, mistake: RefusedValue) -> None:
        self._note(mistake, self.result.refused)

    def note_incomplete(self, mistake: MissingArguments) -> None:
        self._note(mistake, self.result.incomplete)

    def note_idle_group(self, mistake: IdleGroup) -> None:
        self._note(mistake, self.result.idle_groups)

    def note_no_choice(self, mistake: NotAChoice) -> None:
        self._note(mistake, self.result.no_choices)

    def note_without_context(self, mistake: WithoutContext) -> None:
        self._note(mistake, self.result.without_context)

    def note_absent_key(self, mistake: AbsentKey) -> None:
        self._note(mistake, self.result.absent_keys)

    def note_joined(self, mistake: NotAPath) -> None:
        self._note(mistake, self.result.joined)

    def note_joined_folder(self, mistake: JoinedFolder) -> None:
        self._note(mistake, self.result.joined_folders)

    def reference(self, kind: FileKind, path: Value, place: Place, name: str | None = None) -> FileReference:
        """Note which file a path means; ``name`` is what passes it to a node: a parameter, or an argument."""
        reference = replace(self.resolve(kind, path, place), name=name, dormant=self.is_dormant)
        self._note(reference, self.result.references)
        return reference

    def resolve(self, kind: FileKind, path: Value, place: Place) -> FileReference:
        """Which file of the workspace a path means."""
        reference = self.paths.resolve(kind, path, place, self.file, self.asked_files, self.is_conditional)
        is_made_here = reference.source is None and reference.written in self.written_files
        return replace(reference, status=FileStatus.UNKNOWN) if is_made_here else reference

    # ------------------------------------------------------------------------------------------- values

    def text_of(self, value: Value | None) -> str | None:
        """The text of what launch takes for one, where it is known."""
        return known_text(self.perform(value))

    def items(self, value: Value | None) -> list[Value]:
        """The known items of a list, dict (as pairs) or ``dict.items()``."""
        match value:
            case None:
                return []
            case DictValue():
                return [containers.new_list(self, pair, "tuple") for pair in self.entries(value)]
            case OneOf(values=options):
                return [item for option in options for item in self.items(option)]
        items = value.items(self)
        return [] if items is None else list(items.values)

    def entries(self, value: Value | None) -> list[tuple[Value, Value]]:
        """The known entries of a dict."""
        return list(value.entries(self).entries.values()) if isinstance(value, DictValue) else []

    def is_open(self, value: Value) -> bool:
        items = value.items(self)
        return items is None or not items.exhaustive

    def is_closed(self, value: Value) -> bool:
        """Whether all items of a list are there for certain."""
        items = value.items(self)
        return items is not None and not items.open

    # ----------------------------------------------------------------------------------------- branches

    def note_open_test(self, branch: Branch, test: Value) -> None:
        self.result.why_open.setdefault(branch, values.reason(test))

    def note_asked_file(self, path: str) -> None:
        self.asked_files.add(posixpath.normpath(path))

    def label(self, arm: BranchArm, text: str) -> BranchArm:
        self.result.labels.setdefault(arm, text)
        return arm

    def argument_behind(self, name: str) -> str:
        """The name of the launch argument that a configuration's value comes from."""
        return self.names.behind(name, self.launch.configurations.get(name))

    def is_open_argument(self, name: str) -> bool:
        """Whether nothing decides what an argument is."""
        return known_text(self.launch.configurations.get(name)) is None

    @staticmethod
    def shown(name: str) -> str:
        return name.partition(AGAIN)[0]

    def note_undecided(self, name: str, *values: str) -> None:
        """A condition asks for an argument that nothing decides."""
        if AGAIN in name:
            return  # set anew on the way: no argument from outside decides it
        known = self.result.undecided.setdefault(name, [])
        known.extend(value for value in values if value not in known)

    def number_of_value(self, name: str, value: str) -> int:
        """A number for one value of an argument that is compared with several."""
        values = self._values.setdefault(name, [])
        if value not in values:
            values.append(value)
        return values.index(value)

    @contextmanager
    def under(self, own: BranchArms, verdict: Verdict, place: Place) -> Iterator[None]:
        """An action under a condition: one that does not hold leaves no trace in the context, one that is not
        decided leaves both."""
        if verdict.holds is True and not own:
            yield
            return
        arms = own if verdict.branch is None else own | {verdict.branch}
        kept, kept_code = self.current_arms, self.code_arms
        asleep = verdict.holds is False or (verdict.branch is not None and self._excluded(verdict.branch))
        before = self.launch.set_aside() if asleep else self.launch.fork()
        self.current_arms, self.code_arms = kept | arms, kept_code | own
        self.dormant += asleep
        self.undecided += not asleep
        try:
            yield
        finally:
            self.dormant -= asleep
            self.undecided -= not asleep
            self.current_arms, self.code_arms = kept, kept_code
            if asleep:
                self.launch.restore(before)
            else:
                self.launch.join(before, "a branch whose condition is not known")

    @contextmanager
    def perhaps(self) -> Iterator[None]:
        """What is read here is read only where one of several values is the one."""
        self.undecided += 1
        try:
            yield
        finally:
            self.undecided -= 1

    def _excluded(self, branch: BranchArm) -> bool:
        """Whether an outer branch already says the opposite."""
        return any(other == branch[0] and arm != branch[1] for other, arm in self.current_arms)

    # --------------------------------------------------------------------------------------------- code

    @contextmanager
    def root(self, module: Module) -> Iterator[None]:
        """Run code of a module, from a fresh chain of calls."""
        kept, kept_arms = self.activations, self.branch_arms
        self.steps, self.repeats, self.runs = 0, {}, {}
        self.allowed_steps = max(FEW_STEPS, min(PROGRAM_STEPS, self.left))
        self.activations, self.branch_arms = [], sorted(self.code_arms, key=repr)
        enter_root(self, module)
        depth = self.store.depth
        self.store.push()
        try:
            yield
        finally:
            layer = self.store.cut(depth)
            self.store.merge([layer])
            self.activations, self.branch_arms = kept, kept_arms
            self.left -= self.steps
            self.result.stands_alone = self.result.stands_alone and self.steps < self.allowed_steps
