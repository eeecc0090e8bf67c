"""The one error of the Python API."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from archlint.config.source import ConfigurationError
from archlint.engine.request import NothingToDo


class ArchlintError(Exception):
    """The job could not be done: where the command line ends with exit status 2.

    ``str()`` is all that the command line says.  ``message`` is the sentence alone; ``file`` and ``line`` (from 1) say
    where the mistake is, and are None where it is in no file.
    """

    def __init__(self, text: str, message: str = "", file: str | None = None, line: int | None = None) -> None:
        super().__init__(text)
        self.message, self.file, self.line = message or text, file, line


@contextmanager
def typed_errors() -> Iterator[None]:
    """What a run or a configuration refuses, as an :class:`ArchlintError`."""
    try:
        yield
    except ConfigurationError as error:
        raise ArchlintError(str(error), error.message, error.file or None, error.line) from None
    except NothingToDo as error:
        raise ArchlintError(str(error)) from None
