"""LCH004: files that a launch file names and that are not where it looks."""

from __future__ import annotations

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.packaging import generated_files
from robot_package import CMAKE, CMAKE_TESTS, MANIFEST, SETUP, TALKER, manifest, node, write_files, write_robot


@pytest.mark.parametrize(
    ("default", "also", "spare"),
    [
        ("false", "", True),
        ("true", "", False),
        ("false", '<include file="$(find-pkg-share robot)/launch/db.launch.xml"/>', False),
    ],
)
def test_a_file_that_only_another_argument_needs(findings, default: str, also: str, spare: bool):
    included = '<include file="$(find-pkg-share robot)/launch/db.launch.xml" if="$(var db)"/>'
    (found, *_) = findings("LCH004", f'<arg name="db" default="{default}"/>{included}\n{also}')
    assert found.message.startswith("package 'robot' has no launch file 'launch/db.launch.xml'")
    assert found.message.endswith("; with the default arguments nothing needs it") is spare


@pytest.mark.parametrize(
    ("line", "found"), [("", 1), ("open(path, 'w').write('x')", 0), ("shutil.copy('a', path)", 0), ("open(path)", 1)]
)
def test_a_file_that_the_launch_file_may_make(findings, line, found):
    launch = f"""\
import os, shutil
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    path = os.path.join(get_package_share_directory('robot'), 'config', 'made.yaml')
    {line}
    return LaunchDescription([Node(package='robot', executable='talker', parameters=[path])])
"""
    assert len(findings("LCH004", **{"launch/py.launch.py": launch})) == found


@pytest.mark.parametrize(
    ("code", "found"),
    [
        ("robot = xacro.process_file(path, mappings={'arm': 'left'}).toxml()", 1),
        ("robot = xacro.process(path)", 1),
        ("try:\n        robot = xacro.process_file(path)\n    except OSError:\n        pass", 0),
        ("robot = somewhere.process_file(path)", 0),
    ],
)
def test_a_robot_that_xacro_is_given(findings, code, found):
    launch = f"""\
import os, somewhere, xacro
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    path = os.path.join(get_package_share_directory('robot'), 'config', 'arm.urdf.xacro')
    {code}
    return LaunchDescription([Node(package='robot', executable='talker')])
"""
    assert len(findings("LCH004", **{"launch/py.launch.py": launch})) == found


def test_a_missing_file_behind_the_block_that_every_package_copies(findings):
    cmake = "project(robot)\ninstall(DIRECTORY launch DESTINATION share/robot)\n" + CMAKE_TESTS
    files = {"CMakeLists.txt": cmake, "package.xml": CMAKE, "setup.py": "", "config/talk.yaml": ""}
    for written, message in (("config/talk.yaml", "does not install"), ("config/tolk.yaml", "has no parameter file")):
        inner = f'<param from="$(find-pkg-share robot)/{written}"/>'
        (found,) = findings("LCH004", node(inner), **files)
        assert message in found.message
    whole = cmake.replace("DIRECTORY launch", "DIRECTORY launch config")
    inner = '<param from="$(find-pkg-share robot)/config/talk.yaml"/>'
    assert findings("LCH004", node(inner), **{**files, "CMakeLists.txt": whole}) == []


@pytest.mark.parametrize(
    ("folders", "said"),
    [
        (
            "launch",
            "package 'robot' does not install the parameter file 'src/config/talk.yaml', which is looked for as "
            "'config/talk.yaml'",
        ),
        ("launch config", None),  # the build stops, and PKG004 says that src/config is meant
        ("launch src/config", None),
    ],
)
def test_a_path_that_is_right_once_the_folder_is_installed(findings, folders: str, said: str | None):
    cmake = f"project(robot)\ninstall(DIRECTORY {folders} DESTINATION share/robot)\nament_package()\n"
    files = {"CMakeLists.txt": cmake, "package.xml": CMAKE, "setup.py": "", "src/config/talk.yaml": ""}
    told = findings("LCH004", node('<param from="$(find-pkg-share robot)/config/talk.yaml"/>'), **files)
    assert [one.message for one in told] == ([said] if said else [])
    assert all("install src/config as config (" in (one.help or "") for one in told)
    other = findings("LCH004", node('<param from="$(find-pkg-share robot)/config/tall.yaml"/>'), **files)
    assert [one.message for one in other] == ["package 'robot' has no parameter file 'config/tall.yaml'"]


@pytest.mark.parametrize(
    ("folders", "path", "told"),
    [
        ("launch config", "config/talk.yaml", 0),  # the build stops, and PKG004 says so
        ("launch config", "config/deep/talk.yaml", 0),
        ("launch config/deep", "config/deep/talk.yaml", 0),
        ("launch config/deep", "config/talk.yaml", 1),
        ("launch", "config/talk.yaml", 1),
    ],
)
def test_a_folder_that_the_build_lists_and_that_is_not_there(findings, folders: str, path: str, told: int):
    cmake = f"project(robot)\ninstall(DIRECTORY {folders} DESTINATION share/robot)\nament_package()\n"
    files = {"CMakeLists.txt": cmake, "package.xml": CMAKE, "setup.py": ""}
    launch = node(f'<param from="$(find-pkg-share robot)/{path}"/>')
    assert len(findings("LCH004", launch, **files)) == told
    assert len(findings("PKG004", launch, **files)) == (folders != "launch")


def test_one_file_that_is_looked_for_in_two_folders(findings):
    """No one line installs it into both."""
    cmake = "project(robot)\ninstall(DIRECTORY launch DESTINATION share/robot)\nament_package()\n"
    files = {"CMakeLists.txt": cmake, "package.xml": CMAKE, "setup.py": "", "views/talk.yaml": ""}
    paths = [f'<param from="$(find-pkg-share robot)/{path}"/>' for path in ("views/talk.yaml", "talk.yaml")]
    as_it_lies, at_the_top = findings("LCH004", "".join(map(node, paths)), **files)
    assert as_it_lies.help == "install views/talk.yaml (data_files in setup.py, install(DIRECTORY …) in CMake)"
    assert at_the_top.help.startswith("install views/talk.yaml into the share folder itself (")


@pytest.mark.parametrize(("robot", "told"), [("", 0), ("turtle", 1)])
def test_a_folder_that_whoever_launches_it_has_to_name(findings, robot: str, told: int):
    argument = f'<arg name="model" default="{robot}"/>'
    inner = '<param from="$(find-pkg-share robot)/robots/$(var model)/ekf.yaml"/>'
    assert len(findings("LCH004", argument + node(inner))) == told


@pytest.mark.parametrize(
    ("others", "said"), [(["arm"], "; 'arm' has a file of that path"), (["arm", "leg"], ""), ([], "")]
)
def test_a_file_that_another_package_has(tmp_path, monkeypatch, others: list[str], said: str):
    monkeypatch.chdir(tmp_path)
    inner = '<param from="$(find-pkg-share robot)/config/grip.yaml"/>'
    write_robot(tmp_path / "robot", node(inner))
    for name in others:
        write_files(tmp_path / name, {"package.xml": manifest(name), "config/grip.yaml": ""})
    write_files(tmp_path, {"archlint.toml": 'select = ["LCH004"]'})
    (told,) = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert told.help == f"check the path; it is relative to the package's installed share folder{said}"


def test_files_of_other_packages_are_not_looked_for(findings):
    assert findings("LCH004", '<include file="$(find-pkg-share nav2_bringup)/launch/x.launch.py"/>') == []


