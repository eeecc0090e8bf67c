"""Helpers: classes and functions that work on a node which is passed to them.

Each is also tried alone, with a node that is not known, so that no create call is missed.  Where other code passes it
a node, that node has its endpoints, and what was tried says nothing more.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, TypeVar

from archlint import model
from archlint.finding import Place
from archlint.interpreter.heap import Slot
from archlint.interpreter.values import Value, alternatives
from archlint.libraries.rclpy import node_classes, nodes
from archlint.reasons import NotPassed

if TYPE_CHECKING:
    from archlint.libraries.run import Run

Holders = dict[tuple[model.ClassKey, str], list[model.Blueprint]]
"""The nodes that objects of a class were seen to hold, by class and attribute."""

_Made = TypeVar("_Made", model.Creation, model.ParameterDeclaration)


def holders_in(run: Run, layer: Mapping[Slot, object]) -> list[tuple[model.ClassKey, str, model.Blueprint]]:
    """Which objects of a program hold a node in the end, by their classes, and in which attribute."""
    rows: list[tuple[model.ClassKey, str, model.Blueprint]] = []
    for (key, slot), value in layer.items():
        holder = run.instances.get(key)
        if holder is None or not isinstance(slot, str) or holder.own_class is None:
            continue
        for option in alternatives(value) if isinstance(value, Value) else ():
            node = nodes.known_node(run, option)
            if node is not None:
                rows.extend((cls, slot, node) for cls in node_classes.keys(holder.own_class))
    return rows


def settle_helpers(programs: Sequence[model.Program], holders: Holders) -> None:
    """Drop what helpers create on nodes that are not known, where a known node has it; give the rest to the node that
    annotations name; then drop the empty ones."""
    every = [node for program in programs for node in program.nodes]
    owned = _names_by_place(creation for node in every if not node.caller_unknown for creation in node.creations)
    declared = _names_by_place(parameter for node in every if not node.caller_unknown for parameter in node.parameters)
    for node in every:
        if node.caller_unknown:
            node.creations = [creation for creation in node.creations if not _is_known(creation, owned)]
            node.parameters = [declaration for declaration in node.parameters if not _is_known(declaration, declared)]
            _give_away(node, _meant(node, every, holders))
    for program in programs:
        if any(_is_nothing(node, program) for node in program.nodes):
            program.nodes[:] = [node for node in program.nodes if not _is_nothing(node, program)]


def changed_by_settling(
    programs: Sequence[model.Program],
    holders: Holders,
    names_in_file: Callable[[str], frozenset[str]],
    others: Sequence[model.Blueprint] = (),
) -> list[model.Program]:
    """The programs, and perhaps some more, in which :func:`prune_uncalled`, :func:`settle_helpers` or
    :func:`note_unfollowed` change something."""
    helpers = [node for program in programs for node in program.nodes if node.caller_unknown]
    annotated = {helper.annotated for helper in helpers if helper.annotated is not None}
    classes = {cls for cls, attribute in annotated if not attribute}
    held = {id(node) for meant in annotated for node in holders.get(meant, ())}
    names = {_short_name(helper) for helper in (*helpers, *others)}

    def may_change(node: model.Blueprint, program: model.Program) -> bool:
        if node.caller_unknown or id(node) in held or _is_nothing(node, program):
            return True
        if any(own.key in classes for own in node.classes) or any(map(_is_uncalled, node.creations)):
            return True
        return bool(names) and not names.isdisjoint(names_in_file(node.place.file))

    return [program for program in programs if any(may_change(node, program) for node in program.nodes)]


def helpers_in(programs: Sequence[model.Program]) -> list[model.Blueprint]:
    """What works on a node that is not known, outside of tests."""
    return [node for program in programs for node in program.nodes if node.caller_unknown and not node.test]


def note_unfollowed(
    programs: Sequence[model.Program],
    names_in_file: Callable[[str], frozenset[str]],
    others: Sequence[model.Blueprint] = (),
) -> None:
    """A node that may be the one which a helper works on is not complete: those of its program, and those whose file
    speaks of it.  ``others`` are helpers of programs that were run before these."""
    known = [(helper, program) for program in programs for helper in helpers_in([program])]
    for helper, home in [*known, *((helper, None) for helper in others)]:
        name = _short_name(helper)
        gap = (helper.place, f"the node that {helper.class_name} works on is not known")
        for program in programs:
            for node in program.nodes:
                if node.caller_unknown or gap in node.gaps:
                    continue
                if program is home or name in names_in_file(node.place.file):
                    node.complete = False
                    node.gaps.append(gap)


def _short_name(helper: model.Blueprint) -> str:
    return helper.class_name.rpartition(".")[2]


def _names_by_place(items: Iterable[_Made]) -> dict[Place, set[str | None]]:
    names: dict[Place, set[str | None]] = {}
    for item in items:
        names.setdefault(item.place, set()).add(item.name.text)
    return names


def _is_known(item: _Made, owned: dict[Place, set[str | None]]) -> bool:
    """Whether a known node has what one line creates: under this name, or where the name is that of a caller."""
    names = owned.get(item.place)
    return names is not None and (item.name.text in names or item.name.resolution in ("partial", "unknown"))


def _meant(helper: model.Blueprint, every: Sequence[model.Blueprint], holders: Holders) -> list[model.Blueprint]:
    """The node, as each program makes it, that annotations name; none where they may mean several."""
    if helper.annotated is None:
        return []
    cls, attribute = helper.annotated
    of_class = (node for node in every if any(own.key == cls for own in node.classes))
    candidates = holders.get(helper.annotated, []) if attribute else list(of_class)
    candidates = [node for node in candidates if not node.caller_unknown and node.test <= helper.test]
    is_single = len({(node.place, node.class_name, node.name.text) for node in candidates}) == 1
    return list({id(node): node for node in candidates}.values()) if is_single else []


def _give_away(helper: model.Blueprint, owners: Sequence[model.Blueprint]) -> None:
    """Put a helper's endpoints and parameters under a node.  Nothing shows that it is passed, so each is there
    under a condition."""
    if not owners:
        return
    for number, owner in enumerate(owners):
        for creation in helper.creations:
            given = creation if number == 0 else replace(creation)
            given.node, given.conditional = owner, True
            owner.creations.append(given)
        owner.parameters += [replace(parameter, node=owner, conditional=True) for parameter in helper.parameters]
    for callback in (registered for creation in helper.creations for registered in creation.callbacks.values()):
        callback.node = owners[0]
    helper.creations, helper.parameters = [], []


def _is_nothing(node: model.Blueprint, program: model.Program) -> bool:
    """Whether there is nothing to say of it: no endpoint or parameter, of a helper or of an object that runs its
    own constructor and never that of its base, rclpy's Node."""
    unmade = not node.constructed and not program.exhausted and node.complete
    return (node.caller_unknown or unmade) and not node.creations and not node.parameters


