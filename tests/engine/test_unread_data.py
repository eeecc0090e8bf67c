"""LNT002 of what tools of ROS read at run time: descriptions that are no XML, parameter files that are no YAML."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Finding
from robot_package import write_files

MANIFEST = """\
<package format="3">
  <name>robot</name><version>0.1.0</version><description>d</description><license>MIT</license>
  <maintainer email="a@example.org">A</maintainer>
  <export><build_type>ament_cmake</build_type></export>
</package>
"""
CMAKE = "cmake_minimum_required(VERSION 3.8)\nproject(robot)\nfind_package(ament_cmake REQUIRED)\nament_package()\n"
XACRO = '<?xml version="1.0"?>\n<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="r">\n  {}\n</robot>\n'
SDF = '<?xml version="1.0"?>\n<sdf version="1.7">\n  {}\n</sdf>\n'
PLUGINS = '<library path="robot">\n  <class type="robot::Arm" base_class_type="base::Base">\n    {}\n</library>\n'


@pytest.fixture
def told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """The places of LNT002 in a package with one more file."""
    monkeypatch.chdir(tmp_path)

    def run(path: str, text: str, asked: str = ".", **files: str) -> list[tuple[str, int]]:
        for name, content in {"package.xml": MANIFEST, "CMakeLists.txt": CMAKE, path: text, **files}.items():
            file = tmp_path / "robot" / name
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(content, encoding="utf-8")
        findings = check(Request((asked,), load(Path()), False, 1)).findings
        return [(row.place.file, row.place.line) for row in findings if row.code == "LNT002"]

    return run


@pytest.mark.parametrize(
    ("path", "text", "line"),
    [
        ("urdf/arm.xacro", XACRO.format('<link name="base">'), 4),
        ("urdf/arm.urdf.xacro", XACRO.format("<!-- a <!-- nested --> comment -->"), 3),
        ("urdf/arm.xacro", "\n" + XACRO.format(""), 2),
        ("urdf/arm.xacro", XACRO.replace(' xmlns:xacro="http://www.ros.org/wiki/xacro"', "").format("<xacro:a/>"), 3),
        ("urdf/arm.xacro", XACRO.format("") + "<robot/>\n", 5),
        ("urdf/arm.urdf", XACRO.format('<link name="base" name="other"/>'), 3),
        ("config/arm.srdf", XACRO.format('<link name="a"/-->'), 3),
        ("worlds/hall.sdf", SDF.format('<world name="a"></wrold>'), 3),
        ("worlds/hall.world", "# a world\n" + SDF.format(""), 1),  # a declaration has to be the first
        ("worlds/hall.sdf", SDF.replace("<sdf", "Speed < 3, see <sdf").format(""), 2),
        ("urdf/arm.urdf", XACRO.replace("<robot", "An arm.\n<robot").format(""), 2),
        ("worlds/hall.sdf", SDF.format("<?ignore>\n  <collision name='a'>\n<?>"), 6),
        ("urdf/arm.xacro", XACRO.format("<?ignore>"), 3),
        ("plugins.xml", PLUGINS.format("<description>An arm.</description>"), 4),
        ("controllers.xml", PLUGINS.format("<description>An arm.</description>"), 4),
        ("robot_plugin.xml", PLUGINS.format("<description>An arm.</class>"), 3),
    ],
)
def test_a_description_that_is_no_xml(told, path, text, line):
    assert told(path, text) == [(f"robot/{path}", line)]


@pytest.mark.parametrize(
    ("path", "text"),
    [
        ("urdf/arm.xacro", XACRO.format('<xacro:include filename="b.xacro"/>')),
        ("urdf/arm.urdf", "\n" + XACRO.format('<link name="base"/>')),
        ("worlds/hall.sdf", SDF.format("<!-- --- the floor --- -->")),
        ("worlds/stage.world", "# for Stage\ndefine block model (size [0.5 0.5 0.5])\n\nblock (pose [0 0 0 0])\n"),
        ("worlds/hall.sdf", SDF.format("") + "\nnotes\n"),
        ("worlds/hall.sdf", SDF.replace("<sdf", "Notes: -p 'a: [1]' & so on\n\n<!-- x -->\n<sdf").format("")),
        ("worlds/hall.world", "a world\n" + SDF.partition("\n")[2].format("")),
        ("worlds/hall.sdf", SDF.format("<?ignore>\n  <collision name='a'/>\n<?>")),
        ("worlds/hall.world", SDF.format("<uri>https://example.org/?a=1&b=2</uri>")),
        ("worlds/hall.sdf", SDF.format('<world name="{{ name }}">')),
        ("worlds/hall.sdf", SDF.format("@[if indoors]<world>@[end if]")),
        ("urdf/arm.xacro", '<!DOCTYPE robot [<!ENTITY a "b">]>\n' + XACRO.format("&a;")),
        ("urdf/arm.xacro", ""),
        ("test/broken.xacro", XACRO.format('<link name="base">')),
        ("old/arm.xacro", XACRO.format('<link name="base">')),
        ("data/list.xml", "<list>"),
        ("plugins.xml", PLUGINS.format("<description>An arm.</description>\n  </class>")),
    ],
)
def test_a_description_that_its_reader_takes_or_that_is_not_in_use(told, path, text):
    assert told(path, text) == []


def test_one_flaw_that_several_files_of_a_package_have_is_one_finding(told):
    broken = SDF.format("<model></modle>")
    files = {"models/b/model.sdf": broken, "models/c/model.sdf": SDF.format("<model")}
    assert told("models/a/model.sdf", broken, **files) == [
        ("robot/models/a/model.sdf", 3),
        ("robot/models/c/model.sdf", 4),
    ]


def test_a_package_that_was_not_asked_for(told):
    other = MANIFEST.replace("robot", "other")
    files = {"../other/package.xml": other, "../other/CMakeLists.txt": CMAKE.replace("robot", "other")}
    assert told("urdf/arm.xacro", XACRO.format("<link>"), "other", **files) == []


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("talker:\n  ros__parameters:\n    topics: [a, # the first\n    rate: 10\n", 5),  # YAML gives up at the end
        ("About the talker. It is slow.\ntalker:\n  ros__parameters:\n    rate: 10\n", 2),
        ("talker:\n  ros__parameters:\n    rate: 10\n   name: a\n", 4),
    ],
)
def test_a_parameter_file_that_is_no_yaml_and_that_no_launch_file_loads(told, text, line):
    assert told("config/talker.yaml", text) == [("robot/config/talker.yaml", line)]


@pytest.mark.parametrize(
    ("path", "text"),
    [
        ("config/talker.yaml", "talker:\n  ros__parameters:\n    rate: 10\n"),
        ("config/talker.yaml", "talker:\n  ros__parameters:\n    rate: {{ rate }}\n"),
        ("config/talker.yaml", "talker:\n  ros__parameters:\n    {% if fast %}\n    rate: 10\n    {% endif %}\n"),
        ("config/notes.yaml", "a: [b\n"),
        ("test/talker.yaml", "talker:\n  ros__parameters:\n    rate: [1\n"),
    ],
)
def test_a_parameter_file_that_is_yaml_or_a_template_or_no_parameter_file(told, path, text):
    assert told(path, text) == []


@pytest.mark.parametrize(("setup", "lines"), [("setup(name='<package-name>')\n", []), ("setup(name='robot')\n", [2])])
def test_a_manifest_in_which_a_script_fills_in_the_name(told, setup: str, lines: list[int]):
    manifest = MANIFEST.replace("robot", "<package-name>")
    places = told("package.xml", manifest, **{"setup.py": f"from setuptools import setup\n\n{setup}"})
    assert places == [("robot/package.xml", line) for line in lines]


def test_the_marks_of_a_merge_are_told_as_such(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)
    merge = "<<<<<<< HEAD\n{0}1\n=======\n{0}2\n>>>>>>> 1a2b3c4\n"
    files = {
        "package.xml": MANIFEST,
        "CMakeLists.txt": CMAKE,
        "scripts/talker.py": "import rclpy\n" + merge.format("RATE = "),
        "config/talker.yaml": "talker:\n  ros__parameters:\n" + merge.format("    rate: "),
        "scripts/listener.py": "import rclpy\nRATE = = 1\n",
    }
    for name, content in files.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(content, encoding="utf-8")
    findings = check(Request((".",), load(tmp_path), False, 1)).findings
    told = {row.place.file: "the marks of a merge" in row.message for row in findings if row.code == "LNT002"}
    assert told == {"config/talker.yaml": True, "scripts/listener.py": False, "scripts/talker.py": True}


def test_a_cmake_file_that_cannot_be_parsed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "package.xml").write_text(MANIFEST, encoding="utf-8")
    (tmp_path / "CMakeLists.txt").write_text("project(robot)\nDEPENDENCIES std_msgs\n", encoding="utf-8")
    (told,) = [row for row in check(Request((".",), load(tmp_path), False, 1)).findings if row.code == "LNT002"]
    assert (told.place.file, told.place.line) == ("CMakeLists.txt", 2)
    assert told.message.startswith("CMake cannot read this file: 'DEPENDENCIES' is no command")


def unread() -> list[Finding]:
    findings = check(Request((".",), load(Path()), False, 1)).findings
    return [found for found in findings if found.code == "LNT002"]


EMPTY = "this file is empty"
COMMENTED = "<!-- <launch>\n  <!-- the robot -->\n  <let name='a' value='1'/>\n</launch> -->\n"


@pytest.mark.parametrize(
    ("path", "text", "expected"),
    [
        ("launch/a.launch.xml", "", (EMPTY, "delete it, or write it", "INFO")),
        ("package.xml", "", (EMPTY, "delete it, or write it", "WARNING")),
        (
            "launch/a.launch.xml",
            "<!-- later -->",
            ("nothing is in this file but a comment", "delete it, or write it", "INFO"),
        ),
        (
            "launch/a.launch.xml",
            COMMENTED,
            (
                "the whole file is in a comment, in which there are others, so that it is no XML",
                "delete it, or take it out of the comment",
                "INFO",
            ),
        ),
        (
            "launch/a.launch.xml",
            "<!-- <launch> -->\n<launch>\n",
            ("malformed XML: no element found", "correct it: until then nothing in this file is checked", "WARNING"),
        ),
    ],
)
def test_xml_with_nothing_in_it(tmp_path, monkeypatch, path, text, expected):
    monkeypatch.chdir(tmp_path)
    write_files(tmp_path / "robot", {"package.xml": MANIFEST, "CMakeLists.txt": CMAKE, path: text})
    (found,) = unread()
    assert (found.code, (found.message, found.help, found.severity.name)) == ("LNT002", expected)


def test_empty_launch_files_beside_each_other_are_one_finding(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    texts = {"launch": "", "launch/more": "\n"}
    files = {f"{folder}/{name}.launch.xml": text for folder, text in texts.items() for name in ("a", "b")}
    write_files(tmp_path / "robot", {"package.xml": MANIFEST, "CMakeLists.txt": CMAKE, **files})
    assert [(found.place.file, found.message) for found in unread()] == [
        (f"robot/{folder}/a.launch.xml", f"{EMPTY}; another file beside it is empty, too")
        for folder in ("launch", "launch/more")
    ]


def test_links_into_one_folder_that_is_not_there_are_one_finding(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    write_files(tmp_path / "robot", {"package.xml": MANIFEST, "CMakeLists.txt": CMAKE})
    for name in ("a", "b", "c"):
        (tmp_path / "robot" / f"{name}.py").symlink_to(tmp_path / "home" / name / "it.py")
    (found,) = unread()
    absent = f"is a broken symbolic link: there is no '{tmp_path / 'home'}' here"
    assert found.message == f"{absent}; 2 more links lead there, too"
    assert found.help.startswith("remove it, or make it a link to a file of the workspace")