@pytest.mark.parametrize(
    ("written", "hint"),
    [
        ("launch/robt.launch.xml", "; did you mean 'robot.launch.xml'?"),
        ("launch/robot.launch.yml", "; did you mean 'robot.launch.xml'?"),
        ("launch/nope.launch.xml", ""),
        ("launch/camera.launch.xml", ""),
    ],
)
def test_a_missing_file_is_named_with_the_near_one_beside_it(findings, written, hint):
    include = f'<include file="$(find-pkg-share robot)/{written}"/>'
    (found,) = findings("LCH004", include, **{"launch/robot.launch.xml": "<launch/>"})
    assert found.message == f"package 'robot' has no launch file '{written}'{hint}"


@pytest.mark.parametrize(("there", "near"), [("arm.srdf", ""), ("arms.urdf", "; did you mean 'arms.urdf'?")])
def test_what_moveit_is_given_is_no_description_of_a_robot(findings, there: str, near: str):
    load = '<param name="robot_description" value="$(command \'xacro $(find-pkg-share robot)/urdf/arm.urdf\')"/>'
    (found,) = findings("LCH004", node(load), **{f"urdf/{there}": "<robot/>"})
    assert found.message == f"package 'robot' has no file 'urdf/arm.urdf'{near}"


def test_what_names_the_missing_file_is_not_proposed(findings):
    include = '<launch><include file="$(find-pkg-share robot)/launch/{}"/></launch>'.format
    files = {"launch/robot_demos.launch.xml": include("robot_demo.launch.xml")}  # it would include itself
    (found,) = findings("LCH004", **files)
    assert found.message == "package 'robot' has no launch file 'launch/robot_demo.launch.xml'"
    files["launch/robot_demo2.launch.xml"] = include("robot_demo.launch.xml")  # neither is the other's
    (found,) = findings("LCH004", **files)
    assert "did you mean" not in found.message
    files["launch/robt_demo.launch.xml"] = "<launch/>"
    (found,) = findings("LCH004", **files)
    assert found.message.endswith("did you mean 'robt_demo.launch.xml'?")


def test_a_missing_file_is_told_once_however_many_launch_files_name_it(findings):
    include = '<launch><include file="$(find-pkg-share robot)/launch/{}"/></launch>'.format
    files = {f"launch/{name}.launch.xml": include("base.launch.xml") for name in ("arm", "base_and_arm")}
    files["launch/other.launch.xml"] = include("camera.launch.xml")
    base, camera = findings("LCH004", **files)
    assert [one.place.file for one in (base, *base.related)] == [
        "launch/arm.launch.xml",
        "launch/base_and_arm.launch.xml",
    ]
    assert (camera.place.file, camera.related) == ("launch/other.launch.xml", ())


def test_the_files_of_a_folder_that_is_not_there_are_told_once(findings):
    load = '<param from="$(find-pkg-share robot)/{}"/>'.format
    launch = node("".join(map(load, ["params/a.yaml", "params/b.yaml", "config/c.yaml", "config/d.yaml"])))
    folder, *files = findings("LCH004", launch, **{"config/p.yaml": "talker: {}"})
    assert folder.message == ("package 'robot' has no folder 'params' with these 2 files: params/a.yaml, params/b.yaml")
    assert [row.message for row in folder.related] == ["'params/b.yaml' is named here"]
    assert [one.message for one in files] == [  # the folder is right: each name is wrong for itself
        "package 'robot' has no parameter file 'config/c.yaml'",
        "package 'robot' has no parameter file 'config/d.yaml'",
    ]


def test_the_files_of_a_folder_that_is_not_installed_are_told_once(findings):
    load = '<param from="$(find-pkg-share robot)/{}"/>'.format
    launch = node("".join(map(load, ["params/a.yaml", "params/b.yaml", "more/c.yaml"])))
    files = dict.fromkeys(["params/a.yaml", "params/b.yaml", "more/c.yaml"], "talker: {}")
    params, more = findings("LCH004", launch, **files)
    assert params.message == "package 'robot' does not install these 2 files: params/a.yaml, params/b.yaml"
    assert more.message == "package 'robot' does not install the parameter file 'more/c.yaml'"


@pytest.mark.parametrize(
    ("there", "hint"),
    [
        ("new_robot_in_simulation_grasp_it_demo.launch.xml", False),  # alike only in how all of them begin
        ("new_robot_in_simulation_workcel.launch.xml", True),
        ("new_robt_in_simulation_workcell.launch.xml", True),
    ],
)
def test_how_all_files_of_a_folder_begin_makes_no_two_alike(findings, there: str, hint: bool):
    include = '<include file="$(find-pkg-share robot)/launch/new_robot_in_simulation_workcell.launch.xml"/>'
    (found,) = findings("LCH004", include, **{f"launch/{there}": "<launch/>"})
    assert (f"did you mean '{there}'?" in found.message) is hint


def test_a_file_that_is_there_but_not_installed(findings):
    (found,) = findings(
        "LCH004", '<include file="$(find-pkg-share robot)/more/x.launch.xml"/>', **{"more/x.launch.xml": "<launch/>"}
    )
    assert "does not install the launch file 'more/x.launch.xml'" in found.message


def test_a_file_that_is_installed_elsewhere(findings):
    load = '<param from="$(find-pkg-share robot)/more/a.yaml"/>'
    setup = SETUP.replace("glob('config/*'))", "glob('config/*')), ('share/more', ['more/a.yaml'])")
    (told,) = findings("LCH004", node(load), **{"setup.py": setup, "more/a.yaml": "talker: {}"})
    assert told.message == "package 'robot' does not install the parameter file 'more/a.yaml'"
    assert told.help == "the build puts it into 'share/more/a.yaml'; it is looked for in 'share/robot/more/a.yaml'"


LAUNCHES = '<executable cmd="ros2 launch robot deep.launch.xml"/>'


DEEP = SETUP.replace("glob('config/*'))", "glob('config/*')), ('share/robot/more/helpers', glob('helpers/*.xml'))")


@pytest.mark.parametrize(
    ("files", "told"),
    [
        ({"setup.py": DEEP, "helpers/deep.launch.xml": "<launch/>"}, ""),  # ros2 launch looks in all folders
        ({"launch/deep.launch.xml": "<launch/>"}, ""),
        ({"setup.py": DEEP, "helpers/deep.launch.xml": "<launch/>", "launch/deep.launch.xml": "<launch/>"}, ""),
        ({"helpers/deep.launch.xml": "<launch/>"}, "does not install the launch file 'helpers/deep.launch.xml'"),
        ({"setup.py": DEEP, "helpers/deeper.launch.xml": "<launch/>"}, "has no launch file 'launch/deep.launch.xml'"),
    ],
)
def test_a_launch_file_that_a_command_names(findings, files: dict[str, str], told: str):
    messages = [found.message for found in findings("LCH004", LAUNCHES, **files)]
    assert len(messages) == (1 if told else 0)
    assert all(told in message for message in messages)


GIVES = """\
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.launch_description_sources import AnyLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration

def generate_launch_description():
    share = get_package_share_directory('robot')
    def inner(name, file):
        return IncludeLaunchDescription(AnyLaunchDescriptionSource(share + '/launch/' + name),
                                        launch_arguments={'params': file}.items())
    return LaunchDescription([
        DeclareLaunchArgument('file', default_value=os.path.join(share, 'config', 'gone.yaml')),
        inner('one.launch.xml', LaunchConfiguration('file')),
        inner('two.launch.xml', LaunchConfiguration('file')),
        inner('two.launch.xml', os.path.join(share, 'config', 'lost.yaml')),
    ])
"""


