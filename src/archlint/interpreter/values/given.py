"""Constants that a launch gives to a program, of which the run knows whether anything depends on them."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from typing import TYPE_CHECKING

from archlint.interpreter.values.base import NO_PARAMETERS, Items, State, Value
from archlint.interpreter.values.constants import TEXT_LIMIT, Constant, Known, kind_of_text, via

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.origins import OriginKind


class Given(Known):
    """A constant that stays closed until something depends on it: who reads :attr:`value` calls ``look``.

    A program that never looks does the same with any other constant of the same type.  So what can be said by the type
    alone, by whether a text is empty, by the parameters that the constant comes from, or because it comes from the same
    ``source``, is said here without a look.  ``longest`` is how many characters it may have as far as those know who do
    not look at it.
    """

    __slots__ = ("_held", "longest", "look", "source")
    _held: Constant
    look: Callable[[], object]
    source: Hashable
    longest: int

    def __init__(
        self,
        value: Constant,
        via: frozenset[str] = NO_PARAMETERS,
        origin: Place | None = None,
        kind: OriginKind = "other",
        look: Callable[[], object] = bool,
        source: Hashable = None,
        longest: int = TEXT_LIMIT,
    ) -> None:
        fields = {"_held": value, "via": via, "origin": origin, "kind": kind}
        for name, held in {**fields, "look": look, "source": source, "longest": longest}.items():
            object.__setattr__(self, name, held)

    @property
    def value(self) -> Constant:
        self.look()
        return self._held

    def __eq__(self, other: object) -> bool:
        if self is other:
            return True
        if not isinstance(other, Known) or self.python_type is not other.python_type or self.via != other.via:
            return False
        if isinstance(other, Given) and self.source is not None and self.source == other.source:
            return True
        return self.value == other.value

    def __hash__(self) -> int:
        return super().__hash__()

    @property
    def python_type(self) -> type:
        return type(self._held)

    @property
    def is_true(self) -> bool:
        return bool(self._held) if self.is_text else super().is_true

    @property
    def text(self) -> str | None:
        return super().text if self.is_text else None

    @property
    def number_class(self) -> str | None:
        return "int" if isinstance(self._held, int) else "float" if isinstance(self._held, float) else None

    @property
    def whole_number(self) -> int | None:
        return super().whole_number if isinstance(self._held, int) else None

    @property
    def is_none(self) -> bool:
        return self._held is None

    @property
    def is_text(self) -> bool:
        return isinstance(self._held, str)

    @property
    def is_closed(self) -> bool:
        return True

    @property
    def shown(self) -> Known:
        source = None if self.source is None else (str, self.source)
        return Given(self.closed_text, self.via, look=self.look, source=source, longest=self.longest)

    def joined(self, parts: Sequence[Value], origin: Place | None) -> Known | None:
        return joined(parts, origin)

    @property
    def closed_text(self) -> str:
        """What ``str`` makes of it, for who makes another closed constant of that."""
        return str(self._held)

    @property
    def written_at(self) -> Place | None:
        return None if self.origin is None else super().written_at

    def chosen_by(self, parameters: frozenset[str]) -> Known:
        via = self.via | parameters
        return Given(self._held, via, self.origin, self.kind, self.look, self.source, self.longest)

    def items(self, state: State) -> Items | None:
        return super().items(state) if self.is_text else None


def joined(parts: Sequence[Value], origin: Place | None) -> Known | None:
    """The text that constants make, some of them closed: closed, too.  None where one of them has to be looked at."""
    texts: list[str] = []
    sources: list[Hashable] = []
    looks: list[Callable[[], object]] = []
    longest = 0
    for part in parts:
        if isinstance(part, Given) and part.source is not None:
            texts.append(part.closed_text)
            sources.append(part.source)
            looks.append(part.look)
            longest += part.longest
        elif isinstance(part, Known) and not part.is_closed:
            texts.extend(part.pieces)
            sources.append(texts[-1])
            longest += len(texts[-1])
        else:
            return None
    if longest > TEXT_LIMIT:
        return None

    def look() -> None:
        for each in looks:
            each()

    kind = kind_of_text({part.kind for part in parts if isinstance(part, Known)})
    return Given("".join(texts), via(*parts), origin, kind, look, tuple(sources), longest)


__all__ = ["Given"]
