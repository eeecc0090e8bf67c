"""Launch arguments that nothing decides make several systems of one launch file."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest

from archlint.cli import main
from archlint.finding import Place
from archlint.launch.model import DeclaredArgument, Launched
from archlint.model import Text
from archlint.systems.variants import MOST, condition, other_choices, undecided_arguments

FIXTURE = Path(__file__).parents[2] / "fixtures" / "alternatives"
LAUNCH_FILE = "src/base/launch/base.launch.py"


def test_each_combination_of_values_is_a_system():
    launched = Launched("a.launch.py", None, undecided={"sim": ["true", "false"], "mode": ["slow", "fast"]})

    assert undecided_arguments(launched) == [
        {"mode": "slow", "sim": "true"},
        {"mode": "slow", "sim": "false"},
        {"mode": "fast", "sim": "true"},
        {"mode": "fast", "sim": "false"},
    ]


def test_what_an_argument_may_be_besides_the_one_value_asked_for_is_not_made_up():
    assert undecided_arguments(Launched("a.launch.py", None, undecided={"mode": ["slow"]})) == []


def test_declared_choices_are_the_values():
    declared = DeclaredArgument("mode", None, Place("a.launch.py", 1, 1, 1, 1), "a.launch.py", ("slow", "fast", "off"))
    launched = Launched("a.launch.py", None, declared=[declared], undecided={"mode": ["slow"]})

    assert [one["mode"] for one in undecided_arguments(launched)] == ["slow", "fast", "off"]


def test_the_number_of_systems_is_bounded():
    launched = Launched("a.launch.py", None, undecided={f"a{n}": ["true", "false"] for n in range(20)})

    assert len(undecided_arguments(launched)) == MOST


EVERY = [{"sim": sim, "mode": mode} for sim in ("true", "false") for mode in ("slow", "fast")]


@pytest.mark.parametrize(
    ("holding", "said"),
    [
        (EVERY, None),
        (EVERY[:2], "sim:=true"),
        ([EVERY[0], EVERY[2]], "mode:=slow"),
        ([EVERY[3]], "mode:=fast sim:=false"),
        (EVERY[:3], "mode:=slow"),
    ],
    ids=["always", "one argument", "the other argument", "both arguments", "one of two conditions"],
)
def test_a_condition_names_the_fewest_arguments(holding: list[dict[str, str]], said: str | None):
    assert condition(holding, EVERY) == said


def test_a_finding_says_under_which_arguments_it_holds(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
):
    monkeypatch.chdir(FIXTURE)

    main(["check", "--no-cache", "--format", "json", "--launch", LAUNCH_FILE])

    found = {one["code"]: one for one in json.loads(capsys.readouterr().out)["diagnostics"]}
    assert {code: one["condition"] for code, one in found.items()} == {
        "TOP001": "simulated:=true",
        "TOP003": "simulated:=true",
    }
    assert all(one["message"].endswith("(with simulated:=true)") for one in found.values())


def test_a_given_argument_decides(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]):
    monkeypatch.chdir(FIXTURE)

    main(["check", "--no-cache", "--format", "json", "--launch", LAUNCH_FILE, "simulated:=true"])
    simulated = json.loads(capsys.readouterr().out)["diagnostics"]
    main(["check", "--no-cache", "--format", "json", "--launch", LAUNCH_FILE, "simulated:=false"])
    real = json.loads(capsys.readouterr().out)["diagnostics"]

    assert [(one["code"], one["condition"]) for one in simulated] == [("TOP003", None), ("TOP001", None)]
    assert real == []


def test_a_cached_run_says_the_same(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
):
    shutil.copytree(FIXTURE / "src", tmp_path / "src")
    monkeypatch.chdir(tmp_path)
    command = ["check", "--format", "concise", "--launch", LAUNCH_FILE]

    main(command)
    cold = capsys.readouterr().out
    main(command)

    assert "(with simulated:=true)" in cold
    assert capsys.readouterr().out == cold


def test_the_graph_shows_both_and_says_when(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]):
    monkeypatch.chdir(FIXTURE)

    main(["graph", "--no-cache", "--format", "json", "--launch", LAUNCH_FILE])

    nodes = json.loads(capsys.readouterr().out)["nodes"]
    assert {node["name"]: node["condition"] for node in nodes} == {
        "/driver": "simulated:=false",
        "/monitor": None,
        "/simulation": "simulated:=true",
    }


def test_one_mistake_is_told_once_however_many_arguments_take_part(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
):
    shutil.copytree(FIXTURE / "src", tmp_path / "src")
    monkeypatch.chdir(tmp_path)
    (tmp_path / LAUNCH_FILE).write_text(
        "from launch import LaunchDescription\n"
        "from launch.conditions import IfCondition\n"
        "from launch.substitutions import LaunchConfiguration\n"
        "from launch_ros.actions import Node\n\n\n"
        "def generate_launch_description():\n"
        "    return LaunchDescription([\n"
        "        Node(package='base', executable='driver', name=name,\n"
        "             condition=IfCondition(LaunchConfiguration(name)))\n"
        "        for name in ('front', 'middle', 'rear')\n"
        "    ])\n"
    )
    driver = tmp_path / "src/base/base/driver.py"
    says = ("odometry.publish(Odometry())", "battery.publish(BatteryState())")
    timers = "".join(f"        self.create_timer(0.1, lambda: self.{said})\n" for said in says)
    driver.write_text(driver.read_text().replace("\n\ndef main", f"{timers}\n\ndef main", 1))

    main(["check", "--no-cache", "--select", "OWN001", "--format", "json", "--launch", LAUNCH_FILE])

    found = json.loads(capsys.readouterr().out)["diagnostics"]
    assert [(one["line"], one["condition"]) for one in found] == [(10, "front:=true middle:=true rear:=true")]
    assert "/front, /middle and /rear all publish the topics " in found[0]["message"]


def test_another_choice_of_an_argument_is_tried_beside_its_default():
    place = Place("a.launch.py", 1, 1, 1, 1)
    role = DeclaredArgument("role", Text("scout", "exact"), place, "a.launch.py", ("scout", "leader", "guard"))
    sim = DeclaredArgument("sim", Text("true", "exact"), place, "a.launch.py", ("true", "false"))
    required = DeclaredArgument("map", None, place, "a.launch.py", ("hall", "yard"))
    included = DeclaredArgument("gui", Text("on", "exact"), place, "b.launch.py", ("on", "off"))
    unread = DeclaredArgument("log", Text("all", "exact"), place, "a.launch.py", ("all", "few"))
    read = {"role", "sim", "map", "gui"}
    launched = Launched("a.launch.py", None, declared=[role, sim, required, included, unread], read=read)

    assert other_choices(launched) == (
        {"role": "scout", "sim": "true"},
        [
            {"role": "leader", "sim": "true"},
            {"role": "guard", "sim": "true"},
            {"role": "scout", "sim": "false"},
        ],
    )


BY_ROLE = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def start(context):
    if LaunchConfiguration('role').perform(context) == 'leader':
        return [Node(package='base', executable='driver', name='{leader}'){more}]
    return [Node(package='base', executable='driver', name='front')]


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('role', default_value='scout'{choices}),
        OpaqueFunction(function=start),
        Node(package='base', executable='driver', name='rear'),
    ])
"""
CHOICES = ", choices=['scout', 'leader']"


