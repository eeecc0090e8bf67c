"""API006: imports of the workspace's own Python code that find nothing."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Finding
from robot_package import manifest, write_files

SETUP = """
from setuptools import setup
setup(name='robot', packages=['robot'], entry_points={'console_scripts': ['talker = robot.talker:main']})
"""
TALKER = """
import rclpy
{line}


def main():
    rclpy.init()
    rclpy.spin(rclpy.create_node('talker'))
"""
CAMERA = "WIDTH = 640\n\n\ndef open_camera():\n    pass\n"


@pytest.fixture
def said(findings: Callable[..., list[Finding]]) -> Callable[..., list[Finding]]:
    """What is said of a line of a console script, beside which there are other files."""

    def run(line: str, **files: str) -> list[Finding]:
        own = {"setup.py": SETUP, "robot/__init__.py": "", "robot/camera.py": CAMERA}
        return findings("API006", **(own | files | {"robot/talker.py": TALKER.format(line=line)}))

    return run


@pytest.mark.parametrize(
    ("line", "message", "help"),
    [
        (
            "from robot.camara import open_camera",
            "there is no module robot.camara: the import fails; did you mean robot.camera?",
            "import robot.camera",
        ),
        (
            "import robot.motors",
            "there is no module robot.motors: the import fails",
            "correct the name, or add the file",
        ),
        (
            "from robot.tools.lens import focus",
            "there is no module robot.tools: the import fails",
            "correct the name, or add the file",
        ),
        (
            "import robot.camra.lens.parts",
            "there is no module robot.camra: the import fails; did you mean robot.camera?",
            "import robot.camera",
        ),
        (
            "from robot.camera import WIDTH, close_camera",
            "robot.camera has no 'close_camera': the import fails with an ImportError",
            "define close_camera there, or import what there is",
        ),
        (
            "from robot import motors",
            "robot has no 'motors': the import fails with an ImportError",
            "define motors there, or import what there is",
        ),
        (
            "from camera import open_camera",
            "'camera' is not found once a console script imports this file: its folder is not on Python's path",
            "write `from robot.camera import …`",
        ),
    ],
)
def test_an_import_that_finds_nothing(said: Callable[..., list[Finding]], line: str, message: str, help: str) -> None:
    (finding,) = said(line)
    assert (finding.message, finding.help, finding.place.line) == (message, help, 3)


def test_modules_of_a_folder_beside_the_script_are_one_finding(said: Callable[..., list[Finding]]) -> None:
    files = {"robot/tools/lens.py": "", "robot/tools/shutter.py": ""}
    (finding,) = said("import tools.lens\nimport tools.shutter", **files)
    assert finding.message == (
        "'tools.lens' is not found once a console script imports this file: its folder is not on Python's path; "
        "another import of the file does the same"
    )
    assert finding.help == "write `from robot.tools.lens import …`, and give tools an __init__.py"
    (finding,) = said("import tools.lens", **files, **{"robot/tools/__init__.py": ""})
    assert finding.help == "write `from robot.tools.lens import …`"


@pytest.mark.parametrize(
    "line",
    [
        "from robot.camera import open_camera, WIDTH",
        "from robot import camera",
        "from .camera import open_camera",
        "import robot.camera as camera",
        "try:\n    from robot.motors import stop\nexcept ImportError:\n    stop = None",
        "try:\n    from .camera import WIDTH\nexcept ImportError:\n    from camera import WIDTH",
        "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    from robot.motors import Motor",
        "from robot.messages_pb2 import Message",
        "from robot.msg import Speed",
        "import serial",
        "import unknown_library",
    ],
)
def test_imports_that_find_something_or_are_not_known(said: Callable[..., list[Finding]], line: str) -> None:
    assert said(line) == []


@pytest.mark.parametrize(
    ("line", "files"),
    [
        ("from robot.protos.messages_pb2 import Message", {}),
        ("from robot.protos import messages_pb2", {}),
        ("from robot.made.lens import focus", {".gitignore": "robot/made/\n"}),
        ("from robot.kept.lens import focus", {".gitmodules": '[submodule "kept"]\n\tpath = robot/kept\n\turl = u\n'}),
        ("from robot.tools.lens import focus", {"robot/tools/lens.py": "def focus():\n    pass\n"}),
        ("from robot.parts.lens import focus", {"robot/parts.so": ""}),
    ],
)
def test_a_folder_of_modules_that_is_there_or_may_be(
    said: Callable[..., list[Finding]], line: str, files: dict[str, str]
) -> None:
    assert said(line, **files) == []


@pytest.mark.parametrize(
    ("own", "told"),
    [
        ("from lens import Lens\n", False),
        ("import lens.parts\n", False),
        ("from robot.lens import focus\n", True),
        ("from .lens import focus\n", True),
        ("import lenses\n", True),
    ],
)
def test_a_file_that_is_called_like_the_library_it_imports(
    said: Callable[..., list[Finding]], own: str, told: bool
) -> None:
    assert bool(said("from lens import Lens", **{"robot/lens.py": own + "def focus():\n    pass\n"})) is told


@pytest.mark.parametrize(("listed", "told"), [("'robot'", 0), ("'robot', 'scripts'", 1)])
def test_a_folder_of_scripts_that_is_installed_as_no_package(
    said: Callable[..., list[Finding]], listed: str, told: int
) -> None:
    files = {
        "setup.py": SETUP.replace("['robot']", f"[{listed}]"),
        "scripts/__init__.py": "import rclpy\nfrom .drive import go\n",
    }
    assert len(said("", **files, **{"scripts/turn.py": "import rclpy\n"})) == told


def test_a_folder_of_modules_beside_the_python_package(findings: Callable[..., list[Finding]]) -> None:
    launch = "from robot.scripts.ports import PORT\n\n\ndef generate_launch_description():\n    print(PORT)\n"
    files = {
        "setup.py": SETUP,
        "robot/__init__.py": "",
        "robot/talker.py": TALKER.format(line=""),
        "scripts/ports.py": "",
    }
    (finding,) = findings("API006", **files, **{"launch/all.launch.py": launch})
    assert finding.message == "there is no module robot.scripts: the import fails"


def test_a_module_that_is_compiled(said: Callable[..., list[Finding]]) -> None:
    compiled = {"robot/motors.so": "", "robot/gears.cpython-311-x86_64-linux-gnu.so": ""}
    assert said("import robot.motors as motors\nfrom robot import gears", **compiled) == []
    assert len(said("import robot.motor", **compiled)) == 1


def test_names_that_a_module_may_have(said: Callable[..., list[Finding]]) -> None:
    for text in ("from unknown_library import *\n", "globals()['motors'] = 1\n", "def __getattr__(name): ...\n"):
        assert said("from robot.camera import motors", **{"robot/camera.py": text}) == []
    star = {"robot/camera.py": "from robot.motors import *\n", "robot/motors.py": "def stop(): ...\n"}
    assert said("from robot.camera import stop", **star) == []
    assert len(said("from robot.camera import start", **star)) == 1


def test_packages_of_which_not_all_is_known(said: Callable[..., list[Finding]]) -> None:
    unknown = SETUP.replace("['robot']", "packages_of('robot')", 1)
    assert said("import robot.motors", **{"setup.py": unknown}) == []


def test_a_path_that_is_changed(said: Callable[..., list[Finding]]) -> None:
    assert said("import sys\nsys.path.append('.')\nfrom camera import open_camera") == []


def test_a_module_that_the_setup_installs_elsewhere(said: Callable[..., list[Finding]]) -> None:
    setup = SETUP.replace("entry_points", "data_files=[('lib/camera', glob('robot/camera.py'))], entry_points")
    assert said("from camera import open_camera", **{"setup.py": setup}) == []


@pytest.mark.parametrize("text", ["'Drives the camera.'", '"The robot\'s camera"', "'''\nReads a camera\n'''"])
def test_a_module_that_the_setup_only_speaks_of(said: Callable[..., list[Finding]], text: str) -> None:
    setup = SETUP.replace("entry_points", f"description={text}, entry_points")
    (finding,) = said("from camera import open_camera", **{"setup.py": setup})
    assert finding.message.startswith("'camera' is not found once a console script imports this file")
    installed = setup.replace("entry_points", "py_modules=['camera'], entry_points")
    assert said("from camera import open_camera", **{"setup.py": installed}) == []


def test_a_module_that_the_setup_installs_among_the_scripts(said: Callable[..., list[Finding]]) -> None:
    files = "data_files=[(os.path.join('lib', 'robot'), glob(os.path.join('robot', '*')))], entry_points"
    setup = "import os\nfrom glob import glob\n" + SETUP.replace("entry_points", files)
    assert said("import camera", **{"setup.py": setup}) == []


def test_a_module_called_like_one_that_is_installed(said: Callable[..., list[Finding]]) -> None:
    assert said("import serial", **{"robot/serial.py": ""}) == []
    assert said("import queue", **{"robot/queue.py": ""}) == []


@pytest.mark.parametrize("listed", ["robot/lens", "robot.lens"])
def test_a_package_beside_it_that_the_setup_installs_inside(said: Callable[..., list[Finding]], listed: str) -> None:
    files = {"robot/lens/__init__.py": "", "robot/lens/optics.py": "FOCUS = 1\n"}
    setup = SETUP.replace("['robot']", f"['robot', '{listed}']")
    (finding,) = said("from lens import optics", **{"setup.py": setup}, **files)
    assert finding.help == "write `from robot.lens import …`"
    beside = setup.replace("entry_points", "data_files=[('lib/robot', ['robot/lens/optics.py'])], entry_points")
    assert said("from lens import optics", **{"setup.py": beside}, **files) == []
    above = setup.replace("entry_points", "package_dir={'': 'robot'}, entry_points")
    assert said("from lens import optics", **{"setup.py": above}, **files) == []


def test_a_file_that_no_console_script_imports(findings: Callable[..., list[Finding]]) -> None:
    files = {
        "setup.py": SETUP,
        "robot/__init__.py": "",
        "robot/camera.py": CAMERA,
        "robot/talker.py": TALKER.format(line=""),
    }
    assert findings("API006", **files, **{"robot/tool.py": "import rclpy\nfrom camera import open_camera\n"}) == []


DRIVER = {"robot/driver.py": "from {} import open_camera\n\n\ndef drive():\n    return open_camera()\n"}


@pytest.mark.parametrize(
    "line", ["from robot.driver import drive", "from .driver import drive", "from driver import drive"]
)
def test_a_file_that_the_file_of_a_console_script_imports(said: Callable[..., list[Finding]], line: str) -> None:
    (told,) = said(line, **{path: text.format("camera") for path, text in DRIVER.items()})
    assert told.place.file == "robot/driver.py"
    assert told.help == "write `from robot.camera import …`"
    assert [place.place.file for place in told.related] == ["robot/talker.py"] * line.startswith("from driver")
    right = said(
        "from robot.driver import drive", **{path: text.format("robot.camera") for path, text in DRIVER.items()}
    )
    assert right == []


DEEP = {"robot/tools/__init__.py": "", "robot/tools/lens.py": "FOCUS = 1\n"}


@pytest.mark.parametrize(
    ("line", "message", "help"),
    [
        (
            "from .camara import open_camera",
            "there is no module robot.camara: the import fails; did you mean robot.camera?",
            "import robot.camera",
        ),
        (
            "from . import motors",
            "robot has no 'motors': the import fails with an ImportError",
            "define motors there, or import what there is",
        ),
        (
            "from .tools.lens import WIDTH",
            "robot.tools.lens has no 'WIDTH': the import fails with an ImportError",
            "define WIDTH there, or import what there is",
        ),
        (
            "from robot.robot.camera import open_camera",
            "there is no module robot.robot.camera: the import fails; the module is robot.camera",
            "write `from robot.camera import …`",
        ),
        (
            "from src.robot.robot.tools.lens import FOCUS",
            "there is no package src: the import fails; the module is robot.tools.lens",
            "write `from robot.tools.lens import …`",
        ),
        (
            "from robot.tools.tools import FOCUS",
            "there is no module robot.tools.tools: the import fails",
            "correct the name, or add the file",
        ),
        (
            "from robot.robot import open_camera",
            "there is no module robot.robot: the import fails; the module is robot.camera",
            "write `from robot.camera import …`",
        ),
        (
            "import lens",
            "there is no module lens: the import fails; the module is robot.tools.lens",
            "write `from robot.tools.lens import …`",
        ),
        (
            "from camrea import open_camera",
            "there is no module camrea: the import fails; the module is robot.camera",
            "write `from robot.camera import …`",
        ),
    ],
)
def test_an_own_module_under_another_name(in_src, line: str, message: str, help: str) -> None:
    (finding,) = in_src(line, **DEEP)
    assert (finding.message, finding.help) == (message, help)


def test_a_module_that_lies_outside_of_every_package(in_src) -> None:
    folder = {"top/src/common/tools/lens.py": "FOCUS = 1\n", "top/src/common/tools/__init__.py": ""}
    (finding,) = in_src("from common.tools.lens import FOCUS", **folder)
    assert "its file lies outside of every ROS package" in finding.message
    assert finding.help.startswith("move the module into a Python package")


@pytest.fixture
def in_src(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., list[Finding]]:
    """The same for a package in a folder of the source that has its own name."""
    monkeypatch.chdir(tmp_path)

    def run(line: str, **files: str) -> list[Finding]:
        setup = SETUP.replace("['robot']", "['robot', 'robot.tools']")
        own = {"setup.py": setup, "package.xml": manifest("robot"), "robot/__init__.py": "", "robot/camera.py": CAMERA}
        own |= files | {"robot/talker.py": TALKER.format(line=line)}
        beside = {path.removeprefix("top/"): own.pop(path) for path in [*own] if path.startswith("top/")}
        below = {f"src/robot/{path}": text for path, text in own.items()}
        write_files(tmp_path, {**below, **beside, "archlint.toml": 'select = ["API006"]\n'})
        return check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings

    return run


@pytest.mark.parametrize(
    ("line", "files"),
    [
        ("from .tools.lens import FOCUS", {}),
        ("from . import tools, camera", {}),
        ("from .tools import lens", {}),
        ("try:\n    from .motors import stop\nexcept ImportError:\n    stop = None", {}),
        ("from .messages_pb2 import Message", {}),
        ("from src.robot.robot.camera import open_camera", {"top/run.sh": "export PYTHONPATH=.\n"}),
        ("from src.robot.robot.camera import open_camera", {"top/requirements.txt": "src\n"}),
        ("from src.robot.camera import open_camera", {}),
        ("from optics import FOCUS", {}),
        ("from lens import DISTANCE", {}),
        ("import lens", {"robot/camera/lens.py": ""}),
        ("import camrea", {}),
        ("import sys\nsys.path.append('.')\nfrom src.robot.robot.camera import open_camera", {}),
    ],
)
def test_own_modules_that_are_found_or_not_meant(in_src, line: str, files: dict[str, str]) -> None:
    assert in_src(line, **DEEP, **files) == []


def test_a_package_that_has_another_name_now(said):
    (told,) = said("from robot_v2.camera import open_camera")
    assert told.message == "there is no package robot_v2: the import fails; the module is robot.camera"
    assert told.help == "write `from robot.camera import …`"


@pytest.mark.parametrize(
    ("line", "files"),
    [
        ("from robot_v2.camera import close_camera", {}),
        ("from robot_v2.motors import open_camera", {}),
        ("import robot_v2.camera", {}),
        ("from robot_v2 import camera", {}),
        ("from robot_v2.camera import open_camera", {"requirements.txt": "robot-v2==1.0\n"}),
        ("from robot_v2.camera import open_camera", {"robot_v2/__init__.py": "", "robot_v2/camera.py": CAMERA}),
        ("from numpy.camera import open_camera", {}),
        # Another file imports from it what the workspace does not have: the module here is a copy of one of it.
        ("from robot_v2.camera import open_camera", {"robot/tool.py": "import rclpy\nfrom robot_v2 import Shop\n"}),
        ("try:\n    from robot_v2.camera import open_camera\nexcept ImportError:\n    open_camera = None", {}),
    ],
)
def test_a_package_that_may_be_elsewhere(said, line: str, files: dict[str, str]):
    assert [told for told in said(line, **files) if "there is no package" in told.message] == []


@pytest.mark.parametrize(
    ("line", "meant"),
    [
        ("from geogrpahiclib.geodesic import Geodesic\nimport geographiclib", "geographiclib.geodesic"),
        ("import matplotib.pyplot as plt\nimport matplotlib", "matplotlib.pyplot"),
        ("import sokcetserver", "socketserver"),
        ("import rlcpy", "rclpy"),
        ("import robto.camera", "robot.camera"),
    ],
)
def test_a_module_whose_name_is_a_known_one_but_for_a_slip(
    said: Callable[..., list[Finding]], line: str, meant: str
) -> None:
    (finding,) = said(line)
    assert finding.message.endswith(f": the import fails; did you mean {meant}?")


def test_a_near_name_that_nothing_here_speaks_of(said: Callable[..., list[Finding]]) -> None:
    """It is one of somebody else's packages, which this workspace neither declares nor imports."""
    for line in ("from geogrpahiclib.geodesic import Geodesic", "import matplotib.pyplot", "import sensor_msg.msg"):
        assert said(line) == []


