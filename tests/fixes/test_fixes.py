"""What ``--fix`` makes of a file: exactly the edit that was meant, once, and code that still parses."""

from __future__ import annotations

import os
import stat
from pathlib import Path
from textwrap import dedent

import pytest

from archlint.cli import main
from archlint.edit_sites import IdleSuppression
from archlint.finding import Edit, Finding, Fix, Severity
from archlint.fixes.apply import apply
from archlint.fixes.dependencies import free_line
from archlint.fixes.source import Source
from archlint.fixes.suppressions import shortened
from archlint.place import Place

HEAD = """\
import threading

import rclpy
from rclpy.action import ActionClient
from rclpy.node import Node
from rclpy.wait_for_message import wait_for_message
from example_interfaces.action import Fibonacci
from std_msgs.msg import String
from std_srvs.srv import Trigger


class Worker(Node):
    def __init__(self):
        super().__init__('worker')
"""
TAIL = """

def main():
    rclpy.init()
    rclpy.spin(Worker())


if __name__ == '__main__':
    main()
"""


class Workbench:
    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.head = HEAD
        self.file = folder / "worker.py"

    def fix(self, line: str, *options: str, code: str) -> str:
        """The lines of the constructor after ``--fix``; a second run must change nothing."""
        self.file.write_text(self.head + f"        {line}\n" + TAIL, encoding="utf-8")
        main(["check", "--fix", "--select", code, "--no-cache", *options])
        after = self.file.read_text("utf-8")
        compile(after, "worker.py", "exec")
        main(["check", "--fix", "--select", code, "--no-cache", *options])
        assert self.file.read_text("utf-8") == after
        assert after.startswith(self.head) and after.endswith(TAIL)
        return dedent(after.removeprefix(self.head).removesuffix(TAIL)).strip()


