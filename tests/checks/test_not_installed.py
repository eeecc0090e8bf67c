"""PKG004: code and launch files that the build of a package leaves out."""

from __future__ import annotations

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.workspace.tracked import index_of
from robot_package import CMAKE, SETUP, TALKER, manifest, node, write_files

IMPORTS = "from robot.words.greetings import HELLO\n" + TALKER
CODE = {"robot/talker.py": IMPORTS, "robot/words/greetings.py": "HELLO = 'hello'\n"}
INITS = {"robot/__init__.py": "", "robot/words/__init__.py": ""}


def setup(packages: str, more: str = "") -> str:
    """A setup.py with ``packages=`` and other keywords."""
    text = SETUP.replace("import setup\n", "import find_namespace_packages, find_packages, setup\n")
    return text.replace("    name='robot',\n", f"    name='robot',\n    packages={packages},\n{more}")


# ------------------------------------------------------------------------------------------------- Python code


@pytest.mark.parametrize(
    ("packages", "files", "help"),
    [
        ("['robot']", {}, "add 'robot.words' to packages="),
        ("['robot']", INITS, "add 'robot.words' to packages="),
        (
            "find_packages()",
            {"robot/__init__.py": ""},
            "add an empty file robot/words/__init__.py: find_packages() passes over a folder without one",
        ),
        (
            "find_packages(exclude=['robot.w*'])",
            INITS,
            "change the include= or exclude= of find_packages(), which leaves it out",
        ),
        ("[name for name in ['robot']]", INITS, "add 'robot.words' to packages="),
    ],
)
def test_a_package_that_is_left_out_and_imported(findings, packages, files, help):
    (finding,) = findings("PKG004", **CODE, **files, **{"setup.py": setup(packages)})
    assert finding.message == (
        "packages= leaves out 'robot.words', which robot/talker.py imports: a build without --symlink-install does not "
        "have it, and the import fails"
    )
    assert (finding.place.file, finding.place.line, finding.help) == ("setup.py", 5, help)
    assert [(row.place.file, row.place.line) for row in finding.related] == [("robot/talker.py", 1)]


@pytest.mark.parametrize(
    ("packages", "files"),
    [
        ("['robot', 'robot.words']", {}),
        ("find_packages()", INITS),
        ("find_packages(exclude=['test'])", INITS),
        ("find_packages(include=['robot', 'robot.*'])", INITS),
        ("['robot'] + find_packages(include=['robot.*'])", INITS),
        ("find_namespace_packages()", {}),
        ("find_packages(where=folder)", {}),
        ("packages_here()", {}),
    ],
)
def test_packages_that_are_all_installed_or_not_known(findings, packages, files):
    assert findings("PKG004", **CODE, **files, **{"setup.py": setup(packages)}) == []


@pytest.mark.parametrize(
    "more", ["    package_data={'': ['*.py']},\n", "    include_package_data=True,\n", "    cmdclass={},\n"]
)
def test_a_setup_file_that_may_install_more(findings, more):
    assert findings("PKG004", **CODE, **{"setup.py": setup("['robot']", more)}) == []


@pytest.mark.parametrize(
    "imports",
    [
        "try:\n    from robot.words.greetings import HELLO\nexcept ImportError:\n    HELLO = ''\n",
        "import sys\nsys.path.append('/opt/words')\nfrom robot.words.greetings import HELLO\n",
        "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    from robot.words.greetings import HELLO\n",
        "def later():\n    from robot.words.greetings import HELLO\n",
    ],
)
def test_an_import_that_need_not_succeed(findings, imports):
    files = CODE | {"robot/talker.py": imports + TALKER}
    assert findings("PKG004", **files, **{"setup.py": setup("['robot']")}) == []


@pytest.mark.parametrize("name", ["setup.py", "pyproject.toml"])
def test_a_folder_that_is_installed_by_itself(findings, name):
    files = {"robot/talker.py": "from words import HELLO\n" + TALKER, "words/words/__init__.py": "HELLO = 'hello'\n"}
    files |= {"setup.py": setup("find_packages()"), "robot/__init__.py": ""}
    assert findings("PKG004", **files, **{f"words/{name}": ""}) == []


def test_a_folder_with_a_setup_file_is_not_installed_under_a_name_that_leads_to_it(findings):
    """Its own setup.py installs ``protocol``, and ``robot.words`` is nowhere."""
    files = {
        "robot/__init__.py": "",
        "robot/talker.py": "from robot.words.greetings import HELLO\nfrom protocol.frames import A\n" + TALKER,
        "robot/words/greetings.py": "HELLO = 'hello'\n",
        "robot/words/setup.py": "from setuptools import setup\n",
        "robot/words/protocol/__init__.py": "",
        "robot/words/protocol/frames.py": "A = 1\n",
        "setup.py": setup("find_packages()"),
    }
    (finding,) = findings("PKG004", **files)
    assert finding.help.startswith("add an empty file robot/words/__init__.py: ")


def test_each_folder_without_an_init_is_named(findings):
    files = {
        "robot/__init__.py": "",
        "robot/talker.py": "from robot.words import a\nfrom robot.signs import b\n" + TALKER,
        "robot/words/a.py": "",
        "robot/signs/b.py": "",
        "setup.py": setup("find_packages()"),
    }
    (finding,) = findings("PKG004", **files)
    assert finding.help.startswith("add empty files robot/words/__init__.py, robot/signs/__init__.py: ")


def test_a_package_inside_a_folder_without_an_init_is_passed_over_with_it(findings):
    files = CODE | {"robot/words/__init__.py": ""}
    (finding,) = findings("PKG004", **files, **{"setup.py": setup("find_packages()")})
    assert finding.help.startswith("add an empty file robot/__init__.py: find_packages() passes over")


def test_a_program_that_no_entry_starts_needs_nothing(findings):
    files = CODE | {"robot/talker.py": TALKER, "robot/listener.py": IMPORTS}
    assert findings("PKG004", **files, **{"setup.py": setup("['robot']")}) == []


def test_scripts_that_lie_beside_each_other(findings):
    files = {"scripts/base.py": "", "scripts/drive.py": "import base\n" + TALKER}
    more = "    scripts=['scripts/drive.py', 'scripts/base.py'],\n"
    assert findings("PKG004", **files, **{"setup.py": setup("['robot']", more)}) == []
    assert (
        len(findings("PKG004", **files, **{"setup.py": setup("['robot']", more.replace(", 'scripts/base.py'", ""))}))
        == 1
    )


def test_a_module_that_data_files_installs_beside_the_programs(findings):
    files = {"robot/__init__.py": "", "robot/camera.py": "", "tools/camera.py": "", "camera.py": ""}
    files["robot/talker.py"] = "import camera\n" + TALKER
    assert len(findings("PKG004", **files, **{"setup.py": setup("['robot']")})) == 1
    beside = setup("['robot']").replace("data_files=[", "data_files=[('lib/robot', ['robot/camera.py']), ")
    assert findings("PKG004", **files, **{"setup.py": beside}) == []
    elsewhere = beside.replace("'lib/robot'", "'share/robot'")
    assert len(findings("PKG004", **files, **{"setup.py": elsewhere})) == 1


def test_what_is_imported_by_what_is_imported(findings):
    files = {
        "robot/talker.py": "from robot import driver\n" + TALKER,
        "robot/driver.py": "from .words import greetings\n",
        "robot/words/greetings.py": "",
    }
    (finding,) = findings("PKG004", **files, **{"setup.py": setup("['robot']")})
    assert "leaves out 'robot.words', which robot/driver.py imports" in finding.message


def test_the_module_of_an_entry(findings):
    files = {
        "robot/nodes/talker.py": TALKER,
        "setup.py": setup("['robot']").replace("robot.talker", "robot.nodes.talker"),
    }
    (finding,) = findings("PKG004", **files)
    assert finding.message.startswith("packages= leaves out 'robot.nodes', in which the executable 'talker' is:")
    assert [row.message for row in finding.related] == ["the entry of 'talker'"]


