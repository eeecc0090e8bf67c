"""What the configuration says to each rule."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from archlint.checks.registry import Options, registered
from archlint.rulebook import codes_of

if TYPE_CHECKING:
    from archlint.config.settings import Settings


def options_for(settings: Settings, codes: Iterable[str]) -> dict[str, Options]:
    """What the configuration says to each of these rules; codes that no module registers are left out."""
    checks = registered()
    return {
        code: Options(
            distros=settings.distros,
            shared_topics=settings.shared_topics,
            external=settings.external,
            owners=settings.owners,
            contracts=settings.contracts,
            layers=settings.node_layers,
            own={**checks[code].defaults, **settings.rules.get(code, {})},
            ignored_in=tuple(
                glob
                for glob, selectors in settings.per_file_ignores.items()
                if any(code in codes_of(selector) for selector in selectors)
            ),
        )
        for code in codes
        if code in checks
    }
