"""What may stand where somebody types: for each kind of thing that is wanted, who knows what there is."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping

from archlint.lookup.answers import Completion
from archlint.lookup.index import Index
from archlint.lookup.names_to_use import names_to_remap, names_to_remap_to, names_wanted
from archlint.lookup.parameters_to_set import node_keys, parameters_wanted
from archlint.lookup.texts import Texts
from archlint.lookup.typed_python import wanted_in_python
from archlint.lookup.typed_xml import wanted_in_xml
from archlint.lookup.typed_yaml import wanted_in_yaml
from archlint.lookup.types_to_import import types_of_package, types_wanted
from archlint.lookup.wanted import Wanted, WantedKind


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


def _types(index: Index, texts: Texts, wanted: Wanted) -> Iterator[Completion]:
    return types_wanted(index, texts, wanted)


def _imports(index: Index, texts: Texts, wanted: Wanted) -> Iterator[Completion]:
    return types_of_package(index, wanted)


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


_OFFER: Mapping[WantedKind, Callable[[Index, Texts, Wanted], Iterable[Completion]]] = {
    "name": names_wanted,
    "type": _types,
    "import": _imports,
    "parameter": parameters_wanted,
    "package": _packages,
    "executable": _executables,
    "remap source": names_to_remap,
    "remap target": names_to_remap_to,
    "node key": node_keys,
}

__all__ = ["complete", "wanted_at"]
