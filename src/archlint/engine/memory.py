"""What a run over a workspace leaves in memory, so that the next one, after an edit of code, has a first answer soon.

The first answer has everything that the edited files themselves can change: the open system is linked and judged anew,
by rules that go by program only where programs run edited code, and so is each launched system that has code of theirs.
Of the other programs and launched systems, and of what packages say of each other, it repeats what the run before has
found; a whole run then says what else has changed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import field, replace
from typing import TYPE_CHECKING

from archlint.checks.registry import registered
from archlint.checks.scope import Scope
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.checks.registry import Options
    from archlint.finding import Finding
    from archlint.launch.model import Launched
    from archlint.model import Program
    from archlint.systems.model import System
    from archlint.workspace.installed import Installs

Selected = Mapping[str, "Options"]
Judge = Callable[["System", Selected], Iterable["Finding"]]


@dataclass
class Memory:
    """What one run has made and found.  ``before`` is that of the run whose findings it may repeat, and ``changed``
    are the files, by their shown paths, that are not as they were then."""

    before: Memory | None = None
    changed: frozenset[str] = frozenset()
    moved: Callable[[Iterable[Finding]], list[Finding]] = list
    """Findings of the run before at the lines where their code is now."""
    _systems: dict[str, System] = field(default_factory=dict)
    """Those of launch files, by their paths."""
    _files: dict[str, frozenset[str]] = field(default_factory=dict)
    """The files that each of them was made of; none of one of which that is not known."""
    _installs: tuple[dict[str, Installs], frozenset[str]] | None = None
    _findings: dict[str, list[Finding]] = field(default_factory=dict)
    _of_packages: list[Finding] = field(default_factory=list)
    """What was found for all the workspace, whatever nodes there are."""
    _of_programs: list[Finding] = field(default_factory=list)
    """What rules have found that go by program."""
    _programs: dict[int, frozenset[str] | None] = field(default_factory=dict)
    """The files that each program of the open system has read, by its id; None where that is not known."""

    def installs(self) -> dict[str, Installs] | None:
        """What packages install, if nothing was edited that says so."""
        before = self.before
        if before is None or before._installs is None:
            return None
        installs, files = before._installs
        return installs if self.changed.isdisjoint(files) else None

    def note_installs(self, installs: dict[str, Installs], files: Iterable[str]) -> None:
        """What packages install has been read from their build files and these modules."""
        self._installs = installs, frozenset(files)

    def system(self, launched: Launched) -> System | None:
        """The system of a launch file, if nothing of it was edited."""
        before = self.before
        if before is None or launched.file not in before._systems or launched.file not in before._findings:
            return None
        files = before._files.get(launched.file)
        if files is None or not self.changed.isdisjoint({*files, *launched.sources}):
            return None
        return before._systems[launched.file]

    def note(self, system: System, files: Iterable[str] | None) -> None:
        """A system has been made of these files; None where not all of them are known."""
        if system.name is not None:
            self._systems[system.name] = system
            if files is not None:
                self._files[system.name] = frozenset(files)

    def note_programs(self, programs: Iterable[Program], files_of: Callable[[Program], Iterable[str] | None]) -> None:
        """These are the programs of the open system, and what each has read."""
        for program in programs:
            files = files_of(program)
            self._programs[id(program)] = None if files is None else frozenset((program.file, *files))

    def judged(self, system: System, selected: Selected, judge: Judge) -> Iterator[Finding]:
        """What ``judge`` finds in a system, or the run before has found."""
        if system.launched is not None:
            file = system.launched.file
            if self.before is not None and self.system(system.launched) is not None:
                self._findings[file] = self.moved(self.before._findings[file])
            else:
                self._findings[file] = list(judge(system, selected))
            yield from self._findings[file]
            return
        checks = registered()
        whole = {code for code in selected if code in checks and checks[code].scope is Scope.WORKSPACE}
        by_program = {code: options for code, options in selected.items() if code in checks and checks[code].by_program}
        if self.before is None:
            self._of_packages = list(judge(system, {code: selected[code] for code in selected if code in whole}))
            self._of_programs = list(judge(system, by_program))
        else:
            self._of_packages = self.moved(self.before._of_packages)
            self._of_programs = self._judged_again(self.before, system, by_program, judge)
        yield from self._of_packages
        yield from self._of_programs
        rest = {code: selected[code] for code in selected if code not in whole and code not in by_program}
        yield from judge(system, rest)

    def _judged_again(self, before: Memory, system: System, selected: Selected, judge: Judge) -> list[Finding]:
        """What rules find that go by program: of the files of programs that run edited code, or did so before, they
        are asked again, with all programs that run code of these."""
        every = [*self._programs.values(), *before._programs.values()]
        failed = any(finding.code not in selected for finding in before._of_programs)
        if failed or any(files is None for files in every):
            return list(judge(system, selected))
        touched = self.changed.union(
            *(files for files in every if files is not None and not self.changed.isdisjoint(files))
        )
        programs = [program for program in system.programs if not touched.isdisjoint(self._programs[id(program)] or ())]
        ids = {id(program) for program in programs}
        nodes = [node for node in system.entries if node.program is None or id(node.program) in ids]
        part = replace(system, nodes=nodes, programs=programs, unowned=())
        again = [finding for finding in judge(part, selected) if finding.place.file in touched]
        return [*(row for row in self.moved(before._of_programs) if row.place.file not in touched), *again]


__all__ = ["Memory"]
