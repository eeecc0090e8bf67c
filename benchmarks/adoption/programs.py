"""The programs that a team has: archlint, git, pre-commit and colcon, each run as in a shell of its own."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).parents[2]
ENVIRONMENT = ROOT / ".venv-adoption"
NEEDED = ("pre-commit", "colcon-common-extensions", "check-jsonschema", "zizmor")
"""What the environment has besides archlint; colcon-common-extensions brings those for ROS."""
_PASSED_ON = ("PATH", "SYSTEMROOT", "LANG", "SSL_CERT_FILE", "REQUESTS_CA_BUNDLE", "NODE_EXTRA_CA_CERTS")
_WRAPPER = """\
#!{python}
import sys
sys.path[0] = {source!r}
from archlint.cli import main
main()
"""
TIME_LIMIT = 600
"""Seconds that a program may take: pre-commit installs archlint with all that it needs."""


@dataclass(frozen=True)
class Done:
    """What a program has said."""

    status: int
    out: str
    err: str

    @property
    def said(self) -> str:
        return self.out + self.err


@dataclass(frozen=True)
class Programs:
    """Where the programs are, and a home folder in which nothing of the user's counts."""

    folder: Path
    """The programs of an environment; archlint is among them."""
    python: Path
    """The Python that has archlint's requirements."""
    home: Path
    installs: bool = False
    """Whether steps may install something from PyPI."""

    def has(self, name: str) -> bool:
        return (self.folder / name).exists()

    def run(self, words: Sequence[str | Path], cwd: Path, **variables: str) -> Done:
        done = subprocess.run(
            [str(word) for word in words],
            cwd=cwd,
            env=self.environment(variables),
            capture_output=True,
            text=True,
            errors="replace",
            check=False,
            timeout=TIME_LIMIT,
        )
        return Done(done.returncode, done.stdout, done.stderr)

    def archlint(self, cwd: Path, *words: str) -> Done:
        return self.run([self.folder / "archlint", *words], cwd)

    def git(self, cwd: Path, *words: str | Path) -> Done:
        return self.run(["git", *words], cwd)

    def environment(self, variables: Mapping[str, str] | None = None) -> dict[str, str]:
        kept = {name: value for name, value in os.environ.items() if name in _PASSED_ON or name.startswith("PIP_")}
        names = {f"GIT_{role}_NAME": "Kim" for role in ("AUTHOR", "COMMITTER")}
        mails = {f"GIT_{role}_EMAIL": "kim@example.com" for role in ("AUTHOR", "COMMITTER")}
        path = f"{self.folder}{os.pathsep}{kept.get('PATH', os.defpath)}"
        return kept | names | mails | {"HOME": str(self.home), "PATH": path} | (variables or {})


def of_this_checkout(folder: Path, home: Path) -> Programs:
    """archlint from this checkout, run by this Python; of the rest only what the machine has."""
    folder.mkdir(parents=True, exist_ok=True)
    start = folder / "archlint"
    start.write_text(_WRAPPER.format(python=sys.executable, source=str(ROOT / "src")), "utf-8")
    start.chmod(0o755)
    return Programs(folder, Path(sys.executable), home)


def installed(home: Path) -> Programs | str:
    """The environment with all programs, made where there is none; or why there is none."""
    python = ENVIRONMENT / "bin" / "python"
    commands: list[list[str | Path]] = [[sys.executable, "-m", "venv", ENVIRONMENT]] if not python.exists() else []
    pip: list[str | Path] = [python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
    commands.append([*pip, *NEEDED, f"{ROOT}[lsp]"])
    commands.append([*pip, "--no-deps", "--force-reinstall", ROOT])
    for words in commands:
        done = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            last = (done.stdout + done.stderr).strip().splitlines()[-1:]
            return f"pip cannot install {', '.join(NEEDED)}: {''.join(last)}"
    return Programs(ENVIRONMENT / "bin", python, home, installs=True)
