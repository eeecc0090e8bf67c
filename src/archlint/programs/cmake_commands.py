"""Commands of ament that a build calls by a name that there is not, or that it lacks.

Sources: CMake stops at a command that nothing defines.  ``ament_lint_auto`` of ament_lint has one command,
``ament_lint_auto_find_test_dependencies``; the others are those of ament_cmake, rosidl, rclcpp_components and
pluginlib, Humble to Rolling.  It is ``ament_package()`` of ament_cmake_core that installs package.xml and the entry in
the index of packages, by which ``ros2 run`` and launch find a package.
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Sequence

from archlint.finding import Place
from archlint.programs.cmake_names import may_find
from archlint.suggestions import distance
from archlint.workspace.cmake import Command
from archlint.workspace.cmake_run import CMAKE_FILE, Step
from archlint.workspace.installed import Installs, MisspeltCommand

_OF_LINT_AUTO = "ament_lint_auto_"
_FINDS_TESTS = "ament_lint_auto_find_test_dependencies"
_COMMANDS = (
    *("ament_package", "ament_package_xml", "ament_auto_package", "ament_target_dependencies"),
    *("ament_auto_add_executable", "ament_auto_add_library", "ament_auto_find_build_dependencies"),
    *("ament_export_dependencies", "ament_export_include_directories", "ament_export_interfaces"),
    *("ament_export_libraries", "ament_export_targets", "ament_python_install_package", _FINDS_TESTS),
    *("ament_add_gmock", "ament_add_gtest", "ament_add_pytest_test", "ament_environment_hooks"),
    *("ament_index_register_resource", "rosidl_generate_interfaces", "rosidl_get_typesupport_target"),
    *("rosidl_target_interfaces", "rclcpp_components_register_node", "rclcpp_components_register_nodes"),
    *("pluginlib_export_plugin_description_file", "generate_parameter_library"),
)
"""Those that the build of a package calls most."""
_SLIP = 2
"""Letters of such a name that may be wrong: these are long."""
_OF_PACKAGES = frozenset({"ament_package", "ament_auto_package", "ament_package_xml", "return", "catkin_package"}) | {
    *("ament_index_register_package", "install_package", "include_guard"),
}
"""Words of files that register their package, or may end before the end."""


def misspelt_commands(steps: Sequence[Step], words: frozenset[str]) -> Iterator[MisspeltCommand]:
    """The commands that always run, or run for tests, whose name is almost one of ament's."""
    for step in steps:
        command = step.command
        meant = None if step.conditional and not step.of_tests else _meant(command.name)
        if meant is not None and not _may_be_defined(command, words):
            place = Place(step.file, command.line, command.column, command.line, command.column + len(command.name))
            yield MisspeltCommand(command.name, meant, place)


def _meant(name: str) -> str | None:
    """What a command is called that was meant; None for a name that is right, or that may be one of others."""
    if name in _COMMANDS:
        return None
    if name.startswith(_OF_LINT_AUTO):
        return _FINDS_TESTS
    return next((command for command in _COMMANDS if distance(name, command, _SLIP) <= _SLIP and _is_long(name)), None)


_LONG = 12


def _is_long(name: str) -> bool:
    return len(name) >= _LONG


def _may_be_defined(command: Command, words: frozenset[str]) -> bool:
    """Whether the files ask if there is such a command: ``if(COMMAND ament_…)``."""
    return "COMMAND" in words and command.name in words


def unregistered_at(installs: Installs, steps: Sequence[Step]) -> Place | None:
    """The last command of a package's CMakeLists.txt, where nothing in all of the build registers the package."""
    own = posixpath.normpath(posixpath.join(installs.folder, CMAKE_FILE))
    if not _OF_PACKAGES.isdisjoint(installs.words) or installs.is_indexed_as(installs.package):
        return None
    last = next((step.command for step in reversed(steps) if posixpath.normpath(step.file) == own), None)
    if last is None or any(may_find(step.command) for step in steps) or not any(map(_finds_ament, steps)):
        return None
    return Place(own, last.line, last.column, last.line, last.column + len(last.name))


_BRINGS_COMMANDS = frozenset(
    {"add_subdirectory", "cmake_language", "cpmaddpackage", "find_package", "function", "include"}
) | {
    *("fetchcontent_makeavailable", "load_cache", "macro", "return"),
}
"""Words of files that find packages, define commands, or may end before the end."""


def unbrought_at(installs: Installs, steps: Sequence[Step]) -> Place | None:
    """Where a package's CMakeLists.txt calls ``ament_package()`` and nothing brings a command of that name."""
    own = posixpath.normpath(posixpath.join(installs.folder, CMAKE_FILE))
    if not _BRINGS_COMMANDS.isdisjoint(installs.words):
        return None
    calls = [step for step in steps if step.command.name == _REGISTERS]
    others = (step.command for step in steps if step.command.name != _REGISTERS)
    if (
        len(calls) != 1
        or calls[0].conditional
        or posixpath.normpath(calls[0].file) != own
        or any(map(may_find, others))
    ):
        return None
    call = calls[0].command
    return Place(own, call.line, call.column, call.line, call.column + len(call.name))


_REGISTERS = "ament_package"


def _finds_ament(step: Step) -> bool:
    """Whether a command always finds ament_cmake or a part of it: the package is not built by other means."""
    texts = step.command.texts[:1] if step.command.name == "find_package" and not step.conditional else ()
    return any(name.startswith("ament_cmake") for name in texts)


__all__ = ["misspelt_commands", "unbrought_at", "unregistered_at"]
