"""NME004: nodes of one launched system under one name, by what makes them so: an executable, an include, an action."""

from __future__ import annotations

import posixpath
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import combinations, groupby, takewhile
from typing import TYPE_CHECKING

from archlint.analysis.brief_programs import is_brief
from archlint.analysis.keyboard_answers import is_answered
from archlint.branches import exclusive, runs_along
from archlint.checks.doubled_includes import Again, Twins, included_twice, of_includes
from archlint.checks.folding import folds, with_other_places, with_others
from archlint.checks.launched_names import is_given_by_launch
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related, Severity
from archlint.launch.parameter_sources import files_among
from archlint.model import Role
from archlint.systems.overrides import key_matches, settings_of

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.launch.started import Started
    from archlint.model import Blueprint
    from archlint.systems.model import System
    from archlint.systems.nodes import Node
    from archlint.systems.overrides import Setting


@rule("NME004", scope=Scope.SYSTEM, in_use=True)
def duplicate_node_name(system: System, options: Options) -> Iterator[Finding]:
    """Nodes of one launched system under one name."""
    if system.launched is None:
        return
    included: dict[Again, list[Twins]] = {}
    of_actions: dict[tuple[int, int], list[Twins]] = {}
    of_process: dict[tuple[int, str | None, Severity], list[Finding]] = {}
    for twins in _twins(system):
        node, other = twins
        again = None if node.started is other.started else included_twice(node.started, other.started)
        if again is not None:
            included.setdefault(again, []).append(twins)
        elif node.started is other.started:
            for told in _of_one_process(system, *twins):
                of_process.setdefault((id(node.started), told.help, told.severity), []).append(told)
        else:
            of_actions.setdefault((id(node.started), id(other.started)), []).append(twins)
    yield from map(_with_all_names, of_process.values())
    for several in of_actions.values():
        yield from _of_two_actions(system, several)
    yield from of_includes(included, system.nodes)


def _twins(system: System) -> Iterator[Twins]:
    """Of each name two nodes that have it for certain, in the order in which they are started."""
    named = [n for n in system.nodes if n.name is not None and n.resolution == "exact" and n.launch_place]
    named = [node for node in named if node.error is None and not is_given_by_launch(node)]  # the others never start
    for _, group in groupby(sorted(named, key=lambda n: n.name or ""), key=lambda node: node.name):
        pairs = combinations(list(group), 2)
        twins = next((pair for pair in pairs if _coexist(system, *pair)), None)
        if twins is not None:
            yield twins


def _coexist(system: System, node: Node, other: Node) -> bool:
    """Whether two nodes certainly run at the same time."""
    if node.domain != other.domain or not runs_along(node.alternatives, other.alternatives):
        return False
    if any(is_brief(system, each) for each in (node, other)):
        return False
    if any(each.known is not None and each.known.conditional for each in (node, other)):
        return False  # who starts the program may never meet the condition
    if node.started is not other.started:
        return True
    if any(_is_never_initialised(each) for each in (node, other)):
        return False
    return not (_gone_before(node, other) or _gone_before(other, node) or _in_other_branches(node, other))


def _is_never_initialised(node: Node) -> bool:
    """Whether a process makes an object of a class of nodes that comes to no ``Node.__init__()``: it forgets to call
    it, or raises an exception before it does."""
    blueprint, program = node.blueprint, node.program
    if blueprint is None or program is None or blueprint.caller_unknown:
        return False
    return not blueprint.constructed and blueprint.complete and not program.exhausted


def _in_other_branches(node: Node, other: Node) -> bool:
    """Whether a process makes one of two nodes, and never both."""
    first, second = node.blueprint, other.blueprint
    if first is None or second is None:
        return False
    makers = first.made_by, second.made_by
    if makers[0] is not makers[1] and any(maker is not None and maker.role == Role.METHOD for maker in makers):
        return True  # what calls the method is not known
    if first.branch_arms & second.ended_arms or second.branch_arms & first.ended_arms:
        return True
    return exclusive(first.branch_arms, second.branch_arms)