@pytest.fixture
def workbench(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Workbench:
    monkeypatch.chdir(tmp_path)
    return Workbench(tmp_path)


CLIENT = "self.create_client(Trigger, 'far')"
SERVER = "ActionClient(self, Fibonacci, 'count')"


@pytest.mark.parametrize(
    ("before", "after"),
    [
        (f"self.ok = {CLIENT}.wait_for_service()", f"self.ok = {CLIENT}.wait_for_service(timeout_sec=5.0)"),
        (f"self.ok = {CLIENT}.wait_for_service(None)", f"self.ok = {CLIENT}.wait_for_service(5.0)"),
        (
            f"self.ok = {CLIENT}.wait_for_service(timeout_sec = None)",
            f"self.ok = {CLIENT}.wait_for_service(timeout_sec = 5.0)",
        ),
        (f"self.ok = {SERVER}.wait_for_server( )", f"self.ok = {SERVER}.wait_for_server(timeout_sec=5.0 )"),
        (
            f"{CLIENT}.wait_for_service()  # patiently",
            f"while rclpy.ok() and not {CLIENT}.wait_for_service(timeout_sec=5.0):  # patiently\n"
            "    self.get_logger().warning('waiting for the service far')",
        ),
        (
            f"{SERVER}.wait_for_server(\n    # patiently\n)",
            f"while rclpy.ok() and not {SERVER}.wait_for_server(timeout_sec=5.0\n    # patiently\n):\n"
            "    self.get_logger().warning('waiting for the action server count')",
        ),
        (
            f"while not {CLIENT}.wait_for_service(): pass",
            f"while rclpy.ok() and not {CLIENT}.wait_for_service(timeout_sec=5.0): pass",
        ),
        (
            f"ok = {CLIENT}.wait_for_service(); print(ok)",
            f"ok = {CLIENT}.wait_for_service(timeout_sec=5.0); print(ok)",
        ),
        (
            "_, said = wait_for_message(String, self, ('x'),)",
            "_, said = wait_for_message(String, self, ('x'), time_to_wait=5.0,)\n"
            "if said is None:\n    raise TimeoutError('no message came within 5.0 s')",
        ),
        (
            "_, said = wait_for_message(\n    String,\n    self,\n    'x',  # what is said\n)",
            "_, said = wait_for_message(\n    String,\n    self,\n    'x', time_to_wait=5.0,  # what is said\n)\n"
            "if said is None:\n    raise TimeoutError('no message came within 5.0 s')",
        ),
        (
            "came, said = wait_for_message(String, self, 'x')\nprint(said if came else '')",
            "came, said = wait_for_message(String, self, 'x', time_to_wait=5.0)\nprint(said if came else '')",
        ),
    ],
)
def test_a_wait_gets_a_limit(workbench: Workbench, before: str, after: str):
    assert workbench.fix(before.replace("\n", "\n        "), code="TMO001") == before  # unsafe: not by --fix alone
    assert workbench.fix(before.replace("\n", "\n        "), "--unsafe-fixes", code="TMO001") == after


@pytest.mark.parametrize(
    "line",
    [
        f"x = 1; {CLIENT}.wait_for_service()",  # no line of its own for what is to be said
        f"ok = {CLIENT}.wait_for_service()",  # nobody would read the answer
        "wait_for_message(String, self, 'x')",
        "said = wait_for_message(String, self, 'x')[1]",
        f"self.create_timer(5.0, lambda: {CLIENT}.wait_for_service())",  # a callback had better not wait
    ],
)
def test_a_limit_alone_would_only_hide_the_wait(workbench: Workbench, line: str):
    assert workbench.fix(line, "--unsafe-fixes", code="TMO001") == line


def test_a_limited_wait_breaks_no_other_rule_about_time(workbench: Workbench, capsys: pytest.CaptureFixture[str]):
    for line in (f"{CLIENT}.wait_for_service()", f"while not {CLIENT}.wait_for_service(): pass"):
        workbench.fix(line, "--unsafe-fixes", code="TMO001")
        capsys.readouterr()
        assert main(["check", "--select", "TMO", "--no-cache", "--format", "concise"]) == 0, capsys.readouterr().out


WAITING_SCRIPT = """\
import rclpy
from std_srvs.srv import Trigger


def make(node):
    return node.create_client(Trigger, 'far')


def main():
    rclpy.init()
    node = rclpy.create_node('asker')
    client = {}
    {}
    rclpy.spin(node)


main()
"""


@pytest.mark.parametrize(
    ("made", "after"),
    [
        (
            "node.create_client(Trigger, 'far')",
            "while rclpy.ok() and not client.wait_for_service(timeout_sec=5.0):\n"
            "        node.get_logger().warning('waiting for the service far')",
        ),
        ("make(node)", None),  # whose client this is, only another function tells
    ],
)
def test_a_wait_in_a_function(workbench: Workbench, made: str, after: str | None):
    workbench.file.write_text(WAITING_SCRIPT.format(made, "client.wait_for_service()"), encoding="utf-8")
    main(["check", "--fix", "--unsafe-fixes", "--select", "TMO001", "--no-cache"])
    expected = "client.wait_for_service()" if after is None else after
    assert workbench.file.read_text("utf-8") == WAITING_SCRIPT.format(made, expected)


def test_a_limit_that_the_caller_decides_is_left_alone(workbench: Workbench):
    line = f"limits = {{}}; {CLIENT}.wait_for_service(**limits)"
    assert workbench.fix(line, code="TMO001") == line


SPIN = "rclpy.spin_until_future_complete"


@pytest.mark.parametrize(
    ("arguments", "after"),
    [
        ("self, F", "self, F, timeout_sec=5.0"),
        ("self, F, None, None", "self, F, None, 5.0"),
        ("self, F, timeout_sec=-1", "self, F, timeout_sec=5.0"),
    ],
)
def test_a_spin_gets_a_limit(workbench: Workbench, arguments: str, after: str):
    future = f"{CLIENT}.call_async(Trigger.Request())"
    line = f"{SPIN}({arguments.replace('F', future)})"
    assert workbench.fix(line, code="TMO003") == line  # unsafe: not by --fix alone
    assert workbench.fix(line, "--unsafe-fixes", code="TMO003") == f"{SPIN}({after.replace('F', future)})"


@pytest.mark.parametrize(
    ("rest", "added"),
    [
        (
            "print(asked.result().success)",
            "if not asked.done():\n    raise TimeoutError('no answer came within 5.0 s')\n",
        ),
        ("if asked.done():\n    print(asked.result())", ""),
        ("if asked.result() is not None:\n    print(asked.result())", ""),
    ],
    ids=["a result that would be None", "the code asks itself", "the code asks for the result"],
)
def test_after_a_limited_spin_the_future_is_asked(workbench: Workbench, rest: str, added: str):
    asked = f"asked = {CLIENT}.call_async(Trigger.Request())"
    lines = f"{asked}\n{SPIN}(self, asked)\n{rest}".replace("\n", "\n        ")
    fixed = workbench.fix(lines, "--unsafe-fixes", code="TMO003")
    assert fixed == f"{asked}\n{SPIN}(self, asked, timeout_sec=5.0)\n{added}{rest}"


def test_a_goal_may_take_longer_than_any_limit_of_ours(workbench: Workbench):
    goal = f"handle = {SERVER}.send_goal_async(Fibonacci.Goal()).result()"
    line = f"{goal}; done = handle.get_result_async(); {SPIN}(self, done)"
    assert workbench.fix(line, "--unsafe-fixes", code="TMO003") == line


IN_A_THREAD = f"""def ask():
    answer = {CLIENT}.call(Trigger.Request())
    print(answer.success)
threading.Thread(target=ask).start()""".replace("\n", "\n        ")


@pytest.mark.parametrize(
    ("distro", "added"),
    [
        ("humble", None),
        ("jazzy", "    if answer is None:\n        raise TimeoutError('no answer came within 5.0 s')\n"),
        ("kilted", ""),  # call() raises by itself
        ("rolling", ""),
    ],
)
def test_a_call_gets_a_limit_where_the_distribution_has_one(workbench: Workbench, distro: str, added: str | None):
    before = workbench.fix(IN_A_THREAD, "--unsafe-fixes", code="TMO002")  # humble is among those that are supported
    (workbench.folder / "archlint.toml").write_text(f'distro = "{distro}"\n')
    assert workbench.fix(IN_A_THREAD, code="TMO002") == before  # unsafe: not by --fix alone
    after = workbench.fix(IN_A_THREAD, "--unsafe-fixes", code="TMO002")
    limited = before.replace("Request())\n", f"Request(), timeout_sec=5.0)\n{added}")
    assert after == (before if added is None else limited)


def test_a_limit_is_no_help_where_nobody_spins(workbench: Workbench):
    line = f"{CLIENT}.call(Trigger.Request())"
    (workbench.folder / "archlint.toml").write_text('distro = "jazzy"\n')
    assert workbench.fix(line, "--unsafe-fixes", code="TMO002") == line


def test_a_name_becomes_a_parameter(workbench: Workbench):
    line = "self.create_publisher(String, '/robot/sensor/temp', 10)"
    assert workbench.fix(line, code="NME001") == line  # unsafe: not by --fix alone
    assert workbench.fix(line, "--unsafe-fixes", code="NME001").splitlines() == [
        "self.declare_parameter('temp_topic', '/robot/sensor/temp')",
        "temp_topic = self.get_parameter('temp_topic').value",
        "self.create_publisher(String, temp_topic, 10)",
    ]


def test_all_names_of_a_class_are_one_finding_and_one_fix(workbench: Workbench):
    lines = "self.create_publisher(String, '/robot/echo', 10)\n        self.create_client(Trigger, '/robot/reset')"
    fixed = workbench.fix(lines, "--unsafe-fixes", code="NME001")
    assert fixed.splitlines() == [
        "self.declare_parameter('echo_topic', '/robot/echo')",
        "echo_topic = self.get_parameter('echo_topic').value",
        "self.create_publisher(String, echo_topic, 10)",
        "self.declare_parameter('reset_service', '/robot/reset')",
        "reset_service = self.get_parameter('reset_service').value",
        "self.create_client(Trigger, reset_service)",
    ]


def test_a_name_that_the_vehicle_fixes_stays(workbench: Workbench):
    line = "self.create_publisher(String, '/fmu/in/arming', 10)"
    assert workbench.fix(line, "--unsafe-fixes", code="NME001") == line


def test_two_names_that_end_alike_get_a_parameter_each(workbench: Workbench):
    lines = "self.create_publisher(String, '/left/say', 10)\n        self.create_publisher(String, '/right/say', 10)"
    fixed = workbench.fix(lines, "--unsafe-fixes", code="NME001")
    assert "declare_parameter('say_topic', '/left/say')" in fixed
    assert "declare_parameter('right_say_topic', '/right/say')" in fixed


@pytest.mark.parametrize(
    ("before", "after"),
    [
        (  # a constant of the module, and a keyword
            "self.create_publisher(msg_type=String, topic=SAID, qos_profile=10)",
            """
            self.declare_parameter('said_topic', SAID)
            said_topic = self.get_parameter('said_topic').value
            self.create_publisher(msg_type=String, topic=said_topic, qos_profile=10)
            """,
        ),
        (  # a text that is put together
            "self.create_client(Trigger, f'{SAID}/reset')",
            """
            self.declare_parameter('reset_service', f'{SAID}/reset')
            reset_service = self.get_parameter('reset_service').value
            self.create_client(Trigger, reset_service)
            """,
        ),
        (  # one name, two endpoints
            "self.create_publisher(String, '/robot/echo', 10); x = 1\n"
            "self.create_subscription(String, '/robot/echo', print, 10)",
            """
            self.declare_parameter('echo_topic', '/robot/echo')
            echo_topic = self.get_parameter('echo_topic').value
            self.create_publisher(String, echo_topic, 10); x = 1
            self.create_subscription(String, echo_topic, print, 10)
            """,
        ),
        (  # one name in two branches, neither of which reaches the other
            "if rclpy.ok():\n    self.create_publisher(String, '/robot/echo', 10)\n"
            "else:\n    self.create_publisher(String, '/robot/echo', 5)",
            """
            if rclpy.ok():
                self.declare_parameter('echo_topic', '/robot/echo')
                echo_topic = self.get_parameter('echo_topic').value
                self.create_publisher(String, echo_topic, 10)
            else:
                self.declare_parameter('robot_echo_topic', '/robot/echo')
                robot_echo_topic = self.get_parameter('robot_echo_topic').value
                self.create_publisher(String, robot_echo_topic, 5)
            """,
        ),
        (
            "ActionClient(self, Fibonacci, '/robot/count')",
            """
            self.declare_parameter('count_action', '/robot/count')
            count_action = self.get_parameter('count_action').value
            ActionClient(self, Fibonacci, count_action)
            """,
        ),
    ],
)
def test_names_that_are_not_simply_written_in_the_call(workbench: Workbench, before: str, after: str):
    workbench.head = HEAD.replace("\n\nclass", "\nSAID = '/robot/said'\n\n\nclass", 1)
    fixed = workbench.fix(before.replace("\n", "\n        "), "--unsafe-fixes", code="NME001")
    assert fixed == dedent(after).strip()


def test_a_method_that_may_run_again_asks_for_the_parameter_first(workbench: Workbench):
    fixed = workbench.fix(
        "self.open()\n        self.open()\n\n    def open(self):\n"
        "        self.create_publisher(String, '/robot/said', 10)",
        "--unsafe-fixes",
        code="NME001",
    )
    assert fixed.partition("def open(self):\n")[2].splitlines() == [
        "    if not self.has_parameter('said_topic'):",
        "        self.declare_parameter('said_topic', '/robot/said')",
        "    said_topic = self.get_parameter('said_topic').value",
        "    self.create_publisher(String, said_topic, 10)",
    ]


@pytest.mark.parametrize(
    "lines",
    [
        "say = '/robot/said'\ndef again():\n    self.create_publisher(String, say, 10)\nagain()\nagain()",
        "self.open('/robot/said')\n\ndef open(self, say):\n    self.create_publisher(String, say, 10)",
        "def open(say):\n    self.create_publisher(String, say, 10)\nopen('/robot/said')\nopen('/robot/said')",
    ],
)
def test_a_name_that_a_method_may_be_given_is_left_alone(workbench: Workbench, lines: str):
    indent = "        " if "self, say" not in lines else "    "
    body = lines.replace("\n", "\n" + indent)
    assert "declare_parameter" not in workbench.fix(body, "--unsafe-fixes", code="NME001")


def test_a_method_that_only_the_constructor_calls_declares_it_plainly(workbench: Workbench):
    fixed = workbench.fix(
        "self._set_up()\n\n    def _set_up(self):\n        self.create_publisher(String, '/robot/said', 10)",
        "--unsafe-fixes",
        code="NME001",
    )
    assert "has_parameter" not in fixed and "self.declare_parameter('said_topic', '/robot/said')" in fixed


SCRIPT = """\
import rclpy
from std_msgs.msg import String


def main():
    rclpy.init()
    node = rclpy.create_node('talker')
    {}
    rclpy.spin(node)


main()
"""


def test_a_node_of_a_function(workbench: Workbench):
    workbench.file.write_text(SCRIPT.format("node.create_publisher(String, '/robot/said', 10)"), encoding="utf-8")
    main(["check", "--fix", "--unsafe-fixes", "--select", "NME001", "--no-cache"])
    assert workbench.file.read_text("utf-8") == SCRIPT.format(
        "node.declare_parameter('said_topic', '/robot/said')\n"
        "    said_topic = node.get_parameter('said_topic').value\n"
        "    node.create_publisher(String, said_topic, 10)"
    )


HELPER = """\
from std_msgs.msg import String


class Helper:
    def __init__(self, node):
        self.node = node
        self.node.create_publisher(String, '/robot/said', 10)
"""


def test_a_node_that_is_handed_over_may_have_a_parameter_of_that_name(workbench: Workbench):
    (workbench.folder / "helper.py").write_text(HELPER, encoding="utf-8")
    workbench.fix("self.declare_parameter('said_topic', 'x'); import helper; helper.Helper(self)",
                  "--unsafe-fixes", code="NME001")  # fmt: skip
    fixed = (workbench.folder / "helper.py").read_text("utf-8")
    assert "if not self.node.has_parameter('robot_said_topic'):" in fixed


@pytest.mark.parametrize(
    "line",
    [
        "for _ in 'ab': self.create_publisher(String, '/robot/said', 10)",
        "if self.context: self.create_publisher(String, '/robot/said', 10)",
        "x = 1; self.create_publisher(String, '/robot/said', 10)",
        "[self.create_publisher(String, '/robot/said', 10) for _ in 'a']",
        "say = lambda: self.create_publisher(String, '/robot/said', 10); say()",
        "with open('x') as f, self.create_publisher(String, '/robot/said', 10): pass",
        "self.create_publisher(String, str('/robot/said'), 10)",
    ],
)
def test_a_name_that_cannot_become_a_parameter_in_one_step(workbench: Workbench, line: str):
    assert workbench.fix(line, "--unsafe-fixes", code="NME001") == line


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("self.x = 1  # archlint: ignore[TMO001]", "self.x = 1"),
        ("self.x = 1  # archlint: ignore[TMO001]  # why", "self.x = 1  # why"),
        (f"{CLIENT}.wait_for_service()  # archlint: ignore[TMO001, TMO002]",
         f"{CLIENT}.wait_for_service()  # archlint: ignore[TMO001]"),
        ("# archlint: ignore[TMO001]\n        self.x = 1", "self.x = 1"),
        ("self.x = 1  # archlint: ignore[SRV003]", "self.x = 1  # archlint: ignore[SRV003]"),  # was not run
    ],
)  # fmt: skip
def test_a_suppression_that_hides_nothing_goes(workbench: Workbench, before: str, after: str):
    assert workbench.fix(before, code="TMO001,TMO002,LNT001").replace("    ", "") == after


