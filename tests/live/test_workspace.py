"""A workspace that is kept in memory: unsaved text counts, and a first answer says what the whole analysis says."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import Settings
from archlint.finding import Finding
from archlint.live.buffers import Buffer, Buffers, as_saved
from archlint.live.snapshot import Snapshot
from archlint.live.workspace import Asked, LiveWorkspace
from archlint.monitor import Monitor
from server.robot import LISTENER, TALKER, Robot

LAUNCH = """\
<launch>
  <node pkg="robot" exec="{}" name="{}">
    <remap from="nothing" to="something"/>
  </node>
</launch>
"""


CPP_MANIFEST = """\
<package format="3">
  <name>microphone</name>
  <version>1.0.0</version>
  <description>a node of C++</description>
  <maintainer email="nobody@example.org">nobody</maintainer>
  <license>MIT</license>
  <depend>rclcpp</depend>
  <depend>std_msgs</depend>
  <export><build_type>ament_cmake</build_type></export>
</package>
"""
CMAKE = """\
project(microphone)
find_package(rclcpp REQUIRED)
find_package(std_msgs REQUIRED)
add_executable(microphone src/microphone.cpp)
install(TARGETS microphone DESTINATION lib/${PROJECT_NAME})
"""
MICROPHONE = """\
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"

class Microphone : public rclcpp::Node {
public:
  Microphone() : Node("microphone") {
    heard_ = create_publisher<std_msgs::msg::String>("chatter", 10);
  }
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr heard_;
};

