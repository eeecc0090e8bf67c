"""The names under which Python would import the files of a workspace."""

from __future__ import annotations

from workspace.trees import look, manifest, plant


def modules(workspace) -> dict[str, str | None]:
    return {file.relative: file.module for file in workspace.files if file.relative.endswith(".py") or file.module}


def test_an_ament_python_package(tmp_path):
    plant(
        tmp_path,
        {
            "robot/package.xml": manifest("robot"),
            "robot/setup.py": "",
            "robot/robot/__init__.py": "",
            "robot/robot/node.py": "",
            "robot/robot/parts/__init__.py": "",
            "robot/robot/parts/arm.py": "",
            "robot/robot/data/table.py": "",
            "robot/launch/robot.launch.py": "",
            "robot/launch/bringup.py": "",
            "robot/test/test_node.py": "",
            "robot/scripts/start-robot.py": "",
        },
    )
    assert modules(look(tmp_path)) == {
        "robot/launch/bringup.py": "bringup",
        "robot/launch/robot.launch.py": None,
        "robot/robot/__init__.py": "robot",
        "robot/robot/data/table.py": "robot.data.table",
        "robot/robot/node.py": "robot.node",
        "robot/robot/parts/__init__.py": "robot.parts",
        "robot/robot/parts/arm.py": "robot.parts.arm",
        "robot/scripts/start-robot.py": None,
        "robot/setup.py": "setup",
        "robot/test/test_node.py": "test_node",
    }


def test_the_folder_of_the_packages_own_name_needs_no_init(tmp_path):
    plant(
        tmp_path,
        {
            "robot/package.xml": manifest("robot"),
            "robot/robot/node.py": "",
            "robot/src/robot/other.py": "",
            "robot/tools/robot/third.py": "",
        },
    )
    assert modules(look(tmp_path)) == {
        "robot/robot/node.py": "robot.node",
        "robot/src/robot/other.py": "robot.other",
        "robot/tools/robot/third.py": "third",
    }


def test_no_name_reaches_above_the_ros_package(tmp_path):
    plant(
        tmp_path,
        {
            "src/__init__.py": "",
            "src/robot/package.xml": manifest("robot"),
            "src/robot/__init__.py": "",
            "src/robot/robot/__init__.py": "",
            "src/robot/robot/node.py": "",
        },
    )
    names = modules(look(tmp_path))
    assert names["src/robot/robot/node.py"] == "robot.node"
    assert names["src/robot/__init__.py"] is None


def test_cmake_installs_a_folder_under_a_name_of_its_own(tmp_path):
    plant(
        tmp_path,
        {
            "arm/package.xml": manifest("arm", "ament_cmake"),
            "arm/CMakeLists.txt": """
                project(arm)
                ament_python_install_package(${PROJECT_NAME} PACKAGE_DIR "${CMAKE_CURRENT_SOURCE_DIR}/src/python")
                ament_python_install_package(arm_tools
                  PACKAGE_DIR tools SCRIPTS_DESTINATION lib/${PROJECT_NAME})
                # ament_python_install_package(gone PACKAGE_DIR unused)
                ament_python_install_package(${DYNAMIC})
            """,
            "arm/src/python/driver.py": "",
            "arm/src/python/parts/joint.py": "",
            "arm/tools/calibrate.py": "",
            "arm/unused/x.py": "",
        },
    )
    assert modules(look(tmp_path)) == {
        "arm/src/python/driver.py": "arm.driver",
        "arm/src/python/parts/joint.py": "arm.parts.joint",
        "arm/tools/calibrate.py": "arm_tools.calibrate",
        "arm/unused/x.py": "x",
    }


def test_files_in_no_package(tmp_path):
    plant(
        tmp_path,
        {
            "node.py": "",
            "lib/__init__.py": "",
            "lib/sub/__init__.py": "",
            "lib/sub/x.py": "",
            "scripts/talker": "#!/usr/bin/env python3\n",
        },
    )
    expected = {"lib/__init__.py": "lib", "lib/sub/__init__.py": "lib.sub", "lib/sub/x.py": "lib.sub.x"}
    expected |= {"node.py": "node", "scripts/talker": "talker"}
    assert modules(look(tmp_path)) == expected
    assert modules(look(tmp_path, "lib/sub")) == {"lib/sub/__init__.py": "lib.sub", "lib/sub/x.py": "lib.sub.x"}


def test_a_folder_that_cmake_copies_under_another_name_has_both(tmp_path):
    plant(
        tmp_path,
        {
            "robot/package.xml": manifest("robot", build_type="ament_cmake"),
            "robot/CMakeLists.txt": "install(DIRECTORY scripts/ DESTINATION ${PYTHON_INSTALL_DIR}/${PROJECT_NAME})",
            "robot/scripts/speeds.py": "",
            "robot/tools/plot.py": "",
        },
    )
    workspace = look(tmp_path)
    assert modules(workspace) == {"robot/scripts/speeds.py": "robot.speeds", "robot/tools/plot.py": "plot"}
    names = {file.relative: [link.module for link in file.links] for file in workspace.files if file.links}
    assert names == {"robot/scripts/speeds.py": ["speeds"]}


def test_package_dir_counts_where_setup_py_is_run(tmp_path):
    for name, build_type in (("robot", "ament_python"), ("arm", "ament_cmake")):
        plant(
            tmp_path,
            {
                f"{name}/package.xml": manifest(name, build_type=build_type),
                f"{name}/setup.py": f"setup(package_dir={{'{name}': 'scripts'}})",
                f"{name}/scripts/speeds.py": "",
            },
        )
    assert modules(look(tmp_path)) == {
        "arm/scripts/speeds.py": "speeds",
        "arm/setup.py": "setup",
        "robot/scripts/speeds.py": "robot.speeds",
        "robot/setup.py": "setup",
    }
