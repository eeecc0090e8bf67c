"""Paths into the home folder of one person that launch files, and the parameter files that they load, name."""

from __future__ import annotations

import posixpath
import re
from collections import Counter
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_aside
from archlint.analysis.kept import kept_for_each_file, once
from archlint.finding import Place
from archlint.launch.parameter_sources import files_among
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import called_name, calls_in

if TYPE_CHECKING:
    from archlint.syntax.launch_elements import Element
    from archlint.systems.model import System, WorkspaceIndex

_IN_HOME = re.compile(
    r"(?:(?<=file://)|(?<![\w$)}./~-]))(?:/home|/Users|[A-Za-z]:[\\/]Users)[\\/](?P<who>[\w.-]+)[\\/][^\s'\":,;]*"
)
_ACCOUNTS = frozenset(
    {"admin", "container", "dev", "developer", "devuser", "docker", "host", "jetson", "nao", "nvidia", "odroid"}
    | {"orangepi", "pi", "raspberry", "root", "ros", "ros2", "ros_user", "rosuser", "runner", "shared", "turtlebot"}
    | {"turtlebot3", "turtlebot4", "ubuntu", "user", "username", "vagrant", "vscode", "you", "your_name", "your_user"}
    | {"your_username", "yourname", "youruser", "yourusername"}
)
"""Accounts that every machine of a kind has, images of containers among them, and names that stand for any."""


@dataclass(frozen=True)
class PersonalPath:
    """A path that is there for one person only; ``inside`` is what it names in a package of this workspace: the path
    below its share folder where the package has ``installed`` it there, else below its source folder."""

    path: str
    who: str
    place: Place
    inside: tuple[str, str] | None = None
    installed: bool = False


def personal_paths(system: System) -> Iterator[PersonalPath]:
    """Those in the launch files of a launched system, then those in the parameter files that it loads."""
    workspace = system.workspace
    if system.launched is None or workspace is None:
        return
    for file in system.launched.sources:
        if workspace.launch_files.is_frontend(file):
            yield from _among(workspace, file, _of_elements(workspace, file))
        else:
            yield from _among(workspace, file, _of_code(workspace, file) or [])
    started = system.launched.started
    uses = (use.reference.source for process in started for use in files_among(process.parameters))
    for file in dict.fromkeys(file for file in uses if file is not None):
        yield from _among(workspace, file, _of_parameters(workspace, file))


_Text = tuple[str, facts.Span]


def _among(workspace: WorkspaceIndex, file: str, texts: Iterable[_Text]) -> Iterator[PersonalPath]:
    for text, span in texts:
        for match in _IN_HOME.finditer(text):
            path, who = match[0], match["who"]
            if who.lower() not in _ACCOUNTS and who not in _of_images(workspace):
                inside = _inside(workspace, path)
                shared = None if inside is None else _shared(workspace, *inside)
                if inside is not None and shared is not None:
                    inside = inside[0], shared
                yield PersonalPath(path, who, Place(file, *span), inside, shared is not None)


def _shared(workspace: WorkspaceIndex, package: str, below: str) -> str | None:
    """Where a package installs a file of its folder, below its share folder; None where it does not."""
    installs, share = workspace.installs.get(package), f"share/{package}/"
    file = f"{workspace.packages[package].relative}/{below}".removeprefix("./")
    places = [] if installs is None else [place for place in installs.places_of(file) if place.startswith(share)]
    return min(places).removeprefix(share) if places else None


def _inside(workspace: WorkspaceIndex, path: str) -> tuple[str, str] | None:
    """The package of this workspace in whose folder a path leads, and the path below that, where it is a file."""
    parts = path.split("/")
    for at in range(len(parts) - 1, 0, -1):
        package = workspace.packages.get(parts[at])
        below = "/".join(parts[at + 1 :])
        if package is not None and below and workspace.tree.is_file(f"{package.relative}/{below}".removeprefix("./")):
            return package.name, below
    return None


@once
def maps_by_personal_path(workspace: WorkspaceIndex) -> list[PersonalPath]:
    """The images that maps for map_server name so, and that lie beside them: a map without a folder in front of it is
    looked for there.

    Source: ``loadMapYaml`` of nav2_map_server.
    """
    rows: list[PersonalPath] = []
    for file in workspace.tree.files_below(workspace.tree.top):
        if not file.endswith((".yaml", ".yml")) or workspace.package_of(file) is None or is_aside(workspace, file):
            continue
        images = workspace.tree.lines_with(file, r"^image:\s")
        is_map = (
            images and workspace.tree.lines_with(file, r"^resolution:") and workspace.tree.lines_with(file, r"^origin:")
        )
        for number, line in images if is_map else ():
            texts = [(line, (number, 1, number, len(line) + 1))]
            beside = posixpath.join(posixpath.dirname(file), posixpath.basename(line.strip(" \t\r\n'\"")))
            rows += _among(workspace, file, texts) if workspace.tree.is_file(beside) else []
    return rows


