"""The step that installs, with a Python that only writes down what it is asked: `make adoption` installs truly."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PYTHON = """\
#!/bin/sh
echo "$*" >>"$ASKED"
case "$1 $2" in
  "-c "*) exit {old} ;;
  "-m venv")
    mkdir -p "$4/bin" && cp "$0" "$4/bin/python"
    printf '#!/bin/sh\\necho archlint 1.2.3\\n' >"$4/bin/archlint"
    chmod +x "$4/bin/archlint"
    exit {broken} ;;
esac
"""


class Machine:
    """One with a Python of ours, and what it was asked."""

    def __init__(self, root: Path, old: bool = False, broken: bool = False) -> None:
        self.root = root
        self.asked, self.output = root / "asked", root / "output"
        programs = root / "programs"
        programs.mkdir()
        for name in ("python3", "python"):
            (programs / name).write_text(PYTHON.format(old=int(old), broken=int(broken)))
            (programs / name).chmod(0o755)
        self.path = f"{programs}:{os.defpath}"

    def install(self, version: str = "") -> subprocess.CompletedProcess[str]:
        temporary = self.root / "temporary"
        temporary.mkdir(exist_ok=True)
        variables = {
            "PATH": self.path,
            "ASKED": str(self.asked),
            "RUNNER_TEMP": str(temporary),
            "RUNNER_OS": "Linux",
            "RUNNER_ARCH": "X64",
            "GITHUB_OUTPUT": str(self.output),
            "ARCHLINT_VERSION": version,
        }
        command = ["bash", str(ROOT / "scripts" / "action" / "install")]
        return subprocess.run(command, cwd=self.root, env=variables, capture_output=True, text=True, check=False)


@pytest.mark.parametrize(("version", "wanted"), [("", str(ROOT)), ("0.2.0", "archlint==0.2.0")])
def test_it_installs_this_revision_or_a_release(tmp_path: Path, version: str, wanted: str):
    machine = Machine(tmp_path)
    done = machine.install(version)
    assert done.returncode == 0, done.stdout + done.stderr
    assert machine.asked.read_text("utf-8").splitlines()[-1].endswith(f" {wanted}")
    outputs = dict(line.split("=", 1) for line in machine.output.read_text("utf-8").splitlines())
    assert outputs["archlint"] == str(tmp_path / "temporary" / "archlint" / "environment" / "bin" / "archlint")
    assert outputs["cache-key"] == "archlint-Linux-X64-1.2.3"


@pytest.mark.parametrize("version", ["0.1; touch touched", "$(touch touched)", "../evil", "--index-url=x", "a\nb=c"])
def test_a_version_is_a_version(tmp_path: Path, version: str):
    machine = Machine(tmp_path)
    done = machine.install(version)
    assert done.returncode == 2
    assert done.stdout == "::error title=archlint::version must be a release such as 0.1.0\n"
    assert not (tmp_path / "touched").exists() and not machine.asked.exists()


def test_a_python_that_is_too_old_is_an_error_that_says_what_to_do(tmp_path: Path):
    done = Machine(tmp_path, old=True).install()
    assert done.returncode == 2
    assert "archlint needs Python 3.10 or newer: give the action a python-version" in done.stdout


def test_a_python_that_makes_no_environments(tmp_path: Path):
    done = Machine(tmp_path, broken=True).install()
    assert done.returncode == 2
    assert "python3 cannot make an environment here" in done.stdout
