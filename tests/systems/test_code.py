"""The look-ups in the Python code of a workspace."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.place import Place
from archlint.syntax.python.lowering import lower
from archlint.syntax.workspace_files import WorkspaceFiles
from archlint.systems.code import WorkspaceCode
from archlint.workspace.installed import Executable, Installs
from archlint.workspace.model import SourceFile
from archlint.workspace.tree import SourceTree
from robot_package import write_files

TEXTS = {
    "robot/robot/__init__.py": "",
    "robot/robot/talker.py": "from robot import helper\nfrom arm import joint\n",
    "robot/robot/helper.py": "from .deep import inner\nRATE = 'rate_hz'\n",
    "robot/robot/deep/inner.py": "",
    "robot/robot/unused.py": "",
    "robot/launch/it.launch.py": "import robot.unused\n",
    "arm/arm/joint.py": "",
}


@pytest.fixture
def code(tmp_path: Path) -> WorkspaceCode:
    write_files(tmp_path, TEXTS)
    files = [_file(path) for path in TEXTS]
    installs = Installs("robot", "robot")
    installs.add(Executable("talker", "robot", Place("setup.py", 6, 1, 6, 20), "robot.talker", "main"))
    workspace = WorkspaceFiles(files, lambda file: lower(TEXTS[file.relative]), tree=SourceTree(tmp_path))
    return WorkspaceCode(workspace, installs={"robot": installs})


def _file(path: str) -> SourceFile:
    package, _, inside = path.partition("/")
    kind = "launch_python" if path.endswith(".launch.py") else "python"
    module = "" if kind == "launch_python" else inside.removesuffix(".py").removesuffix("/__init__").replace("/", ".")
    return SourceFile(f"/w/{path}", path, kind, package, module)


def test_files_and_modules_of_a_package(code: WorkspaceCode):
    assert code.files_of("arm") == ["arm/arm/joint.py"]
    assert code.modules_of("robot")["robot.talker"] == "robot/robot/talker.py"
    assert "robot/launch/it.launch.py" not in code.files_of("robot")
    assert code.top_modules == {"robot", "arm"}


@pytest.mark.parametrize(
    ("module", "files"),
    [
        ("robot.talker", ["robot/robot/talker.py"]),
        ("deep.inner", ["robot/robot/deep/inner.py"]),  # put on the path by other means
        ("robot.gone", []),
    ],
)
def test_the_files_that_a_module_may_be(code: WorkspaceCode, module: str, files: list[str]):
    assert code.files_named("robot", module) == files


def test_who_imports_whom(code: WorkspaceCode):
    talker = next(file for file, _ in code.asked_for() if file.relative.endswith("talker.py"))
    assert code.is_local(talker, "robot.helper")
    assert not code.is_local(talker, "arm.joint")
    assert code.imported(talker.relative, "arm.joint") is not None
    assert code.imported(talker.relative, "numpy") is None


def test_what_programs_and_launch_files_lead_to_is_in_use(code: WorkspaceCode):
    in_use = code.in_use
    assert {"robot/robot/talker.py", "robot/robot/helper.py", "robot/robot/deep/inner.py", "arm/arm/joint.py"} <= in_use
    assert "robot/robot/unused.py" in in_use  # the launch file imports it
    assert code.reached_from(["robot/robot/deep/inner.py"]) == {"robot/robot/deep/inner.py"}


def test_what_is_in_use_is_worked_out_once(code: WorkspaceCode, monkeypatch):
    """Rules ask for each use of a package, and all imports of the workspace lead to the answer."""
    asked: list[object] = []
    reached_from = WorkspaceCode.reached_from
    monkeypatch.setattr(
        WorkspaceCode, "reached_from", lambda self, starts: [asked.append(starts), reached_from(self, starts)][1]
    )
    assert code.in_use == code.in_use
    assert len(asked) == 1


def test_words_of_a_file(code: WorkspaceCode):
    assert code.mentions("robot/robot/helper.py", "rate_hz")
    assert not code.mentions("robot/robot/helper.py", "rate")  # part of a word
    assert not code.mentions("robot/gone.py", "rate")


def test_only_python_has_facts():
    """A launch file in YAML may well be an expression of Python, too."""
    compiled: list[str] = []
    launch = SourceFile("/w/it.launch.yaml", "it.launch.yaml", "launch_yaml", "robot", "")
    script = SourceFile("/w/it.py", "it.py", "python", "robot", "it")
    code = WorkspaceCode(WorkspaceFiles([launch, script], lambda file: compiled.append(file.relative)))
    assert code.facts_at("it.launch.yaml") is code.facts_at("it.py") is None
    assert compiled == ["it.py"]


def test_without_files_nothing_is_known():
    nothing = WorkspaceCode()
    assert nothing.facts_at("a.py") is None
    assert nothing.asked_for() == []
    assert nothing.in_use == frozenset()
