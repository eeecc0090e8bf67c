"""Which classes NME001 tells alone: the source shows that their absolute names do not fit what is around them."""

from __future__ import annotations

import posixpath
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.manifests import package_around
from archlint.checks.name_reasons import FIXED, REPEATED, Reason, beside_relative, for_each_instance, unlike_its_package
from archlint.model import EntityKind
from archlint.systems.nodes import key_of

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.systems.nodes import Endpoint

Home = tuple[str, str]
"""The file and the class that a name is fixed in; the class is empty where there is none."""
_PROVIDES = frozenset({EntityKind.PUBLISHER, EntityKind.SERVICE, EntityKind.ACTION_SERVER})


@dataclass(frozen=True)
class FixedName:
    """A name that is fixed in the code of a class."""

    home: Home
    endpoint: Endpoint
    reason: Reason

    @property
    def text(self) -> str:
        return self.endpoint.written or ""

    @property
    def is_own(self) -> bool:
        """Whether it is written in the file of the node, and not in one of constants."""
        return self.home[0] == self.endpoint.place.file

    @property
    def is_absolute(self) -> bool:
        """Whether it is, and nothing but the names around it can say why."""
        return self.reason.key == FIXED.key

    @property
    def is_relative(self) -> bool:
        """Whether it follows the namespace of the node, and not its name as well (``~/state``)."""
        return self.is_own and not self.text.startswith(("/", "~"))


def told_alone(workspace: WorkspaceIndex | None, names: Iterable[FixedName]) -> dict[Home, Reason]:
    """The classes whose absolute names do not fit what is around them, each with what is to be said of it: alone, or
    together with the others of its package."""
    by_home: dict[Home, list[FixedName]] = {}
    for name in names:
        by_home.setdefault(name.home, []).append(name)
    alone = {home: reason for home, rows in by_home.items() if (reason := _as_started(workspace, rows)) is not None}
    for package, homes in _by_package(workspace, by_home).items():
        classes = {home: by_home[home] for home in homes if home not in alone}
        absolute = [home for home, rows in classes.items() if any(name.is_absolute for name in rows)]
        evidence = {**(_unlike(package, classes, absolute) if package else {}), **_mixed(classes)}
        if package and evidence:
            alone.update((home, replace(evidence.get(home, FIXED), package=package)) for home in absolute)
        else:
            alone.update(evidence)
    return alone


def _as_started(workspace: WorkspaceIndex | None, names: Sequence[FixedName]) -> Reason | None:
    """What launch files show of the names of a class."""
    repeated = next((name.reason for name in names if name.reason.key == REPEATED), None)
    if repeated is not None:
        return repeated
    count = max((_instances(workspace, name.endpoint) for name in names if name.is_absolute), default=0)
    return for_each_instance(count) if count > 1 else None


def _mixed(classes: Mapping[Home, Sequence[FixedName]]) -> dict[Home, Reason]:
    """The classes that have names of both forms."""
    relative = {home: [name.text for name in names if name.is_relative] for home, names in classes.items()}
    return {
        home: beside_relative(min(relative[home]))
        for home, names in classes.items()
        if relative[home] and any(name.is_absolute and name.is_own for name in names)
    }


def _instances(workspace: WorkspaceIndex | None, endpoint: Endpoint) -> int:
    """How many nodes of one launched system provide the same under the name of an endpoint; what each of them only
    listens to or asks may well be one for all."""
    blueprint = endpoint.node.blueprint
    if workspace is None or blueprint is None:
        return 0
    return _provided(workspace).get((key_of(blueprint), endpoint.kind, endpoint.written), 0)


@once
def _provided(workspace: WorkspaceIndex) -> Mapping[tuple[object, EntityKind, str | None], int]:
    """How many nodes of one kind, by :func:`key_of`, a launch file starts that provide something under one name."""
    most: Counter[tuple[object, EntityKind, str | None]] = Counter()
    for system in workspace.systems:
        nodes = [node for node in system.nodes if system.launched is not None and not node.alternatives]
        most |= Counter(
            (key_of(node.blueprint), kind, name)
            for node in nodes
            if node.blueprint is not None
            for kind, name in {(end.kind, end.name) for end in node.endpoints if end.kind in _PROVIDES}
        )
    return most


def _by_package(workspace: WorkspaceIndex | None, homes: Iterable[Home]) -> dict[str, list[Home]]:
    """The classes with fixed names of each package; the name is empty for those in none."""
    packages: dict[str, list[Home]] = {}
    for home in homes:
        package = None if workspace is None else package_around(workspace, posixpath.dirname(home[0]))
        packages.setdefault("" if package is None else package.name, []).append(home)
    return packages


def _unlike(package: str, classes: Mapping[Home, Sequence[FixedName]], absolute: Sequence[Home]) -> dict[Home, Reason]:
    """The classes with absolute names in a package that has more classes without any, and in one where another class
    has such a name as a relative one."""
    others = [home for home in classes if home not in absolute]
    relative = {name.text: home for home in others for name in classes[home] if name.is_relative}
    if not relative:
        return {}
    few = len(absolute) < len(set(relative.values()))
    same = {home: next(_same_as(classes[home], relative), "") for home in absolute}
    return {home: unlike_its_package(package, same[home] or min(relative)) for home in absolute if few or same[home]}


def _same_as(names: Iterable[FixedName], relative: Mapping[str, Home]) -> Iterator[str]:
    yield from (name.text[1:] for name in names if name.is_absolute and name.text[1:] in relative)


__all__ = ["FixedName", "Home", "told_alone"]
