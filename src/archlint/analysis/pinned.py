"""The ROS distributions that a workspace is built and tested for, as far as its own files say so."""

from __future__ import annotations

import posixpath
import re
from typing import TYPE_CHECKING, NamedTuple

from archlint.analysis.kept import once
from archlint.ros.distros import DISTROS, UBUNTU

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence

    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.tree import Tree

_COMPOSE = tuple(f"{name}.{end}" for name in ("docker-compose", "compose") for end in ("yml", "yaml"))
PINNING_FILES = (
    ".gitlab-ci.yml",
    "Dockerfile",
    "dockerfile",
    "setup.bash",
    "setup.sh",
    ".vscode/settings.json",
    *_COMPOSE,
)
BUILT_FILES = ("install/setup.sh",)
"""What colcon writes at the top of a workspace, where it is kept with the sources: it names what it was built with."""
PINNING_FOLDERS = (".github/workflows", ".devcontainer", "docker", "Docker", "DOCKER")
_READ = re.compile(r"(?:^|/)(?:[^/]*\.ya?ml|[^/]*[Dd]ockerfile[^/]*|devcontainer\.json)$")
_CONTAINER = re.compile(r"[Dd]ockerfile\.[^/]+")
"""``Dockerfile.robot``, at the top."""
_OLDER = frozenset({"dashing", "eloquent", "foxy", "galactic"})
_OTHERS = (*sorted(_OLDER), "iron", "noetic", "melodic")
_NAMED = re.compile(rf"(?<![A-Za-z0-9])({'|'.join((*DISTROS, *_OTHERS))})(?![A-Za-z0-9])", re.IGNORECASE)
_OF_ROS = re.compile(
    r"(?:\bros[:-]|/opt/ros/|\b(?:ros[_.])?distro\w*[\"']?\s*[:=]\s*[\"'\[ ]*|ros-distributions?:\s*)$", re.IGNORECASE
)
"""What precedes a distribution: ``ros:jazzy``, ``ros-jazzy-desktop``, ``ROS_DISTRO=jazzy``, ``distro: jazzy``."""


def named_distros(workspace: WorkspaceIndex | None) -> frozenset[str]:
    """The distributions that the files of CI, containers and an editor, or a setup script, at the top of a workspace
    name, none
    where they say nothing certain; a README is no evidence, for nothing runs it."""
    return frozenset() if workspace is None else _named(workspace)


def is_for_older_ros(workspace: WorkspaceIndex | None) -> bool:
    """Whether a workspace is plainly for a distribution of ROS 2 that is older than all whose interfaces are known."""
    return _is_among(named_distros(workspace), _OLDER, but_not=DISTROS)


def knows_interfaces_of(workspace: WorkspaceIndex | None, package: str) -> bool:
    """Whether the interfaces of a package are those that the workspace is built with: its own are, and others where it
    is for no distribution older than all whose interfaces are known, by its files or by its README, or where nothing
    that the package had in Foxy has been removed since."""
    if workspace is None or package in workspace.packages or package in _GROWN:
        return True
    return not is_for_older_ros(workspace) and not is_from_before_humble(workspace)


def is_from_before_humble(workspace: WorkspaceIndex) -> bool:
    """Whether a workspace is for such a distribution and for none that came later, by the evidence below."""
    return _is_among(_named_or_told(workspace), _OLDER, but_not=_SINCE_HUMBLE)


def is_from_before_galactic(workspace: WorkspaceIndex | None) -> bool:
    """Whether a workspace is for such a distribution, by its files or, where they say nothing, by its README, by what
    it was last built with and by the scripts that start it, which name one, and none that came later."""
    return workspace is not None and _is_among(
        _named_or_told(workspace), _BEFORE_GALACTIC, but_not=("galactic", *_SINCE_HUMBLE)
    )


def is_for_humble(workspace: WorkspaceIndex | None) -> bool:
    """Whether a workspace is for humble: its files name that, or its README does, and none that came later."""
    if workspace is None:
        return False
    named = named_distros(workspace)
    return "humble" in named or (not named and _is_among(_in_readmes(workspace), _HUMBLE, but_not=_SINCE_IRON))


def is_for_humble_or_newer(workspace: WorkspaceIndex) -> bool:
    """Whether a workspace is for humble or for one that came later, and for none before, by the same evidence."""
    return _is_among(_named_or_told(workspace), frozenset(_SINCE_HUMBLE), but_not=tuple(_OLDER))


