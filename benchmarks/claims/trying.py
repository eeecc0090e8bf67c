"""Runs claims under a real rclpy, and asks archlint of the same programs."""

from __future__ import annotations

import re
import tempfile
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from tests_ros.environments import Environment

from archlint.config.settings import Settings
from archlint.engine.pipeline import Request, check
from archlint.finding import Finding
from benchmarks.claims import circles, groups, lookups, lost, made_again, signatures, slow, unspun
from benchmarks.claims.model import REPORTED, SILENT, Claim, Judged
from benchmarks.executors.running import run_programs
from benchmarks.executors.verdicts import working_in

RULES: dict[str, Judged] = {
    one.JUDGED.rule: one.JUDGED for one in (slow, made_again, signatures, unspun, groups, circles, lost, lookups)
}
_MANIFEST = "<package format='3'><name>{name}</name><version>0.0.0</version></package>"
_SENDER = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


def main():
    rclpy.init()
    node = Node('sender')
    publisher = node.create_publisher(String, 'go', 10)
    node.create_timer(0.1, lambda: publisher.publish(String(data='given')))
    rclpy.spin(node)


if __name__ == '__main__':
    main()
"""
"""Who sends the messages for whose callbacks the programs are: a callback that nobody calls is left alone."""


def all_claims() -> list[Claim]:
    return sorted({claim for judged in RULES.values() for claim in judged.claims()})


def observe(
    environment: Environment, claims: Iterable[Claim], jobs: int, tf2_ros: Path | None = None
) -> Iterator[tuple[Claim, str]]:
    """What becomes of each program, as it comes.  EXE007's need ``tf2_ros``, a folder of a checkout."""
    by_name = {claim.name: claim for claim in claims if claim.rule != "EXE007" or tf2_ros is not None}
    tasks = [_task(claim) for claim in by_name.values()]
    with tempfile.TemporaryDirectory() as folder:
        prefixes = [] if tf2_ros is None else lookups.prefixes(environment, tf2_ros, Path(folder))
        for name, said in run_programs(environment, tasks, jobs, prefixes):
            claim = by_name[name]
            yield claim, RULES[claim.rule].outcome(claim, said)


def _task(claim: Claim) -> dict[str, object]:
    judged = RULES[claim.rule]
    return {
        "name": claim.name,
        "source": judged.source(claim),
        "needs": judged.needs(claim),
        "latency": 0.0,
        "program_first": True,
        "enough": 10_000,
        "limit": judged.seconds,
    }


def findings(claims: Sequence[Claim], distro: str) -> dict[Claim, list[Finding]]:
    """What archlint says of each program, by the rules that may speak of it."""
    found: dict[Claim, list[Finding]] = {claim: [] for claim in claims}
    with tempfile.TemporaryDirectory() as name, working_in(Path(name)) as folder:
        by_package = {}
        for claim in claims:
            package = re.sub(r"\W", "_", claim.name)
            by_package[package] = claim
            (folder / package).mkdir()
            (folder / package / "package.xml").write_text(_MANIFEST.format(name=package.lower()))
            (folder / package / "asker.py").write_text(RULES[claim.rule].source(claim))
        (folder / "other_end").mkdir()
        (folder / "other_end" / "package.xml").write_text(_MANIFEST.format(name="other_end"))
        (folder / "other_end" / "sender.py").write_text(_SENDER)
        for finding in check(Request((".",), Settings(distro=distro, cache_dir="cache"), jobs=1)).findings:
            claim = by_package.get(finding.place.file.partition("/")[0])
            if claim is not None and finding.code in (RULES[claim.rule].judges or (claim.rule,)):
                found[claim].append(finding)
    return found


def said(found: Sequence[Finding]) -> str:
    return REPORTED if found else SILENT
