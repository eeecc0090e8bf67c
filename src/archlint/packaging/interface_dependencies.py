"""What the interface files of a package use of other packages, held against its CMakeLists.txt and its package.xml.

Source: ``rosidl_generate_interfaces`` of rosidl_cmake hands its ``DEPENDENCIES``, and what these depend on, to the
generators, which find no other package's types; without the group of interface packages it stops (``FATAL_ERROR``).
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from archlint.place import Place
from archlint.records import dataclass
from archlint.ros import packages, standard_interfaces
from archlint.ros.interfaces import parts_of_type
from archlint.syntax.interface_values import PRIMITIVE_TYPES
from archlint.syntax.interfaces import FieldType
from archlint.workspace.closure import closure

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.model import Package

_PACKAGE_NAME = re.compile(r"[a-z][a-z0-9_]*")
_ALWAYS = frozenset({"builtin_interfaces"})
"""What old files may use without saying so: ``time`` and ``duration``."""


@dataclass(frozen=True)
class TypeUse:
    """A field whose type is of another package."""

    package: Package
    needed: str
    type: str
    place: Place


@dataclass(frozen=True)
class NotHanded:
    """A package whose types are used, and that ``rosidl_generate_interfaces`` does not get; ``uses`` are the first
    places in each file."""

    package: Package
    needed: str
    command: Place
    uses: tuple[TypeUse, ...]


@dataclass(frozen=True)
class UndefinedType:
    """A type of message that its package does not define, with the fields that have it."""

    package: str
    """The one whose interfaces use it."""
    owner: str
    """The one that would have to define it."""
    name: str
    meant: str
    """The type that was probably meant, as a field has it; empty where that is not known."""
    places: tuple[Place, ...]


def types_of_others(workspace: WorkspaceIndex) -> Iterator[TypeUse]:
    """Every field of the interfaces that are generated, if its type is of another package."""
    for package, type, place in _types(workspace):
        needed = "" if type.is_primitive else type.name.rpartition("/msg/")[0]
        if needed and needed not in (package.name, *_ALWAYS):
            yield TypeUse(package, needed, type.name, place)


def undefined_types(workspace: WorkspaceIndex) -> Iterator[UndefinedType]:
    """Every type of a field that the package which it is of certainly does not define."""
    table = workspace.interfaces
    rows: dict[tuple[str, str], list[Place]] = {}
    for package, type, place in _types(workspace):
        if not type.is_primitive:
            rows.setdefault((package.name, type.qualified(package.name)), []).append(place)
    for (user, full), places in rows.items():
        owner, kind, name = parts_of_type(full)
        if table is not None and table.defines(owner, kind, name) is False:
            yield UndefinedType(user, owner, name, _meant(name) if owner == user else "", tuple(places))


def _meant(name: str) -> str:
    """What is there for a bare name that its own package does not define: ``int16`` for ``Int16``, and for ``Header``
    the one standard message of that name."""
    if name.lower() in PRIMITIVE_TYPES:
        return name.lower()
    owners = [
        full.partition("/")[0] for full in standard_interfaces.table().interfaces if full.endswith(f"/msg/{name}")
    ]
    return f"{owners[0]}/{name}" if len(owners) == 1 else ""


def _types(workspace: WorkspaceIndex) -> Iterator[tuple[Package, FieldType, Place]]:
    """The type of every field of the interfaces that are generated, and where it is."""
    table = workspace.interfaces
    if table is None:
        return
    for name in table.names():
        own, kind, _ = parts_of_type(name)
        package, interface, file = workspace.packages.get(own), table.get(name), table.file(name)
        installs = workspace.installs.get(own)
        if package is None or interface is None or file is None or installs is None or installs.generated is None:
            continue
        if not file.relative.startswith(f"{package.relative}/") and package.relative != ".":
            continue  # another package of that name
        if not any(f"{kind}/{file.relative.rpartition('/')[2]}" in word for word in installs.generated):
            continue
        for field in (field for section in interface.sections for field in section.fields):
            yield package, field.type, Place(file.relative, field.line, 1, field.line, 1)


def not_handed(workspace: WorkspaceIndex, brought_by: Callable[[str], set[str]]) -> Iterator[NotHanded]:
    """The packages that commands lack; ``brought_by`` says what a package brings along."""
    rows: dict[tuple[str, str], list[TypeUse]] = {}
    for use in types_of_others(workspace):
        rows.setdefault((use.package.name, use.needed), []).append(use)
    for (name, needed), uses in rows.items():
        installs = workspace.installs[name]
        words = {word for word in installs.generated or () if _PACKAGE_NAME.fullmatch(word)} - {name}
        known = workspace.packages.keys() | packages.table().brings.keys()
        if installs.generated_at is None or not words <= known or needed in closure(words, brought_by):
            continue
        first = {use.place.file: use for use in reversed(uses)}
        yield NotHanded(uses[0].package, needed, installs.generated_at, tuple(first[file] for file in sorted(first)))


def without_group(workspace: WorkspaceIndex) -> Iterator[tuple[Package, Place]]:
    """The packages that generate interfaces and are in no group of those that do, with the place of the command."""
    for name in sorted(workspace.installs):
        installs, package = workspace.installs[name], workspace.packages.get(name)
        if package is None or package.is_interface_package or installs.generated_at is None:
            continue
        if package.build_type == "ament_cmake" and not installs.words & _SKIPS:
            yield package, installs.generated_at


@dataclass(frozen=True)
class NotGenerated:
    """Interface files of a package, by their paths below its folder, that ``rosidl_generate_interfaces`` does not get,
    though the CMake file names them."""

    package: Package
    command: Place
    files: tuple[str, ...]


def not_generated(workspace: WorkspaceIndex) -> Iterator[NotGenerated]:
    """The packages that name interface files, in a list say, and do not hand them to the command."""
    table, left_out = workspace.interfaces, dict[str, list[str]]()
    for name in table.names() if table is not None else ():
        own, kind, interface = parts_of_type(name)
        if table is not None and table.is_left_out(own, kind, interface):
            left_out.setdefault(own, []).append(f"{kind}/{interface}.{kind}")
    for own, files in left_out.items():
        installs, package = workspace.installs.get(own), workspace.packages.get(own)
        if installs is None or package is None or installs.generated_at is None or package.ros1:
            continue
        named = tuple(file for file in files if file.rpartition("/")[2] in installs.words)
        if named:
            yield NotGenerated(package, installs.generated_at, named)


_SKIPS = frozenset({"SKIP_INSTALL", "SKIP_GROUP_MEMBERSHIP_CHECK"})
"""Words with which the command does not ask for the group."""

__all__ = [
    "NotGenerated",
    "NotHanded",
    "TypeUse",
    "UndefinedType",
    "not_generated",
    "not_handed",
    "types_of_others",
    "undefined_types",
    "without_group",
]