def test_the_scripts_of_entries_in_a_folder_that_is_no_package(findings):
    entries = "'talker = robot.talker:main', 'tool = scripts.tool:main', 'other = scripts.other:main'"
    text = setup("find_packages()").replace("'talker = robot.talker:main'", entries)
    tool = "import rclpy\nfrom rclpy.node import Node\nrclpy.init()\nrclpy.spin(Node('tool'))\n"
    files = {"setup.py": text, "robot/__init__.py": "", "scripts/tool.py": tool, "scripts/other.py": tool}
    (finding,) = findings("PKG004", **files)
    assert finding.message.startswith("packages= leaves out 'scripts', in which the executable 'tool' is")
    assert finding.help == "add an empty file scripts/__init__.py: find_packages() passes over a folder without one"
    assert [row.message for row in finding.related] == ["the entry of 'tool'", "the entry of 'other'"]
    assert findings("PKG002", **files) == []
    in_share = {"setup.py": text.replace("data_files=[", "data_files=[('share/robot/scripts', ['scripts/tool.py']), ")}
    assert [len(row.related) for row in findings("PKG004", **files | in_share)] == [2]
    assert len(findings("PKG002", **files, **{"scripts/__init__.py": ""})) == 2


def test_a_setup_file_of_a_package_without_a_build_type_is_never_run(findings):
    untyped = manifest().replace("<export><build_type>ament_python</build_type></export>", "")
    files = CODE | {"package.xml": untyped, "setup.py": setup("['robot']")}
    assert len(findings("PKG004", **files)) == 1
    assert findings("PKG004", **files, **{"CMakeLists.txt": "project(robot)\nament_package()\n"}) == []


def test_all_that_one_setup_file_leaves_out_is_one_finding(findings):
    files = CODE | {"robot/talker.py": "import robot.sounds.bell\n" + IMPORTS, "robot/sounds/bell.py": ""}
    (finding,) = findings("PKG004", **files, **{"setup.py": setup("['robot']")})
    assert "leaves out robot.sounds, robot.words, which installed code needs" in finding.message
    assert finding.help == "add 'robot.sounds', 'robot.words' to packages="


def test_a_package_dir(findings):
    files = {"src/robot/talker.py": IMPORTS, "src/robot/words/greetings.py": ""}
    files |= {"src/robot/__init__.py": "", "setup.py": setup("find_packages('src')", "    package_dir={'': 'src'},\n")}
    (finding,) = findings("PKG004", **files)
    assert finding.help.startswith("add an empty file src/robot/words/__init__.py")
    assert findings("PKG004", **files, **{"src/robot/words/__init__.py": ""}) == []


def test_a_module_in_a_package_dir_without_a_package(findings):
    """``find_packages('src')`` finds the packages in that folder, and none of its modules."""
    moved = "    package_dir={'': 'src'},\n"
    files = {"src/talker.py": "def main(): ...\n", "src/__init__.py": ""}

    def build(packages: str, more: str = moved) -> str:
        return setup(packages, more).replace("robot.talker:main", "talker:main")

    for packages in ("find_packages('src')", "[]"):
        (finding,) = findings("PKG004", **files, **{"setup.py": build(packages)})
        assert finding.message.startswith("packages= leaves out 'talker', in which the executable 'talker' is")
        assert finding.help == "add py_modules=['talker']"
    fine = build("find_packages('src')", f"{moved}    py_modules=['talker'],\n")
    assert findings("PKG004", **files, **{"setup.py": fine}) == []


def test_a_package_dir_that_is_not_there(findings):
    moved = "    package_dir={'': 'src'},\n"
    files = CODE | INITS | {"setup.py": setup("find_packages()", moved)}
    (finding,) = findings("PKG004", **files)
    assert finding.message == "package_dir= puts packages into 'src', a folder that is not there: the build stops"
    assert finding.help == "remove package_dir=: the packages are beside setup.py"
    assert moved.strip() in files["setup.py"].splitlines()[finding.place.line - 1]
    (elsewhere,) = findings("PKG004", **{"lib/tools/a.py": "", "setup.py": setup("['tools']", moved)})
    assert elsewhere.help == "move the packages to 'src', or change package_dir="


def test_a_package_dir_that_is_there(findings):
    files = {f"src/{name}": text for name, text in (CODE | INITS).items()}
    moved = "    package_dir={'robot': 'src/robot', 'tools': 'tools'},\n"
    assert findings("PKG004", **files, **{"setup.py": setup("['robot', 'robot.words']", moved)}) == []


def test_a_package_that_cmake_builds_installs_what_cmake_says(findings):
    files = {"package.xml": CMAKE, "CMakeLists.txt": "project(robot)\nament_python_install_package(robot)\n"}
    assert findings("PKG004", **CODE, **files, **{"setup.py": setup("['robot']")}) == []


# ------------------------------------------------------------------------------------------------- launch files

NO_DATA = SETUP.replace("data_files=[", "data_files=[] and [")
LAUNCH = node()


def test_a_folder_of_launch_files_that_nothing_installs(findings):
    (finding,) = findings("PKG004", LAUNCH, **{"setup.py": NO_DATA})
    assert finding.message == (
        "package 'robot' does not install the launch file 'it.launch.xml': ros2 launch does not find it"
    )
    assert (finding.place.line, finding.help) == (
        5,
        "add ('share/robot/launch', ['launch/it.launch.xml']) to data_files=",
    )


@pytest.mark.parametrize(
    ("row", "told"),
    [
        ("launch/it.launch.xml", []),
        ("launch/*.launch.xml", []),
        ("launch/*.py", ["add launch/it.launch.xml under 'share/robot/launch =' in [options.data_files]"]),
    ],
)
def test_launch_files_that_setup_cfg_lists(findings, row, told):
    texts = {
        "setup.py": "from setuptools import setup\n\nsetup()\n",
        "setup.cfg": f"[options.data_files]\nshare/robot/launch =\n    {row}\n",
        "README.md": "ros2 launch robot it.launch.xml\n",
    }
    assert [finding.help for finding in findings("PKG004", LAUNCH, **texts)] == told


def test_what_cmake_does_not_install(findings):
    cmake = "project(robot)\nfind_package(ament_cmake REQUIRED)\nament_package()\n"
    (finding,) = findings("PKG004", LAUNCH, **{"package.xml": CMAKE, "setup.py": "", "CMakeLists.txt": cmake})
    assert (finding.place.file, finding.place.line) == ("CMakeLists.txt", 3)
    mended = cmake.replace(
        "ament_package", "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\nament_package"
    )
    assert findings("PKG004", LAUNCH, **{"package.xml": CMAKE, "setup.py": "", "CMakeLists.txt": mended}) == []


@pytest.mark.parametrize(
    ("starts", "told"),
    [
        ('<node pkg="arm_driver" exec="driver"/>', 0),
        ('<node pkg="arm_driver" exec="driver"/><node pkg="robot" exec="talker"/>', 1),
        ('<node pkg="arm_driver" exec="driver"/><!-- for the robot -->', 1),
        ('<node pkg="rviz2" exec="rviz2"/>', 1),
    ],
)
def test_a_launch_file_that_came_along_with_another_driver(findings, starts, told):
    assert len(findings("PKG004", starts, **{"setup.py": NO_DATA})) == told
    asks = manifest(more="<exec_depend>arm_driver</exec_depend>")
    assert len(findings("PKG004", starts, **{"setup.py": NO_DATA, "package.xml": asks})) == 1


@pytest.mark.parametrize("folder", ["share/launch", "launch", "share/old_robot/launch", "lib/robot/launch"])
def test_launch_files_that_are_installed_where_nobody_looks(findings, folder):
    listed = SETUP.replace("share/robot/launch", folder)
    (finding,) = findings("PKG004", LAUNCH, **{"setup.py": listed})
    assert finding.message == (
        f"package 'robot' installs the launch file 'it.launch.xml' in '{folder}', where ros2 launch does not look"
    )
    assert (finding.place.file, finding.help) == ("setup.py", "install it in 'share/robot/launch'")


