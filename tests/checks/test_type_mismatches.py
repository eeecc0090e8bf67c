from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from archlint.checks.registry import Options
from archlint.checks.type_mismatches import action_type_mismatch, service_type_mismatch, topic_type_mismatch
from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Finding, Severity
from archlint.model import UnknownInterface
from archlint.systems.model import System
from robot_package import SETUP, write_robot
from robot_package import node as node_xml
from systems.builders import (
    action_client,
    action_server,
    client,
    node,
    place,
    programs,
    publisher,
    service,
    subscriber,
    system,
)

Rule = Callable[[System, Options], Iterator[Finding]]


def found(rule: Rule, judged: System) -> list[Finding]:
    return list(rule(judged, Options(own={"separate": True})))


@pytest.mark.parametrize(
    ("rule", "provider", "user", "kind"),
    [
        (topic_type_mismatch, publisher, subscriber, "msg"),
        (service_type_mismatch, service, client, "srv"),
        (action_type_mismatch, action_server, action_client, "action"),
    ],
    ids=["topic", "service", "action"],
)
class TestTheTwoEnds:
    def test_of_two_types(self, rule: Rule, provider: Callable, user: Callable, kind: str):
        judged = system(node("/a", provider("x", f"p/{kind}/One")), node("/b", user("x", f"p/{kind}/Two")))

        [finding] = found(rule, judged)

        assert finding.node == "/b"
        assert [related.place.file for related in finding.related] == ["src/demo/demo/a.py"]
        assert f"p/{kind}/One" in finding.message
        assert f"p/{kind}/Two" in finding.message

    def test_of_a_type_that_its_package_does_not_define(
        self, rule: Rule, provider: Callable, user: Callable, kind: str
    ):
        one = node("/a", provider("x", f"p/{kind}/One"))
        other = node("/b", user("x", f"p/{kind}/Two"))
        judged = replace(system(one, other), programs=programs(*one.blueprints, *other.blueprints))
        judged.programs[0].unknown_interfaces.append(UnknownInterface(place("b.py", 1), "p", kind, "Two"))

        assert found(rule, judged) == []

    def test_of_one_type(self, rule: Rule, provider: Callable, user: Callable, kind: str):
        judged = system(node("/a", provider("x", f"p/{kind}/One")), node("/b", user("x", f"p/{kind}/One")))

        assert found(rule, judged) == []

    def test_of_which_one_is_not_known(self, rule: Rule, provider: Callable, user: Callable, kind: str):
        judged = system(node("/a", provider("x", f"p/{kind}/One")), node("/b", user("x", None)))

        assert found(rule, judged) == []

    def test_of_two_names(self, rule: Rule, provider: Callable, user: Callable, kind: str):
        judged = system(node("/a", provider("x", f"p/{kind}/One")), node("/b", user("y", f"p/{kind}/Two")))

        assert found(rule, judged) == []

    def test_within_one_node(self, rule: Rule, provider: Callable, user: Callable, kind: str):
        judged = system(node("/a", provider("x", f"p/{kind}/One"), user("x", f"p/{kind}/Two")))

        assert len(found(rule, judged)) == 1

    def test_in_packages_that_do_not_meet(self, rule: Rule, provider: Callable, user: Callable, kind: str):
        judged = system(
            node("/a", provider("x", f"p/{kind}/One")),
            node("/b", user("x", f"p/{kind}/Two"), package="other"),
        )

        assert found(rule, judged) == []


@pytest.mark.parametrize("end", [publisher, subscriber])
def test_one_node_that_uses_several_types_is_one_finding(end):
    other = {publisher: subscriber, subscriber: publisher}[end]
    bridge = node("/bridge", end("x", "p/msg/One"), end("x", "p/msg/Two"), end("x", "p/msg/Three"))
    [alone] = found(topic_type_mismatch, system(bridge))
    assert alone.severity is Severity.WARNING and len(alone.related) == 2
    assert "x' as p/msg/One, p/msg/Two and p/msg/Three: within one process Fast DDS" in alone.message

    fitting = node("/driver", other("x", "p/msg/Two"))
    assert found(topic_type_mismatch, system(bridge, fitting)) == [alone]
    wrong = node("/driver", other("x", "p/msg/Four"))
    assert {one.severity for one in found(topic_type_mismatch, system(bridge, wrong))} == {
        Severity.WARNING,
        Severity.ERROR,
    }
    same = node("/bridge", end("x", "p/msg/One"), end("x", "p/msg/One"))
    assert found(topic_type_mismatch, system(same)) == []


