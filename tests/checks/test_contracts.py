"""OWN003 and ARC001 to ARC003."""

from __future__ import annotations

from pathlib import Path
from textwrap import dedent

import pytest

from archlint.checks.registry import judge, options_for
from archlint.config import ConfigurationError, load
from archlint.finding import Finding
from archlint.system.model import System
from system.builders import client, node, publisher, service, subscriber, system, unknown


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
        ({"from_": '"/planner"', "to": '"/mux"'}, "nothing goes from /planner to /mux"),
        ({"from_": '"/brake"', "to": '"/motor"'}, "there is no node /brake to connect to /motor"),
        ({"topic": '"/cmd_vel"', "subscriber": '"/motor"'}, None),
        ({"topic": '"/stop"', "subscriber": '"/motor"'}, "/motor does not subscribe to /stop"),
        ({"topic": '"/stop"', "publisher": '"/planner"'}, "/planner does not publish /stop"),
        ({"topic": '"/stop"', "subscriber": '"/arm"'}, "there is no node /arm to subscribe to /stop"),
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


@pytest.mark.parametrize(
    ("config", "message"),
    [
        ('[[contracts]]\nname = "x"\n', "this contract has no `kind`"),
        (contract(kind='"forbidden"'), "must be one of forbid, require, independent, types; did you mean forbid?"),
        (contract(kind='"forbid"', form='"/a"', to='"/b"'), "unknown key of a contract `form`; did you mean `from`?"),
        (contract(kind='"forbid"', to='"/b"'), "a contract of kind `forbid` has `from` and `to`"),
        ('contracts = "none"', "a list of tables"),
        ("[layers]\na = ['/a']\n", "`layers` needs `order`"),
        ("[layers]\norder = ['a', 'b']\na = ['/a']\n", "does not say which nodes are in `b`"),
        ("[layers]\norder = ['upper']\nupper = ['/a']\nuper = ['/b']\n", "did you mean `upper`?"),
        ("[owners]\n'/x' = 3\n", "`owners./x` must be a list of strings, not a number"),
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
