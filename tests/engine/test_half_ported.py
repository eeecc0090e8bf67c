"""Files that use rclpy and still import what only ROS 1 has."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Severity
from robot_package import TALKER, write_robot

NAMED = TALKER.replace("'chatter'", "'/said'")


@pytest.mark.parametrize(
    ("before", "severity"),
    [
        ("import rospy\n", Severity.INFO),
        ("from dynamic_reconfigure.server import Server\n", Severity.INFO),
        ("try:\n    import rospy\nexcept ImportError:\n    rospy = None\n", Severity.WARNING),
        ("def bridge():\n    import rospy\n", Severity.WARNING),
        ("import os\n", Severity.WARNING),
    ],
)
def test_a_file_that_fails_at_an_import_of_ros1(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, before: str, severity: Severity
):
    write_robot(
        tmp_path,
        **{
            "robot/talker.py": before + NAMED,
            "archlint.toml": 'select = ["NME001"]\n[rules.NME001]\neverywhere = true\n',
        },
    )
    monkeypatch.chdir(tmp_path)
    (told,) = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert told.severity is severity
    assert ("of ROS 1, so it does not run" in told.message) is (severity is Severity.INFO)


def test_a_workspace_may_have_a_module_of_that_name(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    write_robot(tmp_path / "robot", **{"robot/talker.py": "import actionlib\n" + NAMED})
    write_robot(tmp_path / "actionlib", **{"package.xml": "<package><name>actionlib</name></package>"})
    (tmp_path / "archlint.toml").write_text('select = ["NME001"]\n[rules.NME001]\neverywhere = true\n')
    monkeypatch.chdir(tmp_path)
    (told,) = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert told.severity is Severity.WARNING
