"""The commands of a CMakeLists.txt that CMake or ament refuses as they are written.

Sources: ``target_link_libraries`` of CMake takes one signature for each target (policy CMP0023), and
``ament_target_dependencies`` without ``PUBLIC`` has the plain one; a second target of a name is refused (CMP0002), and
``rosidl_generate_interfaces`` makes a target of its first argument; ``install(FILES)`` needs a ``DESTINATION``.
``ament_python_install_package`` of ament_cmake_python stops at a folder without an ``__init__.py``, and since Humble
rosidl_generator_py calls it for the interfaces of a package.
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Mapping, Sequence
from typing import Protocol

from archlint.finding import Place
from archlint.workspace.cmake import Argument, Command
from archlint.workspace.cmake_run import Step
from archlint.workspace.installed import CalledCommand, Refusal, RefusedCommand

_LINKS = "target_link_libraries"
_GENERATES = "rosidl_generate_interfaces"
_INSTALLS_PYTHON = "ament_python_install_package"
_OF_AMENT = "ament_target_dependencies"
_SCOPES = frozenset({"PUBLIC", "PRIVATE", "INTERFACE"})
_OF_INTERFACES = (".msg", ".srv", ".action", ".idl")
_OPTIONS = frozenset(
    {"DEPENDENCIES", "LIBRARY_NAME", "SKIP_INSTALL", "SKIP_GROUP_MEMBERSHIP_CHECK", "ADD_LINTER_TESTS"}
)
_NO_TARGETS_OF_THEIR_OWN = frozenset({"IMPORTED", "ALIAS", "INTERFACE"})

PACKAGES_OF_COMMANDS: Mapping[str, str] = {
    "rosidl_generate_interfaces": "rosidl_default_generators",
    "rclcpp_components_register_node": "rclcpp_components",
    "rclcpp_components_register_nodes": "rclcpp_components",
    "pluginlib_export_plugin_description_file": "pluginlib",
    "generate_parameter_library": "generate_parameter_library",
    "ament_auto_add_executable": "ament_cmake_auto",
    "ament_auto_add_library": "ament_cmake_auto",
    "ament_auto_package": "ament_cmake_auto",
    "ament_lint_auto_find_test_dependencies": "ament_lint_auto",
    "ament_add_gtest": "ament_cmake_gtest",
    "ament_add_gmock": "ament_cmake_gmock",
    "ament_add_pytest_test": "ament_cmake_pytest",
}
"""Commands, and the packages that define them."""


class Files(Protocol):
    """The files of the workspace by shown paths."""

    def is_file(self, path: str) -> bool: ...


def refused_commands(steps: Sequence[Step], files: Files | None) -> Iterator[RefusedCommand]:
    """Those that always run, or run for tests; ``files`` is None where the build may make some itself."""
    always = [step for step in steps if step.of_tests or not step.conditional]
    yield from _two_signatures([step for step in steps if not step.conditional])
    yield from _made_twice([step for step in steps if not step.conditional])
    yield from _python_twice([step for step in steps if not step.conditional])
    for step in always:
        if step.command.name == "install":
            yield from _without_destination(step)
        elif step.command.name == _GENERATES:
            yield from _words_for_files(step)
        elif step.command.name == _INSTALLS_PYTHON and files is not None:
            yield from _no_package_of_python(step, files)


def called_commands(steps: Sequence[Step]) -> Iterator[CalledCommand]:
    """The commands that always run, or run for tests, and that a package defines which has to be found."""
    told = set[str]()
    for step in steps:
        command = step.command
        package = PACKAGES_OF_COMMANDS.get(command.name)
        if package is not None and command.name not in told and (step.of_tests or not step.conditional):
            told.add(command.name)
            yield CalledCommand(command.name, package, _place_of_name(step))


def _two_signatures(steps: Sequence[Step]) -> Iterator[RefusedCommand]:
    """The first command for a target that has another signature than the one before."""
    signatures: dict[str, tuple[bool, Step]] = {}
    told = set[str]()
    for step in steps:
        command = step.command
        is_plain = _is_plain(command)
        if is_plain is None:
            continue
        target = command.texts[0]
        before = signatures.setdefault(target, (is_plain, step))
        if before[0] != is_plain and target not in told:
            told.add(target)
            first = _place(before[1].command.arguments[0], before[1])
            yield RefusedCommand("two signatures", target, command.name, _place(command.arguments[0], step), first)


def _is_plain(command: Command) -> bool | None:
    """Whether a command links a target without saying for whom; None for one that may link nothing."""
    if command.name not in (_LINKS, _OF_AMENT) or any(argument.open for argument in command.arguments[:2]):
        return None
    texts = [text for text in command.texts[1:] if text != "SYSTEM"]
    if not texts:
        return None
    if texts[0] in _SCOPES:
        others = [argument for argument in command.arguments[1:] if argument.text not in _SCOPES]
        return None if all(argument.open for argument in others) else False
    if texts[0].startswith("LINK_"):
        return None
    return True


def _made_twice(steps: Sequence[Step]) -> Iterator[RefusedCommand]:
    """The commands that make a target which another one has made before."""
    makers: dict[str, Step] = {}
    for step in steps:
        command = step.command
        makes = command.name in ("add_executable", "add_library", _GENERATES)
        if not makes or not command.arguments or command.arguments[0].open:
            continue
        target = command.texts[0]
        if not _NO_TARGETS_OF_THEIR_OWN.isdisjoint(command.texts):
            continue
        first = makers.setdefault(target, step)
        if first is not step:
            of_types = _GENERATES in (command.name, first.command.name)
            kind: Refusal = "types made twice" if of_types and command.name != first.command.name else "made twice"
            yield RefusedCommand(kind, target, command.name, _place(command.arguments[0], step), _place_of_name(first))


def _python_twice(steps: Sequence[Step]) -> Iterator[RefusedCommand]:
    """The command that installs a Python package of the name which the interfaces have: both make a target for it."""
    types = [step for step in steps if step.command.name == _GENERATES and step.command.arguments]
    for step in steps:
        if step.command.name != _INSTALLS_PYTHON or not step.command.arguments:
            continue
        name = step.command.arguments[0]
        first = next((row for row in types if row.command.texts[0] == name.text), None)
        if first is not None and not name.open and "SKIP_INSTALL" not in first.command.texts:
            yield RefusedCommand(
                "two packages of Python", name.text, _INSTALLS_PYTHON, _place(name, step), _place_of_name(first)
            )


def _without_destination(step: Step) -> Iterator[RefusedCommand]:
    arguments = step.command.arguments
    if len(arguments) < 2 or arguments[0].text not in ("FILES", "PROGRAMS", "DIRECTORY"):
        return
    if any(argument.open for argument in arguments):
        return  # the destination may be in it
    if {"DESTINATION", "TYPE"}.isdisjoint(step.command.texts):
        near = next((argument for argument in arguments if _is_nearly_destination(argument.text)), None)
        named = arguments[0] if near is None else near
        yield RefusedCommand("no destination", named.text, "install", _place(named, step))


def _is_nearly_destination(text: str) -> bool:
    return text.isupper() and text.startswith("DEST")


def _words_for_files(step: Step) -> Iterator[RefusedCommand]:
    """A file where the name of a target belongs, and a word in capital letters that is no option."""
    target, *others = step.command.arguments or (None,)
    if target is None:
        return
    if target.text.endswith(_OF_INTERFACES):
        yield RefusedCommand("no target", target.text, _GENERATES, _place(target, step))
    for argument in others:
        if argument.text.isupper() and argument.text.isascii() and argument.text not in _OPTIONS and _is_word(argument):
            yield RefusedCommand("no option", argument.text, _GENERATES, _place(argument, step))


def _is_word(argument: Argument) -> bool:
    return not argument.open and argument.text.replace("_", "").isalpha()


def _no_package_of_python(step: Step, files: Files) -> Iterator[RefusedCommand]:
    arguments, texts = step.command.arguments, step.command.texts
    if not arguments or any(argument.open for argument in arguments):
        return
    folder = texts[texts.index("PACKAGE_DIR") + 1] if "PACKAGE_DIR" in texts[:-1] else texts[0]
    path = step.path(folder)
    if not posixpath.isabs(path) and not files.is_file(posixpath.join(path, "__init__.py")):
        yield RefusedCommand("no package of Python", path, _INSTALLS_PYTHON, _place(arguments[0], step))


def _place(argument: Argument, step: Step) -> Place:
    return Place(step.file, argument.line, argument.column, argument.line, argument.column + len(argument.text))


def _place_of_name(step: Step) -> Place:
    command = step.command
    return Place(step.file, command.line, command.column, command.line, command.column + len(command.name))


__all__ = ["PACKAGES_OF_COMMANDS", "called_commands", "refused_commands"]
