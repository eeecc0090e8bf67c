"""PKG011: package.xml files that colcon refuses."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Finding
from robot_package import CMAKE, SETUP, SETUP_OF, write_files

MAIL = 'email="a@example.org"'


@pytest.fixture
def full() -> str:
    """A whole manifest."""
    more = (
        f"<version>0.1.0</version><description>d</description><maintainer {MAIL}>A</maintainer><license>MIT</license>"
    )
    return "<package format='3'><name>robot</name>" + more + "{}</package>"


def test_all_of_a_file_is_one_finding(findings, full):
    text = full.replace("0.1.0", "1").replace(MAIL, 'email="a"').format("")
    (finding,) = findings("PKG011", **{"package.xml": text, "setup.py": SETUP})
    assert finding.message == (
        "colcon does not take 'robot' for a package of ROS, and builds it as plain Python: '1' is no version of three "
        "numbers"
    )
    assert [row.message for row in finding.related] == ["'a' is no email address"]


def test_with_a_cmake_file_and_without_any(findings, full):
    text = full.replace(MAIL, "").format("<export><build_type>ament_cmake</build_type></export>")
    (finding,) = findings("PKG011", **{"package.xml": text, "CMakeLists.txt": "project(robot)\n"})
    assert "builds it as plain CMake" in finding.message


@pytest.mark.parametrize("files", [{}, {"package.xml": CMAKE, "CMakeLists.txt": "project(robot)\n"}])
def test_manifests_that_are_taken(findings, files):
    assert findings("PKG011", **files) == []


AMENT = "project(robot)\nfind_package(ament_cmake REQUIRED)\nament_package()\n"


@pytest.mark.parametrize(
    ("files", "build_type"),
    [({"CMakeLists.txt": AMENT}, "ament_cmake"), ({"setup.py": SETUP}, "ament_python")],
)
def test_a_package_without_a_build_type(findings, full, files, build_type):
    (finding,) = findings("PKG011", **{"package.xml": full.format("<depend>rclpy</depend>"), **files})
    assert finding.message == (
        "colcon takes 'robot' for a package of catkin, the build system of ROS 1: there is no <build_type>"
    )
    assert finding.help == f"add <export><build_type>{build_type}</build_type></export>"


@pytest.mark.parametrize(
    ("export", "help"),
    [
        ("<export>\n<!-- <metapackage/> -->\n</export>", "put <build_type>ament_cmake</build_type> into <export>"),
        ("<!-- <export> -->", "add <export><build_type>ament_cmake</build_type></export>"),
    ],
)
def test_a_build_type_belongs_into_the_export_that_is_there(findings, full, export, help):
    (finding,) = findings("PKG011", **{"package.xml": full.format(export), "CMakeLists.txt": AMENT})
    assert finding.help == help


@pytest.mark.parametrize(
    ("more", "files"),
    [
        ("", {"CMakeLists.txt": "project(robot)\n"}),  # it is not known what this is for
        ("<build_depend>catkin</build_depend>", {"CMakeLists.txt": AMENT}),
        ("<export><build_type>catkin</build_type></export>", {"CMakeLists.txt": AMENT}),
        ('<export><build_type condition="$ROS_VERSION == 1">catkin</build_type></export>', {"setup.py": SETUP}),
    ],
)
def test_a_package_that_may_be_for_ros_1(findings, full, more, files):
    assert findings("PKG011", **{"package.xml": full.format(more), **files}) == []


def test_a_build_type_in_an_element_that_is_not_export(findings, full):
    text = full.format("<ament_cmake><build_type>ament_cmake</build_type></ament_cmake>")
    (finding,) = findings("PKG011", **{"package.xml": text, "CMakeLists.txt": AMENT})
    assert finding.help == "write <export>"


def test_a_package_without_a_build_type_that_depends_on_the_one_it_means(findings, full):
    python = {"setup.py": SETUP, "CMakeLists.txt": AMENT}
    tool = "<buildtool_depend>ament_python</buildtool_depend>"
    both = f"{tool}<buildtool_depend>ament_cmake</buildtool_depend>"
    for tools, build_type in ((tool, "ament_python"), (both, "ament_cmake")):
        (finding,) = findings("PKG011", **{"package.xml": full.format(tools), **python})
        assert finding.help == f"add <export><build_type>{build_type}</build_type></export>"


@pytest.fixture
def of_arm(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, full: str):
    """What is found of a package of a build type that has these files alone."""
    monkeypatch.chdir(tmp_path)

    def run(build_type: str, files: dict[str, str]) -> list[Finding]:
        export = f"\n<export><build_type>{build_type}</build_type></export>"
        manifest = {"package.xml": full.replace("<name>robot", "<name>arm").format(export)}
        write_files(tmp_path, manifest | files | {"archlint.toml": 'select = ["PKG011"]\n'})
        return check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings

    return run


@pytest.mark.parametrize(
    ("written", "files", "what", "right"),
    [
        ("ament_python", {"CMakeLists.txt": AMENT}, "'ament_python' is built by a setup.py", "ament_cmake"),
        ("ament_cmake", {"setup.py": SETUP}, "'ament_cmake' is built by a CMakeLists.txt", "ament_python"),
        ("ament_cmake_auto", {"CMakeLists.txt": AMENT}, "colcon knows no build type 'ament_cmake_auto'", "ament_cmake"),
        ("ament_pyton", {"setup.py": SETUP}, "colcon knows no build type 'ament_pyton'", "ament_python"),
    ],
)
def test_a_build_type_that_is_not_that_of_the_build_files(of_arm, written, files, what, right):
    (finding,) = of_arm(written, files)
    assert finding.message.startswith(f"colcon cannot build 'arm': {what}")
    assert finding.help == f"write <build_type>{right}</build_type>"
    assert (finding.place.file, finding.place.line) == ("package.xml", 2)


@pytest.mark.parametrize(
    ("written", "files"),
    [
        ("ament_cmake", {"CMakeLists.txt": AMENT}),
        ("ament_cmake", {"CMakeLists.txt": AMENT, "setup.py": SETUP}),
        ("ament_python", {"CMakeLists.txt": AMENT, "setup.py": SETUP}),
        ("cmake", {"CMakeLists.txt": AMENT}),
        ("ament_cargo", {"CMakeLists.txt": AMENT}),
        ("ament_python", {"CMakeLists.txt": "project(arm)\n"}),  # it is not known what this is for
        ("ament_cmake", {}),
        ("acme_build", {"CMakeLists.txt": AMENT}),
        ("<!-- ament_python -->ament_cmake", {"CMakeLists.txt": AMENT}),
    ],
)
def test_a_build_type_that_fits_or_may(of_arm, written, files):
    assert of_arm(written, files) == []


def test_a_package_of_ros_1(findings, full):
    text = full.replace(MAIL, "").format("<buildtool_depend>catkin</buildtool_depend>")
    assert findings("PKG011", **{"package.xml": text}) == []


def test_manifests_with_one_mistake_are_one_finding(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)
    texts = {name: f"<package><n>{name}</n></package>" for name in ("arm", "base", "camera")}
    for name, text in {**texts, "door": "<package><name>door</nam"}.items():
        (tmp_path / name).mkdir()
        (tmp_path / name / "package.xml").write_text(text)
    copied, other = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert copied.message == (
        "malformed package.xml: the package has no <name>; 2 more package.xml files are unreadable for the same reason"
    )
    assert [related.place.file for related in copied.related] == ["base/package.xml", "camera/package.xml"]
    assert other.place.file == "door/package.xml"


def test_packages_with_the_same_address_are_one_finding(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, full: str):
    monkeypatch.chdir(tmp_path)
    addresses = {"arm": "robot@localhost", "base": "robot@localhost", "head": "me@home"}
    for name, address in addresses.items():
        text = full.format(BUILD).replace("robot<", f"{name}<").replace(MAIL, f'email="{address}"')
        write_files(tmp_path / name, {"package.xml": text, "setup.py": SETUP_OF.format(name=name)})
    write_files(tmp_path, {"archlint.toml": 'select = ["PKG011"]'})
    several, alone = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert several.message.endswith("'robot@localhost' is no email address; another package.xml has the same")
    assert [row.place.file for row in several.related] == ["base/package.xml"]
    assert (alone.place.file, alone.related) == ("head/package.xml", ())


def test_a_package_that_depends_on_itself_is_told_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, full: str):
    monkeypatch.chdir(tmp_path)
    write_files(tmp_path, {"package.xml": full.format("<depend>robot</depend>" + BUILD), "setup.py": SETUP})
    write_files(tmp_path, {"archlint.toml": 'select = ["PKG003", "PKG011"]'})
    (finding,) = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert (finding.code, finding.help) == ("PKG011", "remove the line")


BUILD = "<export><build_type>ament_python</build_type></export>"
