"""YAML as rcl reads it: the scanner of libyaml, which takes a tab for a blank wherever it indents nothing.

PyYAML's own scanner, with which launch reads YAML, refuses ``value<tab># comment``; libyaml's does not, and no
robot stops at it.  PyYAML carries libyaml along in all its wheels; built without it, its own scanner has to do.
"""

from __future__ import annotations

from typing import IO, Any

import yaml
from yaml.composer import Composer

DEEPEST = 1_000
"""Brackets inside each other, as many as libyaml takes."""


class LaunchLoader(yaml.SafeLoader):
    """PyYAML's own scanner, which goes through all open brackets at each token."""

    def fetch_flow_collection_start(self, TokenClass: type[Any]) -> None:
        if self.flow_level >= DEEPEST:
            raise RecursionError
        super().fetch_flow_collection_start(TokenClass)


if yaml.__with_libyaml__:

    class RclLoader(Composer, yaml.CSafeLoader):
        """Events from libyaml, nodes from Python: the composer in C is recursive and can kill the process."""

        def __init__(self, stream: str | bytes | IO[Any]) -> None:
            yaml.CSafeLoader.__init__(self, stream)
            Composer.__init__(self)

else:
    RclLoader = LaunchLoader  # type: ignore[misc,assignment]
