"""What is asked of a run."""

from __future__ import annotations

from dataclasses import field
from typing import TYPE_CHECKING

from archlint.monitor import Monitor
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.config.settings import Settings
    from archlint.engine.executors import ExecutorPool
    from archlint.engine.keeper import Keeper
    from archlint.engine.known import Baseline, Older
    from archlint.engine.linked_facts import LinkedFacts
    from archlint.observed.model import Observed
    from archlint.syntax.cache import NullStore, Store


class NothingToDo(Exception):
    """No file to look at; ``str()`` says where none was found."""


@dataclass(frozen=True)
class Request:
    """What is to be analysed and how.  ``paths`` exist; ``jobs`` is the most processes, None for as many as
    there are processors and memory for."""

    paths: tuple[str, ...]
    settings: Settings
    cached: bool = True
    jobs: int | None = None
    folder: str | None = None
    """The absolute path of the folder that files are shown from; None for the working directory.  With another one,
    the settings are those of :func:`archlint.config.seen_from.seen_from`."""
    launch: str | None = None
    """The launch file that is the only system, as a path from that folder."""
    launch_arguments: tuple[tuple[str, str], ...] = ()
    observed: Observed | None = None
    """What a running system said of itself, to hold the system against."""
    fixes: bool = True
    """Whether the findings are to have their fixes."""
    baseline: Baseline | None = None
    """The findings that are held back."""
    before: tuple[Older, ...] | None = None
    """The findings of an earlier revision, which are not to be reported again; None to report all."""
    occurrences: bool = False
    """Whether the report is to list all findings, known or not, before they are folded."""
    store: Store | NullStore | None = field(default=None, compare=False, repr=False)
    """Where results are kept, if not where the settings say."""
    monitor: Monitor = field(default_factory=Monitor, compare=False, repr=False)
    """Who is notified of the progress of the run; the result does not depend on it."""
    keeper: Keeper | None = field(default=None, compare=False, repr=False)
    """Who keeps what is said of the result, where an equal command may get the same answer."""
    linked: LinkedFacts | None = field(default=None, compare=False, repr=False)
    """The facts of all files, where what lies on the disk is not to be read."""
    pool: ExecutorPool | None = field(default=None, compare=False, repr=False)
    """Who compiles and follows programs, if not processes of this machine."""