NODE_TAG = '<node pkg="demo_nodes_py" exec="talker"/>'


@pytest.mark.parametrize(
    ("file", "before", "after"),
    [
        ("it.launch.xml", f"  <!-- archlint: ignore[LCH005] -->\n  {NODE_TAG}\n", f"  {NODE_TAG}\n"),
        ("it.launch.xml", f"{NODE_TAG} <!-- archlint: ignore[LCH005] -->\n", f"{NODE_TAG}\n"),
        ("it.launch.xml", f"<!-- archlint: ignore[LCH005] --> {NODE_TAG}\n", f"{NODE_TAG}\n"),
        ("it.launch.xml", f"<!-- archlint: ignore[LCH005] why -->\n{NODE_TAG}\n",
         f"<!-- why -->\n{NODE_TAG}\n"),
        ("it.launch.xml", f"{NODE_TAG} <!-- archlint: ignore[LCH005,SRV003] why -->\n",
         f"{NODE_TAG} <!-- archlint: ignore[SRV003] why -->\n"),
        ("it.launch.xml", f"<!-- archlint: ignore[LCH005, SRV003] -->\n{NODE_TAG}\n",
         f"<!-- archlint: ignore[SRV003] -->\n{NODE_TAG}\n"),
        ("it.launch.xml", f"{NODE_TAG} <!--archlint: ignore [ LCH005,SRV003 ]-->\n",
         f"{NODE_TAG} <!--archlint: ignore [SRV003]-->\n"),
        ("it.launch.yaml", "- node:  # archlint: ignore[LCH005]\n    pkg: demo_nodes_py\n    exec: talker\n",
         "- node:\n    pkg: demo_nodes_py\n    exec: talker\n"),
    ],
)  # fmt: skip
def test_a_suppression_in_a_launch_file_goes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, file: str, before: str, after: str
):
    monkeypatch.chdir(tmp_path)
    whole = "<launch>\n{}</launch>\n" if file.endswith(".xml") else "launch:\n{}"
    (tmp_path / file).write_text(whole.format(before), encoding="utf-8")
    left = main(["check", "--fix", "--select", "LCH005,LNT001", "--no-cache"])
    assert (tmp_path / file).read_text("utf-8") == whole.format(after)
    assert left == 0


