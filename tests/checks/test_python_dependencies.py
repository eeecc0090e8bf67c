"""PKG009: modules of Python that package.xml does not ask for."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Finding

Judge = Callable[..., list[Finding]]
SETUP = """from setuptools import setup

setup(name='robot', packages=['robot'], install_requires=[{pip}],
      entry_points={{'console_scripts': ['node = robot.node:main']}})
"""


@pytest.fixture
def judge(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Judge:
    """What PKG009 says of a program that imports something, with some tags in its package.xml."""
    monkeypatch.chdir(tmp_path)

    def run(imports: str, *tags: str, pip: str = "'setuptools'", **files: str) -> list[Finding]:
        lines = "".join(f"  {tag}\n" for tag in ("<depend>rclpy</depend>", *tags))
        kind = "<export><build_type>ament_python</build_type></export>"
        texts = {
            "package.xml": f'<package format="3">\n  <name>robot</name>\n{lines}  {kind}\n</package>\n',
            "archlint.toml": 'select = ["PKG009"]\n',
            "setup.py": SETUP.format(pip=pip),
            "robot/__init__.py": "",
            "robot/node.py": f"import rclpy\n{imports}\n\n\ndef main():\n    rclpy.init()\n",
            **files,
        }
        for name, text in texts.items():
            (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
            (tmp_path / name).write_text(text, encoding="utf-8")
        return check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings

    return run


@pytest.mark.parametrize(
    ("readme", "told"),
    [
        ("For ROS 2 Foxy.", 0),
        ("For Galactic.", 0),
        ("For Foxy and Humble.", 0),
        ("For Humble.", 1),
        ("For Jazzy.", 0),
        ("For Humble and Jazzy.", 0),
        ("", 0),
    ],
)
def test_a_key_that_not_each_ubuntu_has_a_package_for(judge: Judge, readme: str, told: int):
    assert len(judge("import torch\ntorch.zeros(3)", **{"README.md": readme})) == told
    assert len(judge("import serial\nserial.Serial()", **{"README.md": readme})) == 1


@pytest.mark.parametrize(
    ("imports", "key"),
    [
        ("import serial\nserial.Serial()", "python3-serial"),
        ("from scipy.spatial import KDTree\nKDTree([])", "python3-scipy"),
        ("import cv2\ncv2.imread('')", "python3-opencv"),
        ("import paho.mqtt.client as mqtt\nmqtt.Client()", "python3-paho-mqtt"),
        ("import casadi\ncasadi.SX.sym('x')", "casadi-pip"),
        ("import speech_recognition\nspeech_recognition.Recognizer()", "python-speechrecognition-pip"),
        ("import ultralytics\nultralytics.YOLO()", "python3-ultralytics-pip"),
    ],
)
def test_a_module_that_nothing_asks_for(judge: Judge, imports: str, key: str):
    (finding,) = judge(imports)
    assert finding.help == f"add <exec_depend>{key}</exec_depend>"
    assert [row.place.file for row in finding.related] == ["robot/node.py"]


def test_all_modules_of_a_package_are_one_finding(judge: Judge):
    (finding,) = judge("import serial\nimport scipy\nimport serial.tools")
    assert finding.message == (
        "package 'robot' imports 2 modules: scipy, serial, which its package.xml does not declare: rosdep does not "
        "install them"
    )


@pytest.mark.parametrize(
    "imports",
    [
        "import numpy",
        "import yaml",
        "import json",
        "import my_own_library",  # rosdep knows no such thing
        "try:\n    import serial\nexcept ImportError:\n    serial = None",
        "def port():\n    import serial",
    ],
)
def test_what_is_there_or_may_be_missing(judge: Judge, imports: str):
    assert judge(imports) == []


@pytest.mark.parametrize(
    ("imports", "tag"),
    [
        ("import serial", "<exec_depend>python3-serial</exec_depend>"),
        ("import serial", "<depend>pyserial</depend>"),
        ("import cv2", "<depend>cv_bridge</depend>"),
        ("from PyQt5.QtWidgets import QWidget", "<depend>python3-qt5-bindings</depend>"),
        ("import transforms3d", "<depend>tf_transformations</depend>"),
        ("import serial", "<depend>packages_of_our_team</depend>"),  # which nobody knows
    ],
)
def test_what_package_xml_asks_for(judge: Judge, imports: str, tag: str):
    assert judge(imports, tag) == []


def test_a_dependency_that_somebody_has_taken_out_is_known_to_him(judge: Judge):
    imports = "import serial\nserial.Serial()"
    assert judge(imports, "<!-- <exec_depend>python3-serial</exec_depend> -->") == []
    assert len(judge(imports, "<!-- python3-serial is on the image -->")) == 1


def test_what_pip_brings_along_with_another_missing_module_is_not_listed(judge: Judge):
    imports = "import cv2, torch, ultralytics\ncv2.imread('')\ntorch.zeros(3)\nultralytics.YOLO()"
    [finding] = judge(imports)
    assert finding.help == "add <exec_depend>python3-ultralytics-pip</exec_depend>"


def test_parts_of_a_module_that_have_keys_of_their_own(judge: Judge):
    (finding,) = judge("from PySide2 import QtCore, QtQml\nQtCore, QtQml")
    keys = ("python3-pyside2", "python3-pyside2.qtqml")
    assert finding.help == "add " + "".join(f"<exec_depend>{key}</exec_depend>" for key in keys)
    (finding,) = judge("from PySide2.QtWidgets import QLabel\nQLabel()")
    assert finding.help == "add <exec_depend>python3-pyside2</exec_depend>"


def test_a_part_of_a_module_that_rosdep_does_not_have(judge: Judge):
    part = "from PySide2.QtPositioning import QGeoCoordinate\nQGeoCoordinate()"
    assert judge(f"from PySide2 import QtCore\nQtCore\n{part}") == []


@pytest.mark.parametrize(
    ("line", "help"),
    [
        ("import sounddevice", "remove the import of 'sounddevice', which nothing uses"),
        ("import sounddevice  # keeps ALSA quiet", "add <exec_depend>python3-sounddevice-pip</exec_depend>"),
        ("import torch_geometric", "add <exec_depend>python3-torch-geometric-pip</exec_depend>"),
        ("import sounddevice  # noqa: F401", "add <exec_depend>python3-sounddevice-pip</exec_depend>"),
    ],
)
def test_an_import_for_what_it_does(judge: Judge, line: str, help: str):
    (finding,) = judge(line)
    assert finding.help == help


def test_a_module_of_a_version_that_ubuntu_does_not_have(judge: Judge):
    assert judge("import cv2\ncv2.aruco.ArucoDetector(None)") == []
    assert len(judge("import cv2\ncv2.aruco.detectMarkers(None)")) == 1


def test_a_test_dependency_is_not_installed_with_the_node(judge: Judge):
    assert len(judge("import serial", "<test_depend>python3-serial</test_depend>")) == 1


def test_what_pip_is_asked_for(judge: Judge):
    assert judge("import serial", pip="'setuptools', 'pyserial'") == []
    assert judge("import serial", **{"requirements.txt": "pyserial==3.5\n"}) == []
    for file in ("docker/Dockerfile", "dockerfile_drivers"):
        assert judge("import serial", **{file: "FROM ros:jazzy\nRUN pip install pyserial\n"}) == []
    assert judge("import serial", **{"pixi.toml": '[dependencies]\npyserial = ">=3"\n'}) == []


def test_what_comes_with_a_package_that_pip_is_asked_for(judge: Judge):
    assert judge("import torch\ntorch.zeros(3)", **{"requirements.txt": "ultralytics==8.3.168\n"}) == []
    assert len(judge("import serial\nserial.Serial()", **{"requirements.txt": "ultralytics==8.3.168\n"})) == 1


CMAKE = "project(robot)\nfind_package(ament_cmake REQUIRED)\n{}ament_package()\n"


@pytest.mark.parametrize(
    ("installs", "told"),
    [
        ("install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\n", 0),
        ("find_package(ament_cmake_python REQUIRED)\nament_python_install_package(robot)\n", 1),
        ("install(PROGRAMS robot/node.py DESTINATION lib/${PROJECT_NAME})\n", 1),
    ],
    ids=["launch files alone", "the module", "the program"],
)
def test_a_package_whose_cmake_files_install_no_python(judge: Judge, installs: str, told: int):
    """The setup.py beside its CMakeLists.txt is not run."""
    manifest = "<package format='3'><name>robot</name><export><build_type>ament_cmake</build_type></export></package>"
    files = {"package.xml": manifest, "CMakeLists.txt": CMAKE.format(installs), "launch/it.txt": ""}
    assert len(judge("import serial\nserial.Serial()", **files)) == told


@pytest.mark.parametrize(
    ("file", "text"),
    [
        (".devcontainer/pip_packages.txt", "pyserial==3.5\n"),
        ("uv.lock", '[[package]]\nname = "pyserial"\nversion = "3.5"\n'),
        ("README.md", "# Robot\n\n    sudo apt update && pip3 install --user pyserial\n"),
        ("scripts/prepare.sh", "pip install \\\n    numpy \\\n    pyserial\n"),
        ("README.md", "Work in an environment of your own:\n\n    source .venv/bin/activate\n"),
    ],
)
def test_what_the_workspace_says_to_install(judge: Judge, file: str, text: str):
    assert judge("import serial\nserial.Serial()", **{file: text}) == []


@pytest.mark.parametrize(
    ("readme", "told"),
    [
        ("See [how to set it up](docs/setup.md#robot).", 0),
        ("See `how to set it up <docs/setup.md>`_.", 0),
        ("See the documents.", 1),  # perhaps of something else
    ],
)
@pytest.mark.parametrize("line", ["pip install pyserial", "source ~/venvs/robot/bin/activate"])
def test_what_a_document_says_to_install_to_which_the_readme_links(judge: Judge, readme: str, told: int, line: str):
    files = {"README.md": f"# Robot\n\n{readme}\n", "docs/setup.md": f"Then:\n\n    {line}\n"}
    assert len(judge("import serial\nserial.Serial()", **files)) == told


@pytest.mark.parametrize(
    "text",
    [
        "Talks to a motor by pyserial.\n",
        "    pip install numpy\n\nIt needs pyserial.\n",
        "    source install/setup.bash\n",
        "    conda activate poses\n",  # for a program beside ROS
    ],
)
def test_a_word_in_a_readme_installs_nothing(judge: Judge, text: str):
    assert len(judge("import serial\nserial.Serial()", **{"README.md": text})) == 1


def test_tests_and_loose_files_are_not_installed(judge: Judge):
    assert judge("", **{"test/test_port.py": "import serial\n", "robot/__main__.txt": ""}) == []


def test_a_module_of_the_workspace_is_no_package_of_the_system(judge: Judge):
    assert judge("import serial", **{"serial/__init__.py": "", "serial/package.xml": ""}) == []


def test_what_comes_with_a_package_that_another_rule_asks_for(judge: Judge):
    """Who declares cv_bridge, as PKG001 asks, has OpenCV along with it."""
    assert judge("import cv2\nfrom cv_bridge import CvBridge") == []
    (serial,) = judge("import cv2\nimport serial\nfrom cv_bridge import CvBridge")
    assert "'serial'" in serial.message


def test_an_import_that_an_editor_has_added(judge: Judge):
    (told,) = judge("from matplotlib.transforms import Transform\nimport serial\nserial.Serial()")
    assert told.help == (
        "add <exec_depend>python3-serial</exec_depend>, and remove the import of 'matplotlib', which nothing uses"
    )


def test_where_nothing_is_used_the_import_is_the_place(judge: Judge):
    (told,) = judge("from matplotlib.transforms import Transform")
    assert (told.place.file, told.place.line) == ("robot/node.py", 2)
    assert told.help == "remove the import of 'matplotlib', which nothing uses"


def test_an_import_of_what_another_file_of_the_package_uses(judge: Judge):
    plot = "import rclpy\nimport matplotlib\n\nrclpy.init()\nmatplotlib.use('Agg')\n"
    (told,) = judge("import matplotlib", **{"robot/plot.py": plot})
    assert told.help == "add <exec_depend>python3-matplotlib</exec_depend>"


def test_an_import_of_what_a_file_without_ros_uses(judge: Judge):
    (told,) = judge("import matplotlib", **{"robot/plot.py": "import matplotlib\n\nmatplotlib.use('Agg')\n"})
    assert told.help == "add <exec_depend>python3-matplotlib</exec_depend>"


def test_a_module_that_comes_with_another_one_and_adds_to_it(judge: Judge):
    (told,) = judge("import matplotlib\nfrom mpl_toolkits.mplot3d import Axes3D")
    assert "imports 'matplotlib'," in told.message
    assert told.help == "add <exec_depend>python3-matplotlib</exec_depend>"
