"""What the code of launch files, manifests and entry points says, asked of a whole workspace."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from archlint.analysis.cpp_nodes import names_cpp_node
from archlint.analysis.ignored import words_ignored_at
from archlint.config.settings import Settings
from archlint.engine.pipeline import Request, graph
from archlint.launch_files.launch_code import has_action_for, may_read_argument, words_of_launch_code, writes_files
from archlint.launch_files.missing_files import names_beside
from archlint.packaging.entry_points import NoFunction, NoFunctionNamed, NoModule, broken_target
from archlint.packaging.imports import imports_at_start
from archlint.packaging.manifests import package_around
from archlint.place import Place
from archlint.systems.model import WorkspaceIndex
from archlint.workspace.installed import Executable
from robot_package import TALKER, write_robot

LAUNCH = "launch/it.launch.py"
Index = Callable[..., WorkspaceIndex]


@pytest.fixture
def index(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Index:
    monkeypatch.chdir(tmp_path)

    def of(**files: str) -> WorkspaceIndex:
        write_robot(tmp_path, **files)
        workspace = graph(Request((".",), Settings(), cached=False, jobs=1)).workspace
        assert workspace is not None
        return workspace

    return of


def launch(body: str) -> dict[str, str]:
    return {LAUNCH: f"def generate_launch_description():\n    {body}\n    return []\n"}


@pytest.mark.parametrize(
    ("body", "writes"),
    [
        ("open('a.yaml', 'w').write('x')", True),
        ("open('a.yaml', mode='a')", True),
        ("Path('a.yaml').write_text('x')", True),
        ("shutil.copy('a', 'b')", True),
        ("open('a.yaml')", False),
        ("open('a.yaml', 'r')", False),
    ],
)
def test_a_launch_file_that_may_write_files(index: Index, body: str, writes: bool):
    assert writes_files(index(**launch(body)), LAUNCH) is writes


@pytest.mark.parametrize(
    ("body", "reads"),
    [
        ("a = get('speed')", True),
        ("a = '$(var speed)'", True),
        ("a = {'speed': 1}", False),  # a key
        ("a = Node(name='speed')", False),  # the name of a node
        ("a = Node(parameters=[{'unit': 'speed'}])", False),  # the value of a parameter
        ("a = Node(parameters=[{'unit': LaunchConfiguration('speed')}])", True),
        ("a = Node(parameters=[dict(unit=get('speed'))])", True),
        ("a = Node(arguments=['-topic', 'speed'])", False),
        ("a = Node(remappings=[('in', 'speed')])", False),
        ("a = ExecuteProcess(cmd=['ros2', 'topic', 'echo', 'speed'])", False),
        ("a = ExecuteProcess(cmd=['echo', LaunchConfiguration('speed')])", True),
        ("a = IncludeLaunchDescription(s, launch_arguments={'unit': 'speed'}.items())", False),
        ("a = IncludeLaunchDescription(s, launch_arguments=[('unit', 'speed')])", False),
        ("a = [LaunchConfiguration(n) for n in ('map', 'speed')]", True),
        ("a = 'speed limit'", False),
    ],
)
def test_code_that_may_read_an_argument(index: Index, body: str, reads: bool):
    assert may_read_argument(index(**launch(body)), LAUNCH, "speed") is reads


@pytest.mark.parametrize(
    ("name", "text", "reads"),
    [
        ("it.launch.xml", "<launch><let name='v' value='$(var speed)'/></launch>\n", True),
        ("it.launch.xml", "<launch><arg name='speed' default='1'/></launch>\n", False),
        ("it.launch.yaml", "launch: [{'let': {'name': 'v', 'value': '$(var speed)'}}]\n", True),
        # A text of YAML, and of Python, too.
        ("it.launch.yaml", "launch: [{'let': {'name': 'v', 'value': 'speed'}}]\n", False),
    ],
)
def test_launch_files_that_are_no_python_are_read_as_texts(index: Index, name: str, text: str, reads: bool):
    assert may_read_argument(index(**{f"launch/{name}": text}), f"launch/{name}", "speed") is reads


def test_words_of_launch_files_and_actions_for_them(index: Index):
    actions = "import launch_ros\nEXECUTABLE = 'heavy'\n"
    workspace = index(**launch("a = 'ros2 run robot talker'"), **{"robot/actions.py": actions})
    assert words_of_launch_code(workspace) == [frozenset({"ros2 run robot talker"})]
    assert has_action_for(workspace, "robot", "heavy")
    assert not has_action_for(workspace, "robot", "light")


@pytest.mark.parametrize(
    ("module", "function", "wrong"),
    [
        ("robot.talker", "main", None),
        ("uvicorn.main", "run", None),  # another distribution's
        ("robot.tlker", "main", NoModule("robot.tlker", "main", ("robot.talker",))),
        ("robot.talker", None, NoFunctionNamed("robot.talker", ("main",))),
        ("robot.talker", "mian.x", "mian"),
    ],
)
def test_the_target_of_an_entry_point(index: Index, module: str, function: str | None, wrong: object):
    place = Place("setup.py", 6, 1, 6, 9)
    found = broken_target(index(), Executable("talker", "robot", place, module, function))
    assert (found.function if isinstance(found, NoFunction) else found) == wrong


def test_a_module_that_binds_names_which_stand_nowhere(index: Index):
    workspace = index(**{"robot/talker.py": TALKER + "\nfrom elsewhere import *\n"})
    place = Place("setup.py", 6, 1, 6, 9)
    assert broken_target(workspace, Executable("talker", "robot", place, "robot.talker", "start")) is None


def test_the_imports_that_always_run(index: Index):
    guarded = "try:\n    import h\nexcept ImportError:\n    pass\n"
    text = f"import rclpy.node\nfrom c import d, e as f\nfrom . import g\n{guarded}"
    found = [one for one in imports_at_start(index(**{"robot/talker.py": text})) if one.file.module == "robot.talker"]
    assert [(one.module, one.names, one.place.line) for one in found] == [("rclpy.node", (), 1), ("c", ("d", "e"), 2)]


def test_the_manifest_around_a_folder(index: Index):
    workspace = index(**{"inner/package.xml": "<package>", "inner/a/b.py": ""})
    package = package_around(workspace, "robot")
    assert package is not None and package.name == "robot"
    assert package_around(workspace, "inner/a") is None  # a manifest that makes no package


def test_the_names_beside_a_missing_file(index: Index):
    workspace = index(**{"config/a.yaml": "", "config/deep/b.yaml": ""})
    assert names_beside(workspace, "robot", "config/gone.yaml") == ["a.yaml"]
    assert names_beside(workspace, "elsewhere", "config/gone.yaml") == []


def test_a_node_of_a_source_in_cpp(index: Index):
    workspace = index(
        **{"src/a.cpp": '#include "rclcpp/rclcpp.hpp"\nNode("driver")\n', "src/b.cpp": 'Thing("other")\n'}
    )
    assert names_cpp_node(workspace, "config/a.yaml", "driver")
    assert not names_cpp_node(workspace, "config/a.yaml", "other")  # no node is made there


def test_what_a_comment_keeps_quiet(index: Index):
    workspace = index(**{"robot/talker.py": "import a  # archlint: ignore[PKG001, undeclared]\nimport b\n"})
    assert words_ignored_at(workspace, Place("robot/talker.py", 1, 1, 1, 9)) == ["PKG001", "undeclared"]
    assert words_ignored_at(workspace, Place("robot/talker.py", 2, 1, 2, 9)) == []


@pytest.mark.parametrize(
    ("path", "text", "lines"),
    [
        ("config/a.yaml", "talker:\n  ros__parameters:\n    rate: 5\t# Hz\n", []),
        ("config/a.yaml", "launch:\n- node: {pkg: robot, exec: talker}\t# of the arm\n", [2]),
        ("launch/a.launch.yaml", "launch:\n- node: {pkg: robot, exec: talker}\t# of the arm\n", [2]),
    ],
)
def test_a_parameter_file_is_not_read_as_launch_reads_it(index: Index, path: str, text: str, lines: list[int]):
    """PyYAML refuses a tab before a comment, and rcl, for which a parameter file is, does not."""
    files = index(**{path: text}).launch_files
    assert not files.can_be_launched(path)
    files.parameters(path)
    assert [problem.line for problem in files.problems()] == lines
