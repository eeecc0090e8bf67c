"""Whether the code of a repository may run.

A configuration belongs to the repository that is checked, so it alone never decides: the one who starts archlint does,
on the command line or in the environment.
"""

from __future__ import annotations

import os
import site
import sysconfig
from collections.abc import Iterable, Mapping
from pathlib import Path

VARIABLE = "ARCHLINT_PLUGINS"


def said_by(environment: Mapping[str, str]) -> bool | None:
    """What the environment says of plugins: run them, leave them out, or nothing.  Raises ``ValueError``."""
    value = environment.get(VARIABLE, "")
    if value not in ("", "0", "1"):
        raise ValueError(f"{VARIABLE} is 1 to run plugins or 0 to leave them out, not {value!r}")
    return None if value == "" else value == "1"


def refusal(name: str) -> str:
    """What to say of a plugin that would run if somebody allowed it."""
    return (
        f"the plugin {name} is Python code of this repository, and archlint runs it only where you say so: "
        f"`--plugins` or {VARIABLE}=1 runs it, `--no-plugins` checks without its rules"
    )


def belongs_to(places: Iterable[str], repository: Path) -> bool:
    """Whether some of these files are the repository's, and not installed into the environment of archlint itself."""
    paths = sysconfig.get_paths()
    installed = (paths["purelib"], paths["platlib"], site.getusersitepackages(), *site.getsitepackages())
    folders = {os.path.realpath(folder) for folder in installed}
    for place in map(Path, map(os.path.realpath, places)):
        inside = place.is_relative_to(repository)
        if inside and not any(place.is_relative_to(folder) for folder in folders):
            return True
    return False
