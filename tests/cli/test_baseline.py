"""A team with old findings switches archlint on: ``--write-baseline``, ``--baseline``, ``--prune-baseline``."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest

from archlint.cli import main
from robot_package import SETUP_CFG, manifest, write_files

NODE = """\
import rclpy
from rclpy.node import Node
from std_srvs.srv import SetBool


class {name}(Node):
    def __init__(self):
        super().__init__('{node}')
        self.motor = self.create_client(SetBool, 'enable_motor')
        self.motor.wait_for_service()
        self.timer = self.create_timer(5.0, self.enable)

    def enable(self):
        self.motor.call_async(SetBool.Request(data=True))


def main():
    rclpy.init()
    rclpy.spin({name}())
"""
SETUP = """\
from setuptools import setup
setup(name='robot', entry_points={'console_scripts': ['arm = robot.arm:main', 'leg = robot.leg:main']})
"""
ARM = "TMO001 robot/arm.py: Arm.__init__, enable_motor, wait_for_service"
LEG = "TMO001 robot/leg.py: Leg.__init__, enable_motor, wait_for_service"
FILE = "archlint-baseline.txt"


@pytest.fixture(autouse=True)
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Two nodes that wait for ever."""
    monkeypatch.chdir(tmp_path)
    more = "<exec_depend>std_srvs</exec_depend>"
    files = {
        "package.xml": manifest(more=more),
        "setup.py": SETUP,
        "setup.cfg": SETUP_CFG,
        "robot/__init__.py": "",
        "robot/arm.py": NODE.format(name="Arm", node="arm"),
        "robot/leg.py": NODE.format(name="Leg", node="leg"),
        "archlint.toml": f'baseline = "{FILE}"\n',
    }
    return write_files(tmp_path, files)


def edit(file: str, before: str, after: str) -> None:
    path = Path(file)
    text = path.read_text("utf-8")
    assert before in text
    path.write_text(text.replace(before, after), "utf-8")


def mend(file: str) -> None:
    edit(file, "        self.motor.wait_for_service()\n", "")


def entries() -> list[str]:
    return [line for line in Path(FILE).read_text("utf-8").splitlines() if not line.startswith("#")]


class Said:
    """What one command says."""

    def __init__(self, capsys: pytest.CaptureFixture[str], *words: str) -> None:
        self.status = main(["check", "--no-cache", "--format", "concise", *words])
        out = capsys.readouterr()
        self.findings = [
            line.split(": ")[0].rpartition(":")[0] + " " + line.split()[2] for line in out.out.splitlines()
        ]
        self.err = out.err


@pytest.fixture
def say(capsys: pytest.CaptureFixture[str]):
    return lambda *words: Said(capsys, *words)


def test_old_findings_are_held_back_and_a_new_one_fails(say):
    first = say("--write-baseline")
    assert (first.status, first.findings) == (0, [])
    assert first.err.startswith(f"Wrote 2 entries to {FILE}.\n")
    assert entries() == [ARM, LEG]

    edit("robot/arm.py", "import rclpy\n", "# The arm.\n\nimport rclpy\n")
    again = say()
    assert (again.status, again.findings) == (0, [])
    assert again.err == "No findings in 3 files with 2 nodes; 2 held by the baseline.\n"

    edit(
        "robot/leg.py",
        "    def enable",
        "        self.create_client(SetBool, 'enable_brake').wait_for_service()\n\n    def enable",
    )
    worse = say()
    assert (worse.status, worse.findings) == (1, ["robot/leg.py:13 TMO001"])
    assert entries() == [ARM, LEG]


def test_what_is_mended_has_to_leave_the_baseline_and_nothing_is_added_to_it(say):
    say("--write-baseline")
    mend("robot/arm.py")
    edit(
        "robot/leg.py",
        "    def enable",
        "        self.create_client(SetBool, 'enable_brake').wait_for_service()\n\n    def enable",
    )
    stale = say()
    assert (stale.status, stale.findings) == (1, [f"{FILE}:3 LNT004", "robot/leg.py:13 TMO001"])

    pruned = say("--prune-baseline")
    assert (pruned.status, pruned.findings) == (1, ["robot/leg.py:13 TMO001"])
    assert pruned.err.startswith(f"Removed 1 entry from {FILE}.\n")
    assert entries() == [LEG]


