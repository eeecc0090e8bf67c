"""What a CMakeLists.txt comes to: its commands with variables replaced, loops unrolled, other files followed.

Nothing is configured: of an ``if`` every branch counts, but where it compares the value of a loop or a call.  A path of
the source tree is written ``//`` and the shown path, so that it means the same in each folder.
"""

from __future__ import annotations

import fnmatch
import posixpath
import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import field

from archlint.records import dataclass
from archlint.workspace.cmake import Argument, Command, parse_cmake
from archlint.workspace.cmake_branches import Branches
from archlint.workspace.cmake_values import changed_list, list_mode, numbers, parsed_arguments, path_component

SOURCE = "//"
"""How a path below a folder of the source tree begins."""

CMAKE_FILE = "CMakeLists.txt"

STEPS = 20_000
"""Commands that one package may come to."""
_DEPTH = 12
"""How deep calls, loops and included files may be nested."""
_VALUES = 2_000
"""Items of a list that are kept."""
_CHARACTERS = 20_000

_MODULE_PATH = "CMAKE_MODULE_PATH"
"""The variable that lists where ``include(Module)`` looks first."""

_WORD = re.compile(r"[\w.-]+")
_VARIABLE = re.compile(r"\$\{([\w.+/-]+)\}")
_BLOCKS = {"foreach": "endforeach", "while": "endwhile", "macro": "endmacro", "function": "endfunction"}
_BRANCHES = frozenset({"if", "else", "elseif", "endif"})
_NO_EFFECT = frozenset({*_BRANCHES, "return", "break", "continue", *_BLOCKS.values()})
_OUTPUT = frozenset(
    {"string", "math", "execute_process", "file", "list", "cmake_path", "separate_arguments", "aux_source_directory"}
    | {"get_filename_component", "get_property", "get_target_property", "get_directory_property"}
    | {"find_file", "find_library", "find_path", "find_program", "cmake_parse_arguments", "unset", "option"}
)
"""Commands that set a variable of which they are given the name."""
_SOURCES = ("c", "cc", "cpp", "cxx")
"""What ``aux_source_directory`` finds.  Source: ``CMAKE_C_SOURCE_FILE_EXTENSIONS`` and those of C++."""


@dataclass(frozen=True)
class Step:
    """A command that runs: in which ``file`` it stands, and the shown path of the ``folder`` that it works in."""

    command: Command
    file: str
    folder: str
    conditional: bool = False
    """Whether it is inside an ``if`` that may or may not hold."""
    of_tests: bool = False
    """Whether all that are around it are ``if(BUILD_TESTING)``, which holds unless somebody asks for no tests."""

    def path(self, text: str) -> str:
        """The shown path that an argument means."""
        inside = without_source(text)
        return posixpath.normpath(inside if inside != text else posixpath.join(self.folder, text))


def run_alone(text: str, package: str) -> CMakeRun:
    """The run of a package's CMakeLists.txt by itself: other files are not read, and no folder is listed."""
    run = CMakeRun(lambda path: text if path == CMAKE_FILE else None, lambda folder: ())
    run.run(CMAKE_FILE, ".", package)
    return run


def without_source(text: str) -> str:
    """An argument as a shown path where it is one of the source tree; any other as it is."""
    return text.removeprefix(SOURCE)


@dataclass
class _Scope:
    """The variables of a folder or function: lists of texts, None for what is set and not known."""

    variables: dict[str, list[str] | None]
    folder: str
    around: _Scope | None = None
    given: set[str] = field(default_factory=set)
    """The variables of loops and calls: no configuration gives these another value."""

    def inner(self, folder: str | None = None) -> _Scope:
        return _Scope(dict(self.variables), self.folder if folder is None else folder, self, set(self.given))