@pytest.mark.parametrize(
    ("leader", "more", "choices", "conditions"),
    [
        pytest.param("rear", "", CHOICES, ["role:=leader"], id="only the other choice"),
        pytest.param("rear", "", "", [], id="nobody says what it may be"),
        pytest.param("front", "", CHOICES, [], id="nothing wrong in either"),
        pytest.param("front", ", Node(package='base', executable='driver', name='rear')", CHOICES, ["role:=leader"]),
    ],
)
def test_what_another_choice_starts_is_judged(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    leader: str,
    more: str,
    choices: str,
    conditions: list[str],
):
    shutil.copytree(FIXTURE / "src", tmp_path / "src")
    monkeypatch.chdir(tmp_path)
    text = BY_ROLE.replace("{leader}", leader).replace("{more}", more).replace("{choices}", choices)
    (tmp_path / LAUNCH_FILE).write_text(text)

    main(["check", "--no-cache", "--format", "json", "--select", "NME004"])
    found = json.loads(capsys.readouterr().out)["diagnostics"]
    main(["check", "--no-cache", "--format", "json", "--select", "NME004", "--launch", LAUNCH_FILE])
    by_default = json.loads(capsys.readouterr().out)["diagnostics"]

    assert [one["condition"] for one in found] == conditions
    assert by_default == []


def test_what_the_default_shows_is_told_without_a_condition(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
):
    shutil.copytree(FIXTURE / "src", tmp_path / "src")
    monkeypatch.chdir(tmp_path)
    text = BY_ROLE.replace("{leader}", "other").replace("{more}", "").replace("{choices}", CHOICES)
    (tmp_path / LAUNCH_FILE).write_text(text.replace("name='front'", "name='rear'"))

    main(["check", "--no-cache", "--format", "json", "--select", "NME004"])

    [found] = json.loads(capsys.readouterr().out)["diagnostics"]
    assert found["condition"] is None and "with role" not in found["message"]