def is_for_humble_alone(workspace: WorkspaceIndex | None) -> bool:
    """Whether a workspace is for humble and for no other distribution, by the same evidence."""
    return workspace is not None and _is_among(_named_or_told(workspace), _HUMBLE, but_not=(*_SINCE_IRON, *_OLDER))


def is_from_humble_to_jazzy(workspace: WorkspaceIndex) -> bool:
    """Whether a workspace is for humble, iron or jazzy, and for none before or after, by the same evidence."""
    later = DISTROS[DISTROS.index("jazzy") + 1 :]
    return _is_among(_named_or_told(workspace), frozenset({"humble", "iron", "jazzy"}), but_not=(*_OLDER, *later))


def is_on_focal(workspace: WorkspaceIndex) -> bool:
    """Whether a workspace is for a distribution on Ubuntu 20.04 and for none that came later, by the same evidence."""
    return _is_among(_named_or_told(workspace), _ON_FOCAL, but_not=_SINCE_HUMBLE)


def names_no_distro(workspace: WorkspaceIndex) -> bool:
    """Whether none of all this names a distribution."""
    return not _named_or_told(workspace)


def may_be_of_old_template(workspace: WorkspaceIndex) -> bool:
    """Whether some package may come from the template of ``ros2 pkg create`` before Humble, by the beginning of its
    CMakeLists.txt or the list of packages in its setup.py.

    Source: ros2pkg/resource, which has ``VERSION 3.8`` and ``find_packages(exclude=['test'])`` since Humble.
    """
    folders = (package.relative for package in workspace.packages.values() if not package.ros1)
    files = (posixpath.normpath(f"{folder}/{name}") for folder in folders for name in ("CMakeLists.txt", "setup.py"))
    return any(_OLD_TEMPLATE.search(workspace.tree.text(file) or "") for file in files)


_OLD_TEMPLATE = re.compile(r"\bcmake_minimum_required\s*\(\s*VERSION\s+(?:2\.|3\.[0-7]\b)|\bpackages=\[package_name\],")


def ubuntu_releases(workspace: WorkspaceIndex) -> frozenset[str]:
    """The releases of Ubuntu that a workspace may be for, by the same evidence; where it says nothing, the two that
    most robots run."""
    named = {UBUNTU[name] for name in _named_or_told(workspace) if name in UBUNTU}
    return frozenset(named) or frozenset({"jammy", "noble"})


def may_be_on_focal(workspace: WorkspaceIndex) -> bool:
    """Whether a README, the last build or a script of a workspace names such a distribution, beside others or not, and
    its files name none that came later."""
    if not _OLDER.isdisjoint(named_distros(workspace)):
        return True
    told = _told(workspace) | _names_in(_lines_of_readmes(workspace))
    return named_distros(workspace).isdisjoint(_SINCE_HUMBLE) and not told.isdisjoint(_OLDER)


_GROWN = frozenset(
    {
        *("action_msgs", "actionlib_msgs", "builtin_interfaces", "composition_interfaces", "diagnostic_msgs"),
        *("geometry_msgs", "lifecycle_msgs", "nav_msgs", "rcl_interfaces", "rosgraph_msgs", "sensor_msgs"),
        *("shape_msgs", "statistics_msgs", "std_msgs", "std_srvs", "stereo_msgs", "trajectory_msgs"),
        "visualization_msgs",
    }
)
"""The packages of common_interfaces and rcl_interfaces that Foxy has: what their interfaces had there they have today,
with the same types (the branches foxy, humble, jazzy and rolling, compared file by file)."""
_BEFORE_GALACTIC = frozenset({"dashing", "eloquent", "foxy"})
"""The distributions whose ``Node`` of launch took ``node_name`` and the like, and whose parameters have no type."""
_ON_FOCAL = frozenset({"foxy", "galactic"})
_HUMBLE = frozenset({"humble"})
_SINCE_HUMBLE = (*DISTROS, "iron")
_OF_ROS_2 = _OLDER.union(_SINCE_HUMBLE)
_SINCE_IRON = tuple(name for name in _SINCE_HUMBLE if name not in _HUMBLE)


def _is_among(named: frozenset[str], distros: frozenset[str], *, but_not: Sequence[str]) -> bool:
    return not named.isdisjoint(distros) and named.isdisjoint(but_not)


