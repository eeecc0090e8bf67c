"""Holds what archlint says of launch files against what launch itself would start: ``python -m
benchmarks.launches.compare RECORDS CHECKOUT… [--misses]``, where RECORDS is the folder that ``record`` wrote.

Each node of each run (defaults, and one other value of one argument at a time) is compared in package, executable,
name, namespace, remappings, parameters with their files, and presence: whether it is started under these arguments.
*Equal* is a node with all of them equal. What archlint leaves *unknown* is not equal, except where the environment or
a command's output decides the value: nobody can know these from the sources. The environment does so where archlint
names the variable, and the run did ask for it and did not find it. *Wrong* is a node of which something known differs;
one that only one side starts counts as one node.
"""

from __future__ import annotations

import json
import re
import sys
from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

from archlint.interpreter.library import INSTALL_FOLDER
from archlint.launch.functions import PROCESS_END, PROCESS_OUTPUT
from archlint.launch.moveit_configs.collected import FOLDER_ORDER
from archlint.launch.read_files import FILE_OF_THE_MACHINE
from benchmarks.launches.expected import MADE, Checkout, Row, Unknown, recorded
from benchmarks.launches.inside.guard import FROM_OUTSIDE, OUTPUT

FIELDS = ("package", "executable", "name", "namespace", "remaps", "parameters", "presence")
HEAD = f"| checkout | launch files | do not load | runs | nodes | {' | '.join(FIELDS)} | equal | unknown | wrong |"
HEAD += "\n|---|" + "---|" * (len(FIELDS) + 7)
EQUAL, OPEN, WRONG = "equal", "unknown", "wrong"
OUTSIDE = (OUTPUT, FROM_OUTSIDE)
DOCUMENT = 500
"""From this length on, a text is a document that code of the launch file has read, a robot's description mostly."""


def main() -> None:
    records, *roots = [Path(word).resolve() for word in sys.argv[1:] if not word.startswith("-")]
    print(HEAD)
    total: Counter[str] = Counter()
    for root in roots:
        counts, told = measure(json.loads((records / f"{root.name}.json").read_text()), Checkout(root))
        total += counts
        print(line(root.name.replace("+", "/"), counts), flush=True)
        if "--misses" in sys.argv:
            print("".join(f"    {words}\n" for words in told), end="", flush=True)
    print(line("all", total))


def measure(record: list[dict[str, Any]], checkout: Checkout) -> tuple[Counter[str], list[str]]:
    counts: Counter[str] = Counter()
    told: list[str] = []
    for row in record:
        counts["files"] += 1
        whole = [run for run in row["runs"] if run["error"] is None]
        if not whole:
            counts["failed"] += 1
            told.append(f"does not load: {row['file']}: {row['runs'][0]['error'][:300]!r}")
        for run in whole:
            counts["runs"] += 1
            launched, ours = checkout.launch(row["file"], run["arguments"])
            where = " ".join([row["file"], *(f"{name}:={value}" for name, value in run["arguments"].items())])
            for verdicts, words in compared(recorded(run["nodes"]), ours, frozenset(run.get("environment") or ())):
                counts["nodes"] += 1
                worst = max(verdicts.values(), key=(EQUAL, OPEN, WRONG).index)
                counts[worst] += 1
                counts.update(name for name, verdict in verdicts.items() if verdict == EQUAL)
                if worst != EQUAL:
                    gaps = [] if launched is None else sorted({gap.reason for gap in launched.not_followed()})
                    more = f"  [not followed: {'; '.join(gaps)[:200]}]" if gaps and "missing" in words else ""
                    told.append(f"{worst}: {where}: {words}{more}" + (" [no launch file]" if launched is None else ""))
    return counts, told


def compared(
    real: list[Row], ours: list[Row], variables: frozenset[str] = frozenset()
) -> Iterator[tuple[dict[str, str], str]]:
    """For each node the verdict on each field, and the differences in words; ``variables`` are those that the run
    asked for and that are not set, or different on each machine."""
    for other in ours:
        _take_as_outside(other, variables)
    pairs = _paired(real, ours)
    for one, other in pairs:
        verdicts = {name: verdict(one, other, name) for name in FIELDS[:-1]}
        verdicts["presence"] = OPEN if other.undecided and not other.outside else EQUAL
        yield verdicts, f"{_shown(one)} {other.where}: " + "; ".join(_differences(one, other, verdicts))
    met = {id(one) for one, _ in pairs}
    for one in real:
        if id(one) not in met:
            yield dict.fromkeys(FIELDS, WRONG), f"missing: {_shown(one)} {one.where or ''}"
    met = {id(other) for _, other in pairs}
    for other in ours:
        if id(other) not in met and not (other.undecided and other.outside):
            how = OPEN if other.undecided else WRONG
            yield dict.fromkeys(FIELDS, how), f"more: {_shown(other)} {other.where}"


