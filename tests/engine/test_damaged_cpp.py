"""C++ of which part was not understood is told, and nothing is said to be missing beside it."""

from __future__ import annotations

from pathlib import Path

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check

TALKER = """\
#include "rclcpp/rclcpp.hpp"
class Talker : public rclcpp::Node {
public:
  Talker() : Node("talker") {
    orders_ = create_publisher<std_msgs::msg::String>("orders", 10);
    chatter_ = create_publisher<std_msgs::msg::String>("chatter", 10);
  }
};
int main(int argc, char ** argv) { rclcpp::spin(std::make_shared<Talker>()); }
"""
LISTENER = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Listener(Node):
    def __init__(self):
        super().__init__('listener')
        self.create_subscription(String, 'orders', print, 10)
        self.create_subscription(String, 'chatter', print, 10)

rclpy.init()
rclpy.spin(Listener())
"""


def found(folder: Path, talker: str, sources: str = "src") -> list[tuple[str, str, int, str]]:
    package = folder / "demo"
    (package / sources).mkdir(parents=True, exist_ok=True)
    (package / "package.xml").write_text(
        "<package format='3'><name>demo</name><version>0.0.1</version><description>d</description>"
        "<maintainer email='kim@example.com'>Kim</maintainer><license>MIT</license>"
        "<export><build_type>ament_cmake</build_type></export></package>"
    )
    (package / "CMakeLists.txt").write_text(
        f"project(demo)\nadd_executable(talker {sources}/talker.cpp)\ninstall(TARGETS talker DESTINATION lib/demo)\n"
    )
    (package / sources / "talker.cpp").write_text(talker)
    (folder / "listener.py").write_text(LISTENER)
    (folder / "archlint.toml").write_text('select = ["LNT002", "TOP003"]\nclosed-world = true\n')
    findings = check(Request((str(folder),), load(folder), cached=False, jobs=1)).findings
    return [(row.code, row.severity.name.lower(), row.place.line, row.message) for row in findings]


def test_a_whole_file_is_fine_and_a_lost_publisher_is_no_missing_one(tmp_path: Path) -> None:
    assert found(tmp_path, TALKER) == []
    missing = [code for code, *_ in found(tmp_path, TALKER.replace('"orders"', '"other"'))]
    assert missing == ["TOP003"]
    lost = TALKER.replace("orders_ = create_publisher<", "orders_ = create_publisher ")
    [(code, severity, line, message)] = found(tmp_path, lost)
    assert (code, severity, line) == ("LNT002", "info", 5)
    assert message.startswith("the call of create_publisher is missing from the graph")


def test_a_template_is_no_code_yet(tmp_path: Path) -> None:
    lost = TALKER.replace("orders_ = create_publisher<", "orders_ = create_publisher ")
    assert "LNT002" in [code for code, *_ in found(tmp_path / "one", lost, "drivers")]
    assert "LNT002" not in [code for code, *_ in found(tmp_path / "other", lost, "templates")]


def test_brackets_that_do_not_match_fail_the_run(tmp_path: Path) -> None:
    [(code, severity, line, message)] = found(tmp_path, TALKER.replace('"orders", 10)', '"orders", 10'))
    assert (code, severity, line) == ("LNT002", "warning", 5)
    assert message.startswith("'(' is never closed")