@pytest.mark.parametrize("folder", ["share/robot", "share/robot/launch/more", "share/nav2_bringup/launch"])
def test_launch_files_that_are_installed_for_a_package(findings, folder):
    listed = SETUP.replace("share/robot/launch", folder)
    assert findings("PKG004", LAUNCH, **{"setup.py": listed}) == []


SHARE = "${CMAKE_INSTALL_PREFIX}/share/${PROJECT_NAME}"
LINK_EACH = f"""\
file(GLOB FILES "${{CMAKE_CURRENT_SOURCE_DIR}}/launch/*")
foreach(FILE ${{FILES}})
  get_filename_component(NAME ${{FILE}} NAME)
  execute_process(COMMAND ${{CMAKE_COMMAND}} -E create_symlink ${{FILE}} "{SHARE}/launch/${{NAME}}")
endforeach()
"""


@pytest.mark.parametrize(
    ("command", "count"),
    [
        (LINK_EACH, 0),
        (f"file(COPY launch DESTINATION {SHARE})\n", 0),
        (f"set(TO {SHARE})\nadd_custom_target(all_files ALL COMMAND cp -r launch ${{TO}})\n", 0),
        ('install(CODE "file(COPY launch DESTINATION /opt)")\n', 0),
        ("install(SCRIPT copy.cmake)\n", 0),
        # These put nothing below the prefix.
        (f"message(STATUS {SHARE})\n", 1),
        (f"file(GLOB FILES ${{CMAKE_CURRENT_SOURCE_DIR}}/*.msg)\nset(RPATH {SHARE})\n", 1),
        ("execute_process(COMMAND git rev-parse HEAD OUTPUT_VARIABLE HASH)\n", 1),
        ("file(COPY launch DESTINATION ${CMAKE_CURRENT_BINARY_DIR})\n", 1),
    ],
)
def test_a_build_that_puts_files_into_its_install_folder_by_itself(findings, command, count):
    cmake = f"project(robot)\n{command}ament_package()\n"
    files = {"package.xml": CMAKE, "setup.py": "", "CMakeLists.txt": cmake}
    assert len(findings("PKG004", LAUNCH, **files)) == count
    assert len(findings("LCH001", node(executable="other"), **files)) == count
    include = '<include file="$(find-pkg-share robot)/launch/other.launch.xml"/>'
    assert len(findings("LCH004", include, **files)) == count


INSTALL_FOLDERS = """\
function(install_folders)
  foreach(FOLDER ${ARGN})
    install(DIRECTORY "${FOLDER}/" DESTINATION "share/${PROJECT_NAME}/${FOLDER}")
  endforeach()
endfunction()
"""


@pytest.mark.parametrize(
    ("call", "count"),
    [
        ("include(Shared)\ninstall_folders(launch)\n", 0),
        ("include(Shared)\ninstall_folders(config)\n", 1),
        ("include(Shared)\n", 1),
        ("include(CTest)\n", 1),
        ("include(Shared)\nfrom_elsewhere(launch)\n", 0),
        ("include(Shared)\nfrom_elsewhere(config)\n", 1),
    ],
)
@pytest.mark.parametrize(
    "path",
    [
        'set(CMAKE_MODULE_PATH "${CMAKE_MODULE_PATH}" "${PROJECT_SOURCE_DIR}/cmake")\n',
        "list(APPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_SOURCE_DIR}/cmake)\n",
    ],
)
def test_a_cmake_function_of_a_module_in_the_source_tree(findings, path, call, count):
    cmake = f"project(robot)\n{path}{call}ament_package()\n"
    files = {"package.xml": CMAKE, "setup.py": "", "CMakeLists.txt": cmake, "config/a.yaml": ""}
    files["cmake/Shared.cmake"] = INSTALL_FOLDERS
    assert len(findings("PKG004", LAUNCH, **files)) == count


def test_one_launch_file_of_several_may_be_put_aside(findings):
    some = SETUP.replace("glob('launch/*')", "['launch/it.launch.xml']")
    files = {"setup.py": some, "launch/other.launch.xml": f"<launch>{LAUNCH}</launch>"}
    assert findings("PKG004", LAUNCH, **files) == []
    readme = {"README.md": "Start it:\n\n    ros2 launch robot other.launch.xml\n"}
    (finding,) = findings("PKG004", LAUNCH, **files, **readme)
    assert "does not install the launch file 'other.launch.xml'" in finding.message
    assert [(row.place.file, row.place.line, row.place.column) for row in finding.related] == [("README.md", 3, 5)]


@pytest.mark.parametrize(
    ("listed", "told"),
    [
        (("it", "b", "c"), "does not install the launch file 'd.launch.xml'"),
        (("it", "b", "c", "d"), ""),
        (("it",), ""),  # the others may be parts of it
        (("it", "b"), ""),  # as many as are left out
        (("[a-i]*", "b", "c"), ""),  # what a pattern leaves out may be meant
    ],
)
def test_a_launch_file_that_a_list_of_them_lacks(findings, listed, told):
    names = [f"launch/{name}.launch.xml" for name in listed]
    files = {f"launch/{name}.launch.xml": f"<launch>{LAUNCH}</launch>" for name in "bcd"}
    sources = "glob('launch/[a-i]*')" if "[a-i]*" in listed else str(names)
    setup = SETUP.replace("glob('launch/*')", sources)
    messages = [finding.message for finding in findings("PKG004", LAUNCH, **{"setup.py": setup}, **files)]
    assert len(messages) == bool(told) and all(told in message for message in messages)


def test_a_launch_file_that_install_files_lacks(findings):
    names = "launch/it.launch.xml launch/b.launch.xml"
    cmake = f"project(robot)\ninstall(FILES {names} DESTINATION share/robot/launch)\nament_package()\n"
    files = {f"launch/{name}.launch.xml": f"<launch>{LAUNCH}</launch>" for name in "bc"}
    (finding,) = findings("PKG004", LAUNCH, **{"package.xml": CMAKE, "setup.py": "", "CMakeLists.txt": cmake}, **files)
    assert finding.message.startswith("package 'robot' does not install the launch file 'c.launch.xml'")


@pytest.mark.parametrize(
    ("packages", "message", "help"),
    [
        (
            "['robot', f'robot/{1 * \"drivers\"}', 'robot.more']",
            "packages= lists 'robot/drivers', and 1 more, without a folder: the build stops at 'robot/drivers'",
            "take them off the list",
        ),
        (
            "['robot_py']",
            "packages= lists 'robot_py', without a folder: the build stops at 'robot_py'; did you mean 'robot'?",
            "write 'robot'",
        ),
    ],
)
def test_a_package_that_is_listed_and_has_no_folder(findings, packages, message, help):
    (finding,) = findings("PKG004", LAUNCH, **{"setup.py": setup(packages)})
    assert (finding.message, finding.help, finding.place.line) == (message, help, 5)


@pytest.mark.parametrize(
    ("entry", "help"),
    [
        ("robot.talker:main", "write 'robot'"),
        ("arm.talker:main", "rename the folder 'robot' to 'arm', as which the code of the package calls it"),
    ],
)
def test_a_folder_that_the_entries_call_as_packages_does(findings, entry: str, help: str):
    (finding,) = findings("PKG004", LAUNCH, **{"setup.py": setup("['arm']").replace("robot.talker:main", entry)})
    assert finding.help == help


@pytest.mark.parametrize(
    ("more", "help"),
    [
        ({}, "write 'robot'"),
        ({"test/__init__.py": ""}, "write 'robot'"),
    ],
)
def test_the_folder_that_programs_need_has_another_name(findings, more, help):
    (finding,) = findings("PKG004", LAUNCH, **{"setup.py": setup("['my_python_package']")}, **more)
    assert finding.help == help


