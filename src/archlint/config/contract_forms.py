"""Which keys a contract may have beside each other."""

from __future__ import annotations

from archlint.architecture import CONNECTIONS, FORBID, INDEPENDENT, NUMBERS, POLICIES, QOS, REQUIRE, TYPES
from archlint.records import dataclass


@dataclass(frozen=True)
class _Form:
    """Keys that a contract may have beside ``name`` and ``kind``: all of ``needed``, at least one of ``some`` where
    there are any, and any of ``free``, of which it has at most ``most``."""

    needed: tuple[str, ...]
    some: tuple[str, ...] = ()
    free: tuple[str, ...] = ()
    most: int = 9

    def fits(self, given: set[str]) -> bool:
        rest = given - set(self.needed)
        return (
            given >= set(self.needed)
            and rest <= {*self.some, *self.free}
            and (not self.some or bool(rest & set(self.some)))
            and len(rest & set(self.free)) <= self.most
        )

    def __str__(self) -> str:
        words = " and ".join(f"`{key}`" for key in self.needed)
        if self.some:
            words += f" with {_listed(self.some)}"
        return f"{words} (and may have {_listed(self.free)})" if self.free else words


def _listed(keys: tuple[str, ...]) -> str:
    return ", ".join(f"`{key}`" for key in keys[:-1]) + f" or `{keys[-1]}`"


FORMS = {
    FORBID: (_Form(("from", "to"), free=CONNECTIONS, most=1),),
    REQUIRE: (
        _Form(("from", "to"), free=CONNECTIONS, most=1),
        _Form(("topic",), ("publisher", "subscriber")),
        _Form(("service",), ("server", "client")),
        _Form(("action",), ("server", "client")),
        _Form(("topic", "through")),
    ),
    INDEPENDENT: (_Form(("nodes",)),),
    TYPES: tuple(_Form((connection, "types")) for connection in CONNECTIONS),
    QOS: (_Form(("topic",), (*POLICIES, *NUMBERS), ("publisher", "subscriber")),),
}
