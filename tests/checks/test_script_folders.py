"""PKG013: programs that are installed where ros2 run and launch do not look."""

from __future__ import annotations

import pytest

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
