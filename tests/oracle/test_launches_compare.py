"""How the comparison with the real launch counts, and how a share is laid out for it."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest
from benchmarks.launches import layout
from benchmarks.launches.__main__ import main
from benchmarks.launches.compare import EQUAL, OPEN, WRONG, compared, measure
from benchmarks.launches.expected import Checkout, Row, Unknown, recorded
from benchmarks.launches.inside.guard import FROM_OUTSIDE, OUTPUT
from benchmarks.launches.inside.parameters import rows_of_file, value_of

from robot_package import manifest

PLAIN = {"package": "robot", "executable": "talker", "name": "a", "namespace": None, "remaps": [], "files": []}
UNKNOWN = Unknown("it is an argument")


def row(**changed: object) -> Row:
    return Row("node", {**PLAIN, "parameters": {}, **changed})


def verdicts(real: Row, ours: Row) -> dict[str, str]:
    [(found, _)] = compared([real], [ours])
    return {name: verdict for name, verdict in found.items() if verdict != EQUAL}


def test_equal_nodes():
    assert verdicts(row(), row()) == {}


@pytest.mark.parametrize(
    ("real", "ours", "verdict"),
    [
        ({"name": "a"}, {"name": "b"}, {"name": WRONG}),
        ({"name": "a"}, {"name": UNKNOWN}, {"name": OPEN}),
        ({"remaps": [["a", "b"]]}, {"remaps": []}, {"remaps": WRONG}),
        ({"remaps": [["a", "b"]]}, {"remaps": [["a", UNKNOWN]]}, {"remaps": OPEN}),
        ({"parameters": {("**", "rate"): 1}}, {"parameters": {("**", "rate"): 1.0}}, {"parameters": WRONG}),
        ({"parameters": {("**", "rate"): 1}}, {"parameters": {}}, {"parameters": WRONG}),
        ({"parameters": {("**", "rate"): 1}}, {"parameters": {("**", "rate"): UNKNOWN}}, {"parameters": OPEN}),
    ],
)
def test_what_differs_and_what_is_not_known(real, ours, verdict):
    assert verdicts(row(**real), row(**ours)) == verdict


@pytest.mark.parametrize("text", [f"<{OUTPUT}>", f"/home/{FROM_OUTSIDE}/a.yaml"])
def test_nobody_can_know_what_the_machine_decides(text):
    assert verdicts(row(parameters={("**", "a"): text}), row(parameters={("**", "a"): UNKNOWN})) == {}
    assert verdicts(row(parameters={("**", "a"): text}), row(parameters={("**", "a"): "b"})) == {"parameters": WRONG}


def test_parameters_that_may_be_there():
    ours = row()
    ours.open.append("a list of parameters that is not known")
    assert verdicts(row(parameters={("**", "rate"): 1}), ours) == {"parameters": OPEN}


def test_a_node_of_one_side_only():
    found = [(set(verdicts.values()), words) for verdicts, words in compared([row()], [row(executable="listener")])]
    assert found == [({WRONG}, "missing: node robot/talker "), ({WRONG}, "more: node robot/listener None")]


def test_types_of_a_parameter_file(tmp_path):
    text = "/**:\n  ros__parameters:\n    a: 1\n    b: '1'\n    c: {d: yes, e: 1.5}\n    f: [a, b]\n"
    (tmp_path / "a.yaml").write_text(text)
    assert rows_of_file(str(tmp_path / "a.yaml")) == [
        ("/**", "a", 1),
        ("/**", "b", "1"),
        ("/**", "c.d", True),
        ("/**", "c.e", 1.5),
        ("/**", "f", ["a", "b"]),
    ]
    assert [value_of("1e3"), value_of("'2'"), value_of("x")] == [1000.0, "2", "x"]


CMAKE = """\
project(robot)  # not install(DIRECTORY all)
install(DIRECTORY launch config/ DESTINATION share/${PROJECT_NAME})
install(FILES a.rviz DESTINATION share/${PROJECT_NAME}/rviz)
"""


def test_a_share_is_laid_out_as_cmake_installs_it(tmp_path):
    folder = tmp_path / "robot"
    for name in ("launch/a.launch.py", "config/a.yaml", "a.rviz", "all/b.yaml"):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text("def generate_launch_description(): ...\n")
    (folder / "package.xml").write_text("<package><name>robot</name></package>")
    (folder / "CMakeLists.txt").write_text(CMAKE)
    [package] = layout.packages(tmp_path)
    layout.lay_out(package, None, tmp_path / "install")
    share = tmp_path / "install" / "robot" / "share" / "robot"
    found = sorted(path.relative_to(share).as_posix() for path in share.rglob("*") if path.is_file())
    assert found == ["a.yaml", "launch/a.launch.py", "package.xml", "rviz/a.rviz"]
    path = folder / "launch" / "a.launch.py"
    assert path in layout.launch_files(package)
    assert layout.place_of(package, path, tmp_path / "install") == share / "launch" / "a.launch.py"


LAUNCH = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('extra', default_value='false'),
        Node(package='robot', executable='talker', namespace='n', parameters=[{'rate': 2}], remappings=[('a', 'b')]),
        Node(package='robot', executable='more', condition=IfCondition(LaunchConfiguration('extra'))),
    ])
"""


