"""What archlint says a launch file starts, in the words of the records."""

from __future__ import annotations

import os
import posixpath
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath

from archlint.branches import ChoiceOfVisit
from archlint.config.settings import Settings
from archlint.engine.compiling import compiled
from archlint.engine.inputs import find_files, parts_of
from archlint.engine.pipeline import store_of
from archlint.engine.request import Request
from archlint.launch.launches import Launches
from archlint.launch.model import Launched
from archlint.launch.parameter_sources import OpenParameters, ParameterFileUse, ParameterSetting
from archlint.launch.started import Started
from archlint.model import Text
from archlint.programs.entry_points import read_installs
from archlint.ros import names
from archlint.syntax.parameter_files import NotKnown
from archlint.syntax.workspace_files import WorkspaceFiles
from archlint.systems.overrides import applied, settings_of
from archlint.workspace.tree import SourceTree


@dataclass(frozen=True)
class Unknown:
    """Stands for what archlint does not know, with the reason that it gives."""

    reason: str = ""
    outside: bool = False
    """Whether it is for want of a variable of the environment."""

    def __repr__(self) -> str:
        return f"? ({self.reason})"


DISTRO = "jazzy"
"""What the records were made on."""

MADE = "a file that the launch makes"
"""Its name is made up anew in each run; what is in it is compared with the other parameters."""


@dataclass
class Row:
    """One started node, from either side."""

    kind: str
    fields: dict[str, object]
    where: str | None = None
    undecided: bool = False
    open: list[str] = field(default_factory=list)
    """Why there may be more parameters."""
    undecided_by: list[str] = field(default_factory=list)
    """Why it is not known whether the node is started: a reason for each branch, if there is one."""
    outside: bool = False
    """Whether variables of the environment decide that it is started, and ``may_have_more`` that they decide what
    other parameters it has."""
    may_have_more: bool = False


class Checkout:
    def __init__(self, root: Path) -> None:
        os.chdir(root)
        request = Request((".",), Settings(), cached=False, jobs=1)
        workspace = find_files(request)
        facts = compiled(request, workspace, store_of(request))
        tree = SourceTree(Path.cwd(), Path(workspace.root))
        self.parts: list[Launches] = []
        for part in parts_of(request, workspace):
            files = WorkspaceFiles(part.files, facts.facts_of, facts.relevant, tree)
            installs = read_installs(part.packages, files)
            old = frozenset(package.name for package in part.packages if package.ros1)
            launches = Launches(files, installs, ros1_packages=old, distro=DISTRO)
            launches.knows_command_line = True
            self.parts.append(launches)

    def launch(self, file: str, arguments: Mapping[str, str]) -> tuple[Launched | None, list[Row]]:
        """A launch file under arguments; None where archlint takes it for none."""
        for launches in self.parts:
            if launches.files.can_be_launched(file):
                launched = launches.run(file, arguments)
                apart = {include.place for include in launched.included if include.own_process}
                started = [
                    one
                    for one in launched.started
                    if one.kind != "process" and not one.dormant and not apart & {*one.includes}
                ]
                return launched, [self._row(launches, launched, one) for one in started]
        return None, []

    def _row(self, launches: Launches, launched: Launched, started: Started) -> Row:
        shown = _Shown(launches)
        uses = [one for one in started.parameters if isinstance(one, ParameterFileUse)]
        given = started.namespace is not None
        fields: dict[str, object] = {
            "package": shown.text(started.package),
            "executable": shown.text(started.executable),
            "name": None if started.name is None else shown.text(started.name),
            "namespace": shown.text(started.namespace) if given and started.namespace is not None else None,
            "remaps": [[shown.text(one.source), shown.text(one.target)] for one in started.remaps],
            "parameters": self._parameters(launches, started, shown),
        }
        fields["files"] = [_file(use, shown) for use in uses]
        why = [one.reason for one in started.parameters if isinstance(one, OpenParameters)]
        if any(isinstance(one, ParameterSetting) and one.name is None for one in started.parameters):
            why.append("a parameter whose name is not known")
        # Of an action that is met twice, the branches that lead to each visit say why.
        branches = {branch for branch, _ in started.branch_arms if not isinstance(branch, ChoiceOfVisit)}
        by = sorted(launched.why_open.get(branch, "") for branch in branches)
        return Row(
            started.kind, fields, f"{started.place.file}:{started.place.line}", bool(started.branch_arms), why, by
        )

    @staticmethod
    def _parameters(launches: Launches, started: Started, shown: _Shown) -> dict[tuple[str, str], object]:
        if started.kind == "component":
            name = started.name.text if started.name is not None else None
            namespace = started.namespace.text if started.namespace is not None else "/"
            full = names.join(namespace or "/", name) if name else None
            rows = [("", one.name, one.value) for one in applied(started, full, launches.files.parameters)]
        else:
            rows = [(one.key, one.name, one.value) for one in settings_of(started, launches.files.parameters)]
        return {
            (key.strip("/"), name): Unknown(value.reason) if isinstance(value, NotKnown) else shown(value)
            for key, name, value in rows
        }