class CMakeRun:
    """The steps of a package's build.  ``read`` gives the text of a file, ``list_files`` the files below a folder, both
    by shown paths.  ``open`` is set where something of the build could not be read."""

    def __init__(self, read: Callable[[str], str | None], list_files: Callable[[str], Sequence[str]]) -> None:
        self._read = read
        self._list_files = list_files
        self._functions: dict[str, tuple[list[str], list[Command], str, bool]] = {}
        self._left = STEPS
        self._branches = Branches()
        self.steps: list[Step] = []
        self.files: list[str] = []
        """The files that were read."""
        self.words: set[str] = set()
        """Every word of these files, but for their comments."""
        self.open = False
        self.without_folder: list[Step] = []
        """The ``add_subdirectory`` of which no ``CMakeLists.txt`` can be read."""

    def run(self, file: str, folder: str, project: str | None = None) -> None:
        """Run the CMakeLists.txt of a package; ``project`` is its name until the file gives it one."""
        here = SOURCE + folder
        scope = _Scope({"CMAKE_SOURCE_DIR": [here], "PROJECT_SOURCE_DIR": [here], _MODULE_PATH: []}, folder)
        if project is not None:
            scope.variables["PROJECT_NAME"] = [project]
        self._file(file, scope, 0)

    def _file(self, path: str, scope: _Scope, depth: int) -> bool:
        """Run a file in a scope; False where it cannot be read."""
        text = self._read(path) if depth <= _DEPTH else None
        if text is None:
            self.open = True
            return False
        self.files.append(path)
        scope.variables["CMAKE_CURRENT_SOURCE_DIR"] = [SOURCE + scope.folder]
        scope.variables["CMAKE_CURRENT_LIST_DIR"] = [SOURCE + (posixpath.dirname(path) or ".")]
        commands = parse_cmake(text)
        for command in commands:
            self.words.update(word for part in (command.name, *command.texts) for word in _WORD.findall(part))
        self._block(commands, path, scope, depth)
        return True

    def _block(self, commands: Sequence[Command], file: str, scope: _Scope, depth: int) -> None:
        at = 0
        while at < len(commands):
            command = commands[at]
            end = _end(commands, at)
            if command.name in _BRANCHES:
                self._branches.enter(command, _expanded(command, scope), scope.variables, scope.given)
            self._left -= 1
            if self._left < 0 or depth > _DEPTH:
                self.open = True
                return
            if self._branches.left_out:
                pass
            elif command.name == "foreach":
                self._loop(command, commands[at + 1 : end], file, scope, depth)
            elif command.name in ("macro", "function"):
                self._define(command, commands[at + 1 : end], file)
            elif command.name != "while":
                self._interpret(command, file, scope, depth)
            at = end + 1

    # ----------------------------------------------------------------------------------------------- blocks

    def _loop(self, command: Command, body: Sequence[Command], file: str, scope: _Scope, depth: int) -> None:
        words = _expanded(command, scope)
        if not words or words[0].open:
            self.open = True
            return
        values = _loop_values(words, scope)
        for value in [None] if values is None else values:
            scope.variables[words[0].text] = None if value is None else [value]
            scope.given.add(words[0].text)
            self._block(body, file, scope, depth + 1)

    def _define(self, command: Command, body: Sequence[Command], file: str) -> None:
        if command.arguments:
            name, *parameters = command.texts
            self._functions[name.lower()] = (parameters, list(body), file, command.name == "function")

    def _call(self, command: Command, arguments: Sequence[Argument], scope: _Scope, depth: int) -> None:
        parameters, body, file, own_scope = self._functions[command.name]
        values = [argument.text for argument in arguments]
        known: dict[str, list[str] | None] = {n: [value] for n, value in zip(parameters, values, strict=False)}
        known |= {"ARGN": values[len(parameters) :], "ARGV": values, "ARGC": [str(len(values))]}
        known |= {f"ARGV{number}": [value] for number, value in enumerate(values)}
        inner = scope.inner() if own_scope else scope
        before, given = {name: scope.variables.get(name) for name in known}, set(scope.given)
        inner.variables.update(known)
        inner.given -= known.keys()
        # A variable that is passed on may have another value when somebody configures the build.
        if len(values) == len(command.texts):
            inner.given |= {n for n, text in zip(parameters, command.texts, strict=False) if "$" not in text}
        self._block(body, file, inner, depth + 1)
        if not own_scope:
            scope.variables.update(before)
            scope.given = given

    # --------------------------------------------------------------------------------------------- commands

    def _interpret(self, command: Command, file: str, scope: _Scope, depth: int) -> None:
        if command.name in _NO_EFFECT:
            return
        arguments = _expanded(command, scope)
        texts = [argument.text for argument in arguments]
        ran = Command(command.name, tuple(arguments), command.line, command.column)
        step = Step(ran, file, scope.folder, self._branches.conditional, self._branches.of_tests)
        if command.name in self._functions:
            self._call(command, arguments, scope, depth)
        elif command.name == "add_subdirectory" and texts:
            self._subdirectory(step, arguments[0], scope, depth)
        elif command.name == "include" and texts:
            self._include(step, arguments[0], scope, depth)
        else:
            self._assign(step, texts, scope)
            self.steps.append(step)

    def _subdirectory(self, step: Step, argument: Argument, scope: _Scope, depth: int) -> None:
        if argument.open:
            self.open = True
            return
        folder = step.path(argument.text)
        file = posixpath.normpath(posixpath.join(folder, CMAKE_FILE))
        if self._read(file) is None:
            self.without_folder.append(step)
        self._file(file, scope.inner(folder), depth + 1)

    def _include(self, step: Step, argument: Argument, scope: _Scope, depth: int) -> None:
        if argument.open:
            self.open = True
            return
        path: str | None = step.path(argument.text)
        if "/" not in argument.text and "." not in argument.text:
            path = self._module(step, argument.text, scope)
        if path is None:
            return  # a module of CMake's own: these install nothing
        here = scope.variables.get("CMAKE_CURRENT_LIST_DIR")
        self._file(path, scope, depth + 1)
        scope.variables["CMAKE_CURRENT_LIST_DIR"] = here

    def _module(self, step: Step, name: str, scope: _Scope) -> str | None:
        """The file of a module of the source tree, by the name that ``include`` has for it."""
        folders = scope.variables.get(_MODULE_PATH) or ()
        paths = (step.path(posixpath.join(folder, f"{name}.cmake")) for folder in folders)
        return next((path for path in paths if self._read(path) is not None), None)

    def _assign(self, step: Step, texts: list[str], scope: _Scope) -> None:
        """What a command does to variables."""
        name = step.command.name
        if name == "project" and texts:
            scope.variables["PROJECT_NAME"] = [texts[0]]
            scope.variables["PROJECT_SOURCE_DIR"] = [SOURCE + scope.folder]
            scope.variables.setdefault("CMAKE_PROJECT_NAME", [texts[0]])
        elif name == "set" and texts:
            _set_command(texts, scope, self._branches.conditional)
        elif name == "list" and len(texts) > 1 and (mode := list_mode(texts[0])) is not None:
            _set(scope, texts[1], changed_list(mode, scope.variables.get(texts[1], []), texts[2:]))
        elif name == "cmake_parse_arguments" and (own := parsed_arguments(texts, scope.variables.get("ARGV"))):
            for variable, value in own.items():
                is_sure = not self._branches.conditional or scope.variables.get(variable, value) == value
                _set(scope, variable, value if is_sure else None)
        elif name in _OUTPUT:
            result = self._result(step, texts, scope)
            if result is None:
                scope.variables.update({text: None for text in texts if text in scope.variables or text.isidentifier()})
            else:
                _set(scope, *result)

    def _result(self, step: Step, texts: list[str], scope: _Scope) -> tuple[str, list[str] | None] | None:
        """The variable that a command sets, and its new value where it is known; None where neither is."""
        name, mode = step.command.name, texts[0].upper() if texts else ""
        if name == "file" and mode in ("GLOB", "GLOB_RECURSE") and len(texts) > 2:
            return texts[1], self._glob(step, texts[2:], recursive=mode == "GLOB_RECURSE")
        if name == "aux_source_directory" and len(texts) == 2:  # adds to what the variable holds
            sources = self._glob(
                step, [posixpath.join(texts[0], f"*.{suffix}") for suffix in _SOURCES], recursive=False
            )
            before = scope.variables.get(texts[1], [])
            return texts[1], None if sources is None or before is None else [*before, *sources]
        if name == "get_filename_component" and len(texts) > 2:
            return texts[0], path_component(texts[1], texts[2])
        if name == "string" and mode == "REPLACE" and len(texts) > 4:
            return texts[3], [part.replace(texts[1], texts[2]) for part in texts[4:]]
        return None

    def _glob(self, step: Step, words: list[str], recursive: bool) -> list[str] | None:
        """The files that patterns find, as paths of the source tree."""
        patterns, relative = [], False
        skip = False
        for word in words:
            if skip or word in ("CONFIGURE_DEPENDS", "LIST_DIRECTORIES", "true", "false", "FOLLOW_SYMLINKS"):
                skip = False
            elif word == "RELATIVE":
                relative = skip = True
            else:
                patterns.append(word)
        if any("$" in pattern for pattern in patterns):
            return None
        matches = {path: None for pattern in patterns for path in self._matches(step.path(pattern), recursive)}
        # RELATIVE is, but for rare cases, to the folder itself, from which such a path is read again.
        shown = (posixpath.relpath(path, step.folder) if relative else SOURCE + path for path in sorted(matches))
        return list(shown)[:_VALUES]

    def _matches(self, pattern: str, recursive: bool) -> Iterable[str]:
        folder, name = posixpath.split(pattern)
        while any(mark in folder for mark in "*?["):
            folder = posixpath.dirname(folder)
        files = self._list_files(folder or ".")
        if recursive:
            return [path for path in files if fnmatch.fnmatchcase(posixpath.basename(path), name)]
        entries = {"/".join(path.split("/")[: pattern.count("/") + 1]) for path in files}
        return [entry for entry in entries if _matches_parts(entry.split("/"), pattern.split("/"))]


