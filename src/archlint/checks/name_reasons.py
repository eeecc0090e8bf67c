"""Why NME001 speaks of a name, and what it says."""

from __future__ import annotations

from dataclasses import replace

from archlint.finding import Place, Severity
from archlint.records import dataclass


@dataclass(frozen=True)
class Reason:
    """Why a name is reported: it ``is`` so, and so ``what`` follows, with ``cure`` as help for several names."""

    key: str
    state: str
    effect: str
    cure: str
    severity: Severity | None = None
    namespace: str = ""
    """The one that launch files start the node in, where a name begins with it."""
    other: str = ""
    """One of the relative names that show it."""
    place: Place | None = None
    """Where another node has that name, which is one of these without its '/'."""

    @property
    def is_of_class(self) -> bool:
        """Whether it is about one class, whatever the form of other names in its workspace."""
        return self.key in (REPEATED, INSTANCES, "relative")

    @property
    def has_fix(self) -> bool:
        """Whether the name can become a parameter where the node creates something under it."""
        return self.key != "shared"

    def message(self, subject: str, such_as: str, plural: bool) -> str:
        effect = self.effect.format(it="them" if plural else "it")
        return f"{subject} {'are' if plural else 'is'} {self.state}{such_as}{effect}"


FIXED = Reason(
    "fixed",
    "absolute and fixed in the code",
    ": no namespace applies to {it}",
    "remove the leading '/', so that the node's namespace applies, or take the names from parameters",
)
"""Nothing more than that: what is said once of all nodes of a workspace."""
INSTANCES = "instances"
"""The key where a launch file starts a node several times."""
REPEATED = "repeated"
"""The key where a name begins with the namespace in which the node runs anyway."""
PARAMETERS = replace(FIXED, key=REPEATED, cure="take the names from parameters")
"""For a node that launch files start in one namespace and another, where a name begins with one of them."""
RELATIVE = Reason("relative", "fixed in the code", "", "take the names from parameters")
WITHOUT_PACKAGE = replace(FIXED, key="without package", severity=Severity.INFO)
"""For a script in a workspace that has no package."""


def shared_by(users: int) -> Reason:
    """For the names of one file that several others take from there."""
    return Reason(
        "shared",
        "absolute and fixed in the code",
        f", for {users} files that import names from here: no namespace applies to {{it}}",
        "remove the leading '/' here, so that the nodes' namespaces apply",
        Severity.INFO,
    )


def beside_relative(other: str) -> Reason:
    """For a node that has a relative name, too."""
    effect = f", beside relative names of the same node such as '{_kept(other)}': in a namespace, only those move"
    return replace(FIXED, key="mixed", effect=effect, other=other)


def repeating(namespace: str, cure: str) -> Reason:
    """For a node that launch files start in one namespace, with which a name of it begins."""
    return replace(FIXED, key=REPEATED, effect=_unmoved(namespace), cure=cure, namespace=namespace)


def for_each_instance(count: int) -> Reason:
    """For a node that one launch file starts several times."""
    effect = f", and a launch file starts the node {count} times: all of them have the same one"
    return replace(FIXED, key=INSTANCES, effect=effect)


def unlike_another(other: str, place: Place) -> Reason:
    """For a name that another node has as a relative one."""
    effect = f", and another node has '{_kept(other)}' as a relative name: in a namespace, only that one moves"
    return replace(FIXED, key="unlike", effect=effect, other=other, place=place)


def parted_from(other: str, place: Place) -> Reason:
    """For a name that the other end has as a relative one."""
    effect = f", and the other end has '{_kept(other)}' as a relative name: in a namespace, the two no longer meet"
    return replace(FIXED, key="parted", effect=effect, other=other, place=place)


def in_namespace(namespace: str) -> Reason:
    """For a node that launch files start in one namespace."""
    return replace(FIXED, key="in namespace", effect=_unmoved(namespace))


def _unmoved(namespace: str) -> str:
    return f", and launch files start the node in the namespace '{namespace}', which does not apply to {{it}}"


def _kept(name: str) -> str:
    """A name in an effect, where braces stand for what the effect is on: ``{node}`` is a substitution of ROS."""
    return name.replace("{", "{{").replace("}", "}}")


__all__ = [
    "FIXED",
    "INSTANCES",
    "PARAMETERS",
    "RELATIVE",
    "REPEATED",
    "WITHOUT_PACKAGE",
    "Reason",
    "beside_relative",
    "for_each_instance",
    "in_namespace",
    "parted_from",
    "repeating",
    "shared_by",
    "unlike_another",
]
