"""Patterns of the declared architecture that match nothing: what they say holds without being looked at."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.architecture import CONNECTIONS, PACKAGE, REQUIRE, Globs, matches
from archlint.checks.required import is_concerned
from archlint.connections.links import connections, is_meant
from archlint.suggestions import did_you_mean

if TYPE_CHECKING:
    from archlint.architecture import ConnectionKind, Contract
    from archlint.checks.registry import Options
    from archlint.systems.model import System


def idle_patterns(systems: Sequence[System], options: Options) -> Iterator[str]:
    """A sentence for each pattern under ``[[contracts]]``, ``[layers]`` and ``[owners]`` that no node, topic,
    service or action of any system has; nothing where only a part of the workspace was looked at."""
    if any(system.workspace is not None and system.workspace.is_subset for system in systems):
        return
    known = _Known(systems, options)
    for contract in options.contracts:
        where = f"{contract.place.file}:{contract.place.line}: the contract '{contract.name}'"
        if contract.kind == REQUIRE:  # where something is missing in a system that it is about, ARC003 says so
            if not any(is_concerned(system, contract) for system in systems):
                yield f"{where} is not checked: some of what it names does not exist"
            continue
        yield from (f"{where} {words}" for words in _of_contract(contract, known))
    layers = options.layers
    for name in layers.order if layers is not None else ():
        assert layers is not None
        yield from (f"the layer '{name}' {words}" for words in known.without_node(layers.members[name]))
    for name, owners in options.owners.items():
        yield from (f"[owners] {words}" for words in known.without_name((name,), CONNECTIONS))
        yield from (f"[owners] for '{name}' {words}" for words in known.without_node(owners))


def _of_contract(contract: Contract, known: _Known) -> Iterator[str]:
    for globs in (contract.source, contract.target, contract.provider, contract.user, contract.nodes):
        yield from known.without_node(globs)
    if contract.connection is not None:
        yield from known.without_name(contract.names, (contract.connection,))


class _Known:
    """What the systems have: nodes, and names by the kind of connection."""

    def __init__(self, systems: Iterable[System], options: Options) -> None:
        self._options = options
        self._nodes = [node for system in systems for node in system.nodes]
        self._names: dict[ConnectionKind, set[str]] = {kind: set() for kind in CONNECTIONS}
        for system in systems:
            for connection in connections(system):
                self._names[connection.kind].add(connection.name)

    def without_node(self, globs: Globs) -> Iterator[str]:
        for glob in globs:
            if self._options.is_external(glob) or any(is_meant((glob,), node) for node in self._nodes):
                continue
            if glob.startswith(PACKAGE):
                packages = {f"{PACKAGE}{node.package}" for node in self._nodes if node.package}
                yield f"matches nothing: no node is of a package '{glob.removeprefix(PACKAGE)}'" + did_you_mean(
                    glob, packages
                )
            else:
                names = {node.name for node in self._nodes if node.name and not node.test}
                yield f"matches nothing: no node is called '{glob}'{did_you_mean(glob, names)}"

    def without_name(self, globs: Globs, kinds: tuple[ConnectionKind, ...]) -> Iterator[str]:
        names = {name for kind in kinds for name in self._names[kind]}
        for glob in globs:
            if not self._options.is_external(glob) and not any(matches((glob,), name) for name in names):
                yield f"matches nothing: no {' or '.join(kinds)} is called '{glob}'{did_you_mean(glob, names)}"