def test_a_missing_file_is_told_where_it_is_named(findings):
    """The files that use it name none: what they are given has a default, or is written in the include."""
    arg = '<arg name="params" default="$(find-pkg-share robot)/config/good.yaml"/>'
    inner = "<launch>" + arg + "\n" + node('<param from="$(var params)"/>') + "</launch>"
    files = {"launch/one.launch.xml": inner, "launch/two.launch.xml": inner, "config/good.yaml": ""}
    outer = {"launch/outer.launch.py": GIVES}
    gone, lost = findings("LCH004", **files, **outer)
    rows = [(one.place.file, one.place.line, one.message.rpartition(" ")[2]) for one in (gone, lost)]
    assert rows == [
        ("launch/outer.launch.py", 14, "'config/gone.yaml'"),
        ("launch/outer.launch.py", 17, "'config/lost.yaml'"),
    ]
    uses = [[(one.place.file, one.place.line) for one in found.related] for found in (gone, lost)]
    assert uses == [[("launch/one.launch.xml", 2), ("launch/two.launch.xml", 2)], [("launch/two.launch.xml", 2)]]
    there = {"config/gone.yaml": "", "config/lost.yaml": ""}
    assert findings("LCH004", **files, **outer, **there) == []


def test_a_variable_for_a_missing_file_is_told_once(findings):
    text = """\
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    view = os.path.join(get_package_share_directory('robot'), 'config', 'view.rviz')
    return LaunchDescription([
        Node(package='rviz2', executable='rviz2', name='one', arguments=['-d', view]),
        Node(package='rviz2', executable='rviz2', name='two', arguments=['-d', view])])
"""
    (found,) = findings("LCH004", **{"launch/py.launch.py": text})
    assert (found.place.line, [one.place.line for one in found.related]) == (7, [9, 10])


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        ("['-d', view] if os.path.exists(view) else []", 0),  # RViz starts without it
        ("['-d', view] if os.environ.get('SHOWN') else []", 1),
        ("['-d', view]", 1),
    ],
)
def test_a_file_on_the_command_line_only_where_it_is(findings, arguments: str, told: int):
    text = f"""\
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    view = os.path.join(get_package_share_directory('robot'), 'config', 'view.rviz')
    return LaunchDescription([Node(package='rviz2', executable='rviz2', arguments={arguments})])
"""
    assert len(findings("LCH004", **{"launch/py.launch.py": text})) == told


@pytest.mark.parametrize(("excluded", "told"), [("plain", 0), ("other", 1)])
def test_a_file_named_by_the_default_with_which_nothing_reads_it(findings, excluded: str, told: int):
    text = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution, PythonExpression
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare

def start(context):
    view = LaunchConfiguration('view').perform(context)
    file = PathJoinSubstitution([FindPackageShare('robot'), 'config', f'{view}.rviz'])
    shown = IfCondition(PythonExpression(f"'{view}' != 'EXCLUDED'"))
    return [Node(package='rviz2', executable='rviz2', arguments=['-d', file], condition=shown)]

def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('view', default_value='plain'), OpaqueFunction(function=start)])
"""
    assert len(findings("LCH004", **{"launch/py.launch.py": text.replace("EXCLUDED", excluded)})) == told


PASSING = """\
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

def generate_launch_description():
    folder = get_package_share_directory('robot')
    defaults = {'table': os.path.join(folder, 'state', 'table.csv')}
    passed = {name: LaunchConfiguration(name) for name in defaults}
    return LaunchDescription([
        *[DeclareLaunchArgument(name, default_value=default) for name, default in defaults.items()],
        Node(package='robot', executable='talker', parameters=[passed])])
"""
READING = TALKER.replace(
    "super().__init__('talker')", "super().__init__('talker'); self.declare_parameter('table', '')"
)


def test_a_path_that_a_parameter_gets_from_an_argument_is_told_where_it_is_made(findings):
    (finding,) = findings("LCH004", **{"launch/py.launch.py": PASSING, "robot/talker.py": READING})
    assert "'state/table.csv'" in finding.message
    assert PASSING.splitlines()[finding.place.line - 1].startswith("    defaults =")


@pytest.mark.parametrize(
    ("code", "told"),
    [
        ("if os.path.exists(path): load(path)", 0),
        ("if pathlib.Path(path).is_file(): load(path)", 0),
        ("load(path)", 1),
    ],
)
def test_a_file_that_the_node_may_do_without(findings, code: str, told: int):
    reading = f"import os, pathlib\n\ndef state(path):\n    {code}\n\n{READING}"
    assert len(findings("LCH004", **{"launch/py.launch.py": PASSING, "robot/talker.py": reading})) == told
    model = PASSING.replace("table.csv", "arm.urdf")  # what a node cannot do without
    assert len(findings("LCH004", **{"launch/py.launch.py": model, "robot/talker.py": reading})) == 1


@pytest.mark.parametrize(("name", "told"), [("", 0), ("talk.yaml", 1)])
def test_an_argument_with_the_name_of_a_file_that_is_empty_until_it_is_given(findings, name: str, told: int):
    path = "$(find-pkg-share robot)/$(var file)"
    argument = f'<arg name="file" default="{name}"/>'
    cmake = "project(robot)\ninstall(DIRECTORY launch DESTINATION share/robot)\n" + CMAKE_TESTS
    files = {"CMakeLists.txt": cmake, "package.xml": CMAKE, "setup.py": ""}
    assert len(findings("LCH004", argument + node(f'<param from="{path}"/>'), **files)) == told
    assert len(findings("LCH004", argument + f'<include file="{path}"/>', **files)) == told


@pytest.mark.parametrize(
    ("command", "told"),
    [
        ('xacro_add_files("urdf/robot.urdf.xacro" INSTALL DESTINATION urdf/)', 0),
        ('xacro_add_files("hands/left.urdf.xacro" INSTALL DESTINATION hands/)', 1),
        ("", 1),
    ],
)
def test_a_file_that_a_command_of_another_package_may_make(findings, command: str, told: int):
    cmake = (
        f"project(robot)\nfind_package(xacro REQUIRED)\n{command}\ninstall(DIRECTORY launch DESTINATION share/robot)\n"
    )
    files = {"CMakeLists.txt": cmake, "package.xml": CMAKE, "setup.py": "", "urdf/robot.urdf.xacro": "<robot/>"}
    launch = node('<param name="file" value="$(find-pkg-share robot)/urdf/robot.urdf"/>')
    assert len(findings("LCH004", launch, **files)) == told


@pytest.mark.parametrize(
    ("test", "told"),
    [
        ("if os.path.exists(path):", 0),
        ("if os.path.isfile(path):", 0),
        ("if Path(path).exists():", 0),
        ("if os.path.exists(os.path.dirname(path)):", 1),  # another path
        ("if os.environ.get('CONFIGURED'):", 1),
        ("if not os.path.exists(path):\n        raise RuntimeError(path)\n    if True:", 1),  # it cannot do without
    ],
)
@pytest.mark.parametrize("use", ["parameters = [path]", "talkers = [Node(**talker, parameters=[path])]"])
def test_a_file_that_is_used_only_where_it_is(findings, test: str, told: int, use: str):
    text = f"""\
import os
from pathlib import Path
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    path = os.path.join(get_package_share_directory('robot'), 'config', 'perhaps.yaml')
    talker = dict(package='robot', executable='talker')
    parameters, talkers = [], []
    {test}
        {use}
    return LaunchDescription([Node(**talker, parameters=parameters), *talkers])
