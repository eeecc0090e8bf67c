"""``preset``: which rules run, which fail and which only inform, as a base that the other keys change."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from typing import TYPE_CHECKING

from archlint.config.preset_names import PresetName
from archlint.config.selection import ABOUT_THE_RUN, Layer
from archlint.finding import Severity
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.finding import Finding


@dataclass(frozen=True)
class Preset:
    """A layer below those of the configuration, and what a finding of each severity weighs."""

    layer: Layer = field(default_factory=Layer)
    weights: Mapping[Severity, Severity] = field(default_factory=dict)

    def severity(self, finding: Finding) -> Severity:
        """What a finding weighs; that archlint could not look at something is never made lighter."""
        if finding.code in ABOUT_THE_RUN:
            return finding.severity
        return self.weights.get(finding.severity, finding.severity)


PRESETS: Mapping[PresetName | None, Preset] = {
    None: Preset(),
    "course": Preset(Layer(extend_select=("GRF002", "PRM006")), {Severity.WARNING: Severity.INFO}),
    "team": Preset(Layer(extend_select=("LNT005",))),
    "safety": Preset(
        Layer(extend_select=("GRF002", "GRF003", "GRF004", "LNT005", "PRM006")), {Severity.INFO: Severity.WARNING}
    ),
}
"""``course``: errors fail, warnings only inform.  ``team``: errors and warnings fail, and a suppression has a reason.
``safety``: every finding fails, those of most opt-in rules, too."""
