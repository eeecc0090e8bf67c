"""What rules of taste leave alone: code that is put aside, stands in for something or tries it out."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from textwrap import dedent

import pytest

from archlint.config.settings import Settings, load
from archlint.engine.pipeline import Request, check
from archlint.finding import Finding, Severity
from archlint.workspace.test_code import FileRoles
from robot_package import manifest, write_files

NODE = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.words = self.create_publisher(String, '/robot/words', 10)


def main():
    rclpy.init()
    rclpy.spin(Talker())


if __name__ == '__main__':
    main()
"""
MANIFEST = """
<package format="3"><name>robot</name><version>0.0.1</version><description>d</description>
<maintainer email="a@b.org">a</maintainer><license>MIT</license><exec_depend>rclpy</exec_depend>
<exec_depend>std_msgs</exec_depend><export><build_type>ament_python</build_type></export></package>
"""
SETUP = """
from setuptools import find_packages, setup

setup(name='robot', packages=find_packages(), entry_points={'console_scripts': [
    'driver = robot.driver:main',
    {more}
]})
"""
LAUNCH = """
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package='robot', executable='talker')])
"""


@pytest.fixture
def named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """``named({path: text}, "a console script")`` gives the NME001 findings of a package ``robot`` with these files."""
    monkeypatch.chdir(tmp_path)

    def run(files: dict[str, str], more: str = "") -> list[Finding]:
        package = {
            "package.xml": MANIFEST.strip(),
            "setup.py": SETUP.replace("{more}", more),
            "robot/__init__.py": "",
            "robot/driver.py": "def main(): pass\n",
        }
        for name, text in {**package, **files}.items():
            path = tmp_path / "robot" / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(dedent(text), encoding="utf-8")
        (tmp_path / "archlint.toml").write_text(
            'select = ["NME001"]\n[rules.NME001]\neverywhere = true\n', encoding="utf-8"
        )
        return check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings

    return run


@pytest.mark.parametrize(
    "path",
    [
        "robot/mock_robot.py",
        "robot/dummy_scan.py",
        "robot/quick_tests/imu.py",
        "robot/fake/lidar.py",
        "robot/imu_test.py",
        "robot/mock2.py",
    ],
)
def test_a_stand_in_or_a_trial(named, path: str):
    assert named({path: NODE}, more="'talker = " + path.removesuffix(".py").replace("/", ".") + ":main',") == []
    assert FileRoles().is_trial(path)


@pytest.mark.parametrize("path", ["robot/latest_pose.py", "robot/contest.py", "robot/attestation.py", "robot/demo.py"])
def test_a_word_that_only_holds_the_letters_of_one(named, path: str):
    module = path.removesuffix(".py").replace("/", ".")

    [found] = named({path: NODE}, more=f"'talker = {module}:main',")

    assert (found.place.file, found.severity) == (f"robot/{path}", Severity.WARNING)


@pytest.mark.parametrize(
    "path",
    [
        "robot/archive/talker.py",
        "robot/_archive/talker.py",
        "robot/old_arm/talker.py",
        "robot/talker_old.py",
        "robot/talker_unused.py",
        "robot/talker-archive.py",
        "robot/talker_deprecated.py",
        "robot/talker_copy2.py",
        "robot/Copy of talker.py",
        "robot/talker.sync-conflict-1.py",
        "robot/(UNUSED)arms/talker.py",
        "robot/arm_not_used/talker.py",
        "robot/notused/talker.py",
        "robot/archieve/talker.py",
        "robot/_old/talker.py",
        "robot/2024_back_up/talker.py",
        "robot/talker_bkp.py",
        "robot/talker_bkup.py",
        "robot/arms_bkp/talker.py",
        "robot/arm (no usado)/talker.py",
        "robot/no_usado/talker.py",
        "robot/sin_usar/talker.py",
        "robot/Obsoletos/talker.py",
        "robot/viejo/talker.py",
        "robot/antiguos/talker.py",
        "robot/n\u00e3o usado/talker.py",
        "robot/na\u0303o_usado/talker.py",
        "robot/vecchio/talker.py",
        "robot/veraltet/talker.py",
        "robot/ungenutzt/talker.py",
        "robot/inutilis\u00e9s/talker.py",
        "robot/anciens/talker.py",
        "robot/not used/talker.py",
        "robot/[do not use] arm/talker.py",
        "robot/dont_use/talker.py",
    ],
)
def test_what_is_put_aside(named, path: str):
    assert named({path: NODE}) == []


@pytest.mark.parametrize(
    "path",
    [
        "robot/folder/talker.py",
        "legacy_bridge/talker.py",
        "conflict_detector.py",
        "gold/x.py",
        "backup/x.py",
        "unused_ports.py",
        "archive_reader.py",
        "copy_files.py",
        "record_archive.launch.py",
        "bkp_battery.launch.py",
        "last_used/x.py",
        "(new)arms/talker.py",
        "arms(old road)/talker.py",
        "nounused.py",
        "puerto_viejo/x.py",
        "alt_arm/x.py",
        "casino_usado/x.py",
        "dont_use_gps.py",
        "use/x.py",
        "ancient/x.py",
    ],
)
def test_what_only_sounds_like_it(path: str):
    assert not FileRoles().is_put_aside(path)


@pytest.mark.parametrize(
    ("files", "told"),
    [
        ({"robot/old_driver.py": NODE}, 0),
        ({"robot/old_driver.py": NODE, "robot/arm.py": "# from robot import new_driver\n"}, 0),
        ({"robot/old_driver.py": NODE, "robot/arm.py": "from robot.old_driver import Talker\n"}, 1),
        ({"robot/old_driver.py": NODE, "launch/robot.launch.py": "# runs robot.old_driver\n" + LAUNCH}, 0),
        ({"robot/old_driver.py": NODE, "launch/robot.launch.py": LAUNCH + "cmd = ['python3', 'old_driver.py']\n"}, 1),
        ({"robot/old_gripper.py": NODE}, 1),  # there is no gripper.py
        ({"robot/olddriver.py": NODE}, 1),
        ({"robot/backup_driver.py": NODE}, 1),  # drives where the driver fails
        ({"robot/arms/old_driver.py": NODE, "robot/arms/__init__.py": ""}, 1),
    ],
)
def test_a_file_beside_the_one_that_has_replaced_it(named, files: dict[str, str], told: int):
    assert len(named({"setup.py": "from setuptools import setup\nsetup(name='robot')\n", **files})) == told


