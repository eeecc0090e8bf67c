"""What to say of the arguments that ``--launch`` was given, and of those that it was not."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.suggestions import did_you_mean

if TYPE_CHECKING:
    from archlint.systems.model import System


def argument_notices(system: System) -> Iterator[str]:
    """Sentences on arguments that the launch file of a system does not know, and on those that it wants a value
    for.  Where a part of it could not be read, only on those that look like a slip of the pen."""
    launched = system.launched
    if launched is None:
        return
    complete = not any(launched.not_followed())
    declared = {argument.name for argument in launched.declared}
    known = declared | {use.name for use in launched.undeclared} | launched.undecided.keys()
    for name in sorted(launched.arguments.keys() - known):
        meant = did_you_mean(name, declared)
        if meant or complete:
            yield f"{launched.file} has no argument '{name}'{meant}"
    if not complete:
        return
    for argument in launched.declared:
        own = argument.file == launched.file and not argument.dormant  # whoever includes a file gives it values
        if own and argument.default is None and argument.name not in launched.arguments:
            cases = " or ".join(f"{argument.name}:={value}" for value in launched.undecided.get(argument.name, ()))
            yield f"{launched.file} needs a value for '{argument.name}'" + (f": {cases}" if cases else "")