def test_lessons_that_nothing_starts_together_and_that_have_partners_of_their_own():
    talker, listener = node("/talker", publisher("x", "p/msg/One")), node("/listener", subscriber("x", "p/msg/One"))
    spheres = node("/spheres", publisher("x", "p/msg/Two"))

    [finding] = found(topic_type_mismatch, system(talker, listener, spheres))
    assert finding.severity is Severity.INFO
    assert finding.message.endswith("if they run together: no launch file here starts both by default")

    [launched] = found(topic_type_mismatch, system(talker, listener, spheres, name="launch/all.launch.py"))
    [closed] = found(topic_type_mismatch, system(talker, listener, spheres, closed=True))
    [lonely] = found(topic_type_mismatch, system(listener, spheres))
    assert {launched.severity, closed.severity, lonely.severity} == {Severity.ERROR}


def test_the_package_belongs_to_the_type():
    judged = system(
        node("/a", publisher("x", "std_msgs/msg/Int32")), node("/b", subscriber("x", "example_interfaces/msg/Int32"))
    )

    assert len(found(topic_type_mismatch, judged)) == 1


def test_one_publisher_against_many_is_one_finding():
    wrong = node("/a", publisher("x", "p/msg/One"))
    right = [node(f"/b{number}", subscriber("x", "p/msg/Two")) for number in range(3)]

    [finding] = found(topic_type_mismatch, system(wrong, *right))

    assert len(finding.related) == 3


def test_the_subscription_that_disagrees_with_the_publisher_is_told():
    source = node("/a", publisher("x", "p/msg/One"))
    wrong, right = node("/b", subscriber("x", "p/msg/Two")), node("/c", subscriber("x", "p/msg/One"))

    [finding] = found(topic_type_mismatch, system(source, wrong, right, name="launch/all.launch.py"))

    assert finding.message.startswith("/b subscribes to '/x' as p/msg/Two, but /a publishes it as p/msg/One")
    assert [related.message.split()[0] for related in finding.related] == ["/a", "/c"]


@pytest.mark.parametrize(
    ("name", "shared", "expected"),
    [("x_raw", True, Severity.INFO), ("x_other", True, Severity.ERROR), ("x_raw", False, Severity.ERROR)],
    ids=["it works", "nobody publishes there", "another callback"],
)
def test_a_node_that_tries_two_names_with_one_callback(name: str, shared: bool, expected: Severity):
    source = node("/a", publisher("x", "p/msg/One"), publisher("x_raw", "p/msg/Two"))
    judged = system(
        source, node("/b", subscriber("x", "p/msg/Two"), subscriber(name, "p/msg/Two")), name="all.launch.py"
    )
    first, second = [end.creation for end in judged.endpoints if end.node.name == "/b"]
    if shared:
        second.callbacks = first.callbacks

    [finding] = found(topic_type_mismatch, judged)

    assert finding.severity is expected
    assert (finding.help or "").startswith("remove this subscription") is (expected is Severity.INFO)


@pytest.mark.parametrize(
    ("written", "launched_by", "count"), [("x", None, 0), ("x", "all.launch.py", 1), ("/x", None, 1)]
)
def test_an_absolute_and_a_relative_name_of_one_node(written: str, launched_by: str | None, count: int):
    """A converter is given a namespace, so that what it reads is not what it sends: a launch file decides."""
    ends = publisher("/x", "p/msg/One"), subscriber(written, "p/msg/Two")

    assert len(found(topic_type_mismatch, system(node("/a", *ends, launched_by=launched_by)))) == count


def test_an_end_that_has_a_partner_of_its_type_is_not_what_is_wrong():
    """A bridge is given the wrong type, and another one in the same launch file the right one."""
    wrong = node("/bridge", subscriber("x", "p/msg/Two"), publisher("x", "p/msg/Two"))
    right, source = node("/other", subscriber("x", "p/msg/One")), node("/z", publisher("x", "p/msg/One"))

    [finding] = found(topic_type_mismatch, system(wrong, right, source, name="launch/all.launch.py"))

    assert finding.node == "/bridge"
    assert finding.message.startswith("/bridge publishes '/x' as p/msg/Two, but /other subscribes to it as p/msg/One")


def test_arms_of_one_branch_are_never_both_there():
    judged = system(
        node(
            "/a",
            publisher("x", "p/msg/One", conditional=True, branch_arms=frozenset({("a.py:9", 0)})),
            publisher("x", "p/msg/Two", conditional=True, branch_arms=frozenset({("a.py:9", 1)})),
        )
    )

    assert found(topic_type_mismatch, judged) == []


