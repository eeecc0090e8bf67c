"""The story, told step by step: ``python -m benchmarks.adoption [WORKSPACE…]``.

A step is ``ok``, ``failed``, or ``skipped`` with what is missing.  The exit status is 1 where one failed.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from benchmarks.adoption.programs import ROOT, Programs, installed, of_this_checkout
from benchmarks.adoption.steps import STEPS, Failed, Skipped, Story
from benchmarks.adoption.workspace import Workspace, checked_out

WORKSPACES = (ROOT / "fixtures" / "broken_system", ROOT / "fixtures" / "lesson")


@dataclass(frozen=True)
class Outcome:
    """How a step went."""

    step: str
    how: str
    said: str

    def line(self) -> str:
        return f"  {self.how:<8} {self.step:<14} {self.said}"


def told(source: Path, kept: Path, programs: Programs) -> Iterator[Outcome]:
    """The steps on a copy of one workspace; after one that failed there is no other."""
    kept.mkdir(parents=True, exist_ok=True)
    programs.home.mkdir(parents=True, exist_ok=True)
    story = Story(Workspace(source.resolve(), kept / "workspace", programs), programs, kept)
    for step in STEPS:
        try:
            said, how = step(story), "ok"
        except Skipped as reason:
            said, how = str(reason), "skipped"
        except Failed as reason:
            said, how = str(reason), "failed"
        yield Outcome(step.__name__, how, said)
        if how == "failed":
            return


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.adoption", description=__doc__)
    parser.add_argument(
        "workspaces", metavar="WORKSPACE", nargs="*", default=WORKSPACES, help="a folder, or URL@COMMIT"
    )
    parser.add_argument("--install", action="store_true", help="make .venv-adoption with pre-commit and colcon first")
    parser.add_argument("-o", metavar="DIR", dest="folder", type=Path, help="keep what the steps have written here")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="adoption-") as temporary:
        folder = (arguments.folder or Path(temporary)).resolve()
        home = Path(temporary, "home").resolve()
        programs = _programs(arguments.install, folder / "programs", home)
        failed = False
        for number, workspace in enumerate(arguments.workspaces, 1):  # two may have the same name
            print(f"\n{workspace}", flush=True)
            try:
                source = _source(str(workspace), Path(temporary, "checkouts", str(number)), programs)
            except OSError as error:
                print(f"  failed   {error}", flush=True)
                failed = True
                continue
            for outcome in told(source, folder / f"{number}-{source.resolve().name}", programs):
                print(outcome.line(), flush=True)
                failed |= outcome.how == "failed"
    return int(failed)


def _source(workspace: str, checkouts: Path, programs: Programs) -> Path:
    """The folder of a workspace, which git brings where it is an address."""
    return checked_out(workspace, checkouts, programs) if "://" in workspace else Path(workspace)


def _programs(install: bool, folder: Path, home: Path) -> Programs:
    programs = installed(home) if install else "without --install"
    if isinstance(programs, Programs):
        return programs
    print(f"archlint from this checkout, no pre-commit and no colcon: {programs}", file=sys.stderr)
    return of_this_checkout(folder, home)


if __name__ == "__main__":
    sys.exit(main())
