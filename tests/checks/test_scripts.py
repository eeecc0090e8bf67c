"""PKG006: installed scripts that the system cannot start."""

from __future__ import annotations

import pytest

from robot_package import CMAKE, SCRIPTS, node

GUARD = "if __name__ == '__main__':\n    main()\n"
DRIVE = "import rclpy\n\n\ndef main():\n    rclpy.init()\n    rclpy.spin(rclpy.create_node('drive'))\n\n\n"
HERE = {"package.xml": CMAKE, "CMakeLists.txt": SCRIPTS}
START = node(exec="drive.py")


def test_a_program_without_a_first_line(findings):
    (finding,) = findings("PKG006", **HERE, **{"scripts/drive.py": DRIVE + GUARD})
    assert finding.message == (
        "ros2 run and launch cannot start 'drive.py' of package 'robot': it does not begin with a #! line"
    )
    assert (finding.place.file, finding.place.line) == ("scripts/drive.py", 1)
    assert [row.place.file for row in finding.related] == ["CMakeLists.txt"]


def test_a_script_that_a_launch_file_starts(findings):
    (finding,) = findings("PKG006", START, **HERE, **{"scripts/drive.py": DRIVE})
    assert [row.place.file for row in finding.related] == ["CMakeLists.txt", "launch/it.launch.xml"]


def test_a_comment_in_front_of_the_first_line(findings):
    text = "# drives\n#!/usr/bin/env python3\n" + DRIVE + GUARD
    (finding,) = findings("PKG006", **HERE, **{"scripts/drive.py": text})
    assert finding.message.endswith(": its #! line is line 2, and not the first")
    assert finding.help == "move the #! line to the top of the file"


@pytest.mark.parametrize(("asks", "launch", "told"), [(3, "", 0), (2, "", 1), (3, START, 1)])
def test_an_exercise_that_nobody_has_done_and_nothing_starts(findings, asks: int, launch: str, told: int):
    text = DRIVE.replace("    rclpy.init()\n", "    # TODO: subscribe\n" * asks + "    rclpy.init()\n") + GUARD
    assert len(findings("PKG006", launch, **HERE, **{"scripts/drive.py": text})) == told


def test_a_first_line_that_ends_as_on_windows(findings, tmp_path):
    text = "#!/usr/bin/env python3\n" + DRIVE + GUARD
    (finding,) = findings("PKG006", **HERE, **{"scripts/drive.py": text.replace("\n", "\r\n")})
    assert finding.help == "save the file with Unix line endings"


def test_a_template_that_nothing_starts(findings):
    here = {**HERE, "CMakeLists.txt": SCRIPTS.replace("drive", "drive_template")}
    assert findings("PKG006", **here, **{"scripts/drive_template.py": DRIVE + GUARD}) == []
    assert findings("PKG006", node(exec="drive_template.py"), **here, **{"scripts/drive_template.py": DRIVE + GUARD})


def test_several_scripts_of_a_package_are_one_finding(findings):
    install = "install(PROGRAMS scripts/drive.py scripts/stop.py DESTINATION lib/robot)\n"
    scripts = {f"scripts/{name}.py": DRIVE + GUARD for name in ("drive", "stop")}
    (finding,) = findings("PKG006", **{**HERE, "CMakeLists.txt": install}, **scripts)
    assert finding.message.endswith("; another script is like that")


@pytest.mark.parametrize(
    ("launch", "files"),
    [
        ("", {"scripts/drive.py": "#!/usr/bin/env python3\n" + DRIVE + GUARD}),
        (START, {"scripts/drive.py": "#!/usr/bin/python3\n" + DRIVE}),
        ("", {"scripts/drive.py": DRIVE}),  # a module beside the programs
        ("", {"scripts/drive.py": DRIVE + GUARD, "scripts/all.py": "import rclpy\nimport drive\n"}),
        (node(exec="drive.py", **{"launch-prefix": "python3 -u"}), {"scripts/drive.py": DRIVE + GUARD}),
        ("", {"CMakeLists.txt": SCRIPTS.replace("lib/robot", "share/robot"), "scripts/drive.py": DRIVE + GUARD}),
    ],
)
def test_scripts_that_can_be_started_or_are_no_programs(findings, launch, files):
    assert findings("PKG006", launch, **{**HERE, **files}) == []


def test_setuptools_writes_the_first_line_of_an_entry_point(findings):
    assert findings("PKG006", **{"robot/talker.py": DRIVE + GUARD}) == []