def _gone_before(node: Node, other: Node) -> bool:
    """Whether a process has destroyed or freed a node before it makes another."""
    first, second = node.blueprint, other.blueprint
    if first is None or second is None:
        return False
    ends = first.gone if _made_in_turn(first, second) else ()
    if any(second.number >= number and arms <= second.branch_arms for arms, number in ends):
        return True
    if first.until is None or any(c.callbacks for c in first.creations):
        return False
    return second.number >= first.until


def _made_in_turn(first: Blueprint, second: Blueprint) -> bool:
    """Whether one thread makes two nodes, one after the other."""
    makers = first.made_by, second.made_by
    return makers[0] is makers[1] or all(
        maker is not None and maker.role in (Role.MAIN, Role.MODULE) for maker in makers
    )


def _of_two_actions(system: System, several: list[Twins]) -> Iterator[Finding]:
    """One finding for two launch actions, with all names that both give."""
    first, other = several[0]
    here = other.launch_place
    if first.launch_place is None or here is None:
        return
    names = [twin.name or "" for twin, _ in several]
    more = _namesakes(system, first, other) if len(names) == 1 else []
    shared = f"{_COUNTS.get(len(more), 'many')} nodes of this system have the name '{names[0]}'"
    if len(names) > 1:
        shared = f"two launch actions start nodes with the same names: {', '.join(names)}"
    if first.launch_place == here:
        shared = f"this line creates several actions, and each starts a node with the name '{names[0]}'"
        if _includes_of(first.started, other.started):
            shared = f"this line starts several nodes with the name '{names[0]}'"
    late = all(twin.started is not None and twin.started.without_namespace for twin in (first, other))
    if late:
        shared = f"{shared}: the namespace of the group around it is gone when its timer or event handler starts it"
    sole = all(sum(node.started is twin.started for node in system.nodes) == 1 for twin in (first, other))
    help = "give each its own name"
    section = _with_its_section(system, first, other)
    if late:
        help, section = "put the timer or event handler around the group, or give each node its namespace=", ""
    elif not sole:
        help, section = _each_renamed(first), ""
    elif first.launch_place != here and _is_one_too_many(first.started, other.started):
        help, section = "remove one of the two: they start the same program in the same way", ""
    elif _start_one_program(first.started, other.started):
        help = "give each its own name or namespace"  # with other topics, a namespace would part them from the rest
        if first.launch_place.file != here.file:
            help = f"start the program once, or {help}"
    diagnostic = finding(
        "NME004",
        here,
        shared,
        help=help + section,
        related=[
            *([Related(first.launch_place, "the other one is started here")] if first.launch_place != here else []),
            *(Related(place, "another one is started here") for place in more),
            *_includes_apart(first.started, other.started),
            *(Related(place, "its file is included here") for place in _includes_of(first.started, other.started)),
            *_names_in_the_code(first, other),
        ],
        node=names[0],
        identity=tuple(names),
    )
    files = dict.fromkeys((first.launch_place.file, here.file))
    if late:
        files, cause = {here.file: None}, ""
    elif not sole:
        files, cause = {(other.package or ""): None}, _CODE
    else:
        cause = help if len(files) == 1 else ""
    yield replace(diagnostic, group=(_TOGETHER, system.name or "", *files, cause))


_CODE = "code"
"""The cause of what no launch file can mend: nodes that a class makes beside its own, each time under one name."""
_TOGETHER, _OF_PROCESS = "together", "of one process"
"""Kinds of groups: nodes that are started in the same way, and starts of one executable."""


@folds("NME004", across_systems=True)
def _of_one_group(several: Sequence[Finding]) -> Finding:
    """One finding for all nodes of a launch file that are to be told apart in the same way, for all that two files both
    start, and for all launch files that start one executable with several nodes of a name."""
    if several[0].group[0] == _OF_PROCESS:
        return with_other_places(several, "it is started here, too")
    return with_others(several, "another node is", "more nodes are", "started in the same way")


def _with_its_section(system: System, *twins: Node) -> str:
    """What else has to change with a name: the key of its section in a parameter file."""
    section = next((row for twin in twins if (row := _section_of(system, twin)) is not None), None)
    if section is None:
        return ""
    file = posixpath.basename(section.place.file)
    return f", and {file} a section for each: '{section.written}' is for one name alone"