def _file(use: ParameterFileUse, shown: _Shown) -> object:
    reference = use.reference
    if reference.written is None:
        return Unknown(reference.reason or "")
    return MADE if use.changes else shown(str(PurePosixPath(reference.written)))  # as launch_ros hands it on


_WORKSPACE = re.compile(r"\$\(workspace\)/([^\s:;,]*)")
_PACKAGE_PATH = re.compile(r"(\$\(find-pkg-(?:share|prefix) [\w.-]+\))((?:/[^\s:;,/]*)+)")

_SHARE_IN_PREFIX = re.compile(r"\$\(find-pkg-prefix ([\w.-]+)\)/share/\1(?=/|$)")


def normal(text: str) -> str:
    """A text with the paths in it in their shortest form."""
    text = _SHARE_IN_PREFIX.sub(r"$(find-pkg-share \1)", text)
    return _PACKAGE_PATH.sub(lambda found: _path(found[1], found[2]), text)


def _path(start: str, rest: str) -> str:
    found = posixpath.normpath(rest)
    return start if found == "/" else start + found


class _Shown:
    def __init__(self, launches: Launches) -> None:
        folders = ((installs.folder, name) for name, installs in launches.installs.items())
        self._folders = sorted(folders, key=lambda row: (-len(row[0]), row))

    def text(self, text: Text) -> object:
        known = text.text is not None and text.resolution in ("exact", "parameter")
        return self(text.text) if known else Unknown(text.reason or "")

    def __call__(self, value: object) -> object:
        if isinstance(value, str):
            return normal(_WORKSPACE.sub(lambda found: self._installed(found[1]), value))
        if isinstance(value, (list, tuple)):
            return [self(item) for item in value]
        return value

    def _installed(self, path: str) -> str:
        path = posixpath.normpath(path)
        for folder, name in self._folders:
            below = (
                path
                if folder == "."
                else path[len(folder) :].lstrip("/")
                if f"{path}/".startswith(folder + "/")
                else None
            )
            if below is not None:
                return f"$(find-pkg-share {name})/{below}".rstrip("/")
        return path


def recorded(nodes: Iterable[Mapping[str, object]]) -> list[Row]:
    """The rows of a record."""
    found = []
    for node in nodes:
        fields = {
            name: _plain(node[name]) for name in ("package", "executable", "name", "namespace", "remaps", "files")
        }
        rows = node["parameters"]
        assert isinstance(rows, list)
        fields["parameters"] = {(key.strip("/"), name): _plain(value) for key, name, value in rows}
        line = node.get("line")
        found.append(Row(str(node["kind"]), fields, line if isinstance(line, str) else None))
    return found


def _plain(value: object) -> object:
    if isinstance(value, str):
        return normal(value)
    return [_plain(item) for item in value] if isinstance(value, list) else value