def test_a_dependency_is_declared(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)
    manifest = tmp_path / "package.xml"
    text = (
        '<?xml version="1.0"?>\r\n<package format="3">\r\n  <name>talk</name>\r\n  <version>0.1.0</version>\r\n'
        "  <description>It talks.</description>\r\n  <maintainer email='a@b.org'>A</maintainer>\r\n"
        "  <license>MIT</license>\r\n\r\n  <depend>rclpy</depend>\r\n  <!-- <depend>old</depend> -->\r\n"
        "  <export><build_type>ament_python</build_type></export>\r\n</package>\r\n"
    )
    manifest.write_bytes(text.encode())
    os.chmod(manifest, 0o640)
    (tmp_path / "talk").mkdir()
    (tmp_path / "talk" / "__init__.py").touch()
    (tmp_path / "talk" / "node.py").write_text(
        "import rclpy\nfrom std_msgs.msg import String\nfrom sensor_msgs.msg import Image\n\n"
        "rclpy.create_node('talk').create_publisher(String, 'said', 10)\n"
    )
    main(["check", "--fix", "--select", "PKG001", "--no-cache"])
    added = "  <exec_depend>{}</exec_depend>\r\n"
    after = manifest.read_bytes().decode()
    assert after.replace(added.format("std_msgs"), "").replace(added.format("sensor_msgs"), "") == text
    assert stat.S_IMODE(manifest.stat().st_mode) == 0o640


