"""PKG004: headers that other packages include and that no build installs."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Finding
from robot_package import manifest, write_files

LIBRARY = """cmake_minimum_required(VERSION 3.8)
project(kinematics)
add_library(kinematics src/solver.cpp)
{lines}
ament_package()
"""
INSTALLED = "install(DIRECTORY include/ DESTINATION include)"
EXPORTED = "\nament_export_include_directories(include)"
USER = """cmake_minimum_required(VERSION 3.8)
project(arm)
find_package(kinematics REQUIRED)
add_executable(driver src/driver.cpp)
install(TARGETS driver DESTINATION lib/arm)
ament_package()
"""
FILES = {
    "kinematics/package.xml": manifest("kinematics", "ament_cmake"),
    "kinematics/include/kinematics/solver.hpp": "#pragma once\nint solve();\n",
    "kinematics/src/solver.cpp": '#include "kinematics/solver.hpp"\nint solve() { return 0; }\n',
    "arm/package.xml": manifest("arm", "ament_cmake", "<depend>kinematics</depend>"),
    "arm/CMakeLists.txt": USER,
    "arm/src/driver.cpp": "#include <kinematics/solver.hpp>\nint main() { return solve(); }\n",
}
Judge = Callable[..., list[Finding]]


@pytest.fixture
def judge(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Judge:
    """What PKG004 says of a library with some lines of CMake, and of a program that includes its header."""
    monkeypatch.chdir(tmp_path)

    def run(lines: str, **files: str) -> list[Finding]:
        own = {"kinematics/CMakeLists.txt": LIBRARY.format(lines=lines), "archlint.toml": 'select = ["PKG004"]\n'}
        write_files(tmp_path, FILES | own | files)
        return check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings

    return run


@pytest.mark.parametrize(
    "lines",
    [
        "install(TARGETS kinematics DESTINATION lib)",
        "install(DIRECTORY config DESTINATION share/kinematics OPTIONAL)",
        "install(FILES include/kinematics/other.hpp DESTINATION include/kinematics OPTIONAL)",
    ],
)
def test_a_header_that_nothing_installs(judge: Judge, lines: str):
    (told,) = judge(lines)
    assert told.message == (
        "package 'kinematics' does not install the header 'include/kinematics/solver.hpp', which arm/src/driver.cpp "
        "includes: its build does not find it"
    )
    assert told.help == "add install(DIRECTORY include/ DESTINATION include)"
    assert (told.place.file, told.place.line) == ("kinematics/CMakeLists.txt", 5)
    assert [(row.place.file, row.place.line) for row in told.related] == [("arm/src/driver.cpp", 1)]


@pytest.mark.parametrize(
    "lines",
    [
        INSTALLED + EXPORTED,
        "install(DIRECTORY include/${PROJECT_NAME} DESTINATION include)" + EXPORTED,
        "install(FILES include/kinematics/solver.hpp DESTINATION include/kinematics)" + EXPORTED,
        INSTALLED + "\ninstall(TARGETS kinematics EXPORT all DESTINATION lib)\nament_export_targets(all)",
        "install(TARGETS kinematics DESTINATION lib PUBLIC_HEADER DESTINATION include)",
        "ament_auto_package()",
        "install(DIRECTORY ${HEADERS} DESTINATION include)",
        "acme_install_headers(include)",
    ],
)
def test_a_header_that_is_installed_or_may_be(judge: Judge, lines: str):
    assert judge(lines) == []


def test_a_header_that_is_installed_and_not_exported(judge: Judge):
    (told,) = judge(f"{INSTALLED}\ninstall(TARGETS kinematics DESTINATION lib)")
    assert told.message == (
        "package 'kinematics' installs the header 'include/kinematics/solver.hpp', which arm/src/driver.cpp includes, "
        "and does not export its folder: its build does not find it"
    )
    assert (told.place.file, told.place.line) == ("kinematics/CMakeLists.txt", 6)


@pytest.mark.parametrize(
    ("file", "text"),
    [
        ("arm/include/kinematics/solver.hpp", "#pragma once\nint solve();\n"),
        ("arm/CMakeLists.txt", USER.replace("add_exec", "include_directories(../kinematics/include)\nadd_exec")),
        ("arm/src/driver.cpp", "#if WITH_ARM\n#include <kinematics/solver.hpp>\n#endif\nint main() { return 0; }\n"),
    ],
)
def test_a_header_that_is_found_elsewhere(judge: Judge, file: str, text: str):
    assert judge("", **{file: text}) == []


def test_a_header_that_only_its_own_package_includes(judge: Judge):
    assert judge("", **{"arm/src/driver.cpp": "int main() { return 0; }\n"}) == []
