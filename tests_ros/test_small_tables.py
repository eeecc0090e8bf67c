"""What archlint knows by heart of names, remap rules, QoS and parameter files, asked of a real rclpy."""

from __future__ import annotations

import itertools
import json
import subprocess
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import pytest
import yaml

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.ros import names, remapping
from archlint.ros.qos import Qos, compatible
from tests_ros.environments import Environment
from tests_ros.running import INSIDE, domain_of_its_own

NODE = ("asker", "/left")
NAMES = (
    *("scan", "/scan", "~/scan", "~", "~scan", "~~", "scan/", "/", "//scan", "a//b", "scan_", "_scan", "__scan"),
    *("a__b", "1scan", "a/1b", "a1/b", "sc an", "sc-an", "scän", "scan~", "a/~/b", "{node}/scan", "{ns}/scan"),
    *("{namespace}scan", "{node", "node}", "{}", "{1a}", "{robot}/scan", "a{node}b", "{node}{node}", "a/{ns}"),
    *("scan.x", "a:b", "A/B", "x" * 241, "x" * 242, "/" + "x" * 246, "/" + "x" * 247),
)
NODES = ("asker", "Asker", "as ker", "as-ker", "1asker", "_asker", "a/b", "/a", "ä", "x" * 200, "x" * 256)
NAMESPACES = ("left", "/left", "/", "/left/", "//left", "/left//arm", "/1left", "left arm", "/a/b", "~", "/x" * 100)
REMAPS = (
    ("scan:=one",),
    ("scan:=one", "scan:=two"),
    ("scan:=one", "/scan:=two"),
    ("/scan:=two", "scan:=one"),
    ("scan:=one", "one:=two"),
    ("asker:scan:=one", "scan:=two"),
    ("scan:=one", "asker:scan:=two"),
    ("other:scan:=one",),
    ("rostopic://scan:=one", "scan:=two"),
    ("rosservice://scan:=one", "scan:=two"),
    ("__node:=one", "__node:=two"),
    ("__ns:=/one", "__ns:=/two"),
    ("__ns:=/one", "scan:=two"),
    ("__ns:=/one", "/scan:=two"),
    ("__ns:=/one", "/one/scan:=two"),
    ("__node:=one", "asker:scan:=two"),
    ("__node:=one", "one:scan:=two"),
    ("__node:=one", "scan:=~/two"),
    ("asker:__node:=one", "__node:=two"),
)
"""Rules of one command line: several for one name, in either order, and rules that change what others meet."""

DEFAULTS: dict[str, Any] = {
    "bool": False,
    "integer": 1,
    "double": 1.5,
    "string": "a",
    "bool_array": [True],
    "integer_array": [1],
    "double_array": [1.5],
    "string_array": ["a"],
}
IN_FILE = {
    "true": "true",
    "yes": "yes",
    "one": "1",
    "hex": "0x10",
    "half": "0.5",
    "thousand": "1e3",
    "word": "word",
    "quoted": "'1'",
    "date": "2024-01-01",
    "bools": "[true, false]",
    "ones": "[1, 2]",
    "halves": "[0.5, 1.5]",
    "words": "[a, b]",
    "quoted_ones": "['1', '2']",
}


@dataclass(frozen=True)
class Asked:
    """What a real rclpy says, and the folder with the parameter file that it was given."""

    answer: dict[str, Any]
    folder: Path


def pairs() -> list[tuple[Qos, Qos]]:
    """Each policy of an offer against each of a request; reliability and durability also together."""
    plain = Qos(liveliness="automatic")
    ends = {
        "reliability": ("reliable", "best_effort", "best_available"),
        "durability": ("volatile", "transient_local", "best_available"),
        "deadline": (None, 1.0, 2.0),
        "liveliness": ("automatic", "manual_by_topic"),
        "liveliness_lease": (None, 1.0, 2.0),
    }
    found = []
    together = (("reliability", "durability"), ("liveliness", "liveliness_lease"), ("deadline", "reliability"))
    for first, second in together:
        sides = [
            replace(plain, **{first: one, second: other})  # type: ignore[arg-type]
            for one, other in itertools.product(ends[first], ends[second])
        ]
        found += itertools.product(sides, sides)
    return [*found, (plain, plain)]


@pytest.fixture(scope="session")
def asked(environment: Environment, tmp_path_factory: pytest.TempPathFactory) -> Asked:
    folder = tmp_path_factory.mktemp("asked")
    lines = [f"    {kind}_{word}: {value}" for kind in DEFAULTS for word, value in IN_FILE.items()]
    (folder / "settings.yaml").write_text("\n".join(["holder:", "  ros__parameters:", *lines, ""]))
    question = {
        "names": NAMES,
        "nodes": NODES,
        "namespaces": NAMESPACES,
        "remaps": REMAPS,
        "qos": [(vars(offer), vars(request)) for offer, request in _plain(pairs())],
        "parameters": str(folder / "settings.yaml"),
        "declared": {f"{kind}_{word}": default for kind, default in DEFAULTS.items() for word in IN_FILE},
    }
    with domain_of_its_own() as domain:
        done = subprocess.run(
            [environment.python, INSIDE / "asked.py"],
            env=environment.variables([], domain, folder),
            input=json.dumps(question),
            capture_output=True,
            text=True,
            timeout=60,
            check=False,
        )
    assert done.returncode == 0, done.stderr[-2000:]
    return Asked(json.loads(done.stdout), folder)


