"""Which package a file belongs to."""

from __future__ import annotations

import pytest

from archlint.workspace.installed import Installs
from archlint.workspace.model import SourceFile
from archlint.workspace.owners import FileOwners

FILES = [
    SourceFile("/w/src/robot/robot/talker.py", "src/robot/robot/talker.py", "python", "robot", "robot.talker"),
    SourceFile("/w/tools/loose.py", "tools/loose.py", "python", None, "loose"),
]
INSTALLS = {name: Installs(name, folder) for name, folder in (("robot", "src/robot"), ("arm", "src/robot/arm"))}


@pytest.mark.parametrize(
    ("path", "package"),
    [
        ("src/robot/robot/talker.py", "robot"),
        ("tools/loose.py", None),  # it was found, and in no package
        ("src/robot/config/a.yaml", "robot"),
        ("src/robot/arm/config/a.yaml", "arm"),  # the innermost folder
        ("src/robotics/a.yaml", None),
        ("elsewhere/a.yaml", None),
    ],
)
def test_the_package_of_a_file(path: str, package: str | None):
    assert FileOwners(FILES, INSTALLS).package_of(path) == package


def test_a_package_at_the_top_has_all_files():
    assert FileOwners((), {"robot": Installs("robot", ".")}).package_of("config/a.yaml") == "robot"
    assert FileOwners().package_of("config/a.yaml") is None
