"""The targets that CMake commands make of C++ sources, and all that these commands may give them: packages, other
targets, libraries of the system.

Whatever a command gives in one of several cases counts as given, and so does what a folder has for all its targets.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import field

from archlint.finding import Place
from archlint.records import dataclass
from archlint.ros import packages
from archlint.workspace.cmake import Argument, Command
from archlint.workspace.cmake_run import Step
from archlint.workspace.installed import BuiltTarget

_MAKES = frozenset({"add_executable", "add_library"})
_SOURCES = (".cpp", ".cc", ".cxx")
_GIVES = frozenset(
    {"ament_target_dependencies", "target_link_libraries", "target_include_directories", "rosidl_target_interfaces"}
)
"""Commands that give the target which is named first what follows."""
_ASKS = frozenset({"find_package", "pkg_check_modules", "pkg_search_module", "find_library", "find_path", "find_file"})
"""Commands that set variables of what is named first."""
_OF_SYSTEM = re.compile(
    r"asio|boost(_\w+)?|catkin|ceres|eigen3?|ffmpeg|gazebo|glog|ogre|opencv|pcl(_\w+)?|python3?|qt5?\w*|yaml_cpp",
    re.IGNORECASE,
)
"""Libraries whose variables one package finds for another one."""
_SUFFIX = re.compile(r"_(?:LIBRARIES|LIBRARY|LIBS|INCLUDE_DIRS?|INCLUDES)$")
_OPTIONS_OF_ALL = frozenset({"add_compile_options", "add_definitions", "set_directory_properties"})
_TO_ALL = frozenset({"include_directories", "link_libraries"})
_CHANGE_NO_HEADERS = frozenset(
    {"install", "add_dependencies", "export", "target_compile_features", "target_compile_definitions", "add_test"}
    | {"target_compile_options", "set_target_properties", "set_property", "message", "get_target_property", "set"}
    | {"rclcpp_components_register_node", "rclcpp_components_register_nodes", "ament_export_targets", "list", "project"}
    | {"ament_export_libraries", "ament_export_interfaces", "pluginlib_export_plugin_description_file", "if", "elseif"}
    | {"target_link_directories", "target_link_options", "generate_export_header", "ament_package", "find_package"}
    | {"ament_export_dependencies", "ament_export_include_directories", "rosidl_get_typesupport_target", "foreach"}
)
"""Commands that may name a target without giving it folders of headers."""
_INCLUDES = ("INCLUDE_DIRECTORIES", "LINK_LIBRARIES", "COMPILE_FLAGS", "-I")
"""What stands in a property, or an option, that brings headers after all."""
_KEYWORDS = frozenset(
    {"PUBLIC", "PRIVATE", "INTERFACE", "SYSTEM", "BEFORE", "AFTER", "LINK_PUBLIC", "LINK_PRIVATE"}
) | {
    *("STATIC", "SHARED", "MODULE", "OBJECT", "EXCLUDE_FROM_ALL", "debug", "optimized", "general"),
}
_OF_PACKAGE = re.compile(r"\$\{([\w.+-]+?)_(?:TARGETS|LIBRARIES|LIBRARY|LIBS|INCLUDE_DIRS?|INCLUDES|LIBRARY_DIRS)\}")
_ALIAS = re.compile(r"([\w.+-]+)::[\w.:+-]+")
_OWN_FOLDER = re.compile(
    r"\$<BUILD_INTERFACE:[^$]*>|\$<INSTALL_INTERFACE:[^$]*>"
    r"|\$\{CMAKE_(?:CURRENT_BINARY_DIR|BINARY_DIR|DL_LIBS|THREAD_LIBS_INIT)\}[\w./-]*"
)
_PREFIX_OF_ROS = re.compile(r"/opt/ros|\binstall/|\$ENV\{|\$\{CMAKE_(?:INSTALL_PREFIX|PREFIX_PATH)")


@dataclass
class _Target:
    name: str
    place: Place
    sources: tuple[str, ...] = ()
    given: set[str] = field(default_factory=set)
    open: bool = False
    settled: bool = False
    """Whether the place is that of a command which gives it something."""


@dataclass(frozen=True)
class _Build:
    """What the arguments of commands may mean in a build."""

    package: str
    support: set[str]
    """The variables that hold the type support of the package's own interfaces."""
    asked_for: set[str]
    """Packages that set variables such as ``NAME_LIBRARIES``, in lower case."""

    def is_known(self, name: str) -> bool:
        """Whether ``NAME_LIBRARIES`` is what it says; that of no package may hold anything."""
        return name.lower() in self.asked_for or name in packages.table().names or bool(_OF_SYSTEM.fullmatch(name))