def _section_of(system: System, node: Node) -> Setting | None:
    """What a parameter file sets of a node in a section with its name."""
    if node.started is None or system.workspace is None:
        return None
    rows = settings_of(node.started, system.workspace.parameters_of)
    return next((row for row in rows if row.written and "*" not in row.key and key_matches(row.key, node.name)), None)


def _includes_of(first: Started | None, other: Started | None) -> list[Place]:
    """Where the file is included in which one line starts two processes."""
    if first is None or other is None or first.place != other.place:
        return []
    return list(dict.fromkeys(place for started in (first, other) for place in started.includes[-1:]))


def _includes_apart(first: Started | None, other: Started | None) -> Iterator[Related]:
    """Where a launch file includes the two files that start two processes, or one of these beside the other process:
    neither file shows both."""
    if first is None or other is None or first.file == other.file:
        return
    shared = sum(
        1 for _ in takewhile(lambda pair: pair[0] == pair[1], zip(first.includes, other.includes, strict=False))
    )
    for started in (first, other):
        apart = started.includes[shared : shared + 2]
        if apart:
            included = apart[1].file if len(apart) > 1 else started.file
            yield Related(apart[0], f"{posixpath.basename(included)} is included here")


def _names_in_the_code(*twins: Node) -> Iterator[Related]:
    """Where the code gives a node the name that no launch file replaces."""
    for twin in twins:
        origin = None if twin.blueprint is None else twin.blueprint.name.origin
        if origin is not None and (twin.started is None or twin.started.name is None):
            yield Related(origin, f"the code gives '{twin.name}' its name here")


_COUNTS = dict(enumerate(("two", "three", "four", "five", "six", "seven", "eight")))


def _namesakes(system: System, first: Node, other: Node) -> list[Place]:
    """Where further nodes are started under the name of two, beside both of them."""
    places: dict[Place, None] = {}
    for node in system.nodes:
        named = node.name == first.name and node.resolution == "exact" and node.launch_place is not None
        if named and node not in (first, other) and _coexist(system, node, first) and _coexist(system, node, other):
            assert node.launch_place is not None
            places.setdefault(node.launch_place)
    return sorted(place for place in places if place not in (first.launch_place, other.launch_place))


def _is_one_too_many(first: Started | None, other: Started | None) -> bool:
    """Whether two files start one executable in the same way, so that another name would only hide that both nodes send
    and receive the same."""
    if first is None or other is None or first.file == other.file:
        return False
    way = _way_of(first)
    return way is not None and way == _way_of(other)


def _each_renamed(node: Node) -> str:
    """How a process that makes several nodes is told to call one of them another name."""
    bare = _own_name(node)
    if bare is None:
        return "give each its own name in the code: name= would rename all nodes of an action"
    return (
        f"give each its own name in the code, or in one action ros_arguments=['-r', '{bare}:__node:=…']: name= would "
        "rename all its nodes"
    )


def _start_one_program(first: Started | None, other: Started | None) -> bool:
    """Whether two actions start one executable: of two files, perhaps neither knows of the other."""
    if first is None or other is None:
        return False
    texts = (first.package, other.package), (first.executable, other.executable)
    return all(mine.resolution == "exact" and mine.text == yours.text for mine, yours in texts)


def _way_of(started: Started) -> tuple[object, ...] | None:
    """What tells one start of a program from another; None where not all of it is known or something is set in it."""
    files = [use.reference.source for use in files_among(started.parameters)]
    if started.remaps or len(files) < len(started.parameters) or None in files or None in started.arguments:
        return None
    texts = (started.package, started.executable, started.name, started.namespace)
    return *(None if text is None else (text.text, text.resolution) for text in texts), *files, *started.arguments


def _of_one_process(system: System, first: Node, other: Node) -> Iterator[Finding]:
    if other.launch_place is None:
        return
    renamed = first.started is not None and first.started.name is not None
    differ = first.known is not None or _own_name(first) != _own_name(other)
    message = f"this executable creates several nodes with the name '{first.name}'"
    if renamed and differ:
        message = f"name= renames every node of this executable, so several have the name '{first.name}'"
    arms = [frozenset() if node.blueprint is None else node.blueprint.branch_arms for node in (first, other)]
    sure = arms[0] == arms[1]
    if system.workspace is not None and is_answered(system.workspace, arms[0] ^ arms[1]):
        return  # a launch has no keyboard to answer at
    diagnostic = finding(
        "NME004",
        other.launch_place,
        message if sure else f"{message}, once a branch of its code has created both",
        help=_unrenamed(system, first)
        if renamed and differ
        else "give each its own name in the code" + (", and remove name= here" if renamed else ""),
        related=list(dict.fromkeys(related for node in (first, other) for related in _creation_sites(node))),
        node=first.name,
        identity=(first.name or "",),
        group=(_OF_PROCESS, *(str(node.blueprint.place) for node in (first, other) if node.blueprint is not None)),
    )
    yield diagnostic if sure else replace(diagnostic, severity=Severity.INFO)