def test_a_slip_in_two_imports_is_one_finding(findings: Callable[..., list[Finding]]) -> None:
    """What is not imported under its right name is no finding of its own."""
    talker = TALKER.format(line="import rlcpy\nfrom rlcpy.node import Node").replace("\nimport rclpy\n", "\n")
    files = {"setup.py": SETUP, "robot/__init__.py": "", "robot/talker.py": talker}
    (finding,) = findings("API006", **files)
    assert finding.message.endswith("did you mean rclpy?; another import of the file does the same")
    assert findings("API005", **files) == []


def test_names_of_launch_in_a_module_that_is_nowhere(said: Callable[..., list[Finding]]) -> None:
    assert said("from base_of_all import Node, LogInfo") == []


def test_the_whole_import_is_advised(said: Callable[..., list[Finding]]) -> None:
    (finding,) = said("from rlcpy.node import Node")
    assert finding.help == "write `from rclpy.node import Node`"


@pytest.mark.parametrize(
    "line", ["import serialx", "import tarantula", "import gpytorch", "import cv_bridge3", "import turtlebot5_msgs"]
)
def test_modules_that_may_well_be_called_so(said: Callable[..., list[Finding]], line: str) -> None:
    assert said(line) == []


def test_a_module_that_the_near_one_imports_itself(said: Callable[..., list[Finding]]) -> None:
    """The machine has both: `statemachines` builds on `statemachine` of somebody else."""
    own = {"robot/statemachines.py": "class State:\n    pass\n"}
    (finding,) = said("from statemachine import State", **own)
    assert finding.help == "write `from robot.statemachines import …`"
    own["robot/statemachines.py"] = "from statemachine import State\n"
    assert said("from statemachine import State", **own) == []