@pytest.mark.parametrize(
    ("folders", "help"), [(["motor", "test"], "write 'motor'"), (["motor", "arm"], "take it off the list")]
)
def test_the_only_folder_of_python_has_another_name(tmp_path, monkeypatch, folders: list[str], help: str):
    files = {f"src/wheels/{name}/__init__.py": "" for name in folders}
    files["src/wheels/package.xml"] = manifest("my_python_package")
    files["src/wheels/setup.py"] = (
        "from setuptools import setup\nsetup(name='wheels', packages=['my_python_package'])\n"
    )
    write_files(tmp_path, {"archlint.toml": 'select = ["PKG004"]', **files})
    monkeypatch.chdir(tmp_path)
    (told,) = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert told.help == help


@pytest.mark.parametrize(
    ("packages", "files"),
    [
        ("['robot', 'robot.words']", {"robot/words/data.json": "{}"}),
        ("['robot', 'robot.words']", {".gitignore": "words/\n"}),
        ("['robot', 'robot.words']", {"setup.py": setup("['robot', 'robot.words']", "    cmdclass={},\n")}),
        ("['robot', NAME]", {}),
    ],
)
def test_a_listed_package_that_is_there_or_may_be(findings, packages, files):
    assert findings("PKG004", LAUNCH, **({"setup.py": setup(packages)} | files)) == []


@pytest.mark.parametrize("command", ["ros2 launch launch/it.launch.xml", "ros2 launch it.launch.xml"])
def test_a_launch_file_that_is_started_by_its_path(findings, command):
    assert findings("PKG004", LAUNCH, **{"setup.py": NO_DATA, "start.sh": f"{command} rate:=2\n"}) == []


@pytest.mark.parametrize(
    ("folder", "count"), [("launch/more", 1), ("launch/old", 0), ("launch/test", 0), ("templates", 0)]
)
def test_launch_files_elsewhere_are_for_something_else(findings, folder, count):
    files = {
        "setup.py": SETUP.replace("glob('launch/*')", "['launch/it.launch.xml']"),
        f"{folder}/b.launch.xml": f"<launch>{LAUNCH}</launch>",
        "README.md": "ros2 launch robot b.launch.xml\n",
    }
    assert len(findings("PKG004", LAUNCH, **files)) == count


def test_what_a_launch_file_names_is_told_there(findings):
    files = {
        "setup.py": SETUP.replace("glob('launch/*')", "['launch/it.launch.xml']"),
        "launch/it.launch.xml": '<launch><include file="$(find-pkg-share robot)/launch/b.launch.xml"/></launch>',
        "launch/b.launch.xml": f"<launch>{LAUNCH}</launch>",
        "README.md": "ros2 launch robot b.launch.xml\n",
    }
    assert findings("PKG004", **files) == []
    assert len(findings("LCH004", **files)) == 1


# -------------------------------------------------------------------------------------------- what is listed in vain


INSTALLS_FILM = """project(robot)
find_package(ament_cmake REQUIRED)
install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})
install(FILES films/test.mp4 DESTINATION share/${PROJECT_NAME})
ament_package()
"""


def listing(*files: str) -> str:
    rows = f"('share/ament_index/resource_index/packages', ['resource/robot']), ('share/robot', {list(files)!r}), "
    return SETUP.replace("data_files=[", f"data_files=[{rows}")


def test_a_marker_that_is_not_there_stops_the_build(findings):
    (finding,) = findings("PKG004", **{"setup.py": listing("package.xml")})
    assert finding.message == (
        "data_files= lists the marker of the package that is not there: the build stops at 'resource/robot'"
    )
    assert finding.help == "add an empty file 'resource/robot'"
    assert findings("PKG004", **{"setup.py": listing("package.xml"), "resource/robot": ""}) == []


def test_a_marker_that_is_there_under_the_name_of_the_package(findings):
    setup = listing("package.xml").replace("resource/robot", "resource/old_robot")
    (finding,) = findings("PKG004", **{"setup.py": setup, "resource/robot": ""})
    assert finding.message.endswith("stops at 'resource/old_robot'; did you mean 'resource/robot'?")
    assert finding.help == "write 'resource/robot'"


OF_OLD_NAME = '<launch><node pkg="old_robot" exec="talker"/></launch>'


def test_a_marker_with_the_name_of_another_package(findings):
    setup = listing("package.xml").replace("resource/robot", "resource/old_robot")
    (finding,) = findings("PKG004", **{"setup.py": setup, "resource/old_robot": ""})
    assert finding.message == (
        "the marker that data_files= installs is 'old_robot', and this is package 'robot': ROS takes this package for "
        "'old_robot', too"
    )
    assert finding.help == "rename 'resource/old_robot' to 'resource/robot', and write that here"


def test_a_marker_that_is_a_file_with_another_use(findings):
    setup = listing("package.xml").replace("'resource/robot'", "'package.xml'")
    [finding] = [row for row in findings("PKG004", **{"setup.py": setup}) if "marker" in row.message]
    assert finding.help == "have an empty file 'resource/robot', and write that here"


@pytest.mark.parametrize(
    ("folder", "cure"),
    [
        ("lib/old_robot", "and write 'robot' in setup.py and setup.cfg"),
        ("lib/robot", "and write that here"),
        ("lib/old_robot_arm", "and write that here"),
    ],
)
def test_a_marker_with_the_name_that_the_folder_of_the_programs_has_too(findings, folder: str, cure: str):
    setup = listing("package.xml").replace("resource/robot", "resource/old_robot")
    config = f"[develop]\nscript_dir=$base/{folder}\n[install]\ninstall_scripts=$base/{folder}\n"
    told = findings("PKG004", **{"setup.py": setup, "setup.cfg": config, "resource/old_robot": ""})
    assert [row.help for row in told if "marker" in row.message] == [
        f"rename 'resource/old_robot' to 'resource/robot', {cure}"
    ]


@pytest.mark.parametrize(
    "start", [{"README.md": "    ros2 launch old_robot all.launch.xml\n"}, {"launch/it.launch.xml": OF_OLD_NAME}]
)
def test_the_name_of_a_marker_by_which_the_package_is_started(findings, start: dict[str, str]):
    setup = listing("package.xml").replace("resource/robot", "resource/old_robot")
    rows = findings("PKG004", **{"setup.py": setup, "resource/old_robot": "", **start})
    assert rows[0].help == "write <name>old_robot</name> in package.xml, as it is started by that name"


@pytest.mark.parametrize(
    "markers", ["['resource/old_robot', 'resource/robot']", "['resource/' + name]", "glob('resource/*')", "[]"]
)
def test_a_package_with_a_marker_of_its_own_or_perhaps_one(findings, markers: str):
    setup = listing("package.xml").replace("['resource/robot']", markers).replace("setup(", "name = 'robot'\nsetup(", 1)
    assert findings("PKG004", **{"setup.py": setup, "resource/robot": "", "resource/old_robot": ""}) == []


@pytest.mark.parametrize(
    ("markers", "said"),
    [
        (
            "['resource/robot', 'resource/lens.yaml']",
            "'resource/lens.yaml' among the markers of packages: ROS takes that",
        ),
        ("['resource/robot', 'config/a.yaml']", "'config/a.yaml' among"),
        (
            "glob('resource/*')",
            "'resource/chart.png', 'resource/lens.yaml' among the markers of packages: ROS takes these",
        ),
        ("['resource/robot']", ""),
        ("['resource/robot', 'resource/of_tests']", ""),
        ("['resource/robot', 'launch/it.launch.xml']", ""),
    ],
)
def test_a_file_among_the_markers_of_packages(findings, markers: str, said: str):
    setup = listing("package.xml").replace("['resource/robot']", markers)
    files = dict.fromkeys(("robot", "lens.yaml", "chart.png", "of_tests", ".gitkeep"), "")
    files = {f"resource/{name}": "" for name in files} | {
        "config/a.yaml": "",
        "setup.py": setup.replace("config/*", "-"),
    }
    assert [row.message.removeprefix("data_files= puts ")[: len(said)] for row in findings("PKG004", **files)] == (
        [said] if said else []
    )