def test_the_fix_of_a_finding_in_two_copies_of_a_package_mends_both(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)
    about = "<version>0.1.0</version><description>d</description><maintainer email='a@b.org'>A</maintainer>"
    manifest = (
        f'<package format="3">\n  <name>talk</name>{about}\n  <license>MIT</license>\n  <depend>rclpy</depend>\n'
        "  <export><build_type>ament_python</build_type></export>\n</package>\n"
    )
    node = (
        "import rclpy\nfrom std_srvs.srv import Trigger\n\n"
        "node = rclpy.create_node('talk')  # archlint: ignore[TMO002]\n"
        "client = node.create_client(Trigger, 'far')\n"
    )
    for copy in ("one", "two"):
        (tmp_path / copy / "talk").mkdir(parents=True)
        (tmp_path / copy / "package.xml").write_text(manifest)
        (tmp_path / copy / "talk" / "__init__.py").touch()
        (tmp_path / copy / "talk" / "node.py").write_text(node)
    main(["check", "--fix", "--select", "TMO002,LNT001,PKG001", "--no-cache"])
    mended = node.replace("  # archlint: ignore[TMO002]", "")
    declared = "  <depend>rclpy</depend>\n  <exec_depend>std_srvs</exec_depend>\n"
    for copy in ("one", "two"):
        assert (tmp_path / copy / "talk" / "node.py").read_text() == mended
        assert (tmp_path / copy / "package.xml").read_text() == manifest.replace("  <depend>rclpy</depend>\n", declared)


