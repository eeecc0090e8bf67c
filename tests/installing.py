"""What a package of a test installs."""

from __future__ import annotations

from pathlib import Path

from archlint.programs.entry import EntryPoint
from archlint.programs.entry_points import entry_points, read_installs
from archlint.syntax.compile import compile_python
from archlint.syntax.workspace_files import WorkspaceFiles
from archlint.workspace.discovery import find
from archlint.workspace.installed import Installs
from archlint.workspace.tree import SourceTree

MANIFEST = "<package><name>robot</name><export><build_type>ament_python</build_type></export></package>"


class InstallsOf:
    """Writes the files of a package ``robot`` of Python, and reads what it installs."""

    def __init__(self, root: Path) -> None:
        self.root = root
        self.entry_points: list[EntryPoint] = []

    def __call__(self, **files: str) -> Installs:
        files.setdefault("package.xml", MANIFEST)
        for name, text in files.items():
            path = self.root / "robot" / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        workspace = find(["."], working_directory=str(self.root))
        facts_of = lambda file: compile_python(Path(file.path).read_text())  # noqa: E731
        files = WorkspaceFiles(workspace.files, facts_of, tree=SourceTree(self.root))
        installs = read_installs(workspace.packages, files)["robot"]
        self.entry_points = entry_points({"robot": installs}, workspace.files)
        return installs


def modules_of(installs: Installs) -> dict[str, tuple[str | None, str | None]]:
    return {executable.name: (executable.module, executable.function) for executable in installs.executables.values()}
