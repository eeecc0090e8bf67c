"""The steps of the story, each a function that returns what to say of it."""

from __future__ import annotations

import importlib.util
import json
import os
import urllib.request
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from benchmarks.adoption.action import Action
from benchmarks.adoption.language_client import Session, Silence
from benchmarks.adoption.programs import ROOT, Done, Programs
from benchmarks.adoption.workspace import NAME, Workspace

CODE = "TOP001"
"""What the mistake in the added package is reported as."""
_SARIF_SCHEMA = "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json"
_HOOK = """\
repos:
  - repo: {repository}
    rev: {revision}
    hooks:
      - id: archlint
"""


class Failed(Exception):
    """A step that did not go as the documents say."""


class Skipped(Exception):
    """A step for which something is missing here; ``str()`` says what."""


@dataclass
class Story:
    """What the steps share."""

    workspace: Workspace
    programs: Programs
    kept: Path
    """The folder for what they write down: the summary, the SARIF, the session of the editor."""
    report: dict[str, Any] = field(default_factory=dict)
    """The findings of the pull request, and ``sarif`` the file of the same."""
    sarif: Path = Path()

    @property
    def root(self) -> Path:
        return self.workspace.root

    def archlint(self, *words: str) -> Done:
        return self.programs.archlint(self.root, *words)


def start(story: Story) -> str:
    """`archlint init` writes files with which the workspace passes."""
    written = _expect(0, story.archlint("init"))
    _expect(0, story.archlint("check", "--quiet"))
    baseline = story.root / "archlint-baseline.txt"
    lines = baseline.read_text("utf-8").splitlines() if baseline.is_file() else []
    held = sum(bool(line) and not line.startswith("#") for line in lines)
    taken, said = story.workspace.commit("archlint init")
    _require(taken, said)
    return f"{written.out.count('wrote ')} files; {held} entries in the baseline; the check passes"


def workflow(story: Story) -> str:
    """The workflow that it wrote is valid by GitHub's schema, and zizmor has nothing against the action."""
    if importlib.util.find_spec("check_jsonschema") is None:
        raise Skipped("no check-jsonschema")
    path = story.root / ".github" / "workflows" / "archlint.yml"
    words = [story.programs.python, "-m", "check_jsonschema", "--builtin-schema", "vendor.github-workflows", path]
    _expect(0, story.programs.run(words, story.root))
    if not story.programs.has("zizmor"):
        return f"{path.name} is valid; the action is not audited: `make adoption` does it"
    audit = [story.programs.folder / "zizmor", "--offline", "--persona", "auditor", ROOT / "action.yml"]
    _expect(0, story.programs.run(audit, story.root))
    return f"{path.name} is valid; zizmor finds nothing in action.yml"


def hook(story: Story) -> str:
    """pre-commit installs the hook from a repository; a bad commit is refused, a good one taken."""
    if not story.programs.has("pre-commit"):
        raise Skipped("no pre-commit: `make adoption` brings it")
    if not (ROOT / ".git").exists():
        raise Skipped("this is no checkout of archlint's repository")
    bare = story.kept / "archlint.git"
    _expect(0, story.programs.git(story.kept, "clone", "-q", "--bare", ROOT, bare))
    revision = _expect(0, story.programs.git(bare, "rev-parse", "HEAD")).out.strip()
    configuration = _HOOK.format(repository=bare, revision=revision)
    (story.root / ".pre-commit-config.yaml").write_text(configuration, "utf-8")
    _expect(0, story.programs.run([story.programs.folder / "pre-commit", "install"], story.root))
    story.workspace.add_package(mistake=True)
    taken, said = story.workspace.commit("a bad one")
    _require(not taken and CODE in said, said)
    story.workspace.add_package(mistake=False)
    taken, said = story.workspace.commit("a good one")
    _require(taken, said)
    return f"{revision[:10]} installed; a commit with {CODE} was refused, the corrected one was taken"


def pull_request(story: Story) -> str:
    """The steps of the action report what the branch brings in, and nothing else."""
    git = story.programs.git
    _expect(0, git(story.root, "update-ref", "refs/remotes/origin/main", "HEAD"))
    _expect(0, git(story.root, "checkout", "-q", "-b", "feature"))
    story.workspace.add_package(mistake=True)
    taken, said = story.workspace.commit("a mistake", "--no-verify")
    _require(taken, said)
    action = Action(story.programs, story.root, story.kept, {"new-only": "pull-request"})
    if story.programs.installs:
        _expect(0, action.run("install"))
    else:
        archlint = str(story.programs.folder / "archlint")
        action.outputs["install"] = {"python": str(story.programs.python), "archlint": archlint}
    done = _expect(1, action.run("check", GITHUB_BASE_REF="main"))
    outputs = action.outputs["check"]
    story.report = json.loads(Path(outputs["json-file"]).read_text("utf-8"))
    story.sarif = Path(outputs["sarif-file"])
    findings = story.report["diagnostics"]
    _require([finding["code"] for finding in findings] == [CODE] and outputs["errors"] == "1", done.said)
    _require(NAME in findings[0]["file"] and "```mermaid" in action.summary.read_text("utf-8"), done.said)
    whole = json.loads(story.archlint("check", "--no-baseline", "--format", "json").out)["summary"]
    every = whole["errors"] + whole["warnings"] + whole["infos"]
    how = "installed by the action" if story.programs.installs else "with archlint from this checkout"
    return f"1 new finding of {every}, at its line, in the summary and in the graph; {how}"


