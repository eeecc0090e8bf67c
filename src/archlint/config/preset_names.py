"""The names of the presets, which the schema needs without what they stand for."""

from __future__ import annotations

from typing import Literal

PresetName = Literal["course", "team", "safety"]