ABOUT = "<package>\n  <name>talk</name>\n  <license>MIT</license>\n"


@pytest.mark.parametrize(
    ("text", "line"),
    [
        (f"{ABOUT}</package>\n", (4, "  ")),
        (f"{ABOUT}\t<depend>rclpy</depend>\n\n</package>\n", (5, "\t")),
        (f"{ABOUT}  <exec_depend>tf2</exec_depend>\n  <!-- <depend>old</depend> -->\n</package>\n", (5, "  ")),
        (f"{ABOUT}<!--\n  <depend>old</depend>\n-->\n</package>\n", (4, "  ")),
        ("<package><name>talk</name></package>\n", None),
    ],
)
def test_where_the_next_dependency_goes(text: str, line: tuple[int, str] | None):
    assert free_line(Source("package.xml", text)) == line


@pytest.mark.parametrize("text", ["", "x = 1\n", "x = 1  # a comment as long as that one was, or longer\n"])
def test_a_suppression_that_is_no_longer_there_is_left_alone(text: str):
    idle = IdleSuppression(Place("a.py", 1, 8, 1, 34), Place("a.py", 1, 26, 1, 34), (), closed=False)
    assert shortened(idle, Source("a.py", text)) is None
    assert shortened(idle, Source("a.py", "x = 1  # archlint: ignore[TMO001]\n")) is not None


def test_a_diff_without_a_line_says_why(workbench: Workbench, capsys: pytest.CaptureFixture[str]):
    asked = ["check", "--diff", "--select", "TMO001", "--no-cache"]
    workbench.file.write_text(HEAD + f"        {CLIENT}.wait_for_service()\n" + TAIL, encoding="utf-8")
    assert main(asked) == 0
    assert capsys.readouterr() == ("", "No safe fixes; 1 fixable with `--fix --unsafe-fixes`.\n")
    workbench.file.write_text(HEAD + "        pass\n" + TAIL, encoding="utf-8")
    assert main(asked) == 0
    assert capsys.readouterr() == ("", "No fixes.\n")


def test_a_diff_changes_nothing(workbench: Workbench, capsys: pytest.CaptureFixture[str]):
    before = HEAD + f"        {CLIENT}.wait_for_service()\n" + TAIL
    workbench.file.write_text(before, encoding="utf-8")
    assert main(["check", "--diff", "--unsafe-fixes", "--select", "TMO001", "--no-cache"]) == 1
    assert [line for line in capsys.readouterr().out.splitlines() if line[:2] in ("+ ", "- ")] == [
        f"-        {CLIENT}.wait_for_service()",
        f"+        while rclpy.ok() and not {CLIENT}.wait_for_service(timeout_sec=5.0):",
        "+            self.get_logger().warning('waiting for the service far')",
    ]
    assert workbench.file.read_text("utf-8") == before