def _with_all_names(several: Sequence[Finding]) -> Finding:
    """One finding for all names that nodes of one process share, in several namespaces say: one edit parts them."""
    first, *others = several
    if not others:
        return first
    names = ", ".join(f"'{other.node}'" for other in others)
    related = dict.fromkeys(row for each in several for row in each.related)
    identity = tuple(name for each in several for name in each.identity)
    return replace(first, message=f"{first.message}; so it is with {names}", related=tuple(related), identity=identity)


def _unrenamed(system: System, node: Node) -> str:
    """The advice to remove ``name=``: a section of a parameter file that is for the name would be read by no node."""
    started = node.started
    if (private := _with_private_names(system, node)) is not None:
        return (
            f"keep name= for '{private}', whose names below ~/ go by it, and create the other with "
            "use_global_arguments=False (in C++: rclcpp::NodeOptions().use_global_arguments(false))"
        )
    others = {twin.name for twin in system.nodes if twin.started is not started}
    taken = next((own for own in _names_of_its_own(system, node) if own in others), None)
    if taken is not None:
        return f"remove name=, and create no '{taken}' in this executable: this system starts one by itself"
    doubled = _doubled_names(system, node)
    if doubled:
        listed = ", ".join(f"'{name}'" for name in doubled)
        return f"remove name=, and give each node a name of its own in the code: several are called {listed}"
    lost = _section_of(system, node)
    if lost is None:
        return "remove name=, so that each node keeps the name from its code"
    file = posixpath.basename(lost.place.file)
    return f"remove name=, and call the section '{lost.written}' of {file} as the code calls the node that reads it"


def _with_private_names(system: System, node: Node) -> str | None:
    """What the code calls the only one of two nodes of a process that has names below its own, where another node knows
    one of them: without ``name=`` these would change."""
    twins = [twin for twin in system.nodes if twin.started is node.started]
    having = [twin for twin in twins if any((end.written or "").startswith("~/") for end in twin.endpoints)]
    if len(twins) != 2 or len(having) != 1:
        return None
    private = {end.name for end in having[0].endpoints if (end.written or "").startswith("~/")}
    used = any(end.name in private for other in system.nodes if other not in twins for end in other.endpoints)
    return _own_name(having[0]) if used else None


def _names_of_its_own(system: System, node: Node) -> list[str]:
    """The full names that the nodes of a process would have without ``name=``."""
    namespace = (node.name or "").rpartition("/")[0]
    twins = [twin for twin in system.nodes if twin.started is node.started]
    return sorted(f"{namespace}/{own}" for own in map(_own_name, twins) if own is not None)


def _doubled_names(system: System, node: Node) -> list[str]:
    """The full names that several nodes would have if no ``name=`` renamed the nodes of a process, nor of another that
    creates some of the same name: whoever removes it from one action removes it from all."""
    own = Counter(_names_of_its_own(system, node))
    renamed = {id(twin.started): twin for twin in system.nodes if twin.started is not None and twin.started.name}
    others = [twin for twin in renamed.values() if twin.started is not node.started]
    elsewhere = {name for twin in others for name in _names_of_its_own(system, twin)}
    return [name for name, number in own.items() if number > 1 or name in elsewhere]


def _own_name(node: Node) -> str | None:
    """What the code calls a node."""
    return node.blueprint.name.text if node.blueprint is not None else None


def _creation_sites(node: Node) -> Iterator[Related]:
    blueprint = node.blueprint
    if blueprint is not None:
        shown = blueprint.name.text or blueprint.class_name
        yield Related(blueprint.made_at or blueprint.place, f"'{shown}' is created here")
