"""PKG004: what scripts that CMake installs import from beside them."""

from __future__ import annotations

import pytest

from robot_package import CMAKE

BUILD = "project(robot)\nfind_package(ament_cmake REQUIRED)\n{}\nament_package()\n"
ALONE = "install(PROGRAMS scripts/drive.py DESTINATION lib/${PROJECT_NAME})"
DRIVE = "#!/usr/bin/env python3\nimport rclpy\n{}\n\ndef main():\n    rclpy.init()\n"


def files(imports: str, installed: str = ALONE, **more: str) -> dict[str, str]:
    """A package that installs a script, which imports something."""
    own = {"package.xml": CMAKE, "CMakeLists.txt": BUILD.format(installed), "scripts/drive.py": DRIVE.format(imports)}
    return {**own, "scripts/gps_tools.py": "RADIUS = 6371.0\n", **more}


@pytest.mark.parametrize("imports", ["import gps_tools", "from gps_tools import RADIUS"])
def test_a_module_that_is_not_installed_beside_the_script(findings, imports):
    (finding,) = findings("PKG004", **files(imports))
    assert finding.message == (
        "the installed script 'drive.py' imports gps_tools.py, which is not installed beside it: a build without "
        "--symlink-install does not have it, and the import fails"
    )
    assert (finding.place.file, finding.place.line, finding.help) == (
        "CMakeLists.txt",
        3,
        "add 'scripts/gps_tools.py' to this install(PROGRAMS …)",
    )
    assert [(row.place.file, row.place.line) for row in finding.related] == [("scripts/drive.py", 3)]


def test_all_that_one_cmake_file_leaves_out(findings):
    line = "install(PROGRAMS scripts/drive.py scripts/turn.py DESTINATION lib/${PROJECT_NAME})"
    more = {"scripts/turn.py": DRIVE.format("import gps_tools\nimport arm_tools"), "scripts/arm_tools.py": "A = 1\n"}
    (finding,) = findings("PKG004", **files("import gps_tools", line, **more))
    assert "another module is left out, too" in finding.message


@pytest.mark.parametrize(
    ("imports", "installed"),
    [
        ("import gps_tools", ALONE.replace("drive.py", "drive.py scripts/gps_tools.py")),
        ("import gps_tools", f"{ALONE}\ninstall(FILES scripts/gps_tools.py DESTINATION lib/robot)"),
        ("import gps_tools", "install(DIRECTORY scripts/ DESTINATION lib/${PROJECT_NAME})"),
        (
            "import gps_tools",
            f"{ALONE}\nfile(GLOB tools scripts/*.py)\ninstall(PROGRAMS ${{tools}} DESTINATION lib/robot)",
        ),
        ("import gps_tools", f"{ALONE}\ninstall_tools(scripts)"),
        ("import sys\nsys.path.append('/opt')\nimport gps_tools", ALONE),
        ("try:\n    import gps_tools\nexcept ImportError:\n    gps_tools = None", ALONE),
        ("import other_tools", ALONE),
        ("import serial", ALONE),
        ("import gps_tools", ""),
    ],
)
def test_a_module_that_is_installed_or_may_be(findings, imports, installed):
    assert findings("PKG004", **files(imports, installed, **{"scripts/serial.py": "A = 1\n"})) == []


@pytest.mark.parametrize(
    "imports", ["from robot.arm_tools import RADIUS", "import robot.arm_tools", "from robot import arm_tools"]
)
def test_a_module_of_the_installed_package_of_python_is_not_needed_beside_the_script(findings, imports):
    line = "ament_python_install_package(${PROJECT_NAME})\n" + ALONE.replace("scripts/", "robot/")
    package = {"robot/__init__.py": "", "robot/arm_tools.py": "RADIUS = 1.0\n"}
    assert findings("PKG004", **files("", line, **package, **{"robot/drive.py": DRIVE.format(imports)})) == []


def test_a_module_that_another_package_has(findings):
    more = {"tools/package.xml": CMAKE.replace("robot", "tools"), "tools/gps_tools.py": "RADIUS = 1.0\n"}
    more["tools/CMakeLists.txt"] = "project(tools)\nfind_package(ament_cmake REQUIRED)\nament_package()\n"
    assert findings("PKG004", **files("import gps_tools", **more)) == []


PACKAGE = {"robot/__init__.py": "", "robot/arm_tools.py": "RADIUS = 1.0\n"}
OF_PACKAGE = "from robot.arm_tools import RADIUS"


@pytest.mark.parametrize("imports", [OF_PACKAGE, "import robot.arm_tools", "from robot import arm_tools"])
def test_a_package_of_python_that_nothing_installs(findings, imports):
    (finding,) = findings("PKG004", **files(imports, **PACKAGE))
    assert finding.message == (
        "the installed script 'drive.py' imports 'robot', a folder that nothing installs where Python looks: the "
        "import fails"
    )
    assert finding.help == "find ament_cmake_python, and write ament_python_install_package(robot)"
    assert (finding.place.line, [row.place.line for row in finding.related]) == (3, [3])


INTERFACES = f"find_package(rosidl_default_generators REQUIRED)\nrosidl_generate_interfaces(robot msg/A.msg)\n{ALONE}"


@pytest.mark.parametrize(
    "imports", ["from robot.msg import A", "import robot.msg", "from robot import msg, srv", "import robot"]
)
def test_the_interfaces_of_a_package_with_the_name_of_a_folder(findings, imports):
    assert findings("PKG004", **files(imports, INTERFACES, **PACKAGE, **{"msg/A.msg": "int32 a\n"})) == []


@pytest.mark.parametrize(
    "imports",
    [
        "from robot.msg import A\nfrom robot.arm_tools import RADIUS",
        "import robot.arm_tools",
        "from robot import msg, arm_tools",
    ],
)
def test_a_module_in_a_folder_with_the_name_of_the_interfaces(findings, imports):
    (finding,) = findings("PKG004", **files(imports, INTERFACES, **PACKAGE, **{"msg/A.msg": "int32 a\n"}))
    assert finding.message == (
        "the installed script 'drive.py' imports 'robot.arm_tools', which nothing installs where Python looks: the "
        "package 'robot' that it finds has the interfaces alone, and the import fails"
    )
    assert finding.help == (
        "rename the folder 'robot', also where it is imported, for rosidl_generate_interfaces() installs a package of "
        "this name; then install it with ament_python_install_package()"
    )


@pytest.mark.parametrize(
    ("imports", "installed"),
    [
        (OF_PACKAGE, f"{ALONE}\nament_python_install_package(robot)"),
        (OF_PACKAGE, f"{ALONE}\ninstall(DIRECTORY robot DESTINATION ${{PYTHON_INSTALL_DIR}})"),
        (OF_PACKAGE, f"{ALONE}\ninstall(DIRECTORY robot DESTINATION lib/${{PROJECT_NAME}})"),
        (OF_PACKAGE, f"{ALONE}\nament_environment_hooks(path.dsv)"),
        (f"import sys\nsys.path.append('/opt')\n{OF_PACKAGE}", ALONE),
        (f"try:\n    {OF_PACKAGE}\nexcept ImportError:\n    pass", ALONE),
        ("from rclpy.arm_tools import RADIUS", ALONE),
    ],
)
def test_a_package_of_python_that_is_installed_or_may_be(findings, imports, installed):
    assert findings("PKG004", **files(imports, installed, **PACKAGE)) == []