def test_an_endpoint_that_may_be_there_is_wrong_whenever_it_is():
    sure, perhaps = publisher("x", "p/msg/One"), subscriber("x", "p/msg/Two", conditional=True)

    assert len(found(topic_type_mismatch, system(node("/a", sure), node("/b", perhaps)))) == 1


def test_a_branch_may_choose_the_type_that_fits():
    arms = [frozenset({("b.py:9", arm)}) for arm in (0, 1)]
    choice = node(
        "/b",
        subscriber("x", "p/msg/Two", conditional=True, branch_arms=arms[0]),
        subscriber("x", "p/msg/One", conditional=True, branch_arms=arms[1]),
    )

    assert found(topic_type_mismatch, system(node("/a", publisher("x", "p/msg/One")), choice)) == []


def test_an_end_that_is_destroyed_where_a_parameter_makes_another():
    first = publisher("x", "p/msg/One", destroyed=True)
    later = publisher("x", "p/msg/Two", conditional=True)
    agreeing, other = (node("/b", subscriber("x", f"p/msg/{name}")) for name in ("One", "Three"))

    assert not found(topic_type_mismatch, system(node("/a", first, later), agreeing))
    assert found(topic_type_mismatch, system(node("/a", first, later), other))


def test_two_endpoints_that_may_not_be_there_prove_nothing():
    one = node("/a", publisher("x", "p/msg/One", conditional=True))
    other = node("/b", subscriber("x", "p/msg/Two", conditional=True))

    assert found(topic_type_mismatch, system(one, other)) == []


MONITOR = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import Bool, String

class {name}(Node):
    def __init__(self):
        super().__init__('{name}'.lower())
        {create}

def main():
    rclpy.init()
    rclpy.spin({name}())
"""
PUBLISH = "self.create_publisher({}, 'stop', 10)"
LISTEN = "self.create_subscription(Bool, 'stop', print, 10)"


@pytest.mark.parametrize(
    ("launched", "severities"),
    [
        ("talker", ["error", "info"]),  # the other launch file starts a pair of its own
        ("", ["error", "error"]),  # no launch file says what it runs with
    ],
)
def test_two_nodes_of_which_each_has_its_launch_file(tmp_path: Path, monkeypatch, launched: str, severities: list[str]):
    monkeypatch.chdir(tmp_path)
    names = {"talker": ("Talker", PUBLISH.format("String")), "right": ("Right", PUBLISH.format("String"))}
    names["drive"] = ("Drive", LISTEN)
    files = {f"robot/{file}.py": MONITOR.format(name=n, create=c) for file, (n, c) in names.items()}
    entries = ", ".join(f"'{file} = robot.{file}:main'" for file in names)
    files["setup.py"] = SETUP.replace("'talker = robot.talker:main'", entries)
    files["launch/drive.launch.xml"] = f"<launch>{node_xml(exec='right')}{node_xml(exec='drive')}</launch>"
    files["archlint.toml"] = 'select = ["TOP001"]'
    write_robot(tmp_path, node_xml(exec=launched) if launched else "", **files)
    told = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert [one.severity.label for one in told] == severities


FILTER = """import time

import rclpy
from rclpy.node import Node


class Filter(Node):
    def __init__(self, type_):
        super().__init__('filter_' + str(time.time_ns()))
        self.subscription = self.create_subscription(type_, '/in', print, 10)
"""
START = """import rclpy
from std_msgs.msg import Int32, String
from robot.filter import Filter


def main():
    rclpy.init()
    rclpy.spin(Filter({}))
"""


def test_a_class_that_each_program_gives_another_type(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    both = START.replace("rclpy.spin(Filter({}))", "nodes = [Filter(String), Filter(Int32)]\n    rclpy.spin(nodes[0])")
    setup = SETUP.replace("'talker = robot.talker:main'", "'texts = robot.texts:main', 'numbers = robot.numbers:main'")
    monkeypatch.chdir(tmp_path)

    def places(texts: str) -> list[str]:
        programs = {"robot/texts.py": texts, "robot/numbers.py": START.format("Int32"), "robot/filter.py": FILTER}
        write_robot(tmp_path, **programs, **{"setup.py": setup, "archlint.toml": 'select = ["TOP001"]'})
        findings = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
        return [finding.place.file for finding in findings]

    assert places(START.format("String")) == []
    assert places(both) == ["robot/filter.py"]


LISTENERS = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import Int32, String


class Planner(Node):
    def __init__(self):
        super().__init__("planner")
        self.plans = self.create_publisher(Int32, "/plan", 10)


class Listener(Node):
    def __init__(self, name):
        super().__init__(f"listener_{name}")
        prefix = "/" + name if name != "" else ""
        self.create_subscription(String, prefix + "/plan", print, 10)


def main():
    rclpy.init()
    executor = rclpy.executors.SingleThreadedExecutor()
    for node in [Planner(), *(Listener(NAME) for number in range(int(input())))]:
        executor.add_node(node)
    executor.spin()
"""


