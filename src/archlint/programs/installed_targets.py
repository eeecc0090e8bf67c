"""The programs that CMake builds and that do not come to the folder in which ``ros2 run`` and launch look.

Source: ``install(TARGETS)`` of CMake puts programs into the folder of ``RUNTIME``, else into the one that is given for
all kinds, else into ``bin``.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from archlint.finding import Place
from archlint.programs.cmake_targets import TargetNames
from archlint.programs.install_folders import below_prefix
from archlint.workspace.cmake import Argument, Command
from archlint.workspace.cmake_run import Step
from archlint.workspace.installed import Astray, Installs

_KINDS = frozenset({"ARCHIVE", "LIBRARY", "RUNTIME", "OBJECTS", "FRAMEWORK", "BUNDLE", "PUBLIC_HEADER"}) | {
    *("PRIVATE_HEADER", "RESOURCE", "FILE_SET", "INCLUDES", "CXX_MODULES_BMI"),
}
"""Keywords that say of what the options behind them are."""
_MOVE = frozenset({"RUNTIME_OUTPUT_DIRECTORY", "CMAKE_RUNTIME_OUTPUT_DIRECTORY", "EXECUTABLE_OUTPUT_PATH"})
"""With these CMake itself builds programs in a folder that is named."""
_DEFAULT = "bin"


def programs_astray(installs: Installs, steps: Sequence[Step], targets: TargetNames) -> dict[str, Astray]:
    """Each such program by the name of its file; none where more may be installed than is read."""
    if installs.open_executables or installs.open_files or not _MOVE.isdisjoint(installs.words):
        return {}
    if any(step.command.name == "ament_auto_package" for step in steps):
        return {}  # which installs what ament_auto_add_executable() makes
    folders: dict[str, list[Astray]] = {}
    for step in steps:
        for name, astray in _installed(step):
            if name.open:
                return {}
            folders.setdefault(name.text, []).append(astray)
    rows: dict[str, Astray] = {}
    for target in _made(steps):
        where = folders.get(target.text, [])
        names = targets.of(target)
        if names is None or target.text in installs.mentioned or any(_may_be_seen(installs, row) for row in where):
            continue
        rows |= {name.text: where[0] if where else Astray("", None) for name in names}
    return rows


def _may_be_seen(installs: Installs, row: Astray) -> bool:
    return "$" in row.folder or row.folder == f"lib/{installs.package}"


def _made(steps: Iterable[Step]) -> Iterator[Argument]:
    """The targets of programs; one that only some builds make is left out, and so is one that stands for another."""
    for step in steps:
        command = step.command
        plain = command.name == "add_executable" and not {"ALIAS", "IMPORTED"} & {*command.texts}
        if plain and not step.conditional and command.arguments and not command.arguments[0].open:
            yield command.arguments[0]


def _installed(step: Step) -> Iterator[tuple[Argument, Astray]]:
    """The targets of an ``install(TARGETS …)``, each with the folder for programs."""
    command = step.command
    if command.name != "install" or command.texts[:1] != ["TARGETS"]:
        return
    folder = _folder_of_programs(command)
    for argument in command.arguments[1:]:
        if argument.text.isupper() and argument.text in _KINDS | {"EXPORT", "DESTINATION", "RUNTIME_DEPENDENCIES"}:
            return
        end = argument.column + len(argument.text)
        yield argument, Astray(folder, Place(step.file, argument.line, argument.column, argument.line, end))


def _folder_of_programs(command: Command) -> str:
    kind, folders = "", dict[str, str]()
    for word, following in zip(command.texts, [*command.texts[1:], ""], strict=True):
        if word in _KINDS:
            kind = word
        elif word == "DESTINATION":
            folders[kind] = following  # of several for one kind the last counts
    folder = folders.get("RUNTIME", folders.get("", _DEFAULT))
    return below_prefix(folder)


__all__ = ["programs_astray"]
