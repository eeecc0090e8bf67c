"""From the files of a workspace to their facts."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.engine.inputs import compiled_files
from archlint.engine.passed_over import skipped_files
from archlint.syntax.files import FactsOfFiles

if TYPE_CHECKING:
    from archlint.engine.request import Request
    from archlint.syntax.cache import NullStore, Store
    from archlint.workspace.model import Workspace


def compiled(request: Request, workspace: Workspace, store: Store | NullStore) -> FactsOfFiles:
    """The facts of the files of Python and C++."""
    linked = request.linked
    if linked is None:
        facts = FactsOfFiles(store, _screen_words, request.jobs, request.monitor, pool=request.pool)
    else:
        facts = FactsOfFiles(linked.cache, _screen_words, request.jobs, request.monitor, linked.read, request.pool)
    facts.prepare(compiled_files(workspace), skipped_files(workspace))
    return facts


def _screen_words() -> tuple[bytes, ...]:
    from archlint.libraries.screen import WORDS  # a run that changes nothing does without the API tables

    return WORDS
