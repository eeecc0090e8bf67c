"""ARC004: committed declarations of nodes that their code does not keep."""

from __future__ import annotations

import shutil
from pathlib import Path
from textwrap import dedent

import pytest

from archlint.cli import main
from archlint.config.settings import load
from archlint.engine.pipeline import Request, check

NODE = """\
import rclpy
from rclpy.node import Node
from rclpy.qos import QoSProfile, ReliabilityPolicy
from std_msgs.msg import Bool, String


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        {body}


rclpy.init()
rclpy.spin(Driver())
"""


@pytest.fixture
def drift(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """The findings about a node whose constructor has some lines, and a file that declares some of it."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "archlint.toml").write_text('select = ["ARC004"]\n')

    def find(declared: str, *lines: str) -> list[str]:
        (tmp_path / "driver.py").write_text(NODE.format(body="\n        ".join(lines or ("pass",))))
        text = declared if "node:" in declared else f"node: {{name: driver}}\n{dedent(declared)}"
        (tmp_path / "interface.yaml").write_text(text)
        report = check(Request((".",), load(tmp_path), cached=False, jobs=1))
        return [f"{f.place.file}:{f.place.line} {f.message}" for f in report.findings]

    return find


@pytest.fixture
def nodl_drift(drift, tmp_path: Path):
    """The same of a NoDL file."""

    def find(declared: str, *lines: str) -> list[str]:
        head = '<interface version="1"><node name="driver" executable="driver">\n'
        (tmp_path / "driver.nodl.xml").write_text(f"{head}{declared}\n</node></interface>\n")
        return drift("# nothing\nnode: {}", *lines)

    return find


SCAN = "self.create_publisher(String, 'scan', 10)"
SCAN_DECLARED = "publishers: [{topic: scan, type: std_msgs/msg/String, qos: {history: 10, reliability: RELIABLE}}]"


def test_what_agrees_is_no_finding(drift):
    assert drift(SCAN_DECLARED, SCAN) == []


def test_names_are_compared_as_ros_expands_them(drift):
    assert drift(SCAN_DECLARED.replace("topic: scan", "topic: /scan"), SCAN) == []
    assert drift(SCAN_DECLARED.replace("scan", "driver/scan"), "self.create_publisher(String, '~/scan', 10)") == []


def test_an_end_that_is_gone(drift):
    assert drift(SCAN_DECLARED) == [
        "interface.yaml:2 the publisher 'scan' of /driver is declared here and not in the code"
    ]


def test_an_end_that_is_new(drift):
    assert drift("parameters: {}", SCAN) == ["driver.py:10 the publisher 'scan' is not declared in interface.yaml"]


@pytest.mark.parametrize(
    ("line", "differs"),
    [
        ("self.create_publisher(Bool, 'scan', 10)", "as std_msgs/msg/String and created as std_msgs/msg/Bool"),
        ("self.create_publisher(String, 'scan', 5)", "as keep last 10 and created as keep last 5"),
        (
            "self.create_publisher(String, 'scan', QoSProfile(depth=10, reliability=ReliabilityPolicy.BEST_EFFORT))",
            "as reliable and created as best effort",
        ),
    ],
)
def test_an_end_that_is_otherwise(drift, line, differs):
    assert drift(SCAN_DECLARED, line) == [f"interface.yaml:2 the publisher 'scan' is declared {differs}"]


@pytest.mark.parametrize(
    ("declared", "message"),
    [
        ("{type: double, default_value: 1.0}", "has the default 1.0 here and 0.5 in the code"),
        ("{type: int}", "has the type int here and double in the code"),
    ],
)
def test_a_parameter_that_is_otherwise(drift, declared, message):
    findings = drift(f"parameters: {{speed: {declared}}}", "self.declare_parameter('speed', 0.5)")
    assert findings == [f"interface.yaml:2 the parameter 'speed' {message}"]


def test_parameters_may_be_nested(drift):
    declared = "parameters: {arm: {speed: {type: double}, name: {type: string_fixed_25}}}"
    lines = ("self.declare_parameter('arm.speed', 0.5)", "self.declare_parameter('arm.name', 'left')")
    assert drift(declared, *lines) == []


@pytest.mark.parametrize(
    "line",
    [
        "self.create_publisher(String, input(), 10)",  # perhaps the declared one
        "import elsewhere; elsewhere.use(self)",
    ],
)
def test_a_node_that_is_not_known_in_full_may_have_what_is_declared(drift, line):
    assert drift(SCAN_DECLARED, line) == []


@pytest.mark.parametrize(
    "declared",
    [
        "publishers: [{topic: '${param:topic}', type: std_msgs/msg/String}]",
        "node: {name: other}\n",  # in C++, perhaps
        "node: {name: '${THIS_NODE}'}\n",
        "node: [",
        "- node:\n",
        "node: driver\n",
    ],
)
def test_a_file_that_does_not_say_enough(drift, declared):
    assert drift(declared, SCAN) == []


def test_what_is_created_under_a_condition_need_not_be_declared(drift):
    assert drift("parameters: {}", "if input():", f"    {SCAN}") == []


def test_no_file_no_finding(drift, tmp_path):
    drift(SCAN_DECLARED)
    (tmp_path / "interface.yaml").rename(tmp_path / "params.yaml")
    assert check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings == []


def test_an_edited_declaration_is_read_again(drift, tmp_path, capsys):
    drift(SCAN_DECLARED, SCAN)
    words = ["check", "--cache-dir", str(tmp_path / "cache"), "-q"]
    assert main(words) == 0
    (tmp_path / "interface.yaml").write_text("node: {name: driver}\n")
    assert main(words) == 1


def test_what_export_writes_agrees(drift, tmp_path, capsys):
    lines = (
        SCAN,
        "profile = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)",
        "self.create_subscription(Bool, '~/stop', print, profile)",
        "self.declare_parameter('speed', 0.5)",
        "self.declare_parameter('names', ['a', 'b'])",
    )
    drift("parameters: {}", *lines)
    assert main(["export", "--no-cache", "--format", "interface-yaml"]) == 0
    assert drift(capsys.readouterr().out, *lines) == []


@pytest.mark.parametrize("format", ["interface-yaml", "nodl"])
@pytest.mark.parametrize(
    "lines",
    [
        ("self.create_publisher(input(), 'scan', 10)",),
        ("import vendor_msgs.msg", "self.create_publisher(vendor_msgs.msg.KINDS[0], 'scan', 10)"),
        ("self.create_publisher(String, 'scan', input())",),
        ("self.create_publisher(String, 'scan', QoSProfile(depth=int(input())))",),
        ("self.create_publisher(String, 'scan', 10)", "self.create_publisher(Bool, 'scan', 10)"),
        ("self.create_publisher(String, 'scan', 10)", "self.create_publisher(String, 'scan', 5)"),
        ("from vendor.srv import KINDS", "self.create_service(KINDS[0], 'stop', print)"),
        ("self.declare_parameter('speed', input())",),
        ("self.declare_parameter('key', [b'a', b'b'])",),
    ],
    ids=" ".join,
)
def test_what_an_export_has_to_leave_out_is_not_missed(drift, tmp_path: Path, capsys, format, lines):
    """Beside a publisher that it declares, so that the committed file is about this node."""
    lines = ("self.create_publisher(Bool, 'alive', 10)", "self.declare_parameter('rate', 10)", *lines)
    (tmp_path / "package.xml").write_text("<package format='3'><name>robot</name></package>")
    (tmp_path / "setup.py").write_text(SETUP)
    drift("# nothing\nnode: {}", *lines)
    assert main(["export", "--no-cache", "--quiet", "--format", format]) == 0
    committed = capsys.readouterr().out
    assert "alive" in committed
    if format == "nodl":
        (tmp_path / "driver.nodl.xml").write_text(committed)
        assert drift("# nothing\nnode: {}", *lines) == []
        assert drift("# nothing\nnode: {}", *lines, NEW)
    else:
        assert drift(committed, *lines) == []
        assert drift(committed, *lines, NEW)


SETUP = """\
from setuptools import setup

setup(name="robot", py_modules=["driver"], entry_points={"console_scripts": ["driver = driver:main"]})
"""
NEW = "self.create_publisher(Bool, 'new', 10)"


def test_nodes_of_one_name_that_nodl_tells_apart_by_nothing(drift, tmp_path: Path):
    """Which of them the code here is, the file does not say."""
    node = '<node name="driver" executable="{}"><topic name="{}" type="std_msgs/msg/String" role="publisher" /></node>'
    for nodes in (("a", "scan"), ("b", "scan")), (("a", "left"), ("b", "right")):
        text = f'<interface version="1">{"".join(node.format(*each) for each in nodes)}</interface>'
        (tmp_path / "driver.nodl.xml").write_text(text)
        assert drift("# nothing\nnode: {}", SCAN) == []


SCAN_IN_NODL = '<topic name="scan" type="std_msgs/msg/String" role="publisher" />'


def test_nodl_that_agrees(nodl_drift):
    assert nodl_drift(SCAN_IN_NODL, SCAN) == []
    assert nodl_drift(f'{SCAN_IN_NODL}<parameter name="rate" type="integer" />', SCAN, RATE) == []


def test_nodl_that_says_otherwise(nodl_drift):
    assert nodl_drift(SCAN_IN_NODL.replace("String", "Bool"), SCAN) == [
        "driver.nodl.xml:2 the publisher 'scan' is declared as std_msgs/msg/Bool and created as std_msgs/msg/String"
    ]
    assert nodl_drift(SCAN_IN_NODL) == [
        "driver.nodl.xml:2 the publisher 'scan' of /driver is declared here and not in the code"
    ]
    assert nodl_drift('<parameter name="rate" type="double" />', RATE) == [
        "driver.nodl.xml:2 the parameter 'rate' has the type double here and int in the code"
    ]


def test_an_end_that_nodl_does_not_declare(nodl_drift):
    assert nodl_drift("", SCAN) == ["driver.py:10 the publisher 'scan' is not declared in driver.nodl.xml"]


def test_a_topic_of_both_roles(nodl_drift):
    both = SCAN_IN_NODL.replace("publisher", "both")
    assert nodl_drift(both, SCAN, "self.create_subscription(String, 'scan', print, 10)") == []
    assert nodl_drift(both, SCAN) == [
        "driver.nodl.xml:2 the subscription 'scan' of /driver is declared here and not in the code"
    ]


def test_nodl_that_declares_no_parameters_says_nothing_of_them(nodl_drift):
    assert nodl_drift(SCAN_IN_NODL, SCAN, RATE) == []


@pytest.mark.parametrize("text", ["", "<interface>", "<launch/>", "<!DOCTYPE a [<!ENTITY b 'c'>]><interface/>"])
def test_what_is_no_nodl(drift, tmp_path: Path, text: str):
    (tmp_path / "driver.nodl.xml").write_text(text)
    assert drift(SCAN_DECLARED, SCAN) == []


def test_nodl_as_it_is_exported(drift, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    copy = tmp_path / "lesson"
    shutil.copytree(Path(__file__).parents[2] / "fixtures" / "lesson", copy)
    monkeypatch.chdir(copy)
    declared = copy / "src" / "my_first_package" / "robot.nodl.xml"
    assert main(["export", "--isolated", "--quiet", "--format", "nodl", "-o", str(declared), "."]) == 0
    assert main(["check", "--isolated", "--quiet", "--select", "ARC004", "."]) == 0
    declared.write_text(declared.read_text().replace("SensorReading", "OtherReading"))
    assert main(["check", "--isolated", "--quiet", "--select", "ARC004", "."]) == 1


RATE = "self.declare_parameter('rate', 10)"