def test_an_old_file_that_is_still_an_entry_point(named):
    assert len(named({"robot/old_driver.py": NODE}, more="'old = robot.old_driver:main',")) == 1


def test_what_a_launch_file_starts_is_not_put_aside(named):
    files = {"robot/old/talker.py": NODE, "robot/old/__init__.py": ""}
    assert named(files, more="'talker = robot.old.talker:main',") == []

    [found] = named({**files, "launch/robot.launch.py": LAUNCH}, more="'talker = robot.old.talker:main',")

    assert found.place.file == "robot/robot/old/talker.py"


def test_a_script_that_its_package_does_not_install(named):
    assert named({"robot/talker.py": NODE}) == []
    assert len(named({"robot/talker.py": NODE}, more="'talker = robot.talker:main',")) == 1


@pytest.mark.parametrize(("folder", "told"), [("examples", 0), ("tools", 0), ("nodes", 1)])
def test_an_example_or_a_tool_of_a_package(named, folder: str, told: int):
    files = {f"robot/{folder}/talker.py": NODE, f"robot/{folder}/__init__.py": ""}
    assert len(named(files, more=f"'talker = robot.{folder}.talker:main',")) == told


def test_what_no_package_installs_says_nothing_of_names(named):
    other = NODE.replace("/robot/words", "/robot/answers")
    loose = {"tools/a.py": NODE, "tools/b.py": NODE, "debug/c.py": other}
    assert named(loose) == []
    beside = {"../scripts/d.py": NODE, "../scripts/e.py": other, "../bench/f.py": NODE}
    assert named({**loose, **beside}) == []


def test_installed_code_is_judged_apart_from_what_is_not(named):
    other = NODE.replace("class Talker", "class Second").replace("Talker()", "Second()")
    files = {"robot/talker.py": NODE, "robot/second.py": other, "tools/a.py": NODE}
    [found] = named(files, more="'talker = robot.talker:main', 'second = robot.second:main',")
    assert (found.place.file, [row.place.file for row in found.related]) == (
        "robot/robot/second.py",
        ["robot/robot/talker.py"],
    )


@pytest.mark.parametrize(
    ("files", "told"),
    [
        ({"debug/tool.py": "from helper import main\n{start}"}, False),
        ({"debug/tool.py": "from helper import main\n{start}", "debug/__init__.py": ""}, False),
        ({"robot/driver.py": "from debug.helper import main\n"}, True),
        ({}, False),
    ],
    ids=["of a script that is not installed", "in a Python package", "of a program", "of nobody"],
)
def test_what_only_a_script_that_is_not_installed_imports(named, files: dict[str, str], told: bool):
    start = "\nif __name__ == '__main__':\n    main()\n"
    texts = {path: text.replace("{start}", start) for path, text in files.items()}
    found = named({**texts, "debug/helper.py": NODE.partition("if __name__")[0]})
    assert [one.place.file for one in found] == ["robot/debug/helper.py"] * told


def test_a_script_beside_the_packages(named):
    functions = NODE.partition("if __name__")[0]
    assert named({"../tools/smoke.py": NODE}) == named({"../tools/smoke.py": functions}) == []


@pytest.mark.parametrize(("folder", "may"), [("scripts", True), ("tools", False)])
def test_a_script_beside_the_packages_that_one_of_them_may_install(tmp_path: Path, monkeypatch, folder: str, may: bool):
    monkeypatch.chdir(tmp_path)
    cmake = (
        "cmake_minimum_required(VERSION 3.8)\nproject(robot)\nfind_package(ament_cmake REQUIRED)\n"
        "get_filename_component(ABOVE ${CMAKE_CURRENT_SOURCE_DIR}/.. ABSOLUTE)\n"
        "install(DIRECTORY ${ABOVE}/scripts/ DESTINATION lib/${PROJECT_NAME})\nament_package()\n"
    )
    files = {"robot/CMakeLists.txt": cmake, "robot/package.xml": manifest(build_type="ament_cmake")}
    wrong = "import rclpy\n\nrclpy.init()\nrclpy.spinn(rclpy.create_node('smoke'))\n"
    write_files(tmp_path, {**files, f"{folder}/smoke.py": wrong, "archlint.toml": 'select = ["API002"]\n'})
    [told] = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert told.message.endswith("no installed program uses this file") != may


def test_a_script_where_there_is_no_package(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "measure.py").write_text(NODE)
    (tmp_path / "archlint.toml").write_text('select = ["NME001"]\n[rules.NME001]\neverywhere = true\n')
    [script] = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert script.severity is Severity.INFO and script.message.endswith("no namespace applies to it")
    assert script.fix is not None and script.fix.title == "take the name from a parameter"
    (tmp_path / "measure.py").write_text(NODE.partition("def main")[0] + "rclpy.init()\nrclpy.spin(Talker())\n")
    [unguarded] = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert unguarded.severity is Severity.INFO
    (tmp_path / "measure.py").write_text(NODE.partition("if __name__")[0])
    [module] = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert module.severity is Severity.WARNING


@pytest.mark.parametrize(("module", "told"), [("talker", True), ("other", False)])
def test_an_executable_may_have_the_name_of_another_file(named, module: str, told: bool):
    files = {"robot/talker.py": NODE, "robot/other.py": "def main():\n    pass\n"}
    assert len(named(files, more=f"'talker = robot.{module}:main',")) == told


