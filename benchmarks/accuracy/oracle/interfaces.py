"""Stand-ins for generated interface classes: `pkg.msg.X`, `pkg.srv.X`, `pkg.action.X`.

A class knows its ROS type name. Constants and field defaults are read from the repository's own .msg,
.srv and .action files; everything else of an interface is an unknown value.
"""

from __future__ import annotations

import ast
import builtins
import re
import sys
import types
from functools import cache
from pathlib import Path
from typing import Any

from .record import recorder
from .standard_interfaces import EVERY_NAME, STANDARD
from .unknown import Unknown, make

KINDS = ("msg", "srv", "action")
_PARTS = {"srv": ("Request", "Response", "Event"), "action": ("Goal", "Result", "Feedback")}
_DEFAULTS: dict[str, Any] = {
    "bool": False, "string": "", "wstring": "", "float32": 0.0, "float64": 0.0,
    **{f"{sign}int{bits}": 0 for sign in ("", "u") for bits in (8, 16, 32, 64)}, "byte": b"\0", "char": 0,
}  # fmt: skip
_LINE = re.compile(r"^([A-Za-z][\w/]*)(<=\d+)?(\[[^\]]*\])?\s+([A-Za-z]\w*)\s*(=?)\s*(.*)$")

_sources: dict[str, Path] = {}


def register_sources(files: dict[str, str]) -> None:
    """Make known where the definitions of the repository's own interfaces lie: ROS type name to file."""
    _sources.update({name: Path(path) for name, path in files.items()})


class InterfaceType(type):
    """A generated interface class; any constant that is not known is an unknown value."""

    ros_type: str

    def __getattr__(cls, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        value = Unknown(f"{cls.__module__}.{cls.__qualname__}.{name}")
        type.__setattr__(cls, name, value)
        return value


class Interface(metaclass=InterfaceType):
    """An instance of an interface: fields hold what was assigned, or their default, or an unknown value."""

    ros_type = ""
    _fields: dict[str, Any] = {}  # noqa: RUF012

    def __init__(self, *args: Any, **fields: Any) -> None:
        for name, value in {**self._fields, **fields}.items():
            object.__setattr__(self, name, list(value) if isinstance(value, list) else value)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        value = make(f"{type(self).__name__}.{name}")
        object.__setattr__(self, name, value)
        return value

    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]:
        """The fields of the interface, where its definition is at hand."""
        return dict.fromkeys(cls._fields, "")

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and vars(self) == vars(other)

    __hash__ = object.__hash__


def ros_type_of(value: object) -> str | None:
    """The ROS type name of what was passed as a type, if it is an interface class."""
    return value.ros_type if isinstance(value, InterfaceType) and value.ros_type else None


@cache
def interface(package: str, kind: str, name: str) -> type:
    """The stand-in class of one interface; nested Request, Goal ... included."""
    ros_type = f"{package}/{kind}/{name}"
    sections = _sections(ros_type)
    result = _class(f"{package}.{kind}", name, ros_type, sections[0] if kind == "msg" and sections else ({}, {}))
    for index, part in enumerate(_PARTS.get(kind, ())):
        members = sections[index] if index < len(sections) else ({}, {})
        type.__setattr__(result, part, _class(f"{package}.{kind}", f"{name}.{part}", f"{ros_type}_{part}", members))
    if kind == "action":
        impl = types.SimpleNamespace(
            SendGoalService=interface(package, "action", f"{name}_SendGoal") if "_" not in name else Unknown(),
            GetResultService=interface(package, "action", f"{name}_GetResult") if "_" not in name else Unknown(),
            FeedbackMessage=_class(
                f"{package}.action", f"{name}_FeedbackMessage", f"{ros_type}_FeedbackMessage", ({}, {})
            ),
            CancelGoalService=interface("action_msgs", "srv", "CancelGoal"),
            GoalStatusMessage=interface("action_msgs", "msg", "GoalStatusArray"),
        )
        type.__setattr__(result, "Impl", impl)
    return result


def _class(module: str, name: str, ros_type: str, members: tuple[dict[str, Any], dict[str, Any]]) -> type:
    constants, fields = members
    short = name.rpartition(".")[2]
    body = {"__module__": module, "__qualname__": name, "ros_type": ros_type, "_fields": fields, **constants}
    return InterfaceType(short, (Interface,), body)


def _sections(ros_type: str) -> list[tuple[dict[str, Any], dict[str, Any]]]:
    path = _sources.get(ros_type)
    if path is None:
        return []
    try:
        text = path.read_text(encoding="utf-8", errors="replace")
    except OSError:
        return []
    return [_members(section) for section in re.split(r"(?m)^---.*$", text)]


def _members(text: str) -> tuple[dict[str, Any], dict[str, Any]]:
    constants: dict[str, Any] = {}
    fields: dict[str, Any] = {}
    for line in text.splitlines():
        found = _LINE.match(line.strip() if '"' in line or "'" in line else line.split("#")[0].strip())
        if not found:
            continue
        base, _, array, name, equals, value = found.groups()
        literal = _literal(value, base)
        if equals:
            constants[name] = literal
        elif array:
            fields[name] = literal if isinstance(literal, list) else []
        elif base in _DEFAULTS:
            fields[name] = literal if value and not value.startswith("#") else _DEFAULTS[base]
    return constants, fields


def _literal(text: str, base: str) -> Any:
    text = text.strip()
    if text in ("true", "True"):
        return True
    if text in ("false", "False"):
        return False
    try:
        return ast.literal_eval(text.split("#")[0].strip() if not text.startswith(("'", '"')) else text)
    except (ValueError, SyntaxError):
        return text if base in ("string", "wstring") else Unknown(text)


def _words_of_importer() -> set[str]:
    """The capitalised names that the importing file uses: what a star import from an unknown package may give."""
    frame: types.FrameType | None = sys._getframe(1)
    while frame is not None and not frame.f_code.co_filename.startswith(recorder.root):
        frame = frame.f_back
    if frame is None:
        return set()
    text = Path(frame.f_code.co_filename).read_text(encoding="utf-8", errors="replace")
    return set(re.findall(r"\b[A-Z]\w*[a-z]\w*", text)) - set(dir(builtins))


class InterfaceModule(types.ModuleType):
    """`pkg.msg`, `pkg.srv`, `pkg.action` and their generated submodules (`pkg.msg._string`)."""

    def __init__(self, name: str, package: str, kind: str) -> None:
        super().__init__(name)
        self._package, self._kind = package, kind
        self.__path__: list[str] = []

    def _names(self) -> set[str]:
        """What a star import gives: what is known of the package, or else the words that no known package has."""
        prefix = f"{self._package}/{self._kind}"
        own = {name.rpartition("/")[2] for name in _sources if name.startswith(f"{prefix}/")}
        return own or set(STANDARD.get(prefix, ())) or _words_of_importer() - EVERY_NAME

    def __getattr__(self, name: str) -> Any:
        if name == "__all__":
            return sorted(self._names())
        if name.startswith("__"):
            raise AttributeError(name)
        value: Any = (
            interface(self._package, self._kind, name) if name[:1].isupper() else Unknown(f"{self.__name__}.{name}")
        )
        setattr(self, name, value)
        return value