def test_a_module_that_the_project_asks_pip_for(said: Callable[..., list[Finding]]) -> None:
    assert said("import matplotlab", **{"requirements.txt": "matplotlab\n"}) == []


INTERFACES = {
    "interfaces/package.xml": manifest("home_interfaces", "ament_cmake"),
    "interfaces/CMakeLists.txt": """
cmake_minimum_required(VERSION 3.8)
project(home_interfaces)
find_package(rosidl_default_generators REQUIRED)
rosidl_generate_interfaces(${PROJECT_NAME} "msg/Door.msg" "srv/OpenDoor.srv" "msg/Both.msg" "srv/Both.srv")
""",
    "interfaces/msg/Door.msg": "bool open\n",
    "interfaces/msg/Both.msg": "bool open\n",
    "interfaces/srv/OpenDoor.srv": "---\nbool success\n",
    "interfaces/srv/Both.srv": "---\nbool success\n",
}
WITH_PYTHON = INTERFACES["interfaces/CMakeLists.txt"] + "ament_python_install_package(${NAME})\n"


@pytest.fixture
def beside_interfaces(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., list[Finding]]:
    """What is said of a line of a console script in a workspace that has a package of interfaces, too."""
    monkeypatch.chdir(tmp_path)

    def run(line: str, files: dict[str, str]) -> list[Finding]:
        own = {"robot/package.xml": manifest(), "robot/setup.py": SETUP, "robot/robot/__init__.py": ""}
        own |= {"robot/robot/talker.py": TALKER.format(line=line), "archlint.toml": 'select = ["API006"]\n'}
        write_files(tmp_path, own | INTERFACES | files)
        return check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings

    return run


