"""The scripts of ``action.yml``, run as GitHub runs them: what an input or a step's output says becomes a variable, and
each step tells what it has to in a file of its own."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import yaml

from benchmarks.adoption.programs import ROOT, Done, Programs

_EXPRESSION = re.compile(r"\$\{\{ (inputs|steps\.(\w+)\.outputs)\.([\w-]+) \}\}")


class Action:
    """One use of the action; ``temporary`` stands for the runner's temporary folder."""

    def __init__(self, programs: Programs, checkout: Path, temporary: Path, inputs: Mapping[str, str]) -> None:
        action = yaml.safe_load((ROOT / "action.yml").read_text("utf-8"))
        self._inputs = {name: str(about["default"]) for name, about in action["inputs"].items()} | {**inputs}
        self._steps = {step["id"]: step for step in action["runs"]["steps"] if "run" in step}
        self._programs, self._checkout, self._temporary = programs, checkout, temporary
        self.outputs: dict[str, dict[str, str]] = {}
        """By the step and the name."""
        self.summary = temporary / "summary.md"

    def run(self, name: str, **variables: str) -> Done:
        """The step with this id, and what it says."""
        step: dict[str, Any] = self._steps[name]
        output = self._temporary / f"output-of-{name}"
        output.write_text("", "utf-8")
        given = {variable: self._resolved(str(value)) for variable, value in step["env"].items()}
        of_github = {
            "GITHUB_ACTION_PATH": str(ROOT),
            "GITHUB_OUTPUT": str(output),
            "GITHUB_STEP_SUMMARY": str(self.summary),
            "GITHUB_WORKSPACE": str(self._checkout),
            "RUNNER_TEMP": str(self._temporary),
        }
        words = ["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c", step["run"]]
        done = self._programs.run(words, self._checkout, **of_github, **given, **variables)
        self.outputs[name] = dict(line.split("=", 1) for line in output.read_text("utf-8").splitlines())
        return done

    def _resolved(self, text: str) -> str:
        def value(found: re.Match[str]) -> str:
            return self._inputs[found[3]] if found[1] == "inputs" else self.outputs[found[2]].get(found[3], "")

        return _EXPRESSION.sub(value, text)
