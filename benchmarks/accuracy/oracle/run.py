"""Run every program and every node class of a repository, each in a process of its own, and merge what
they created."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from .processes import Pool, Python
from .workspace import Source, Workspace, entry_point, is_test, read

_KILLED_AFTER = 120.0  # seconds; a job limits itself, this is for one that cannot

Line = dict[str, Any]


@dataclass
class Job:
    """One process: what it runs, and the lines that it wrote."""

    kind: str
    label: str
    spec: dict[str, Any]
    lines: list[Line] = field(default_factory=list)

    @property
    def failures(self) -> list[Line]:
        """What stopped it."""
        return [line for line in self.lines if line["what"] == "failed"]


class Oracle:
    """All runs of one repository."""

    def __init__(self, root: Path, jobs: int = 2, processes: Pool | None = None, patience: float = 1.0) -> None:
        self._patience = patience
        self._processes = processes or Pool(Python())
        self._close = processes is None
        self.workspace: Workspace = read(root.resolve())
        self._pool = ThreadPoolExecutor(jobs)
        self._jobs: list[Job] = []

    def run(self, *, plain: bool = False) -> dict[str, Any]:
        """Programs first, then the classes that no program made, then conditions turned over, then the rest.

        With ``plain``, the first two only, each once.
        """
        programs = self._start(self._programs())
        if plain:
            self._start(self._classes())
        else:
            self._again(programs)
            classes = self._start(self._classes())
            self._again(classes)
            self._start(self._other_way([*programs, *classes]))
            self._start(self._untouched())
        self._pool.shutdown()
        if self._close:
            self._processes.close()
        return _merged(self.workspace, self._jobs)

    def _start(self, jobs: Iterable[Job]) -> list[Job]:
        started = list(self._pool.map(self._execute, jobs))
        self._jobs.extend(started)
        return started

    def _again(self, jobs: list[Job]) -> None:
        """Once more with failing statements skipped, for what did not come to its end."""
        stopped = [
            job
            for job in jobs
            if any(line["what"] in ("failed", "broke", "cut") for line in job.lines) or not job.lines
        ]
        self._start(Job(job.kind, job.label, {**job.spec, "resume": True}) for job in stopped)

    def _execute(self, job: Job) -> Job:
        with tempfile.TemporaryDirectory(prefix="oracle-") as scratch:
            out = Path(scratch, "out.jsonl")
            spec = {
                "root": str(self.workspace.root),
                "packages": self.workspace.packages,
                "interfaces": self.workspace.interfaces,
                "out": str(out),
                "scratch": scratch,
                "kind": job.kind,
                "real": self._processes.python.real,
                "patience": self._patience,
                "path_first": [],
                "path_last": [],
                **job.spec,
            }
            Path(scratch, "job.json").write_text(json.dumps(spec), encoding="utf-8")
            noise = self._processes.run(Path(scratch), _KILLED_AFTER)
            if out.exists():
                job.lines = [
                    json.loads(line) for line in out.read_text(encoding="utf-8").splitlines() if line.endswith("}")
                ]
            if noise:
                job.lines.append({"what": "failed", "phase": "main", "step": "process", "reason": noise, "where": None})
        return job

    # What to run ---------------------------------------------------------------------------------
    def _programs(self) -> list[Job]:
        jobs: dict[tuple[str, str], Job] = {}
        reached: set[tuple[str, str]] = set()
        for script, folder in self._scripts():
            entry = entry_point(script)
            file = self._file_of(entry[1], folder) if entry else None
            if entry is None or file is None:
                continue
            relative = file.relative_to(self.workspace.root).as_posix()
            reached.add((relative, entry[2]))
            spec = {"module": entry[1], "function": entry[2], "file": str(file), **self._paths(file, folder)}
            jobs[(relative, entry[2])] = Job("entry", f"{relative}:{entry[2]}", spec)
        for source in self._sources():
            if (
                source.is_program()
                and (source.relative, source.guard_calls() or "") not in reached
                and self._about_ros(source)
            ):
                spec = {"file": str(source.path), **self._paths(source.path)}
                jobs[(source.relative, "")] = Job("script", source.relative, spec)
        return [jobs[key] for key in sorted(jobs)]

    def _scripts(self) -> list[tuple[str, Path]]:
        setups = [
            path for path in self.workspace.setups if not is_test(path.relative_to(self.workspace.root).as_posix())
        ]
        jobs = [Job("setup", str(path), {"file": str(path), "path_first": [str(path.parent)]}) for path in setups]
        found = list(self.workspace.configured)
        for path, job in zip(setups, self._pool.map(self._execute, jobs), strict=True):
            for line in job.lines:
                found.extend((script, path.parent) for script in line.get("scripts", []))
        return found

    def _file_of(self, module: str, folder: Path) -> Path | None:
        tail = Path(*module.split("."))
        for root in (folder, folder / "src", *self.workspace.roots):
            for file in (root / tail.with_suffix(".py"), root / tail / "__init__.py"):
                if file.is_file():
                    return file
        return None

    def _classes(self) -> list[Job]:
        done = {place for line in self._lines("node") for place in line["classes"]}
        jobs = []
        for source in self._sources():
            if source.mentions_ros and source.tree and "class " in source.text:
                jobs.append(self._module_job("classes", source, {"done": sorted(done)}))
        return jobs

    def _other_way(self, jobs: list[Job]) -> list[Job]:
        """What holds, or made, an object of a file with untouched calls, with its conditions turned over."""
        seen = {(line["file"], line["line"]) for line in self._lines("entity")}
        open_files = {
            source.relative
            for source in self._sources()
            if any((source.relative, line) not in seen for line, _ in source.create_sites())
        }
        again = []
        for job in jobs:
            made = {place.rpartition(":")[0] for line in job.lines for place in line.get("classes", ())}
            if open_files & {job.label.partition(":")[0], *made}:
                spec = {**job.spec, "resume": True, "other_way": True, "done": []}
                again.append(Job(job.kind, job.label, spec))
        return again

    def _untouched(self) -> list[Job]:
        seen = {(line["file"], line["line"]) for line in self._lines("entity")}
        jobs = []
        for source in self._sources():
            sites = [
                (line, name) for line, name in source.create_sites() if (source.relative, line) not in seen and name
            ]
            if sites:
                functions = sorted({name for _, name in sites})
                jobs.append(self._module_job("forced", source, {"functions": functions, "resume": True}))
        return jobs

    def _module_job(self, kind: str, source: Source, more: dict[str, Any]) -> Job:
        module, top = self.workspace.module_of(source.path)
        paths = self._paths(source.path)
        # The folder of a package's module is not on the path: it would shadow the library.
        own = [path for path in paths["path_first"] if path != str(source.path.parent)]
        paths["path_first"] = list(dict.fromkeys([str(top), *own]))
        spec = {"module": module, "file": str(source.path), "relative": source.relative, **paths, **more}
        return Job(kind, source.relative, spec)

    def _paths(self, file: Path, folder: Path | None = None) -> dict[str, list[str]]:
        """The package's own folders come before the library, everybody else's after it."""
        _, top = self.workspace.module_of(file)
        first = [folder, folder / "src"] if folder else [*([top] if top != file.parent else []), file.parent]
        own = [str(path) for path in [*first, *self.workspace.own_roots(file)] if path != self.workspace.root]
        others = [str(path) for path in [self.workspace.root, *self.workspace.roots] if str(path) not in own]
        return {"path_first": list(dict.fromkeys(own)), "path_last": others}

    def _sources(self) -> list[Source]:
        passed_over = ("setup.py", "conf.py")
        return [
            source
            for source in self.workspace.sources
            if not is_test(source.relative)
            and source.path.name not in passed_over
            and not source.relative.endswith((".launch.py", "_launch.py"))
            and "generate_launch_description" not in source.text
        ]

    def _about_ros(self, source: Source) -> bool:
        if source.mentions_ros:
            return True
        near = self.workspace.own_roots(source.path)[:1]
        return any(
            other.mentions_ros for other in self.workspace.sources for root in near if other.path.is_relative_to(root)
        )

    def _lines(self, what: str) -> list[Line]:
        return [line for job in self._jobs for line in job.lines if line["what"] == what]


def _merged(workspace: Workspace, jobs: list[Job]) -> dict[str, Any]:
    """One record for each entity; a site that a plain run reached is decided by plain runs alone."""
    records: dict[str, Line] = {}
    best: dict[tuple[str, int], int] = {}
    for job in jobs:
        for line in job.lines:
            if line["what"] == "entity":
                line["rank"] = _rank(job, line)
                line["resumed"] = bool(job.spec.get("resume"))
                line["other_way"] = bool(job.spec.get("other_way"))
                place = (line["file"], line["line"])
                best[place] = min(best.get(place, 9), line["rank"])
    for job in jobs:
        for line in job.lines:
            if line["what"] != "entity" or line["rank"] > best[(line["file"], line["line"])]:
                continue
            key = json.dumps(
                [
                    line.get(name)
                    for name in ("kind", "file", "line", "column", "name", "type", "period_s", "qos", "node", "class")
                ]
            )
            kept = records.setdefault(
                key, {key: value for key, value in line.items() if key not in ("what", "rank")} | {"by": []}
            )
            if job.label not in kept["by"] and len(kept["by"]) < 3:
                kept["by"].append(job.label)
    entities = sorted(records.values(), key=_order)
    return {
        "version": 1,
        "repository": workspace.root.name,
        "entities": entities,
        "nodes": _unique(line for job in jobs for line in job.lines if line["what"] == "node" and line.get("file")),
        "parameters": _unique(line for job in jobs for line in job.lines if line["what"] == "parameter"),
        "refused": _unique(line for job in jobs for line in job.lines if line["what"] == "refused"),
        "runs": [_report(job) for job in jobs],
        "unreached": _unreached(workspace, entities),
    }


def _order(line: Line) -> tuple[Any, ...]:
    return (line["file"], line["line"], line["column"], line["kind"], line["name"] or "", str(line["node"]))


def _rank(job: Job, line: Line) -> int:
    """0: a plain run; 1: failing statements skipped; 2: conditions turned over as well; 3: called by force."""
    if line["phase"] == "forced":
        return 3
    if job.spec.get("other_way"):
        return 2
    return 1 if job.spec.get("resume") else 0


def _report(job: Job) -> Line:
    failures = [{name: line.get(name) for name in ("step", "target", "reason", "where")} for line in job.failures]
    broken = [
        {name: line.get(name) for name in ("step", "reason", "where")}
        for line in job.lines
        if line["what"] in ("broke", "cut")
    ]
    entities = sum(line["what"] == "entity" for line in job.lines)
    return {
        "kind": job.kind, "target": job.label, "resumed": bool(job.spec.get("resume")),
        "other_way": bool(job.spec.get("other_way")),
        "ended": not failures and any(line["what"] == "ran" for line in job.lines), "entities": entities,
        "failures": failures, "broken_callbacks": broken[:10],
    }  # fmt: skip


def _unique(lines: Iterable[Line]) -> list[Line]:
    found = {
        json.dumps({key: value for key, value in line.items() if key not in ("what", "via")}, sort_keys=True): line
        for line in lines
    }
    return [{key: value for key, value in found[key].items() if key != "what"} for key in sorted(found)]


def _unreached(workspace: Workspace, entities: list[Line]) -> list[Line]:
    """Calls that are written like create calls and that no run came to."""
    seen = {(line["file"], line["line"]) for line in entities}
    return [
        {"file": source.relative, "line": line, "function": function}
        for source in workspace.sources
        if not is_test(source.relative) and source.path.name != "setup.py"
        for line, function in source.create_sites()
        if (source.relative, line) not in seen
    ]