@pytest.mark.parametrize(
    ("listed", "vain"),
    [
        ("glob('config/' + name + '.yaml')", False),
        ("glob('config/robot.yaml')", False),
        ("glob('config')", True),
        ("['config/' + name + '.yaml']", True),
    ],
)
def test_glob_of_a_name_that_is_not_there_lists_nothing(findings, listed: str, vain: bool):
    """``glob()`` gives an empty list, so that the build goes on; a folder that is there stays in the list."""
    setup = listing("package.xml").replace("['package.xml']", listed).replace("setup(", "name = 'robot'\nsetup(", 1)
    files = {"resource/robot": "", "config/other.yaml": ""}
    assert bool(findings("PKG004", **{"setup.py": f"from glob import glob\n{setup}", **files})) is vain


def test_a_launch_file_that_launch_rejects_is_not_missed(findings):
    """Installed, it would start nothing: LCH005 says what is wrong with it."""
    code = """from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    return LaunchDescription([Node(package='robot', %s='talker')])
"""
    files = {"setup.py": NO_DATA, "README.md": "ros2 launch robot all.launch.py\n"}
    (finding,) = findings("PKG004", **files, **{"launch/all.launch.py": code % "executable"})
    assert "these 2 launch files: all.launch.py, it.launch.xml" in finding.message
    (finding,) = findings("PKG004", **files, **{"launch/all.launch.py": code % "node_executable"})
    assert finding.message.startswith("package 'robot' does not install the launch file 'it.launch.xml'")


def test_several_files_of_one_list(findings):
    (finding,) = findings("PKG004", **{"setup.py": listing("package.xml", "a.yaml", "b.yaml"), "resource/robot": ""})
    assert finding.message.endswith("another file is not there, either")


def of_launch_file(listed: str, **files: str) -> dict[str, str]:
    """A package that lists one launch file, and whose launch files are others."""
    setup = f"from setuptools import setup\nsetup(name='robot', data_files=[('share/robot/launch', ['{listed}'])],\n"
    setup += "      entry_points={'console_scripts': ['talker = robot.talker:main']})\n"
    return {"setup.py": setup, "launch/it.launch.xml": OF_OLD_NAME, **files}


def test_a_launch_file_that_is_listed_under_a_wrong_name_is_one_finding(findings):
    (finding,) = findings("PKG004", **of_launch_file("launch/it_launch.xml"))
    assert finding.message == (
        "data_files= lists a file that is not there: the build stops at 'launch/it_launch.xml'; did you mean "
        "'launch/it.launch.xml'?"
    )
    assert finding.help == "write 'launch/it.launch.xml'"


def test_a_launch_file_that_is_not_installed_beside_one_that_is_not_there(findings):
    vain, left_out = findings("PKG004", **of_launch_file("launch/follow_me.launch.xml"))[::-1]
    assert vain.help == "add the file, or take it off the list"
    assert "does not install the launch file 'it.launch.xml'" in left_out.message


@pytest.mark.parametrize(
    "files",
    [
        {".gitignore": "*.yaml\n"},
        {".gitignore": "a.yaml\n"},
        {".gitignore": "/a.*\n"},
        {"setup.py": "open('a.yaml', 'w').write('')\n" + listing("a.yaml")},
        {"setup.py": listing("a*.yaml")},
        {"setup.py": listing("a.yaml").replace("['a.yaml']", "files_of('.')")},
    ],
)
def test_a_file_that_may_be_made_before_the_build(findings, files):
    assert findings("PKG004", **{"setup.py": listing("a.yaml"), "resource/robot": ""} | files) == []


@pytest.mark.parametrize(
    ("build", "path"),
    [
        ({"setup.py": listing("films/test.mp4")}, b"films/test.mp4"),
        ({"package.xml": CMAKE, "CMakeLists.txt": INSTALLS_FILM}, b"films/test.mp4"),
    ],
    ids=["setup.py", "CMake"],
)
def test_a_file_that_git_has_and_this_checkout_never_had(findings, tmp_path, build, path):
    files = {"resource/robot": "", "launch/it.launch.xml": "<launch/>", **build}
    assert len(findings("PKG004", **files)) == 1
    (tmp_path / ".git").mkdir()
    (tmp_path / ".git" / "index").write_bytes(index_of([b"films/other.mp4"]))
    assert len(findings("PKG004", **files)) == 1
    (tmp_path / ".git" / "index").write_bytes(index_of([path]))
    assert findings("PKG004", **files) == []


BUILD = """project(robot)
find_package(ament_cmake REQUIRED)
{}
ament_package()
"""
OF_CMAKE = {"package.xml": CMAKE, "launch/it.launch.xml": "<launch/>"}
INSTALL = "install(DIRECTORY launch rviz DESTINATION share/${PROJECT_NAME})"


LIBRARY = "add_library(map src/map/map.cpp)\nadd_executable(mapper src/{}/main.cpp)"


def test_files_of_one_folder_that_is_not_there_are_one_finding(findings):
    (finding,) = findings("PKG004", **OF_CMAKE, **{"CMakeLists.txt": BUILD.format(LIBRARY.format("map"))})
    assert finding.message == (
        "add_library() lists a file that is not there: the build stops at 'src/map/map.cpp'; "
        "another file is not there, either"
    )
    assert [related.place.line for related in finding.related] == [4]


def test_the_first_folder_of_a_call_comes_first(findings):
    line = INSTALL.replace("launch rviz", "launch meshes worlds")
    files = {"CMakeLists.txt": BUILD.format(line), ".gitignore": "*.stl\n"}  # which may be all that meshes has
    (finding,) = findings("PKG004", **OF_CMAKE, **files)
    assert finding.message == (
        "install() lists a folder that is not there: the build stops at 'meshes'; another folder is not there, either"
    )
    [other] = finding.related
    assert "'worlds'" in other.message


def test_the_first_folder_of_a_file_comes_first(findings):
    lines = "\n".join(f"install(DIRECTORY {folder}/ DESTINATION share/robot/{folder})" for folder in ("meshes", "rviz"))
    files = {"CMakeLists.txt": BUILD.format(lines), ".gitignore": "*.stl\n"}
    (finding,) = findings("PKG004", **OF_CMAKE, **files)
    assert finding.message.startswith(
        "install() lists a folder that is not there: the build stops at 'meshes'; another"
    )
    assert [related.message.endswith("the build stops at 'rviz'") for related in finding.related] == [True]


@pytest.mark.parametrize(
    ("files", "meant"),
    [
        (["src/rviz/a.rviz"], "src/rviz"),
        (["src/rviz/a.rviz", "src/more/rviz/b.rviz"], "src/rviz"),
        (["src/rviz/a.rviz", "extra/rviz/b.rviz"], None),
        (["src/views/rviz/a.rviz"], None),
        (["test/rviz/a.rviz"], None),
    ],
)
def test_a_folder_that_lies_one_level_below(findings, files: list[str], meant: str | None):
    texts = dict.fromkeys(files, "")
    (finding,) = findings("PKG004", **OF_CMAKE, **{"CMakeLists.txt": BUILD.format(INSTALL)}, **texts)
    assert ("; did you mean" in finding.message) == (meant is not None)
    assert finding.help == (f"write '{meant}'" if meant else "add the folder, or take it off the list")


@pytest.mark.parametrize("same", [True, False])
def test_a_build_file_that_is_a_copy_of_the_one_in_a_package(findings, same: bool):
    cmake = BUILD.format("install(DIRECTORY views DESTINATION share/robot)")
    files = {"src/CMakeLists.txt": cmake + ("" if same else "\n"), "src/views/a.rviz": "", "CMakeLists.txt": cmake}
    (finding,) = findings("PKG004", **OF_CMAKE, **files)
    copied = "delete this file, which is a copy of src/CMakeLists.txt"
    assert finding.help == (copied if same else "write 'src/views'")


def test_a_folder_that_git_ignores_beside_one_that_is_not_there(findings):
    line = INSTALL.replace("launch rviz", "launch made worlds")
    (finding,) = findings("PKG004", **OF_CMAKE, **{"CMakeLists.txt": BUILD.format(line), ".gitignore": "made/\n"})
    assert finding.message.endswith("the build stops at 'worlds'")