def test_archlints_rows_against_a_record(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    folder = tmp_path / "robot"
    (folder / "launch").mkdir(parents=True)
    (folder / "package.xml").write_text(
        "<package><name>robot</name><export><build_type>ament_cmake</build_type></export></package>"
    )
    (folder / "launch" / "a.launch.py").write_text(LAUNCH)
    talker = {**PLAIN, "kind": "node", "name": None, "namespace": "/n", "remaps": [["a", "b"]]}
    talker["parameters"] = [["/**", "rate", 2]]
    more = {**PLAIN, "kind": "node", "executable": "more", "name": None, "parameters": []}
    runs = [
        {"arguments": {}, "error": None, "nodes": [talker]},
        {"arguments": {"extra": "true"}, "error": None, "nodes": [talker, more]},
    ]
    record = json.loads(json.dumps([{"file": "robot/launch/a.launch.py", "runs": runs}]))
    counts, told = measure(record, Checkout(Path(tmp_path)))
    assert told == []
    assert (counts["runs"], counts["nodes"], counts[EQUAL]) == (2, 3, 3)
    record[0]["runs"][0]["nodes"].append(recorded([more]) and more)
    counts, told = measure(record, Checkout(Path(tmp_path)))
    assert told == ["wrong: robot/launch/a.launch.py: missing: node robot/more "]


def test_one_command_for_a_folder_of_repositories(tmp_path, capsys, monkeypatch):
    """What has a record is not recorded again; each repository gets its row, and its differences in a file."""
    checkouts, records = tmp_path / "checkouts", tmp_path / "records"
    launch_file = checkouts / "a+robot" / "robot" / "launch" / "it.launch.py"
    launch_file.parent.mkdir(parents=True)
    launch_file.write_text(
        "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n"
        "def generate_launch_description():\n"
        "    return LaunchDescription([Node(package='robot', executable='talker')])\n"
    )
    (checkouts / "a+robot" / "robot" / "package.xml").write_text(manifest("robot"))
    (checkouts / ".hidden").mkdir()
    records.mkdir()
    seen = [{**PLAIN, "name": None, "kind": "node", "parameters": []} for _ in range(2)]
    run = {"arguments": {}, "error": None, "nodes": seen, "environment": []}
    (records / "a+robot.json").write_text(json.dumps([{"file": "robot/launch/it.launch.py", "runs": [run]}]))
    monkeypatch.setattr(
        sys, "argv", ["", str(checkouts), "-o", str(records), "--python", sys.executable, "--ros", str(tmp_path)]
    )
    for name in ("launch", "launch_ros"):
        (tmp_path / name).mkdir()
    assert main() == 0
    row, whole = capsys.readouterr().out.splitlines()[-2:]
    assert row.startswith("| a/robot | 1 | 0 | 1 | 2 |") and row.endswith("| 50.00 % | 0 | 1 |")
    assert whole == row.replace("a/robot", "all")
    assert "missing: node robot/talker" in (records / "a+robot.txt").read_text()
