"""The targets and packages that CMake commands name and that no command before has made or found.

Source: ``ament_target_dependencies`` of ament_cmake_target_dependencies stops at a target that there is not, and at a
package that no ``find_package`` has found; so does CMake at ``install(TARGETS)``, ``target_link_libraries`` and their
like without their target.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence

from archlint.finding import Place
from archlint.programs.built_targets import built_targets
from archlint.suggestions import nearest
from archlint.workspace.cmake import Argument, Command
from archlint.workspace.cmake_run import Step
from archlint.workspace.installed import Installs, NameInCMake

_MAKES = ("add_executable", "add_library", "add_custom_target", "add_module", "ament_add_", "rosidl_generate")
"""What the name of a command has in it that makes a target of its first argument."""
_OF_A_TARGET = frozenset({"ament_target_dependencies", "target_link_libraries", "target_include_directories"}) | {
    *("target_compile_features", "target_compile_options", "target_compile_definitions", "target_sources"),
    "rclcpp_components_register_node",
}
"""Commands whose first argument must be a target."""
_OF_PACKAGES = {"ament_target_dependencies": 1, "ament_export_dependencies": 0}
"""Commands that are given packages, from which argument on."""
_GENERATES = "rosidl_generate_interfaces"
_KEYWORDS = frozenset({"PUBLIC", "PRIVATE", "INTERFACE", "SYSTEM"})
_FINDS = frozenset({"find_package", "pkg_check_modules", "pkg_search_module", "find_library", "find_path"})
_UNREAD = frozenset({"while", "return", "cpmaddpackage", "catkin", "externalproject_add", "fetchcontent_declare"}) | {
    *("fetchcontent_makeavailable", "fetchcontent_populate"),
}
"""Words of files in which more may be made, or less may run, than is seen."""


def read_names(installs: Installs, steps: Sequence[Step]) -> None:
    """Add such names, in the commands that always run or run for tests, where all of the build is read."""
    is_open = any(_is_open(step) or may_make_anything(step.command) for step in steps)
    if is_open or not _UNREAD.isdisjoint(installs.words):
        return
    installs.targets = frozenset(_made(steps))
    installs.looked_for = frozenset(step.command.texts[0] for step in steps if _finds(step))
    installs.built = built_targets(steps, installs.package)
    there = installs.targets | installs.mentioned
    always = [step for step in steps if step.of_tests or not step.conditional]
    named = [name for step in always for name in (*_of_targets(step), *_own_library(step, installs.package))]
    installs.names_of_nothing += [name for name in named if name.name not in there]
    if any(may_find(step.command) for step in steps):
        return
    installs.names_of_nothing += [
        name
        for step in always
        for name in _of_packages(step)
        if name.name not in installs.looked_for and f"{name.name}_FOUND" not in installs.words
    ]


_VARIABLE = re.compile(r"\$\{(\w+)\}")
_WITHOUT_SIGN = re.compile(r"(?<!\$)\{PROJECT_NAME\}|\$PROJECT_NAME\b")
_OF_PROJECT = "PROJECT_NAME"
_OF_CATKIN = "CATKIN_"
_LIKE_ITS_NAME = frozenset({"package", "package_name", "pkg", "pkg_name", "packagename", "pkgname"})
"""What people take for the variable of the package's name."""


def misspelt_variables(steps: Sequence[Step]) -> Iterator[NameInCMake]:
    """The variables without a value whose names are almost ``PROJECT_NAME``, where they always matter.  A variable that
    some command is given by its bare name may have a value: ``set(PROJECTNAME robot)``."""
    bare = {text for step in steps for text in step.command.texts}
    if "catkin" in bare:
        return
    for step in steps:
        for argument in () if step.conditional and not step.of_tests else step.command.arguments:
            for name in _VARIABLE.findall(argument.text):
                if name not in bare and (_is_nearly_of_project(name) or _means_a_folder(name, argument, step)):
                    yield NameInCMake(name, step.command.name, _place(argument, step))
            if step.command.name == "install" and _WITHOUT_SIGN.search(argument.text):
                yield NameInCMake(argument.text, step.command.name, _place(argument, step))


def _is_nearly_of_project(name: str) -> bool:
    """Whether a name is ``PROJECT_NAME`` with a slip or two, or the beginning of it."""
    begins = name != _OF_PROJECT and _OF_PROJECT.startswith(name.upper()) and len(name) > len("PROJECT_")
    return begins or nearest(name, [_OF_PROJECT]) is not None


def _means_a_folder(name: str, argument: Argument, step: Step) -> bool:
    """Whether a variable that nothing sets is a folder to install into: one of catkin, or the name of the package."""
    if step.command.name != "install" or not (name.startswith(_OF_CATKIN) or name.lower() in _LIKE_ITS_NAME):
        return False
    pairs = zip(step.command.arguments, step.command.arguments[1:], strict=False)
    return any(before.text == "DESTINATION" and after is argument for before, after in pairs)


_AMENT_PACKAGES = frozenset({"ament_package", "ament_package_xml", "ament_auto_package"})


