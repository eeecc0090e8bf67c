"""What rclpy raises for each wrong call is what ``wrong_calls.tsv`` says: an exception, ``nothing``, or a signal."""

from __future__ import annotations

import csv
import json
import subprocess
from pathlib import Path

from tests_ros.environments import Environment
from tests_ros.running import INSIDE, domain_of_its_own
from tests_ros.wrong_calls import PIECES

TABLE = Path(__file__).with_name("wrong_calls.tsv")


def test_what_is_raised(environment: Environment, tmp_path: Path) -> None:
    with TABLE.open(encoding="utf-8", newline="") as file:
        known = {row["what is wrong"]: row[environment.distro] for row in csv.DictReader(file, delimiter="\t")}
    with domain_of_its_own() as domain:
        done = subprocess.run(
            [environment.python, INSIDE / "wrong.py"],
            env=environment.variables([], domain, tmp_path),
            input=json.dumps(PIECES),
            capture_output=True,
            text=True,
            timeout=300,
            check=True,
        )
    assert {name: kind_of(said) for name, said in json.loads(done.stdout).items()} == known


def kind_of(said: str) -> str:
    return said.partition(":")[0] or "nothing"
