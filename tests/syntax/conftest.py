"""What is compiled here is compiled as users have it: anew, and in processes of its own."""

from __future__ import annotations

import pytest

from archlint.syntax import compile as compiler
from archlint.syntax import workers

CAN_FORK, ENCODED = workers.can_fork, compiler.encoded


@pytest.fixture(autouse=True)
def compiled_anew(compiled_once: None, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(workers, "can_fork", CAN_FORK)
    monkeypatch.setattr(compiler, "encoded", ENCODED)