@pytest.mark.parametrize(("name", "told"), [('f"robot{number}"', 0), ('""', 1)])
def test_a_prefix_that_no_name_leaves_out(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, told: int):
    monkeypatch.chdir(tmp_path)
    files = {"robot/talker.py": LISTENERS.replace("NAME", name), "archlint.toml": 'select = ["TOP001"]'}
    write_robot(tmp_path, **files)
    assert len(check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings) == told


def test_what_each_has_a_partner_for_is_for_those_who_ask():
    talker, listener = node("/talker", publisher("x", "p/msg/One")), node("/listener", subscriber("x", "p/msg/One"))
    spheres = node("/spheres", publisher("x", "p/msg/Two"))
    others = [node(f"/part{number}") for number in range(6)]
    quiet = Options(own={"separate": False})

    assert list(topic_type_mismatch(system(talker, listener, spheres, *others), quiet)) == []
    [launched] = topic_type_mismatch(system(talker, listener, spheres, *others, name="launch/all.launch.py"), quiet)
    assert launched.severity is Severity.ERROR


def test_a_service_of_which_each_client_has_a_server_of_its_own():
    wave, waver = node("/wave", service("x", "p/srv/One")), node("/waver", client("x", "p/srv/One"))
    nod, nodder = node("/nod", service("x", "p/srv/Two")), node("/nodder", client("x", "p/srv/Two"))

    [mild] = found(service_type_mismatch, system(wave, waver, nod, nodder))
    assert mild.severity is Severity.INFO
    assert mild.message.endswith("if they run together: no launch file here starts both by default")
    [alone] = found(service_type_mismatch, system(wave, waver, nodder))
    assert alone.severity is Severity.ERROR
    [launched] = found(service_type_mismatch, system(wave, waver, nod, nodder, name="launch/all.launch.py"))
    assert launched.severity is Severity.ERROR


def test_publishers_to_whom_nobody_listens():
    one, two = node("/one", publisher("x", "p/msg/One")), node("/two", publisher("x", "p/msg/Two"))
    listener = node("/listener", subscriber("x", "p/msg/One"))

    assert found(topic_type_mismatch, system(one, two, name="launch/all.launch.py")) == []
    assert len(found(topic_type_mismatch, system(one, two, listener, name="launch/all.launch.py"))) == 1


STEPS = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import Bool, Int16, String

class {kind}(Node):
    def __init__(self):
        super().__init__('{name}')
{lines}

def main():
    rclpy.init()
    rclpy.spin({kind}())
