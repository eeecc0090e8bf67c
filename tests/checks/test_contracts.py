"""OWN003 and ARC001 to ARC003."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from textwrap import dedent

import pytest

from archlint.architecture import matches
from archlint.checks.idle_contracts import idle_patterns
from archlint.cli import main
from archlint.config.options import options_for
from archlint.config.settings import ConfigurationError, load
from archlint.engine.judging import judge
from archlint.finding import Finding
from archlint.ros.qos import Qos
from archlint.systems.model import System, WorkspaceIndex
from archlint.systems.nodes import Node
from systems.builders import client, node, publisher, service, subscriber, system, unknown


@pytest.fixture
def findings(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)

    def find(code: str, config: str, found_in: System) -> list[Finding]:
        (tmp_path / "archlint.toml").write_text(dedent(config), encoding="utf-8")
        return list(judge(found_in, options_for(load(tmp_path), [code])))

    return find


ROBOT = system(
    node("/planner", publisher("cmd_vel"), client("enable"), package="planning"),
    node("/motor", subscriber("cmd_vel"), service("enable"), package="hardware"),
    node("/mux", subscriber("planned_vel"), package="control"),
)


@pytest.mark.parametrize(
    ("owners", "offenders"),
    [
        ('"/cmd_vel" = "/mux"', ["/planner"]),
        ('"/cmd_vel" = ["/mux", "/plan*"]', []),
        ('"/cmd_vel" = "package:planning"', []),
        ('"/*" = "/planner"', ["/motor"]),  # who serves /enable
        ('"/*" = "/nobody"\n"/cmd_vel" = "/planner"', ["/motor"]),  # the name itself counts before a glob
    ],
)
def test_owners(findings, owners: str, offenders: list[str]):
    assert [one.node for one in findings("OWN003", f"[owners]\n{owners}\n", ROBOT)] == offenders


def contract(**keys: str) -> str:
    lines = [f"{key.rstrip('_')} = {value}" for key, value in {"name": '"the rule"', **keys}.items()]
    return "[[contracts]]\n" + "\n".join(lines) + "\n"


def test_a_forbidden_connection_follows_the_data_and_the_request(findings):
    forbidden = contract(kind='"forbid"', from_='"/planner"', to='"/motor"')
    found = findings("ARC001", forbidden, ROBOT)
    assert [one.place.line for one in found] == [10, 11]  # the publisher and the client
    assert found[0].related[-1].place.file == "archlint.toml"
    assert findings("ARC001", contract(kind='"forbid"', from_='"/motor"', to='"/planner"'), ROBOT) == []


def test_groups_that_are_to_be_independent(findings):
    apart = contract(kind='"independent"', nodes='["package:planning", "package:hardware"]')
    assert len(findings("ARC001", apart, ROBOT)) == 2
    assert findings("ARC001", contract(kind='"independent"', nodes='["/planner", "/mux"]'), ROBOT) == []


def test_types_that_a_topic_may_have(findings):
    wrong = contract(kind='"types"', topic='"/cmd_vel"', types='["geometry_msgs/msg/Twist*"]')
    assert [one.node for one in findings("ARC001", wrong, ROBOT)] == ["/motor", "/planner"]
    assert findings("ARC001", contract(kind='"types"', topic='"/cmd_vel"', types='"std_msgs/*"'), ROBOT) == []


def test_types_of_a_service(findings):
    wrong = contract(kind='"types"', service='"enable"', types='"std_srvs/srv/SetBool"')
    assert {one.node for one in findings("ARC001", wrong, ROBOT)} == {"/motor", "/planner"}


def test_a_forbidden_connection_over_one_name_only(findings):
    forbidden = contract(kind='"forbid"', from_='"/planner"', to='"/motor"', service='"/enable"')
    assert [one.place.line for one in findings("ARC001", forbidden, ROBOT)] == [11]


ODOMETRY = system(
    node("/wheels", publisher("odom", qos=Qos(depth=5, reliability="best_effort", deadline=0.1))),
    node("/map", subscriber("odom", qos=Qos(depth=5, history="keep_all", durability="transient_local"))),
    node("/log", subscriber("odom", qos=Qos(depth=None, reliability="best_available", durability=None))),
    node("/any", subscriber("odom", qos=Qos(reliability="best_effort", parameter="reliability"))),
    node("/set", subscriber("odom", qos=Qos(reliability="best_effort", overridable=True))),
)


@pytest.mark.parametrize(
    ("policies", "offenders"),
    [
        ({"reliability": '"reliable"'}, ["/wheels"]),  # best_available and what a parameter decides are not known
        ({"reliability": '["reliable", "best_effort"]'}, []),
        ({"durability": '"volatile"'}, ["/map"]),
        ({"history": '"keep_last"'}, ["/map"]),
        ({"depth": "10"}, ["/wheels"]),  # keep_all has none, and one is not known
        ({"depth": "[5, 10]"}, []),
        ({"deadline": "0.1"}, ["/log", "/map"]),
        ({"deadline": "0.1", "publisher": '"*"'}, []),
        ({"deadline": "0.1", "subscriber": '"/map"'}, ["/map"]),
        ({"deadline": "[0, 0.1]"}, []),
        ({"lifespan": "1.0", "publisher": '"*"'}, ["/wheels"]),
        ({"liveliness": '"automatic"'}, []),
    ],
)
def test_the_qos_that_a_topic_may_have(findings, policies: dict[str, str], offenders: list[str]):
    wanted = contract(kind='"qos"', topic='"/odom"', **policies)
    assert [one.node for one in findings("ARC001", wanted, ODOMETRY)] == offenders


def test_qos_in_words(findings):
    wanted = contract(kind='"qos"', topic='"/odom"', deadline="0.5", publisher='"*"')
    [found] = findings("ARC001", wanted, ODOMETRY)
    assert found.message == "/wheels publishes '/odom' with deadline 0.1 s; the contract 'the rule' allows 0.5 s"
    assert found.related[0].place.file == "archlint.toml"


@pytest.mark.parametrize(
    ("pattern", "name", "meant"),
    [
        ("/left/motor", "/left/motor", True),
        ("/left/*", "/left/arm/motor", True),
        ("/motor", "/left/motor", False),
        ("motor", "/left/motor", True),
        ("motor", "/motor", True),
        ("arm/motor", "/left/arm/motor", True),
        ("motor", "/left_motor", False),
        ("*_motor", "/left_motor", True),
        ("package:dri*", "/motor", True),
        ("package:arm", "/motor", False),
    ],
)
def test_what_a_pattern_means(pattern: str, name: str, meant: bool):
    assert matches((pattern,), name, "drivers") is meant


LAYERS = """
    [layers]
    order = ["mission", "control", "hardware"]
    mission = ["/planner"]
    control = ["/mux"]
    hardware = ["/motor"]
