"""What analyses say of single files, kept in the cache for the next run."""

from __future__ import annotations

import hashlib
from typing import TYPE_CHECKING

from archlint.engine.own_code import own_code
from archlint.engine.summaries_ahead import processes_of
from archlint.syntax.summaries import Summaries
from archlint.workspace.model import PYTHON_KINDS

if TYPE_CHECKING:
    from archlint.engine.inputs import Inputs
    from archlint.syntax.files import FactsOfFiles


def kept_summaries(inputs: Inputs, facts: FactsOfFiles) -> Summaries:
    """What is known so far.  Nothing where facts stay in memory from run to run: there it stays with them.  Where
    nothing is kept, several processes tell each other all the same."""
    divided = processes_of(inputs.request) > 1
    if inputs.memory is not None or not (inputs.store.takes_programs or divided):
        return Summaries()
    files = {file.relative: file for file in inputs.workspace.files if file.kind in PYTHON_KINDS}

    def digest_of(path: str) -> str | None:
        return facts.meaning_of_read(files[path]) if path in files else None

    key = _key(inputs)
    surroundings = hashlib.sha256(repr(own_code()).encode()).hexdigest()
    return Summaries(lambda: inputs.store.get_programs(key), digest_of, surroundings)


def keep_summaries(summaries: Summaries, inputs: Inputs) -> None:
    """Keep what is known now for the next run."""
    if summaries.changed:
        inputs.store.put_programs(_key(inputs), summaries.written())


def _key(inputs: Inputs) -> str:
    name = [str(inputs.tree.base), inputs.workspace.root, inputs.workspace.complete_folders]
    return f"summaries-{hashlib.sha256(repr(name).encode()).hexdigest()}"


__all__ = ["keep_summaries", "kept_summaries"]
