"""What a launch file asks of Python's ``re``: never computed, for a pattern may take forever. What is not known of the
text is the reason, so that a file that waits for a line of a process's output says so."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from archlint.interpreter.values import External, Instance, Unknown, Value, reason

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.launch.run import LaunchRun

_PATTERN = "re.Pattern"
_FUNCTIONS = ("search", "match", "fullmatch", "findall", "finditer", "split", "sub", "subn")
_KNOWN = "what a regular expression finds"


def _compile(run: LaunchRun, site: CallSite) -> Value:
    given = {str(number): value for number, value in enumerate(site.args)}
    return Instance(External(_PATTERN), run.store.new_key(), None, given, _PATTERN)


def _function(run: LaunchRun, site: CallSite) -> Value:
    unknown = next((value for value in site.values if value.why_unknown is not None), None)
    return Unknown(_KNOWN if unknown is None else reason(unknown))


def _method(run: LaunchRun, receiver: Value, site: CallSite) -> Value:
    return _function(run, site)


PLAIN: dict[str, Callable[[LaunchRun, CallSite], Value]] = {
    "re.compile": _compile,
    **{f"re.{name}": _function for name in _FUNCTIONS},
}
METHODS: dict[str, Callable[[LaunchRun, Value, CallSite], Value]] = {
    f"{_PATTERN}.{name}": _method for name in _FUNCTIONS
}

__all__ = ["METHODS", "PLAIN"]
