"""ROS 1 beside ROS 2 in one workspace: passed over with one word, and without a finding."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.report.model import Report

MANIFEST = "<package format='3'><name>{name}</name><version>0.0.0</version>{more}</package>"
CATKIN = "<buildtool_depend>catkin</buildtool_depend><depend>rospy</depend>"
AMENT = "<exec_depend>rclpy</exec_depend><export><build_type>ament_cmake</build_type></export>"
EITHER = (
    "<buildtool_depend condition='$ROS_VERSION == 1'>catkin</buildtool_depend>"
    "<export><build_type condition='$ROS_VERSION == 1'>catkin</build_type>"
    "<build_type condition='$ROS_VERSION == 2'>ament_cmake</build_type></export>"
)
OLD_NODE = """\
import rospy
import tf2_ros
from std_msgs.msg import Strin
def on(message):
    print message.seq
"""


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)

    def go(more: str, package: str = "", **files: str) -> Report:
        plain = {f"{package}package.xml": MANIFEST.format(name="robot", more=more), "tools/plain.py": "ROBOTS = 2\n"}
        for name, text in {**plain, **files}.items():
            path = tmp_path / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        return check(Request((".",), load(tmp_path), cached=False, jobs=1))

    return go


@pytest.fixture
def plain(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """Checks files of no package."""
    monkeypatch.chdir(tmp_path)

    def go(**files: str) -> Report:
        for name, text in files.items():
            path = tmp_path / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        return check(Request((".",), load(tmp_path), cached=False, jobs=1))

    return go


def said(report: Report) -> tuple[list[str], list[str]]:
    """The codes of the findings, and what is said of ROS 1."""
    return [finding.code for finding in report.findings], [n for n in report.notices if "ROS 1" in n]


def test_nodes_for_ros_1_get_no_findings(run):
    report = run(CATKIN, **{"scripts/one.py": OLD_NODE, "scripts/two.py": "import actionlib\nimport tf2_ros\n"})
    assert said(report) == ([], ["2 Python files are for ROS 1 and skipped"])


def test_an_installed_script_for_ros_1_gets_no_findings(run):
    install = "install(PROGRAMS scripts/one.py DESTINATION lib/${PROJECT_NAME})\n"
    sends = "from std_msgs.msg import Bool\nprint(Bool(False), Bool(date=True))\n"
    needs = "<exec_depend>std_msgs</exec_depend>" + AMENT
    files = {"CMakeLists.txt": install, "scripts/one.py": f"import rospy\n{sends}"}
    assert said(run(needs, **files)) == ([], ["scripts/one.py is for ROS 1 and skipped"])
    assert said(run(needs, **files | {"scripts/one.py": f"import rclpy\n{sends}"})) == (["MSG003", "MSG001"], [])


def test_a_package_for_ros_2_is_checked_beside_one_of_its_name_for_ros_1(run):
    manifest = MANIFEST.format(name="robot", more=AMENT.replace("cmake", "python"))
    node = "import rclpy\nfrom std_msgs.msg import Bool\nprint(Bool(date=True))\n"
    new = {"new/package.xml": manifest, "new/robot/__init__.py": "", "new/robot/one.py": node}
    old = {"old/CMakeLists.txt": "find_package(catkin REQUIRED)\n", "old/scripts/one.py": OLD_NODE}
    report = run(CATKIN, package="old/", **old, **new)
    assert "MSG001" in said(report)[0]


def test_one_sentence_for_all_of_it(run):
    launch = '<launch><node pkg="robot" type="one.py" name="one"/></launch>'
    report = run(CATKIN, **{"scripts/one.py": OLD_NODE, "launch/one.launch": launch, "launch/two.launch": launch})
    assert said(report) == ([], ["2 launch files and 1 Python file are for ROS 1 and skipped"])


def test_an_interface_for_ros_1_is_not_held_against_ros_2(run):
    files = {"msg/Old.msg": "float64[] Values\n", "scripts/one.py": "import rospy\n"}
    assert said(run(CATKIN, **files))[0] == []
    assert said(run(AMENT, **files))[0] == ["LNT002"]


BOTH = '<launch><arg name="x" default="1"/><include file="$(dirname)/gone.launch"/></launch>'


@pytest.mark.parametrize(
    ("launch", "more", "old"),
    [
        (BOTH, CATKIN, True),
        (BOTH, AMENT, False),
        (BOTH, EITHER, False),
        ('<launch><arg name="x" doc="what it is"/></launch>', CATKIN, True),
        ('<launch><arg name="x" doc="what it is"/></launch>', AMENT, False),
        ('<launch><include file="$(dirname)/a.launch" pass_all_args="true"/></launch>', AMENT, True),
        ('<launch><group ns="a" clear_params="true"/></launch>', AMENT, True),
        ('<launch><node pkg="robot" exec="one" ns="a"/></launch>', CATKIN, False),
        ('<launch><include file="$(find-pkg-share robot)/a.launch" ns="a"/></launch>', CATKIN, False),
    ],
)
def test_a_launch_file_that_both_could_read_is_its_packages(run, launch, more, old):
    _, notices = said(run(more, **{"launch/it.launch": launch}))
    assert notices == (["launch/it.launch is for ROS 1 and skipped"] if old else [])


def test_without_a_package_the_habits_of_ros_1_decide(run, tmp_path):
    files = {"old.launch": '<launch><arg name="x" doc="y"/></launch>', "new.launch": '<launch><arg name="x"/></launch>'}
    run(AMENT, **files)
    (tmp_path / "package.xml").unlink()
    report = check(Request((".",), load(tmp_path), cached=False, jobs=1))
    assert said(report)[1] == ["old.launch is for ROS 1 and skipped"]


PORTED_IMPORT = "import rclpy\nfrom std_srvs.srv import Empty, EmptyRequest, EmptyResponse\n"
CATKIN_BUILD = "project(robot)\nfind_package(\n    catkin\n    REQUIRED COMPONENTS std_srvs)\ncatkin_python_setup()\n"
AMENT_BUILD = "project(robot)\nfind_package(ament_cmake REQUIRED)\nament_package()\n"


@pytest.mark.parametrize("manifest", [CATKIN, "<depend>rclpy</depend>", EITHER])
def test_a_package_that_catkin_builds_is_passed_over_whatever_it_imports(tmp_path, monkeypatch, manifest):
    """The imports were replaced, the package was not ported: nothing of ROS 2 builds it."""
    monkeypatch.chdir(tmp_path)
    texts = {
        "old/package.xml": MANIFEST.format(name="old", more=manifest),
        "old/CMakeLists.txt": CATKIN_BUILD,
        "old/src/one.py": PORTED_IMPORT,
        "old/src/bad.py": "import rclpy\nprint 1\n",
        "new/package.xml": MANIFEST.format(name="new", more=AMENT),
        "new/two.py": "import rclpy\n",
    }
    for name, text in texts.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    (tmp_path / "old/src/gone.py").symlink_to("nowhere.py")

    report = check(Request((".",), load(tmp_path), cached=False, jobs=1))
    assert said(report) == ([], ["2 Python files are for ROS 1 and skipped"])


@pytest.mark.parametrize(
    ("manifest", "build"),
    [
        (AMENT, CATKIN_BUILD),
        ("<depend>rclpy</depend>", AMENT_BUILD),
        (EITHER, f"if($ENV{{ROS_VERSION}} EQUAL 1)\n{CATKIN_BUILD}else()\n{AMENT_BUILD}endif()\n"),
        ("<depend>rclpy</depend>", f"# {CATKIN_BUILD.splitlines()[0]}\n"),
        ("<depend>rclpy</depend>", "# find_package(catkin)\nproject(robot)\n"),
        ("<depend>rclpy</depend>", "#[[\nfind_package(catkin)\n]]\nproject(robot)\n"),
        ("<depend>rclpy</depend>", 'message("no find_package(catkin) any more")\nproject(robot)\n'),
    ],
)
def test_a_package_that_was_ported_is_judged(run, manifest, build):
    report = run(manifest, **{"src/one.py": PORTED_IMPORT, "CMakeLists.txt": build})
    assert "MSG002" in [finding.code for finding in report.findings]
    assert report.notices == [] or "ROS 1" not in report.notices[0]


def test_a_link_into_a_submodule_that_is_not_checked_out(run, tmp_path):
    def told() -> list[tuple[str, str, str]]:
        report = run(AMENT, **{".gitmodules": '[submodule "x"]\n\tpath = external/x\n\turl = https://example.org/x\n'})
        return [(one.message, one.help, one.severity.name) for one in report.findings]

    link = tmp_path / "gamestate.py"
    link.symlink_to("external/x/python/gamestate.py")
    message = "is a symbolic link into the git submodule 'external/x', which is not checked out"
    assert told() == [(message, "git submodule update --init", "INFO")]
    link.unlink()
    link.symlink_to("external/xx/gamestate.py")
    [(message, help, severity)] = told()
    assert (message, severity) == ("is a broken symbolic link", "WARNING")
    assert help.startswith("correct it")
    link.unlink()
    (tmp_path / "src").mkdir()
    (tmp_path / "src" / "CMakeLists.txt").symlink_to("/opt/ros/no-such/share/catkin/cmake/toplevel.cmake")
    assert told() == []  # catkin makes it in every workspace


MADE_ANEW = {"rclpy/__init__.py": "from .node import Node\n", "rclpy/node.py": "class Node:\n    def say(self): ...\n"}
OF_THIS = "import rclpy\nfrom std_msgs.msg import String\nnode = rclpy.create_node('talker')\nprint(String(text=''))\n"


def about_rclpy(report: Report) -> tuple[list[str], list[str]]:
    return [finding.code for finding in report.findings], [n for n in report.notices if "rclpy" in n]


def test_nothing_is_said_of_programs_that_get_an_rclpy_of_the_workspace_itself(plain):
    files = {**MADE_ANEW, "examples/talker.py": OF_THIS, "go.launch.xml": "<launch/>"}
    notice = "3 Python files are for the rclpy of rclpy/__init__.py, not that of ROS 2, and skipped"
    assert about_rclpy(plain(**files)) == ([], [notice])


def test_an_rclpy_that_only_tests_get_hides_nothing(plain):
    files = {f"tests/stubs/{name}": text for name, text in MADE_ANEW.items()}
    assert about_rclpy(plain(**files, **{"examples/talker.py": OF_THIS})) == (["MSG001"], [])


def test_a_package_that_depends_on_rclpy_gets_the_one_of_ros_2(run):
    code, notices = about_rclpy(run(AMENT, **MADE_ANEW, **{"examples/talker.py": OF_THIS}))
    assert ("MSG001" in code, notices) == (True, [])