def misnamed_project(installs: Installs, steps: Sequence[Step]) -> Iterator[NameInCMake]:
    """The name of a project that is not that of its package: ``ament_package()`` stops there.

    Source: ``ament_package_xml`` of ament_cmake_core.
    """
    named: Step | None = None
    for step in steps:
        if step.conditional or step.folder != installs.folder:
            continue
        if step.command.name == "project" and step.command.arguments:
            named = step
        elif step.command.name in _AMENT_PACKAGES:
            name = None if named is None else named.command.arguments[0]
            if named is not None and name is not None and not name.open and name.text != installs.package:
                yield NameInCMake(name.text, "project", _place(name, named))
            return


def _of_targets(step: Step) -> Iterator[NameInCMake]:
    for argument in _targets_of(step.command):
        if not argument.open and "::" not in argument.text:
            yield NameInCMake(argument.text, step.command.name, _place(argument, step))


def _own_library(step: Step, package: str) -> Iterator[NameInCMake]:
    """What a target is linked with by the name of its own package: no library of the system is called so."""
    linked = step.command.arguments[1:] if step.command.name == "target_link_libraries" else ()
    for argument in linked:
        if argument.text == package:
            yield NameInCMake(argument.text, step.command.name, _place(argument, step))


def _of_packages(step: Step) -> Iterator[NameInCMake]:
    if step.command.name == _GENERATES:
        for argument in _dependencies(step.command):
            if not argument.open:
                yield NameInCMake(argument.text, _GENERATES, _place(argument, step), package=True)
    if step.command.name in _OF_PACKAGES:
        first = _OF_PACKAGES[step.command.name]
        target = step.command.texts[0] if first and step.command.texts else ""
        for argument in step.command.arguments[first:]:
            if not argument.open and argument.text not in _KEYWORDS:
                yield NameInCMake(argument.text, step.command.name, _place(argument, step), package=True, target=target)


def _dependencies(command: Command) -> Sequence[Argument]:
    """The packages whose interfaces ``rosidl_generate_interfaces`` is told to use."""
    texts = command.texts
    if "DEPENDENCIES" not in texts:
        return ()
    first = texts.index("DEPENDENCIES") + 1
    last = next((at for at in range(first, len(texts)) if texts[at].isupper()), len(texts))
    return command.arguments[first:last]


def _finds(step: Step) -> bool:
    return step.command.name in _FINDS and bool(step.command.arguments)


def _is_open(step: Step) -> bool:
    """Whether a command finds packages of which nobody knows the names, or makes targets of such names."""
    command = step.command
    if "ament_auto_find" in command.name:
        return True
    names = command.name in _FINDS or any(word in command.name for word in _MAKES)
    return names and bool(command.arguments) and command.arguments[0].open


def _made(steps: Iterable[Step]) -> Iterator[str]:
    """The targets that commands make, and whatever else of that name there may be."""
    for step in steps:
        command, texts = step.command, step.command.texts
        if texts and any(word in command.name for word in _MAKES):
            yield texts[0]
        for word in ("EXECUTABLE", "TARGET", "NAME"):
            if word in texts[:-1] and command.name not in _OF_A_TARGET:
                yield texts[texts.index(word) + 1]


_FINDS_NOTHING = re.compile(
    r"(?:add|ament|set|get|target|link|include|list|file|find|rosidl|rclcpp|pluginlib|cmake|configure|install|enable|mark)_?"
    r"[a-z_]*|project|message|option|string|math|unset|if|pkg_check_modules|execute_process|separate_arguments|source_group"
    r"|generate_parameter_library|pybind11_add_module|python_add_library|export|define_property|file|qt5_.*|qt6_.*"
)
"""Commands that find no package but by their own arguments."""


def may_find(command: Command) -> bool:
    return _FINDS_NOTHING.fullmatch(command.name) is None


def may_make_anything(command: Command) -> bool:
    """Whether a command that is not known here is given nothing: ``acme_auto_package()`` makes targets of names that it
    works out, and finds packages."""
    return not command.arguments and may_find(command)


def _targets_of(command: Command) -> Sequence[Argument]:
    """The arguments of a command that must be targets."""
    if command.name in _OF_A_TARGET:
        return command.arguments[:1]
    texts = command.texts
    if command.name != "install" or texts[:1] != ["TARGETS"]:
        return ()
    end = next((at for at, text in enumerate(texts) if at and text.isupper() and text in _AFTER_TARGETS), len(texts))
    return [argument for argument in command.arguments[1:end] if argument.text != "TARGETS"]


_AFTER_TARGETS = frozenset(
    {"EXPORT", "RUNTIME_DEPENDENCIES", "RUNTIME_DEPENDENCY_SET", "ARCHIVE", "LIBRARY", "RUNTIME", "OBJECTS"}
    | {"FRAMEWORK", "BUNDLE", "PRIVATE_HEADER", "PUBLIC_HEADER", "RESOURCE", "FILE_SET", "CXX_MODULES_BMI"}
    | {"DESTINATION", "OPTIONAL", "PERMISSIONS", "CONFIGURATIONS", "COMPONENT", "NAMELINK_COMPONENT"}
    | {"NAMELINK_ONLY", "NAMELINK_SKIP", "INCLUDES", "EXCLUDE_FROM_ALL"}
)


def _place(argument: Argument, step: Step) -> Place:
    return Place(step.file, argument.line, argument.column, argument.line, argument.column + len(argument.text))


__all__ = ["may_find", "may_make_anything", "misnamed_project", "misspelt_variables", "read_names"]
