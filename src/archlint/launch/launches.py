"""The launches of a workspace: each is a run of its own, and what launch files say is read once."""

from __future__ import annotations

import posixpath
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

from archlint.faults import Faults
from archlint.interpreter import containers
from archlint.interpreter.heap import Store
from archlint.interpreter.modules import ModuleIndex
from archlint.interpreter.values import Known
from archlint.launch.files import LaunchFiles
from archlint.launch.model import Launched
from archlint.launch.paths import LaunchPaths
from archlint.launch.run import Surroundings
from archlint.workspace.owners import FileOwners

if TYPE_CHECKING:
    from archlint.interpreter.modules import Module
    from archlint.interpreter.values import Value
    from archlint.launch.launcher import Launcher
    from archlint.syntax.workspace_files import WorkspaceFiles
    from archlint.workspace.installed import Installs


class Launches:
    """Runs the launch files of one workspace."""

    def __init__(
        self,
        files: WorkspaceFiles,
        installs: Mapping[str, Installs],
        faults: Faults | None = None,
        ros1_packages: frozenset[str] = frozenset(),
        distro: str | None = None,
    ) -> None:
        self.installs = installs
        self.index = ModuleIndex(files.importable, files.facts_of)
        self.faults = faults or Faults()
        self.owners = FileOwners(files.files, installs)
        paths = LaunchPaths(installs, files.tree, self.owners)
        self.files = LaunchFiles(files, self.owners, self.index.roles, self.faults, ros1_packages)
        self._surroundings = Surroundings(self.index, Store(), self.files, paths, self.faults, distro)
        self._of_defaults: dict[str, Launched] = {}
        self.knows_command_line = False
        """Whether the arguments that a run is given are all that the command line says, as where the user names them;
        otherwise a launch file that looks at ``sys.argv`` may find any word there."""
        self.follow: Callable[[str, Mapping[str, str], Callable[[], Launched]], Launched] = lambda _, __, act: act()
        """What a launch yields: the answer of ``act``, or one that is known."""

    def run(self, path: str, arguments: Mapping[str, str] | None = None) -> Launched:
        """Run a launch file as ``ros2 launch path name:=value …``; without arguments the defaults hold."""
        given = dict(arguments or {})
        if self.knows_command_line:
            return self._run(path, given)
        result = self.follow(path, given, lambda: self._run(path, given))
        if not given:
            self._of_defaults.setdefault(path, result)
        return result

    def _run(self, path: str, arguments: dict[str, str]) -> Launched:
        from archlint.launch.launcher import Launcher  # where all launches are known, nothing of it is needed

        result = Launched(path, self.owners.package_of(path), arguments)
        run = Launcher(self._surroundings, path, result)
        for name, value in arguments.items():
            run.launch.configurations[name] = Known(value)
        store = self._surroundings.store
        depth = store.depth
        store.push()
        run.argv = self._command_line(run, result) if self.knows_command_line else None
        try:
            run.enter(path)
        finally:
            store.cut(depth)
        result.stands_alone = result.stands_alone and not run.program.reads_command_line
        return result

    def import_module(self, module: Module) -> None:
        """Import a module as a launch does that comes to it, for whatever runs later."""
        from archlint.launch.launcher import Launcher  # as above

        Launcher(self._surroundings, module.path, Launched(module.path, None)).import_module(module)

    def _command_line(self, run: Launcher, result: Launched) -> Value:
        """``sys.argv`` of ``ros2 launch package file name:=value …``."""
        words = ["ros2", "launch", result.package or ".", posixpath.basename(result.file)]
        words += [f"{name}:={value}" for name, value in result.arguments.items()]
        return containers.new_list(run, [Known(word) for word in words])

    def with_defaults(self, path: str) -> Launched:
        """A launch file run on its own with its defaults; the same answer each time."""
        return self._of_defaults.get(path) or self.run(path)