_IMAGE_FILES = ("Dockerfile", "docker-compose.yml", "docker-compose.yaml", "compose.yaml", "devcontainer.json")
_HIDDEN = (".devcontainer/Dockerfile", ".devcontainer/devcontainer.json", ".docker/Dockerfile")
_ACCOUNT = re.compile(
    r"/home/([\w.-]+)|\buseradd\b.*\s([\w.-]+)\s*(?:[\\;&]|$)|\bUSER(?:NAME)?[= ]([\w.-]+)", re.MULTILINE
)


@once
def _of_images(workspace: WorkspaceIndex) -> frozenset[str]:
    """The accounts that the container images of a workspace have: their home folders are there wherever those run."""
    tree = workspace.tree
    below = (path for path in tree.files_below(tree.top) if posixpath.basename(path).endswith(_IMAGE_FILES))
    texts = (tree.text(path) or "" for path in (*below, *(f"{tree.top}/{path}" for path in _HIDDEN)))
    return frozenset(name for text in texts for match in _ACCOUNT.finditer(text) for name in match.groups() if name)


# ------------------------------------------------------------------------------------------------ the texts of files

_DESCRIBES = frozenset({"description", "msg", "doc", "help"})
_ASKS = frozenset({"exists", "isfile", "isdir", "is_file", "is_dir", "print", "LogInfo"})


@kept_for_each_file
def _of_code(file_facts: facts.Facts) -> list[_Text]:
    """The texts of a launch file in Python, but for docstrings, descriptions, paths that it only asks for, and those
    that a function gives a variable which nothing reads."""
    aside = {id(part) for value in _never_read(file_facts) for part in everything_in([value])}
    for part in everything_in(file_facts.body):
        match part:
            case facts.Expression(value=facts.Literal() as docstring):
                aside.add(id(docstring))
            case facts.Call(args=arguments):
                said = arguments if called_name(part) in _ASKS else [a for a in arguments if a.keyword in _DESCRIBES]
                aside.update(id(inner) for argument in said for inner in everything_in([argument.value]))
    texts: list[_Text] = []
    for part in everything_in(file_facts.body):
        match part:
            case facts.Literal(value=str(text)) if id(part) not in aside:
                texts.append((text, part.span))
            case facts.FormatString(parts=pieces) if id(part) not in aside:
                written = "".join(piece if isinstance(piece, str) else "{}" for piece in pieces)
                texts.append((written, part.span))
    return texts


def _never_read(file_facts: facts.Facts) -> Iterator[facts.Expr]:
    """The values that functions give variables whose names occur nowhere else, but for those that a call makes: it may
    do more than that."""
    functions = list(everything_in(file_facts.body, facts.Function))
    assigned = {id(row): row for function in functions for row in everything_in(function.body, facts.Assign)}
    given = Counter(name for row in assigned.values() for to in row.targets for name in [to.variable] if name)
    occur = Counter(part.id for part in everything_in(file_facts.body, facts.Name))
    if "locals" in occur:
        return
    for row in assigned.values():
        unread = all(to.variable and occur[to.variable] == given[to.variable] for to in row.targets)
        calls = {called_name(call) for call in calls_in([row.value])}
        if unread and calls <= _MAKES_PATHS:
            yield row.value


_MAKES_PATHS = frozenset({"Path", "PathJoinSubstitution", "join"})


def _of_elements(workspace: WorkspaceIndex, file: str) -> Iterator[_Text]:
    read = workspace.launch_files.frontend(file)
    stack: list[Element] = [] if read.root is None or read.ros1 else [read.root]
    while stack:
        element = stack.pop()
        stack += reversed(element.children)
        for name, attribute in element.attributes.items():
            values = attribute.value if isinstance(attribute.value, list) else [attribute.value]
            if name not in _DESCRIBES:
                yield from ((value, attribute.span) for value in values if isinstance(value, str))


def _of_parameters(workspace: WorkspaceIndex, file: str) -> Iterator[_Text]:
    read = workspace.parameters_of(file)
    for entry in (*(entry for section in read.sections for entry in section.entries), *read.plain):
        values = entry.value if isinstance(entry.value, list) else [entry.value]
        yield from ((value, entry.span) for value in values if isinstance(value, str))


__all__ = ["PersonalPath", "maps_by_personal_path", "personal_paths"]