"""
    assert len(findings("LCH004", **{"launch/py.launch.py": text})) == told


@pytest.mark.parametrize(
    ("there", "hint"),
    [
        ("params_multi_robot_1.yaml", True),
        ("multirobot_1_params.yaml", True),
        ("params_multi_robot_2.yaml", False),  # the other robot's
        ("params_robot_1.yaml", False),
    ],
)
def test_a_file_whose_words_stand_in_another_order(findings, there: str, hint: bool):
    inner = '<param from="$(find-pkg-share robot)/config/multirobot_params_1.yaml"/>'
    (found,) = findings("LCH004", node(inner), **{f"config/{there}": ""})
    assert (f"did you mean '{there}'?" in found.message) is hint


IN_SHARE = "folder = get_package_share_directory('robot')\n"
WRITES = "with open(os.path.join(folder, 'made.yaml'), 'w') as file:\n    file.write(text)\n"


@pytest.mark.parametrize(
    ("files", "told"),
    [
        ({"robot/make.py": WRITES}, 0),
        ({"robot/make.py": "(folder / 'made.yaml').write_text(text)\n"}, 0),
        ({"templates/made.yaml.j2": ""}, 0),
        ({"templates/made.xacro": ""}, 0),
        ({"src/make.cpp": 'std::ofstream file(folder + "/made.yaml");\n'}, 0),
        ({"src/make.cpp": 'std::ifstream file(folder + "/made.yaml");\n'}, 1),
        ({"src/make.cpp": 'system("map_saver_cli -f " + share + "/config/temp/made");\n'}, 0),
        ({"src/make.cpp": 'system("map_saver_cli -f " + share + "/config/temp/other");  // not made.yaml\n'}, 1),
        ({"robot/make.py": "client.call(SaveMap.Request(map_url=folder + '/made'))\n"}, 0),
        ({"robot/make.py": "read(folder + '/made')\n"}, 1),
        ({"robot/make.py": WRITES.replace("'w'", "'r'")}, 1),  # who reads it does not make it
        ({"robot/make.py": WRITES.replace("made.yaml", "premade.yaml")}, 1),
        ({"robot/make.py": WRITES, "config/temp/other.yaml": ""}, 1),  # the folder is there: what is kept there is, too
        (
            {"robot/make.py": f"folder = get_package_share_directory('robot')\n{WRITES}", "config/temp/other.yaml": ""},
            0,
        ),
        ({}, 1),
    ],
)
def test_a_file_that_something_here_writes(findings, files: dict[str, str], told: int):
    inner = '<param from="$(find-pkg-share robot)/config/temp/made.yaml"/>'
    assert len(findings("LCH004", node(inner), **files)) == told


def test_a_file_that_is_missing_beside_the_launch_file_says_where_it_is_looked_for(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    include = """<launch><include file="$(dirname)/gone.launch.xml"/></launch>"""
    texts = {"setup.py": SETUP, "robot/talker.py": TALKER, "launch/it.launch.xml": include}
    texts["package.xml"] = MANIFEST.format(name="robot", type="ament_python", more="")
    for name, text in texts.items():
        (tmp_path / "src/robot" / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "src/robot" / name).write_text(text)
    (tmp_path / "archlint.toml").write_text('select = ["LCH004"]')
    (found,) = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert found.message == "package 'robot' has no launch file 'launch/gone.launch.xml'"
    assert "relative to the installed folder of this launch file" in found.help


# ------------------------------------------------------------------------- files that are named in other places

SHARE = "$(find-pkg-share robot)"
IN_PYTHON = """\
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch.substitutions import Command
from launch_ros.actions import Node

def generate_launch_description():
    share = get_package_share_directory('robot')
    path = os.path.join(share, 'urdf', 'robot.urdf')
    return LaunchDescription([{action}])
"""
EVERYWHERE = [
    "Node(package='robot', executable='talker', arguments=[path])",
    "Node(package='robot', executable='talker', parameters=[{'model': path}])",
    "Node(package='robot', executable='talker', parameters=[{'text': Command(['xacro ', path, ' a:=1'])}])",
    "ExecuteProcess(cmd=['gz', 'sim', path])",
    "Node(package='robot', executable='talker', parameters=[{'model': open(path).read()}])",
]


@pytest.mark.parametrize(
    ("beside", "told"),
    [
        ([], 1),  # the meshes have moved
        (["meshes/visual/base.stl"], 0),  # the mesh to look at, and the one to collide with
        (["meshes/visual/README.md", "meshes/collision/README.md"], 1),
    ],
)
def test_a_file_of_the_same_name_in_a_folder_that_goes_with_it(findings, beside: list[str], told: int):
    launch = '<node pkg="robot" exec="talker"><param name="mesh" value="package://robot/meshes/visual/arm.stl"/></node>'
    files = dict.fromkeys(["meshes/collision/arm.stl", "meshes/collision/base.stl", *beside], "solid\n")
    found = findings("LCH004", launch, **files)
    assert ["did you mean" in row.message for row in found] == [True] * told


@pytest.mark.parametrize(("name", "told"), [("script", 0), ("path", 1)])
def test_a_module_of_the_package_that_only_an_undeclared_parameter_names(findings, name: str, told: int):
    """PRM004 says that nothing takes the value; installing the module as data would mend nothing."""
    value = f'<param name="{name}" value="$(find-pkg-share robot)/robot/talker.py"/>'
    files = {
        "setup.py": SETUP.replace("    name='robot',\n", "    name='robot',\n    packages=['robot'],\n"),
        "robot/__init__.py": "",
        "robot/talker.py": TALKER.replace("declare_parameter('rate', 1.0)", "declare_parameter('path', '')"),
    }
    assert len(findings("LCH004", node(value), **files)) == told
    assert len(findings("PRM004", node(value), **files)) == 1 - told


@pytest.mark.parametrize("action", EVERYWHERE)
def test_a_file_wherever_it_is_named(findings, action):
    launch = {"launch/py.launch.py": IN_PYTHON.format(action=action)}
    (missing,) = findings("LCH004", **launch)
    assert missing.message == "package 'robot' has no file 'urdf/robot.urdf'"
    (left_out,) = findings("LCH004", **launch, **{"urdf/robot.urdf": ""})
    assert left_out.message == "package 'robot' does not install the file 'urdf/robot.urdf'"
    setup = SETUP.replace("data_files=[", "data_files=[('share/robot/urdf', glob('urdf/*')), ")
    assert findings("LCH004", **launch, **{"urdf/robot.urdf": "", "setup.py": setup}) == []


@pytest.mark.parametrize(
    "action",
    [
        "Node(package='robot', executable='talker', arguments=[path + '.png'])",
        "Node(package='robot', executable='talker', arguments=[path[:-5]])",
        "Node(package='robot', executable='talker', arguments=[f'--file={path}'])",
        "Node(package='robot', executable='talker', arguments=[os.path.join(share, os.environ['MODEL'], 'a.urdf')])",
        "ExecuteProcess(cmd=['touch', '/tmp/robot.urdf'])",
        "Node(package='robot', executable='talker', parameters=[{'map.output_file': path}])",
        "Node(package='robot', executable='talker', parameters=[{'model': open(path, 'w').write('')}])",
    ],
)
def test_a_path_that_need_not_be_there(findings, action):
    assert findings("LCH004", **{"launch/py.launch.py": IN_PYTHON.format(action=action)}) == []


@pytest.mark.parametrize(
    ("written", "told"),
    [
        ("path", []),
        ("os.path.join(share, 'urdf', 'arm.urdf')", ["urdf/robot.urdf"]),  # it writes another one
    ],
)
def test_a_file_that_the_launch_file_writes_with_xacro(findings, written: str, told: list[str]):
    read = "Node(package='robot', executable='talker', arguments=[path])"
    world = "ExecuteProcess(cmd=['gz', 'sim', os.path.join(share, 'worlds', 'hall.world')])"
    made = (
        f"import xacro\n    xacro.open_output({written}).write(xacro.process_file('robot.xacro').toxml())\n    return"
    )
    launch = IN_PYTHON.format(action=f"{read}, {world}").replace("return", made)
    messages = [each.message for each in findings("LCH004", **{"launch/py.launch.py": launch})]
    assert messages == [f"package 'robot' has no file '{file}'" for file in [*told, "worlds/hall.world"]]


def test_a_file_that_is_made_on_each_machine(findings):
    launch = {"launch/py.launch.py": IN_PYTHON.format(action=EVERYWHERE[0])}
    assert findings("LCH004", **launch, **{".gitignore": "*.urdf\n"}) == []


def test_what_git_ignores_is_read_once(findings, monkeypatch):
    read: list[str] = []
    patterns = generated_files.patterns_of
    monkeypatch.setattr(
        generated_files, "patterns_of", lambda folder, text: [read.append(folder), patterns(folder, text)][1]
    )
    launch = {f"launch/{name}.launch.py": IN_PYTHON.format(action=EVERYWHERE[0]) for name in ("first", "second")}
    assert findings("LCH004", **launch, **{".gitignore": "*.urdf\n"}) == []
    assert len(read) == 1


def test_a_file_that_is_opened_in_a_try(findings):
    action = EVERYWHERE[4].replace("open(path).read()", "read(path)")
    read = "def read(path):\n    try:\n        return open(path).read()\n    except OSError:\n        return ''\n\n\n"
    launch = IN_PYTHON.format(action=action).replace("def generate", f"{read}def generate")
    assert findings("LCH004", **{"launch/py.launch.py": launch}) == []


@pytest.mark.parametrize(
    ("launch", "files", "help"),
    [
        (node('<param from="config/talk.yaml"/>'), ["config/talk.yaml"], f"write {SHARE}/config/talk.yaml"),
        (node('<param from="talk.yaml"/>'), ["config/talk.yaml"], f"write {SHARE}/config/talk.yaml"),
        ('<include file="other.launch.xml"/>', ["launch/other.launch.xml"], f"write {SHARE}/launch/other.launch.xml"),
    ],
)
def test_a_relative_path(tmp_path, monkeypatch, launch, files, help):
    monkeypatch.chdir(tmp_path)
    texts = {"src/robot/launch/it.launch.xml": f"<launch>{launch}</launch>", "src/robot/setup.py": SETUP}
    texts |= {"src/robot/package.xml": MANIFEST.format(name="robot", type="ament_python", more="")}
    texts |= {"src/robot/robot/talker.py": TALKER, **{f"src/robot/{file}": "<launch/>" for file in files}}
    write_files(tmp_path, texts | {"archlint.toml": 'select = ["LCH004"]'})
    (finding,) = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert "has a relative path: it is looked for in the folder in which ros2 launch is started" in finding.message
    assert finding.help == help


@pytest.mark.parametrize(("folder", "count"), [("launch", 1), ("docker", 0)])
def test_a_relative_path_of_a_launch_file_that_is_started_where_it_lies(tmp_path, monkeypatch, folder, count):
    """No rule installs the second one: it runs in a container, in its own folder."""
    monkeypatch.chdir(tmp_path)
    given = node('<param from="./talk.yaml"/>')
    texts = {f"src/robot/{folder}/it.launch.xml": f"<launch>{given}</launch>", f"src/robot/{folder}/talk.yaml": ""}
    texts |= {"src/robot/package.xml": manifest(), "src/robot/setup.py": SETUP, "src/robot/robot/talker.py": TALKER}
    write_files(tmp_path, texts | {"archlint.toml": 'select = ["LCH004"]'})
    assert len(check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings) == count


RELATIVE_DEFAULT = """from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    params = LaunchConfiguration('params')
    return LaunchDescription([
        DeclareLaunchArgument('params', default_value='config/talk.yaml'),
        Node(package='robot', executable='talker', parameters=[params]),
    ])