def test_files_of_two_folders_that_are_not_there(findings):
    other = {"CMakeLists.txt": BUILD.format(LIBRARY.format("mapper")), "src/other.cpp": ""}
    assert len(findings("PKG004", **OF_CMAKE, **other)) == 2


@pytest.mark.parametrize(
    ("line", "message"),
    [
        (INSTALL, "install() lists a folder that is not there: the build stops at 'rviz'"),
        (
            INSTALL[:-1] + ' PATTERN "*.bak" EXCLUDE)',
            "install() lists a folder that is not there: the build stops at 'rviz'",
        ),
        (
            "install(FILES robot.yaml DESTINATION share/${PROJECT_NAME})",
            "install() lists a file that is not there: the build stops at 'robot.yaml'",
        ),
        (
            'rosidl_generate_interfaces(${PROJECT_NAME} "msg/Speed.msg" DEPENDENCIES std_msgs)',
            "rosidl_generate_interfaces() lists a file that is not there: the build stops at 'msg/Speed.msg'",
        ),
        (
            "add_subdirectory(drivers)",
            "add_subdirectory() needs a file that is not there: the build stops at 'drivers/CMakeLists.txt'",
        ),
    ],
)
def test_what_cmake_lists_and_is_not_there(findings, line, message):
    (finding,) = findings("PKG004", **OF_CMAKE, **{"CMakeLists.txt": BUILD.format(line)})
    assert finding.message == message
    assert (finding.place.file, finding.place.line) == ("CMakeLists.txt", 3)


@pytest.mark.parametrize(
    ("files", "listed", "right"),
    [
        ('"msg/Speed"', "msg/Speed", "msg/Speed.msg"),
        ("msg/Speed.msg, msg/Turn.msg", "msg/Speed.msg,", "msg/Speed.msg"),
        ('"srv/Stop" DEPENDENCIES std_msgs', "srv/Stop", "srv/Stop.srv"),
        ('"msg/Stop"', "msg/Stop", ""),
        ('"msg/Speed.msg", "msg/Turn.msg"', ",", ""),
    ],
)
def test_an_interface_that_is_listed_by_no_path_of_a_file(findings, files, listed, right):
    there = dict.fromkeys(("msg/Speed.msg", "msg/Turn.msg"), "float64 value\n") | {"srv/Stop.srv": "---\n"}
    cmake = BUILD.format(f"rosidl_generate_interfaces(${{PROJECT_NAME}} {files})")
    (finding,) = findings("PKG004", **OF_CMAKE, **there, **{"CMakeLists.txt": cmake})
    assert f"the build stops at '{listed}'" in finding.message
    assert finding.help == (f"write '{right}'" if right else "add the file, or take it off the list")


@pytest.mark.parametrize(
    "words",
    ['"msg/Speed.msg" DEPENDENCIES std_msgs', '"msg/Speed.msg" LIBRARY_NAME msg/robot', "${FILES}", "robot_msgs"],
)
def test_what_else_the_command_for_interfaces_is_given(findings, words):
    cmake = BUILD.format(f"rosidl_generate_interfaces(${{PROJECT_NAME}} {words})")
    assert findings("PKG004", **OF_CMAKE, **{"msg/Speed.msg": "float64 value\n", "CMakeLists.txt": cmake}) == []


@pytest.mark.parametrize(
    ("line", "files"),
    [
        (INSTALL, {"rviz/robot.rviz": ""}),
        (INSTALL, {".gitignore": "rviz/\n"}),
        (INSTALL, {".gitignore": "rviz/*\n"}),
        (INSTALL.replace("rviz", "meshes"), {".gitignore": "*.stl\n"}),
        (INSTALL, {".gitmodules": '[submodule "r"]\n\tpath = rviz\n\turl = https://example.org/r\n'}),
        (INSTALL.replace("rviz", '"our maps"'), {".gitmodules": '[submodule "m"]\n\tpath = our maps\n'}),
        (INSTALL.replace("DIRECTORY launch rviz", "FILES librobot.so"), {}),
        (INSTALL.replace(" DESTINATION", " OPTIONAL DESTINATION").replace(")", " OPTIONAL)"), {}),
        (INSTALL[:-1] + ' FILES_MATCHING PATTERN "*.rviz")', {}),
        (f"if(WITH_PICTURES)\n  {INSTALL}\nendif()", {}),
        (f"file(MAKE_DIRECTORY rviz)\n{INSTALL}", {}),
        (f"execute_process(COMMAND make_pictures)\n{INSTALL}", {}),
        (f"execute_process(COMMAND uname -m COMMAND tee rviz/robot.rviz)\n{INSTALL}", {}),
        (f"execute_process(COMMAND echo robot OUTPUT_FILE rviz/robot.rviz)\n{INSTALL}", {}),
        (f"execute_process(COMMAND git clone https://example.org/rviz)\n{INSTALL}", {}),
        (f"macro(paint)\n  execute_process(COMMAND uname)\nendmacro()\nexecute_process(COMMAND uname)\n{INSTALL}", {}),
        (f"exec_program(make_pictures)\n{INSTALL}", {}),
        (INSTALL.replace("rviz", "${CMAKE_CURRENT_BINARY_DIR}/rviz"), {}),
        (INSTALL.replace("rviz", "/usr/share/rviz"), {}),
        ("add_subdirectory(drivers)", {"drivers/CMakeLists.txt": ""}),
        ("add_subdirectory(drivers)", {".gitmodules": '[submodule "d"]\n\tpath = drivers\n\turl = https://a.org/d\n'}),
        ("if(WITH_DRIVERS)\n  add_subdirectory(drivers)\nendif()", {}),
        ("add_subdirectory(${DRIVERS})", {}),
        ("add_subdirectory(/usr/src/googletest googletest)", {}),
        ("file(COPY /opt/drivers DESTINATION .)\nadd_subdirectory(drivers)", {}),
    ],
    ids=[
        *("there", "ignored by git", "in it all ignored", "its meshes ignored"),
        *("a submodule", "one with a space", "a library", "optional", "files by pattern"),
        *("under a condition", "made", "made by a command", "in a pipe", "by an output", "cloned", "in a macro"),
        *("by an old command", "built", "elsewhere"),
        *("a part", "a submodule as a part", "a part under a condition", "by a variable", "of the system", "copied"),
    ],
)
def test_what_cmake_may_find(findings, line, files):
    assert findings("PKG004", **OF_CMAKE, **{"CMakeLists.txt": BUILD.format(line)}, **files) == []


@pytest.mark.parametrize(
    "command",
    [
        "COMMAND uname -m COMMAND tr -d '\\n' OUTPUT_VARIABLE ARCHITECTURE",
        "COMMAND git rev-parse HEAD OUTPUT_VARIABLE COMMIT",
    ],
)
def test_a_command_that_only_asks_makes_no_folder(findings, command):
    build = BUILD.format(f"execute_process({command})\n{INSTALL}")
    assert [row.place.line for row in findings("PKG004", **OF_CMAKE, **{"CMakeLists.txt": build})] == [4]


@pytest.mark.parametrize(
    "pattern", [".vscode/*", "/planning/rviz", "rviz/old/", "*.stl", "*.rviz", "rviz/\n!rviz/", "# rviz", ""]
)
def test_a_pattern_of_git_that_is_for_something_else(findings, pattern):
    files = {**OF_CMAKE, "CMakeLists.txt": BUILD.format(INSTALL), ".gitignore": f"{pattern}\n"}
    assert [row.place.line for row in findings("PKG004", **files)] == [3]


def test_a_program_of_a_folder_that_is_misspelt(findings):
    line = "install(PROGRAMS scipts/walk.py DESTINATION lib/${PROJECT_NAME})"
    (finding,) = findings("PKG004", **OF_CMAKE, **{"CMakeLists.txt": BUILD.format(line), "scripts/walk.py": ""})
    assert "the build stops at 'scipts/walk.py'; did you mean 'scripts/walk.py'?" in finding.message
    assert (finding.place.line, finding.help) == (3, "write 'scripts/walk.py'")


