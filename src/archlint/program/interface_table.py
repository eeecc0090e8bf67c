"""The interfaces that the workspace defines, by ROS type name; read when first asked for."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING

from archlint.facts.interfaces import Interface, Section, parse_interface

if TYPE_CHECKING:
    from archlint.workspace.model import SourceFile

_SECTIONS = {
    "": "message",
    "Request": "request",
    "Response": "response",
    "Goal": "goal",
    "Result": "result",
    "Feedback": "feedback",
}


def type_of_file(file: SourceFile) -> str | None:
    """``package/msg/Name`` of an interface file; None where it lies in no package."""
    path = file.path.replace("\\", "/")
    stem, _, kind = path.rpartition("/")[2].rpartition(".")
    if file.package is None or kind not in ("msg", "srv", "action") or not stem:
        return None
    return f"{file.package}/{kind}/{stem}"


class InterfaceTable:
    """Interfaces by name.  ``read`` gives the text of a file, None where it cannot be read."""

    def __init__(self, files: Iterable[SourceFile], read: Callable[[SourceFile], str | None]) -> None:
        self._files: dict[str, SourceFile] = {}
        for file in files:
            if file.kind == "interface":
                name = type_of_file(file)
                if name is not None:
                    self._files.setdefault(name, file)
        self._read = read
        self._parsed: dict[str, Interface | None] = {}

    def names(self) -> list[str]:
        return sorted(self._files)

    def file(self, name: str) -> SourceFile | None:
        return self._files.get(name)

    def get(self, name: str) -> Interface | None:
        """The interface called ``package/kind/Name``; None where the workspace does not define it."""
        if name not in self._parsed:
            file = self._files.get(name)
            text = None if file is None else self._read(file)
            kind = name.split("/")[1]
            self._parsed[name] = None if text is None else parse_interface(text, kind)
        return self._parsed[name]

    def section(self, name: str, part: str) -> Section | None:
        interface = self.get(name)
        wanted = _SECTIONS.get(part)
        if interface is None or wanted is None:
            return None
        return next((section for section in interface.sections if section.name == wanted), None)

    def constant(self, name: str, part: str, constant: str) -> str | int | float | bool | None:
        """The value of a constant, or None.  Constants of services are on ``Srv.Request`` and ``Srv.Response``;
        those of messages on the class."""
        section = self.section(name, part)
        if section is None:
            return None
        for found in section.constants:
            if found.name == constant and isinstance(found.value, (str, int, float, bool)):
                return found.value
        return None
