"""What may stand where somebody types: names of the right kind and type, types, parameters, packages, executables."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping

from archlint.lookup.answers import Completion, CompletionKind
from archlint.lookup.index import PROVIDERS, Index
from archlint.lookup.known_nodes import nodes_in_file, nodes_of_key, nodes_started
from archlint.lookup.texts import Texts
from archlint.lookup.typed_python import wanted_in_python
from archlint.lookup.typed_xml import wanted_in_xml
from archlint.lookup.typed_yaml import wanted_in_yaml
from archlint.lookup.types_to_import import types_of_package, types_wanted
from archlint.lookup.wanted import Wanted, WantedKind
from archlint.model import NAMED
from archlint.systems.nodes import Endpoint, Node


def complete(index: Index, texts: Texts, file: str, line: int, column: int) -> list[Completion]:
    """What may stand at a position, the best first; empty where nothing of ROS is expected.

    The call or element need not be complete, and the run need not know it."""
    wanted = wanted_at(texts, file, line, column)
    if wanted is None:
        return []
    answers = dict.fromkeys(_OFFER[wanted.what](index, texts, wanted))
    return sorted(answers, key=lambda each: (each.rank, each.text, each.detail))


def wanted_at(texts: Texts, file: str, line: int, column: int) -> Wanted | None:
    """What is wanted at a position, by the text of the file alone."""
    if file.endswith(".py"):
        return wanted_in_python(texts, file, line, column)
    if file.endswith((".xml", ".launch")):
        return wanted_in_xml(texts, file, line, column)
    if file.endswith((".yaml", ".yml")):
        return wanted_in_yaml(texts, file, line, column)
    return None


def _names(index: Index, texts: Texts, wanted: Wanted) -> Iterator[Completion]:
    """The names of the same kind and type: as the code of a node in no namespace writes them, or in full where a slash
    is typed."""
    if wanted.entity is None:
        return
    kind, offers = NAMED[wanted.entity], wanted.entity in PROVIDERS
    in_full = wanted.typed.startswith("/")
    rows: dict[str, tuple[int, str]] = {}
    for end, is_open in _ends(index):
        name = end.name if in_full else _relative(end) if is_open else None
        if name is None or NAMED[end.kind] != kind or not _fits(end, wanted) or _is_here(end, wanted):
            continue
        rank = 0 if (end.kind in PROVIDERS) != offers else 1
        rows[name] = min(rows.get(name, (rank, end.type or "")), (rank, end.type or ""))
    for name, (rank, type_name) in rows.items():
        yield Completion(name, kind, type_name, wanted.replaces, rank)


def _relative(end: Endpoint) -> str | None:
    """The name as another node writes it: a private one is private to its own."""
    written = end.written
    return end.name.removeprefix("/") if end.name and written and written.startswith("~") else written


def _ends(index: Index) -> Iterator[tuple[Endpoint, bool]]:
    """The endpoints with known names, and whether each is one of the code alone."""
    for system, _ in index.systems:
        for end in system.endpoints:
            if end.resolved and not end.error and not end.node.test:
                yield end, system.name is None


def _fits(end: Endpoint, wanted: Wanted) -> bool:
    """Whether an endpoint may be of the type that is wanted: the whole of it, or its last part, is known."""
    if not wanted.type or end.type is None:
        return True
    return end.type == wanted.type if "/" in wanted.type else end.type.rpartition("/")[2] == wanted.type


def _is_here(end: Endpoint, wanted: Wanted) -> bool:
    """Whether an endpoint is that of the half-typed name itself."""
    at, place = wanted.replaces, end.place
    return place.file == at.file and place.line <= at.line <= place.end_line


def _types(index: Index, texts: Texts, wanted: Wanted) -> Iterator[Completion]:
    return types_wanted(index, texts, wanted)


def _imports(index: Index, texts: Texts, wanted: Wanted) -> Iterator[Completion]:
    return types_of_package(index, wanted)


def _parameters(index: Index, texts: Texts, wanted: Wanted) -> Iterator[Completion]:
    """What the node at hand declares: that of the class, of the launch file's element or of the section."""
    if wanted.node:
        nodes = nodes_of_key(index, wanted.node)
    elif wanted.package or wanted.executable:
        nodes = nodes_started(index, wanted.package, wanted.executable)
    elif wanted.replaces.file.endswith(".py"):
        nodes = nodes_in_file(index, texts, wanted.replaces)
    else:
        nodes = []
    for declaration in (declaration for node in nodes for declaration in node.parameters):
        name = declaration.name.text
        if name is not None and declaration.name.resolution == "exact" and name.startswith(wanted.module):
            default = f" = {declaration.default!r}" if declaration.known else ""
            detail = f"{declaration.type or 'type not known'}{default}"
            yield Completion(name.removeprefix(wanted.module), "parameter", detail, wanted.replaces)


def _packages(index: Index, texts: Texts, wanted: Wanted) -> Iterator[Completion]:
    """The packages of the workspace, first those that install executables, and those that launch files name."""
    for name, installs in index.workspace.installs.items():
        count = len(installs.executables)
        detail = f"{count} executable{'' if count == 1 else 's'}" if count else "in this workspace"
        yield Completion(name, "package", detail, wanted.replaces, 0 if count else 1)
    for subject in index.subjects():
        if subject.kind == "package" and subject.name not in index.workspace.installs:
            yield Completion(subject.name, "package", "launched here", wanted.replaces, 2)


def _executables(index: Index, texts: Texts, wanted: Wanted) -> Iterator[Completion]:
    for subject in index.subjects():
        if subject.kind == "executable" and wanted.package in ("", subject.owner):
            yield Completion(subject.name, "executable", subject.owner, wanted.replaces)


def _sources(index: Index, texts: Texts, wanted: Wanted) -> Iterator[Completion]:
    """The names that the node itself gives to what it creates."""
    for node in nodes_started(index, wanted.package, wanted.executable):
        for end in _resolved(node):
            if end.written is not None:
                yield Completion(end.written, NAMED[end.kind], end.type or "", wanted.replaces)


def _targets(index: Index, texts: Texts, wanted: Wanted) -> Iterator[Completion]:
    """The names that there are."""
    for end, _ in _ends(index):
        if end.name is not None:
            yield Completion(end.name, NAMED[end.kind], end.type or "", wanted.replaces)


def _resolved(node: Node) -> Iterator[Endpoint]:
    return (end for end in node.endpoints if end.resolved and not end.error)


def _node_keys(index: Index, texts: Texts, wanted: Wanted) -> Iterator[Completion]:
    """The nodes that have parameters, by their full names."""
    kind: CompletionKind = "node"
    for system, rank in index.systems:
        for node in system.nodes:
            if node.name is not None and node.resolution == "exact" and node.parameters and not node.test:
                class_name = node.blueprint.class_name if node.blueprint is not None else ""
                yield Completion(node.name, kind, class_name, wanted.replaces, rank)


_OFFER: Mapping[WantedKind, Callable[[Index, Texts, Wanted], Iterable[Completion]]] = {
    "name": _names,
    "type": _types,
    "import": _imports,
    "parameter": _parameters,
    "package": _packages,
    "executable": _executables,
    "remap source": _sources,
    "remap target": _targets,
    "node key": _node_keys,
}

__all__ = ["complete", "wanted_at"]
