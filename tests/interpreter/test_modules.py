"""Which file an import means: of a workspace whose files have these paths, as Python's search of packages says."""

from __future__ import annotations

import pytest

from archlint.interpreter.modules import Module, ModuleIndex
from archlint.syntax.facts import Facts
from archlint.syntax.python.lowering import lower
from archlint.workspace.model import Link, SourceFile


def file_at(path: str, module: str | None = None, links: tuple[Link, ...] = (), kind: str = "python") -> SourceFile:
    """A file of the package that its first folder is."""
    return SourceFile(f"/ws/{path}", path, kind, path.partition("/")[0], module, links=links)


class Workspace:
    """Files by path, each with the dotted name that it is imported by and its text."""

    def __init__(self, *files: SourceFile, **texts: str) -> None:
        self.files = {file.relative: file for file in files}
        self.texts = texts
        self.index = ModuleIndex(files, self.facts_of)

    def facts_of(self, file: SourceFile) -> Facts | None:
        text = self.texts.get((file.module or "").replace(".", "__"), "")
        return None if text == "no Python" else lower(text)

    def module(self, path: str) -> Module:
        module = self.index.module(self.files[path])
        assert module is not None
        return module

    def found(self, importer: str, name: str, level: int = 0) -> str | None:
        """The path of the module that an import in a file finds."""
        module = self.index.find(self.module(importer), name, level)
        return None if module is None else module.path


ROBOT = (
    file_at("robot/robot/__init__.py", "robot"),
    file_at("robot/robot/node.py", "robot.node"),
    file_at("robot/robot/drive/__init__.py", "robot.drive"),
    file_at("robot/robot/drive/motor.py", "robot.drive.motor"),
    file_at("robot/robot/drive/limits.py", "robot.drive.limits"),
)


@pytest.mark.parametrize(
    ("importer", "name", "level", "path"),
    [
        ("robot/robot/node.py", "robot", 0, "robot/robot/__init__.py"),
        ("robot/robot/node.py", "robot.drive", 0, "robot/robot/drive/__init__.py"),
        ("robot/robot/node.py", "robot.drive.motor", 0, "robot/robot/drive/motor.py"),
        ("robot/robot/node.py", "drive", 1, "robot/robot/drive/__init__.py"),
        ("robot/robot/node.py", "drive.motor", 1, "robot/robot/drive/motor.py"),
        ("robot/robot/node.py", "", 1, "robot/robot/__init__.py"),
        ("robot/robot/drive/motor.py", "limits", 1, "robot/robot/drive/limits.py"),
        ("robot/robot/drive/motor.py", "node", 2, "robot/robot/node.py"),
        ("robot/robot/drive/__init__.py", "motor", 1, "robot/robot/drive/motor.py"),
        ("robot/robot/drive/__init__.py", "node", 2, "robot/robot/node.py"),
        ("robot/robot/drive/motor.py", "motors", 1, None),
        ("robot/robot/drive/motor.py", "node", 1, None),
        ("robot/robot/node.py", "numpy", 0, None),
        ("robot/robot/node.py", "robot.wheel", 0, None),
    ],
)
def test_imports_within_a_package(importer: str, name: str, level: int, path: str | None):
    assert Workspace(*ROBOT).found(importer, name, level) == path


@pytest.mark.parametrize(
    ("importer", "name", "level", "absolute"),
    [
        ("robot/robot/drive/motor.py", "limits", 1, "robot.drive.limits"),
        ("robot/robot/drive/motor.py", "", 1, "robot.drive"),
        ("robot/robot/drive/motor.py", "node", 2, "robot.node"),
        ("robot/robot/drive/__init__.py", "motor", 1, "robot.drive.motor"),
        ("robot/robot/drive/__init__.py", "node", 2, "robot.node"),
        ("robot/robot/node.py", "rclpy.node", 0, "rclpy.node"),
    ],
)
def test_the_name_that_a_relative_import_stands_for(importer: str, name: str, level: int, absolute: str):
    workspace = Workspace(*ROBOT)
    assert workspace.index.absolute_name(workspace.module(importer), name, level) == absolute


def test_a_script_imports_what_lies_beside_it():
    workspace = Workspace(file_at("robot/scripts/run.py"), file_at("robot/scripts/helpers.py"))
    assert workspace.found("robot/scripts/run.py", "helpers") == "robot/scripts/helpers.py"
    assert workspace.found("robot/scripts/run.py", "run") is None, "a script that imports its own name means another"
    assert workspace.module("robot/scripts/run.py").name == "run"
    assert workspace.index.absolute_name(workspace.module("robot/scripts/run.py"), "helpers", 1) == "helpers"