@pytest.mark.parametrize(
    ("line", "having", "name"),
    [
        ("from home_interfaces import Door", "home_interfaces.msg", "Door"),
        ("from home_interfaces import OpenDoor", "home_interfaces.srv", "OpenDoor"),
        ("from std_srvs import Trigger", "std_srvs.srv", "Trigger"),
    ],
)
def test_an_interface_that_is_imported_from_its_package(beside_interfaces, line: str, having: str, name: str) -> None:
    (told,) = beside_interfaces(line, {})
    package = having.partition(".")[0]
    assert told.message == f"package {package} has '{name}' in {having}: the import fails with an ImportError"
    assert told.help == f"write `from {having} import {name}`"


def test_interfaces_of_one_package_are_one_finding(beside_interfaces):
    lines = "from home_interfaces import Door\nfrom home_interfaces import OpenDoor"
    (told,) = beside_interfaces(lines, {})
    assert told.place.line == 3 and "another import of the file does the same" in told.message


@pytest.mark.parametrize(
    ("line", "files"),
    [
        ("from home_interfaces import msg", {}),
        ("from home_interfaces import Window", {}),
        ("from home_interfaces import Both", {}),
        ("from home_interfaces.msg import Door", {}),
        ("try:\n    from home_interfaces import Door\nexcept ImportError:\n    Door = None", {}),
        ("from home_interfaces import Door", {"interfaces/home_interfaces/__init__.py": "Door = object\n"}),
        ("from home_interfaces import Door", {"interfaces/CMakeLists.txt": WITH_PYTHON}),
    ],
)
def test_what_a_package_of_interfaces_has_or_may_have(beside_interfaces, line: str, files: dict[str, str]) -> None:
    assert not beside_interfaces(line, files)


