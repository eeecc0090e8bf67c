"""Reads the workspaces of learners in ``fixtures/learners``, and writes them as folders (see the README there)."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

from robot_package import write_files

FIXTURES = Path(__file__).parents[1] / "fixtures"
LEARNERS = FIXTURES / "learners"
LESSON = FIXTURES / "lesson" / "src"
PACKAGE = "src/my_first_package/"
INTERFACES = "src/my_robot_interfaces/"
_FOLDERS = {
    "msg": INTERFACES,
    "srv": INTERFACES,
    "action": INTERFACES,
    "launch": PACKAGE,
    "config": PACKAGE,
}
_MARK = re.compile(r"\s*(?:#|<!--)\s*(teacher|also|missed): ([A-Z0-9|]+)(?: -->)?$")
_BESIDE = "Beside it: "
_DEPENDENCIES = (
    *("rclpy", "my_robot_interfaces", "std_msgs", "std_srvs", "sensor_msgs", "geometry_msgs", "nav_msgs"),
    *("example_interfaces", "rcl_interfaces", "diagnostic_msgs", "message_filters", "tf2_ros", "lifecycle_msgs"),
    *("launch", "launch_ros", "ament_index_python", "python3-requests", "python3-numpy"),
)


@dataclass
class Learned:
    """A workspace: its files, and what a teacher would want said of which line.

    ``wanted``, ``missed`` and ``allowed`` hold codes, by file and line: of several codes at one line any will do.
    ``missed`` is what a teacher would say and archlint does not yet; ``allowed`` is true, and beside the point.
    """

    theme: str
    name: str
    files: dict[str, str] = field(default_factory=dict)
    wanted: dict[tuple[str, int], frozenset[str]] = field(default_factory=dict)
    missed: dict[tuple[str, int], frozenset[str]] = field(default_factory=dict)
    allowed: dict[tuple[str, int], frozenset[str]] = field(default_factory=dict)

    @property
    def title(self) -> str:
        return f"{self.theme}: {self.name}"

    def write(self, root: Path) -> Path:
        return write_files(root, self.files)


def learned() -> list[Learned]:
    """All workspaces, in the order in which they are written."""
    return [workspace for path in sorted(LEARNERS.glob("*.txt")) for workspace in _workspaces(path)]


def _workspaces(path: Path) -> Iterator[Learned]:
    _, *parts = re.split(r"^== ", path.read_text("utf-8"), flags=re.MULTILINE)
    for part in parts:
        head, *sections = re.split(r"^-- ", part, flags=re.MULTILINE)
        name, *words = head.splitlines()
        workspace = Learned(path.stem, name)
        for section in sections:
            file, _, text = section.partition("\n")
            _add(workspace, _path_of(file), text.rstrip("\n"))
        beside = [word for line in words if line.startswith(_BESIDE) for word in line[len(_BESIDE) :].split(", ")]
        complete(workspace, beside)
        yield workspace


def _path_of(file: str) -> str:
    if file.startswith("src/"):
        return file
    folder = file.partition("/")[0] if "/" in file else ""
    return _FOLDERS.get(folder, f"{PACKAGE}my_first_package/") + file


def _add(workspace: Learned, file: str, text: str) -> None:
    lines = text.splitlines()
    for number, line in enumerate(lines, 1):
        mark = _MARK.search(line)
        if mark is not None:
            of_kind = {"teacher": workspace.wanted, "missed": workspace.missed, "also": workspace.allowed}
            of_kind[mark[1]][file, number] = frozenset(mark[2].split("|"))
            lines[number - 1] = line[: mark.start()]
    workspace.files[file] = "\n".join(lines) + "\n"


def complete(workspace: Learned, beside: list[str]) -> None:
    """Add what every workspace has and a reader need not see again."""
    files = workspace.files
    for node in beside:
        files[f"{PACKAGE}my_first_package/{node}.py"] = (
            LESSON / "my_first_package/my_first_package" / f"{node}.py"
        ).read_text("utf-8")
    for name in ("msg/SensorReading.msg", "srv/GetSensorData.srv", "srv/SetMotorSpeed.srv"):
        files.setdefault(INTERFACES + name, (LESSON / "my_robot_interfaces" / name).read_text("utf-8"))
    files.setdefault(f"{INTERFACES}package.xml", (LESSON / "my_robot_interfaces/package.xml").read_text("utf-8"))
    files.setdefault(f"{INTERFACES}CMakeLists.txt", _cmake(files))
    files.setdefault(f"{PACKAGE}my_first_package/__init__.py", "")
    files.setdefault(f"{PACKAGE}resource/my_first_package", "")
    files.setdefault(f"{PACKAGE}package.xml", _manifest())
    files.setdefault(f"{PACKAGE}setup.py", _setup(files))
    config = (LESSON / "my_first_package/setup.cfg").read_text("utf-8")
    for folder in [file.removesuffix("setup.py") for file in files if file.endswith("/setup.py")]:
        files.setdefault(f"{folder}setup.cfg", config.replace("my_first_package", folder.split("/")[-2]))


def _cmake(files: dict[str, str]) -> str:
    interfaces = sorted(file.removeprefix(INTERFACES) for file in files if file.endswith((".msg", ".srv", ".action")))
    rows = "".join(f'  "{name}"\n' for name in interfaces)
    text = (LESSON / "my_robot_interfaces/CMakeLists.txt").read_text("utf-8")
    before, _, rest = text.partition("rosidl_generate_interfaces(${PROJECT_NAME}\n")
    dependencies = rest[rest.index("  DEPENDENCIES") :]
    return f"{before}rosidl_generate_interfaces(${{PROJECT_NAME}}\n{rows}{dependencies}"


def _manifest() -> str:
    needs = "".join(f"  <depend>{name}</depend>\n" for name in _DEPENDENCIES)
    return (
        '<package format="3">\n  <name>my_first_package</name>\n  <version>0.1.0</version>\n'
        "  <description>What a learner writes.</description>\n"
        '  <maintainer email="learner@example.com">Learner</maintainer>\n  <license>Apache-2.0</license>\n'
        f"{needs}  <export><build_type>ament_python</build_type></export>\n</package>\n"
    )


def _setup(files: dict[str, str]) -> str:
    """A setup.py with an executable for each module that has a ``main``."""
    folder = f"{PACKAGE}my_first_package/"
    modules = sorted(
        file[len(folder) : -len(".py")]
        for file, text in files.items()
        if file.startswith(folder) and file.endswith(".py") and re.search(r"^(async )?def main\(", text, re.MULTILINE)
    )
    rows = "".join(f"        '{name} = my_first_package.{name}:main',\n" for name in modules)
    return (
        "from glob import glob\n\nfrom setuptools import find_packages, setup\n\nsetup(\n"
        "    name='my_first_package',\n    version='0.1.0',\n    packages=find_packages(),\n    data_files=[\n"
        "        ('share/ament_index/resource_index/packages', ['resource/my_first_package']),\n"
        "        ('share/my_first_package', ['package.xml']),\n"
        "        ('share/my_first_package/launch', glob('launch/*')),\n"
        "        ('share/my_first_package/config', glob('config/*')),\n    ],\n"
        f"    entry_points={{'console_scripts': [\n{rows}    ]}},\n)\n"
    )
