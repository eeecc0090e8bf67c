"""Launch files that source the setup of another workspace themselves, and have the packages of that from there on."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import called_name

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_RUNS = frozenset({"run", "check_output", "check_call", "Popen", "getoutput", "popen"})
_SETUP = re.compile(r"/install/(?:local_)?setup\.(?:bash|sh|zsh)\b")
_SOURCES = re.compile(r"(?:^|[\s;&])(?:source|\.) ")


def sources_another(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether a launch file runs ``source ~/base_ws/install/setup.bash && env``, to start what that workspace has."""
    return workspace.code.kind_of(file) == "launch_python" and bool(_sources(workspace, file))


@kept_for_each_file
def _sources(file_facts: facts.Facts) -> bool:
    if not any(called_name(call) in _RUNS for call in everything_in(file_facts.body, facts.Call)):
        return False
    texts = [part.text for part in everything_in(file_facts.body, facts.Literal) if part.text is not None]
    for part in everything_in(file_facts.body, facts.FormatString):
        texts += [piece for piece in part.parts if isinstance(piece, str)]
    return any(map(_SETUP.search, texts)) and any(map(_SOURCES.search, texts))


__all__ = ["sources_another"]
