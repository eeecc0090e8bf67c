"""``archlint init``: a configuration, a hook and a CI job to start with.  What exists is left as it is."""

from __future__ import annotations

import argparse
import os
import re
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from archlint.cli import console, starter_files, starter_jobs
from archlint.cli.exits import CLEAN, UsageError
from archlint.cli.options import paths_of
from archlint.cli.parser import Parser
from archlint.cli.starter_files import BASELINE, Seen
from archlint.disk import read_regular
from archlint.visible import visible

if TYPE_CHECKING:
    from archlint.config.settings import Settings
    from archlint.report.model import Report
    from archlint.systems.model import System

_MAX_BYTES = 1_000_000
_EXAMPLES = 5
"""How many of a kind a comment lists."""


def parser() -> Parser:
    parser = Parser(
        "init",
        "Write a commented configuration, a pre-commit hook and a CI job that pass as they are. Findings of today go "
        "to a baseline. Nothing is asked, and no file that exists is changed.",
    )
    parser.add_argument("paths", metavar="PATH", nargs="?", help="the folder of the workspace (default: .)")
    return parser


def run(arguments: argparse.Namespace) -> int:
    from archlint.config.files import repository_of  # most commands end without it

    [path] = paths_of(argparse.Namespace(paths=[] if arguments.paths is None else [arguments.paths]))
    folder = Path(path)
    if not folder.is_dir():
        raise UsageError(f"init needs a folder, the workspace, and {path} is a file")
    root = repository_of(folder.absolute())
    inside = Path(os.path.relpath(folder.resolve(), root)).as_posix()
    try:
        said = [*_configured(folder), *_hooked(root, inside), *_in_ci(root, inside)]
    except OSError as error:
        raise UsageError(f"cannot write {error.filename}: {error.strerror}") from None
    console.say("".join(f"{visible(line)}\n" for text in said for line in text.splitlines()))
    return CLEAN


def _configured(folder: Path) -> Iterator[str]:
    """Write the configuration, and the baseline where something fails today.  Raises :class:`UsageError`."""
    from archlint.config.settings import ConfigurationError, Settings, load
    from archlint.engine.pipeline import NothingToDo
    from archlint.ros.distros import DISTROS

    try:
        settings = load(folder, plugins=False)
        if settings.file is not None:
            yield _left(Path(settings.file))
            return
        distro = os.environ.get("ROS_DISTRO")
        settings = Settings(distro=distro if distro in DISTROS else None)
        yield from _written_for(folder, settings)
    except (ConfigurationError, NothingToDo) as error:
        raise UsageError(str(error)) from None


def _written_for(folder: Path, settings: Settings) -> Iterator[str]:
    from archlint.cli.baseline import UsedBaseline
    from archlint.engine.baseline_file import BaselineError, read_to_rewrite
    from archlint.engine.pipeline import Request, check
    from archlint.finding import Severity

    path = folder / BASELINE
    exists = os.path.lexists(path)
    try:
        held = read_to_rewrite(path)
    except BaselineError as error:
        raise UsageError(str(error)) from None
    shown: list[System] = []
    request = Request((str(folder),), settings, cached=False, fixes=False, baseline=held, occurrences=True)
    report = check(request, shown)
    fails = any(finding.severity >= Severity.WARNING for finding in report.findings)
    if fails and not exists:
        UsedBaseline(path, held, writes=True, prunes=False).written(report)
    text = starter_files.configuration(_seen(folder, settings, shown), held=fails or exists)
    yield _wrote(folder / "archlint.toml", text)
    if exists:
        yield _left(path)
    elif fails:
        yield f"wrote {_shown(path)}: {_held(report)}"
        yield from _merged(folder)


def _merged(folder: Path) -> Iterator[str]:
    """Two branches that both add or remove entries of the baseline would be a conflict: git is to keep all lines."""
    path = folder / ".gitattributes"
    if not os.path.lexists(path):
        yield _wrote(path, f"{starter_files.ATTRIBUTES}\n")
        return
    yield _left(path)
    if BASELINE not in _text(path):
        yield f"to merge baselines without conflicts, append this to it\n\n{starter_files.ATTRIBUTES}\n"