# --------------------------------------------------------------------------------------- files that nodes open

OPENS = """\
import os
from pathlib import Path
from ament_index_python.packages import get_package_share_directory, get_package_share_path

def load():
    {lines}
"""
JOINED = "return open(os.path.join(get_package_share_directory('robot'), 'data', 'words.json'))"


@pytest.mark.parametrize(
    "lines",
    [
        JOINED,
        "share = get_package_share_directory('robot')\n    return open(os.path.join(share, 'data/words.json'))",
        "return open(get_package_share_directory('robot') + '/data/words.json')",
        "share = get_package_share_directory('robot')\n    return open(f'{share}/data/words.json')",
        "data = get_package_share_directory('robot') + '/data'\n    return open(data + '/words.json')",
        "return Path(get_package_share_directory('robot')) / 'data' / 'words.json'",
        "return get_package_share_path('robot') / 'data' / 'words.json'",
        "name = 'words.json'\n    return open(os.path.join(get_package_share_directory('robot'), 'data', name))",
        "words = open(os.path.join(get_package_share_directory('robot'), 'data', 'words.json'))",
    ],
)
def test_a_file_that_a_node_looks_for(findings, lines):
    files = {"robot/words.py": OPENS.format(lines=lines), "data/words.json": "{}"}
    (finding,) = findings("PKG004", **files)
    assert finding.message == (
        "package 'robot' does not install the file 'data/words.json', which robot/words.py looks for in its share "
        "folder"
    )
    assert (finding.place.file, finding.help) == (
        "setup.py",
        "add ('share/robot/data', ['data/words.json']) to data_files=",
    )
    installed = SETUP.replace("data_files=[", "data_files=[('share/robot/data', ['data/words.json']), ")
    assert findings("PKG004", **files, **{"setup.py": installed}) == []


@pytest.mark.parametrize(
    "lines",
    [
        JOINED.replace("'data'", "folder"),
        JOINED.replace("'robot'", "package"),
        JOINED.replace("'robot'", "'elsewhere'"),
        JOINED.replace("words.json", "others.json"),
        "path = " + JOINED.removeprefix("return ") + "\n    return path if os.path.exists('x') else None",
        "share = get_package_share_directory('robot')\n    share = '/'\n    os.path.join(share, 'data/words.json')",
        "return open(get_package_share_directory('robot') + '/data/' + kind + '/words.json')",
        "return open(get_package_share_directory('robot') + 'data/words.json')",
        "return os.path.join(get_package_share_directory('robot'), '..', 'data')",
        "return open(f'{get_package_share_directory(robot)}/data/words.json')",
        "share = get_package_share_directory('robot')\n    share += '/a'\n    return open(share + '/data/words.json')",
        "path = get_package_share_path('robot') / 'data/words.json'\n    return path if path.is_file() else 1",
        "words = os.path.join(get_package_share_directory('robot'), 'data', 'words.json')\n    return 1",  # unused
    ],
)
def test_a_file_that_may_be_elsewhere(findings, lines):
    assert findings("PKG004", **{"robot/words.py": OPENS.format(lines=lines), "data/words.json": "{}"}) == []


def test_a_file_that_is_installed_elsewhere(findings):
    files = {"robot/words.py": OPENS.format(lines=JOINED), "data/words.json": "{}"}
    installed = SETUP.replace("data_files=[", "data_files=[('share/robot', ['data/words.json']), ")
    (finding,) = findings("PKG004", **files, **{"setup.py": installed})
    assert finding.message == (
        "package 'robot' installs the file 'data/words.json' elsewhere than where robot/words.py looks for it: "
        "it comes to 'share/robot/words.json'"
    )
    assert finding.help == "add ('share/robot/data', ['data/words.json']) to data_files="


OPENS_IN_CPP = """\
#include <ament_index_cpp/get_package_share_directory.hpp>
#include <rclcpp/rclcpp.hpp>

int main(int argc, char ** argv)
{{
  rclcpp::init(argc, argv);
  {lines}
  auto node = std::make_shared<rclcpp::Node>("words");
  load(node, path);
  rclcpp::spin(node);
}}
"""
SHARE_IN_CPP = 'const std::string share = ament_index_cpp::get_package_share_directory("robot");'


def of_cpp_code(lines: str, installed: str) -> dict[str, str]:
    build = "find_package(rclcpp REQUIRED)\nadd_executable(words src/words.cpp)\n" + installed
    return {
        **OF_CMAKE,
        "CMakeLists.txt": BUILD.format(build),
        "src/words.cpp": OPENS_IN_CPP.format(lines=lines),
        "data/words.json": "{}",
    }


@pytest.mark.parametrize(
    "lines",
    [
        f'{SHARE_IN_CPP}\n  std::string path = share + "/data/words.json";',
        f'{SHARE_IN_CPP}\n  std::string path = share + "/" + "data/words.json";',
        'auto path = std::filesystem::path(ament_index_cpp::get_package_share_directory("robot")) / "data/words.json";',
    ],
)
def test_a_file_that_a_node_of_cpp_looks_for(findings, lines):
    (finding,) = findings("PKG004", **of_cpp_code(lines, "install(DIRECTORY data/ DESTINATION share/${PROJECT_NAME})"))
    assert "installs the file 'data/words.json' elsewhere than where src/words.cpp looks for it" in finding.message
    assert finding.help == "write install(FILES data/words.json DESTINATION share/${PROJECT_NAME}/data)"
    (finding,) = findings("PKG004", **of_cpp_code(lines, ""))
    assert "does not install the file 'data/words.json', which src/words.cpp looks for" in finding.message
    assert findings("PKG004", **of_cpp_code(lines, "install(DIRECTORY data DESTINATION share/${PROJECT_NAME})")) == []


def test_ament_package_installs_the_manifest(findings):
    assert findings("PKG004", **of_cpp_code(f'{SHARE_IN_CPP}\n  std::string path = share + "/package.xml";', "")) == []
    code = OPENS.format(lines="return open(get_package_share_directory('robot') + '/package.xml')")
    (finding,) = findings("PKG004", **{"robot/words.py": code, "setup.py": SETUP.replace("'package.xml'", "")})
    assert "does not install the file 'package.xml', which robot/words.py looks for" in finding.message


@pytest.mark.parametrize(
    "lines",
    [
        f'{SHARE_IN_CPP}\n  auto path = share + "/data/" + argv[1] + ".json";',
        f'{SHARE_IN_CPP}\n  auto path = share + "/data/words.json";\n  if (!std::filesystem::exists(path)) return 1;',
        f'// {SHARE_IN_CPP}\n  auto path = share + "/data/words.json";',
    ],
)
def test_a_file_of_cpp_that_may_be_elsewhere(findings, lines):
    assert findings("PKG004", **of_cpp_code(lines, "")) == []


OF_LAUNCH = """\
import os
import yaml
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import ExecuteProcess

def generate_launch_description():
    name = 'robot'
    share = os.path.join(get_package_share_directory(name))
    {line}
    return LaunchDescription([])
"""
OPENED = "open(os.path.join(share, 'data', 'a.json'))"
LISTED = "os.listdir(os.path.join(share, 'bags'))"
PLAYED = "ExecuteProcess(cmd=['ros2', 'bag', 'play', os.path.join(share, 'bags', 'fast')])"
CMAKE_INSTALLS = "install(DIRECTORY launch{} DESTINATION share/${{PROJECT_NAME}})"


def of_launch_code(line: str, installed: str = CMAKE_INSTALLS.format(""), **more: str) -> dict[str, str]:
    """A package of CMake with a launch file that says a line, a parameter file and a bag."""
    files = {
        "data/a.json": "{}",
        "urdf/a.urdf": "<robot/>",
        "bags/fast/metadata.yaml": "{}",
        "bags/fast/fast_0.db3": "",
    }
    cmake = {"CMakeLists.txt": BUILD.format(installed), "launch/up.launch.py": OF_LAUNCH.format(line=line)}
    return {**OF_CMAKE, **files, **cmake, **more}