def built_targets(steps: Sequence[Step], package: str) -> list[BuiltTarget]:
    """Each target, in the order in which they are made."""
    build = _Build(package, {step.command.texts[0] for step in steps if _gets_type_support(step)}, _asked_for(steps))
    targets: dict[str, _Target] = {}
    all_given, all_open = set[str](), any(map(_gives_folders_to_all, steps))
    for step in steps:
        command = step.command
        if command.name in _MAKES and command.arguments and not command.arguments[0].open:
            _make(targets, step, package)
        elif command.name in _TO_ALL:
            all_open |= not _add(all_given, command.arguments, build)
        elif command.name in _GIVES and command.arguments:
            to = targets.get(_plain(command.arguments[0].text, package))
            all_open |= command.arguments[0].open
            if to is not None:
                to.open |= not _add(to.given, _with_headers(command, targets), build)
                to.place = to.place if to.settled else _place(command.arguments[0], step)
                to.settled = True
        elif command.name not in _CHANGE_NO_HEADERS or _brings_headers(command.texts):
            for name in {*command.texts} & targets.keys():
                targets[name].open = True
    return [
        BuiltTarget(row.name, row.sources, row.place, frozenset(row.given | all_given), row.open or all_open)
        for row in targets.values()
    ]


def _with_headers(command: Command, targets: Mapping[str, _Target]) -> Sequence[Argument]:
    """What a command gives its target that may have folders of headers: a package of ROS is no target of its own name,
    so that ``target_link_libraries(talker rclcpp)`` names a file to link, and no more."""
    given = command.arguments[1:]
    if command.name != "target_link_libraries":
        return given
    of_ros = packages.table().names
    return [argument for argument in given if argument.text in targets or argument.text not in of_ros]


TYPE_SUPPORT = "<type support>"
"""Stands for what makes the headers of the package's own interfaces."""


def _make(targets: dict[str, _Target], step: Step, package: str) -> None:
    name, *rest = step.command.arguments
    texts = [argument.text for argument in rest]
    target = _Target(_plain(name.text, package), _place(name, step), open=step.conditional or name.text in targets)
    if texts[:1] == ["ALIAS"]:
        target.given = {_plain(text, package) for text in texts[1:]}
    else:
        target.sources = tuple(dict.fromkeys(step.path(t) for t in texts if "$" not in t and t.endswith(_SOURCES)))
        target.open |= "IMPORTED" in texts
    targets[target.name] = target


def _add(given: set[str], arguments: Iterable[Argument], build: _Build) -> bool:
    """Add the names in the arguments of a command; False where one of them may be any."""
    known = True
    for argument in arguments:
        text = argument.text
        if text in _KEYWORDS or _OWN_FOLDER.fullmatch(text) or text.startswith("//"):
            continue
        if any(text == f"${{{variable}}}" for variable in build.support) or _is_type_support(text, build.package):
            given |= {TYPE_SUPPORT, text}
        elif (variable := _OF_PACKAGE.fullmatch(text)) is not None and build.is_known(variable[1]):
            given.add(variable[1])
        elif "$" in text or _PREFIX_OF_ROS.search(text):
            known = False
        elif "/" not in text and not text.startswith("-"):
            given.add(_plain(text, build.package))
    return known


def _asked_for(steps: Iterable[Step]) -> set[str]:
    """The packages whose variables commands set."""
    commands = [step.command for step in steps if step.command.name in _ASKS and step.command.arguments]
    names = {_SUFFIX.sub("", command.texts[0]).lower() for command in commands}
    return names | {word.lower() for command in commands if command.name == "find_package" for word in command.texts}


def _gives_folders_to_all(step: Step) -> bool:
    """Whether a command gives all targets of a folder an option or a property that brings headers."""
    name, texts = step.command.name, step.command.texts
    first = texts[0] if texts else ""
    flags = name == "set" and first.startswith("CMAKE_CXX_FLAGS")
    of_folder = name == "set_property" and first == "DIRECTORY"
    return (name in _OPTIONS_OF_ALL or flags or of_folder) and _brings_headers(texts)


def _gets_type_support(step: Step) -> bool:
    return step.command.name == "rosidl_get_typesupport_target" and bool(step.command.arguments)


def _is_type_support(text: str, package: str) -> bool:
    return text == package or text.startswith(
        (f"{package}__rosidl", "rosidl_typesupport_cpp", f"{package}::{package}__")
    )


def _plain(text: str, package: str) -> str:
    """The package of ``package::target``; of the package itself, the target."""
    alias = _ALIAS.fullmatch(text)
    if alias is None:
        return text
    return text.rpartition("::")[2] if alias[1] == package else alias[1]


def _brings_headers(texts: Iterable[str]) -> bool:
    return any(word in text for text in texts for word in _INCLUDES)


def _place(argument: Argument, step: Step) -> Place:
    return Place(step.file, argument.line, argument.column, argument.line, argument.column + len(argument.text))


__all__ = ["TYPE_SUPPORT", "built_targets"]
