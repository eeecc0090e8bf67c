"""The shared libraries that CMake builds and does not install, though what it installs is linked with them.

Source: ``install(TARGETS)`` of CMake takes the folder of the build out of a program's run path; a library that is not
installed is not found when the program starts.  ``ament_auto_package()`` of ament_cmake_auto installs the targets that
are in the list ``${PROJECT_NAME}_LIBRARIES``, into which ``ament_auto_add_library()`` puts its own.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from archlint.finding import Place
from archlint.workspace.cmake_run import Step
from archlint.workspace.installed import LeftLibrary

_LINKS = "target_link_libraries"
_OF_COMPONENTS = frozenset({"rclcpp_components_register_node", "rclcpp_components_register_nodes"})
_SETS = frozenset({"list", "set"})
_OF_AUTO = "_LIBRARIES"


def left_libraries(steps: Sequence[Step], words: frozenset[str]) -> Iterator[LeftLibrary]:
    """Each of them, with a target that needs it."""
    if any("RPATH" in word for word in words) or _names_what_to_install(steps):
        return
    installed = _installed(steps)
    libraries = {
        step.command.texts[0]: step
        for step in steps
        if step.command.name == "add_library" and _is_built(step.command.texts) and not step.conditional
    }
    for name, step in libraries.items():
        if installed is None or name in installed or step.command.arguments[0].open or _is_named_elsewhere(steps, name):
            continue
        needed = next(_needing(steps, name, installed), None)
        if needed is not None:
            argument = step.command.arguments[0]
            end = argument.column + len(argument.text)
            yield LeftLibrary(name, needed, Place(step.file, argument.line, argument.column, argument.line, end))


def _names_what_to_install(steps: Sequence[Step]) -> bool:
    """Whether ``ament_auto_package()`` may install a library that it did not make."""
    if not any(step.command.name == "ament_auto_package" for step in steps):
        return False
    return any(
        step.command.name in _SETS and any(text.endswith(_OF_AUTO) for text in step.command.texts) for step in steps
    )


def _is_built(texts: Sequence[str]) -> bool:
    """Whether ``add_library`` builds a shared library: one that is imported is there already, and CMake refuses to
    install its target."""
    return "SHARED" in texts[1:2] and "IMPORTED" not in texts


def _installed(steps: Sequence[Step]) -> frozenset[str] | None:
    """The targets that any command installs; None where one of them may be any."""
    names: set[str] = set()
    for step in steps:
        if step.command.name == "install":
            if any(argument.open and "TARGETS" in step.command.texts for argument in step.command.arguments):
                return None
            names.update(step.command.texts)
    return frozenset(names)


def _is_named_elsewhere(steps: Sequence[Step], name: str) -> bool:
    """Whether a command that is not known here is given a library, or its file is installed by another way."""
    for step in steps:
        command = step.command
        known = command.name.startswith(("target_", "add_", "set_", "ament_", "rosidl_", "rclcpp_components_"))
        if command.name != "install" and not known and name in command.texts:
            return True
        if any(f"{name}>" in text for text in command.texts):  # $<TARGET_FILE:name>
            return True
    return False


def _needing(steps: Sequence[Step], name: str, installed: frozenset[str]) -> Iterator[str]:
    """The installed targets that are linked with a library, and the program of a component in it."""
    for step in steps:
        texts = step.command.texts
        if step.conditional or not texts:
            continue
        if step.command.name == _LINKS and name in texts[1:] and texts[0] in installed and texts[0] != name:
            yield texts[0]
        elif step.command.name in _OF_COMPONENTS and texts[0] == name:
            yield texts[texts.index("EXECUTABLE") + 1] if "EXECUTABLE" in texts[:-1] else "its components"


__all__ = ["left_libraries"]
