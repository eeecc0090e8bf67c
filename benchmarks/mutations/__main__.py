"""How many planted defects are found, and what else is said: ``python -m benchmarks.mutations CHECKOUT…``."""

from __future__ import annotations

import argparse
import hashlib
import tempfile
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

from . import code, endpoints, launch, package  # noqa: F401  (they register their defects)
from .closed import closed_systems, renamed_ends
from .defect import PLANTERS, Defect, Sites
from .plant import Bench, Outcome, edited
from .trees import Package, closure, copied, packages

LARGEST = 250
"""Python files of a workspace; a package that needs more than that is left out, to be done in reasonable time."""


def main() -> None:
    """Print a table of defects, then with --misses each one that was not found, with --noise what else was said."""
    parser = argparse.ArgumentParser(description=main.__doc__)
    parser.add_argument("checkouts", nargs="+", type=Path)
    parser.add_argument("--each", type=int, default=4, help="defects of a kind for each checkout (default 4)")
    parser.add_argument("--only", action="append", default=[], help="kinds whose words, or rules, contain this")
    parser.add_argument("--misses", action="store_true")
    parser.add_argument("--noise", action="store_true")
    options = parser.parse_args()
    outcomes: dict[str, list[Outcome]] = defaultdict(list)
    with tempfile.TemporaryDirectory() as folder:
        for checkout in options.checkouts:
            for what, outcome in _outcomes(checkout.resolve(), Path(folder), options.each, options.only):
                outcomes[what].append(outcome)
                _tell(checkout.name, what, outcome, options)
    _print_table(outcomes)


def _outcomes(root: Path, folder: Path, each: int, only: list[str]) -> Iterator[tuple[str, Outcome]]:
    every = packages(root)
    chosen: dict[str, list[tuple[str, Defect]]] = defaultdict(list)
    choices = _choices(every, only)
    if not only or any("closed" in word for word in only):
        choices.update(_closed(root, every, folder / "cache"))
    for what, found in choices.items():
        for name, defect in _spread(found, each):
            chosen[name].append((what, defect))
    for name, defects in sorted(chosen.items()):
        parts = closure(every[name], every)
        if sum(file.endswith(".py") for part in parts for file in part.files) > LARGEST:
            continue
        target = folder / root.name / name
        copied(parts, target)
        bench = Bench(target, folder / "cache")
        for what, defect in defects:
            if _still_parses(target, defect):
                yield what, bench.plant(defect)


def _choices(every: dict[str, Package], only: list[str]) -> dict[str, list[tuple[str, Defect]]]:
    found: dict[str, list[tuple[str, Defect]]] = defaultdict(list)
    for home in every.values():
        if not any(file.endswith(".py") for file in home.files) and not home.launch_xml:
            continue
        beside = {one.name: one for one in closure(home, every)}
        for what, planter in PLANTERS.items():
            for defect in planter(Sites(home, beside)):
                if not only or any(word in what or word in defect.rules for word in only):
                    found[what].append((home.name, defect))
    return found


def _spread(found: list[tuple[str, Defect]], each: int) -> list[tuple[str, Defect]]:
    """Some of the possible defects of a kind: the same ones each time, from anywhere in the checkout."""

    def order(choice: tuple[str, Defect]) -> str:
        edit = choice[1].edits[-1]
        return hashlib.sha256(f"{edit.file}:{edit.start}".encode()).hexdigest()

    return sorted(found, key=order)[:each]


def _closed(root: Path, every: dict[str, Package], cache: Path) -> dict[str, list[tuple[str, Defect]]]:
    """Defects in systems that are whole, each in the package of the launch file; each edit once."""
    owners = {file: one.name for one in every.values() for file in one.files}
    found: dict[str, dict[object, tuple[str, Defect]]] = defaultdict(dict)
    for system in closed_systems(root, cache):
        named = {end.place.file for end in system.endpoints}
        for what, defect in renamed_ends(system, {file: (root / file).read_bytes() for file in named}):
            owner = owners.get(system.name or "")
            if owner is not None:
                found[what].setdefault(defect.edits, (owner, defect))
    return {what: list(several.values()) for what, several in found.items()}


def _still_parses(target: Path, defect: Defect) -> bool:
    """Whether every changed Python file is still Python."""
    for file in {edit.file for edit in defect.edits if edit.file.endswith(".py")}:
        data = edited((target / file).read_bytes(), [edit for edit in defect.edits if edit.file == file])
        try:
            compile(data, file, "exec", dont_inherit=True)
        except (SyntaxError, ValueError):
            return False
    return True


def _tell(checkout: str, what: str, outcome: Outcome, options: argparse.Namespace) -> None:
    edit = outcome.defect.edits[-1]
    if options.misses and outcome.found is None:
        places = ", ".join(f"{place.file}:{place.first}" for place in outcome.defect.places)
        print(
            f"missed: {what}: {checkout}: {edit.text.decode()!r} in {edit.file}, expected at {places}",
            flush=True,
        )
    if options.noise:
        for one in outcome.others:
            print(
                f"also: {what}: {checkout}: {edit.text.decode()!r} in {edit.file}: "
                f"{one.code} {one.place.file}:{one.place.line} {one.message}",
                flush=True,
            )


def _print_table(outcomes: dict[str, list[Outcome]]) -> None:
    print("| defect | rule | planted | found at its place | other new findings |")
    print("|---|---|---|---|---|")
    total = [0, 0, 0]
    for what, several in sorted(outcomes.items(), key=lambda item: (item[1][0].defect.rules, item[0])):
        row = [
            len(several),
            sum(one.found is not None for one in several),
            sum(len(one.others) for one in several),
        ]
        total = [one + other for one, other in zip(total, row, strict=True)]
        print(f"| {what} | {', '.join(several[0].defect.rules)} | " + " | ".join(map(str, row)) + " |")
    print("| all | | " + " | ".join(map(str, total)) + " |")


if __name__ == "__main__":
    main()
