"""Scripts that CMake installs as programs and that the operating system cannot start.

Source: ``install(PROGRAMS …)`` copies a file as it is and makes it executable; ``ros2 run`` and launch start it by its
path alone, without a shell, so that the kernel wants its ``#!`` line (execve(2)).
"""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.launch.kinds import StartedKind
from archlint.python_code.left_blanks import is_an_exercise
from archlint.records import dataclass
from archlint.syntax.walk import main_guard

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.installed import Executable

_PYTHON = re.compile(r"\bpython[\d.]*\b|\bprefix\b|\blaunch-prefix\b")
"""Words of a launch file that may start a script by an interpreter of its choice."""

_FIRST_LINE = re.compile(r"\A#!.*")


@dataclass(frozen=True)
class Unstartable:
    """A script without a ``#!`` line, or (``carriage_return``) with one that ends as lines do on Windows;
    ``started_at`` is where a launch file starts it."""

    executable: Executable
    script: str
    carriage_return: bool
    started_at: Place | None
    below: int = 0
    """The line that has a ``#!`` and is not the first; 0 where there is none."""


def unstartable_scripts(workspace: WorkspaceIndex) -> Iterator[Unstartable]:
    """Every such script that is a program: a launch file starts it, or it has code for that case, and is no exercise
    that nobody has done."""
    started = _started(workspace)
    for package in sorted(workspace.installs):
        build = workspace.packages.get(package)
        if build is None or build.build_type != "ament_cmake":
            continue
        for executable in workspace.installs[package].executables.values():
            script = executable.script
            if script is None or not script.endswith(".py") or not executable.place.file.endswith((".txt", ".cmake")):
                continue
            beginning = workspace.tree.lines(script, 1, 2)
            first = "".join(beginning[:1])
            if not any(beginning) or (first.startswith("#!") and not first.endswith("\r")):
                continue
            at = started.get((package, executable.name))
            by_hand = not _is_to_be_copied(workspace, script) and _is_program(workspace, executable, script)
            if (at is not None or by_hand) and not _has_python(workspace, script):
                yield Unstartable(executable, script, first.startswith("#!"), at, _line_below(workspace, script))


def _is_to_be_copied(workspace: WorkspaceIndex, script: str) -> bool:
    """Whether a script is there for others to go on from: an exercise, or ``node_template.py``."""
    words = posixpath.basename(script).removesuffix(".py").lower().split("_")
    return "template" in words or is_an_exercise(workspace, script)


def _line_below(workspace: WorkspaceIndex, script: str) -> int:
    return next((number for number, _ in workspace.tree.lines_with(script, "^#!/") if number > 1), 0)


def _started(workspace: WorkspaceIndex) -> dict[tuple[str | None, str | None], Place]:
    """Where launch files start the programs of packages, by package and name."""
    rows: dict[tuple[str | None, str | None], Place] = {}
    for launched in workspace.launched:
        for process in launched.started:
            if process.kind is StartedKind.NODE:
                rows.setdefault((process.package.text, process.executable.text), process.place)
    return rows


def _is_program(workspace: WorkspaceIndex, executable: Executable, script: str) -> bool:
    """Whether a script has code for the case that it is started, and no other file imports it."""
    file_facts = workspace.facts_at(script)
    if file_facts is None or main_guard(file_facts) is None:
        return False
    stem = posixpath.basename(script).removesuffix(".py")
    imported = rf"^[ \t]*(?:from|import)\b.*\b{re.escape(stem)}\b"
    files = (file for file in workspace.code.files_of(executable.package) if file != script)
    named = (file for file in files if workspace.code.mentions(file, stem))
    return not any(workspace.tree.lines_with(file, imported) for file in named)


def _has_python(workspace: WorkspaceIndex, script: str) -> bool:
    """Whether a launch file names the script and may have an interpreter start it."""
    name = posixpath.basename(script)
    texts = (workspace.tree.text(launched.file) or "" for launched in workspace.launched)
    return any(name in text and _PYTHON.search(_FIRST_LINE.sub("", text)) for text in texts)
