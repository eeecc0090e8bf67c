"""The second step of ``action.yml``: run archlint as the inputs say, and tell GitHub what came of it.

Needs Python alone, and the formats that archlint's users rely on: it also runs with a release of archlint.
The inputs arrive as variables ``INPUT_…`` and become words of a command, never text of a shell.
"""

from __future__ import annotations

import json
import os
import secrets
import shlex
import subprocess
import sys
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from drawing import Draughtsman, Drawing
from summary import SourceLinks, failure, markdown

LIMIT = 1_000_000
"""Bytes of a summary; GitHub shows none that is larger than 1 MiB, and other steps write to it, too."""


class WrongInput(Exception):
    """An input that nothing can be done with; ``str()`` says what is wrong."""


@dataclass(frozen=True)
class Step:
    """What the environment of the step says."""

    variables: Mapping[str, str]

    def given(self, name: str, otherwise: str = "") -> str:
        value = self.variables.get(f"INPUT_{name}", "").strip() or otherwise
        if name != "PATHS" and not value.isprintable():
            raise WrongInput(f"{_input(name)} has a character that cannot be printed")
        return value

    def wants(self, name: str) -> bool:
        value = self.given(name, "true").lower()
        if value not in ("true", "false"):
            raise WrongInput(f"{_input(name)} is true or false, not {value!r}")
        return value == "true"

    @property
    def archlint(self) -> str:
        return self.variables["ARCHLINT"]

    @property
    def folder(self) -> Path:
        """Where to check."""
        folder = Path(self.given("WORKING_DIRECTORY", "."))
        if not folder.is_dir():
            raise WrongInput(f"working-directory: there is no folder {folder.as_posix()}")
        return folder.resolve()

    @property
    def temporary(self) -> Path:
        return Path(self.variables["RUNNER_TEMP"], "archlint")

    @property
    def cache(self) -> Path:
        return Path(self.variables.get("ARCHLINT_CACHE") or self.temporary / "cache")

    @property
    def paths(self) -> list[str]:
        lines = [line.strip() for line in self.given("PATHS", ".").splitlines()]
        return [_no_option(line) for line in lines if line]

    @property
    def options(self) -> list[str]:
        """What the user wants otherwise, in words."""
        try:
            return shlex.split(self.given("ARGS"))
        except ValueError as error:
            raise WrongInput(f"args cannot be split into words: {error}") from None

    @property
    def since(self) -> str:
        """The revision of ``new-only``; empty where everything is to be reported."""
        wanted = self.given("NEW_ONLY")
        if wanted != "pull-request":
            return wanted
        base = self.variables.get("GITHUB_BASE_REF", "")
        return f"origin/{base}" if base else ""

    @property
    def results(self) -> tuple[Path, Path]:
        """The files of the findings, as JSON and as SARIF."""
        sarif = self.given("SARIF_FILE")
        return self.temporary / "archlint.json", self.folder / sarif if sarif else self.temporary / "archlint.sarif"

    def environment(self) -> dict[str, str]:
        """That of archlint: its key is kept beside its cache, without which the cache of another machine is void."""
        kept = {name: value for name, value in self.variables.items() if not name.startswith(("INPUT_", "PYTHON"))}
        return kept | {"XDG_CONFIG_HOME": str(self.cache / "key"), "CI": "true"}

    def check(self) -> list[str]:
        """The command.  The user's options come first, so that none of them changes where the results are."""
        baseline, since = self.given("BASELINE"), self.since
        found, sarif = self.results
        return [
            *(self.archlint, "check", *self.paths, *self.options),
            *(("--baseline", baseline) if baseline else ()),
            *(("--new-only", since) if since else ()),
            *("--cache-dir", str(self.cache / "results")),
            *("--format", "github" if self.wants("ANNOTATIONS") else "text"),
            *("--output", f"json={found}", "--output", f"sarif={sarif}"),
        ]

    def graph(self) -> list[str]:
        """The command that draws what lies in the paths that follow it."""
        return [
            *(self.archlint, "graph", "--format", "mermaid", "--quiet"),
            *("--cache-dir", str(self.cache / "results")),
        ]

    def difference(self) -> list[str]:
        """The command that draws what has changed since the revision of ``new-only``; empty without one."""
        if not self.since:
            return []
        return [
            *(self.archlint, "diff", self.since, "--format", "mermaid", "--quiet"),
            *("--cache-dir", str(self.cache / "results"), "--paths", *self.paths),
        ]