@pytest.mark.parametrize(
    ("more", "told"),
    [
        ("# 'talker = robot.talker:main',", False),
        ("'pen',  # 'talker = robot.talker:main',", False),
        ("'pen = robot.pen:main'.replace('pen', 'talker'),", True),
        ("'pen#1', 'talker = robot.talker:main',", True),
    ],
    ids=["a comment", "a comment after an entry", "a word of the code", "a hash that starts no comment"],
)
def test_an_entry_that_is_commented_out_installs_nothing(named, more: str, told: bool):
    assert len(named({"robot/talker.py": NODE}, more=more)) == told


_CPP = "add_executable(talker src/talker.cpp)\ninstall(TARGETS talker DESTINATION lib/robot)\n"


@pytest.mark.parametrize(
    ("cmake", "told"),
    [
        (_CPP + "install(DIRECTORY scripts DESTINATION share/robot)\n", False),
        (_CPP + "# install(PROGRAMS scripts/talker.py DESTINATION lib/robot)\n", False),
        (_CPP + "#[[ install(PROGRAMS scripts/talker.py\n DESTINATION lib/robot) ]]\n", False),
        (_CPP + "install(PROGRAMS scripts/talker.py DESTINATION lib/robot)\n", True),
        (_CPP + "install(PROGRAMS scripts/talker.py DESTINATION lib/robot RENAME talk)\n", True),
        (_CPP + "install(PROGRAMS scripts/talker.py DESTINATION lib/robot/tools)\n", True),
        (_CPP + "make_program(NAME scripts/talker.py)\n", True),
        ("add_executable(driver driver.cpp)\nmake_program(talker)\n", True),
    ],
    ids=[
        "a target's namesake",
        "a comment",
        "a block comment",
        "installed",
        "renamed",
        "in a folder",
        "a command",
        "a word",
    ],
)
def test_a_program_of_cmake_with_the_name_of_a_script(named, cmake: str, told: bool):
    manifest = MANIFEST.strip().replace("ament_python", "ament_cmake")
    files = {"package.xml": manifest, "setup.py": "", "CMakeLists.txt": "project(robot)\n" + cmake}
    assert len(named({**files, "scripts/talker.py": NODE})) == told


@pytest.mark.parametrize(
    ("command", "told"),
    [("python3 robot/talker.py", True), ("run", False)],
)
def test_a_launch_file_names_a_script(named, command: str, told: bool):
    launch = f"<launch><!-- python3 robot/talker.py --><executable cmd='{command}'/></launch>"
    assert len(named({"robot/talker.py": NODE, "launch/a.launch.xml": launch})) == told


def test_what_a_script_beside_the_packages_imports(named):
    module = NODE.partition("if __name__")[0]
    script = "from {} import main\n\nif __name__ == '__main__':\n    main()\n"
    assert named({"../tools/smoke.py": module, "../tools/run.py": script.format("smoke")}) == []
    assert named({"../tools/smoke.py": module, "../tools/run.py": script.format("other")}) == []


@pytest.mark.parametrize(
    ("files", "more"),
    [
        ({}, "'talker = robot.talker:main',"),
        ({"robot/driver.py": "from robot.talker import main\n"}, ""),
        ({"robot/driver.py": "from robot import between\n", "robot/between.py": "from .talker import main\n"}, ""),
        ({"setup.py": "from setuptools import setup\nsetup(name='robot', scripts=['robot/talker.py'])\n"}, ""),
        ({"setup.py": "from setuptools import setup\nsetup(name='robot')\n"}, ""),
        ({"setup.py": "from setuptools import setup\nimport where\nsetup(name='robot', entry_points=where.all)\n"}, ""),
        ({"launch/a.launch.xml": "<launch><executable cmd='python3 robot/talker.py'/></launch>"}, ""),
        ({"launch/a.launch.xml": "<launch><executable cmd='python3 -m robot.talker'/></launch>"}, ""),
    ],
    ids=[
        "installed",
        "imported",
        "imported by an import",
        "a script",
        "a library",
        "not known",
        "a launch file runs it",
        "a launch file runs it as a module",
    ],
)
def test_a_script_that_can_be_started(named, files: dict[str, str], more: str):
    [found] = named({"robot/talker.py": NODE, **files}, more)

    assert found.severity is Severity.WARNING


NEVER_ADDED = """
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    talker = Node(package='robot', executable='talker')
    return LaunchDescription([])
"""


@pytest.mark.parametrize("launch", [LAUNCH, NEVER_ADDED], ids=["started", "never added"])
def test_a_launch_file_that_names_an_executable_which_is_not_there(named, launch: str):
    assert named({"robot/talker.py": NODE, "launch/robot.launch.py": launch}) == []


TABLE = """
class Topics:
    WORDS = '/robot/words'
    STATE = '/robot/state'
"""


def uses(name: str, topic: str) -> str:
    return (
        NODE.replace("'/robot/words'", topic)
        .replace("talker", name)
        .replace("Node\n", "Node\nfrom robot.topics import Topics\n", 1)
    )


def test_names_that_several_files_take_from_one_place(named):
    files = {
        "robot/topics.py": TABLE,
        "robot/one.py": uses("one", "Topics.WORDS"),
        "robot/two.py": uses("two", "Topics.STATE"),
    }

    [found] = named(files, more="'one = robot.one:main', 'two = robot.two:main',")

    assert (found.place.file, found.place.line, found.severity) == ("robot/robot/topics.py", 3, Severity.INFO)
    assert found.message == (
        "2 names of Topics are absolute and fixed in the code, such as the topic '/robot/words', for 2 files that "
        "import names from here: no namespace applies to them"
    )
    assert found.help == "remove the leading '/' here, so that the nodes' namespaces apply"


