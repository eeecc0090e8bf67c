"""Which file an import means, by the files that there are alone."""

from __future__ import annotations

from archlint.workspace.importable import Importable
from archlint.workspace.model import SourceFile

NODE = SourceFile("/w/robot/robot/node.py", "robot/robot/node.py", "python", package="robot", module="robot.node")
BASE = SourceFile("/w/robot/robot/base.py", "robot/robot/base.py", "python", package="robot", module="robot.base")
OTHER = SourceFile("/w/other/base.py", "other/base.py", "python", package="other", module="base")
LAUNCH = SourceFile(
    "/w/robot/launch/__init__.py", "robot/launch/__init__.py", "python", package="robot", module="launch"
)


def test_an_import_means_the_file_of_that_name_or_one_beside_its_own() -> None:
    importable = Importable([NODE, BASE, OTHER, LAUNCH])

    assert importable.meant(NODE, "robot.base") is BASE
    assert importable.meant(NODE, "base", level=1) is BASE
    assert importable.meant(NODE, "base") is BASE  # as Python finds it where node.py is a script
    assert importable.meant(OTHER, "base") is OTHER
    assert importable.meant(NODE, "launch") is None  # ROS's own


def test_its_digest_says_which_files_there_are() -> None:
    assert Importable([NODE, BASE]).digest == Importable((NODE, BASE)).digest
    assert Importable([NODE, BASE]).digest != Importable([NODE]).digest
