"""How the work of rules grows with a system: counted in comparisons, so that it is the same on every machine."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from unittest.mock import patch

import pytest

from archlint import suggestions
from archlint.analysis import coexistence
from archlint.checks import circle_search, near_misses, unmatched
from archlint.config import toml_places
from archlint.config.options import options_for
from archlint.config.settings import Settings
from archlint.connections import delivery
from archlint.engine.judging import judge
from archlint.engine.pipeline import Request, check
from archlint.finding import Finding, Place
from archlint.python_code import class_chains, unassigned_attributes
from archlint.ros.qos import Qos
from archlint.syntax import facts
from archlint.systems.model import System
from robot_package import SETUP, TALKER, manifest, write_files
from systems.builders import node, partial, publisher, subscriber, system

REAL = near_misses.MOST_PAIRS, coexistence.MOST_ENDS
CROWDED = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Talker(Node):
    def __init__(self):
        super().__init__('talker')
{lines}
"""
BEST_EFFORT = Qos(reliability="best_effort")


def counted(module: object, name: str, code: str, judged: System) -> tuple[int, list[Finding]]:
    """How often a rule calls a function of a module, and what it finds."""
    calls = 0
    function: Callable[..., object] = getattr(module, name)

    def counting(*given: object) -> object:
        nonlocal calls
        calls += 1
        return function(*given)

    with patch.object(module, name, counting):
        found = list(judge(judged, options_for(Settings(), (code,))))
    return calls, found


@pytest.fixture(autouse=True)
def small_limits(monkeypatch: pytest.MonkeyPatch) -> None:
    for module in (near_misses, unmatched):
        monkeypatch.setattr(module, "MOST_PAIRS", 900)
    monkeypatch.setattr(coexistence, "MOST_ENDS", 12)


def test_the_limits_leave_room_for_large_robots():
    assert REAL == (100_000, 100)


def lonely(many: int) -> System:
    """So many topics that are published, and as many that are heard, no two of one name."""
    published = [publisher(f"said_by_{number}x") for number in range(many)]
    heard = [subscriber(f"heard_as_{number}x") for number in range(many)]
    return system(node("/a", *published), node("/b", *heard), closed=True)


@pytest.mark.parametrize(
    ("module", "code"), [(near_misses, "TOP004"), (unmatched, "TOP002"), (unmatched, "TOP003")], ids=["4", "2", "3"]
)
def test_names_are_compared_up_to_a_limit(module: object, code: str):
    few, found = counted(module, "nearly_equal", code, lonely(10))
    assert few == 10 * 10
    assert len(found) == (0 if code == "TOP004" else 10)
    many, found = counted(module, "nearly_equal", code, lonely(50))
    assert many == 900
    assert len(found) == (0 if code == "TOP004" else 50)  # only the suggestions end


def test_a_slip_within_the_limit_is_told_and_one_behind_it_is_not():
    def told(before: int) -> list[Finding]:
        unlike = [subscriber(f"heard_as_{number}x") for number in range(before)]
        heard = node("/b", *unlike, subscriber("zz_batery"))
        published = node("/a", *(publisher(f"said_by_{number}x") for number in range(before)), publisher("zz_battery"))
        return list(judge(system(published, heard), options_for(Settings(), ("TOP004",))))

    assert [one.identity for one in told(10)] == [("/zz_batery", "/zz_battery")]
    assert told(50) == []


