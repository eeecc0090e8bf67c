"""What a text that is being typed is to become."""

from __future__ import annotations

from typing import Literal

from archlint.model import EntityKind
from archlint.place import Place
from archlint.records import dataclass

WantedKind = Literal[
    "name", "type", "import", "parameter", "package", "executable", "remap source", "remap target", "node key"
]


@dataclass(frozen=True)
class Wanted:
    """``what`` is wanted in place of ``replaces``, which is what is typed of it so far (``typed``).

    ``entity`` says for a name or a type what the call creates, ``type`` the type beside the name as
    ``package/msg/Name``, or its last part alone.  ``package`` and ``executable`` are those of the node around it in a
    launch file, as far as they are known; ``node`` is the key of a parameter file; ``module`` is what is imported from.
    """

    what: WantedKind
    replaces: Place
    typed: str
    entity: EntityKind | None = None
    type: str = ""
    package: str = ""
    executable: str = ""
    node: str = ""
    module: str = ""


__all__ = ["Wanted", "WantedKind"]
