"""Which files and folders are imported under a name that CMakeLists.txt gives them."""

from __future__ import annotations

import pytest

from archlint.workspace.installed_modules import installed_modules


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("ament_python_install_package(robot)", {"robot": "robot"}),
        ("ament_python_install_package(${PROJECT_NAME})", {"arm": "arm"}),
        ("project(gripper)\nament_python_install_package(${PROJECT_NAME})", {"gripper": "gripper"}),
        (
            'ament_python_install_package(robot PACKAGE_DIR "${CMAKE_CURRENT_SOURCE_DIR}/src/robot")',
            {"src/robot": "robot"},
        ),
        ("ament_python_install_package(robot PACKAGE_DIR ${generated})", {}),
        ("# ament_python_install_package(robot)", {}),
        ("#[[\nament_python_install_package(robot)\n]]", {}),
        ('message("next: ament_python_install_package(robot)")', {}),
        ("install(DIRECTORY scripts/ DESTINATION ${PYTHON_INSTALL_DIR}/${PROJECT_NAME})", {"scripts": "arm"}),
        ("install(DIRECTORY nodes DESTINATION ${PYTHON_INSTALL_DIR}/arm)", {"nodes": "arm.nodes"}),
        ("install(DIRECTORY src/arm DESTINATION ${PYTHON_INSTALL_DIR} PATTERN test EXCLUDE)", {"src/arm": "arm"}),
        (
            "set(CODE src/python)\ninstall(DIRECTORY ${CODE}/ DESTINATION lib/python${VERSION}/site-packages/arm)",
            {"src/python": "arm"},
        ),
        (
            "install(FILES src/__init__.py src/joints.py DESTINATION ${PYTHON_INSTALL_DIR}/${PROJECT_NAME})",
            {"src/__init__.py": "arm", "src/joints.py": "arm.joints"},
        ),
        ("install(DIRECTORY scripts/ DESTINATION lib/${PROJECT_NAME})", {}),
        ("install(DIRECTORY scripts/ DESTINATION share/${PROJECT_NAME}/site-packages)", {}),
        ("install(DIRECTORY ${generated}/ DESTINATION ${PYTHON_INSTALL_DIR}/arm)", {}),
        ("install(DIRECTORY ./ DESTINATION ${PYTHON_INSTALL_DIR}/arm)", {}),
        ("install(DIRECTORY scripts/ DESTINATION ${PYTHON_INSTALL_DIR}/${name})", {}),
        ("set(name gripper)\nproject(${name})\nament_python_install_package(${PROJECT_NAME})", {"gripper": "gripper"}),
        (
            "set(parts joints tools)\nforeach(part ${parts})\n"
            "install(DIRECTORY src/${part} DESTINATION ${PYTHON_INSTALL_DIR}/arm)\nendforeach()",
            {"src/joints": "arm.joints", "src/tools": "arm.tools"},
        ),
        (
            "set(code old)\nset(code new)\ninstall(DIRECTORY ${code}/ DESTINATION ${PYTHON_INSTALL_DIR}/arm)",
            {"new": "arm"},
        ),
        (
            "set(code old)\nif(NEW)\nset(code new)\nendif()\n"
            "install(DIRECTORY ${code}/ DESTINATION ${PYTHON_INSTALL_DIR}/arm)",
            {},  # one of the two
        ),
        ("function(put)\nament_python_install_package(robot)\nendfunction()", {}),  # nothing calls it
    ],
)
def test_folders_and_the_names_they_are_imported_under(text: str, expected: dict[str, str]):
    assert installed_modules(f"cmake_minimum_required(VERSION 3.8)\n{text}\n", "arm") == expected