def test_names_that_are_known_in_part_are_compared_up_to_a_limit():
    def closed(many: int) -> System:
        said = [publisher(f"said_{number}") for number in range(many)]
        heard = [subscriber(partial(f"part_{number}_*")) for number in range(many)]
        return system(node("/a", *said), node("/b", *heard), closed=True)

    few, found = counted(unmatched, "_may_match", "TOP002", closed(10))
    assert (few, len(found)) == (10 * 10, 10)
    many, found = counted(unmatched, "_may_match", "TOP002", closed(50))
    assert (many, len(found)) == (900, 900 // 50)  # of the others somebody may be the partner


def crowd(many: int) -> System:
    """So many nodes that publish one topic, and as many that want more than they offer."""
    nodes = [node(f"/a{number}", publisher("x", qos=BEST_EFFORT)) for number in range(many)]
    return system(*nodes, *(node(f"/b{number}", subscriber("x")) for number in range(many)), closed=True)


def test_ends_of_one_topic_are_held_against_each_other_up_to_a_limit():
    few, found = counted(delivery, "coexist", "QOS001", crowd(6))
    assert few == 6 * 6
    assert [len(one.related) for one in found] == [6] * 6
    many, _ = counted(delivery, "coexist", "QOS001", crowd(40))
    assert many == 12 * 12


def test_what_fits_is_looked_for_once_for_each_subscription():
    half, _ = counted(delivery, "_errors", "QOS001", crowd(40))
    many, _ = counted(delivery, "_errors", "QOS001", crowd(80))
    assert many < 2.1 * half


def test_types_and_owners_of_one_topic_are_held_against_each_other_up_to_a_limit():
    def typed(many: int) -> System:
        types = ("std_msgs/msg/Bool", "std_msgs/msg/String")
        return system(*(node(f"/a{number}", publisher("x", types[number % 2])) for number in range(many)), closed=True)

    for code, pairs in (("TOP001", 12 * 12 / 4), ("OWN001", 12 * 11 / 2)):
        many, _ = counted(coexistence, "coexist", code, typed(60))
        assert many == pairs


def test_a_profile_is_looked_for_at_its_create_call_and_not_at_all_others(
    judge: Callable[..., list[Finding]], monkeypatch: pytest.MonkeyPatch
):
    compared = 0
    equal = Place.__eq__

    def counted_equal(self: Place, other: object) -> bool:
        nonlocal compared
        compared += 1
        return equal(self, other)

    monkeypatch.setattr(Place, "__eq__", counted_equal)

    def of(many: int) -> int:
        nonlocal compared
        lines = "".join(f"        self.create_publisher(String, 't{number}', 10)\n" for number in range(many))
        compared = 0
        judge("QOS004", CROWDED.format(lines=lines))
        return compared

    assert of(80) < 3 * of(40) + 100  # not the square of it


def test_what_a_file_assigns_is_collected_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    collected = 0
    targets_of = unassigned_attributes.targets_of

    def counting(body: object) -> object:
        nonlocal collected
        collected += 1
        return targets_of(body)

    monkeypatch.setattr(unassigned_attributes, "targets_of", counting)

    def of(many: int) -> int:
        nonlocal collected
        lines = "".join(f"        self.b{number} = self.a{number}\n" for number in range(many))
        (tmp_path / "node.py").write_text(CROWDED.format(lines=lines))
        collected = 0
        findings = check(Request((str(tmp_path),), Settings(), cached=False, jobs=1)).findings
        assert {finding.code for finding in findings} == {"API002"}
        return collected

    assert 0 < of(40) == of(20)


def test_the_names_that_a_file_binds_are_collected_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    looked = 0
    bound_by = class_chains._bound_by

    def counting(statement: facts.Base) -> set[str]:
        nonlocal looked
        looked += 1
        return bound_by(statement)

    monkeypatch.setattr(class_chains, "_bound_by", counting)

    def of(many: int) -> int:
        nonlocal looked
        method = "    def go(self):\n        return self.unheard_of\n"
        classes = "".join(f"class C{number}(C{number - 1}):\n{method}" for number in range(1, many))
        end = f"\nrclpy.init()\nrclpy.spin(C{many - 1}('a'))\n"
        source = f"import rclpy\nfrom rclpy.node import Node\nclass C0(Node):\n    pass\n{classes}{end}"
        (tmp_path / "node.py").write_text(source)
        looked = 0
        check(Request((str(tmp_path),), Settings(), cached=False, jobs=1))
        return looked

    assert 0 < of(40) < 2.1 * of(20)


def test_the_headers_of_a_configuration_are_read_once(monkeypatch: pytest.MonkeyPatch):
    read = 0
    entries = toml_places._entries

    def counting(text: str) -> list[toml_places._Entry]:
        nonlocal read
        read += 1
        return entries(text)

    monkeypatch.setattr(toml_places, "_entries", counting)
    text = "[[contracts]]\nname = 'a'\n" * 50
    spans = [toml_places.headers(text, ("contracts",))[number] for number in range(50)]
    assert (read, spans[:2]) == (1, [(1, 3, 12), (3, 3, 12)])


def test_circles_of_services_are_looked_for_up_to_a_limit(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    def found(limit: int) -> set[str]:
        monkeypatch.setattr(circle_search, "MOST_STEPS", limit)
        served = "".join(
            f"        self.create_service(Trigger, 's{k}', self.on_{k})\n"
            f"        self.c{k} = self.create_client(Trigger, 's{(k + 1) % 5}')\n"
            for k in range(5)
        )
        handlers = "".join(
            f"    def on_{k}(self, request, response):\n        return self.c{k}.call(request)\n" for k in range(5)
        )
        source = "from std_srvs.srv import Trigger\n" + CROWDED.format(lines=served + handlers)
        (tmp_path / "node.py").write_text(source)
        findings = check(Request((str(tmp_path),), Settings(), cached=False, jobs=1)).findings
        return {finding.code for finding in findings} & {"SRV006"}

    assert (found(1000), found(3)) == ({"SRV006"}, set())


def test_what_was_meant_is_looked_for_up_to_a_limit(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    compared = 0
    distance = suggestions.distance

    def counting(first: str, second: str, limit: int) -> int:
        nonlocal compared
        compared += 1
        return distance(first, second, limit)

    monkeypatch.setattr(suggestions, "distance", counting)
    monkeypatch.setattr(suggestions, "MOST_COMPARED", 2_000)

    def of(many: int) -> list[str]:
        """The messages of a file with so many names, and as many that are misspelt."""
        nonlocal compared
        letters = [f"{chr(97 + number // 26)}{chr(97 + number % 26)}" for number in range(many)]
        known = "".join(f"speed_of_{name} = 1\n" for name in letters)
        reads = [f"        print(sped_of_{name})" for name in letters]
        (tmp_path / "node.py").write_text(known + CROWDED.format(lines="\n".join(reads)))
        compared = 0
        report = check(Request((str(tmp_path),), Settings(), cached=False, jobs=1))
        return [finding.message for finding in report.findings if finding.code == "API005"]

    few = of(10)
    assert len(few) == 10
    assert all("did you mean 'speed_of_" in message for message in few)
    many = of(300)
    assert len(many) == 300  # only the suggestions end
    assert "did you mean" in many[0]
    assert "did you mean" not in many[-1]
    assert compared < 3 * suggestions.MOST_COMPARED


LAUNCH = """\
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    file = os.path.join(get_package_share_directory('robot'), 'config', 'robot.yaml')
    return LaunchDescription([Node(package='robot', executable='talker', parameters=[file])])
"""


def test_the_values_of_a_parameter_file_are_not_held_against_each_other(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    compared = 0
    equal = Place.__eq__

    def counting(first: Place, second: object) -> bool:
        nonlocal compared
        compared += 1
        return equal(first, second)

    monkeypatch.setattr(Place, "__eq__", counting)

    def of(many: int) -> int:
        nonlocal compared
        values = "".join(f"    of_nobody_{number}: {number}\n" for number in range(many))
        files = {
            "package.xml": manifest(),
            "setup.py": SETUP,
            "robot/__init__.py": "",
            "robot/talker.py": TALKER,
            "launch/robot.launch.py": LAUNCH,
            "config/robot.yaml": f"talker:\n  ros__parameters:\n{values}",
        }
        write_files(tmp_path / "robot", files)
        compared = 0
        report = check(Request((str(tmp_path),), Settings(), cached=False, jobs=1))
        assert [finding.code for finding in report.findings if finding.code == "PRM004"] == ["PRM004"]
        return compared

    assert of(200) < 3 * of(100)