def main(variables: Mapping[str, str]) -> int:
    step = Step(variables)
    try:
        command, folder, environment = step.check(), step.folder, step.environment()
        wants_summary, wants_graph = step.wants("SUMMARY"), step.wants("GRAPH")
    except WrongInput as error:
        return _failed(str(error), variables)
    found, sarif = step.results
    try:
        for path in (found, sarif):
            path.parent.mkdir(parents=True, exist_ok=True)
            path.unlink(missing_ok=True)
    except OSError as error:
        return _failed(f"cannot write {error.filename}: {error.strerror}", variables)
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, check=False)
    status, messages = done.returncode, done.stderr.decode("utf-8", "replace")
    findings = done.stdout.decode("utf-8", "replace")
    if step.wants("ANNOTATIONS"):
        print(findings, end="", flush=True)
    else:
        _show(findings)
    _show(messages)
    if not found.is_file():
        return _failed(messages.strip() or f"archlint ended with exit status {status}", variables, status)
    outputs = {"exit-code": str(status)}
    report = json.loads(found.read_text("utf-8"))
    counts = report["summary"]
    outputs |= {"findings": str(len(report["diagnostics"])), "json-file": str(found)}
    outputs |= {name: str(counts[name]) for name in ("errors", "warnings", "infos")}
    if sarif.is_file():
        outputs["sarif-file"] = str(sarif)
    _append(variables, "GITHUB_OUTPUT", _lines(outputs))
    if wants_summary:
        draughtsman = Draughtsman(step.graph(), folder, environment, step.difference())
        drawing = draughtsman.of(report) if wants_graph else Drawing()
        text = markdown(report, drawing, SourceLinks.of(variables, folder), step.since)
        if len(text.encode()) < LIMIT:
            _append(variables, "GITHUB_STEP_SUMMARY", text)
    return status


def _show(text: str) -> None:
    """Print what may hold text of the source, such as ``##[add-mask]`` in a comment, of which GitHub does nothing."""
    if text:
        token = secrets.token_hex(16)
        print(f"::stop-commands::{token}\n{text.rstrip()}\n::{token}::", flush=True)


def _failed(message: str, variables: Mapping[str, str], status: int = 2) -> int:
    """Say why there are no findings, where people look: at the job, and in its summary."""
    print(f"::error title=archlint::{_escaped(message)}", flush=True)
    _append(variables, "GITHUB_OUTPUT", _lines({"exit-code": str(status)}))
    _append(variables, "GITHUB_STEP_SUMMARY", failure(message))
    return status


def _escaped(message: str) -> str:
    """As GitHub's commands need it."""
    return message.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _no_option(path: str) -> str:
    """A path as a word that cannot be taken for an option."""
    return f"./{path}" if path.startswith("-") else path


def _input(name: str) -> str:
    return name.lower().replace("_", "-")


def _lines(outputs: Mapping[str, str]) -> str:
    return "".join(f"{name}={value}\n" for name, value in outputs.items())


def _append(variables: Mapping[str, str], name: str, text: str) -> None:
    """Add to one of the files by which a step tells GitHub something, if there is one."""
    if variables.get(name):
        with open(variables[name], "a", encoding="utf-8") as stream:
            stream.write(text)


if __name__ == "__main__":
    sys.exit(main(os.environ))