def _matches_parts(parts: list[str], patterns: list[str]) -> bool:
    return len(parts) == len(patterns) and all(map(fnmatch.fnmatchcase, parts, patterns))


def _end(commands: Sequence[Command], at: int) -> int:
    """The index of the command that ends the block which begins at ``at``; ``at`` itself where none does."""
    closing = _BLOCKS.get(commands[at].name)
    if closing is None:
        return at
    depth = 0
    for index in range(at, len(commands)):
        depth += {commands[at].name: 1, closing: -1}.get(commands[index].name, 0)
        if depth == 0:
            return index
    return len(commands)


# ------------------------------------------------------------------------------------------------ variables


_HAND_ON = frozenset({"rosidl_generate_interfaces", "ament_target_dependencies", "ament_export_dependencies"})
"""Functions of ament and rosidl that hand ``${ARGN}`` to another one: a quoted list becomes several arguments there."""


def _expanded(command: Command, scope: _Scope) -> list[Argument]:
    """The arguments with known variables replaced; a list that is not quoted becomes several.  A function that hands on
    ``${ARGN}`` makes several of a quoted one, too."""
    whole = command.name not in _HAND_ON
    arguments: list[Argument] = []
    for argument in command.arguments:
        text = argument.text
        for _ in range(3):  # ${${name}}
            if "${" not in text or len(text) > _CHARACTERS:
                break
            text = _VARIABLE.sub(lambda match: _value(match, scope), text)
        parts = [text] if argument.quoted and whole else [part for part in text.split(";") if part]
        arguments.extend(Argument(part, argument.line, argument.column, argument.quoted) for part in parts)
    return arguments[:10_000]


