"""The HTML page in a real browser: `make test-page`.  Without a Chromium all of it is skipped, and says so."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from benchmarks.page.chromium import Chromium, installed


@pytest.fixture(scope="session")
def chromium() -> Iterator[Chromium]:
    if installed() is None:
        pytest.skip("no Chromium is installed")
    with Chromium() as browser:
        yield browser