def test_of_two_modules_of_a_name_that_of_the_own_package():
    workspace = Workspace(
        file_at("arm/src/utils.py", "utils"),
        file_at("base/src/utils.py", "utils"),
        file_at("base/src/node.py", "node"),
        file_at("tool/lib/main.py", "main"),
    )
    assert workspace.found("base/src/node.py", "utils") == "base/src/utils.py"
    assert workspace.found("tool/lib/main.py", "utils") == "arm/src/utils.py", "as near as the other: the first path"


def test_a_folder_that_the_code_puts_on_the_path():
    """``sys.path.append('vendor')``: a dotted name is looked for below the folders of the same package alone."""
    workspace = Workspace(
        file_at("robot/robot/node.py", "robot.node"),
        file_at("robot/vendor/planner/search.py", "vendor.planner.search"),
        file_at("other/planner/grid.py", "other.planner.grid"),
    )
    assert workspace.found("robot/robot/node.py", "planner.search") == "robot/vendor/planner/search.py"
    assert workspace.found("robot/robot/node.py", "search") is None
    assert workspace.found("robot/robot/node.py", "planner.grid") is None


def test_a_folder_called_launch_is_not_the_package_of_ros():
    workspace = Workspace(
        file_at("robot/launch/__init__.py", "launch"), file_at("robot/launch/up.launch.py", "launch.up")
    )
    assert workspace.found("robot/launch/up.launch.py", "launch") is None
    source_of_launch = Workspace(
        file_at("launch/launch/__init__.py", "launch"), file_at("robot/launch/up.launch.py", None)
    )
    assert source_of_launch.found("robot/launch/up.launch.py", "launch") == "launch/launch/__init__.py"


def test_a_linked_file_is_imported_by_each_of_its_names():
    shared = file_at("common/msgs.py", "common.msgs", (Link("/ws/robot/robot/msgs.py", "robot", "robot.msgs"),))
    workspace = Workspace(*ROBOT, shared, file_at("common/units.py", "common.units"))
    assert workspace.found("robot/robot/node.py", "robot.msgs") == "common/msgs.py"
    assert workspace.found("robot/robot/node.py", "msgs", 1) == "common/msgs.py"
    assert workspace.found("common/msgs.py", "units", 1) == "common/units.py"
    assert workspace.found("common/msgs.py", "drive.motor", 1) == "robot/robot/drive/motor.py"


def test_only_python_is_imported():
    workspace = Workspace(*ROBOT, file_at("robot/robot/table.yaml", "robot.table", kind="parameters"))
    assert workspace.found("robot/robot/node.py", "robot.table") is None


def test_what_does_not_compile_is_not_there():
    workspace = Workspace(*ROBOT, robot__drive__motor="no Python")
    assert workspace.found("robot/robot/node.py", "robot.drive.motor") is None
    assert workspace.found("robot/robot/node.py", "robot.drive.limits") == "robot/robot/drive/limits.py"


def test_all_that_the_imports_of_a_module_lead_to():
    workspace = Workspace(
        *ROBOT,
        robot__node="import robot.drive.motor\nimport numpy",
        robot__drive__motor="def run():\n    if True:\n        from . import limits",
        robot__drive__limits="class Limits:\n    from ..node import LOW",
    )
    paths = {file.relative for file in ROBOT}
    assert workspace.index.imported_by(workspace.module("robot/robot/node.py")) == paths
    of_limits = workspace.index.imported_by(workspace.module("robot/robot/drive/limits.py"))
    assert "robot/robot/drive/motor.py" in of_limits, "through the node, round in a circle"
    assert workspace.index.imported_by(workspace.module("robot/robot/__init__.py")) == {"robot/robot/__init__.py"}


def test_the_modules_that_were_run_are_in_the_order_of_their_paths():
    workspace = Workspace(*ROBOT)
    for path in ("robot/robot/node.py", "robot/robot/drive/motor.py"):
        with workspace.index.first_import(workspace.module(path)):
            pass
    workspace.module("robot/robot/drive/limits.py")
    loaded = [module.path for module in workspace.index.loaded()]
    assert loaded == ["robot/robot/drive/motor.py", "robot/robot/node.py"]
