"""Try the editors that are here: ``python -m benchmarks.editors``.

An editor is ``ok``, ``failed``, or ``skipped`` with what is missing.  The exit status is 1 where one failed.
``NEOVIM``, ``EMACS`` and ``NODE`` name other programs than those on the ``PATH``, ``VSIX`` the extension's package.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
PATIENCE = 300
"""Seconds until an editor that does not end is given up."""
SHOWN = [["NME001", 7], ["OWN001", 14], ["SRV002", 15], ["SRV003", 38], ["TMO001", 17], ["TOP001", 13]]
"""Codes and lines of what is wrong with the file that is opened, as `archlint check` says."""
_FOLDER = Path("src/my_first_package/my_first_package")
_TRIED, _OTHER = "sensor_node.py", "control_node.py"
_NAME = {"TRIED_LINE": "13", "TRIED_COLUMN": "68", "NEW_NAME": "/robot/sensor/heat"}
"""Where the file has a topic's name, which the other file has too, and what it is renamed to."""


class Skipped(Exception):
    """An editor that cannot be tried here; ``str()`` says why."""


def neovim(folder: Path) -> list[str]:
    program = _program("NEOVIM", "nvim")
    said = subprocess.run([program, "--version"], check=False, capture_output=True, text=True).stdout
    version = re.match(r"NVIM v(\d+)\.(\d+)", said)
    if version is None or (number := (int(version[1]), int(version[2]))) < (0, 10):
        raise Skipped(f"{said.splitlines()[0] if said else program} is older than 0.10")
    configuration = folder / "init.lua"
    configuration.write_text(_snippets("lua")[0 if number >= (0, 11) else 1], "utf-8")
    return [program, "--headless", "-u", str(configuration), "-c", f"luafile {HERE / 'neovim.lua'}"]


def emacs(folder: Path) -> list[str]:
    program = _program("EMACS", "emacs")
    start = [program, "--batch", "--eval", "(package-initialize)"]  # Debian's elpa-eglot is one of its packages
    if subprocess.run([*start, "--eval", "(require 'eglot)"], check=False, capture_output=True).returncode:
        raise Skipped("this Emacs has no Eglot")
    configuration = folder / "init.el"
    configuration.write_text(_snippets("elisp")[0], "utf-8")
    return [*start, "-l", str(configuration), "-l", str(HERE / "emacs.el")]


def vscode(folder: Path) -> list[str]:
    package = Path(os.environ.get("VSIX", ROOT / "editors" / "vscode" / "archlint-0.1.0.vsix"))
    if not package.is_file():
        raise Skipped("the extension is not built: editors/README.md says how")
    with zipfile.ZipFile(package) as files:
        files.extractall(folder / "extension")
    return [_program("NODE", "node"), str(HERE / "vscode.js")]


def main() -> int:
    failed = False
    for editor in (neovim, emacs, vscode):
        with tempfile.TemporaryDirectory(prefix="editors-") as temporary:
            try:
                wrong, how = _tried(editor, Path(temporary).resolve()), "ok"
            except Skipped as reason:
                wrong, how = str(reason), "skipped"
        if how == "ok" and wrong:
            how, failed = "failed", True
        said = wrong or "findings, hover, definition and rename are right"
        print(f"  {how:<8} {editor.__name__:<8} {said}", flush=True)
    return int(failed)


def _tried(editor: Callable[[Path], list[str]], folder: Path) -> str:
    """What is wrong with the answers that an editor shows, or nothing."""
    command = editor(folder)
    workspace = folder / "workspace"
    shutil.copytree(ROOT / "fixtures" / "broken_system", workspace)
    (folder / "home").mkdir()
    answers = folder / "answers.json"
    files = {name: str(workspace / _FOLDER / name) for name in (_TRIED, _OTHER)}
    environment = os.environ | _NAME
    environment["PATH"] = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    environment |= {"TRIED": files[_TRIED], "WORKSPACE": str(workspace), "ANSWERS": str(answers)}
    environment |= {"HOME": str(folder / "home"), "EXTENSION": str(folder / "extension/extension/dist/extension.js")}
    environment |= {f"XDG_{kind}_HOME": str(folder / "home" / kind) for kind in ("CONFIG", "STATE", "DATA", "CACHE")}
    try:
        done = subprocess.run(
            command, check=False, env=environment, cwd=folder, capture_output=True, text=True, timeout=PATIENCE
        )
    except subprocess.TimeoutExpired:
        return f"it does not end within {PATIENCE} s"
    if not answers.is_file():
        return f"no answers; it said: {(done.stderr or done.stdout).strip()[-500:]}"
    return _wrong(json.loads(answers.read_text("utf-8")), files)


def _wrong(answers: dict[str, Any], files: dict[str, str]) -> str:
    if sorted(answers["shown"]) != SHOWN:
        return f"the findings are {answers['shown']}"
    if "Subscribed by\n- `/control_node`" not in answers["hover"]:
        return f"the hover says {answers['hover']!r}"
    if answers["ends"] != [files[_OTHER]]:
        return f"the definition is in {answers['ends']}"
    if sorted(answers["renamed"]) != sorted(files.values()):
        return f"the rename changes {answers['renamed']}"
    return ""


def _program(variable: str, name: str) -> str:
    program = os.environ.get(variable) or shutil.which(name)
    if program is None:
        raise Skipped(f"no {name} on the PATH")
    return program


def _snippets(language: str) -> list[str]:
    text = (ROOT / "editors" / "README.md").read_text("utf-8")
    return re.findall(rf"```{language}\n(.*?)```", text, re.DOTALL)


if __name__ == "__main__":
    sys.exit(main())