def test_names_that_one_file_takes_from_another(named):
    files = {"robot/topics.py": TABLE, "robot/one.py": uses("one", "Topics.WORDS")}

    [found] = named(files, more="'one = robot.one:main',")

    assert found.severity is Severity.WARNING


@pytest.mark.parametrize(
    ("import_", "fails"),
    [
        ("from robot.eyes import Eye", True),
        ("import rospy", True),
        ("from dynamic_reconfigure.server import Server", True),
        ("from robot.driver import Eye", False),
        ("from robot import driver", False),
        ("from robot.msg import Eye", False),
        ("from other.eyes import Eye", False),
        ("try:\n    from robot.eyes import Eye\nexcept ImportError:\n    pass", False),
    ],
)
def test_a_script_that_nobody_installs_and_whose_import_fails(tmp_path, monkeypatch, import_: str, fails: bool):
    script = NODE.replace("import rclpy\n", f"import rclpy\n{import_}\n", 1)
    script = script.replace("rclpy.spin(Talker())", "node = Talker()")
    script = script.replace(
        "String, '/robot/words', 10)", "String, 'words', 10)\n        self.create_timer(1.0, print)"
    )
    files = {
        "package.xml": MANIFEST,
        "setup.py": SETUP.replace("{more}", ""),
        "robot/__init__.py": "",
        "robot/old.py": script,
    }
    for path, text in {**files, "robot/driver.py": NODE}.items():
        (tmp_path / path).parent.mkdir(exist_ok=True)
        (tmp_path / path).write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    found = [
        one
        for one in check(Request((".",), replace(load(tmp_path), unused_files=True), cached=False, jobs=1)).findings
        if one.code == "EXE008"
    ]
    assert [one.severity for one in found] == ([] if fails else [Severity.INFO])


