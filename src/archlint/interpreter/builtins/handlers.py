"""What the functions of this package are like, and the simplest of them."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from archlint.interpreter.values import NONE, Unknown, Value, depends_on, reason

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.interpreter.machine import Machine

Handler = Callable[["Machine", "CallSite"], Value]

MISSING = Unknown("an argument is missing")


def first(site: CallSite) -> Value:
    """The first argument."""
    return site.args[0] if site.args else MISSING


def nothing(machine: Machine, site: CallSite) -> Value:
    """What gives ``None``."""
    return NONE


def same(machine: Machine, site: CallSite) -> Value:
    """What gives back its argument."""
    return first(site)


def unknown(what: str) -> Handler:
    """What is not followed, whatever it is given."""

    def handler(machine: Machine, site: CallSite) -> Value:
        return Unknown(reason(*site.args) if site.args else what)

    return handler


def because_of(*values: Value) -> Unknown:
    """What cannot be known, as these values are not; by the parameter that decides them."""
    return Unknown(reason(*values), depends_on(*values))


__all__ = ["Handler", "because_of", "first", "nothing", "same", "unknown"]
