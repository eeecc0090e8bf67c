"""What a package installs where: executables, and the files under ``share``."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator, Sequence
from typing import Protocol

from archlint.finding import Place
from archlint.programs.asking_commands import only_asks
from archlint.programs.cmake_commands import misspelt_commands, unbrought_at, unregistered_at
from archlint.programs.cmake_names import may_make_anything, misnamed_project, misspelt_variables, read_names
from archlint.programs.cmake_targets import TargetNames
from archlint.programs.install_folders import below_prefix, may_be_of_programs
from archlint.programs.installed_targets import programs_astray
from archlint.programs.left_libraries import left_libraries
from archlint.programs.refused_commands import called_commands, refused_commands
from archlint.syntax.entry_point_tables import ScriptEntry, entries_of_setup_cfg
from archlint.workspace.cmake import Argument, Command
from archlint.workspace.cmake_run import CMakeRun, Step, without_source
from archlint.workspace.installed import Executable, FoundPackage, InstalledFiles, Installs, NeededSource


class CMakeTree(Protocol):
    """The files of the workspace by shown paths."""

    def text(self, path: str) -> str | None: ...

    def is_file(self, path: str) -> bool: ...

    def files_below(self, folder: str) -> Sequence[str]: ...


# --------------------------------------------------------------------------------------------------- CMake

_KEYWORDS = frozenset(
    [
        "PROGRAMS",
        "FILES",
        "DIRECTORY",
        "TARGETS",
        "DESTINATION",
        "RENAME",
        "PERMISSIONS",
        "CONFIGURATIONS",
        "COMPONENT",
        "OPTIONAL",
        "PATTERN",
        "REGEX",
        "EXCLUDE",
        "USE_SOURCE_PERMISSIONS",
        "FILE_PERMISSIONS",
        "DIRECTORY_PERMISSIONS",
        "FILES_MATCHING",
        "EXPORT",
        "ARCHIVE",
        "LIBRARY",
        "RUNTIME",
        "INCLUDES",
        "TYPE",
        "EXCLUDE_FROM_ALL",
        "MESSAGE_NEVER",
        "CODE",
        "SCRIPT",
    ]
)
_NAMES_NO_EXECUTABLE = frozenset(
    {"project", "find_package", "cmake_minimum_required", "set", "list", "file", "message", "add_library", "install"}
    | {"get_filename_component", "string", "option", "if", "add_compile_options", "add_definitions", "unset"}
    | {"include_directories", "link_directories", "link_libraries", "pkg_check_modules"}
    | {"ament_package", "ament_target_dependencies", "ament_python_install_package", "ament_auto_package"}
    | {"rosidl_generate_interfaces", "rosidl_target_interfaces", "rosidl_get_typesupport_target"}
)
"""Commands whose words are names of other things."""
_PREFIXES = ("target_", "set_", "ament_export_", "ament_add_", "ament_lint_", "catkin_add_", "_")


_GENERATES = "rosidl_generate_interfaces"


def read_cmake(installs: Installs, path: str, tree: CMakeTree) -> None:
    """Add what a CMakeLists.txt, and what it includes, installs."""
    run = CMakeRun(tree.text, tree.files_below)
    run.run(path, installs.folder)
    installs.build_files.extend(run.files)
    installs.words |= run.words
    installs.open_executables |= run.open
    installs.open_files |= run.open
    targets = TargetNames(run.steps)
    makers = _MAKERS & installs.words
    makes_sources = bool(makers) and not (makers == {"execute_process"} and only_asks(run.steps, installs.words))
    for step in run.steps:
        _read_step(installs, step, tree, targets)
        installs.required += [] if "return" in installs.words else _found(step)
        always = step.of_tests or not step.conditional
        installs.needed += _needed(step) if always and not makes_sources else []
    installs.needed += [] if makes_sources else [row for step in run.without_folder for row in _folder_needed(step)]
    if not installs.executables and any(may_make_anything(step.command) for step in run.steps):
        installs.open_executables = True
    if not run.open:
        installs.astray = programs_astray(installs, run.steps, targets)
        read_names(installs, run.steps)
        installs.called += called_commands(run.steps) if installs.looked_for else []
        installs.left_libraries += [] if installs.open_files else left_libraries(run.steps, installs.words)
        installs.unset_variables += misspelt_variables(run.steps)
    installs.refused += refused_commands(run.steps, None if makes_sources else tree)
    installs.misspelt += misspelt_commands(run.steps, installs.words)
    installs.unregistered_at = None if run.open else unregistered_at(installs, run.steps)
    installs.unbrought_at = None if run.open else unbrought_at(installs, run.steps)
    installs.names_of_nothing += misnamed_project(installs, run.steps)
    installs.generates_nothing = not run.open and not installs.mentioned and _GENERATES not in installs.words


def _read_step(installs: Installs, step: Step, tree: CMakeTree, targets: TargetNames) -> None:
    command, arguments, texts = step.command, step.command.arguments, step.command.texts
    built = "add_executable" in command.name or "add_library" in command.name
    sources = _sources(step, tree, auto="ament_auto_" in command.name) if built else ()
    if not step.conditional:
        installs.sources |= frozenset(sources)
    if _puts_files_there_itself(installs, step):
        installs.open_executables = installs.open_files = True
    elif command.name in ("install", "catkin_install_python"):
        _install(installs, step, tree)
    elif "add_executable" in command.name and arguments:
        _target(installs, arguments[0], step.file, targets, sources)
    elif command.name == "ament_auto_package":
        at = texts.index("INSTALL_TO_SHARE") if "INSTALL_TO_SHARE" in texts else len(texts)
        for name in texts[at + 1 :]:
            installs.files.append(InstalledFiles(step.path(name), f"share/{installs.package}", folder=True))
    elif command.name == _GENERATES:
        known = not any(argument.open for argument in arguments)
        installs.generated = frozenset(texts) if known and installs.generated_at is None else None
        named = next((a for a in arguments if a.text == "DEPENDENCIES"), arguments[0] if arguments else None)
        installs.generated_at = None if named is None or step.conditional else _place(named, step.file)
    elif command.name == "ament_python_install_package":
        _console_scripts(installs, step, tree)
    elif command.name not in _NAMES_NO_EXECUTABLE and not command.name.startswith(_PREFIXES):
        installs.mentioned |= frozenset(texts)
    if "EXECUTABLE" in texts[:-1]:
        plugin = texts[texts.index("PLUGIN") + 1] if "PLUGIN" in texts[:-1] else ""
        _target(installs, arguments[texts.index("EXECUTABLE") + 1], step.file, targets, plugin=plugin)


_RUN_SOMETHING = frozenset({"execute_process", "exec_program", "add_custom_command", "add_custom_target"})
_PREFIX = "CMAKE_INSTALL_PREFIX"


def _puts_files_there_itself(installs: Installs, step: Step) -> bool:
    """Whether a command may write below the install prefix by other means than a list of files: what it puts there
    nobody can say.  The prefix may come in a variable that another command has set."""
    command = step.command
    if command.name == "install":
        return not {"CODE", "SCRIPT"}.isdisjoint(_groups(command))
    unknown = any(argument.open for argument in command.arguments)
    return unknown and _PREFIX in installs.words and _writes(command)


def _writes(command: Command) -> bool:
    """Whether a command may write files: what runs something, and a ``file(…)`` that does more than read."""
    of_files = command.name == "file" and command.texts[0].upper() not in _READS
    return of_files or command.name in _RUN_SOMETHING


_READS = frozenset({"GLOB", "GLOB_RECURSE", "READ", "STRINGS", "RELATIVE_PATH", "TO_CMAKE_PATH", "TO_NATIVE_PATH"})


_MAKERS = _RUN_SOMETHING | frozenset(
    {"MAKE_DIRECTORY", "make_directory", "configure_file", "GENERATE", "COPY", "DOWNLOAD"}
    | {"externalproject_add", "fetchcontent_declare", "fetchcontent_makeavailable"}
)
"""With one of these the CMake files may make something themselves that they then install."""


_TAKE_SOURCES = frozenset({"add_executable", "add_library", "ament_add_gtest", "ament_add_gmock"})
_EXPORTS_PLUGINS = "pluginlib_export_plugin_description_file"
_CODE = (".cpp", ".cc", ".cxx", ".c")


def _needed(step: Step) -> Iterator[NeededSource]:
    """What a command stops at where it is not there.  Source: ``file(INSTALL)`` of CMake cannot find it, no more than
    ``add_executable`` a source, but passes over a folder with ``FILES_MATCHING``; ``rosidl_generate_interfaces`` asks
    for each file with an extension, and ``ament_add_pytest_test`` for its own."""
    rows: list[tuple[Argument, bool]] = []
    groups = _groups(step.command) if step.command.name == "install" else {}
    if "OPTIONAL" not in groups:
        kinds = ("FILES", "PROGRAMS", *(() if "FILES_MATCHING" in groups else ("DIRECTORY",)))
        rows = [(a, kind == "DIRECTORY") for kind in kinds for a in groups.get(kind, [])]
    if step.command.name in _TAKE_SOURCES:
        rows = [(a, False) for a in step.command.arguments[1:] if a.text.endswith(_CODE)]
    if step.command.name == "ament_add_pytest_test":
        rows = [(a, False) for a in step.command.arguments[1:2] if a.text.endswith(".py")]
    if step.command.name == _GENERATES:
        rows = [(a, False) for a in _interface_files(step.command)]
    if step.command.name == _EXPORTS_PLUGINS:
        rows = [(a, False) for a in step.command.arguments[1:2] if a.text.endswith(".xml")]
    for argument, folder in rows:
        if not re.search(r"[$<>:]", argument.text) and not posixpath.isabs(without_source(argument.text)):
            place = _place(argument, step.file)
            yield NeededSource(
                step.path(argument.text), step.command.name, place, folder, step.of_tests, line=step.command.line
            )


_WITH_A_FOLDER = re.compile(r"(?:.*/)?(?:msg|srv|action|idl)/[\w.,-]+|,")


def _interface_files(command: Command) -> Iterator[Argument]:
    """The files that interfaces are generated from; a word of something else, such as a package among them, is left
    out."""
    for argument in command.arguments[1:]:
        if argument.text in ("DEPENDENCIES", "LIBRARY_NAME"):
            return
        if argument.text.endswith((".msg", ".srv", ".action")) or _WITH_A_FOLDER.fullmatch(argument.text):
            yield argument


def _folder_needed(step: Step) -> Iterator[NeededSource]:
    """The CMake file without which the build stops at an ``add_subdirectory`` that always runs."""
    argument = step.command.arguments[0]
    always = step.of_tests or not step.conditional
    if always and not posixpath.isabs(without_source(argument.text)):
        file = posixpath.join(step.path(argument.text), "CMakeLists.txt")
        yield NeededSource(file, step.command.name, _place(argument, step.file), of_tests=step.of_tests, part=True)


def _found(step: Step) -> Iterator[FoundPackage]:
    """The package that the build stops without at a command."""
    required = step.command.name == "find_package" and "REQUIRED" in step.command.texts[1:]
    if required and (step.of_tests or not step.conditional):
        [name, *_] = step.command.arguments
        if not name.open:
            yield FoundPackage(name.text, _place(name, step.file), step.of_tests)


def _console_scripts(installs: Installs, step: Step, tree: CMakeTree) -> None:
    """``ament_python_install_package(… SCRIPTS_DESTINATION …)`` installs what a setup.cfg beside the Python package
    names; that of the ROS package is read anyway."""
    texts = step.command.texts
    if "SCRIPTS_DESTINATION" not in texts:
        return
    folder = texts[texts.index("PACKAGE_DIR") + 1] if "PACKAGE_DIR" in texts[:-1] else texts[0]
    table = texts[texts.index("SETUP_CFG") + 1] if "SETUP_CFG" in texts[:-1] else f"{folder}/../setup.cfg"
    path = step.path(table)
    text = None if "$" in table else tree.text(path)
    if text is None:
        installs.open_executables = True
    elif path != posixpath.normpath(posixpath.join(installs.folder, "setup.cfg")):
        installs.build_files.append(path)
        for entry in entries_of_setup_cfg(text):
            installs.add(console_script(entry, installs.package, path))


def console_script(entry: ScriptEntry, package: str, path: str) -> Executable:
    """The executable that an entry of a table stands for."""
    place = Place(path, entry.line, entry.column, entry.line, entry.end_column)
    return Executable(entry.name, package, place, entry.module, entry.function, wrong=entry.wrong)


def _sources(step: Step, tree: CMakeTree, auto: bool) -> tuple[str, ...]:
    """The C++ sources that an executable is built of, as shown paths."""
    texts = [text for text in step.command.texts[1:] if "$" not in text]
    paths = [step.path(text) for text in texts if text.endswith((".cpp", ".cc", ".cxx"))]
    if auto and "DIRECTORY" in texts[:-1]:
        folder = step.path(texts[texts.index("DIRECTORY") + 1])
        paths += [path for path in tree.files_below(folder) if posixpath.dirname(path) == folder]
    return tuple(dict.fromkeys(paths))


def _target(
    installs: Installs,
    argument: Argument,
    path: str,
    targets: TargetNames,
    sources: tuple[str, ...] = (),
    plugin: str = "",
) -> None:
    names = None if argument.open else targets.of(argument)
    if names is None:
        installs.open_executables = True
        return
    for name in names:
        place = _place(argument, path)
        installs.add(Executable(name.text, installs.package, place, sources=sources, plugin=plugin))


def _place(argument: Argument, path: str) -> Place:
    end = argument.column + len(argument.text) + (2 if argument.quoted else 0)
    return Place(path, argument.line, argument.column, argument.line, end)


def _install(installs: Installs, step: Step, tree: CMakeTree) -> None:
    groups = _groups(step.command)
    where = groups.get("DESTINATION") or []
    destination = below_prefix(where[0].text) if where else None
    if not {"TARGETS", "EXPORT"}.isdisjoint(groups):
        return
    if destination is None or "$" in destination:
        installs.open_executables |= may_be_of_programs(destination, installs.package)
        installs.open_files = True
        return
    programs = destination in (f"lib/{installs.package}", "${CATKIN_PACKAGE_BIN_DESTINATION}")
    own = next((argument.text for argument in groups.get("RENAME", [])), None)
    for kind in ("PROGRAMS", "FILES", "DIRECTORY"):
        for argument in groups.get(kind, []):
            if "$" in argument.text:
                installs.open_executables |= programs
                installs.open_files |= not programs
                continue
            shown = step.path(argument.text)
            contents = kind == "DIRECTORY" and (argument.text.endswith("/") or shown == installs.folder)
            row = InstalledFiles(shown, destination, kind == "DIRECTORY", contents, own)
            if not programs or kind == "DIRECTORY":
                installs.files.append(row)
            if programs and kind == "DIRECTORY":
                _programs_of_folder(installs, row, _place(argument, step.file), tree)
            elif programs:
                name = own or posixpath.basename(shown)
                installs.add(Executable(name, installs.package, _place(argument, step.file), script=shown))


def _programs_of_folder(installs: Installs, row: InstalledFiles, place: Place, tree: CMakeTree) -> None:
    """``install(DIRECTORY … DESTINATION lib/<package>)``: launch finds what comes to that very folder."""
    for script in tree.files_below(row.source):
        name = posixpath.basename(script)
        inside = posixpath.relpath(script, row.source)
        if row.contents and inside == name:
            installs.add(Executable(name, installs.package, place, script=script))
        else:
            top = row.destination if row.contents else posixpath.join(row.destination, posixpath.basename(row.source))
            installs.too_deep.setdefault(name, posixpath.normpath(posixpath.join(top, posixpath.dirname(inside))))


def _groups(command: Command) -> dict[str, list[Argument]]:
    """The arguments of ``install`` by the keyword that they follow."""
    groups: dict[str, list[Argument]] = {}
    current = ""
    for argument in command.arguments:
        if argument.text in _KEYWORDS and not argument.quoted:
            current = argument.text
            groups.setdefault(current, [])
        else:
            groups.setdefault(current, []).append(argument)
    return groups
