"""What the JSON of a graph says of definitions: the interfaces of the workspace, and the arguments of a launch file."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import PurePath
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from archlint.launch.model import DeclaredArgument
    from archlint.syntax.interfaces import FieldType, Interface
    from archlint.systems.model import System


def interfaces(system: System) -> list[dict[str, Any]]:
    """The interfaces that the workspace defines, with their fields and constants."""
    table = None if system.workspace is None else system.workspace.interfaces
    rows: list[dict[str, Any]] = []
    if table is None:
        return rows
    for name in table.names():
        file, interface = table.file(name), table.get(name)
        if file is not None and interface is not None:
            rows.append({"name": name, "file": PurePath(file.relative).as_posix(), **_definition(name, interface)})
    return rows


def _definition(name: str, interface: Interface) -> dict[str, Any]:
    package = name.partition("/")[0]
    return {
        "fields": [
            {
                "section": section.name,
                "name": field.name,
                "type": type_words(field.type, package),
                "default": field.default,
                "line": field.line,
            }
            for section in interface.sections
            for field in section.fields
        ],
        "constants": [
            {
                "section": section.name,
                "name": constant.name,
                "type": constant.type,
                "value": constant.value,
                "line": constant.line,
            }
            for section in interface.sections
            for constant in section.constants
        ],
    }


def type_words(type: FieldType, package: str) -> str:
    """The type of a field of an interface of a package, as an interface file has it, with a full name."""
    bound = "" if type.string_bound is None else f"<={type.string_bound}"
    size = "" if type.size is None else str(type.size)
    array = {"": "", "fixed": f"[{size}]", "bounded": f"[<={size}]", "unbounded": "[]"}[type.array]
    return f"{type.qualified(package)}{bound}{array}"


def launch_arguments(system: System) -> list[dict[str, Any]]:
    """The arguments that the launch file of a system declares, those of the files that it includes among them."""
    declared = system.launched.declared if system.launched is not None else ()
    first: dict[str, DeclaredArgument] = {}
    for argument in declared:
        if not argument.dormant:
            first.setdefault(argument.name, argument)
    return list(_arguments(first))


def _arguments(declared: dict[str, DeclaredArgument]) -> Iterator[dict[str, Any]]:
    for name, argument in sorted(declared.items()):
        yield {
            "name": name,
            "required": argument.default is None,
            "default": None if argument.default is None else argument.default.text,
            "choices": list(argument.choices),
            "file": PurePath(argument.file).as_posix(),
            "line": argument.place.line,
        }


__all__ = ["interfaces", "launch_arguments", "type_words"]
