"""Packages in which absolute names are the convention: what NME001 says once of all their classes."""

from __future__ import annotations

import posixpath
from collections.abc import Collection, Iterable, Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from archlint.analysis.manifests import package_around
from archlint.checks.folding import all_sites
from archlint.finding import Finding, Related

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.model import Package

Home = tuple[str, str]
"""The file and the class that a name is fixed in; the class is empty where there is none."""
CONVENTION = "convention"
"""The third part of the group of a finding that is shown with those of the other classes of its package."""
_CLASSES = 3
"""How many classes with nothing but absolute names make a convention."""
_SHARE = 0.8
"""How much of the fixed names of a package is absolute where that is the convention."""


@dataclass(frozen=True)
class FixedName:
    """A name that is fixed in the code of a class."""

    home: Home
    place: Place
    name: str
    follows: bool
    """Whether it can follow a convention: it is absolute, and no launch file gives the node a namespace, which it would
    ignore."""


def with_convention(workspace: WorkspaceIndex | None, names: Iterable[FixedName]) -> dict[Home, tuple[str, str]]:
    """The classes that follow the convention of their package to fix absolute names, each with the name and the
    package.xml of that package.  A class that mixes absolute and relative names follows none."""
    by_package: dict[tuple[str, str], dict[Home, set[FixedName]]] = {}
    packages: dict[str, Package | None] = {}
    for name in names:
        folder = posixpath.dirname(name.home[0])
        if folder not in packages:
            packages[folder] = None if workspace is None else package_around(workspace, folder)
        package = packages[folder]
        if package is not None:
            classes = by_package.setdefault((package.name, package.manifest.relative), {})
            classes.setdefault(name.home, set()).add(name)
    return {home: package for package, classes in by_package.items() for home in _that_follow(classes)}


def _that_follow(classes: Mapping[Home, AbstractSet[FixedName]]) -> Sequence[Home]:
    """The classes of one package that follow its convention, if it has one."""
    following = [home for home, names in classes.items() if all(name.follows for name in names)]
    every = [name for names in classes.values() for name in names]
    absolute = [name for name in every if name.name.startswith("/")]
    return following if len(following) >= _CLASSES and len(absolute) >= _SHARE * len(every) else ()


def one_of_package(findings: Sequence[Finding]) -> Finding:
    """The finding for the absolute names of several classes of a package: at the first, with the first of each other
    class related."""
    first, package = findings[0], findings[0].group[0]
    by_home: dict[Home, list[Finding]] = {}
    for diagnostic in findings:
        by_home.setdefault(home_of(diagnostic), []).append(diagnostic)
    names = sorted({diagnostic.identity[-1] for diagnostic in findings})
    subject = f"{len(names)} absolute names" if len(names) > 1 else f"the absolute name '{names[0]}'"
    whom = "any of them" if len(names) > 1 else "it"
    return replace(
        first,
        message=f"package '{package}' fixes {subject} in {_number_of(by_home)}: no namespace applies to {whom}",
        help=_help(findings),
        related=tuple(_related(home, rows) for home, rows in list(by_home.items())[1:]),
        sites=all_sites(findings),
        identity=(first.identity[0], *names),
    )


def home_of(diagnostic: Finding) -> Home:
    """The file and the class of a finding."""
    return diagnostic.place.file, diagnostic.identity[0]


def _number_of(homes: Collection[Home]) -> str:
    if all(class_name for _, class_name in homes):
        return f"{len(homes)} classes"
    return f"{len({file for file, _ in homes})} files"


def _help(findings: Sequence[Finding]) -> str:
    fixed = any(diagnostic.place.file.endswith(".py") for diagnostic in findings)
    parameters = ", or make parameters of them with `archlint check --fix --unsafe-fixes`" if fixed else ""
    return (
        f"remove the leading '/' of each, in all these classes together{parameters}; if there will never be a second "
        'robot of its kind, turn the rule off: `ignore = ["NME001"]`'
    )


def _related(home: Home, findings: Sequence[Finding]) -> Related:
    """What is said at the first name of a further class."""
    _, word, name = findings[0].identity
    count = len({diagnostic.identity[1:] for diagnostic in findings})
    subject = home[1] or "this file"
    more = f" and {count - 1} more" if count > 1 else ""
    return Related(findings[0].place, f"{subject} fixes the {word} '{name}'{more}")


__all__ = ["CONVENTION", "FixedName", "Home", "home_of", "one_of_package", "with_convention"]
