"""The workspaces that several tests ask about."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from lookup.asking import Editor

FIXTURES = Path(__file__).parents[2] / "fixtures"


@pytest.fixture(scope="module")
def lesson() -> Iterator[Editor]:
    yield from in_folder(FIXTURES / "lesson")


@pytest.fixture(scope="module")
def launched() -> Iterator[Editor]:
    yield from in_folder(FIXTURES / "launched")


def in_folder(folder: Path) -> Iterator[Editor]:
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        yield Editor()


@pytest.fixture(autouse=True)
def where_the_editor_is(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in {"lesson", "launched"} & set(request.fixturenames):
        monkeypatch.chdir(FIXTURES / name)


@pytest.fixture
def robot(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path