def test_a_module_that_is_called_like_its_package(said: Callable[..., list[Finding]]) -> None:
    """robot/robot/robot.py is robot.robot, and no other name for robot."""
    robot = "class Arm:\n    pass\n"
    assert said("from robot.robot import Arm", **{"robot/robot.py": robot}) == []
    assert said("import robot.robot", **{"robot/robot.py": robot}) == []
    (finding,) = said("from robot.robot import Leg", **{"robot/robot.py": robot})
    assert finding.message == "robot.robot has no 'Leg': the import fails with an ImportError"


@pytest.mark.parametrize(
    ("line", "told"),
    [
        # Only a script comes to the first import: its own folder is on the path.
        ("if __name__ == '__main__':\n    from camera import WIDTH\nelse:\n    from .camera import WIDTH", 0),
        ("if __name__ != '__main__':\n    from camera import WIDTH", 1),
        ("if __name__ == '__main__':\n    from robot.camera import HEIGHT\nelse:\n    from .camera import WIDTH", 1),
    ],
)
def test_an_import_of_a_file_that_may_be_the_program(said: Callable[..., list[Finding]], line: str, told: int) -> None:
    assert len(said(line)) == told


@pytest.mark.parametrize(
    ("line", "told"), [("from . import _talker", 0), ("from robot import _talker", 0), ("from . import _radio", 1)]
)
def test_the_compiled_part_of_a_wrapper_is_no_file(said: Callable[..., list[Finding]], line: str, told: int) -> None:
    assert len(said(line)) == told