def test_a_run_speaks_only_of_what_it_looked_at(say):
    say("--write-baseline")
    mend("robot/arm.py")
    assert say("robot/leg.py").findings == []
    assert say("--ignore", "TMO").findings == []
    assert say("robot").findings == [f"{FILE}:3 LNT004"]
    Path("robot/arm.py").unlink()
    edit("setup.py", "'arm = robot.arm:main', ", "")
    assert say().findings == [f"{FILE}:3 LNT004"]

    edit("robot/leg.py", "Leg", "Limb")
    say("robot/leg.py", "--write-baseline")
    assert entries() == [ARM, LEG.replace("Leg", "Limb")]


def test_a_file_that_cannot_be_read_leaves_its_entries_alone(say):
    say("--write-baseline")
    Path("robot/arm.py").write_text("import rclpy\ndef f(:\n", "utf-8")
    broken = say()
    assert [line.split()[1] for line in broken.findings] == ["LNT002"]
    say("--prune-baseline")
    assert entries() == [ARM, LEG]


def test_all_of_it_is_shown_without_the_baseline(say):
    say("--write-baseline")
    assert say("--no-baseline").findings == ["robot/arm.py:10 TMO001", "robot/leg.py:10 TMO001"]
    assert say("--isolated").findings == ["robot/arm.py:10 TMO001", "robot/leg.py:10 TMO001"]


def test_the_folder_that_it_is_run_in_does_not_matter(say, monkeypatch: pytest.MonkeyPatch):
    say("--write-baseline")
    monkeypatch.chdir("robot")
    assert say().findings == []


def test_json_says_how_many_are_held_back(say, capsys: pytest.CaptureFixture[str]):
    say("--write-baseline")
    main(["check", "--no-cache", "--format", "json"])
    report = json.loads(capsys.readouterr().out)
    assert (report["diagnostics"], report["summary"]["baselined"]) == ([], 2)


def test_an_answer_that_was_kept_ends_with_the_baseline(capsys: pytest.CaptureFixture[str]):
    main(["check", "--write-baseline"])
    for _ in range(2):
        assert main(["check"]) == 0
    Path(FILE).write_text(f"{LEG}\n", "utf-8")
    assert main(["check"]) == 1


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ([], "archlint.toml:1: `baseline` names a file that does not exist; to create it, add --write-baseline"),
        (["--baseline", "old.txt"], "--baseline: no such file: old.txt; to create it, add --write-baseline"),
        (["--isolated", "--write-baseline"], "--write-baseline needs a file: add `--baseline archlint-baseline.txt`"),
        (["--no-baseline", "--prune-baseline"], "--prune-baseline needs a file"),
        (["--prune-baseline", "--diff"], "--diff writes nothing"),
        (["--baseline", "setup.py", "--write-baseline"], "setup.py is not a baseline, so it is not overwritten"),
        (["--baseline", "setup.py"], "setup.py:1: not an entry of a baseline"),
        (["--baseline", "."], "cannot be read"),
    ],
)
def test_what_cannot_be_used_says_so(say, words: list[str], said: str):
    result = say(*words)
    assert result.status == 2
    assert said in result.err
    assert not Path(FILE).exists()


def test_a_configuration_cannot_choose_a_file_elsewhere(say):
    Path("archlint.toml").write_text('baseline = "../../precious.txt"\n', "utf-8")
    result = say("--write-baseline")
    assert result.status == 2
    assert result.err.startswith("archlint: error: archlint.toml:1: `baseline` leads out of the repository")


def test_no_line_that_moves_ends_an_entry(
    say, tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch
):
    broken = tmp_path_factory.mktemp("alone") / "broken"
    shutil.copytree(Path(__file__).parents[2] / "fixtures" / "broken_system", broken)
    monkeypatch.chdir(broken)
    assert say("--baseline", FILE, "--write-baseline").findings == []
    assert len(entries()) > 10
    for file in [*Path().rglob("*.py"), *Path().rglob("*.yaml"), *Path().rglob("*.msg")]:
        file.write_text(f"# Moved.\n\n\n{file.read_text('utf-8')}", "utf-8")
    assert say("--baseline", FILE).findings == []
