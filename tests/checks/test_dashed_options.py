"""PKG010: options of a setup.cfg that are written with a dash."""

from __future__ import annotations

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from robot_package import SETUP_OF, manifest, write_files

OLD = "[develop]\nscript-dir=$base/lib/robot\n[install]\ninstall-scripts=$base/lib/robot\n"
FOXY = """from setuptools import setup

package_name = 'robot'
setup(
    name=package_name,
    version='0.0.0',
    packages=[package_name],
    entry_points={'console_scripts': []},
)
"""
"""As ``ros2 pkg create`` of Foxy writes it."""


def test_the_old_template(findings):
    (finding,) = findings("PKG010", **{"setup.cfg": OLD})
    assert finding.message == (
        "'script-dir' has a dash: setuptools warns of it at each build, and says that it will refuse it; another "
        "option of the file has one, too"
    )
    assert finding.help == "write 'script_dir'"
    assert [row.place.line for row in (finding, *finding.related)] == [2, 4]


@pytest.mark.parametrize(("pin", "told"), [("==45.2.0", 0), ("<50", 0), ("", 1), (">=45", 1), ("==65.0.0", 1)])
def test_a_package_that_asks_for_an_old_setuptools(findings, pin: str, told: int):
    options = f"[options]\ninstall_requires =\n    pyserial\n    setuptools{pin}\n"
    assert len(findings("PKG010", **{"setup.cfg": OLD + options})) == told


def test_all_packages_of_one_template_are_one_finding(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for name in ("arm", "base", "robot"):
        setup = SETUP_OF.format(name=name)
        write_files(tmp_path / name, {"setup.cfg": OLD, "package.xml": manifest(name), "setup.py": setup})
    write_files(tmp_path, {"archlint.toml": 'select = ["PKG010"]'})
    (finding,) = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert finding.message.endswith("refuse it; 2 more setup.cfg files have such options, too")
    assert {row.place.file for row in (finding, *finding.related)} == {
        "arm/setup.cfg",
        "base/setup.cfg",
        "robot/setup.cfg",
    }


@pytest.mark.parametrize(
    ("packages", "told"),
    [("[package_name]", 0), ("find_packages(exclude=['test'])", 2)],  # the second is what Humble writes
)
def test_a_package_of_an_old_template_beside_one_of_a_later(tmp_path, monkeypatch, packages: str, told: int):
    monkeypatch.chdir(tmp_path)
    for name, setup in (("arm", FOXY), ("robot", FOXY.replace("[package_name]", packages))):
        write_files(tmp_path / name, {"setup.cfg": OLD, "package.xml": manifest(name), "setup.py": setup})
    write_files(tmp_path, {"archlint.toml": 'select = ["PKG010"]'})
    findings = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert len({row.place.file for told_of in findings for row in (told_of, *told_of.related)}) == told


@pytest.mark.parametrize(
    ("command", "told"),
    [
        ("ament_python_install_package(robot)", 0),  # CMake builds the package, and nobody hands setuptools the file
        ("ament_python_install_package(robot SCRIPTS_DESTINATION lib/robot SETUP_CFG setup.cfg)", 1),
    ],
)
def test_a_package_that_cmake_builds(findings, command: str, told: int):
    cmake = f"cmake_minimum_required(VERSION 3.8)\nproject(robot)\nfind_package(ament_cmake_python)\n{command}\n"
    files = {"setup.cfg": OLD, "CMakeLists.txt": cmake, "package.xml": manifest(build_type="ament_cmake")}
    assert len(findings("PKG010", **files)) == told


@pytest.mark.parametrize(
    "text",
    [
        OLD.replace("-dir", "_dir").replace("-scripts", "_scripts"),
        "[flake8]\nmax-line-length = 99\n",
        "[tool:pytest]\njunit-family = xunit2\n",
        "# script-dir=$base\n",
        "[options]\ninstall_requires =\n    ruamel-yaml\n    typing-extensions = 4\n",
        "[options.extras_require]\nwith-camera = opencv-python\n",
        "[options.entry_points]\nconsole_scripts =\n  talk-er = robot.talker:main\n",
    ],
)
def test_underscores_and_other_tools(findings, text):
    assert findings("PKG010", **{"setup.cfg": text}) == []


@pytest.mark.parametrize(
    "text",
    [
        "[metadata]\nname = robot\nauthor-email = ada@example.org\n",
        "[options]\ninstall-requires = setuptools\n",
        "[build_scripts]\nbuild-dir = scripts\n",
    ],
)
def test_other_sections_that_setuptools_reads(findings, text):
    (finding,) = findings("PKG010", **{"setup.cfg": text})
    assert finding.place.line == len(text.splitlines())


@pytest.mark.parametrize(
    ("files", "told"),
    [
        ({"README.md": "For ROS 2 Foxy."}, 0),  # setuptools 45 of Ubuntu 20.04 takes dashes without a word
        ({"README.md": "For ROS 2 Dashing."}, 0),
        ({"README.md": "For ROS 2 Dashing, and since 2023 for Humble."}, 1),
        ({"bin/start.sh": "source /opt/ros/eloquent/setup.bash\n"}, 0),
        ({"install/setup.sh": 'COLCON_CURRENT_PREFIX="/opt/ros/foxy"\n'}, 0),
        ({"README.md": "Now for Humble.", "install/setup.sh": 'COLCON_CURRENT_PREFIX="/opt/ros/foxy"\n'}, 1),
        ({"install/setup.sh": 'COLCON_CURRENT_PREFIX="/opt/ros/humble"\n'}, 1),
        ({"bin/start.sh": "source /opt/ros/foxy/setup.bash\nros2 run robot talker\n"}, 0),
        ({"bin/start.sh": "source /opt/ros/foxy/setup.bash\n", "README.md": "Now for Humble."}, 1),
        ({"bin/start.sh": "source /opt/ros/humble/setup.bash\n"}, 1),
        ({"Dockerfile.robot": "FROM ros:foxy\n"}, 0),
        ({"README.md": "For ROS 2 Foxy.\n\n    ROS_DISTRO=<yours>  # humble, galactic or foxy\n"}, 0),
        ({"README.md": "For ROS 2 Humble.\n\n    ROS_DISTRO=<yours>  # humble, galactic or foxy\n"}, 1),
        ({"README.md": "    ROS_DISTRO=<yours>  # humble or foxy\n"}, 1),
        ({"setup.py": FOXY}, 0),
        ({"setup.py": FOXY, "README.md": "For Humble."}, 1),
        ({"setup.py": FOXY.replace("[package_name]", "find_packages(exclude=['test'])")}, 1),
    ],
)
def test_a_workspace_on_ubuntu_20_04(findings, files, told):
    assert len(findings("PKG010", **{"setup.cfg": OLD}, **files)) == told