def _named_or_told(workspace: WorkspaceIndex) -> frozenset[str]:
    """The distributions that the files of a workspace name or, where they name none, its README, its last build and
    the scripts that start it."""
    return named_distros(workspace) or _told(workspace)


def _told(workspace: WorkspaceIndex) -> frozenset[str]:
    return _in_readmes(workspace) | _built_with(workspace) | _started_with(workspace)


_SCRIPTS = (".sh", ".bash", ".zsh", ".service")
_SOURCED = re.compile(r"/opt/ros/([a-z]+)")


@once
def _built_with(workspace: WorkspaceIndex) -> frozenset[str]:
    top = workspace.tree.top
    return _sourced_in(workspace, (posixpath.normpath(f"{top}/{name}") for name in BUILT_FILES))


@once
def _started_with(workspace: WorkspaceIndex) -> frozenset[str]:
    tree = workspace.tree
    return _sourced_in(workspace, (path for path in tree.files_below(tree.top) if path.endswith(_SCRIPTS)))


def _sourced_in(workspace: WorkspaceIndex, paths: Iterable[str]) -> frozenset[str]:
    """The distributions whose setup files some scripts run."""
    texts = (workspace.tree.text(path) or "" for path in paths)
    return frozenset(match[1] for text in texts for match in _SOURCED.finditer(text))


_README = re.compile(r"README(?:\.(?:md|rst|txt))?", re.IGNORECASE)


class _Line(NamedTuple):
    """A line of a README that names distributions."""

    names: frozenset[str]
    at_top: bool
    is_choice: bool


@once
def _in_readmes(workspace: WorkspaceIndex) -> frozenset[str]:
    """The distributions that the README at the top names; those further down, of packages that others maintain, say,
    count where it names none."""
    lines = _lines_of_readmes(workspace)
    certain = [line for line in lines if not line.is_choice] or lines
    at_top = _names_in(line for line in certain if line.at_top)
    return _names_in(certain) if at_top.isdisjoint(_OF_ROS_2) else at_top


def _names_in(lines: Iterable[_Line]) -> frozenset[str]:
    return frozenset[str]().union(*(line.names for line in lines))


@once
def _lines_of_readmes(workspace: WorkspaceIndex) -> list[_Line]:
    tree = workspace.tree
    lines: list[_Line] = []
    for path in (path for path in tree.files_below(tree.top) if _README.fullmatch(posixpath.basename(path))):
        at_top = (posixpath.dirname(path) or ".") == posixpath.normpath(tree.top)
        for text in (tree.text(path) or "").splitlines():
            if names := frozenset(match[1].lower() for match in _NAMED.finditer(text)):
                lines.append(_Line(names, at_top, _is_a_choice(names, text)))
    return lines


def _is_a_choice(names: frozenset[str], line: str) -> bool:
    """Whether a line of a README tells the reader to fill in his own distribution, and which there are."""
    return len(names) > 1 and _FILLED_IN in line


_FILLED_IN = "ROS_DISTRO"


def distros_to_judge(workspace: WorkspaceIndex | None, distros: Sequence[str]) -> tuple[str, ...]:
    """Of several distributions the one that a workspace is plainly for; all of them where it says nothing, or more than
    one."""
    named = named_distros(workspace)
    return tuple(named) if len(named) == 1 and named.issubset(distros) else tuple(distros)


@once
def _named(workspace: WorkspaceIndex) -> frozenset[str]:
    named: set[str] = set()
    certain = False
    for text in _texts(workspace.tree):
        for match in _NAMED.finditer(text):
            named.add(match[1].lower())
            certain = certain or _OF_ROS.search(text[max(0, match.start() - 60) : match.start()]) is not None
    return frozenset(named) if certain else frozenset()


def _texts(tree: Tree) -> Iterator[str]:
    folders, files = (
        [posixpath.normpath(f"{tree.top}/{name}") for name in names] for names in (PINNING_FOLDERS, PINNING_FILES)
    )
    below = [path for folder in folders for path in tree.files_below(folder) if _READ.search(path)]
    named = (path for path in tree.files_below(tree.top) if _CONTAINER.fullmatch(posixpath.basename(path)))
    below += [path for path in named if (posixpath.dirname(path) or ".") == posixpath.normpath(tree.top)]
    for path in (*below, *files):
        text = tree.text(path)
        if text is not None:
            yield text