def _value(variable: re.Match[str], scope: _Scope) -> str:
    values = scope.variables.get(variable[1])
    return variable[0] if values is None else ";".join(values)


def _set(scope: _Scope, name: str, value: list[str] | None) -> None:
    scope.given.discard(name)
    small = value is not None and len(value) <= _VALUES and sum(map(len, value)) <= _CHARACTERS
    scope.variables[name] = value if small else None


def _set_command(texts: Sequence[str], scope: _Scope, maybe: bool) -> None:
    name, *values = texts
    target: _Scope | None = scope
    if "PARENT_SCOPE" in values:
        target = scope.around
        values = values[: values.index("PARENT_SCOPE")]
    if "CACHE" in values:
        values = values[: values.index("CACHE")]
    if target is not None:
        parts = [part for value in values for part in value.split(";") if part]
        old = target.variables.get(name, parts)
        unknown = any("$" in part for part in parts) or (maybe and old != parts)
        _set(target, name, None if unknown else parts)


def _loop_values(words: Sequence[Argument], scope: _Scope) -> list[str] | None:
    """What a ``foreach`` goes through; None where that is not known."""
    texts = [word.text for word in words[1:]]
    if any("$" in text for text in texts) or "ZIP_LISTS" in texts:
        return None
    if texts[:1] == ["RANGE"]:
        return numbers(texts[1:], _VALUES)
    if texts[:1] != ["IN"]:
        return texts
    items: list[str] = []
    of_lists = False
    for text in texts[1:]:
        if text in ("LISTS", "ITEMS"):
            of_lists = text == "LISTS"
        elif not of_lists:
            items.append(text)
        else:
            values = scope.variables.get(text)
            if values is None:
                return None
            items.extend(values)
    return items
