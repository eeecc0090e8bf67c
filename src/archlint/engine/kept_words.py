"""The words of the Python files of a workspace, kept in the cache for the next run: most files are as they were."""

from __future__ import annotations

import hashlib
from typing import TYPE_CHECKING

import msgspec

from archlint.engine.own_code import own_code
from archlint.workspace.model import PYTHON_KINDS

if TYPE_CHECKING:
    from archlint.engine.inputs import Inputs
    from archlint.syntax.files import FactsOfFiles

_Rows = dict[str, tuple[str, list[str]]]
"""The digest of the content of each file, by its shown path, and its words."""


class KeptWords:
    """Gives the tree of a run the words that are known."""

    def __init__(self, inputs: Inputs, facts: FactsOfFiles) -> None:
        self._store, self._tree = inputs.store, inputs.tree
        name = [str(inputs.tree.base), inputs.workspace.root, inputs.workspace.complete_folders]
        self._key = f"words-{hashlib.sha256(repr(name).encode()).hexdigest()}"
        self._surroundings = hashlib.sha256(repr(own_code()).encode()).hexdigest()
        self._digests = {file.relative: facts.digest(file) for file in inputs.workspace.of_kind(*PYTHON_KINDS)}
        self._known = self._read()
        self._tree.words.known = self.of

    def _read(self) -> _Rows:
        try:
            payload = self._store.get_programs(self._key) or b""
            surroundings, rows = msgspec.msgpack.decode(payload, type=tuple[str, _Rows])
        except msgspec.MsgspecError:
            return {}
        return rows if surroundings == self._surroundings else {}

    def of(self, path: str) -> list[str] | None:
        """The words of a file whose content is that of an earlier run; None where that is not known."""
        digest, words = self._known.get(path, ("", []))
        return words if digest and digest == self._digests.get(path) else None

    def keep(self) -> None:
        """Keep the words that were asked for in this run."""
        named = filter(_is_unicode, self._tree.words.read)
        asked = {path: digest for path in named if (digest := self._digests.get(path)) is not None}
        if all(path in self._known and self._known[path][0] == digest for path, digest in asked.items()):
            return
        rows = {path: (digest, sorted(self._tree.words.of(path))) for path, digest in sorted(asked.items())}
        self._store.put_programs(self._key, msgspec.msgpack.encode((self._surroundings, rows)))


def _is_unicode(path: str) -> bool:
    """Whether a name can be written down: that of a file may be any bytes."""
    return not any("\ud800" <= character <= "\udfff" for character in path)


def kept_words(inputs: Inputs, facts: FactsOfFiles) -> KeptWords | None:
    """What is known so far; None where nothing is kept, or where words stay in memory from run to run."""
    if inputs.memory is not None or not inputs.store.lasts or not inputs.store.takes_programs:
        return None
    return KeptWords(inputs, facts)


__all__ = ["KeptWords", "kept_words"]