"""


def test_a_relative_path_is_told_where_it_is_written(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    texts = {"src/robot/launch/it.launch.py": RELATIVE_DEFAULT, "src/robot/setup.py": SETUP}
    texts |= {"src/robot/package.xml": MANIFEST.format(name="robot", type="ament_python", more="")}
    texts |= {"src/robot/robot/talker.py": TALKER, "src/robot/config/talk.yaml": ""}
    write_files(tmp_path, texts | {"archlint.toml": 'select = ["LCH004"]'})
    (finding,) = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert "has a relative path" in finding.message
    assert finding.place.line == 10


@pytest.mark.parametrize("written", ["/opt/talk.yaml", "~/talk.yaml", "speak.yaml", "src/robot/config/talk.yaml"])
def test_a_path_from_somewhere_that_is_known(tmp_path, monkeypatch, written):
    monkeypatch.chdir(tmp_path)
    launch = f"<launch>{node(f'<param from={written!r}/>')}</launch>"
    texts = {"src/robot/launch/it.launch.xml": launch, "src/robot/config/talk.yaml": "", "src/robot/setup.py": SETUP}
    texts |= {"src/robot/package.xml": MANIFEST.format(name="robot", type="ament_python", more="")}
    write_files(tmp_path, texts | {"src/robot/robot/talker.py": TALKER, "archlint.toml": 'select = ["LCH004"]'})
    assert check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings == []


def include(file: str, *arguments: str) -> str:
    return f"<include file='{file}'>{''.join(arguments)}</include>"


def arg(name: str, path: str, at: str = "value") -> str:
    return f'<arg name="{name}" {at}="$(find-pkg-share robot)/{path}"/>'


@pytest.mark.parametrize(
    ("launch", "message"),
    [
        (arg("map", "halls/hall.yaml", "default"), "package 'robot' has no file 'halls/hall.yaml'"),
        (include("$(find-pkg-share nav2)/it.xml", arg("map", "halls/hall.yaml")), "has no file 'halls/hall.yaml'"),
        ('<let name="map" value="$(find-pkg-share robot)/halls/hall.yaml"/>', "has no file 'halls/hall.yaml'"),
        (arg("map", "config/mapp.yaml", "default"), "has no file 'config/mapp.yaml'; did you mean 'map.yaml'?"),
        (arg("slam_params_file", "config/slam.yaml", "default"), "has no file 'config/slam.yaml'"),
        (include("$(find-pkg-share nav2)/it.xml", arg("params_file", "config/nav2.yaml")), "file 'config/nav2.yaml'"),
        (arg("rvizconfig", "config/view.rviz", "default"), "has no file 'config/view.rviz'"),
    ],
)
def test_a_path_that_an_argument_gets(findings, launch, message):
    (finding,) = findings("LCH004", launch, **{"config/map.yaml": ""})
    assert message in finding.message


@pytest.mark.parametrize(
    "launch",
    [
        arg("map", "config/map.yaml", "default"),
        arg("map", "config/other.yaml", "default"),  # a node may write it there
        arg("save_to", "halls/hall.yaml", "default"),
        arg("params_file", "config/map.yaml", "default"),
        arg("output_params_file", "config/seen.yaml", "default"),
        arg("parameterless", "config/seen.yaml", "default"),
        arg("config", "config/seen.bin", "default"),
        '<arg name="map" default="$(find-pkg-share halls)/halls/hall.yaml"/>',
    ],
)
def test_a_path_of_an_argument_that_may_be_there(findings, launch):
    assert findings("LCH004", launch, **{"config/map.yaml": ""}) == []


def test_a_path_of_an_argument_to_another_folder_than_the_file_is_in(findings):
    launch, config = arg("map", "config/map.yaml", "default"), {"config/other.yaml": "", "config/halls/map.yaml": ""}
    (finding,) = findings("LCH004", launch, **config)
    assert finding.message == "package 'robot' has no file 'config/map.yaml'; did you mean 'config/halls/map.yaml'?"


@pytest.mark.parametrize(
    ("installed", "near", "said"),
    [
        ("launch", "config/halls/map.yaml", "; 'config/halls/map.yaml' is not installed either"),
        ("launch config", "config/halls/map.yaml", ""),
        ("launch config/halls", "halls/map.yaml", ""),  # where it is in the share folder
    ],
)
def test_a_file_that_is_meant_is_installed_or_to_be(findings, installed, near, said):
    cmake = f"project(robot)\ninstall(DIRECTORY {installed} DESTINATION share/robot)\nament_package()\n"
    files = {"CMakeLists.txt": cmake, "package.xml": CMAKE, "setup.py": "", "config/halls/map.yaml": ""}
    (finding,) = findings("LCH004", arg("map", "maps/map.yaml", "default"), **files)
    assert finding.message == f"package 'robot' has no file 'maps/map.yaml'; did you mean '{near}'?"
    assert finding.help.removeprefix("check the path; it is relative to the package's installed share folder") == said


@pytest.mark.parametrize("package", ["robott", "tracking_robot"])
def test_a_launch_file_is_not_told_to_include_itself(findings, package):
    line = include(f"$(find-pkg-share {package})/launch/it.launch.xml")
    assert findings("LCH004", line) == []


def test_a_path_of_an_argument_where_several_files_have_that_name(findings):
    launch, config = arg("map", "config/map.yaml", "default"), {"config/other.yaml": "", "config/halls/map.yaml": ""}
    assert findings("LCH004", launch, **config, **{"config/sheds/map.yaml": ""}) == []


def test_a_world_that_the_build_makes_of_a_template(findings):
    world = arg("world", "worlds/dock.world", "default")
    assert findings("LCH004", world, **{"worlds/dock.world.xacro": "", "worlds/a.world.xacro": ""}) == []
    assert len(findings("LCH004", arg("world", "worlds/lake.world", "default"))) == 1


@pytest.mark.parametrize(
    ("package", "end"),
    [("robo", "; did you mean 'robot'?"), ("your_robot", "")],
)
def test_a_share_folder_of_no_package(findings, package, end):
    line = include(f"$(find-pkg-share {package})/launch/all.launch.xml")
    there = {"launch/all.launch.xml": "<launch/>"} if end else {}
    (finding,) = findings("LCH004", line, **there)
    assert finding.message == (
        f"there is no package '{package}', in which this looks for the launch file 'launch/all.launch.xml'{end}"
    )


def test_a_share_folder_of_a_package_from_elsewhere_that_is_called_nearly_like_one_here(findings):
    """A package that is installed beside the workspace may be called ``xrobot``: this one lacks the file."""
    line = include("$(find-pkg-share xrobot)/launch/all.launch.xml")
    assert findings("LCH004", line, **{"launch/other.launch.xml": "<launch/>"}) == []


def test_a_share_folder_of_no_package_with_a_file_of_this_one(findings):
    line = include("$(find-pkg-share old_machine)/config/arm.launch.xml")
    (finding,) = findings("LCH004", line, **{"config/arm.launch.xml": "<launch/>"})
    assert finding.help == "write 'robot'"
    fetched = {"robot.repos": "repositories:\n  old_machine:\n    type: git\n"}
    assert findings("LCH004", line, **{"config/arm.launch.xml": "<launch/>"}, **fetched) == []


DEFAULT_ASKED_FOR = """\
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, LogInfo, OpaqueFunction
from launch.substitutions import LaunchConfiguration