def sarif(story: Story) -> str:
    """The SARIF of the pull request is valid by the official schema."""
    schema = json.loads(_sarif_schema(story.programs.installs))
    import jsonschema  # only here, where it is asked for

    written = json.loads(story.sarif.read_text("utf-8"))
    try:
        jsonschema.validate(written, schema)
    except jsonschema.ValidationError as error:
        raise Failed(error.message) from None
    return f"{len(written['runs'][0]['results'])} result, valid"


def _sarif_schema(from_network: bool) -> bytes:
    """The official schema, of which no package has a copy."""
    if copy := os.environ.get("SARIF_SCHEMA"):
        return Path(copy).read_bytes()
    if not from_network:
        raise Skipped("SARIF_SCHEMA names no copy of the official schema")
    try:
        with urllib.request.urlopen(_SARIF_SCHEMA, timeout=30) as answer:
            return bytes(answer.read())
    except OSError as error:
        raise Skipped(f"no answer from {_SARIF_SCHEMA} ({error}), and SARIF_SCHEMA names no copy") from None


def colcon(story: Story) -> str:
    """The package's own test fails under colcon and passes once the mistake is mended; the JUnit file is counted."""
    if not story.programs.has("colcon"):
        raise Skipped("no colcon: `make adoption` brings it")
    only = ["--base-paths", str(story.workspace.added)]
    base = [story.programs.folder / "colcon", "--log-base", "log"]

    def run(*words: str) -> Done:
        return story.programs.run([*base, *words], story.root)

    for mistake, status in ((True, 1), (False, 0)):
        story.workspace.add_package(mistake)
        _expect(0, run("build", *only))
        run("test", *only)
        counted = _expect(status, run("test-result", "--all", "--verbose"))
        _require((CODE in counted.out) is mistake and "pytest.xml: 1 test," in counted.out, counted.said)
    story.workspace.add_package(mistake=True)
    (story.root / "build" / "archlint").mkdir()
    _expect(0, story.archlint("check", "--exit-zero", "--output", "junit=build/archlint/archlint.xml"))
    counted = _expect(1, run("test-result", "--all", "--verbose"))
    _require(f"archlint.{CODE}" in counted.out, counted.said)
    summary = counted.out.strip().splitlines()[-1]
    return f"the package's test failed and passed; with the JUnit file: {summary.removeprefix('Summary: ')}"


def editor(story: Story) -> str:
    """The language server shows the finding in the file that it is about."""
    if "not installed" in (asked := story.archlint("server", "--help")).err or asked.status != 0:
        raise Skipped("no `archlint server`")
    finding = story.report["diagnostics"][0]
    command = [str(story.programs.folder / "archlint"), "server"]
    session = Session(command, story.root, story.programs.environment())
    try:
        shown = session.diagnostics(story.root / finding["file"])
        status = session.end()
    except (Silence, OSError) as error:
        raise Failed(f"the server: {error}") from None
    finally:
        session.kill()
        lines = [json.dumps(message, sort_keys=True) for message in session.messages]
        (story.kept / "session.jsonl").write_text("\n".join(lines) + "\n", "utf-8")
    codes = [diagnostic["code"] for diagnostic in shown]
    _require(CODE in codes and status == 0, f"shown: {codes}; exit status {status}")
    line = next(shown for shown in shown if shown["code"] == CODE)["range"]["start"]["line"]
    _require(line + 1 == finding["line"], f"{CODE} is shown at line {line + 1}, not {finding['line']}")
    return f"{CODE} shown at line {finding['line']} of the open file, in {len(session.messages)} messages"


STEPS: tuple[Callable[[Story], str], ...] = (start, workflow, hook, pull_request, sarif, colcon, editor)


def _expect(status: int, done: Done) -> Done:
    if done.status != status:
        raise Failed(f"exit status {done.status} instead of {status}: {done.said.strip()}")
    return done


def _require(holds: bool, said: str) -> None:
    if not holds:
        raise Failed(said.strip() or "nothing was said")


__all__ = ["STEPS", "Failed", "Skipped", "Story"]