def prune_uncalled(programs: list[model.Program]) -> None:
    """Drop what a method would create if anybody called it, where others show what it creates when called.

    A wrapper that every node inherits and few call is tried on each of them; it is kept where nothing better is
    known of its create call, and then once.  A node of an executable that is seen from end to end has nothing of what
    it never calls.
    """
    sites: dict[Place, list[model.Creation]] = {}
    seen: set[int] = set()
    for program in programs:
        for node in program.nodes:
            if program.executable and node.complete and not node.caller_unknown:
                seen.update(id(creation) for creation in node.creations)
            for creation in node.creations:
                sites.setdefault(creation.place, []).append(creation)
    dropped: set[int] = set()
    for creations in sites.values():
        uncalled = [creation for creation in creations if _is_uncalled(creation)]
        unclear = [creation for creation in uncalled if id(creation) not in seen]
        kept = unclear[:1] if len(uncalled) == len(creations) else []
        dropped.update(id(creation) for creation in uncalled if creation not in kept)
    for program in programs:
        for node in program.nodes:
            if not dropped.isdisjoint(map(id, node.creations)):
                node.creations = [creation for creation in node.creations if id(creation) not in dropped]


def _is_uncalled(creation: model.Creation) -> bool:
    match creation:
        case model.Creation(
            context=model.Callback(role=model.Role.METHOD), name=model.Text(text=None, reason=NotPassed())
        ):
            return True
    return False


__all__ = ["Holders", "helpers_in", "holders_in", "note_unfollowed", "prune_uncalled", "settle_helpers"]