def _paired(real: list[Row], ours: list[Row]) -> list[tuple[Row, Row]]:
    """Which node of one side is which of the other: those with most fields equal first, in the order of launch."""
    scores = []
    for number, one in enumerate(real):
        for index, other in enumerate(ours):
            verdicts = [verdict(one, other, name) for name in FIELDS[:-1]]
            same = one.fields["executable"] == other.fields["executable"] or isinstance(
                other.fields["executable"], Unknown
            )
            if same and (one.kind == other.kind or "component" not in (one.kind, other.kind)):
                scores.append(
                    (-verdicts.count(EQUAL), verdicts.count(WRONG), other.undecided, abs(number - index), number, index)
                )
    left, free, found = set(range(len(real))), set(range(len(ours))), []
    for *_, number, index in sorted(scores):
        if number in left and index in free:
            left.remove(number)
            free.remove(index)
            found.append((number, index))
    return [(real[number], ours[index]) for number, index in sorted(found)]


def verdict(real: Row, ours: Row, name: str) -> str:
    if name == "parameters":
        return _of_parameters(real, ours)
    return same(real.fields[name], ours.fields[name])


def same(real: object, ours: object) -> str:
    if isinstance(ours, Unknown):
        return EQUAL if ours.outside or _is_outside(real) else OPEN
    if ours == MADE:
        return EQUAL if isinstance(real, str) and _SANDBOX.search(real) else WRONG
    if isinstance(real, list) and isinstance(ours, list):
        if len(real) != len(ours):
            return EQUAL if _is_outside(real) and all(isinstance(one, Unknown) for one in ours) else WRONG
        return max(
            (same(*pair) for pair in zip(real, ours, strict=True)), key=(EQUAL, OPEN, WRONG).index, default=EQUAL
        )
    return EQUAL if type(real) is type(ours) and (real == ours or real != real) else WRONG


def _is_outside(value: object) -> bool:
    if isinstance(value, list):
        return any(map(_is_outside, value))
    outside = isinstance(value, str) and (any(word in value for word in OUTSIDE) or _SANDBOX.search(value))
    return bool(outside) or (isinstance(value, str) and len(value) > DOCUMENT)


_SANDBOX = re.compile(r"/launches-\w+/work\b|<[\w.]+ object at 0x[0-9a-f]+>")
"""The home folder of a run, and what it makes up for temporary files; where an object lies in the memory of a run."""


def _of_parameters(real: Row, ours: Row) -> str:
    unseen, wrong = _of_each(real, ours)
    unseen = [] if ours.may_have_more else unseen
    found = [WRONG] if wrong or (unseen and not _may_have_more(ours)) else [OPEN] if unseen else []
    if real.kind != "component":
        files = same(real.fields["files"], ours.fields["files"])
        found.append(_where_files_may_be_more(real, ours) if files == WRONG and ours.open else files)
    found += [how for how, _ in _values(real, ours)]
    return max(found, key=(EQUAL, OPEN, WRONG).index, default=EQUAL)


def _where_files_may_be_more(real: Row, ours: Row) -> str:
    first, second = real.fields["files"], ours.fields["files"]
    assert isinstance(first, list) and isinstance(second, list)
    return EQUAL if ours.may_have_more and all(file in first for file in second) else OPEN


def _may_have_more(ours: Row) -> bool:
    """Whether archlint says that there may be parameters that it does not know."""
    files = ours.fields["files"]
    return bool(ours.open) or (isinstance(files, list) and any(isinstance(one, Unknown) for one in files))


_VARIABLE = re.compile(r"the environment variable (\w+)")


