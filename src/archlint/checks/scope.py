"""What a rule judges: from this follows when it is asked, and when two of its findings are one."""

from __future__ import annotations

from enum import Enum


class Scope(Enum):
    """What a rule judges.

    The *open system* is all code of the workspace, whoever starts it; a *launched system* is what one launch file
    starts, under the names and parameters that it gives.  Where nothing decides some launch arguments, a launched
    system is several, one for each combination of their values; so it is where its code starts something else for
    another of the ``choices`` of an argument.
    """

    WORKSPACE = "workspace"
    """What packages and their files say of each other, whatever nodes there are.  Asked once, and a place is reported
    once."""

    CODE = "code"
    """What code does wherever it runs.  Asked once, of the open system, and a place is reported once."""

    SYSTEM = "system"
    """What runs together, and under which names and parameters.  Asked of the open system and of each launched one,
    under each combination of arguments; two findings are one where they are at one place and say the same, or lead
    to the same related places."""

    AS_LAUNCHED = "as-launched"
    """A line of code or of a launch file that is wrong with some names or parameters.  Asked as ``SYSTEM`` is, and a
    place is reported once, whatever names or parameters show it."""

    LAUNCH_FILE = "launch-file"
    """What a launch file itself says, whichever arguments it is given.  Asked of each launched system once; findings
    are one as for ``SYSTEM``."""

    RUNNING = "running"
    """How a running system differs from its source, under the arguments that it was started with.  Asked as
    ``LAUNCH_FILE`` is, with something to say only where a recording is given (``--observed``)."""

    @property
    def of_each_system(self) -> bool:
        """Whether the rule is asked of launched systems, too."""
        return self not in (Scope.WORKSPACE, Scope.CODE)

    @property
    def of_each_arguments(self) -> bool:
        """Whether it is asked under each combination of the launch arguments that nothing decides."""
        return self in (Scope.SYSTEM, Scope.AS_LAUNCHED)

    @property
    def of_code(self) -> bool:
        """Whether the rule judges lines of code, wherever they run."""
        return self in (Scope.CODE, Scope.AS_LAUNCHED)

    @property
    def once_a_place(self) -> bool:
        """Whether two findings at one place are one, whatever they say."""
        return self in (Scope.WORKSPACE, Scope.CODE, Scope.AS_LAUNCHED)
