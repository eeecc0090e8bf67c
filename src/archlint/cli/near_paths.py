"""A path that does not exist, and what was probably meant by it."""

from __future__ import annotations

import os
from collections.abc import Iterator

from archlint.cli import COMMANDS, habits
from archlint.disk import walk
from archlint.rulebook import codes_of
from archlint.suggestions import listed, meant, nearest
from archlint.workspace.around import workspace_around

_MOST = 20_000
"""How many files and folders are looked through for a name."""
_PASSED_OVER = frozenset({"build", "install", "log", "node_modules", "__pycache__", "venv"})


def no_such_path(path: str, is_first: bool, rest: list[str]) -> str:
    """The message for a path that does not exist.  ``is_first`` says whether it is the first word of the command line,
    where a command might stand; ``rest`` are the words after it."""
    if os.path.islink(path):
        return f"{path} is a symbolic link that leads nowhere"
    return f"no such file or directory: {path}{_hint(path, is_first, rest)}"


def _hint(path: str, is_first: bool, rest: list[str]) -> str:
    if is_first and (command := _command(path, rest)):
        return meant(f"the command `{command}`")
    if near := near_path(path) or listed(named_below(path), "", shown=3):
        return meant(near)
    if any(sign in path for sign in "*?["):
        return "; a pattern is for the shell, without quotes: a folder is checked with all that is in it"
    if codes_of(path):
        return f"; several rules are written with commas between them: --select TMO001,{path}"
    if ":=" in path:
        return "; arguments of a launch file come after --launch FILE"
    near_command = nearest(path, COMMANDS)
    return meant(f"the command `{near_command}`" if near_command else "")


def _command(word: str, rest: list[str]) -> str:
    known = habits.COMMANDS.get(word, "")
    if known.endswith(" CODE"):
        return f"archlint {known.removesuffix('CODE')}{rest[0] if rest else 'CODE'}"
    return f"archlint {known}" if known else nearest(word, COMMANDS) or ""


def near_path(path: str) -> str:
    """The existing path of which each part is that of another one, or near it; empty where there is none."""
    if os.path.exists(path):
        return ""
    so_far = ""
    for part in path.replace(os.sep, "/").split("/"):
        step = os.path.join(so_far, part) if so_far else part or "/"
        if not os.path.exists(step):
            near = nearest(part, _names_in(so_far or "."))
            if near is None:
                return ""
            step = os.path.join(so_far, near)
        so_far = step
    return so_far


def named_below(name: str) -> list[str]:
    """Paths that end in a name without folders, below the working directory or else in the workspace around it:
    packages only, if there are any."""
    if not name or name != os.path.basename(name):
        return []
    around = workspace_around(os.getcwd())
    paths: list[str] = []
    for start in (".", *([] if around is None else [os.path.relpath(around)])):
        paths = paths or sorted(path for path in _all_below(start) if os.path.basename(path) == name)
    return [path for path in paths if os.path.isfile(os.path.join(path, "package.xml"))] or paths


def _all_below(start: str = ".") -> Iterator[str]:
    left = _MOST
    for folder, folders, files in walk(start):
        folders[:] = sorted(name for name in folders if not name.startswith(".") and name not in _PASSED_OVER)
        left -= len(folders) + len(files)
        if left < 0:
            return
        yield from (os.path.normpath(os.path.join(folder, name)) for name in (*folders, *files))


def _names_in(folder: str) -> list[str]:
    try:
        return os.listdir(folder)
    except OSError:
        return []


def no_such_launch_file(file: str, words: list[str]) -> str:
    """The message for a ``--launch`` that names no file; ``words`` are those after it."""
    if os.path.isdir(file):
        inside = sorted(path for path in _all_below() if _lies_in(path, file) and ".launch" in os.path.basename(path))
        return f"--launch: {file} is a folder" + (f"; the launch files in it: {listed(inside)}" if inside else "")
    names = [file, *words[:1]]  # as `ros2 launch PACKAGE FILE` takes them
    others = [path for name in names for path in named_below(name) if ".launch" in name and os.path.isfile(path)]
    return f"--launch: no such file: {file}{meant(near_path(file) or listed(others, '', shown=3))}"


def _lies_in(path: str, folder: str) -> bool:
    return os.path.abspath(path).startswith(os.path.abspath(folder).rstrip(os.sep) + os.sep)


__all__ = ["named_below", "near_path", "no_such_launch_file", "no_such_path"]
