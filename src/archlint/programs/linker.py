"""Link: run every program of a workspace symbolically.

First what is started: console scripts and files with a main guard.  Then the node classes that nothing starts,
then classes and functions that work on a node which nobody here passes; so each create call is seen, with
the arguments of its callers where there are any.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING

from archlint import model
from archlint.faults import Faults
from archlint.finding import Place
from archlint.interpreter.activation import Activation
from archlint.interpreter.attributes import get_attribute
from archlint.interpreter.heap import Store
from archlint.interpreter.limits import TEST_STEPS
from archlint.interpreter.modules import Module, ModuleIndex
from archlint.interpreter.values import FunctionValue, Value
from archlint.launch.library import LaunchLibrary
from archlint.libraries.python import command_line
from archlint.libraries.rclpy import escapes
from archlint.libraries.run import Run
from archlint.monitor import Monitor
from archlint.programs.ahead import SHARES, WORTH_IT, independent_groups
from archlint.programs.any_time import let_attributes_change
from archlint.programs.budget import Budget, cut_short
from archlint.programs.cpp_programs import use_own_methods
from archlint.programs.earlier_imports import EarlierImports
from archlint.programs.entry import Entry, EntryPoint
from archlint.programs.followed import Followed
from archlint.programs.followed_program import FollowedProgram
from archlint.programs.follower import Follower
from archlint.programs.helpers import changed_by_settling, helpers_in, note_unfollowed, prune_uncalled, settle_helpers
from archlint.programs.kept import KeptPrograms, NothingKept
from archlint.programs.keys import EntryKey, ScriptKey
from archlint.programs.parts import Ahead, Follows, size_of
from archlint.programs.roots import run_callbacks, run_pending
from archlint.programs.sweep import Sweep
from archlint.programs.top_level import called_alone, place_of
from archlint.syntax import facts
from archlint.syntax.walk import calls_on_import, main_guard
from archlint.workspace.test_code import common_folder

if TYPE_CHECKING:
    from archlint.ros.interfaces import InterfaceTable
    from archlint.syntax.workspace_files import WorkspaceFiles
    from archlint.workspace.model import SourceFile


class Linker:
    """Runs programs over one index of modules and one base store."""

    def __init__(
        self,
        files: WorkspaceFiles,
        interfaces: InterfaceTable | None = None,
        faults: Faults | None = None,
        keep: Callable[[ModuleIndex, Callable[[Iterable[str]], None]], KeptPrograms] | None = None,
        jobs: int = 1,
        monitor: Monitor | None = None,
        elsewhere: Callable[[Sequence[Sequence[str]], KeptPrograms], None] | None = None,
    ) -> None:
        self.index = ModuleIndex(files.importable, files.facts_of)
        self.earlier = EarlierImports(
            self.index, lambda module: self.new_run(module.name, module).import_module(module)
        )
        self.kept: KeptPrograms | NothingKept = NothingKept() if keep is None else keep(self.index, self.earlier.now)
        self.earlier.of(self.kept)
        self.files = sorted(files.files, key=lambda file: file.relative)
        self._shown = {file.relative: file for file in self.files}
        self._by_module: dict[str | None, list[SourceFile]] = {}
        for file in self.files:
            self._by_module.setdefault(file.module, []).append(file)
        self.relevant = files.relevant
        self.interfaces = interfaces
        self._elsewhere = elsewhere
        """Follows groups of programs on other machines, each given as the paths of its modules."""
        self.monitor = monitor or Monitor()
        self.store = Store()
        self.faults = faults or Faults()
        self.follower = Follower(self.index, self.kept, self.faults, self.monitor)
        self.progress = self.follower.progress
        follows = Follows(self._run_in_order, self._run_started, self._import, self._program_of, self._settled_ahead)
        self.ahead = Ahead(self.index, self.kept, follows, jobs, self.monitor)
        self.started: dict[tuple[str | None, str], model.Program] = {}
        """The program of each entry point, by package and executable."""
        self._entries: dict[EntryKey, model.Program] = {}
        """The same, by all that each was started with."""
        self.helpers: list[model.Blueprint] = []
        """What works on nodes that are not known, once all programs have run."""
        self._settled = False

    # ----------------------------------------------------------------------------------------- programs

    def run_all(self, entry_points: list[EntryPoint]) -> list[model.Program]:
        entries, modules = self._starts(entry_points)
        self.monitor.following(len(entries) + len(modules))
        if size_of(modules) > WORTH_IT:
            every = {module.file.path: module for module in (*modules, *(module for _, module in entries))}
            self._follow_groups(lambda: independent_groups(every.values(), self.index), entries, modules)
        self._run_in_order(entries, modules)
        self.own(changed_by_settling(self.progress.programs, self.progress.holders, self._names_in_file))
        programs = self.progress.programs
        self._settle(programs)
        self.helpers = helpers_in(programs)
        self._settled = True
        self.progress.budget = Budget()  # for what launch files run again
        return [program for program in programs if _says_something(program)]

    def _settle(self, programs: list[model.Program]) -> None:
        """No other programs have to say anything of these."""
        prune_uncalled(programs)
        settle_helpers(programs, self.progress.holders)
        note_unfollowed(programs, self._names_in_file)

    @contextmanager
    def _settled_ahead(self, entries: Iterable[EntryPoint]) -> Iterator[None]:
        """Inside, it is as if all programs had run, and not only these executables: what runs again has statements of
        its own."""
        self._settle([self._program_of(entry) for entry in entries])
        before, self.progress.budget = self.progress.budget, Budget()
        self._settled = True
        try:
            yield
        finally:
            self._settled, self.progress.budget = False, before

    def follow_part(self, entry_points: list[EntryPoint], paths: Collection[str]) -> bytes:
        """The programs of some modules, by their paths, as they are kept: another process has the rest.  There is
        something that keeps them."""
        assert isinstance(self.kept, KeptPrograms)
        self.kept.is_worker = True
        entries, modules = self._starts(entry_points)
        every = {module.file.path: module for module in (*modules, *(module for _, module in entries))}
        self.ahead.part([every[path] for path in paths if path in every], entries, modules)()
        return self.kept.take_new()

    def _starts(self, entry_points: list[EntryPoint]) -> tuple[list[Entry], list[Module]]:
        """What is started, and the modules that matter."""
        ordered = sorted(entry_points, key=lambda e: (e.package or "", e.executable))
        entries = [(entry, module) for entry in ordered if (module := self.module_of(entry)) is not None]
        modules = [m for m in (self._relevant_module(file) for file in self.files) if m is not None]
        return entries, modules

    def _follow_groups(
        self, groups: Callable[[], list[list[Module]]], entries: Sequence[Entry], modules: Sequence[Module]
    ) -> None:
        """Follow groups of programs ahead, on other machines or in processes."""
        if self._elsewhere is None:
            self.ahead.follow_all(groups, entries, modules)
        elif isinstance(self.kept, KeptPrograms) and not self.kept.is_mostly_known():
            self._elsewhere([[module.file.path for module in group] for group in groups()], self.kept)

    def _run_in_order(self, entries: Sequence[Entry], modules: Sequence[Module]) -> None:
        started: dict[str, set[str]] = {}
        for entry, module in entries:
            started.setdefault(module.file.path, set()).add(entry.function or "")
            self._run_started(entry, module)
        for test in (False, True):
            chosen = [m for m in modules if self.index.roles.is_test(m.path) is test]
            for module in chosen:
                if self._is_started(module, started):
                    continue
                if main_guard(module.facts) or not self._is_imported(module):
                    self.run_script(module)
            sweep = Sweep(self.progress, self.follower.follow, self.new_run, self._value, self.monitor)
            sweep.is_known = self.kept.knows
            if size_of(chosen) > WORTH_IT:
                sweep.ahead = lambda parts: self.ahead.follow(lambda: parts(SHARES * self.ahead.jobs))
            sweep.run(chosen)

    def _run_started(self, entry: EntryPoint, module: Module) -> model.Program:
        program = self.started[entry.package, entry.executable] = self.run_entry(entry, module)
        return program

    def _program_of(self, entry: EntryPoint) -> model.Program:
        return self.started[entry.package, entry.executable]

    def own(self, programs: Sequence[model.Program]) -> list[model.Program]:
        """Programs that may be changed: copies of those that other runs have, too."""
        copies = self.follower.own(programs)
        if copies:
            self.started = {entry: copies.get(id(program), program) for entry, program in self.started.items()}
            self._entries = {key: copies.get(id(program), program) for key, program in self._entries.items()}
        return [copies.get(id(program), program) for program in programs]

    def _import(self, module: Module) -> None:
        self.kept.import_for(module.path)
        self.new_run(module.name, module).import_module(module)

    def _is_imported(self, module: Module) -> bool:
        return module.file.path in self.index.imported

    def _value(self, module: Module, name: str) -> Value | None:
        """What a variable of a module holds after its import."""
        self.index.note_use(module)
        self.earlier.before(module)
        return None if module.scope is None else self.store.get(module.scope.key, name)

    def _is_started(self, module: Module, started: dict[str, set[str]]) -> bool:
        """Whether a console script runs this file just as its main guard would."""
        functions = started.get(module.file.path)
        guard = main_guard(module.facts)
        if functions is None:
            return False
        if guard is None or "" in functions:
            return True
        called = called_alone(guard.body)
        return called is not None and functions.issuperset(called)

    def _relevant_module(self, file: SourceFile) -> Module | None:
        if file.kind not in ("python", "launch_python", "cpp") or not self.relevant(file):
            return None
        return self.index.module(file)

    def module_of(self, entry: EntryPoint, near: str = "") -> Module | None:
        """The module that an entry point starts; of packages that share a name, that of the one nearest to the
        shown path ``near``."""
        if entry.file is not None:
            return self.index.module(entry.file)
        named = self._by_module.get(entry.module, ())
        candidates = [file for file in named if file.package == entry.package and file.kind != "setup_py"]
        candidates = candidates or self._files_at(entry)
        if not candidates:
            return None
        return self.index.module(max(candidates, key=lambda file: len(common_folder([file.relative, near]))))

    def _files_at(self, entry: EntryPoint) -> list[SourceFile]:
        """The one file of the package whose path ends like the module's name: a build may move folders."""
        tail = "/" + entry.module.replace(".", "/") + ".py"
        files = (file for file in self.files if file.package == entry.package and file.kind != "setup_py")
        matching = [file for file in files if f"/{file.relative}".endswith(tail)]
        return matching if len(matching) == 1 else []

    def new_run(
        self, name: str, module: Module, role: model.Role = model.Role.MAIN, overrides: model.Overrides | None = None
    ) -> Run:
        place = Place(module.path, 1, 1, 1, 1)
        program = model.Program(name, module.file.package, module.path)
        context = model.Callback(role, name, place, None, file=module.path)
        run = Run(LaunchLibrary, self.index, self.store, program, context, self.interfaces, overrides)
        run.at_spin = run_pending
        run.after_moment = let_attributes_change
        run.first_module = module
        run.faults = self.faults
        self.progress.budget.grant(run, TEST_STEPS if self.index.roles.is_test(module.path) else run.left)
        return run

    def cut_short(self) -> list[str]:
        """The files of the programs that were followed only in part, for the sake of all the others."""
        return cut_short(self.progress.programs)

    def run_entry(
        self,
        entry: EntryPoint,
        module: Module,
        overrides: model.Overrides | None = None,
        words: Sequence[str | None] | None = None,
    ) -> model.Program:
        """Run one executable; also used to run it again with parameter overrides, and with the words of a command
        line (None for one that is not known)."""

        def act() -> Followed:
            return self._run_entry(entry, module, overrides, words)

        changes = None if overrides is None else overrides.key
        given = None if words is None else tuple(words)
        others = tuple(file.relative for file in entry.others)
        key = EntryKey(module.path, entry.package, entry.executable, entry.function, changes, given, others)
        if self._settled:
            self.monitor.following(1)
        program, is_settled = self.follower.follow_entry(
            key, overrides or model.Overrides(), act, self._entries.__getitem__
        )
        if self._settled and not is_settled:
            if changed_by_settling([program], {}, self._names_in_file, self.helpers):
                [program] = self.own([program])
            settle_helpers([program], {})
            note_unfollowed([program], self._names_in_file, self.helpers)
        self._entries[key] = program
        return program

    def _run_entry(
        self,
        entry: EntryPoint,
        module: Module,
        overrides: model.Overrides | None,
        words: Sequence[str | None] | None,
    ) -> Followed:
        run = self.new_run(entry.executable, module, overrides=overrides)
        run.program.package = entry.package
        ran_before = self._is_imported(module)
        with FollowedProgram(run, module) as root:
            if words is not None:
                command_line.give_words(run, words)
            run.import_module(module)
            use_own_methods(run, module, *self._built_with(entry))
            if entry.function is not None:
                function = self._dotted(run, module, entry.function)
                if function is not None and not _has_run_on_import(module, entry.function, function):
                    run.context.name = entry.function
                    root.place = place_of(function) or root.place
                    run.call(function)
            elif main_guard(module.facts) is not None:
                _run_block(run, module, main_guard(module.facts))
            elif ran_before:
                _run_block(run, module, module.facts)
            _make_escaped_class(run)
        return root.result()

    def _built_with(self, entry: EntryPoint) -> list[Module]:
        """The sources of C++ that an executable is built of, besides the one that it starts in."""
        modules = map(self.index.module, entry.others)
        return [module for module in modules if module is not None]

    def _names_in_file(self, file: str) -> frozenset[str]:
        """All names that a file, by its shown path, uses."""
        module = self.index.module(self._shown[file]) if file in self._shown else None
        return frozenset() if module is None else frozenset(module.facts.names)

    def _dotted(self, run: Run, module: Module, name: str) -> Value | None:
        head, *rest = name.split(".")
        value = run.module_attribute(module, head)
        for part in rest:
            value = None if value is None else get_attribute(run, value, part)
        return value

    def run_script(self, module: Module) -> model.Program:
        """Run a file as ``python file``: its top level, then what the main guard holds."""
        self.monitor.following(1)
        return self.follower.follow(ScriptKey(module.path), lambda: self._run_script(module)).program

    def _run_script(self, module: Module) -> Followed:
        name = module.path.rpartition("/")[2]
        run = self.new_run(name.removesuffix(".py"), module)
        guard = main_guard(module.facts)
        run.program.executable = guard is not None
        with FollowedProgram(run, module, None if guard is None else Place(module.path, *guard.span)) as root:
            run.import_module(module)
            use_own_methods(run, module)
            _run_block(run, module, guard)
            _make_escaped_class(run)
        return root.result()


