"""SRV001, ACT001: nothing in the workspace serves an interface that only the workspace can know."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Severity

MANIFEST = """<package format="3"><name>{name}</name><version>1.0.0</version><description>x</description>
<maintainer email="a@b.org">a</maintainer><license>MIT</license>{depends}
<export><build_type>{build}</build_type></export></package>
"""
CMAKE = """project(motor_msgs)
find_package(rosidl_default_generators REQUIRED)
rosidl_generate_interfaces(${PROJECT_NAME} "srv/SetMotor.srv")
"""
SETUP = """from setuptools import setup
setup(name='driver', packages=['driver'], entry_points={'console_scripts': ['driver = driver.node:main']})
"""
CLIENT = """import rclpy
from motor_msgs.srv import SetMotor
from rclpy.node import Node


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.motor = self.create_client(SetMotor, 'set_motor')
        self.timer = self.create_timer(5.0, self.drive)

    def drive(self):
        self.motor.call_async(SetMotor.Request())


def main():
    rclpy.init()
    rclpy.spin(Driver())
"""
SERVER = CLIENT.replace("self.create_client(SetMotor, 'set_motor')", "self.create_service(SetMotor, 'drive', print)")


def workspace(folder: Path, files: dict[str, str]) -> Path:
    rows = {
        "motor_msgs/package.xml": MANIFEST.format(name="motor_msgs", depends="", build="ament_cmake"),
        "motor_msgs/CMakeLists.txt": CMAKE,
        "motor_msgs/srv/SetMotor.srv": "float64 speed\n---\nbool success\n",
        "driver/package.xml": MANIFEST.format(
            name="driver", depends="<depend>rclpy</depend><depend>motor_msgs</depend>", build="ament_python"
        ),
        "driver/setup.py": SETUP,
        "driver/driver/__init__.py": "",
        "driver/driver/node.py": CLIENT,
    }
    for path, text in (rows | files).items():
        file = folder / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
    (folder / "archlint.toml").write_text('select = ["SRV001"]\n', encoding="utf-8")
    return folder


def found(folder: Path, monkeypatch: pytest.MonkeyPatch, path: str = ".", start: str = ".") -> list[tuple[str, int]]:
    monkeypatch.chdir(folder / start)
    report = check(Request((path,), load(folder), cached=False, jobs=1))
    return [(finding.place.file, finding.place.line) for finding in report.findings]


def test_a_client_of_a_type_that_nothing_serves(tmp_path, monkeypatch):
    monkeypatch.chdir(workspace(tmp_path, {}))
    [finding] = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert (finding.place.file, finding.place.line) == ("driver/driver/node.py", 9)
    assert finding.message == (
        "/driver calls the service '/set_motor', and no node offers it, nor any other of motor_msgs/srv/SetMotor, "
        "which this workspace defines: the request never gets a response"
    )


def test_what_a_helper_of_several_nodes_asks_for_is_one_finding(tmp_path, monkeypatch):
    helper = CLIENT.partition("class Driver")[0] + (
        "class Helper:\n    def __init__(self, node):\n"
        "        self.set = node.create_client(SetMotor, 'set_motor')\n"
        "        self.get = node.create_client(SetMotor, 'get_motor')\n\n"
        "    def ask(self):\n        self.set.call_async(SetMotor.Request())\n"
        "        self.get.call_async(SetMotor.Request())\n"
    )
    asking = CLIENT.replace("from motor_msgs.srv import SetMotor", "from driver.helper import Helper")
    asking = asking.replace("self.create_client(SetMotor, 'set_motor')", "Helper(self)")
    asking = asking.replace("call_async(SetMotor.Request())", "ask()")
    files = {
        "driver/driver/helper.py": helper,
        "driver/driver/node.py": asking,
        "driver/driver/other.py": asking.replace("'driver')", "'other')"),
    }
    monkeypatch.chdir(workspace(tmp_path, files))
    [finding] = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert finding.place.file == "driver/driver/helper.py"
    assert finding.message.endswith("; nor does any node offer another service that this file asks for")
    assert [row.message for row in finding.related] == ["nobody offers '/get_motor', either"]


def test_a_client_that_nothing_uses_asks_for_nothing(tmp_path, monkeypatch):
    idle = CLIENT.replace("self.motor.call_async(SetMotor.Request())", "pass")
    assert found(workspace(tmp_path, {"driver/driver/node.py": idle}), monkeypatch) == []


@pytest.mark.parametrize(("served", "severity"), [(False, Severity.INFO), (True, Severity.WARNING)])
def test_another_machine_may_serve_all_of_a_package(tmp_path, monkeypatch, served: bool, severity: Severity):
    """Two services of the package are asked for; nothing here serves any of them, or one that is there, too."""
    more = '"srv/SetMotor.srv" "srv/GetMotor.srv" "srv/StopMotor.srv"'
    asking = CLIENT.replace("import SetMotor", "import GetMotor, SetMotor, StopMotor").replace(
        "        self.timer", "        self.state = self.create_client(GetMotor, 'get_motor')\n        self.timer"
    )
    if served:
        asking = asking.replace(
            "        self.timer", "        self.create_service(StopMotor, 'stop', print)\n        self.timer"
        )
    files = {
        "motor_msgs/CMakeLists.txt": CMAKE.replace('"srv/SetMotor.srv"', more),
        "motor_msgs/srv/GetMotor.srv": "---\nfloat64 speed\n",
        "motor_msgs/srv/StopMotor.srv": "---\n",
        "driver/driver/node.py": asking,
    }
    monkeypatch.chdir(workspace(tmp_path, files))
    [finding] = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert (finding.severity, "another machine" in finding.message) == (severity, not served)


@pytest.mark.parametrize(
    "files",
    [
        {"driver/driver/server.py": SERVER},
        {"firmware/src/main.cpp": "#include <motor_msgs/srv/set_motor.hpp>\nusing motor_msgs::srv::SetMotor;\n"},
        {"driver/driver/helper.py": "def serve(node, name):\n    from motor_msgs.srv import SetMotor\n"},
        {"driver/driver/node.py": CLIENT.replace("motor_msgs", "vendor_msgs")},
        {"driver/driver/node.py": CLIENT.replace("SetMotor", "SetMotors")},
        {"motor_msgs/CMakeLists.txt": CMAKE.replace("SetMotor.srv", "Other.srv")},
    ],
    ids=[
        "served under another name",
        "C++ names it",
        "other code names it",
        "a type from elsewhere",
        "a type that is not there",
        "a type that is not built",
    ],
)
def test_somebody_may_serve_it(tmp_path, monkeypatch, files):
    assert found(workspace(tmp_path, files), monkeypatch) == []


@pytest.mark.parametrize(("start", "path"), [("driver", ".."), ("driver/driver", "../.."), ("..", "ws")])
def test_so_it_is_from_any_folder(tmp_path, monkeypatch, start, path):
    cpp = {"firmware/src/main.cpp": "#include <motor_msgs/srv/set_motor.hpp>\nusing motor_msgs::srv::SetMotor;\n"}
    assert found(workspace(tmp_path / "ws", cpp), monkeypatch, path, start) == []
    assert len(found(workspace(tmp_path / "ws", {"firmware/src/main.cpp": ""}), monkeypatch, path, start)) == 1


def test_a_part_of_a_workspace_does_not_show_who_serves(tmp_path, monkeypatch):
    assert found(workspace(tmp_path, {"driver/driver/server.py": SERVER}), monkeypatch, "driver/driver/node.py") == []


MORE = '"srv/SetMotor.srv" "srv/GetMotor.srv"'


def robot(nodes: int) -> dict[str, str]:
    """A node that asks for two services of a package of which nothing is served, among other nodes."""
    asking = CLIENT.replace("import SetMotor", "import GetMotor, SetMotor").replace(
        "        self.timer", "        self.state = self.create_client(GetMotor, 'get_motor')\n        self.timer"
    )
    idle = "from rclpy.node import Node\n\n\nclass Idle{0}(Node):\n"
    idle += "    def __init__(self):\n        super().__init__('idle{0}')\n"
    return {
        "motor_msgs/CMakeLists.txt": CMAKE.replace('"srv/SetMotor.srv"', MORE),
        "motor_msgs/srv/GetMotor.srv": "---\nfloat64 speed\n",
        "driver/driver/node.py": asking,
        **{f"driver/driver/idle{number}.py": idle.format(number) for number in range(nodes)},
    }


@pytest.mark.parametrize(("others", "expected"), [(4, 1), (5, 0)])
def test_a_large_workspace_leaves_a_whole_package_to_another_machine(tmp_path, monkeypatch, others, expected):
    assert len(found(workspace(tmp_path, robot(others)), monkeypatch)) == expected


ASKS_FIRST = CLIENT.replace(
    "        self.motor.call_async", "        if not {}:\n            return\n        self.motor.call_async"
)


@pytest.mark.parametrize(
    ("asks", "expected"),
    [
        ("self.motor.service_is_ready()", 0),
        ("self.motor.wait_for_service(timeout_sec=2.0)", 0),
        ("self.motor.wait_for_service()", 1),
    ],
)
def test_code_that_goes_on_without_a_server(tmp_path, monkeypatch, asks, expected):
    files = {"driver/driver/node.py": ASKS_FIRST.format(asks)}
    assert len(found(workspace(tmp_path, files), monkeypatch)) == expected


def test_the_loop_of_the_tutorial_does_not_go_on_without_a_server(tmp_path, monkeypatch):
    files = {
        "driver/driver/node.py": CLIENT.replace(
            "        self.timer",
            "        while not self.motor.wait_for_service(timeout_sec=1.0):\n            pass\n        self.timer",
        )
    }
    assert len(found(workspace(tmp_path, files), monkeypatch)) == 1


def needs(name: str) -> dict[str, str]:
    depends = f"<depend>rclpy</depend><depend>motor_msgs</depend><exec_depend>{name}</exec_depend>"
    return {"driver/package.xml": MANIFEST.format(name="driver", depends=depends, build="ament_python")}


SUBMODULE = '[submodule "m"]\n\tpath = motor\n\turl = https://example.org/motor\n'
REPOSITORY = "repositories:\n  drivers/{0}:\n    type: git\n    url: https://example.org/{0}.git\n"


@pytest.mark.parametrize(
    ("files", "expected"),
    [
        pytest.param(needs("motor"), 0, id="a package that is nowhere"),
        pytest.param(needs("nav2_bringup"), 1, id="a package of ROS"),
        pytest.param({".gitmodules": SUBMODULE}, 0, id="a submodule that is not checked out"),
        pytest.param({".gitmodules": SUBMODULE, "motor/README.md": "x"}, 1, id="a submodule that is there"),
        pytest.param({"robot.repos": REPOSITORY.format("motor")}, 0, id="a repository that is not here"),
        pytest.param({"robot.repos": REPOSITORY.format("driver")}, 1, id="a repository that is here"),
    ],
)
def test_a_part_of_the_system_that_is_elsewhere(tmp_path, monkeypatch, files, expected):
    assert len(found(workspace(tmp_path, files), monkeypatch)) == expected
