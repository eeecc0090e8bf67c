"""``python -m benchmarks.claims observe jazzy|kilted`` tries claims; ``… again`` tries them once more and names those
that do something else; ``… compare`` holds archlint against them."""

from __future__ import annotations

import argparse
import re
import sys
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from tests_ros.environments import Environment

from benchmarks.claims import table
from benchmarks.claims.model import Claim
from benchmarks.claims.trying import RULES, all_claims, findings, observe, said
from benchmarks.executors.again import try_again

_BATCH = 200


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.claims", description=__doc__)
    commands = parser.add_subparsers(dest="command", required=True)
    trying = commands.add_parser(
        "observe", help="run programs under a real rclpy and note in observed.tsv what they do"
    )
    repeating = commands.add_parser("again", help="run programs once more, and name those that do something else")
    repeating.add_argument("--record", type=Path, required=True, help="what was run; a second call goes on from it")
    repeating.add_argument("--more", type=int, default=4, help="how often to run one that does something else")
    for command in (trying, repeating):
        command.add_argument("distro", choices=table.DISTROS)
        command.add_argument("--jobs", type=int, default=8, help="how many programs run at a time")
        command.add_argument("--tf2-ros", type=Path, help="geometry2's tf2_ros_py/tf2_ros, for what EXE007 says")
    comparing = commands.add_parser("compare", help="what archlint says of each program against what was observed")
    comparing.add_argument("--distro", choices=table.DISTROS, action="append")
    for command in (trying, repeating, comparing):
        command.add_argument("--only", default="", metavar="REGEX", help="programs whose name matches")
    given = parser.parse_args()
    claims = [claim for claim in all_claims() if re.search(given.only, claim.name)]
    if given.command == "observe":
        try_out(given.distro, claims, given.jobs, given.tf2_ros)
    elif given.command == "again":
        hold_against_the_table(given.distro, claims, given.jobs, given.tf2_ros, given.record, given.more)
    else:
        compare(claims, given.distro or table.DISTROS)


def try_out(distro: str, claims: list[Claim], jobs: int, tf2_ros: Path | None) -> None:
    seen = {}
    for number, (claim, outcome) in enumerate(observe(Environment(distro), claims, jobs, tf2_ros), 1):
        seen[claim] = outcome
        if number % 50 == 0:
            print(f"{number} of {len(claims)}", file=sys.stderr)
    observed = table.read(set(all_claims()))
    observed[distro].update(seen)
    table.write(observed)


def hold_against_the_table(
    distro: str, claims: list[Claim], jobs: int, tf2_ros: Path | None, record: Path, more: int
) -> None:
    by_name = {claim.name: claim for claim in claims if claim.rule != "EXE007" or tf2_ros is not None}
    known = {claim.name: [seen] for claim, seen in table.read(set(by_name.values()))[distro].items()}

    def run(names: list[str]) -> Iterator[tuple[str, str]]:
        for claim, seen in observe(Environment(distro), [by_name[name] for name in names], jobs, tf2_ros):
            yield claim.name, seen

    for line in try_again(known, run, record, more):
        print(line)


def compare(claims: list[Claim], distros: list[str]) -> None:
    observed = table.read(set(claims))
    for distro in distros:
        here = [claim for claim in claims if claim in observed[distro]]
        tried: Counter[str] = Counter()
        wrong: Counter[str] = Counter()
        for start in range(0, len(here), _BATCH):
            for claim, found in findings(here[start : start + _BATCH], distro).items():
                tried[claim.rule] += 1
                seen = observed[distro][claim]
                if not RULES[claim.rule].bears_out(claim, said(found), seen):
                    wrong[claim.rule] += 1
                    print(f"  {distro} {claim.name}: {seen}; {said(found)} {' '.join(one.message for one in found)}")
        for rule, count in sorted(tried.items()):
            print(f"{distro} {rule}: {count} programs, {count - wrong[rule]} as archlint says, {wrong[rule]} not")


if __name__ == "__main__":
    main()