def start(context):
    model = LaunchConfiguration('model').perform(context)
    {asks}
    return []

def generate_launch_description():
    model = os.path.join(get_package_share_directory('robot'), 'models', 'robot.urdf')
    return LaunchDescription([
        DeclareLaunchArgument('model', default_value=model),
        OpaqueFunction(function=start),
    ])
"""


@pytest.mark.parametrize(
    ("asks", "told"),
    [
        ("if os.path.exists(model):\n        return [LogInfo(msg=open(model).read())]", 0),
        ("if not os.path.exists(model):\n        raise FileNotFoundError(model)", 1),
        ("open(model).read()", 1),
    ],
)
def test_a_default_that_code_asks_for_need_not_be_there(findings, asks: str, told: int):
    assert len(findings("LCH004", **{"launch/it.launch.py": DEFAULT_ASKED_FOR.format(asks=asks)})) == told


def test_a_share_folder_of_a_package_with_more_files_than_the_one_here(findings):
    """Packages that are made of one template have files of one name: a package with some of them was not meant."""
    here = {"config/arm.launch.xml": "<launch/>"}
    lines = "".join(include(f"$(find-pkg-share old_machine)/{path}") for path in (*here, "launch/hall.launch.xml"))
    assert findings("LCH004", lines, **here) == []
    (finding,) = findings("LCH004", lines, **here, **{"launch/hall.launch.xml": "<launch/>"})
    assert finding.help == "write 'robot'"


def test_a_share_folder_of_a_package_whose_programs_are_not_here(findings):
    """A driver that is built from source, with a parameter file of which there is a copy here."""
    here = {"config/arm.launch.xml": "<launch/>"}
    line = include("$(find-pkg-share old_machine)/config/arm.launch.xml")
    driver = '<node pkg="old_machine" exec="driver_node"/>'
    assert findings("LCH004", line + driver, **here) == []
    assert len(findings("LCH004", line + driver.replace("driver_node", "talker"), **here)) == 1


@pytest.mark.parametrize(("package", "told"), [("arm_description", 0), ("gripper_arm", 1)])
def test_a_package_that_is_only_of_the_same_kind(tmp_path, monkeypatch, package, told):
    monkeypatch.chdir(tmp_path)
    share = f'<launch><include file="$(find-pkg-share {package})/launch/deep.launch.xml"/></launch>'
    for name, files in {"robot": {"launch/it.launch.xml": share}, "gripper_description": {}}.items():
        inner = files if files else {"launch/deep.launch.xml": "<launch/>"}
        files = {
            "package.xml": manifest(name),
            "setup.py": SETUP.replace("robot", name),
            f"{name}/__init__.py": "",
            **inner,
        }
        write_files(tmp_path / name, {**files, f"resource/{name}": ""})
    write_files(tmp_path, {"archlint.toml": 'select = ["LCH004"]'})
    assert len(check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings) == told


@pytest.mark.parametrize("package", ["nav2_bringup", "lighthouse", "rob"])
def test_a_share_folder_of_a_package_from_elsewhere(findings, package):
    declared = {"package.xml": manifest(more="<depend>rob</depend>")}
    assert findings("LCH004", include(f"$(find-pkg-share {package})/launch/all.launch.xml"), **declared) == []


@pytest.mark.parametrize(
    ("listed", "file", "count"),
    [
        # Without recursive=True two stars mean what one does.
        ("glob('rviz/**')", "rviz/it.rviz", 0),
        ("glob('rviz/**.rviz')", "rviz/it.rviz", 0),
        ("glob('rviz/**/*.rviz')", "rviz/it.rviz", 1),
        ("glob('rviz/**/*.rviz')", "rviz/deep/it.rviz", 0),
        ("glob('rviz/**/*.rviz', recursive=True)", "rviz/it.rviz", 0),
        ("glob('rviz/**/*.rviz', recursive=True)", "rviz/deep/er/it.rviz", 0),
        ("glob('rviz/**/*.yaml', recursive=True)", "rviz/it.rviz", 1),
        ("glob('**/*.rviz', recursive=True)", "rviz/.hidden/it.rviz", 1),
        ("glob('rviz/*/*.rviz')", "rviz/deep/it.rviz", 0),
        ("glob('rviz/**/*.rviz', recursive=DEEP)", "rviz/it.rviz", 0),
        ("glob('**/*.rviz', root_dir='rviz', recursive=True)", "rviz/it.rviz", 0),
    ],
)
def test_a_file_that_a_pattern_of_a_setup_py_matches_or_not(findings, listed, file, count):
    setup = SETUP.replace("data_files=[", f"data_files=[('share/robot/rviz', {listed}), ")
    setup = f"from elsewhere import DEEP\n{setup}"
    inner = '<node pkg="rviz2" exec="rviz2" args="-d $(find-pkg-share robot)/rviz/it.rviz"/>'
    assert len(findings("LCH004", inner, **{"setup.py": setup, file: "", "rviz/other.yaml": ""})) == count


@pytest.mark.parametrize(
    ("path", "help"),
    [
        ("../arm/launch/arm.launch.xml", "start at the share folder of 'arm', which lies beside this one in a merged"),
        ("config/../launch/deep/it.launch.xml", "install robot/launch/deep/it.launch.xml"),
    ],
)
def test_a_file_of_another_package_beside_this_one(tmp_path, monkeypatch, path, help):
    monkeypatch.chdir(tmp_path)
    include = f'<launch><include file="$(find-pkg-share robot)/{path}"/></launch>'
    for name in ("robot", "arm"):
        files = {"package.xml": manifest(name), "setup.py": SETUP.replace("robot", name)}
        files |= {f"resource/{name}": "", "launch/it.launch.xml": include if name == "robot" else "<launch/>"}
        write_files(tmp_path / name, {**files, f"{name}/__init__.py": "", "launch/deep/it.launch.xml": "<launch/>"})
    write_files(tmp_path, {"arm/launch/arm.launch.xml": "<launch/>", "archlint.toml": 'select = ["LCH004"]'})
    (told,) = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert told.help.startswith(help)


@pytest.mark.parametrize(
    ("path", "told"),
    [
        ("$(find-pkg-share robot)/../../../../src/robot/rates/it.yaml", 0),  # install/robot/share/robot, from there up
        ("$(dirname)/../../../../../src/robot/rates/it.yaml", 0),
        (
            "$(find-pkg-share robot)/../../../../src/repository/robot/rates/it.yaml",
            0,
        ),  # this one, cloned into a folder?
        ("$(find-pkg-share robot)/rates/it.yaml", 1),  # nothing installs it
        ("$(find-pkg-share robot)/../../../src/robot/rates/it.yaml", 1),  # install/src is no folder
        ("$(find-pkg-share robot)/../../../../src/robot/rates/other.yaml", 0),
    ],
)
def test_a_path_up_to_the_workspace_of_an_isolated_install(tmp_path, monkeypatch, path, told):
    monkeypatch.chdir(tmp_path)
    write_robot(tmp_path / "src/robot", node(f'<param from="{path}"/>'), **{"rates/it.yaml": "talker: {}"})
    write_files(tmp_path, {"archlint.toml": 'select = ["LCH004"]'})
    assert len(check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings) == told


CHOSEN = """\
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource

def generate_launch_description():
    file = '/arm.launch.py'
    if os.environ['MODEL'] == 'lidar':
        folder = os.path.join(get_package_share_directory('lidar'), 'launch')
        file = '/{lidar}.launch.py'
    else:
        folder = os.path.join(get_package_share_directory('arm'), 'launch')
    return LaunchDescription([IncludeLaunchDescription(PythonLaunchDescriptionSource([folder, file]))])
"""


@pytest.mark.parametrize(("lidar", "told"), [("scan", []), ("scam", ["package 'lidar' has no launch file"])])
def test_branches_that_choose_a_package_choose_its_file_too(tmp_path, monkeypatch, lidar, told):
    """Which of the two names belongs to which package is lost where they are put together."""
    monkeypatch.chdir(tmp_path)
    empty = (
        "from launch import LaunchDescription\ndef generate_launch_description():\n    return LaunchDescription([])\n"
    )
    launches = {"robot": {"all": CHOSEN.format(lidar=lidar)}, "arm": {"arm": empty}, "lidar": {"scan": empty}}
    for name, files in launches.items():
        shared = {"package.xml": manifest(name), "setup.py": SETUP.replace("robot", name), f"resource/{name}": ""}
        write_files(tmp_path / name, {**shared, f"{name}/__init__.py": ""})
        write_files(tmp_path / name, {f"launch/{file}.launch.py": text for file, text in files.items()})
    write_files(tmp_path, {"archlint.toml": 'select = ["LCH004"]'})
    found = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert [finding.message[: len(start)] for finding, start in zip(found, told, strict=False)] == told
    assert bool(found) == bool(told)


@pytest.mark.parametrize(
    ("value", "substitutions", "found"),
    [
        ("package://robot/config/gird.yaml", False, 1),
        ("file://$(find-pkg-share robot)/config/gird.yaml", True, 1),
        ("$(find-pkg-share robot)/config/gird.yaml", True, 1),
        ("$(find-pkg-share robot)/config/gird.yaml", False, 0),  # a text like any other: LCH007's
        ("package://robot/config/grid.yaml", False, 0),
        ("package://robot/maps/hall.yaml", False, 0),  # nothing like it is there: a node may make it
        ("package://elsewhere/config/gird.yaml", False, 0),
        ("package://robot/config", False, 0),
    ],
)
def test_a_path_in_the_value_of_a_parameter_file(findings, value: str, substitutions: bool, found: int):
    files = {"config/grid.yaml": "", "config/p.yaml": f"talker:\n  ros__parameters:\n    grid: {value}\n"}
    allowed = ' allow_substs="true"' if substitutions else ""
    told = findings("LCH004", node(f'<param from="$(find-pkg-share robot)/config/p.yaml"{allowed}/>'), **files)
    assert [(one.place.file, one.place.line) for one in told] == [("config/p.yaml", 3)] * found
    assert [one.message for one in told] == [
        "package 'robot' has no file 'config/gird.yaml'; did you mean 'grid.yaml'?"
    ] * found


def test_a_path_in_a_value_that_a_launch_file_sets(findings):
    for scheme in ("package://robot", "file://$(find-pkg-share robot)"):
        files = {"config/grid.yaml": ""}
        (told,) = findings("LCH004", node(f'<param name="grid" value="{scheme}/config/gird.yaml"/>'), **files)
        assert told.message == "package 'robot' has no file 'config/gird.yaml'; did you mean 'grid.yaml'?"
        assert findings("LCH004", node(f'<param name="grid" value="{scheme}/config/grid.yaml"/>'), **files) == []
        assert findings("LCH004", node(f'<param name="output_file" value="{scheme}/config/gird.yaml"/>'), **files) == []


@pytest.mark.parametrize(
    ("there", "said"),
    [
        (["andino.rviz"], ", and its folder has 'andino.rviz'"),
        (["andino.rviz", "notes.txt", "slam.rviz"], ", and its folder has 'andino.rviz', 'slam.rviz'"),
        ([f"view{number}.rviz" for number in range(4)], ""),
        (["robots.rviz"], "; 'rviz/robots.rviz' is not installed either"),  # the message asks whether it was meant
    ],
)
def test_what_the_folder_of_a_missing_file_has(findings, there: list[str], said: str):
    launch = '<node pkg="rviz2" exec="rviz2" args="-d $(find-pkg-share robot)/rviz/robot.rviz"/>'
    (told,) = findings("LCH004", launch, **{f"rviz/{name}": "x" for name in there})
    assert told.help == f"check the path; it is relative to the package's installed share folder{said}"


MODEL = """\
<arg name="model" default="$(find-pkg-share robot)/{}"/>
<node pkg="robot" exec="talker"><param name="model" value="$(var model)"/></node>
"""


@pytest.mark.parametrize(
    ("file", "told"),
    [("models/policy.pt", 0), ("models/yolo.onnx", 0), ("models/policy.yaml", 1)],
)
def test_a_trained_model_is_seldom_kept_with_the_sources(findings, file: str, told: int):
    assert len(findings("LCH004", MODEL.format(file))) == told


def test_a_trained_model_by_a_name_that_is_almost_there(findings):
    (told,) = findings("LCH004", MODEL.format("config/polcy.pt"), **{"config/policy.pt": "weights"})
    assert told.message.endswith("did you mean 'policy.pt'?")


OPENS = """\
import os
import yaml
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    path = os.path.join(get_package_share_directory('robot'), 'config', 'tf.yaml')
    {code}
    return LaunchDescription([Node(package='robot', executable='talker')])
