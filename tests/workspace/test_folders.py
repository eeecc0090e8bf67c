"""The folders that a path lies in."""

from __future__ import annotations

import pytest

from archlint.workspace.folders import folders_above


@pytest.mark.parametrize(
    ("path", "folders"),
    [
        ("robot/config/arm.yaml", ["robot/config", "robot"]),
        ("arm.yaml", []),
        ("", []),
        ("../arm.yaml", [".."]),
        ("/etc/robot/arm.yaml", ["/etc/robot", "/etc", "/"]),
        ("/", []),
        ("//", []),
    ],
)
def test_the_folders_of_a_path(path: str, folders: list[str]):
    assert list(folders_above(path)) == folders
