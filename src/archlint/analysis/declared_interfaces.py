"""Where committed declarations of nodes and their code disagree."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import PurePath
from typing import TYPE_CHECKING

from archlint.analysis.completeness import is_complete
from archlint.model import EntityKind
from archlint.place import Place
from archlint.records import dataclass
from archlint.ros import names
from archlint.ros.interface_profiles import profile_of
from archlint.ros.parameter_types import OF_PARAMETER_LIBRARY
from archlint.ros.well_known import OF_EVERY_NODE
from archlint.syntax.interface_declarations import FILE_NAME, read_interface_documents
from archlint.syntax.nodl_declarations import SUFFIX, read_nodl

if TYPE_CHECKING:
    from archlint.model import ParameterDeclaration
    from archlint.ros.qos import Qos
    from archlint.syntax.interface_declarations import EndEntry, EndKey, InterfaceDocument, ParameterEntry
    from archlint.systems.model import System
    from archlint.systems.nodes import Endpoint, Node

_KINDS: Mapping[EndKey, tuple[EntityKind, str]] = {
    "publishers": (EntityKind.PUBLISHER, "publisher"),
    "subscribers": (EntityKind.SUBSCRIBER, "subscription"),
    "services": (EntityKind.SERVICE, "service"),
    "service_clients": (EntityKind.CLIENT, "client"),
    "actions": (EntityKind.ACTION_SERVER, "action server"),
    "action_clients": (EntityKind.ACTION_CLIENT, "action client"),
}


@dataclass(frozen=True)
class Drift:
    """Something that a declaration says otherwise than the code; ``other`` is the place of the other one, where there
    is one, and ``in_code`` says whether ``place`` is in the code."""

    place: Place
    node: Node
    words: str
    other: Place | None
    in_code: bool
    file: str


def drifts(system: System) -> Iterator[Drift]:
    """All of a system of all code.  A declaration of a node that is not here, or of one of several of its name, says
    nothing: it may be in C++."""
    index = system.workspace
    if index is None:
        return
    nodes: dict[tuple[str | None, str], list[Node]] = {}
    for node in system.nodes:
        if node.blueprint is not None and not node.test and node.blueprint.name.text is not None:
            nodes.setdefault((node.package, node.blueprint.name.text), []).append(node)
    for file in index.declaration_files:
        text = index.tree.text(file) or ""
        for document in read_nodl(text) if file.endswith(SUFFIX) else read_interface_documents(text):
            package = document.package or index.package_of(file)
            of_name = nodes.get((package, document.name), [])
            if len(of_name) == 1:
                yield from _Comparison(document, of_name[0], PurePath(file).as_posix()).drifts()


@dataclass(frozen=True)
class _Comparison:
    document: InterfaceDocument
    node: Node
    file: str

    def drifts(self) -> Iterator[Drift]:
        complete = is_complete(self.node)
        for key, (kind, noun) in _KINDS.items():
            yield from self._ends(key, kind, noun, complete)
        yield from self._parameters(complete)

    def _ends(self, key: EndKey, kind: EntityKind, noun: str, complete: bool) -> Iterator[Drift]:
        created: dict[str, list[Endpoint]] = {}
        for end in self.node.of_kind(kind):
            if end.resolved and end.name is not None:
                created.setdefault(end.name, []).append(end)
        declared = {self._full(entry): entry for entry in self.document.ends if entry.key == key}
        for name, entry in declared.items():
            if name in created:
                differences = [list(self._differences(entry, end, noun)) for end in created[name]]
                yield from differences[0] if all(differences) else ()
            elif complete and name is not None:
                yield self._stale(f"the {noun} '{entry.name}'", entry)
        if key in self.document.open_keys or None in declared:
            return
        for name, ends in created.items():
            first = ends[0]
            if name in declared or first.conditional or name in OF_EVERY_NODE:
                continue
            if all(self._can_be_declared(end) for end in ends):
                yield self._undeclared(f"the {noun} '{first.written}'", first.place)

    def _can_be_declared(self, end: Endpoint) -> bool:
        """Whether a document has words for an end: its type is known, and its QoS where that has to be said."""
        if end.type is None:
            return False
        if not self.document.has_qos or end.kind not in (EntityKind.PUBLISHER, EntityKind.SUBSCRIBER):
            return True
        return end.qos is not None and end.qos.known and profile_of(end.qos) is not None

    def _full(self, entry: EndEntry) -> str | None:
        """The full name of a declared end; None where ROS takes none such."""
        own = self.node.own
        if own is None or own.name.text is None or own.namespace.text is None:
            return None
        full = names.expand(entry.name, own.name.text, own.namespace.text)
        return full if isinstance(full, str) else None

    def _differences(self, entry: EndEntry, end: Endpoint, noun: str) -> Iterator[Drift]:
        differences = [*_profile(entry.qos, end.qos)] if end.qos is not None else []
        if entry.type is not None and end.type is not None and entry.type != end.type:
            differences.insert(0, (entry.type, end.type))
        if differences:
            said, created = (", ".join(words) for words in zip(*differences, strict=True))
            words = f"the {noun} '{entry.name}' is declared as {said} and created as {created}"
            yield Drift(self._at(entry.span), self.node, words, end.place, False, self.file)

    def _parameters(self, complete: bool) -> Iterator[Drift]:
        declared = {entry.name: entry for entry in self.document.parameters}
        created: dict[str, ParameterDeclaration] = {}
        for parameter in self.node.parameters:
            if parameter.name.text is not None and parameter.name.resolution in ("exact", "parameter"):
                created.setdefault(parameter.name.text, parameter)
        all_known = len({p.place for p in created.values()}) >= len({p.place for p in self.node.parameters})
        for name, entry in declared.items():
            if name in created:
                yield from self._parameter(entry, created[name])
            elif complete and all_known:
                yield self._stale(f"the parameter '{name}'", entry)
        unsaid = "parameters" in self.document.open_keys
        for name, parameter in created.items():
            can_be_declared = parameter.type in OF_PARAMETER_LIBRARY
            if can_be_declared and name not in declared and not parameter.conditional and not unsaid:
                yield self._undeclared(f"the parameter '{name}'", parameter.place)

    def _parameter(self, entry: ParameterEntry, parameter: ParameterDeclaration) -> Iterator[Drift]:
        type_ = None if parameter.type is None else OF_PARAMETER_LIBRARY.get(parameter.type)
        differs = None not in (entry.type, type_) and _plain_type(entry.type or "") != type_
        if differs:
            words = f"has the type {entry.type} here and {type_} in the code"
        elif entry.default and parameter.known and not parameter.given and entry.default[0] != parameter.default:
            words = f"has the default {entry.default[0]!r} here and {parameter.default!r} in the code"
        else:
            return
        words = f"the parameter '{entry.name}' {words}"
        yield Drift(self._at(entry.span), self.node, words, parameter.place, False, self.file)

    def _stale(self, what: str, entry: EndEntry | ParameterEntry) -> Drift:
        words = f"{what} of {self.node.name} is declared here and not in the code"
        return Drift(self._at(entry.span), self.node, words, None, False, self.file)

    def _undeclared(self, what: str, place: Place) -> Drift:
        words = f"{what} is not declared in {self.file}"
        return Drift(place, self.node, words, self._at(self.document.span), True, self.file)

    def _at(self, span: tuple[int, int, int, int]) -> Place:
        return Place.of(self.file, span)


def _plain_type(declared: str) -> str:
    """``string_fixed_25`` is a string."""
    return declared.partition("_fixed_")[0]


def _profile(declared: Mapping[str, object], qos: Qos) -> Iterator[tuple[str, str]]:
    """The policies that differ, as declared and as created."""
    for policy, created in (("reliability", qos.reliability), ("durability", qos.durability)):
        said = declared.get(policy)
        if isinstance(said, str) and "${" not in said and created is not None and said.lower() != created:
            yield said.lower().replace("_", " "), created.replace("_", " ")
    history = declared.get("history")
    kept = {"keep_all": "ALL", "keep_last": qos.depth}.get(qos.history or "")
    if kept is not None and (history == "ALL" or isinstance(history, int)) and history != kept:
        yield _history(history), _history(kept)


def _history(words: object) -> str:
    return "keep all" if words == "ALL" else f"keep last {words}"


__all__ = ["FILE_NAME", "Drift", "drifts"]