"""
SAYS = "        self.end = self.create_publisher(Int16, '/horn', 10)"
HEARS = "        self.end = self.create_subscription({type}, '/horn', print, 10)"


def _of_programs(root: Path, **sources: str) -> list[Finding]:
    """What TOP001 finds in a package with these programs."""
    scripts = ", ".join(f"'{name} = robot.{name}:main'" for name in sources)
    setup = SETUP.replace("'talker = robot.talker:main'", scripts)
    files = {f"robot/{name}.py": text for name, text in sources.items()}
    write_robot(root, **{"setup.py": setup, "archlint.toml": 'select = ["TOP001"]', **files})
    return check(Request((".",), load(root), cached=False, jobs=1)).findings


@pytest.mark.parametrize(("distro", "told"), [("Foxy", 0), ("Humble", 1)])
def test_foxy_accepts_several_types_in_one_process(tmp_path: Path, monkeypatch, distro: str, told: int):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "README.md").write_text(f"For ROS 2 {distro}.\n", encoding="utf-8")
    lines = "\n".join(HEARS.format(type=kind) for kind in ("Int16", "String"))
    assert len(_of_programs(tmp_path, both=STEPS.format(kind="Both", name="both", lines=lines))) == told


@pytest.mark.parametrize(("name", "severity"), [("listener", Severity.INFO), ("other", Severity.ERROR)])
def test_of_two_nodes_with_one_name_one_runs(tmp_path: Path, monkeypatch, name: str, severity: Severity):
    """The first step of a lesson hears a String, the second under the same name what the driver says."""
    monkeypatch.chdir(tmp_path)
    steps = {
        "driver": STEPS.format(kind="Driver", name="driver", lines=SAYS),
        "first": STEPS.format(kind="Listener", name="listener", lines=HEARS.format(type="String")),
        "second": STEPS.format(kind="Listener", name=name, lines=HEARS.format(type="Int16")),
    }
    (finding,) = _of_programs(tmp_path, **steps)
    assert finding.severity is severity


@pytest.mark.parametrize("count", [1, 2, 3])
def test_the_topics_of_a_loop_are_one_finding(tmp_path: Path, monkeypatch, count: int):
    monkeypatch.chdir(tmp_path)
    loop = f"        for i in range({count}):\n            self.create_publisher(Int16, f'/horn_{{i}}', 10)"
    ears = "\n".join(f"        self.create_subscription(Bool, '/horn_{number}', print, 10)" for number in range(count))
    programs = {
        "driver": STEPS.format(kind="Driver", name="driver", lines=ears),
        "horn": STEPS.format(kind="Horn", name="horn", lines=loop),
    }
    (finding,) = _of_programs(tmp_path, **programs)
    told = {
        1: "",
        2: "; so it is with another topic of that line: '/horn_1'",
        3: "; so it is with 2 more topics of that line: '/horn_1', '/horn_2'",
    }
    assert finding.place.file == "robot/horn.py"
    assert finding.message == (
        "/horn publishes '/horn_0' as std_msgs/msg/Int16, but /driver subscribes to it as std_msgs/msg/Bool: they are "
        f"never connected{told[count]}"
    )


@pytest.mark.parametrize(("others", "told"), [(("driver",), 0), (("driver", "old_horn"), 1)])
def test_a_module_that_no_entry_point_starts(tmp_path: Path, monkeypatch, others: tuple[str, ...], told: int):
    """A launch file has it in a comment, and nothing else starts it beside the driver."""
    monkeypatch.chdir(tmp_path)
    driver = STEPS.format(kind="Driver", name="driver", lines=SAYS)
    horn = STEPS.format(kind="Horn", name="horn", lines=HEARS.format(type="String")) + "\n\nmain()\n"
    scripts = ", ".join(f"'{name} = robot.{name}:main'" for name in others)
    setup = SETUP.replace("'talker = robot.talker:main'", scripts)
    launch = node_xml(exec="driver") + "<!-- " + node_xml(exec="old_horn") + " -->"
    files = {"setup.py": setup, "archlint.toml": 'select = ["TOP001"]', "robot/driver.py": driver}
    write_robot(tmp_path, launch, **{"robot/old_horn.py": horn, **files})
    assert len(check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings) == told


CAMERA = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import Bool, Int16, String


class Camera(Node):
    def __init__(self):
        super().__init__('camera')
        self.create_subscription(String, self.text('settings', '/horn'), print, 10)

    def text(self, name, default):
        self.declare_parameter(name, default)
        try:
            found = self.get_parameter(name).get_parameter_value().string_value
        except Exception:
            found = default
        return found


def main():
    rclpy.init()
    rclpy.spin(Camera())
"""


@pytest.mark.parametrize(
    ("given", "told"),
    [(["/texts", "/words"], 0), (["/texts", "/horn"], 1), (["/texts", ""], 1)],
    ids=["each launch file gives another name", "one gives the default", "one gives none"],
)
def test_a_default_that_launch_files_replace(tmp_path: Path, monkeypatch, given: list[str], told: int):
    """The code would go back to it if it could not read its own parameter."""
    monkeypatch.chdir(tmp_path)
    scripts = "'driver = robot.driver:main', 'camera = robot.camera:main'"
    files = {
        "setup.py": SETUP.replace("'talker = robot.talker:main'", scripts),
        "archlint.toml": 'select = ["TOP001"]',
        "robot/driver.py": STEPS.format(kind="Driver", name="driver", lines=SAYS),
        "robot/camera.py": CAMERA,
    }
    for number, name in enumerate(given):
        parameter = f'<param name="settings" value="{name}"/>' if name else ""
        node = f'<node pkg="robot" exec="camera">{parameter}</node>'
        files[f"launch/number{number}.launch.xml"] = f"<launch>{node}</launch>"
    write_robot(tmp_path, **files)
    assert len(check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings) == told
