"""What ``ament_python_install_package`` makes importable."""

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
    ],
)
def test_folders_and_the_names_they_are_imported_under(text: str, expected: dict[str, str]):
    assert installed_modules(f"cmake_minimum_required(VERSION 3.8)\n{text}\n", "arm") == expected