@pytest.mark.parametrize(
    ("line", "folder", "help"),
    [
        (PLAYED, "bags/fast", "write install(DIRECTORY bags/fast DESTINATION share/${PROJECT_NAME}/bags)"),
        (LISTED, "bags", "write install(DIRECTORY bags DESTINATION share/${PROJECT_NAME})"),
    ],
)
def test_a_folder_that_a_launch_file_looks_for(findings, line, folder, help):
    (finding,) = findings("PKG004", **of_launch_code(line))
    assert f"does not install the folder '{folder}', which launch/up.launch.py looks for" in finding.message
    assert (finding.place.file, finding.help) == ("CMakeLists.txt", help)
    assert [(row.place.file, row.place.line) for row in finding.related] == [("launch/up.launch.py", 10)]


def test_a_file_that_a_launch_file_opens_is_told_once(findings):
    files = of_launch_code(OPENED)
    told = [*findings("PKG004", **files), *findings("LCH004", **files)]
    assert ["does not install the" in row.message and "data/a.json" in row.message for row in told] == [True]


def test_a_file_that_a_launch_file_gives_to_a_node_is_told_there(findings):
    given = "Node(package='robot', executable='talker', parameters=[os.path.join(share, 'data', 'a.yaml')])"
    line = f"from launch_ros.actions import Node; return LaunchDescription([{given}])"
    files = of_launch_code(line, **{"data/a.yaml": "talker:\n  ros__parameters:\n    rate: 1.0\n"})
    assert findings("PKG004", **files) == []
    assert [row.place.file for row in findings("LCH004", **files)] == ["launch/up.launch.py"]


def test_a_folder_that_a_setup_file_leaves_out(findings):
    files = {"robot/words.py": OPENS.format(lines="return " + JOINED[12:].replace(", 'words.json')", ""))}
    (finding,) = findings("PKG004", **files, **{"data/words.json": "{}"})
    assert finding.help == "add ('share/robot/data', glob('data/*')) to data_files="


@pytest.mark.parametrize(
    ("line", "more"),
    [
        (OPENED, {"installed": CMAKE_INSTALLS.format(" data")}),
        (PLAYED, {"installed": CMAKE_INSTALLS.format(" bags")}),
        (
            PLAYED,
            {"installed": CMAKE_INSTALLS.format("") + "\ninstall(DIRECTORY urdf/ DESTINATION share/robot/bags/fast)"},
        ),
        (
            PLAYED,
            {"installed": CMAKE_INSTALLS.format("") + "\ninstall(FILES bags/fast/metadata.yaml DESTINATION bags)"},
        ),
        (PLAYED, {"installed": CMAKE_INSTALLS.format("") + "\ninstall_bags(bags)"}),
        (PLAYED.replace("'fast'", "'slow'"), {}),
        (OPENED.replace("share,", "share, LaunchConfiguration('a'),"), {}),
        ("if os.path.exists('x'): " + OPENED, {}),
        ("name = 'other'; " + OPENED, {}),
    ],
)
def test_what_is_installed_or_may_be(findings, line, more):
    assert findings("PKG004", **of_launch_code(line, **more)) == []


def test_a_folder_in_which_only_its_place_is_kept(findings):
    files = of_launch_code(PLAYED.replace("'fast'", "'slow'"), **{"bags/slow/.gitkeep": ""})
    assert findings("PKG004", **files) == []


# ------------------------------------------------------------------------------- folders among what a pattern matches

WORLDS = """from glob import glob
import os
from setuptools import setup
setup(name='robot', packages=['robot'], entry_points={{'console_scripts': ['talker = robot.talker:main']}},
      data_files=[('share/robot/launch', glob('launch/*')), ('share/robot/worlds', {listed})])
"""


@pytest.mark.parametrize("listed", ["glob('worlds/*')", "glob('worlds/m*')", "glob(os.path.join('worlds', '*'))"])
def test_a_folder_among_the_files_of_a_pattern(findings, listed):
    files = {"worlds/hall.world": "", "worlds/models/box.sdf": "", "robot/__init__.py": ""}
    (finding,) = findings("PKG004", **files, **{"setup.py": WORLDS.format(listed=listed)})
    assert "matches a folder, 'worlds/models': the build stops, as it copies files alone" in finding.message


@pytest.mark.parametrize(
    "listed",
    [
        "glob('worlds/*.world')",
        "glob('worlds/*.*')",
        "glob('worlds/models/*')",
        "[path for path in glob('worlds/*') if os.path.isfile(path)]",
        "['worlds/hall.world']",
    ],
)
def test_a_pattern_that_matches_files_alone(findings, listed):
    files = {"worlds/hall.world": "", "worlds/models/box.sdf": "", "robot/__init__.py": ""}
    assert findings("PKG004", **files, **{"setup.py": WORLDS.format(listed=listed)}) == []


# ------------------------------------------------------------------------------- what CMake builds, and is not there


@pytest.mark.parametrize(
    ("line", "command", "file"),
    [
        ("install(PROGRAMS scripts/drive.py DESTINATION lib/robot)", "install()", "scripts/drive.py"),
        ("add_executable(drive src/drive.cpp)", "add_executable()", "src/drive.cpp"),
        ("add_library(parts SHARED src/parts.cpp)", "add_library()", "src/parts.cpp"),
        (
            "if(BUILD_TESTING)\n  ament_add_pytest_test(drives test/test_drive.py TIMEOUT 60)\nendif()",
            "ament_add_pytest_test()",
            "test/test_drive.py",
        ),
    ],
)
def test_a_source_that_is_not_there(findings, line, command, file):
    files = {"package.xml": CMAKE, "CMakeLists.txt": f"project(robot)\n{line}\nament_package()\n"}
    (finding,) = findings("PKG004", **files)
    assert finding.message == f"{command} lists a file that is not there: the build stops at '{file}'"
    assert findings("PKG004", **files, **{file: ""}) == []


@pytest.mark.parametrize(
    "lines",
    [
        "if(WITH_GUI)\n  add_executable(gui src/gui.cpp)\nendif()",
        "add_custom_command(OUTPUT src/made.cpp COMMAND make)\nadd_executable(drive src/made.cpp)",
        "FetchContent_Declare(json)\nadd_library(json src/json.cpp)",
        "add_executable(drive ${GENERATED}/drive.cpp)",
    ],
)
def test_a_source_that_may_be_made(findings, lines):
    assert findings("PKG004", **{"package.xml": CMAKE, "CMakeLists.txt": f"project(robot)\n{lines}\n"}) == []


def test_a_setup_py_that_the_build_never_runs(findings):
    build = "project(robot)\nfind_package(ament_cmake REQUIRED)\nfind_package(ament_cmake_python REQUIRED)\n"
    build += "ament_python_install_package(robot)\ninstall(DIRECTORY worlds DESTINATION share/robot)\nament_package()\n"
    files = {"worlds/hall.world": "", "worlds/models/box.sdf": "", "robot/__init__.py": "", "CMakeLists.txt": build}
    setup = WORLDS.format(listed="glob('worlds/*')")
    assert findings("PKG004", **files, **{"setup.py": setup, "package.xml": manifest(build_type="ament_cmake")}) == []


def test_a_module_beside_a_folder_of_its_name(findings):
    """Both are ``robot.lib.words``."""
    files = {
        "robot/__init__.py": "",
        "robot/lib/__init__.py": "",
        "robot/lib/words.py": "from .words import HELLO\n",
        "robot/lib/words/__init__.py": "from .greetings import HELLO\n",
        "robot/lib/words/greetings.py": "HELLO = 'hello'\n",
        "robot/talker.py": "from robot.lib.words import HELLO\n" + TALKER,
    }
    (finding,) = findings("PKG004", **files, **{"setup.py": setup("['robot']")})
    assert finding.message.startswith("packages= leaves out 'robot.lib', which robot/talker.py imports")
