"""What a C++ package of many headers costs: what its sources include is asked once, not for each header."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.robot_package import manifest

from archlint.config.settings import Settings
from archlint.engine.pipeline import Request, check
from archlint.interpreter.modules import ModuleIndex

HEADER = """#include "rclcpp/rclcpp.hpp"
class C{0} : public rclcpp::Node {{ public: C{0}(); }};
"""
SOURCE = """#include "robot/c{0}.hpp"
C{0}::C{0}() : Node("c{0}") {{ create_publisher<std_msgs::msg::String>("{1}", 1); }}
"""


def test_its_sources_are_looked_through_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    looked = 0
    find = ModuleIndex.find

    def counted(self: ModuleIndex, *given: object) -> object:
        nonlocal looked
        looked += 1
        return find(self, *given)

    monkeypatch.setattr(ModuleIndex, "find", counted)

    def of(many: int) -> int:
        nonlocal looked
        folder = tmp_path / str(many)
        for part in ("include/robot", "src"):
            (folder / "robot" / part).mkdir(parents=True)
        (folder / "robot/package.xml").write_text(manifest(build_type="ament_cmake"))
        for number in range(many):
            (folder / f"robot/include/robot/c{number}.hpp").write_text(HEADER.format(number))
            topic = "bad-name" if number == many - 1 else "good_name"
            (folder / f"robot/src/c{number}.cpp").write_text(SOURCE.format(number, topic))
        looked = 0
        findings = check(Request((str(folder),), Settings(), cached=False, jobs=1)).findings
        assert [finding.code for finding in findings if finding.code == "NME002"] == ["NME002"]
        return looked

    assert of(40) < 2.5 * of(20)
