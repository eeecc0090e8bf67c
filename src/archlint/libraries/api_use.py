"""One call of an API: what it is called on, and its arguments by the API's own names."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

from archlint.finding import Place
from archlint.interpreter.values import Value
from archlint.libraries.tables import Api
from archlint.records import dataclass
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.libraries.run import Run


@dataclass
class ApiUse:
    """One call of an API: what it was called on, and its arguments by the API's own parameter names."""

    api: Api
    receiver: Value | None
    arguments: dict[str, Value]
    expression: facts.Call | None
    open: bool
    """True where more arguments may follow than are known."""
    rest: list[Value]
    """Positional arguments beyond the signature."""
    keywords: dict[str, Value]

    def get(self, name: str | None) -> Value | None:
        return None if name is None else self.arguments.get(name)


def bind_api(api: Api, args: list[Value], keywords: dict[str, Value]) -> tuple[dict[str, Value], list[Value]]:
    bound = dict(zip(api.positional, args, strict=False))
    for name, value in keywords.items():
        bound.setdefault(name, value)
    return bound, args[len(api.positional) :]


def argument_places(run: Run, api: Api, e: facts.Call | None, skip: int = 0) -> dict[str, Place]:
    """Where each argument of a call is written, by the API's parameter names."""
    places: dict[str, Place] = {}
    if e is None or not run.activations:
        return places
    position = -skip
    for argument in e.args:
        if argument.star:
            break
        span = getattr(argument.value, "span", None)
        if argument.keyword is not None:
            name: str | None = argument.keyword
        else:
            name = api.positional[position] if 0 <= position < len(api.positional) else None
            position += 1
        if name is not None and span is not None:
            places[name] = run.place(span)
    return places


Effect = Callable[["Run", ApiUse], Value]
Method = Callable[["Run", Value, "CallSite"], Value]
Plain = Callable[["Run", "CallSite"], Value]


@dataclass(frozen=True)
class Offers:
    """What some libraries offer, by dotted names."""

    row: Callable[[str], Api | None]
    """The row of a call by its canonical name."""
    effects: Mapping[str, Effect]
    """What the effects that rows name do."""
    methods: Mapping[str, Method]
    """Methods without a row."""
    plain: Mapping[str, Plain]
    """Functions and classes without a row, and what of Python's own asks for something outside of the program."""
    bases: frozenset[str]
    """The effects of the classes whose constructors do the same for a class of ours that derives from them."""


__all__ = ["ApiUse", "Effect", "Method", "Offers", "Plain", "argument_places", "bind_api"]
