"""The shape of an expression of launch, and the forms of a test that can be decided for its values."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable

from archlint.records import dataclass


@dataclass(frozen=True)
class Argument:
    """A launch argument."""

    name: str

    @property
    def key(self) -> str:
        return f"\0{self.name}\0"


@dataclass(frozen=True)
class SameObject:
    """An object of which no more is known than that it is always the same one."""

    number: int

    @property
    def key(self) -> str:
        return f"\2{self.number}\2"


@dataclass(frozen=True)
class ClassFile:
    """The file of the class that stands before: two classes may share a name."""

    path: str

    @property
    def key(self) -> str:
        return f"\3{self.path}\3"


Part = str | Argument | SameObject | ClassFile


@dataclass(frozen=True)
class Equality:
    """``argument == 'value'``, or ``!=`` where it is not ``equal``."""

    argument: str
    value: str
    equal: bool


_NOT = re.compile(r"^\s*not\s+$")
_OPENS = re.compile(r"""^\s*['"]?$""")
_COMPARED = re.compile(r"""^['"]?\s*(?P<op>==|!=)\s*['"](?P<value>[^'"]*)['"]\s*$""")
_OPERATORS = re.compile(r"\b(?:and|or|not)\b|[()]")


@dataclass(frozen=True)
class Shape:
    """What an expression is made of; no two texts stand side by side."""

    parts: tuple[Part, ...] = ()

    @classmethod
    def of(cls, parts: Iterable[Part]) -> Shape:
        joined: list[Part] = []
        for part in parts:
            if isinstance(part, str) and joined and isinstance(joined[-1], str):
                joined[-1] += part
            elif part != "":
                joined.append(part)
        return cls(tuple(joined))

    @property
    def arguments(self) -> list[str]:
        """The names of the launch arguments in it."""
        return [part.name for part in self.parts if isinstance(part, Argument)]

    @property
    def is_known(self) -> bool:
        """Whether it can be written down."""
        return not any(isinstance(part, SameObject) for part in self.parts)

    @property
    def key(self) -> str:
        """A text that no other shape has."""
        return "".join(part if isinstance(part, str) else part.key for part in self.parts)

    def written(self, shown: Callable[[str], str]) -> str:
        """The expression for people, with arguments as they are ``shown``."""
        texts = (shown(part.name) if isinstance(part, Argument) else part for part in self.parts)
        return "".join(text for text in texts if isinstance(text, str))

    @property
    def truth(self) -> tuple[str, bool] | None:
        """The argument that is all it asks for, and whether it asks that to be true."""
        match self._without_spaces():
            case (Argument(name=name),):
                return name, True
            case (str(before), Argument(name=name)) if _NOT.match(before):
                return name, False
        return None

    @property
    def equality(self) -> Equality | None:
        """The one comparison that it is, of an argument with a text."""
        match self.parts:
            case (str(before), Argument(name=name), str(after)) if _OPENS.match(before):
                compared = _COMPARED.match(after)
            case (Argument(name=name), str(after)):
                compared = _COMPARED.match(after)
            case _:
                return None
        return None if compared is None else Equality(name, compared["value"], compared["op"] == "==")

    @property
    def is_about_truth(self) -> bool:
        """Whether it consists of truth values and what joins them."""
        return all(
            isinstance(part, Argument) or (isinstance(part, str) and not _OPERATORS.sub("", part).strip())
            for part in self.parts
        )

    def _without_spaces(self) -> tuple[Part, ...]:
        return tuple(part for part in self.parts if not (isinstance(part, str) and not part.strip()))


__all__ = ["Argument", "ClassFile", "Equality", "Part", "SameObject", "Shape"]
