"""Containers of C++'s standard library, as far as they are not those of Python."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter.containers import new_list
from archlint.interpreter.values import DictValue, Unknown, Value

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.libraries.api_use import Plain
    from archlint.libraries.run import Run


def _pairs(run: Run, site: CallSite) -> Value:
    """What a loop over a container goes through: keys with their values, where it is a map."""
    container = site.args[0] if site.args else Unknown("no container")
    if not isinstance(container, DictValue):
        return container
    entries = container.entries(run)
    return new_list(run, [new_list(run, pair, "tuple") for pair in entries.entries.values()], open_=entries.open)


def _template_argument(run: Run, site: CallSite) -> Value:
    """What a template argument of a class is: ``template_argument(object, attribute, given, default)``."""
    if len(site.args) != 4:
        return Unknown("a template argument")
    owner, attribute, explicit, default = site.args
    if not explicit.is_none:
        return explicit
    kept = run.store.get(owner.heap_key, attribute.text) if owner.heap_key and attribute.text else None
    return kept or default


PLAIN: dict[str, Plain] = {"std.pairs": _pairs, "std.template_argument": _template_argument}

__all__ = ["PLAIN"]