def test_unsafe_fixes_alone_are_a_mistake(workbench: Workbench, capsys: pytest.CaptureFixture[str]):
    assert main(["check", "--unsafe-fixes"]) == 2
    assert "--unsafe-fixes needs --fix or --diff" in capsys.readouterr().err


FORMS = {
    "windows line ends": lambda text: text.replace(b"\n", b"\r\n"),
    "tabs": lambda text: text.replace(b"    ", b"\t"),
    "a byte order mark": lambda text: b"\xef\xbb\xbf" + text,
    "another encoding": lambda text: b"# -*- coding: latin-1 -*-\n# caf\xe9\n" + text,
    "no final newline": lambda text: text.rstrip(b"\n"),
    "other letters": lambda text: text.replace(b"import rclpy\n", "import rclpy  # \u00fc\u4e2d\n".encode(), 1),
}


@pytest.mark.parametrize("form", FORMS)
def test_the_form_of_a_file_is_kept(workbench: Workbench, form: str):
    lines = f"{CLIENT}.wait_for_service()\n        self.create_publisher(String, '/robot/said', 10)"
    written = f"{HEAD}        {lines}\n{TAIL}".encode()
    shaped = FORMS[form]
    workbench.file.write_bytes(written)
    main(["check", "--fix", "--unsafe-fixes", "--select", "TMO001,NME001", "--no-cache"])
    expected = workbench.file.read_bytes()
    assert expected != written
    workbench.file.write_bytes(shaped(written))
    main(["check", "--fix", "--unsafe-fixes", "--select", "TMO001,NME001", "--no-cache"])
    assert workbench.file.read_bytes() == shaped(expected)


LINE = f"{HEAD}        {CLIENT}.wait_for_service()\n{TAIL}"


@pytest.mark.parametrize(
    ("name", "before", "after", "breaking", "whole"),
    [
        ("a.py", "x = f(1", ")\n", ")", "2"),
        ("a.launch.xml", "<launch", "/>\n", "<", " "),
        ("a.yaml", "a: [1, 2", "]\n", "[", "0"),
    ],
)
def test_no_file_is_left_that_does_not_parse(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, before: str, after: str, breaking: str, whole: str
):
    monkeypatch.chdir(tmp_path)
    Path(name).write_text(before + after)
    column = len(before) + 1

    def texts_with(new: str) -> dict[str, str]:
        place = Place(name, 1, column, 1, column)
        fix = Fix("safe", (Edit(place, new),))
        return apply([Finding("TMO001", "wait-without-timeout", Severity.ERROR, "", place, fix=fix)]).texts

    assert texts_with(whole) == {name: before + whole + after}
    assert texts_with(breaking) == {}


def test_a_read_only_file_is_an_error(workbench: Workbench, capsys: pytest.CaptureFixture[str]):
    workbench.file.write_text(LINE, encoding="utf-8")
    other = workbench.folder / "another.py"
    other.write_text(LINE, encoding="utf-8")
    workbench.file.chmod(0o444)
    assert main(["check", "--fix", "--unsafe-fixes", "--select", "TMO001", "--no-cache"]) == 2
    assert "cannot write worker.py: the file is read-only" in capsys.readouterr().err
    assert workbench.file.read_text("utf-8") == other.read_text("utf-8") == LINE  # all or nothing


def test_a_linked_file_is_written_through(workbench: Workbench):
    real = workbench.folder / "kept" / "real.txt"
    real.parent.mkdir()
    real.write_text(LINE, encoding="utf-8")
    workbench.file.symlink_to(real)
    main(["check", "--fix", "--unsafe-fixes", "--select", "TMO001", "--no-cache"])
    assert workbench.file.is_symlink()
    assert "timeout_sec=5.0" in real.read_text("utf-8")
    assert sorted(path.name for path in real.parent.iterdir()) == ["real.txt"]


def test_a_diff_on_the_terminal_steers_nothing_and_in_a_file_is_exact(
    workbench: Workbench, capsys: pytest.CaptureFixture[str]
):
    workbench.file = workbench.folder / "wor\nker.py"
    line = f"        {CLIENT}.wait_for_service()\n        # \x1b[2J \u2028 said\n"
    workbench.file.write_text(f"{HEAD}{line}{TAIL}", encoding="utf-8")
    asked = ["check", "--diff", "--unsafe-fixes", "--select", "TMO001", "--no-cache"]
    main(asked)
    shown = capsys.readouterr().out
    assert " # \u241b[2J \\u2028 said\n" in shown
    assert shown.startswith("--- wor\u240aker.py\n+++ wor\u240aker.py\n")
    assert "No newline" not in shown
    main([*asked, "-o", "fix.patch"])
    assert " # \x1b[2J \u2028 said\n" in (workbench.folder / "fix.patch").read_text("utf-8")


