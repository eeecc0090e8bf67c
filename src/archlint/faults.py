"""Failures of archlint's own: noted where they happened, so that the rest of a run goes on."""

from __future__ import annotations

import re
import traceback
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from archlint.finding import Place
from archlint.records import dataclass

_ADDRESS = re.compile(r" at 0x[0-9a-fA-F]+")


@dataclass(frozen=True)
class Fault:
    """A part of the work that raised: ``what`` failed, with an error of the type ``kind``, while it looked at
    ``place``; ``message`` holds what the error says and which line of archlint raised it."""

    what: str
    kind: str
    message: str
    place: Place

    @classmethod
    def of(cls, what: str, error: Exception, place: Place) -> Fault:
        kind = type(error).__name__
        if isinstance(error, (RecursionError, MemoryError)):
            return cls(what, kind, kind, place)  # which line was the last straw says nothing
        frames = traceback.extract_tb(error.__traceback__)
        where = f" ({Path(frames[-1].filename).name}:{frames[-1].lineno})" if frames else ""
        said = _ADDRESS.sub("", str(error))  # where an object lay is another place in every run
        return cls(what, kind, f"{kind}: {said}{where}", place)


class Faults:
    """The faults of one run, each once."""

    def __init__(self) -> None:
        self._by_key: dict[tuple[Place, str, str], Fault] = {}

    def note(self, what: str, error: Exception, place: Place) -> None:
        fault = Fault.of(what, error, place)
        self._by_key.setdefault((place, what, fault.kind), fault)

    @property
    def count(self) -> int:
        return len(self._by_key)

    def by_place(self) -> list[Fault]:
        """All of them by place."""
        return [self._by_key[key] for key in sorted(self._by_key)]

    @contextmanager
    def contained(self, what: str, place: Place) -> Iterator[None]:
        """What is raised inside is noted, and what stands after the block goes on."""
        try:
            yield
        except Exception as error:
            self.note(what, error, place)
