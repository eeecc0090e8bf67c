"""PKG013: programs that are installed where ros2 run and launch do not look."""

from __future__ import annotations

import pytest

from archlint.finding import Severity
from robot_package import SETUP, TALKER, manifest

RIGHT = "[develop]\nscript_dir=$base/lib/robot\n[install]\ninstall_scripts=$base/lib/robot\n"
TOOL = "def main():\n    print('a tool')\n"


@pytest.mark.parametrize(
    ("text", "file", "where"),
    [
        ("", "setup.py", "is installed in bin"),
        ("[metadata]\nname = robot\n", "setup.py", "is installed in bin"),
        ("[develop]\nscript_dir=$base/lib/robot\n", "setup.py", "is installed in bin"),
        (RIGHT.replace("lib/robot", "lib/old"), "setup.cfg", "is installed in lib/old"),
    ],
)
def test_programs_that_nobody_finds(findings, text, file, where):
    (told,) = findings("PKG013", **{"setup.cfg": text})
    assert where in told.message and "they want lib/robot" in told.message
    assert told.place.file == file


MARKED = SETUP.replace("data_files=[", "data_files=[('share/ament_index/resource_index/packages', ['resource/old']), ")


def test_a_package_that_is_indexed_under_two_names_is_found_under_both(findings):
    old = {"setup.cfg": RIGHT.replace("lib/robot", "lib/old"), "resource/old": ""}
    assert findings("PKG013", **old, **{"setup.py": MARKED}) == []
    assert len(findings("PKG013", **old)) == 1


@pytest.mark.parametrize(
    "files",
    [
        {"setup.cfg": RIGHT},
        {"setup.cfg": RIGHT.replace("install_scripts", "install-scripts")},
        {"setup.cfg": RIGHT.replace("=$base", " = $base") + "[tool:pytest]\naddopts = -q\n"},
        {"setup.cfg": RIGHT.replace("$base/lib/robot", "$base/libexec")},
        {"setup.cfg": "no section\n"},
        {"setup.cfg": "", "robot/talker.py": TOOL, "launch/it.launch.xml": "<launch/>"},
        {"setup.cfg": "", "setup.py": SETUP + "OPTIONS = {'install': {'install_scripts': '$base/lib/robot'}}\n"},
        {"setup.cfg": "", "package.xml": manifest(build_type="ament_cmake")},
    ],
)
def test_programs_that_are_found_or_may_be(findings, files):
    assert findings("PKG013", **files) == []


def test_a_tool_that_a_launch_file_starts_is_a_program(findings):
    launch = '<node pkg="robot" exec="talker"/>'
    (told,) = findings("PKG013", launch, **{"setup.cfg": "", "robot/talker.py": TOOL})
    assert told.message.startswith("'talker' is installed in bin")
    assert TALKER != TOOL


NO_PROGRAMS = SETUP.replace("'talker = robot.talker:main'", "")
OF_ANOTHER = RIGHT.replace("lib/robot", "lib/old")


def test_a_package_without_programs_that_names_the_folder_of_another(findings):
    """Nothing is installed there yet; the next one to add a program will not find it."""
    (told,) = findings("PKG013", **{"setup.py": NO_PROGRAMS, "setup.cfg": OF_ANOTHER})
    assert (told.place.file, told.place.line, told.severity) == ("setup.cfg", 4, Severity.INFO)
    assert told.message.startswith("programs of the package would be installed in lib/old")


@pytest.mark.parametrize(
    "files",
    [
        {"setup.py": NO_PROGRAMS, "setup.cfg": RIGHT},
        {"setup.py": NO_PROGRAMS, "setup.cfg": ""},
        {"setup.py": "from tools import scripts\n" + NO_PROGRAMS.replace("[]", "scripts()"), "setup.cfg": OF_ANOTHER},
        {"setup.cfg": OF_ANOTHER, "robot/talker.py": TOOL},
    ],
)
def test_packages_without_programs_for_ros(findings, files):
    assert findings("PKG013", **files) == []