@pytest.mark.parametrize("option", ["--fix", "--add-ignores", "--diff"])
def test_a_file_outside_of_the_repository_is_not_changed(
    workbench: Workbench, capsys: pytest.CaptureFixture[str], option: str, monkeypatch: pytest.MonkeyPatch
):
    repository = workbench.folder / "repository"
    (repository / ".git").mkdir(parents=True)
    workbench.file.write_text(LINE, encoding="utf-8")
    (repository / "linked.py").symlink_to(workbench.file)
    monkeypatch.chdir(repository)
    unsafe = [] if option == "--add-ignores" else ["--unsafe-fixes"]
    main(["check", option, *unsafe, "--select", "TMO001", "--no-cache"])
    assert workbench.file.read_text("utf-8") == LINE
    assert "+++" not in capsys.readouterr().out
    main(["check", str(workbench.file), option, *unsafe, "--select", "TMO001", "--no-cache"])
    assert (workbench.file.read_text("utf-8") == LINE) == (option == "--diff")


def test_no_text_of_a_file_outside_of_the_repository_is_shown(workbench: Workbench, capsys: pytest.CaptureFixture[str]):
    repository = workbench.folder / "repository"
    (repository / ".git").mkdir(parents=True)
    (repository / "msg").mkdir()
    secret = workbench.folder / "secret"
    secret.write_text("TOPSECRET\nx\n")
    for name in ("a.py", "msg/A.msg", "p.yaml", "l.launch.xml", "l.launch.yaml", "l.launch.py", "package.xml"):
        for kind in ("text", "json", "sarif"):
            (repository / name).symlink_to(secret)
            main(["check", str(repository), "--no-cache", "--format", kind])
            (repository / name).unlink()
    (repository / "linked.py").symlink_to(workbench.file)
    workbench.file.write_text(f"{LINE}# TOPSECRET\n", encoding="utf-8")
    main(["check", str(repository), "--no-cache"])
    said = capsys.readouterr().out
    assert "--> repository/linked.py" in said
    assert "TOPSECRET" not in said


BASE = """\
from rclpy.node import Node
from rclpy.node import Node as RosNode


class Base({}):
    def __init__(self):
        super().__init__('base')
        self.declare_parameter('said_topic', '/elsewhere')
"""
DERIVED = """\
import rclpy
from std_msgs.msg import String

from base import Base


class Derived(Base):
    def __init__(self):
        super().__init__()
        {}


rclpy.init()
rclpy.spin(Derived())
"""


@pytest.mark.parametrize(("bases", "edited"), [("Node", True), ("RosNode", True), ("Node, Mixin", False)])
def test_a_base_class_in_another_file(workbench: Workbench, bases: str, edited: bool):
    """Its parameters are left alone; a class that cannot be seen may have any."""
    package = workbench.folder / "talk"
    package.mkdir()
    (package / "base.py").write_text(BASE.format(bases), encoding="utf-8")
    derived = package / "derived.py"
    before = DERIVED.replace("from base", "from talk.base").format("self.create_publisher(String, '/robot/said', 10)")
    derived.write_text(before, encoding="utf-8")
    (package / "__init__.py").touch()
    main(["check", "--fix", "--unsafe-fixes", "--select", "NME001", "--no-cache"])
    after = derived.read_text("utf-8")
    assert after == before if not edited else "self.declare_parameter('robot_said_topic', '/robot/said')" in after


MANIFEST = '<package format="3"><name>{}</name><export><build_type>ament_python</build_type></export></package>\n'
WAIT = """\
self.asked = self.create_client(Trigger, 'asked')
        self.asked.wait_for_service()
        self.create_publisher(String, '/robot/said', 10)"""


def test_a_base_class_in_another_package(workbench: Workbench):
    """``self`` is a node all the same, and has a logger; which parameters it has is not looked up there."""
    derived = workbench.folder / "talk" / "talk" / "derived.py"
    texts = {
        "common/package.xml": MANIFEST.format("common"),
        "common/common/__init__.py": "",
        "common/common/base.py": BASE.format("Node"),
        "talk/package.xml": MANIFEST.format("talk"),
        "talk/talk/__init__.py": "",
    }
    code = DERIVED.replace("from base", "from std_srvs.srv import Trigger\nfrom common.base").format(WAIT)
    for path, text in {**texts, "talk/talk/derived.py": code}.items():
        (workbench.folder / path).parent.mkdir(parents=True, exist_ok=True)
        (workbench.folder / path).write_text(text, encoding="utf-8")
    main(["check", "--fix", "--unsafe-fixes", "--select", "NME001,TMO001", "--no-cache"])
    after = derived.read_text("utf-8")
    assert "self.get_logger()" in after and "timeout_sec" in after
    assert "declare_parameter" not in after
