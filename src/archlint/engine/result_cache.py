"""The result of a whole run, kept under the content of all that it depends on.

A record is plain JSON from a folder that anybody may have written to: one with anything wrong is a miss.  The types of
what is kept say what is right, down to the last place of a fix.
"""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Collection
from dataclasses import astuple, replace
from pathlib import Path
from typing import TYPE_CHECKING, Generic, TypeVar

import msgspec

from archlint.engine.alike import Alike, Answers
from archlint.engine.own_code import own_code
from archlint.records import dataclass
from archlint.workspace.model import PYTHON_KINDS
from archlint.workspace.text_questions import is_about_text
from archlint.workspace.tree import TEXT_LIMIT

if TYPE_CHECKING:
    from archlint.engine.inputs import Inputs
    from archlint.syntax.files import FactsOfFiles
    from archlint.workspace.model import SourceFile


Result = TypeVar("Result")


@dataclass(frozen=True)
class _Asked:
    """What was asked of the disk, see :meth:`RunCache._asked`."""

    rows: Answers


class RunCache(Generic[Result]):
    """The record of one request over one state of a workspace.

    ``kind`` is the type of what is kept, a dataclass; ``beside`` distinguishes what one request may ask for.
    """

    def __init__(self, inputs: Inputs, kind: type[Result], *beside: object) -> None:
        self._store = inputs.store
        self._request = inputs.request
        self._workspace = inputs.workspace
        self._tree = inputs.tree
        self._kind = kind
        self._beside = beside
        self._key: str | None = None
        self._known_asked: _Asked | None = None
        """What the record that was read or written last depends on."""

    @property
    def asked(self) -> list[tuple[str, str, str | None]] | None:
        """What the result depends on beside the files of the workspace: question, path, answer.  None where no result
        was kept."""
        return None if self._known_asked is None else self._known_asked.rows

    def load(self) -> Result | None:
        """The result of an equal run.  Of files that are unchanged nothing but the status is read."""
        if not self._request.cached:
            return None
        self._key = self._key_of([self._known(file) for file in self._workspace.files])
        return self._read()

    def load_again(self, facts: FactsOfFiles) -> Result | None:
        """As :meth:`load`, once the files that had changed have been read."""
        if not self._request.cached or self._key is not None:
            return None
        files = self._workspace.files
        digests = [facts.digest(file) if file.kind in PYTHON_KINDS else self._known(file) for file in files]
        self._key = self._key_of(digests)
        return self._read()

    def load_alike(self, facts: FactsOfFiles) -> Result | None:
        """The result of a run over files that differ from these in nothing that it depends on."""
        alike = None if self._key is None else self._alike(facts)
        if alike is None or alike.key == self._key:
            return None
        result = self._read(alike.key)
        if result is not None:
            self._put_alike(facts, replace(alike, key=self._key or ""))
        return result

    def _alike(self, facts: FactsOfFiles) -> Alike | None:
        payload = self._store.get_run(self._key_of_meaning(facts) or "")
        try:
            alike = None if payload is None else Alike.read(json.loads(payload))
        except (ValueError, RecursionError):
            return None
        python = self._workspace.of_kind(*PYTHON_KINDS)
        return alike if alike is not None and alike.holds(python, facts, self._tree) else None

    def _key_of_meaning(self, facts: FactsOfFiles) -> str | None:
        """As the key of the result, of what the code means and not of how it is written."""
        files = self._workspace.files
        key = self._key_of([facts.outline(file) if file.kind in PYTHON_KINDS else self._known(file) for file in files])
        return None if key is None else f"alike-{key}"

    def _put_alike(self, facts: FactsOfFiles, alike: Alike) -> None:
        key = self._key_of_meaning(facts)
        if key is not None:
            self._store.put_run(key, json.dumps(msgspec.to_builtins(alike)).encode())

    def save(self, result: Result, facts: FactsOfFiles) -> None:
        """Keep a result, unless some input could not be read."""
        if self._key is None:
            return
        self._put(result, _Asked(self._asked({file.relative for file in self._workspace.files})))
        files = self._workspace.of_kind(*PYTHON_KINDS)
        python = {file.relative for file in files}
        # That a text was read for its words is not noted: they are.
        others = {file.relative for file in self._workspace.files if file.relative not in python}
        answers = [row for row in self._asked(others) if is_about_text(row[0]) or row[1] not in python]
        self._put_alike(facts, Alike.of(self._key, answers, self._tree.words, files, facts))

    def save_again(self, result: Result) -> None:
        """Keep what has been added to a result that was loaded or saved."""
        if self._known_asked is not None:
            self._put(result, self._known_asked)

    def _put(self, result: Result, asked: _Asked) -> None:
        assert self._key is not None
        self._known_asked = asked
        record = {"result": msgspec.to_builtins(result), "asked": msgspec.to_builtins(asked.rows)}
        self._store.put_run(self._key, json.dumps(record).encode())

    def _read(self, other: str | None = None) -> Result | None:
        key = other or self._key
        payload = None if key is None else self._store.get_run(key)
        if payload is None:
            return None
        try:
            # Not with msgspec's own reader: the name of a file may hold what is no UTF-8.
            record = json.loads(payload)
            result = msgspec.convert(record["result"], self._kind)
            asked = msgspec.convert({"rows": record["asked"]}, _Asked)
        except (ValueError, RecursionError, LookupError, TypeError):
            return None
        if any(self._tree.answer(question, path) != answer for question, path, answer in asked.rows):
            return None
        self._known_asked = asked
        return result

    def _asked(self, known: Collection[str]) -> Answers:
        """What was asked of the disk beside the files that the key is made of: a parameter file that git ignores,
        a file that is not there."""
        rows = [(question, path, answer) for (question, path), answer in self._tree.asked.items()]
        return [row for row in sorted(rows, key=lambda row: row[:2]) if row[0] == "listing" or row[1] not in known]

    def _known(self, file: SourceFile) -> str | None:
        """The digest of a file's content; of Python only a known one, for compiling hashes it anyway."""
        digest = self._store.lookup(file.path, file.stamp)
        if digest is None and file.kind not in PYTHON_KINDS:
            digest = _digest(Path(file.path))
            if digest is not None:
                self._store.remember(file.path, file.stamp, digest)
        return digest

    def _key_of(self, digests: list[str | None]) -> str | None:
        if None in digests:
            return None
        files = self._workspace.files
        inputs = [
            [file.relative, file.kind, file.package, file.module, file.context, list(map(astuple, file.links)), digest]
            for file, digest in zip(files, digests, strict=True)
        ]
        problems = [astuple(problem) for problem in self._workspace.problems]
        request = self._request
        asked = [repr(request.paths), repr(request.settings), request.launch, request.launch_arguments]
        known = repr((request.baseline, request.before, request.occurrences))
        observed = None if request.observed is None else (request.observed.file, request.observed.digest)
        beside = [self._kind.__name__, *map(repr, self._beside)]
        decisive: list[object] = [own_code(), asked, known, observed, inputs, problems, beside]
        return hashlib.sha256(json.dumps(decisive).encode()).hexdigest()


def _digest(path: Path) -> str | None:
    """A hash of a file's content, of a large one of its beginning and its size; None for what cannot be read, or is no
    regular file."""
    try:
        if not path.is_file():
            return None
        with path.open("rb") as stream:
            # A bag or a map may lie among the YAML files: nobody reads them, nor what is behind the limit.
            data = stream.read(TEXT_LIMIT + 1)
            size = os.fstat(stream.fileno()).st_size
        rest = b"" if len(data) <= TEXT_LIMIT else f" {size}".encode()
        return hashlib.sha256(data + rest).hexdigest()
    except OSError:
        return None