def _held(report: Report) -> str:
    count = report.summary.findings
    which = "the finding that is" if count == 1 else f"the {count} findings that are"
    return f"holds back {which} there today; `archlint check --no-baseline` shows {'it' if count == 1 else 'them'}"


def _seen(folder: Path, settings: Settings, shown: Sequence[System]) -> Seen:
    from archlint.workspace.discovery import find

    launch_files = [
        Path(os.path.relpath(file.path, folder)).as_posix()
        for file in find((str(folder),), exclude=()).of_kind("launch_python", "launch_xml", "launch_yaml")
        if not file.context
    ]
    return Seen(settings.distro, launch_files[:_EXAMPLES], list(_owners(shown))[:_EXAMPLES])


def _owners(shown: Sequence[System]) -> Iterator[tuple[str, str]]:
    """The topics that one known node publishes and another one reads."""
    if not shown:
        return
    from archlint.engine.loading import combined

    for name, topic in sorted(combined(shown).topics.items()):
        publishers = {endpoint.node.name for endpoint in topic.providers}
        if len(publishers) == 1 and topic.users and "*" not in name and (publisher := publishers.pop()) is not None:
            yield name, publisher


def _hooked(root: Path, inside: str) -> Iterator[str]:
    path = root / ".pre-commit-config.yaml"
    if not os.path.lexists(path):
        yield _wrote(path, starter_jobs.hooks(inside))
        return
    yield _left(path)
    if "archlint" not in _text(path):
        yield f"to add the hook, append this to its `repos:`\n\n{starter_jobs.hook(inside)}"


def _in_ci(root: Path, inside: str) -> Iterator[str]:
    submodules = (root / ".gitmodules").is_file()
    gitlab = root / ".gitlab-ci.yml"
    if os.path.lexists(gitlab):
        yield _left(gitlab)
        if "archlint" not in _text(gitlab):
            yield f"to add the job, append this to it\n\n{starter_jobs.gitlab_job(inside, submodules)}"
    elif re.search(r"^\s*url\s*=.*gitlab", _text(_git_folder(root) / "config"), re.MULTILINE):
        yield _wrote(gitlab, starter_jobs.gitlab_job(inside, submodules))
    elif os.path.lexists(root / "Jenkinsfile") and not (root / ".github" / "workflows").is_dir():
        yield _left(root / "Jenkinsfile")
        if "archlint" not in _text(root / "Jenkinsfile"):
            yield f"to add the check, put this among its `stages`\n\n{starter_jobs.jenkins_stage(inside)}"
    else:
        folder = root / ".github" / "workflows"
        existing = next((path for path in sorted(folder.glob("*.y*ml")) if "archlint" in path.name + _text(path)), None)
        if existing is not None:
            yield _left(existing)
            return
        folder.mkdir(parents=True, exist_ok=True)
        yield _wrote(folder / "archlint.yml", starter_jobs.github_workflow(inside, submodules))


def _git_folder(root: Path) -> Path:
    """Where git has the settings of a repository: in a linked worktree and in a submodule ``.git`` is a file that says
    where that is (gitrepository-layout, ``gitdir`` and ``commondir``)."""
    folder = root / ".git"
    if not folder.is_file():
        return folder
    folder = root / _text(folder).removeprefix("gitdir:").strip()
    return folder / _text(folder / "commondir").strip()


def _text(path: Path) -> str:
    """What a file says; nothing where it cannot be read."""
    try:
        return read_regular(path, _MAX_BYTES).decode("utf-8", "replace")
    except OSError:
        return ""


def _wrote(path: Path, text: str) -> str:
    """Write a new file; what is there, a link among it, is never written through."""
    with path.open("x", encoding="utf-8") as stream:
        stream.write(text)
    return f"wrote {_shown(path)}"


def _left(path: Path) -> str:
    return f"{_shown(path)} exists, and is left as it is"


def _shown(path: Path) -> str:
    return Path(os.path.relpath(path)).as_posix()