"""


@pytest.mark.parametrize(
    ("code", "found"),
    [
        ("rows = yaml.safe_load(open(path))", 1),
        ("with open(path, 'r') as file:\n        rows = yaml.safe_load(file)", 1),
        ("with open(path, mode='rb') as file:\n        rows = file.read()", 1),
        ("if os.path.exists(path):\n        rows = open(path).read()", 0),
        ("try:\n        rows = open(path).read()\n    except OSError:\n        rows = ''", 0),
        ("open(path, 'w').write('a: 1')", 0),
    ],
)
def test_a_file_that_the_code_of_a_launch_file_opens(findings, code, found):
    """No other file need have a name like it: launch stops with a FileNotFoundError."""
    files = {"launch/py.launch.py": OPENS.format(code=code), "config/other_things.yaml": ""}
    assert len(findings("LCH004", **files)) == found


def test_a_file_that_is_opened_and_that_git_ignores(findings):
    files = {"launch/py.launch.py": OPENS.format(code="open(path)"), "config/other.yaml": "", ".gitignore": "tf.yaml"}
    assert findings("LCH004", **files) == []


@pytest.mark.parametrize(
    ("file", "text", "found"),
    [
        ("launch/robot.yaml", "launch:\n- arg: {name: map, default: $(find-pkg-share robot)/config/no.yaml}\n", 1),
        ("launch/robot.yaml", "talker:\n  ros__parameters:\n    launch: 1\n", 0),
        ("config/robot.yaml", "launch:\n- arg: {name: map, default: $(find-pkg-share robot)/config/no.yaml}\n", 0),
    ],
)
def test_a_launch_file_in_yaml_that_is_not_named_so(findings, file, text, found):
    reads = "- node: {pkg: robot, exec: talker, param: [{from: $(var map)}]}\n" if text.startswith("launch") else ""
    assert len(findings("LCH004", **{file: text + reads})) == found


ROBOT = """\
<robot name="robot" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="{file}"/>
</robot>
"""


@pytest.mark.parametrize(
    ("file", "lines"),
    [
        ("$(find robot)/config/wheel.xacro", [2]),
        ("wheel.xacro", [2]),
        ("$(find robot)/config/arm.xacro", []),
        ("arm.xacro", []),
        ("$(find turtlebot3_description)/urdf/common.xacro", []),
    ],
)
def test_what_the_description_of_a_robot_includes(findings, file, lines):
    files = {"config/arm.urdf.xacro": ROBOT.replace("{file}", file), "config/arm.xacro": "<robot/>"}
    code = OPENS.replace("tf.yaml", "arm.urdf.xacro").format(code="import xacro; xacro.process_file(path)")
    told = findings("LCH004", **{"launch/py.launch.py": code}, **files)
    assert [(finding.place.file, finding.place.line) for finding in told] == [
        ("config/arm.urdf.xacro", line) for line in lines
    ]


@pytest.mark.parametrize(
    ("lines", "told"),
    [
        ("config/local.yaml\n", 0),
        ("log/\n/config/local.yaml  \n", 0),
        ("*.yaml\n", 1),
        ("config/\n", 1),
        ("# local.yaml\n", 1),
        ("config/other.yaml\n", 1),
        ("local.yaml\n!config/local.yaml\n", 1),
    ],
)
def test_a_parameter_file_that_gitignore_names_is_of_each_machine(findings, lines: str, told: int):
    launch = node('<param from="$(find-pkg-share robot)/config/local.yaml"/>')
    files = {".gitignore": lines, "config/talker.yaml": "talker: {ros__parameters: {rate: 1.0}}\n"}
    found = findings("LCH004", launch, **files)
    assert len(found) == told
    if lines in ("*.yaml\n", "config/\n"):
        assert found[0].help.startswith("a .gitignore keeps it out of the repository: commit it with git add -f")


@pytest.mark.parametrize(
    ("said", "told"),
    [
        ("Folder of the generated arm description, with arm.yaml", 0),
        ("Folder with arm.yaml, as generated by the configurator", 0),
        ("Folder with the generated charm.yaml", 1),
        ("Folder with arm.yaml", 1),
    ],
)
def test_a_file_that_a_launch_file_says_is_generated(findings, said: str, told: int):
    argument = f'<arg name="setup" default="$(find-pkg-share robot)/config" description="{said}"/>'
    inner = '<param from="$(var setup)/arm.yaml"/>'
    launch = f"{argument}\n{node(inner)}"
    assert len(findings("LCH004", launch, **{"config/talker.yaml": ""})) == told


@pytest.mark.parametrize(
    ("files", "told"),
    [
        ({"config/.gitignore": "*.yaml\n"}, 0),
        ({"config/.gitignore": "*\n!.gitignore\n"}, 0),
        ({"config/.gitignore": "*.txt\n"}, 1),
        ({"config/.gitignore": "*.yaml\n", "config/view.rviz": ""}, 1),
        ({".gitignore": "*.yaml\n"}, 1),
    ],
)
def test_a_folder_that_is_kept_for_what_git_ignores(findings, files: dict[str, str], told: int):
    launch = node('<param from="$(find-pkg-share robot)/config/local.yaml"/>')
    assert len(findings("LCH004", launch, **files)) == told


def test_the_files_of_a_folder_that_gitignore_leaves_out(findings):
    launch = "".join(node(f'<param from="$(find-pkg-share robot)/config/{name}.yaml"/>') for name in ("arm", "leg"))
    (told,) = findings("LCH004", launch, **{".gitignore": "*.yaml\n"})
    assert told.help == (
        "a .gitignore keeps them out of the repository: commit them with git add -f, or take out the pattern"
    )
    (told,) = findings("LCH004", launch, **{".gitignore": "*.yml\n"})
    assert told.help == "check the path of the folder; it is relative to the package's installed share folder"


WITH_A_MESH = """\
<robot name="robot">
  <mesh filename="{}"/>
</robot>
"""


@pytest.mark.parametrize(
    ("url", "told"),
    [
        ("package://parts/arm.stl", ["'arm.stl'; did you mean 'robot/parts'?"]),
        ("package://parts/left/arm.stl", ["'left/arm.stl'; did you mean 'robot/parts'?"]),
        ("package://parts/leg.stl", []),  # nobody knows what that is
        ("package://robot/parts/arm.stl", []),
        ("package://rviz2/arm.stl", []),  # a package of ROS
        ("file://parts/arm.stl", []),
    ],
)
def test_a_mesh_by_a_folder_of_the_package_alone(findings, url: str, told: list[str]):
    """The folder is no package: rviz does not find the mesh."""
    launch = '<node pkg="robot" exec="talker"><param name="robot_description" '
    launch += "value=\"$(command 'xacro $(find-pkg-share robot)/config/robot.urdf.xacro')\"/></node>"
    setup = SETUP.replace("data_files=[", "data_files=[('share/robot/parts', glob('parts/**', recursive=True)), ")
    files = {"parts/arm.stl": "", "parts/left/arm.stl": "", "config/robot.urdf.xacro": WITH_A_MESH.format(url)}
    rows = findings("LCH004", launch, **files, **{"setup.py": setup, "rviz2/arm.stl": ""})
    start = "there is no package 'parts', in which this looks for the file "
    assert [row.message for row in rows] == [start + end for end in told]
    assert [(row.place.file, row.place.line, row.help) for row in rows] == [
        ("config/robot.urdf.xacro", 2, "write 'robot/parts'") for _ in told
    ]