def _has_run_on_import(module: Module, name: str, function: Value) -> bool:
    """Whether a console script only makes a coroutine that nothing runs, of what its import has run already."""
    is_async = isinstance(function, FunctionValue) and function.ir.is_async
    return is_async and calls_on_import(module.facts, name)


def _says_something(program: model.Program) -> bool:
    of_messages = (program.unknown_interfaces, program.field_uses, program.wrong_values, program.absent_reads)
    return any(
        (program.nodes, program.calls, program.callbacks, program.refused_calls, program.mistaken_futures, *of_messages)
    )


def _run_block(run: Run, module: Module, block: facts.If | facts.Facts | None) -> None:
    """Run what stands at the top level of a module: its main guard, or all of it."""
    if block is None or module.scope is None:
        return
    run.activations[-1] = Activation(module.name, module, module.scope, block.body, run.store.depth)
    run.execute(block.body)


def _make_escaped_class(run: Run) -> None:
    """An entry point that makes no node itself, and gives one node class to code that is not here, has that make
    the node."""
    if run.program.nodes or len(run.escapes.classes) != 1:
        return
    [cls] = run.escapes.classes.values()
    run.activations[-1].statement = None
    instance = run.call(cls)
    escapes.escape(run, [instance], "code that is not followed creates it")


__all__ = ["EntryPoint", "Linker", "run_callbacks"]
