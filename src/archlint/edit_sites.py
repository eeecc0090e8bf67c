"""Edit sites: the places of the text that a fix of a finding edits, and what stands there.

The rule that finds something knows them; ``fixes/`` turns them into edits, where fixes are asked for.
"""

from __future__ import annotations

from archlint.place import Place
from archlint.records import dataclass


@dataclass(frozen=True)
class LogLoop:
    """A statement that is nothing but a wait: it becomes a loop that waits on and says so through the logger of
    ``node``, ``waiting for`` something."""

    statement: Place
    node: str
    waiting_for: str


@dataclass(frozen=True)
class AnswerCheck:
    """A statement after which the ``answer`` of a wait with a limit is to be looked at: ``test`` has a hole for it and
    holds where nothing came, in which case ``words`` say so."""

    statement: Place
    answer: Place
    test: str
    words: str


@dataclass(frozen=True)
class LimitlessCall:
    """A call that can be given a limit.  ``arguments`` is its argument list, brackets included; ``value`` is what
    stands for no limit there now."""

    keyword: str
    arguments: Place
    value: Place | None = None
    loop: LogLoop | None = None
    negated: Place | None = None
    """``not wait()``, where that is the test of a loop, which is then to end with ROS, too."""
    check: AnswerCheck | None = None


@dataclass(frozen=True)
class NamedCall:
    """A create call whose ``name`` can become a parameter of ``node``."""

    name: Place
    node: Place
    statement: Place
    """The parameter can be declared in front of it."""
    block: Place
    """From the statement to the end of its block: what runs afterwards, whenever the statement does."""
    function: Place | None
    interface: str
    """``topic``, ``service`` or ``action``."""
    written: str
    """The name itself."""
    same_as: tuple[str, ...]
    """Equal for the calls that one parameter can serve: the node and the name, as code in one form."""
    runs_once: bool
    method: str | None
    """The method that it is in, which runs once for a node only if nothing else in the file has its name."""
    shares_node: bool
    """Whether code of other files may declare parameters on the same node."""
    stays: bool = False
    """Whether the name is absolute for a reason, and is only known here for the other names of the same call."""


@dataclass(frozen=True)
class IdleSuppression:
    """A suppression comment that is to name nothing but the ``needed`` codes, or to go where there is none."""

    comment: Place
    listed: Place
    """All codes that it names, brackets included; on the line of the comment."""
    needed: tuple[str, ...]
    closed: bool
    """Whether it ends by itself, as comments of XML do; one with ``#`` goes on to the end of the line."""


@dataclass(frozen=True)
class MissingDependencies:
    """Packages that a package.xml has to declare."""

    manifest: str
    tag: str
    """What its format calls a dependency for run time."""
    packages: tuple[str, ...]


@dataclass(frozen=True)
class Sites:
    """What one finding would have edited: several of a kind where it stands for several calls, or for
    what several copies of a package show."""

    limits: tuple[LimitlessCall, ...] = ()
    names: tuple[NamedCall, ...] = ()
    suppressions: tuple[IdleSuppression, ...] = ()
    dependencies: tuple[MissingDependencies, ...] = ()

    def __add__(self, other: Sites) -> Sites:
        return Sites(
            self.limits + other.limits,
            self.names + other.names,
            self.suppressions + other.suppressions,
            self.dependencies + other.dependencies,
        )
