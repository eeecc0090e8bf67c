from __future__ import annotations

from pathlib import Path

import pytest

from programs.launching import Launches


@pytest.fixture
def launches(tmp_path: Path) -> Launches:
    return Launches(tmp_path)