@pytest.mark.parametrize(("data", "told"), [("x", []), ("import rclpy", ["LNT002"])])
def test_the_pictures_of_a_user_interface_are_no_code(tmp_path, monkeypatch, data: str, told: list[str]):
    (tmp_path / "talker.py").write_text("import logo_rc\n" + NODE.lstrip(), encoding="utf-8")
    (tmp_path / "logo_rc.py").write_text(f'{data}\npicture = b"{"00" * 600_000}"\n', encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    rows = check(Request((".",), Settings(), cached=False, jobs=1)).findings
    assert [finding.code for finding in rows if finding.place.file == "logo_rc.py"] == told


SLEEPS = NODE.replace(
    "        self.words = self.create_publisher(String, '/robot/words', 10)\n",
    """\
        self.rate = self.create_rate(5)
        self.create_timer(1.0, self.tick)

    def tick(self):
        self.rate.sleep()
""",
)


@pytest.mark.parametrize(
    ("path", "severity"),
    [
        ("ws/robot/robot/driver.py", Severity.ERROR),
        ("ws/robot/tools/reference.py", Severity.INFO),
        ("ws/tools/reference.py", Severity.INFO),
        ("ws/robot/(new)robot/driver.py", Severity.INFO),
    ],
    ids=[
        "a program of the package",
        "a script of the package",
        "a script beside the packages",
        "no name to import",
    ],
)
def test_an_error_in_code_that_no_package_installs_is_information(tmp_path, monkeypatch, path, severity):
    files = {"ws/robot/package.xml": MANIFEST.strip(), "ws/robot/setup.py": SETUP.replace("{more}", "")}
    files |= {"ws/robot/robot/__init__.py": "", "ws/robot/robot/driver.py": "def main(): pass\n"}
    for name, text in {**files, path: SLEEPS}.items():
        (tmp_path / name).parent.mkdir(exist_ok=True, parents=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path / "ws")
    rows = check(Request((".",), Settings(unused_files=True), cached=False, jobs=1)).findings
    [sleep] = [finding for finding in rows if finding.code == "EXE004"]
    assert sleep.severity is severity
    assert sleep.message.endswith("; no installed program uses this file") == (severity is Severity.INFO)


@pytest.mark.parametrize(
    ("files", "told"),
    [
        ({"robot/trial/one.py": "from .steps import go\n"}, 0),  # neither installed nor to be started by its path
        ({"robot/trial/one.py": "from .steps import go\n", "robot/trial/__init__.py": ""}, 1),
        ({"robot/trial/one.py": "from robot.steps import go\n"}, 1),
        ({"robot/trial/one.py": "import steps\n"}, 1),
    ],
)
def test_what_nobody_can_run_fails_nowhere(tmp_path, monkeypatch, files, told: int):
    own = {"package.xml": MANIFEST.strip(), "setup.py": SETUP.replace("{more}", ""), "robot/__init__.py": ""}
    own |= {"robot/driver.py": "def main(): pass\n", "robot/steps.py": "def go(): pass\n"}
    for name, text in {**own, **files}.items():
        (tmp_path / name).parent.mkdir(exist_ok=True, parents=True)
        (tmp_path / name).write_text(text + (SLEEPS if "one" in name else ""), encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    rows = check(Request((".",), Settings(unused_files=True), cached=False, jobs=1)).findings
    assert len([finding for finding in rows if finding.code == "EXE004"]) == told


@pytest.mark.parametrize(
    ("start", "told"),
    [
        ("from std_msgs import Bool\n", ["API006"]),
        ("from std_msgs.msg import Bool\n", ["API005"]),
        ("def later():\n    from std_msgs import Bool\n\n\nlater()\n", ["API006", "API005"]),
    ],
    ids=["it stops there", "it starts", "in a function"],
)
def test_a_script_that_nobody_installs_ends_with_its_imports(tmp_path, monkeypatch, start: str, told: list[str]):
    files = {"package.xml": MANIFEST.strip(), "setup.py": SETUP.replace("{more}", ""), "robot/__init__.py": ""}
    files |= {
        "robot/driver.py": "def main(): pass\n",
        "tools/rest.py": f"{start}{SLEEPS}\n\ndef other():\n    return missing\n\n\nOTHERS = [other]\n",
    }
    write_files(tmp_path, files)
    monkeypatch.chdir(tmp_path)
    rows = check(Request((".",), Settings(unused_files=True), cached=False, jobs=1)).findings
    assert [row.code for row in rows if row.code in ("API006", "API005")] == told


WRONG_CALL = """
def rest(seconds): ...


def pause(again=False):
    if again:
        pause()
    rest()


BY_NAME = ['pause']
"""


@pytest.mark.parametrize(
    ("start", "files", "told"),
    [
        ("import rclpy\nimport behaviortrees9\n", {}, 0),
        ("import rclpy\nfrom behaviortrees9.nodes import Repeat\n", {}, 0),
        ("import rclpy\n", {}, 1),
        ("import rclpy\nimport cv2\n", {}, 1),
        ("import rclpy\nimport behaviortrees9\n", {"requirements.txt": "behaviortrees9\n"}, 1),
        ("import rclpy\nimport behaviortrees9\n", {"robot/driver.py": "from robot.one import pause\n"}, 1),
        ("import rclpy\nimport behaviortrees9\n", {"robot/two.py": "from robot.one import pause\npause()\n"}, 1),
        ("import rclpy\n", {"robot/two.py": "from robot.one import pause\nimport behaviortrees9\n"}, 0),
        (
            "import rclpy\nSPEED = 1\n",
            {
                "robot/driver.py": "from robot.one import SPEED\ndef main(): pass\n",
                "robot/two.py": "from robot.one import pause\nimport behaviortrees9\n",
            },
            0,
        ),
        (
            "import rclpy\nSPEED = 1\n",
            {
                "robot/driver.py": "from robot.one import SPEED, pause\ndef main(): pause()\n",
                "robot/two.py": "from robot.one import pause\nimport behaviortrees9\n",
            },
            1,
        ),
        ("import rclpy\ntry:\n    import behaviortrees9\nexcept ImportError:\n    pass\n", {}, 1),
    ],
    ids=[
        "a module that is nowhere",
        "a name of it",
        "imports what is there",
        "imports what rosdep knows",
        "imports what is to be installed",
        "a program imports it",
        "a script imports it",
        "only what cannot be imported does",
        "a function for it, in a module that a program imports",
        "a function for it and for a program",
        "goes on without the module",
    ],
)
def test_what_cannot_be_imported_and_no_program_uses(tmp_path, monkeypatch, start: str, files: dict[str, str], told):
    own = {"package.xml": MANIFEST.strip(), "setup.py": SETUP.replace("{more}", ""), "robot/__init__.py": ""}
    own |= {"robot/driver.py": "def main(): pass\n", "robot/one.py": start + WRONG_CALL}
    for name, text in {**own, **files}.items():
        (tmp_path / name).parent.mkdir(exist_ok=True, parents=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    rows = check(Request((".",), Settings(unused_files=True), cached=False, jobs=1)).findings
    assert len([finding for finding in rows if finding.code == "API001"]) == told


@pytest.mark.parametrize(
    ("paths", "count", "copies"),
    [
        (["robot/driver.py"], 2, ""),
        (["tools/reference.py"], 1, ""),
        (["tools/reference.py", "tools/reference_2.py"], 1, " so does a copy beside it;"),
        (["tools/reference.py", "more/reference.py"], 2, ""),
    ],
)
def test_what_a_rule_says_of_such_a_file_is_one_finding(tmp_path, monkeypatch, paths, count: int, copies: str):
    again = SLEEPS.replace(
        "        self.rate.sleep()\n",
        "        self.more()\n        self.rate.sleep()\n\n    def more(self):\n        lost.x\n",
    )
    again += "\n\ndef other():\n    return missing\n\n\nOTHERS = [other]\n"
    files = {"package.xml": MANIFEST.strip(), "setup.py": SETUP.replace("{more}", ""), "robot/__init__.py": ""}
    for name, text in {**files, "robot/driver.py": "def main(): pass\n"}.items():
        (tmp_path / name).parent.mkdir(exist_ok=True, parents=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    for number, path in enumerate(paths):
        (tmp_path / path).parent.mkdir(exist_ok=True)
        (tmp_path / path).write_text(f"{again}# {number}\n", encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    rows = check(Request((".",), Settings(unused_files=True), cached=False, jobs=1)).findings
    undefined = [finding for finding in rows if finding.code == "API005"]
    assert len(undefined) == count
    if count == 1:
        assert undefined[0].message == (
            f"nothing defines 'lost': this line fails with a NameError; another line like it;{copies} "
            "no installed program uses this file"
        )
        assert undefined[0].related[0].message == "nothing defines 'missing': this line fails with a NameError"


@pytest.mark.parametrize(
    ("path", "severity"),
    [
        ("robot/robot/other.py", Severity.INFO),
        ("robot/robot/backup_of_driver", None),
        ("robot/robot/driver.py", Severity.ERROR),
    ],
    ids=["a module that nothing starts", "a copy that nothing can import", "a program of the package"],
)
def test_a_module_with_a_main_that_no_entry_point_names(tmp_path, monkeypatch, path: str, severity: Severity | None):
    program = "#!/usr/bin/env python3\n" + SLEEPS.partition("if __name__")[0].lstrip()
    files = {"robot/package.xml": MANIFEST.strip(), "robot/setup.py": SETUP.replace("{more}", "")}
    files |= {"robot/robot/__init__.py": "", "robot/robot/driver.py": "def main(): pass\n"}
    for name, text in {**files, path: program}.items():
        (tmp_path / name).parent.mkdir(exist_ok=True, parents=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    rows = check(Request((".",), Settings(unused_files=True), cached=False, jobs=1)).findings
    told = [finding.severity for finding in rows if finding.code == "EXE004"]
    assert told == ([] if severity is None else [severity])


@pytest.mark.parametrize(
    ("path", "names_it", "asked", "told"),
    [
        ("robot/robot/old/reference.py", "", ".", []),
        ("robot/robot/driver copy.py", "", ".", []),
        ("robot/robot/old/reference.py", "", "robot/robot/old/reference.py", ["EXE004"]),
        ("robot/robot/old/reference.py", "from robot.old import reference\n", ".", ["EXE004"]),
    ],
    ids=["put aside", "a copy", "asked for by name", "imported"],
)
def test_an_error_in_code_that_is_put_aside_is_nobodys(tmp_path, monkeypatch, path, names_it, asked, told):
    files = {"robot/package.xml": MANIFEST.strip(), "robot/setup.py": SETUP.replace("{more}", "")}
    files |= {"robot/robot/__init__.py": "", "robot/robot/driver.py": f"{names_it}def main(): pass\n"}
    files["robot/robot/old/__init__.py"] = ""
    for name, text in {**files, path: SLEEPS}.items():
        (tmp_path / name).parent.mkdir(exist_ok=True, parents=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    rows = check(Request((asked,), Settings(), cached=False, jobs=1)).findings
    assert [finding.code for finding in rows if finding.code == "EXE004"] == told


USES_WHAT_IS_OLD = """
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch_ros.actions import Node

HERE = get_package_share_directory('robot')

def generate_launch_description():
    return LaunchDescription([
        Node(package='robot', executable='driver', parameters=[os.path.join(HERE, 'old', 'p.yaml')]),
        IncludeLaunchDescription(PythonLaunchDescriptionSource(os.path.join(HERE, 'old', 'it.launch.py'))),
    ])
"""


@pytest.mark.parametrize(
    ("launch", "told"),
    [(USES_WHAT_IS_OLD, [("LCH001", "old/it.launch.py"), ("PRM004", "old/p.yaml")]), ("", [])],
    ids=["a launch file uses them", "nothing uses them"],
)
def test_old_launch_and_parameter_files_that_something_uses(tmp_path, monkeypatch, launch: str, told: list[str]):
    setup = "from setuptools import setup\nsetup(name='robot', packages=['robot'], data_files=[\n"
    setup += "('share/robot/launch', ['launch/robot.launch.py']),\n"
    setup += "('share/robot/old', ['old/p.yaml', 'old/it.launch.py'])],\n"
    setup += "entry_points={'console_scripts': ['driver = robot.driver:main']})\n"
    files = {
        "package.xml": MANIFEST.strip(),
        "setup.py": setup,
        "robot/__init__.py": "",
        "robot/driver.py": NODE.replace("'talker'", "'driver'"),
        "launch/robot.launch.py": launch,
        "old/it.launch.py": LAUNCH,
        "old/p.yaml": "driver:\n  ros__parameters:\n    rate: 1.0\n",
        "archlint.toml": 'select = ["LCH001", "PRM004"]',
    }
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(exist_ok=True, parents=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    rows = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert [(finding.code, finding.place.file) for finding in rows] == told


@pytest.mark.parametrize(
    ("change", "places"),
    [
        ("", [("robot/robot/driver.py", 1)]),
        ("  # again", [("robot/robot/driver.py", 0), ("robot/robot/driver_two.py", 0)]),
    ],
    ids=["the very same", "another text"],
)
def test_one_finding_for_copies_of_a_file(tmp_path, monkeypatch, change, places):
    files = {"robot/package.xml": MANIFEST.strip(), "robot/robot/__init__.py": ""}
    files |= {"robot/robot/driver.py": SLEEPS}
    files["robot/robot/driver_two.py"] = SLEEPS.replace("self.rate.sleep()", f"self.rate.sleep(){change}")
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(exist_ok=True, parents=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    rows = [row for row in check(Request((".",), Settings(), cached=False, jobs=1)).findings if row.code == "EXE004"]
    again = "the same in a copy of this code"
    assert [(row.place.file, [one.message for one in row.related].count(again)) for row in rows] == places


def test_an_error_in_a_folder_without_packages_stays_one(tmp_path, monkeypatch):
    (tmp_path / "reference.py").write_text(SLEEPS, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    [sleep] = [row for row in check(Request((".",), Settings(), cached=False, jobs=1)).findings if row.code == "EXE004"]
    assert sleep.severity is Severity.ERROR


WAITS = """
import rclpy
from rclpy.node import Node
from std_srvs.srv import Trigger


class Asks(Node):
    def __init__(self):
        super().__init__('asks')
        self.create_client(Trigger, 'go').wait_for_service()


if __name__ == '__main__':
    rclpy.init()
    rclpy.spin(Asks())
"""
INSTALLED = WAITS.replace("if __name__ == '__main__':", "def main():")
STARTS = """
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package='robot', executable='gone')])
"""
INCLUDES = """<launch><include file="$(find-pkg-share robot)/launch/old/up.launch.py"/></launch>"""


@pytest.mark.parametrize(
    ("files", "found"),
    [
        ({"robot/driver.py": INSTALLED, "launch/up.launch.py": STARTS}, ["LCH001", "TMO001"]),
        ({"asks_backup.py": WAITS, "launch/old/up.launch.py": STARTS}, []),
        ({"robot_backup/asks.py": WAITS, "robot_backup/up.launch.py": STARTS}, []),
        ({"launch/old/up.launch.py": STARTS, "launch/all.launch.xml": INCLUDES}, ["LCH001"]),  # it is in use after all
    ],
)
def test_what_is_put_aside_may_wait_for_what_is_gone(tmp_path, monkeypatch, files: dict[str, str], found: list[str]):
    monkeypatch.chdir(tmp_path)
    install = (
        "data_files=[('share/robot/launch/old', glob('launch/old/*')), ('share/robot/launch', glob('launch/*.*'))], "
    )
    texts = {
        "src/robot/package.xml": MANIFEST.strip(),
        "src/robot/setup.py": "from glob import glob\n"
        + SETUP.replace("{more}", "").replace("packages=", install + "packages="),
        "src/robot/robot/__init__.py": "",
        "src/robot/robot/driver.py": "def main():\n    pass\n",
        **{f"src/robot/{path}": text for path, text in files.items()},
    }
    for path, text in texts.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text, encoding="utf-8")
    (tmp_path / "archlint.toml").write_text('select = ["LCH001", "TMO001"]', encoding="utf-8")
    report = check(Request((".",), load(tmp_path), cached=False, jobs=1))
    assert sorted(one.code for one in report.findings) == found


SPINS = """
import rclpy
from std_srvs.srv import Trigger

if __name__ == '__main__':
    rclpy.init()
    node = rclpy.create_node('asks')
    future = node.create_client(Trigger, 'go').call_async(Trigger.Request())
    rclpy.spin_until_future_complete(node, future)
    print(future.result())
"""


@pytest.mark.parametrize(
    ("path", "found"),
    [("arm_system_tests/tester.py", []), ("arm/test_go.py", []), ("arm/contest.py", ["TMO003"])],
)
def test_a_trial_may_spin_until_its_runner_ends_it(tmp_path, monkeypatch, path: str, found: list[str]):
    monkeypatch.chdir(tmp_path)
    texts = {path: SPINS, "other/driver.py": "def main():\n    pass\n", "archlint.toml": 'select = ["TMO003"]\n'}
    for name, text in texts.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    report = check(Request((".",), load(tmp_path), cached=False, jobs=1))
    assert [one.code for one in report.findings] == found


@pytest.mark.parametrize(("path", "count"), [("arm_system_tests/tester.py", 0), ("arm/contest.py", 1)])
def test_a_trial_may_wait_until_its_runner_ends_it(tmp_path, monkeypatch, path: str, count: int):
    monkeypatch.chdir(tmp_path)
    waits = SPINS.replace("    future =", "    node.create_client(Trigger, 'ready').wait_for_service()\n    future =")
    waits += "    rclpy.spin(node)\n"
    texts = {path: waits, "other/driver.py": "def main():\n    pass\n", "archlint.toml": 'select = ["TMO001"]\n'}
    for name, text in texts.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    assert len(check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings) == count


SAID = """
import rclpy
from rclpy.node import Node
from rclpy.qos import QoSProfile, ReliabilityPolicy, qos_profile_sensor_data
from std_msgs.msg import String


class {name}(Node):
    def __init__(self):
        super().__init__('{name}')
        self.end = {end}
        self.create_timer(1.0, self.tick)

    def tick(self):
        pass


def main():
    rclpy.init()
    {run}


if __name__ == '__main__':
    main()
"""
BEST_EFFORT = "self.create_publisher(String, 'said', qos_profile_sensor_data)"
RELIABLE = "self.create_publisher(String, 'said', 10)"
ASKS = "self.create_subscription(String, 'said', print, 10)"


def said(name: str, end: str, run: str | None = None) -> str:
    return SAID.format(name=name, end=end, run=run or f"rclpy.spin({name}())")


@pytest.fixture
def found(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """``found(code, {path: text})`` gives the findings of a rule in a package ``robot`` that installs ``robot.driver``
    and in what lies beside it."""

    def run(code: str, files: dict[str, str]) -> list[Finding]:
        texts = {"package.xml": MANIFEST, "setup.py": SETUP.replace("{more}", ""), "robot/__init__.py": "", **files}
        for path, text in texts.items():
            place = tmp_path / "robot" / path
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_text(text, encoding="utf-8")
        monkeypatch.chdir(tmp_path)
        (tmp_path / "archlint.toml").write_text(f'select = ["{code}"]\n', encoding="utf-8")
        return check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings

    return run


@pytest.mark.parametrize(
    ("driver", "severities"),
    [
        pytest.param(RELIABLE, [], id="what was made for another publisher"),
        pytest.param("None", [Severity.INFO], id="what fits nobody"),
        pytest.param(BEST_EFFORT, [Severity.INFO], id="nor that one"),
    ],
)
def test_two_scripts_that_nobody_installs_are_no_pair(found, driver: str, severities: list[Severity]):
    loose = {"../poc/a.py": said("A", BEST_EFFORT), "../poc/b.py": said("B", ASKS)}
    told = found("QOS001", {**loose, "robot/driver.py": said("Driver", driver)})
    assert [one.severity for one in told] == severities
    assert all(one.message.endswith(", in scripts that no installed program uses") for one in told)


def test_a_subscription_that_is_put_aside_says_nothing_of_the_publisher(found):
    files = {"robot/driver.py": said("Driver", BEST_EFFORT), "robot/old/b.py": said("B", ASKS)}
    assert found("QOS001", {**files, "robot/old/__init__.py": ""}) == []


def test_a_script_that_nobody_installs_against_a_program(found):
    files = {"robot/driver.py": said("Driver", BEST_EFFORT), "debug/b.py": said("B", ASKS)}
    [told] = found("QOS001", files)
    assert told.severity is Severity.ERROR


BY_HAND = "node = Probe()\n    for _ in range(200):\n        node.tick()"


@pytest.mark.parametrize(
    ("path", "end", "run", "count"),
    [
        pytest.param("../poc/probe.py", ASKS, BY_HAND, 0, id="a script that measures"),
        pytest.param("../poc/probe.py", ASKS, "node = Probe()", 1, id="a script that forgets to spin"),
        pytest.param("../poc/probe.py", ASKS, BY_HAND.replace("node.tick", "other.tick"), 1, id="another object"),
        pytest.param("robot/driver.py", "None", BY_HAND, 0, id="a program that does all by hand"),
        pytest.param("robot/driver.py", ASKS, BY_HAND, 1, id="a program whose subscription never runs"),
    ],
)
def test_a_node_whose_callbacks_the_program_calls_itself(found, path: str, end: str, run: str, count: int):
    told = found("EXE008", {"robot/driver.py": "def main():\n    pass\n", path: said("Probe", end, run)})
    assert len(told) == count
    assert all("of its timer" not in one.message for one in told if path.startswith("robot"))


def test_a_draft_of_an_installed_program_belongs_to_its_finding(found):
    draft = "# The first try.\n" + SLEEPS
    other = SLEEPS.replace("super().__init__('", "super().__init__('other_")
    assert other != SLEEPS
    files = {"robot/driver.py": SLEEPS, "../driver_1.py": draft, "../other.py": other}
    installed, apart = sorted(found("EXE004", files), key=lambda told: -told.severity)
    assert installed.place.file == "robot/robot/driver.py"
    assert [row.place.file for row in installed.related if "draft" in row.message] == ["driver_1.py"]
    assert (apart.place.file, apart.severity) == ("other.py", Severity.INFO)


@pytest.mark.parametrize(
    ("entry", "told"),
    [("", 0), ("'mapper = robot.robot:main',", 1)],
    ids=["only the package is called so", "an entry names it"],
)
def test_a_module_that_is_called_like_its_package(tmp_path, monkeypatch, entry: str, told: int):
    code = "import rclpy\n\n\ndef main():\n    rclpy.init()\n    print(lost)\n"
    files = {"package.xml": MANIFEST.strip(), "setup.py": SETUP.replace("{more}", entry), "robot/robot.py": code}
    for name, text in {**files, "robot/__init__.py": "", "robot/driver.py": "def main(): pass\n"}.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    rows = check(Request((".",), Settings(), cached=False, jobs=1)).findings
    assert [finding.code for finding in rows if finding.code == "API005"] == ["API005"] * told


OF_FILES = "from setuptools import setup\nsetup(name='robot', data_files=[('lib/robot', ['robot/arm_v1.4.0.py'])])\n"


@pytest.mark.parametrize(
    ("files", "told"),
    [
        ({"robot/arm_v1.4.0.py": "", "robot/arm_v1.10.py": ""}, 0),
        ({"robot/arm_v1.4.0.py": "", "robot/arm_v1.3.9.py": ""}, 1),
        ({"robot/arm_v1.4.0.py": ""}, 1),
        ({"robot/arm_v1.4.0.py": "", "robot/arm_v2.py": "", "README.md": "python3 robot/arm_v1.4.0.py\n"}, 1),
        ({"robot/arm_v1.4.0.py": "", "robot/arm_v2.py": "", "setup.py": OF_FILES}, 1),
    ],
    ids=["a later one", "an earlier one", "none", "told to run", "installed"],
)
def test_an_earlier_version_in_a_package(tmp_path, monkeypatch, files: dict[str, str], told: int):
    code = (
        "import rclpy\n\n\ndef main():\n    rclpy.init()\n    print(lost)\n\n\nif __name__ == '__main__':\n    main()\n"
    )
    package = {"package.xml": MANIFEST.strip(), "setup.py": "from setuptools import setup\nsetup(name='robot')\n"}
    for name, text in {**package, **files, "robot/__init__.py": ""}.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(code if name == "robot/arm_v1.4.0.py" else text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    rows = check(Request((".",), Settings(), cached=False, jobs=1)).findings
    assert [finding.code for finding in rows if finding.code == "API005"] == ["API005"] * told


def test_a_module_of_launch_names_no_file_of_a_package(tmp_path, monkeypatch):
    """launch.actions is no actions.py of the package, robot.actions is."""
    code = (
        "import rclpy\n\n\ndef main():\n    rclpy.init()\n    print(lost)\n\n\nif __name__ == '__main__':\n    main()\n"
    )
    files = {
        "package.xml": MANIFEST.strip(),
        "setup.py": SETUP.replace("{more}", ""),
        "robot/driver.py": "def main(): 1\n",
        "robot/__init__.py": "",
    }
    launch = "from launch import LaunchDescription\nfrom launch.actions import ExecuteProcess\n\n\n"
    launch += "def generate_launch_description():\n    return LaunchDescription([{}])\n"
    for name, text in {**files, "robot/actions.py": code, "launch/robot.launch.py": launch.format("")}.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    rows = check(Request((".",), Settings(), cached=False, jobs=1)).findings
    assert [finding for finding in rows if finding.code == "API005"] == []
    started = launch.format("ExecuteProcess(cmd=['python3', '-m', 'robot.actions'])")
    (tmp_path / "launch/robot.launch.py").write_text(started, encoding="utf-8")
    rows = check(Request((".",), Settings(), cached=False, jobs=1)).findings
    assert [finding.severity for finding in rows if finding.code == "API005"] == [Severity.ERROR]


@pytest.mark.parametrize(
    ("line", "told"), [("from secret_msgs.msg import Word", 0), ("from std_msgs.msg import Char", 1)]
)
def test_a_script_that_stops_at_an_import_comes_to_nothing_else(tmp_path, monkeypatch, line: str, told: int):
    files = {"package.xml": MANIFEST.strip(), "setup.py": SETUP.replace("{more}", ""), "robot/__init__.py": ""}
    files |= {"robot/driver.py": "def main(): pass\n", "robot/reference.py": f"{line}\n{SLEEPS}"}
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(exist_ok=True, parents=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    rows = check(Request((".",), Settings(unused_files=True), cached=False, jobs=1)).findings
    assert len([finding for finding in rows if finding.code == "EXE004"]) == told


@pytest.mark.parametrize(
    ("path", "is_test"),
    [
        ("robot/test_drive.py", False),
        ("robot/test_arm.py", True),
        ("robot/tests/test_run.py", True),  # whatever is installed of a folder of tests
        ("robot/drive.py", False),
    ],
)
def test_a_program_whose_name_begins_like_that_of_a_test(path, is_test):
    programs = frozenset({"robot/test_drive.py", "robot/tests/test_run.py"})
    assert FileRoles(programs=programs).is_test(path) is is_test