"""


def test_layers_that_are_not_neighbours(findings):
    assert [one.place.line for one in findings("ARC002", LAYERS, ROBOT)] == [10, 11]
    assert findings("ARC002", LAYERS.replace('["/mux"]', '["/motor", "/mux"]'), ROBOT) == []


@pytest.mark.parametrize(
    ("keys", "missing"),
    [
        ({"from_": '"/planner"', "to": '"/motor"'}, None),
        ({"from_": '"/planner"', "to": '"/mux"'}, "there is no connection from /planner to /mux"),
        ({"from_": '"/brake"', "to": '"/motor"'}, "there is no node /brake to connect to /motor"),
        ({"topic": '"/cmd_vel"', "subscriber": '"/motor"'}, None),
        ({"topic": '"/stop"', "subscriber": '"/motor"'}, "/motor does not subscribe to /stop"),
        ({"topic": '"/stop"', "publisher": '"/planner"'}, "/planner does not publish /stop"),
        ({"topic": '"/stop"', "subscriber": '"/arm"'}, "there is no node /arm to subscribe to /stop"),
        ({"topic": '"/stop"', "subscriber": '"/m*"'}, "/motor and /mux do not subscribe to /stop"),
        ({"topic": '"/stop"', "subscriber": '"*"'}, "there is no node to subscribe to /stop"),
        ({"topic": '"/cmd_vel"', "subscriber": '"*"'}, None),
        ({"topic": '"*_vel"', "publisher": '"/planner"'}, "there is no node /planner to publish /planned_vel"),
        ({"service": '"/enable"', "server": '"/motor"', "client": '"*"'}, None),
        ({"service": '"/enable"', "server": '"/mux"'}, "/mux does not serve /enable"),
        ({"action": '"/move"', "server": '"*"'}, "there is no node to serve /move"),
        ({"from_": '"/planner"', "to": '"/motor"', "service": '"/enable"'}, None),
        (
            {"from_": '"/planner"', "to": '"/motor"', "service": '"/stop"'},
            "there is no connection from /planner to /motor over /stop",
        ),
        (
            {"topic": '"/cmd_vel"', "through": '"/mux"'},
            "/planner publishes '/cmd_vel' and /motor receives it without passing /mux",
        ),
        ({"topic": '"/cmd_vel"', "through": '"/motor"'}, None),
        ({"topic": '"/cmd_vel"', "through": '"/planner"'}, None),
        ({"topic": '"/scan"', "through": '"/mux"'}, None),
    ],
)
def test_a_connection_that_must_be(findings, keys: dict[str, str], missing: str | None):
    found = findings("ARC003", contract(kind='"require"', **keys), ROBOT)
    assert [one.message.partition(", which")[0] for one in found] == ([] if missing is None else [missing])
    assert all((one.place.file, one.place.line) == ("archlint.toml", 1) for one in found)


def test_an_unknown_name_may_be_the_missing_connection(findings):
    unclear = system(node("/motor", subscriber(unknown())), node("/button", publisher("stop")))
    required = contract(kind='"require"', topic='"/stop"', subscriber='"/motor"')
    assert findings("ARC003", required, unclear) == []


def test_a_node_outside_of_the_workspace_may_make_the_connection(findings):
    required = contract(kind='"require"', topic='"/stop"', subscriber='"/brake"')
    assert len(findings("ARC003", required, ROBOT)) == 1
    assert findings("ARC003", 'external = ["/brake"]\n' + required, ROBOT) == []


@pytest.mark.parametrize(
    ("config", "notices"),
    [
        (contract(kind='"forbid"', from_='"/planner"', to='"/motor"'), []),
        (
            contract(kind='"forbid"', from_='"/planer"', to='"package:hardwear"'),
            [
                "no node is called '/planer'; did you mean '/planner'?",
                "no node is of a package 'hardwear'; did you mean 'package:hardware'?",
            ],
        ),
        (contract(kind='"qos"', topic='"/enable"', depth="1"), ["no topic is called '/enable'"]),
        (contract(kind='"require"', topic='"/stop"', subscriber='"/arm"'), []),  # a finding of ARC003
        (LAYERS.replace("/mux", "/arm"), ["no node is called '/arm'"]),
        ("[owners]\n'/stop' = '/motor'\n", ["no topic or service or action is called '/stop'"]),
        ("external = ['/stop']\n[owners]\n'/stop' = '/motor'\n", []),
    ],
)  # fmt: skip
def test_what_matches_nothing_is_said(tmp_path: Path, config: str, notices: list[str]):
    (tmp_path / "archlint.toml").write_text(dedent(config), encoding="utf-8")
    options = options_for(load(tmp_path), ["ARC003"])["ARC003"]
    assert [one.partition("matches nothing: ")[2] for one in idle_patterns([ROBOT], options)] == notices


@pytest.mark.parametrize(
    ("config", "message"),
    [
        ('[[contracts]]\nname = "x"\n', "this contract has no `kind`"),
        (contract(kind='"forbidden"'), "must be one of forbid, require, independent, types, qos; did you mean forbid?"),
        (contract(kind='"forbid"', form='"/a"', to='"/b"'), "unknown key of a contract `form`; did you mean `from`?"),
        (contract(kind='"forbid"', to='"/b"'), "a contract of kind `forbid` has `from` and `to`"),
        ('contracts = "none"', "a list of tables"),
        ("[layers]\na = ['/a']\n", "`layers` needs `order`"),
        ("[layers]\norder = ['a', 'b']\na = ['/a']\n", "does not say which nodes are in `b`"),
        ("[layers]\norder = ['upper']\nupper = ['/a']\nuper = ['/b']\n", "did you mean `upper`?"),
        ("[layers]\norder = ['a', 'a']\na = ['/a']\n", "`order` has the layer `a` twice"),
        ("[owners]\n'/x' = 3\n", "`owners./x` must be a string or a list of strings, not a number"),
        ("[owners]\n'/x' = 'pkg:motor'\n", "a node's name, or `package:NAME` for the nodes of a package"),
        (contract(kind='"forbid"', from_='""', to='"/b"'), "`contracts.from` has an empty pattern"),
        (contract(kind='"types"', topic='"package:arm"', types='"x"'), "has 'package:arm'; a pattern is a name"),
        (contract(kind='"require"', service='"/x"', subscriber='"/y"'), "`service` with `server` or `client`"),
        (contract(kind='"require"', topic='"/x"'), "`topic` with `publisher` or `subscriber`"),
        (contract(kind='"independent"', nodes='"/x/*"'), "`contracts.nodes` must be a list of two groups or more"),
        (contract(kind='"qos"', topic='"/x"'), "`topic` with `history`, `reliability`, `durability`"),
        (contract(kind='"qos"', topic='"/x"', reliability='"Reliable"'), "did you mean reliable?"),
        (contract(kind='"qos"', topic='"/x"', depth='"5"'), "`contracts.depth` must be a number of messages"),
        (contract(kind='"qos"', topic='"/x"', deadline="-1"), "`contracts.deadline` must be a number of seconds"),
    ],
)
def test_a_mistake_in_the_configuration(findings, config: str, message: str):
    with pytest.raises(ConfigurationError) as error:
        findings("ARC001", config, ROBOT)
    assert message in str(error.value)


def test_the_mistake_is_shown_at_its_contract(findings):
    second = contract(kind='"forbid"', from_='"/a"', to='"/b"') + "\n" + contract(kind='"require"', to='"/b"')
    with pytest.raises(ConfigurationError) as error:
        findings("ARC001", second, ROBOT)
    assert error.value.line == 7


def test_the_mistake_is_shown_at_the_key_of_its_contract(findings):
    second = contract(kind='"forbid"', from_='"/a"', to='"/b"') + contract(kind='"forbid"', from_="3", to='"/b"')
    with pytest.raises(ConfigurationError) as error:
        findings("ARC001", second, ROBOT)
    assert error.value.line == 9


DRIVER = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import Empty


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.create_publisher(Empty, 'alive', 10)


rclpy.init()
rclpy.spin(Driver())
"""
MANIFEST = (
    '<package format="3"><name>drives</name><version>0.1.0</version><description>Drives.</description>'
    '<maintainer email="a@b.org">A</maintainer><license>MIT</license></package>'
)


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]):
    """Runs ``check`` over a package under a configuration: exit status, standard output, standard error."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "drives").mkdir()
    (tmp_path / "drives" / "package.xml").write_text(MANIFEST, encoding="utf-8")
    (tmp_path / "drives" / "driver.py").write_text(DRIVER, encoding="utf-8")

    def check(config: str, *paths: str) -> tuple[int, str, str]:
        (tmp_path / "archlint.toml").write_text(dedent(config), encoding="utf-8")
        status = main(["check", "--select", "ARC", "--no-cache", "--format", "concise", *paths])
        output = capsys.readouterr()
        return status, output.out, output.err

    return check


def test_a_contract_without_anything_to_look_at_warns(run):
    status, out, err = run(contract(kind='"forbid"', from_='"/driver"', to='"/motor"'))
    assert (status, out) == (0, "")
    assert "archlint.toml:1: the contract 'the rule' matches nothing: no node is called '/motor'" in err


def test_what_is_missing_is_missing_whatever_part_is_asked_for(run):
    required = contract(kind='"require"', from_='"/driver"', to='"/motor"')
    status, out, _ = run(required)
    assert status == 1
    assert run(required, "drives")[:2] == (status, out)


def test_a_part_of_the_workspace_cannot_show_what_is_missing(run, tmp_path: Path):
    """Two packages of one name are two workspaces: of each only itself is known."""
    (tmp_path / "second").mkdir()
    (tmp_path / "second" / "package.xml").write_text(MANIFEST, encoding="utf-8")
    required = contract(kind='"require"', from_='"/driver"', to='"/motor"')
    status, out, err = run(required, "drives")
    assert (status, out) == (0, "") and "matches nothing" not in err


def test_a_mistaken_contract_ends_the_run(run):
    status, out, err = run(contract(kind='"forbid"', from_='"/driver"', two='"/motor"'))
    assert (status, out) == (2, "")
    assert "archlint.toml:5: unknown key of a contract `two`; did you mean `to`?" in err


# ------------------------------------------------------------------------------------------------ launch files


def launched(*nodes: Node, closed: bool = False) -> tuple[System, System]:
    """The system of all nodes of ``ROBOT``, and one of a launch file that starts these."""
    every = [system(*ROBOT.nodes), system(*nodes, name="robot.launch.py", closed=closed)]
    opened, started = WorkspaceIndex(systems=every).systems
    return opened, started


PART = (node("/planner", publisher("cmd_vel")),)
TWO_ROBOTS = tuple(
    one
    for robot in ("/left", "/right")
    for one in (node(f"{robot}/planner", publisher("cmd_vel")), node(f"{robot}/motor", subscriber("cmd_vel")))
)


@pytest.mark.parametrize(
    ("closed", "expected"), [(False, []), (True, ["there is no connection from /planner to /brake"])]
)
def test_a_launch_file_that_starts_a_part(findings, closed: bool, expected: list[str]):
    required = contract(kind='"require"', from_='"/planner"', to='"/brake"')
    _, started = launched(*PART, closed=closed)
    assert [one.message.partition(",")[0] for one in findings("ARC003", required, started)] == expected


def test_each_robot_of_a_launch_file_is_held_to_a_contract(findings):
    forbidden = contract(kind='"forbid"', from_='"planner"', to='"motor"')
    _, started = launched(*TWO_ROBOTS)
    assert [one.node for one in findings("ARC001", forbidden, started)] == ["/left/planner", "/right/planner"]
    apart = contract(kind='"independent"', nodes='["/left/*", "/right/*"]')
    assert findings("ARC001", apart, started) == []
    stopped = contract(kind='"require"', topic='"/*/cmd_vel"', subscriber='"/*/motor"')
    assert findings("ARC003", stopped, started) == []
    deaf = (*TWO_ROBOTS[:3], node("/right/motor"))
    _, started = launched(*deaf)
    [found] = findings("ARC003", stopped, started)
    assert found.message.startswith("/right/motor does not subscribe to /*/cmd_vel")


def test_names_that_only_the_nodes_have_before_they_are_launched(findings):
    opened, _ = launched(*TWO_ROBOTS)
    pair = frozenset((node.blueprint.place, node.blueprint.class_name) for node in opened.nodes[:2] if node.blueprint)
    opened = replace(opened, launched_pairs=frozenset({pair}))
    forbidden = contract(kind='"forbid"', from_='"/planner"', to='"/motor"')
    assert len(findings("ARC001", forbidden, opened)) == 2  # no launch file has nodes of these names
    anywhere = contract(kind='"forbid"', from_='"planner"', to='"motor"')
    assert findings("ARC001", anywhere, opened) == []  # the launch file's own system says it
