"""Patterns of a configuration are for the folder that it lies in, wherever archlint is started."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.globs import Glob


@pytest.mark.parametrize("here", [".", "tools", "tools/old"])
@pytest.mark.parametrize(
    ("pattern", "file", "is_meant"),
    [
        ("tools/*", "tools/old/a.py", True),
        ("tools/*", "src/tools/a.py", False),
        ("tools/old/", "tools/old/a.py", True),
        ("./tools/a.py", "tools/a.py", True),
        ("./a.py", "tools/a.py", False),
        ("**/a.py", "a.py", True),
        ("**/a.py", "tools/old/a.py", True),
        ("old", "tools/old/a.py", True),
        ("a.py", "tools/b.py", False),
    ],
)
def test_a_file_is_meant_from_any_folder(
    here: str, pattern: str, file: str, is_meant: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    (tmp_path / here).mkdir(parents=True, exist_ok=True)
    up = "../" * len(Path(here).parts)
    shown = file.removeprefix(f"{here}/") if file.startswith(f"{here}/") else up + file
    assert Glob(pattern, str(tmp_path), seen_from=str(tmp_path / here)).matches(shown) is is_meant
    monkeypatch.chdir(tmp_path / here)
    assert Glob(pattern, str(tmp_path)).matches(shown) is is_meant