def _plain(given: list[tuple[Qos, Qos]]) -> list[tuple[Any, ...]]:
    class Profile:
        def __init__(self, qos: Qos) -> None:
            for policy in ("reliability", "durability", "deadline", "liveliness", "liveliness_lease"):
                setattr(self, policy, getattr(qos, policy))

    return [tuple(map(Profile, pair)) for pair in given]


@pytest.mark.parametrize(("kind", "answers"), [(remapping.TOPIC, "names"), (remapping.SERVICE, "services")])
def test_names(asked: Asked, kind: str, answers: str):
    said = [_name(name, kind) for name in NAMES]
    assert dict(zip(NAMES, said, strict=True)) == dict(zip(NAMES, _refused(asked.answer[answers]), strict=True))


def _name(name: str, kind: str) -> str | None:
    return None if names.validate_topic_name(name) else remapping.resolve(name, kind, NODE).name


def _refused(answers: list[str]) -> list[str | None]:
    return [None if answer.startswith("<") else answer for answer in answers]


def test_names_of_nodes_and_namespaces(asked: Asked):
    nodes = [None if names.validate_node_name(name) else name for name in NODES]
    assert nodes == _refused(asked.answer["nodes"])
    spaces = [names.absolute_namespace(name) for name in NAMESPACES]
    allowed = [None if names.validate_namespace(name) else name for name in spaces]
    assert allowed == _refused(asked.answer["namespaces"])


@pytest.mark.parametrize("number", range(len(REMAPS)), ids=lambda number: " ".join(REMAPS[number]))
def test_what_wins_among_remap_rules(asked: Asked, number: int):
    rules = [remapping.RemapRule.parse(text) for text in REMAPS[number]]
    name = next((rule.replacement for rule in rules if rule.applies(remapping.NODE_NAME, "asker")), "asker")
    space = next((rule.replacement for rule in rules if rule.applies(remapping.NAMESPACE, name)), "/")
    full = f"{space.rstrip('/')}/{name}"
    ends = [
        remapping.resolve("scan", kind, (name, space), (), rules).name for kind in (remapping.TOPIC, remapping.SERVICE)
    ]
    assert asked.answer["remaps"][number] == " ".join([full, *map(str, ends)])


def test_which_profiles_meet(asked: Asked):
    wrong = [
        (offer, request)
        for (offer, request), met in zip(pairs(), asked.answer["qos"], strict=True)
        if met == any(verdict.level == "error" for verdict in compatible(offer, request))
    ]
    assert wrong == []


def test_parameters_of_another_type(asked: Asked, monkeypatch: pytest.MonkeyPatch):
    """PRM002 says it of exactly those values that declare_parameter() refuses."""
    cells = itertools.product(DEFAULTS.items(), IN_FILE)
    declared = [f"        self.declare_parameter('{kind}_{word}', {default!r})\n" for (kind, default), word in cells]
    write_package(asked.folder, "".join(declared))
    monkeypatch.chdir(asked.folder)
    request = Request((".",), load(asked.folder), cached=False, jobs=1, launch="all.launch.xml")
    found = [finding for finding in check(request).findings if finding.code == "PRM002"]
    texts = [text for finding in found for text in (finding.message, *(row.message for row in finding.related))]
    said = {text.split("'")[1] for text in texts if text.startswith("parameter '")}  # one finding may be for several
    refused = {name for name, value in asked.answer["parameters"].items() if value.startswith("<")}
    assert said == refused
    assert len(asked.answer["parameters"]) == len(DEFAULTS) * len(IN_FILE)
    assert yaml.safe_load((asked.folder / "settings.yaml").read_text())["holder"]


def write_package(folder: Path, declared: str) -> None:
    (folder / "holder").mkdir()
    (folder / "holder" / "__init__.py").touch()
    (folder / "holder" / "node.py").write_text(
        "import rclpy\nfrom rclpy.node import Node\n\n\nclass Holder(Node):\n    def __init__(self):\n"
        f"        super().__init__('holder')\n{declared}\n\ndef main():\n    rclpy.init()\n    rclpy.spin(Holder())\n"
    )
    (folder / "setup.py").write_text(
        "from setuptools import setup\n\nsetup(name='holder', packages=['holder'], "
        "entry_points={'console_scripts': ['holder = holder.node:main']})\n"
    )
    (folder / "package.xml").write_text("<package format='3'><name>holder</name><version>0.0.0</version></package>")
    (folder / "all.launch.xml").write_text(
        "<launch><node pkg='holder' exec='holder'><param from='$(dirname)/settings.yaml'/></node></launch>"
    )
