"""Why a name in the code is absolute, and what NME001 says about that."""

from __future__ import annotations

from dataclasses import dataclass, replace

from archlint.finding import Severity


@dataclass(frozen=True)
class Reason:
    """Why a name is as it is: it ``is`` so, and so ``what`` follows, with ``cure`` as help for several names."""

    key: str
    state: str
    effect: str
    cure: str
    severity: Severity | None = None
    namespace: str = ""
    """The one that launch files start the node in, where a name begins with it."""

    by_package: bool = False
    """Whether it is one finding for all files of a package or folder: what none installs, or what another system
    prescribes."""

    def message(self, subject: str, such_as: str, plural: bool) -> str:
        effect = self.effect.format(it="them" if plural else "it")
        return f"{subject} {'are' if plural else 'is'} {self.state}{such_as}{effect}"


FIXED = Reason(
    "fixed",
    "absolute and fixed in the code",
    ": no namespace applies to {it}",
    "remove the leading '/', so that the node's namespace applies, or take the names from parameters",
)
PARAMETERS = replace(FIXED, cure="take the names from parameters")
"""For a node that launch files start in one namespace and another, where a name begins with one of them."""
OF_ANOTHER = Reason(
    "of another",
    "absolute and fixed in the code",
    ", beside relative names of the same node, which launch files start in a namespace",
    "take the names from parameters, so that a launch file can choose them",
    Severity.INFO,
)
RELATIVE = Reason("fixed", "fixed in the code", "", "take the names from parameters")
DEMANDED = Reason(
    "demanded",
    "absolute and fixed in the code",
    ", and the code rejects {it} in any other form",
    "fine for one robot; for several, take the names from parameters",
    Severity.INFO,
)
PRIVATE = Reason(
    "private",
    "absolute",
    ": a node outside this workspace creates {it} below its own name",
    "fine for one such node; for several, take the names from parameters",
    Severity.INFO,
)
NOT_INSTALLED = Reason(
    "not installed",
    "absolute and fixed in the code",
    ", in code that no installed program uses",
    "remove the leading '/' if you install the file",
    Severity.INFO,
    by_package=True,
)
REMAPPED = Reason(
    "remapped",
    "absolute and fixed in the code",
    ", and remapped wherever a launch file starts the node",
    "remove the leading '/', so that the node's namespace applies without a remapping",
    Severity.INFO,
)
WITHOUT_PACKAGE = replace(FIXED, effect=NOT_INSTALLED.effect, severity=Severity.INFO, by_package=True)
"""For a script in a workspace that has no package."""


def shared_by(users: int) -> Reason:
    return Reason(
        "shared",
        "absolute and fixed in the code",
        f", for {users} files that import names from here: no namespace applies to {{it}}",
        "remove the leading '/' here, so that the nodes' namespaces apply",
        Severity.INFO,
    )


def of_others(system: str) -> Reason:
    return Reason(
        "others",
        "absolute",
        f": {system} prescribes {{it}}",
        f"fine for one {system}; for several, remove the leading '/' and start the node in a namespace",
        Severity.INFO,
        by_package=True,
    )