def test_modules_beside_the_script_are_one_finding_of_the_package(said: Callable[..., list[Finding]]) -> None:
    """Whoever imports one module by its short name does so in all files of a package."""
    files = {"robot/lens.py": "import camera\n", "robot/shutter.py": "import camera\nimport lens\n"}
    (finding,) = said("import camera\nimport shutter", **files)
    assert finding.message.endswith("; 4 more imports of the package do the same")
    assert finding.place.file == "robot/lens.py"
    assert {related.place.file for related in finding.related} == {"robot/shutter.py", "robot/talker.py"}


def test_a_module_that_is_missing_is_one_finding_of_the_package(said: Callable[..., list[Finding]]) -> None:
    (finding,) = said("import robot.lens\nimport robot.motors", **{"robot/lens.py": "import robot.motors\n"})
    assert finding.message.endswith("; another import of the package does the same")


@pytest.mark.parametrize(
    ("document", "text"),
    [
        ("README.md", "Start it with `python3 talker.py`."),
        ("start.ps1", 'python "C:\\robot\\robot\\talker.py" --fast'),
        ("start.bat", "python.exe robot\\talker.py"),
    ],
)
def test_a_script_that_people_are_told_to_run_finds_what_lies_beside_it(
    said: Callable[..., list[Finding]], document: str, text: str
) -> None:
    assert said("import camera", **{document: text}) == []
    (finding,) = said("import camera", **{document: text.replace("talker", "listener")})
    assert finding.place.line == 3


def test_names_of_a_file_that_python_cannot_read(findings: Callable[..., list[Finding]]) -> None:
    """LNT002 says why: whoever mends that file has the class, too."""
    talker = TALKER.format(line="from robot.camera import Camera, WIDTH\nfrom robot.lens import *")
    files = {"setup.py": SETUP, "robot/__init__.py": "", "robot/talker.py": talker, "robot/lens.py": ""}
    broken = "class Camera:\n    def show(self):\n        print 'here'\n"
    assert [told.code for told in findings("API006", **files, **{"robot/camera.py": broken})] == ["LNT002"]
    whole = broken.replace("Camera", "Lens").replace("print 'here'", "print('here')")
    assert [told.code for told in findings("API006", **files, **{"robot/camera.py": whole})] == ["API006", "API006"]