_COMMAND = re.compile(r"\b(?:subprocess\.(?:run|Popen|check_output|getoutput)|os\.popen|platform\.node)\b")
_ELSEWHERE = re.compile(r"^'\$\(find-pkg-share [\w-]+\)/\S+', which is not in this workspace, may set it$")
"""A value in front of a file of another package: the records have an empty file in its place."""
_OF_THE_MACHINE = (FOLDER_ORDER, PROCESS_END, PROCESS_OUTPUT, FILE_OF_THE_MACHINE, INSTALL_FOLDER)


def _is_asked(why: str, variables: frozenset[str]) -> bool:
    """Whether a reason names a variable that the run did ask for, or what only the machine can tell: what a command
    prints, what its name is, how a process ends, which files there are outside of the workspace, in which order a
    folder lists them, what is around the folder that the workspace is installed to."""
    found = _VARIABLE.search(why)
    machine = any(words in why for words in _OF_THE_MACHINE) or _COMMAND.search(why) or _ELSEWHERE.search(why)
    return (found is not None and found[1] in variables) or bool(machine)


def _take_as_outside(row: Row, variables: frozenset[str]) -> None:
    """Note what is not known for want of a variable."""
    row.outside = bool(row.undecided_by) and all(_is_asked(why, variables) for why in row.undecided_by)
    files = row.fields["files"]
    assert isinstance(files, list)
    why_more = [*row.open, *(file.reason for file in files if isinstance(file, Unknown))]
    row.may_have_more = bool(why_more) and all(_is_asked(why, variables) for why in why_more)
    row.fields = {name: _marked(value, variables) for name, value in row.fields.items()}


def _marked(value: object, variables: frozenset[str]) -> object:
    if isinstance(value, Unknown):
        return replace(value, outside=_is_asked(value.reason, variables))
    if isinstance(value, list):
        return [_marked(item, variables) for item in value]
    if isinstance(value, dict):
        return {key: _marked(item, variables) for key, item in value.items()}
    return value


def _of_each(real: Row, ours: Row) -> tuple[list[Any], list[Any]]:
    """The parameters that only one side sets."""
    first, second = real.fields["parameters"], ours.fields["parameters"]
    assert isinstance(first, dict) and isinstance(second, dict)
    return [key for key in first if key not in second], [key for key in second if key not in first]


def _values(real: Row, ours: Row) -> Iterator[tuple[str, str]]:
    first, second = real.fields["parameters"], ours.fields["parameters"]
    assert isinstance(first, dict) and isinstance(second, dict)
    for key, value in first.items():
        if key in second:
            yield same(value, second[key]), f"{'.'.join(key)} is {_short(value)}, not {_short(second[key])}"


def _differences(real: Row, ours: Row, verdicts: dict[str, str]) -> Iterator[str]:
    for name, how in verdicts.items():
        if name == "parameters" and how != EQUAL:
            for only, side in zip(_of_each(real, ours), ("not seen", "not there"), strict=True):
                if only:
                    yield f"parameters {side}: {only[:4]} ({len(only)})"
            yield from [line for verdict, line in _values(real, ours) if verdict != EQUAL][:3]
            if real.kind != "component" and same(real.fields["files"], ours.fields["files"]) != EQUAL:
                yield f"files {_short(real.fields['files'])}, not {_short(ours.fields['files'])}"
            yield from (f"open: {why}" for why in ours.open)
        elif name == "presence" and how != EQUAL:
            yield f"not known whether it is started ({'; '.join(ours.undecided_by)})"
        elif how != EQUAL:
            yield f"{name} {_short(real.fields[name])}, not {_short(ours.fields[name])}"


def _short(value: object) -> str:
    text = repr(value)
    return text if len(text) < 300 else f"{text[:300]}…"


def _shown(row: Row) -> str:
    return f"{row.kind} {row.fields['package']}/{row.fields['executable']}"


def line(name: str, counts: Counter[str]) -> str:
    nodes = counts["nodes"] or 1
    cells = [str(counts[key]) for key in ("files", "failed", "runs", "nodes")]
    cells += [f"{100 * counts[key] / nodes:.1f} %" for key in FIELDS]
    cells.append(f"{100 * counts[EQUAL] / nodes:.2f} %")
    return f"| {name} | " + " | ".join([*cells, str(counts[OPEN]), str(counts[WRONG])]) + " |"


if __name__ == "__main__":
    main()
