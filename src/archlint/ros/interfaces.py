"""The interfaces of the workspace and the standard ones, by ROS type name; read when first asked for."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING, Literal

from archlint.ros import standard_interfaces
from archlint.syntax.interfaces import (
    INTERFACE_KINDS,
    KIND_OF_SUFFIX,
    FieldType,
    Interface,
    InterfaceField,
    InterfaceKind,
    Section,
    SectionName,
    parse_interface,
)

if TYPE_CHECKING:
    from archlint.workspace.model import SourceFile

MessageClass = Literal[
    "",
    "Request",
    "Response",
    "Event",
    "Goal",
    "Result",
    "Feedback",
    "Impl",
    "FeedbackMessage",
    "GetResultResponse",
]
"""Which class of an interface a message is of: that of a message itself is empty; an action's client gets its feedback
and its result in the last two."""
_SECTIONS: Mapping[MessageClass, SectionName] = {
    "": "message",
    "Request": "request",
    "Response": "response",
    "Goal": "goal",
    "Result": "result",
    "Feedback": "feedback",
}
_WRAPPERS: Mapping[MessageClass, Section] = {
    "FeedbackMessage": Section(
        "feedback message",
        [
            InterfaceField("goal_id", FieldType("unique_identifier_msgs/msg/UUID"), 0),
            InterfaceField("feedback", FieldType("Feedback"), 0),
        ],
    ),
    "GetResultResponse": Section(
        "result response",
        [InterfaceField("status", FieldType("int8"), 0), InterfaceField("result", FieldType("Result"), 0)],
    ),
}
"""What rclpy wraps the feedback and the result of every action in, on their way to the client."""
_WRAPPED: Mapping[str, MessageClass] = {"result": "Result", "feedback": "Feedback"}
"""The fields of these that have what is wrapped."""


def parts_of_type(interface: str) -> tuple[str, InterfaceKind, str]:
    """Package, kind and name of ``package/msg/Name``; raises KeyError for another kind."""
    package, kind, name = interface.split("/")
    return package, KIND_OF_SUFFIX[kind], name


def is_interface_name(name: str) -> bool:
    """Whether an interface can have a name, or the module that it is in (``_name``).

    Source: ``VALID_MESSAGE_NAME_PATTERN`` in rosidl_adapter/parser.py."""
    return name.startswith("_") or re.fullmatch("[A-Z][A-Za-z0-9]*", name) is not None


def type_of_file(file: SourceFile) -> str | None:
    """``package/msg/Name`` of an interface file; None where it lies in no package."""
    path = file.path.replace("\\", "/")
    stem, _, kind = path.rpartition("/")[2].rpartition(".")
    if file.package is None or kind not in KIND_OF_SUFFIX or not stem:
        return None
    return f"{file.package}/{kind}/{stem}"


def header_stem(name: str) -> str:
    """What the header of an interface is called in C++: ``joint_state`` of ``JointState``.

    Source: ``convert_camel_case_to_lower_case_underscore`` of rosidl_pycommon."""
    name = re.sub(r"(.)([A-Z][a-z]+)", r"\1_\2", name)
    return re.sub(r"([a-z0-9])([A-Z])", r"\1_\2", name).lower()


_OF_INTERFACES = ("_msgs", "_srvs", "_interfaces")
"""How packages are called that hold interfaces and nothing else."""
_MADE_BY_CMAKE = frozenset(
    {"configure_file", "add_custom_command", "execute_process", "foreach", "add_subdirectory", "include", "macro"}
)
"""Commands with which a package may make, or list, interfaces that stand nowhere as a file."""


class InterfaceTable:
    """Interfaces by name.  ``read`` gives the text of a file, None where it cannot be read.

    ``listed`` are the words of each package's CMakeLists.txt: it may generate interfaces from files that are not
    read (``.idl``), lie elsewhere, or are made when it is built.  Nothing is said about these.  ``generated`` are the
    words of the command that generates them, where all are known: then they are all there is.  ``without`` are the
    packages of the workspace that generate none.  A package of the workspace that defines interfaces hides the standard
    one of its name.
    """

    def __init__(
        self,
        files: Iterable[SourceFile],
        read: Callable[[SourceFile], str | None],
        listed: Mapping[str, Collection[str]] = MappingProxyType({}),
        generated: Mapping[str, Collection[str]] = MappingProxyType({}),
        without: Collection[str] = (),
    ) -> None:
        self._files: dict[str, SourceFile] = {}
        self._packages: set[str] = set()
        self._unread: set[str] = set()
        for file in files:
            if file.kind == "interface":
                self._add(file)
        self._nothing = frozenset(without)
        self._without = self._nothing - self._packages - self._unread
        self._listed: set[tuple[str, str, str]] = set()
        """Package, kind and name of what a CMakeLists.txt lists."""
        self._complete: set[str] = set()
        """Packages whose CMakeLists.txt names every interface that is generated."""
        for package, words in listed.items():
            if package in generated:
                self._add_generated(package, generated[package])
            elif "rosidl_generate_interfaces" in words:
                self._add_listed(package, words)
        self._read = read
        self._parsed: dict[str, Interface | None] = {}

    def _add(self, file: SourceFile) -> None:
        name = type_of_file(file)
        if name is not None:
            self._files.setdefault(name, file)
            self._packages.add(name.partition("/")[0])
        elif file.package is not None:
            self._unread.add(file.package)

    def _add_generated(self, package: str, words: Collection[str]) -> None:
        self._add_names(package, words)
        if self._lists(package):
            self._complete.add(package)

    def _add_names(self, package: str, words: Collection[str]) -> None:
        for word in words:
            stem, _, suffix = word.rpartition(".")
            folder, _, name = stem.rpartition("/")
            if name and suffix in KIND_OF_SUFFIX:
                self._listed.add((package, suffix, name))
            elif name and suffix == "idl":
                kind = folder.rpartition("/")[2]
                self._listed.update(
                    (package, other, name) for other in ([kind] if kind in KIND_OF_SUFFIX else INTERFACE_KINDS)
                )

    def _lists(self, package: str) -> bool:
        return any(listed == package for listed, _, _ in self._listed)

    def _add_listed(self, package: str, words: Collection[str]) -> None:
        self._add_names(package, words)
        globbed = any(f".{suffix}" in words for suffix in KIND_OF_SUFFIX)
        if not globbed and self._lists(package) and "GLOB" not in words:
            self._complete.add(package)
        if ".idl" in words or not _MADE_BY_CMAKE.isdisjoint(words):
            self._unread.add(package)
            self._complete.discard(package)

    def names(self) -> list[str]:
        """The interfaces of the workspace."""
        return sorted(self._files)

    def file(self, name: str) -> SourceFile | None:
        return self._files.get(name)

    def defines(self, package: str, kind: InterfaceKind, name: str) -> bool | None:
        """Whether a package defines an interface of that kind (``msg``, ``srv``, ``action``); None where the
        package is not known, or only in part."""
        if f"{package}/{kind}/{name}" in self._files:
            return not self.is_left_out(package, kind, name)
        if package in self._unread or (package, kind, name) in self._listed:
            return None
        if package in self._packages or package in self._without:
            return False
        standard = standard_interfaces.table()
        if package not in standard.packages:
            return False if package.endswith(_OF_INTERFACES) and not is_interface_name(name) else None
        return f"{package}/{kind}/{name}" in standard.interfaces

    def is_of_workspace(self, package: str) -> bool:
        """Whether a package of the workspace has interfaces, all of which are known."""
        return package in self._packages and package not in self._unread

    def is_known(self, package: str) -> bool:
        """Whether all interfaces of a package are known: one of the workspace, or of ROS."""
        of_ros = package in standard_interfaces.table().packages and package not in self._packages
        return self.is_of_workspace(package) or (of_ros and package not in self._unread | self._without)

    def missing_header(self, package: str, kind: InterfaceKind, stem: str) -> str | None:
        """The interface whose header ``package/msg/stem.hpp`` would be, where a package of the workspace certainly
        generates none of that name."""
        if not self.is_of_workspace(package):
            return None
        start = f"{package}/{kind}/"
        names = [name.removeprefix(start) for name in self._files if name.startswith(start)]
        names += [name for listed, of_kind, name in sorted(self._listed) if (listed, of_kind) == (package, kind)]
        same = [name for name in names if header_stem(name) == stem]
        if not same:
            return "".join(word.capitalize() for word in stem.split("_"))
        return same[0] if all(self.is_left_out(package, kind, name) for name in same) else None

    def is_left_out(self, package: str, kind: InterfaceKind, name: str) -> bool:
        """Whether the file of an interface is there, and the CMakeLists.txt, which lists others by name, does not
        have it: then it is not generated."""
        return (
            f"{package}/{kind}/{name}" in self._files
            and package in self._complete
            and (package, kind, name) not in self._listed
        )

    def is_built(self, file: SourceFile) -> bool:
        """Whether the build may read an interface file: False only where its package evidently generates others, or
        none."""
        interface = type_of_file(file)
        if interface is None:
            return True
        package, kind, name = parts_of_type(interface)
        return not (package in self._nothing or self.is_left_out(package, kind, name))

    def of_package(self, package: str, kind: InterfaceKind) -> list[str]:
        """The names of the interfaces that a package generates of one kind, sorted."""
        start = f"{package}/{kind}/"
        if package in self._without:
            return []
        if package in self._packages:
            here = (name.removeprefix(start) for name in self._files if name.startswith(start))
            return sorted(name for name in here if not self.is_left_out(package, kind, name))
        return sorted(standard_interfaces.table().names(package, kind))

    def all_of_package(self, package: str, kind: InterfaceKind) -> frozenset[str] | None:
        """The names of the interfaces of one kind that a package of the workspace has files of, or lists: it generates
        no others.  None where not all of them are known."""
        if not self.is_of_workspace(package):
            return None
        start = f"{package}/{kind}/"
        here = {name.removeprefix(start) for name in self._files if name.startswith(start)}
        return frozenset(here | {name for own, of_kind, name in self._listed if (own, of_kind) == (package, kind)})

    def packages_with(self, kind: InterfaceKind, name: str) -> tuple[str, ...]:
        """The packages of the workspace that define an interface of that kind and name, sorted."""
        end = f"/{kind}/{name}"
        packages = sorted(file.removesuffix(end) for file in self._files if file.endswith(end))
        return tuple(package for package in packages if self.defines(package, kind, name))

    def get(self, name: str) -> Interface | None:
        """The interface called ``package/kind/Name``; None where it is not known."""
        if name not in self._parsed:
            text = self._text(name)
            self._parsed[name] = None if text is None else parse_interface(text, parts_of_type(name)[1])
        return self._parsed[name]

    def _text(self, name: str) -> str | None:
        file = self._files.get(name)
        if file is not None:
            return self._read(file)
        if name.partition("/")[0] in self._packages:
            return None
        standard = standard_interfaces.table().interfaces.get(name)
        return None if standard is None else standard.text

    def section(self, name: str, section_name: MessageClass) -> Section | None:
        if section_name in _WRAPPERS:
            return _WRAPPERS[section_name]
        interface = self.get(name)
        wanted = _SECTIONS.get(section_name)
        if interface is None or wanted is None:
            return None
        return next((section for section in interface.sections if section.name == wanted), None)

    def has(self, name: str, section_name: MessageClass, attribute: str) -> bool | None:
        """Whether a message has a field or constant; None where its definition is not known in full."""
        if section_name in _WRAPPERS:
            return _WRAPPERS[section_name].field(attribute) is not None
        interface, section = self.get(name), self.section(name, section_name)
        if interface is None or section is None or interface.problems:
            return None
        return section.field(attribute) is not None or any(c.name == attribute for c in section.constants)

    def field_type(self, name: str, section_name: MessageClass, field: str) -> FieldType | None:
        """The type of a field, its name in full; None where it is not known or differs between distributions."""
        section = None if section_name in _WRAPPERS else self.section(name, section_name)
        definition = None if section is None else section.field(field)
        if definition is None or (name not in self._files and self._varies(name, field)):
            return None
        kind = definition.type
        return FieldType(kind.qualified(name.partition("/")[0]), kind.array, kind.size, kind.string_bound)

    def inside(self, name: str, section_name: MessageClass, attribute: str) -> str | None:
        """The one field of a message whose message has a field of this name; None where there is none, or several."""
        section = self.section(name, section_name)
        inner = [
            (field.name, self._interface_in(name, section_name, field.name))
            for field in (section.fields if section else ())
            if section_name in _WRAPPERS or not field.type.is_primitive
        ]
        having = [field for field, (kind, of) in inner if kind and self.has(kind, of, attribute)]
        return having[0] if len(having) == 1 else None

    def _interface_in(self, name: str, section_name: MessageClass, field: str) -> tuple[str, MessageClass]:
        """The interface and the section that a field has; empty where it is something else, or several."""
        if section_name in _WRAPPERS:
            return (name, _WRAPPED[field]) if field in _WRAPPED else ("", "")
        kind = self.field_type(name, section_name, field)
        return ("", "") if kind is None or kind.is_primitive or kind.array else (kind.name, "")

    def _varies(self, name: str, field: str) -> bool:
        standard = standard_interfaces.table().interfaces.get(name)
        return standard is not None and field in standard.varies

    def constant(self, name: str, section_name: MessageClass, constant: str) -> str | int | float | bool | None:
        """The value of a constant, or None.  Constants of services are on ``Srv.Request`` and ``Srv.Response``;
        those of messages on the class."""
        section = self.section(name, section_name)
        if section is None:
            return None
        for definition in section.constants:
            if definition.name == constant and isinstance(definition.value, (str, int, float, bool)):
                return definition.value
        return None


__all__ = ["InterfaceKind", "InterfaceTable", "MessageClass", "parts_of_type", "type_of_file"]
