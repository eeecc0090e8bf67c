"""What API002 says of attributes that only a callback assigns, and that others read before it has run."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.checks.registry import finding
from archlint.checks.uncalled import uncalled_in_program, unless_uncalled
from archlint.finding import Finding, Related, Severity
from archlint.python_code.late_attributes import Late, LateRead, late_attributes
from archlint.python_code.methods_at_work import Called
from archlint.python_code.unspun_reads import UnspunRead, unspun_reads

if TYPE_CHECKING:
    from archlint.systems.model import System

TOO_LATE = "too late"
"""The group of findings about what one class assigns too late."""


def late_attribute_findings(system: System) -> Iterator[Finding]:
    """A finding for each such attribute."""
    for read in () if system.workspace is None else late_attributes(system.workspace):
        if read.late is not Late.NEVER:
            yield _finding(read)
        elif read.is_unshared or uncalled_in_program(system, read.assigned) is not None:
            yield from unless_uncalled(system, _finding(read))

    for unspun in () if system.workspace is None else unspun_reads(system.workspace):
        yield from unless_uncalled(system, _unspun(unspun))


def _unspun(read: UnspunRead) -> Finding:
    """An attribute of a node that a function has just made, and that only a callback assigns."""
    return finding(
        "API002",
        read.place,
        f"only {read.setter}() assigns {read.variable}.{read.name}, and nothing has spun {read.variable} yet: this "
        "line fails with an AttributeError",
        help=f"spin {read.variable} until {read.setter}() has run, or assign self.{read.name} in __init__()",
        related=[Related(read.assigned, "it gets its first value here")],
        identity=(read.cls, read.name, "unspun"),
        group=(TOO_LATE, read.place.file, read.cls, "unspun"),
    )


_ERRORS = {"AttributeError": "an AttributeError", "TypeError": "a TypeError"}
_FIRST = {
    None: "its __init__() comes here",
    Called.TIMER: "the timer's callback {} comes here",
    Called.MESSAGE: "a message for {} comes",
    Called.REQUEST: "a request for {} comes",
}


def _finding(read: LateRead) -> Finding:
    setter, reader = f"{read.setter}()", f"{read.reader}()"
    help = f"assign self.{read.name} in __init__()"
    if read.late is Late.NEVER:
        told = f"only {setter} assigns self.{read.name}, and nothing calls it: this line fails with an AttributeError"
        help += f", or call or register {setter}"
    elif read.error:
        told, help = _of_none(read)
    elif read.late is Late.AFTERWARDS:
        told = f"{reader} reads self.{read.name} before anything assigns it: the first time that is an AttributeError"
    else:
        first = _FIRST[read.role].format(reader)
        told = f"only {setter} assigns self.{read.name}: this line fails with an AttributeError if {first} first"
        help += ", and do without it here until it has a value"
    diagnostic = finding(
        "API002",
        read.place,
        told,
        help=help,
        related=[Related(read.assigned, "it gets its first value here")],
        identity=(read.cls, read.name, "late"),
        group=(TOO_LATE, read.place.file, read.cls, read.late),
    )
    is_certain = read.is_sure and (read.late is not Late.CALLED or read.role is None)
    return diagnostic if is_certain else replace(diagnostic, severity=Severity.WARNING)


def _of_none(read: LateRead) -> tuple[str, str]:
    """What is said of an attribute that is None at first."""
    error, reader = _ERRORS[read.error], f"{read.reader}()"
    help = f"do without self.{read.name} here as long as it is None"
    if read.late is Late.AFTERWARDS:
        return (
            f"{reader} uses self.{read.name} before anything but None is assigned: the first time that is {error}",
            help,
        )
    first = _FIRST[read.role].format(reader)
    return (
        f"self.{read.name} is None until {read.setter}() has run: this line fails with {error} if {first} first",
        help,
    )


__all__ = ["TOO_LATE", "late_attribute_findings"]
