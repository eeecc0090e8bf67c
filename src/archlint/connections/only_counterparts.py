"""Topics with one side only that belong together: the only two of their type, with names of the same words.

``pump_emergency_stop`` and ``emergency_stop``, ``tank_filled_done`` and ``has_tank_filled``, ``cost_map`` and
``costmap_topic``.  Names like that are two topics as a rule, whose other ends are elsewhere; not where the workspace
has no third topic of that type with one side, and nothing else in it writes either name.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import TYPE_CHECKING

from archlint.analysis.completeness import is_complete
from archlint.analysis.kept import kept
from archlint.connections.own_types import are_only_ends, files_that_name, is_defined
from archlint.connections.parts_elsewhere import has_parts_elsewhere
from archlint.model import EntityKind

if TYPE_CHECKING:
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.systems.nodes import Connection, Endpoint

_PARTS = re.compile(r"_+|(?<=[a-z])(?=[A-Z])")
_EMPTY = frozenset({"topic", "msg", "message"})
"""Words that say of a topic what it is anyway."""
_HAPPENED = frozenset({"has", "is", "was", "done", "finished"})
"""Words that say that something has happened."""
_ENDINGS = ("ed", "s")
_SHORTEST_STEM = 3
_SHORTEST = 4
"""How many letters two names must share at least."""
_COMMON = 2
"""How many words one name must have of the other, which has one more."""
_PLAIN = "std_msgs/"
"""Types that drivers and tools from elsewhere seldom speak, unlike a ``Twist``, an ``Image`` or a ``JointState``."""
_NAMED_IN = (
    *(".c", ".cc", ".cpp", ".cs", ".h", ".hpp", ".html", ".ino", ".ipynb", ".java", ".js", ".json", ".jsx", ".launch"),
    *(".perspective", ".py", ".rs", ".rviz", ".sdf", ".sh", ".toml", ".ts", ".tsx", ".urdf", ".vue", ".world"),
    *(".xacro", ".xml", ".yaml", ".yml"),
)
"""What may have the name of a topic that it uses."""


class OnlyOnes:
    """The topics with one side only of a system, of each type."""

    def __init__(self, alone: Iterable[Connection]) -> None:
        self._names: dict[tuple[str | None, bool], set[str]] = {}
        for connection in alone:
            for end in (*connection.providers, *connection.users):
                key = end.type, end.kind is EntityKind.PUBLISHER
                self._names.setdefault(key, set()).add(connection.name)

    def are_meant_as_one(self, system: System, publisher: Endpoint, subscription: Endpoint) -> bool:
        """Whether a publisher and a subscription without partners are the only ones of their type, and their names
        consist of the same words, or nobody else can have the type."""
        workspace, type_ = system.workspace, publisher.type
        if workspace is None or publisher.kind is not EntityKind.PUBLISHER or type_ is None:
            return False
        if any(len(self._names.get(key, ())) != 1 for key in ((type_, True), (type_, False))):
            return False
        if (None, True) in self._names or (None, False) in self._names:
            return False  # of a type that is not known
        alike = _are_alike(publisher.name or "", subscription.name or "", type_, workspace)
        ends = publisher, subscription
        if not alike and (any(_is_in_a_document(workspace, end) for end in ends) or not are_only_ends(system, *ends)):
            return False
        if not (is_complete(publisher.node) and is_complete(subscription.node)) or has_parts_elsewhere(workspace):
            return False
        own = frozenset() if alike else frozenset(end.place.file for end in ends)  # which are followed
        return not any(_is_written_elsewhere(system, workspace, end, own) for end in ends)


def _are_alike(name: str, other: str, type_: str, workspace: WorkspaceIndex) -> bool:
    namespace, _, mine = name.rpartition("/")
    beside, _, yours = other.rpartition("/")
    if namespace != beside:
        return False
    if have_one_core(mine, yours):
        return True
    return is_one_word_more(mine, yours) and (type_.startswith(_PLAIN) or is_defined(workspace, type_))


def have_one_core(name: str, other: str) -> bool:
    """Whether two names have the same words in one order, but for their endings and for words that say nothing."""
    if len({_HAPPENED.isdisjoint(_words(each)) for each in (name, other)}) > 1:
        return False  # what is to be done, and that it is done
    mine, yours = ("".join(_core(each)) for each in (name, other))
    return mine == yours and len(mine) >= _SHORTEST


def _core(name: str) -> list[str]:
    return [_stem(word) for word in _words(name) if word not in _EMPTY | _HAPPENED]


def _stem(word: str) -> str:
    for ending in _ENDINGS:
        if word.endswith(ending) and len(word) - len(ending) >= _SHORTEST_STEM:
            return word.removesuffix(ending)
    return word


def is_one_word_more(name: str, other: str) -> bool:
    """Whether one of two names has all words of the other, at least two, in their order, and one in front of them."""
    short, long = sorted((_words(name), _words(other)), key=len)
    return len(short) >= _COMMON and long[1:] == short and not any(letter.isdigit() for letter in long[0])


def _words(name: str) -> list[str]:
    return [word.lower() for word in _PARTS.split(name) if word]


def _is_written_elsewhere(system: System, workspace: WorkspaceIndex, end: Endpoint, followed: frozenset[str]) -> bool:
    """Whether a file that makes no end of a topic has the last part of its name, but for some that are ``followed``."""
    name = (end.name or "").rpartition("/")[2]
    files = kept(workspace, (_is_written_elsewhere, name), lambda: files_that_name(workspace, name, _NAMED_IN))
    connection = system.topics[end.name or ""]
    return not files <= {each.place.file for each in (*connection.providers, *connection.users)} | followed


_DOCUMENTS = (".md", ".rst", ".txt")
_BY_HAND = "ros2 topic"


def _is_in_a_document(workspace: WorkspaceIndex, end: Endpoint) -> bool:
    """Whether a document that tells how to publish or read a topic by hand has the last part of its name: a person may
    be the other end."""
    name = (end.name or "").rpartition("/")[2]
    files = kept(workspace, (_is_in_a_document, name), lambda: files_that_name(workspace, name, _DOCUMENTS))
    return any(_BY_HAND in (workspace.tree.text(file) or "") for file in files)


__all__ = ["OnlyOnes", "have_one_core", "is_one_word_more"]
