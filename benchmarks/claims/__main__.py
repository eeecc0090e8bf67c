"""``python -m benchmarks.claims observe jazzy|kilted`` tries claims; ``… compare`` holds archlint against them."""

from __future__ import annotations

import argparse
import re
import sys
from collections import Counter
from pathlib import Path

from tests_ros.environments import Environment

from benchmarks.claims import table
from benchmarks.claims.model import Claim
from benchmarks.claims.trying import RULES, all_claims, findings, observe, said

_BATCH = 200


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.claims", description=__doc__)
    commands = parser.add_subparsers(dest="command", required=True)
    trying = commands.add_parser(
        "observe", help="run programs under a real rclpy and note in observed.tsv what they do"
    )
    trying.add_argument("distro", choices=table.DISTROS)
    trying.add_argument("--jobs", type=int, default=8, help="how many programs run at a time")
    trying.add_argument("--tf2-ros", type=Path, help="geometry2's tf2_ros_py/tf2_ros, for what EXE007 says")
    comparing = commands.add_parser("compare", help="what archlint says of each program against what was observed")
    comparing.add_argument("--distro", choices=table.DISTROS, action="append")
    for command in (trying, comparing):
        command.add_argument("--only", default="", metavar="REGEX", help="programs whose name matches")
    given = parser.parse_args()
    claims = [claim for claim in all_claims() if re.search(given.only, claim.name)]
    if given.command == "observe":
        try_out(given.distro, claims, given.jobs, given.tf2_ros)
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