int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Microphone>());
}
"""


class Live:
    """The workspace of the robot, and what an editor holds of it."""

    def __init__(self, robot: Robot) -> None:
        self.robot = robot
        self.workspace = LiveWorkspace(str(robot.folder))
        self._texts: dict[Path, str] = {}

    def hold(self, file: Path, text: str) -> Live:
        self._texts[file] = text
        return self

    @property
    def buffers(self) -> Buffers:
        return {str(file): Buffer(as_saved(text)) for file, text in self._texts.items()}

    @property
    def asked(self) -> Asked:
        return Asked((str(self.robot.folder),), Settings())

    def analyse(self) -> Snapshot:
        return self.workspace.analyse(self.asked, self.buffers)

    def first_answer(self) -> Snapshot | None:
        return self.workspace.first_answer(self.asked, self.buffers)


@pytest.fixture
def live(tmp_path: Path) -> Live:
    robot = Robot(tmp_path)
    for name in ("talker", "listener"):
        robot.write(f"launch/{name}.launch.xml", LAUNCH.format(name, name))
    return Live(robot)


def lines(findings: list[Finding] | tuple[Finding, ...], code: str) -> list[tuple[str, int]]:
    return [(Path(one.place.file).name, one.place.line) for one in findings if one.code == code]


def test_what_is_not_saved_counts(live: Live) -> None:
    assert lines([*live.analyse().findings], "TOP001") == []

    live.hold(live.robot.listener, LISTENER.replace("String", "Float64"))

    assert lines([*live.analyse().findings], "TOP001") == [("talker.py", 9)]


def test_what_is_not_saved_of_a_node_of_cpp_counts(live: Live) -> None:
    live.robot.write("../microphone/package.xml", CPP_MANIFEST)
    live.robot.write("../microphone/CMakeLists.txt", CMAKE)
    live.robot.write(
        "launch/all.launch.xml",
        '<launch><node pkg="robot" exec="listener"/><node pkg="microphone" exec="microphone"/></launch>',
    )
    microphone = live.robot.write("../microphone/src/microphone.cpp", MICROPHONE).resolve()
    assert "TOP001" not in {finding.code for finding in live.analyse().findings}

    live.hold(microphone, MICROPHONE.replace("msg::String", "msg::Int32"))
    assert "TOP001" in {finding.code for finding in live.analyse().findings}

    live.hold(microphone, MICROPHONE)
    assert "TOP001" not in {finding.code for finding in live.analyse().findings}


def test_a_manifest_that_is_not_saved_counts(live: Live) -> None:
    before = live.robot.manifest.read_text("utf-8")
    assert lines([*live.analyse().findings], "PKG001") == []

    live.workspace.look_again()
    live.hold(live.robot.manifest, before.replace("  <exec_depend>std_msgs</exec_depend>\n", ""))

    assert lines([*live.analyse().findings], "PKG001") == [("listener.py", 3)]


def test_the_first_answer_is_the_whole_one(live: Live) -> None:
    live.hold(live.robot.listener, LISTENER).analyse()
    edited = LISTENER.replace("'chatter'", "'/robot/chatter'").replace("import rclpy\n", "import rclpy\n\n\n")
    live.hold(live.robot.listener, edited)

    first, whole = live.first_answer(), live.analyse()

    assert first is not None
    assert first.findings == whole.findings
    assert lines([*first.findings], "NME001") == [("listener.py", 11)]
    assert lines([*first.findings], "LCH002") == [("listener.launch.xml", 3), ("talker.launch.xml", 3)]


def test_the_first_answer_makes_only_the_systems_that_have_edited_code(
    live: Live, monkeypatch: pytest.MonkeyPatch
) -> None:
    from archlint.systems.launched import LaunchSystems

    live.hold(live.robot.listener, LISTENER).analyse()
    made: list[str] = []
    make = LaunchSystems.system
    monkeypatch.setattr(LaunchSystems, "system", lambda self, run: (made.append(run.file), make(self, run))[1])

    live.hold(live.robot.listener, LISTENER + "\nx = 1\n").first_answer()

    assert [Path(file).name for file in made] == ["listener.launch.xml"]


def test_there_is_no_first_answer_to_what_is_more_than_an_edit_of_code(live: Live) -> None:
    assert live.hold(live.robot.listener, LISTENER).first_answer() is None
    live.analyse()
    assert live.hold(live.robot.talker, TALKER).first_answer() is None
    live.analyse()
    assert live.hold(live.robot.manifest, live.robot.manifest.read_text("utf-8")).first_answer() is None


class Newer(BaseException):
    """What ends an analysis that is overtaken."""


def test_an_analysis_that_is_overtaken_ends_before_the_next_rule(live: Live) -> None:
    asked: list[str] = []

    class Overtaking(Monitor):
        def asking(self) -> None:
            asked.append("a rule")
            if len(asked) == 3:
                raise Newer

    with pytest.raises(Newer):
        live.workspace.analyse(live.asked, live.buffers, Overtaking())

    assert len(asked) == 3
    assert live.analyse().findings == LiveWorkspace(str(live.robot.folder)).analyse(live.asked, {}).findings


def test_a_comment_that_moves_nothing_is_no_reason_to_judge_again(live: Live, monkeypatch: pytest.MonkeyPatch) -> None:
    text = LISTENER.replace("'chatter'", "'/robot/chatter'")
    before = live.hold(live.robot.listener, text).analyse()
    monkeypatch.setattr("archlint.live.workspace.judged_in_parts", None)
    edited = text.replace("import rclpy\n", "import rclpy  # always\n") + "# the end\n"

    after = live.hold(live.robot.listener, edited).analyse()

    assert live.first_answer() is None
    assert after.findings == before.findings
    assert after.tree.text("src/robot/robot/listener.py") == edited


def test_what_a_comment_moves_is_there_at_once(live: Live, monkeypatch: pytest.MonkeyPatch) -> None:
    text = LISTENER.replace("'chatter'", "'/robot/chatter'")
    live.hold(live.robot.listener, text).analyse()
    live.hold(live.robot.listener, text.replace("import rclpy\n", "# always\n\nimport rclpy\n"))
    with monkeypatch.context() as patch:
        patch.setattr("archlint.live.workspace.judged_in_parts", None)
        first = live.first_answer()

    assert first is not None
    assert lines([*first.findings], "NME001") == [("listener.py", 11)]
    assert first.findings == live.analyse().findings


def test_a_comment_on_the_line_of_a_finding_is_judged(live: Live) -> None:
    text = LISTENER.replace("'chatter'", "'/robot/chatter'")
    live.hold(live.robot.listener, text).analyse()
    live.hold(live.robot.listener, text.replace("import rclpy\n", "\nimport rclpy\n").replace("10)", "10)  # deep"))

    first = live.first_answer()

    assert first is not None
    assert first.findings == live.analyse().findings


def test_a_comment_that_turns_a_rule_off_counts(live: Live) -> None:
    text = LISTENER.replace("'chatter'", "'/robot/chatter'")
    live.hold(live.robot.listener, text).analyse()
    live.hold(live.robot.listener, f"# archlint: ignore-file[NME001] it is so\n{text}")

    first = live.first_answer()

    assert first is not None
    assert lines([*first.findings], "NME001") == lines([*live.analyse().findings], "NME001") == []


def test_what_does_not_compile_stands_for_what_it_said_before(live: Live) -> None:
    wrong = LISTENER.replace("String", "Float64").replace("'chatter'", "'/robot/chatter'")
    assert lines([*live.hold(live.robot.listener, wrong).analyse().findings], "NME001") == [("listener.py", 9)]

    broken = wrong.replace("import rclpy\n", "import rclpy\nfrom (\n")
    findings = [*live.hold(live.robot.listener, broken).analyse().findings]

    assert lines(findings, "LNT002") == [("listener.py", 2)]
    assert lines(findings, "NME001") == [("listener.py", 10)]  # where its line is now


def test_nothing_is_judged_again_while_code_does_not_compile(live: Live, monkeypatch: pytest.MonkeyPatch) -> None:
    text = LISTENER.replace("'chatter'", "'/robot/chatter'")
    live.hold(live.robot.listener, text).analyse()
    monkeypatch.setattr("archlint.live.workspace.judged_in_parts", None)

    findings = [*live.hold(live.robot.listener, f"{text}\ndef (\n").analyse().findings]

    assert lines(findings, "NME001") == [("listener.py", 9)]
    assert lines(findings, "LNT002") == [("listener.py", 19)]


def test_a_broken_launch_file_stands_for_what_it_said_before(live: Live) -> None:
    launch = live.robot.folder / "src/robot/launch/talker.launch.xml"
    text = launch.read_text("utf-8")
    assert ("talker.launch.xml", 3) in lines([*live.hold(launch, text).analyse().findings], "LCH002")

    findings = [*live.hold(launch, text.replace("</launch>", "<node")).analyse().findings]

    assert lines(findings, "LNT002") == [("talker.launch.xml", 5)]
    assert ("talker.launch.xml", 3) in lines(findings, "LCH002")
