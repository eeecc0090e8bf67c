"""Publishers of one topic that do not speak at once: somebody decides whose turn it is, or they speak only once."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.left_over import idle_methods, kept_calls
from archlint.analysis.reach import creations_of
from archlint.analysis.source_code import SourceCode, source_code
from archlint.connections.sharing import COMMANDS
from archlint.finding import Place
from archlint.model import (
    EntityKind,
    Role,
)
from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of
from archlint.syntax.flow_blocks import Block, Edge, Kind, reach, without_exceptions
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import called_name, calls_in, parts_of, statements_of

if TYPE_CHECKING:
    from archlint.model import ApiCall
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.systems.nodes import Endpoint, Node

_PUBLISH = "rclpy.publisher.Publisher.publish"
_WORD = frozenset({"Bool", "String", "Int8", "Int16", "Int32", "Int64", "UInt8", "UInt16", "UInt32", "UInt64"})
WORDS = frozenset({f"std_msgs/msg/{name}" for name in _WORD} | {"std_srvs/srv/SetBool", "std_srvs/srv/Trigger"})
"""Messages and requests that can say whose turn it is; measurements have types of their own."""
_CHOICES = WORDS | {f"std_msgs/msg/{name}MultiArray" for name in _WORD if "Int" in name}
"""Those that can choose one of several publishers: a number may be in an array, beside others."""
_HALTS = frozenset(
    {"collision", "emergency", "estop", "fault", "halt", "kill", "obstacle", "obstacles", "pause", "safety", "stop"}
)
"""Words for what makes every publisher stop: that does not choose one of them."""
_TELL = (EntityKind.SUBSCRIBER, EntityKind.SERVICE, EntityKind.ACTION_SERVER)
"""What others can tell a node by."""
_OF_ONE_NODE = frozenset({EntityKind.SERVICE, EntityKind.ACTION_SERVER})
"""What is there for one node alone: whoever asks it for something has chosen that node."""
_ONCE = frozenset({Role.INIT, Role.MAIN, Role.MODULE})

_Word = tuple[EntityKind, str]
"""The kind and the final name of a topic or service."""


def take_turns(system: System, owners: Sequence[Endpoint]) -> bool:
    """Whether each publisher asks a word that it is given before it publishes: the same topic as the others, which one
    of them may give instead of asking it, or a service of its own that turns it on and off, or a goal of its own."""
    asked = [(owner.node, _asks(system, owner)) for owner in owners]
    givers = {id(node): node for node, words in asked if not words}
    if len(givers) > 1:
        return False
    asking = [words for node, words in asked if id(node) not in givers]
    common = frozenset.intersection(*asking) if asking else frozenset()
    for giver in givers.values():
        return bool(common & _gives(giver))
    return bool(common) or all(any(kind in _OF_ONE_NODE for kind, _ in words) for words in asking)


def speaks_once(system: System, owner: Endpoint) -> bool:
    """Whether a publisher says something only as its program starts or ends: no callback, thread or loop does."""
    calls = publishes_of(system, owner)
    return bool(calls) and all(call.context.role in _ONCE and not call.looped for call in calls)


def only_stops(system: System, owner: Endpoint) -> bool:
    """Whether a publisher of commands says nothing but zero, and not at all times: where something happens, such as an
    emergency, it stops what another node moves."""
    if owner.type not in COMMANDS:
        return False
    code, calls = source_code(system), publishes_of(system, owner)
    return bool(calls) and all(_is_stop_at(code, call) and _is_for_a_reason(code, call) for call in calls)


def _is_stop_at(code: SourceCode, call: ApiCall) -> bool:
    """Whether a call publishes a message that nothing has filled in: ``Twist()``, or a variable that holds that."""
    expression = code.expression(call)
    if expression is None or len(expression.args) != 1:
        return False
    given, body = expression.args[0].value, code.body(call)
    name = given.variable
    if not name:
        return _is_stop(expression)
    uses = [part for part in parts_of(body, facts.Name) if part.id == name]
    values = [
        assignment.value
        for assignment in statements_of(body, facts.Assign)
        if any(target.variable == name for target in assignment.targets)
    ]
    published = sum(
        called_name(other) == "publish" and any(arg.value.variable == name for arg in other.args)
        for other in calls_in(list(body))
    )
    return len(uses) == published + len(values) > published and all(map(_is_new, values))


def _is_stop(call: facts.Call) -> bool:
    return called_name(call) == "publish" and len(call.args) == 1 and _is_new(call.args[0].value)


def _is_new(value: facts.Expr) -> bool:
    """Whether a value is an object as its class makes it."""
    return isinstance(value, facts.Call) and not value.args and called_name(value).rpartition("::")[2][:1].isupper()


def _is_for_a_reason(code: SourceCode, call: ApiCall) -> bool:
    """Whether something has to happen for a call: its callback is not that of a timer, or of one that starts when
    something happens; or a condition decides."""
    graph = graph_of(code.body(call))
    timer = call.context.creation if call.context.role == Role.TIMER else None
    starts_later = timer is not None and timer.context is not None and timer.context.role not in _ONCE
    is_periodic = (call.context.role == Role.TIMER and not starts_later) or call.looped
    return not is_periodic or bool(graph.deciders(graph.evaluating(call.place.span)))


def publishes_of(system: System, owner: Endpoint) -> list[ApiCall]:
    """The calls that publish with a publisher, as far as they are seen."""
    return _publishes(system).get(owner.place, [])


def never_speaks(owner: Endpoint) -> bool:
    """Whether the program that runs a publisher's node comes to none of the calls that publish with it: only methods do
    so that this program never calls, and that nobody else can access."""
    calls = publishes_with(owner)
    return bool(calls) and all(call.context.role == "method" for call in calls)


def is_replaced(system: System, owner: Endpoint) -> bool:
    """Whether the next line puts something else where a publisher has just been put: nothing can publish with it."""
    body = [*source_code(system).body_at(owner.place)]
    own = source_code(system).statement_at(owner.place)
    for statement, following in pairwise(body):
        if statement is own:
            names = [target.dotted for target in statement.assigned]
            again = [part.dotted for part in parts_of(following)]
            return (
                len(names) == 1 and names == [each.dotted for each in following.assigned] and again.count(*names) == 1
            )
    return False


def publishes_with(owner: Endpoint) -> list[ApiCall]:
    """The calls of its node's program that publish with a publisher; none where others may do so, too."""
    node, program = owner.node.blueprint, owner.node.program
    if node is None or program is None or node.escapes or not node.complete:
        return []
    return [
        call
        for call in program.calls
        if call.api == _PUBLISH and any(creation.place == owner.place for creation in creations_of(call.receiver))
    ]


@once
def _publishes(system: System) -> dict[Place, list[ApiCall]]:
    """What is published, by the place where the publisher is made."""
    by_publisher: dict[Place, list[ApiCall]] = {}
    for call in system.calls:
        if call.api == _PUBLISH:
            for creation in creations_of(call.receiver):
                by_publisher.setdefault(creation.place, []).append(call)
    return by_publisher


def _asks(system: System, owner: Endpoint) -> frozenset[_Word]:
    """The words that a publisher asks; none where it publishes anything without asking, or where that is not seen."""
    if system.workspace is not None and system.workspace.code.kind_of(owner.place.file) == "cpp":
        return _asks_in_cpp(system, system.workspace, owner)
    by_attribute, workspace, file = (
        _attribute_words(source_code(system), owner.node),
        system.workspace,
        owner.place.file,
    )
    file_facts = workspace.facts_at(file) if by_attribute and workspace is not None else None
    if file_facts is None or workspace is None:
        return frozenset()
    kept = kept_calls(workspace, file).get((owner.place.line, owner.place.column))
    cls = _class_around(file_facts, owner.place)
    if kept is None or cls is None:
        return frozenset()
    code = source_code(system)
    answers = {
        function.name: (end.kind, end.name)
        for end in owner.node.of_kind(*_TELL)
        for function in map(code.definition, end.creation.callbacks.values())
        if function is not None and end.name is not None
    }
    here = {name: words for (file, name), words in by_attribute.items() if file == owner.place.file}
    idle = idle_methods(workspace, file)
    called = [item for item in cls.body if isinstance(item, facts.Function) and item.name not in idle]
    return _Source(called, here, answers).before(kept, owner.place.line)


def _asks_in_cpp(system: System, workspace: WorkspaceIndex, owner: Endpoint) -> frozenset[_Word]:
    """The words that a publisher of C++ asks before each of its calls, or before the methods that lead there; in a
    word's own callback it need not ask."""
    code = SourceCode(workspace.code.cpp_facts_at)
    by_attribute: dict[str, set[_Word]] = {}  # a class may be in several files
    for (_, name), set_by in _attribute_words(code, owner.node).items():
        by_attribute.setdefault(name, set()).update(set_by)
    words: set[_Word] = set()
    silent: list[ApiCall] = []
    for call in publishes_of(system, owner) if by_attribute else ():
        for way in _ways(code, workspace, call):
            tests = [test for place in way for test in _guards(code.body_at(place), place.span)]
            asked = {word for test in tests for name in _of_self(test) for word in by_attribute.get(name, ())}
            words |= asked
            if not asked and not _is_stop_at(code, call):
                silent.append(call)
    answers = {
        callback.place
        for end in owner.node.of_kind(*_TELL)
        for callback in end.creation.callbacks.values()
        if (end.kind, end.name) in words
    }
    return frozenset(words if all(call.context.place in answers for call in silent) else ())


def _ways(code: SourceCode, workspace: WorkspaceIndex, call: ApiCall) -> Iterator[tuple[Place, ...]]:
    """The places that lead to a call.  Where a method has run by itself, since nothing has come to it yet, these begin
    where the file calls it by its name, or there are none."""
    places = (call.place, *(frame.place for frame in call.chain))
    if call.context.role != Role.METHOD:
        yield places
        return
    first = places[min(1, len(places) - 1)]
    function, file_facts = code.function_at(first), workspace.code.cpp_facts_at(first.file)
    for caller in parts_of(file_facts.body, facts.Call) if file_facts is not None else ():
        if function is not None and called_name(caller) == function.name:
            yield (*places, Place.of(first.file, caller.span))


class _Source:
    """The methods of a class in which publishing is looked for: ``by_attribute`` are the words that set each attribute,
    ``answers`` the words by the method that takes them in."""

    def __init__(
        self, methods: Sequence[facts.Function], by_attribute: dict[str, set[_Word]], answers: dict[str, _Word]
    ) -> None:
        self.methods = methods
        self.by_attribute = by_attribute
        self.answers = answers
        self.waiting: set[str] = set()

    def before(self, attribute: str, set_at: int) -> frozenset[_Word]:
        """The words that are asked before an attribute is used anywhere but in the line where it is set; none where
        one use asks none.  A word's own method may use it, as where a node that is turned off says zero once; a new
        message that nothing has filled in stops, and moves nothing."""
        uses = [
            (method, part)
            for method in self.methods
            for part in _without_stops(method.body)
            if part.attr == attribute and part.span[0] != set_at
        ]
        asked = [(method, self._before_use(method, part.span)) for method, part in uses]
        words = frozenset(word for _, some in asked for word in some)
        return words if all(some or self.answers.get(method.name) in words for method, some in asked) else frozenset()

    def _before_use(self, method: facts.Function, span: facts.Span) -> frozenset[_Word]:
        """The words that are asked in a method before a place, or else before the method is called, wherever it is."""
        names = (name for test in _guards(method.body, span) for name in _of_self(test))
        here = frozenset(word for name in names for word in self.by_attribute.get(name, ()))
        if here or method.name in self.waiting or method.name.startswith("__"):
            return here
        self.waiting.add(method.name)
        above = self.before(method.name, 0)
        self.waiting.discard(method.name)
        return above


def _without_stops(body: Sequence[facts.Stmt]) -> Iterator[facts.Attribute]:
    """The attributes that a body names, without those that it publishes a stop with."""
    stops = {
        call.func.value.span
        for call in calls_in(list(body))
        if isinstance(call.func, facts.Attribute) and isinstance(call.func.value, facts.Attribute) and _is_stop(call)
    }
    yield from (part for part in parts_of(body, facts.Attribute) if part.span not in stops)


def _class_around(file_facts: facts.Facts, place: Place) -> facts.Class | None:
    around = [cls for cls in everything_in(file_facts.body, facts.Class) if _is_in(place.line, cls)]
    return max(around, key=lambda cls: cls.span[0], default=None)


def _attribute_words(code: SourceCode, node: Node) -> dict[tuple[str, str], set[_Word]]:
    """The attributes of ``self``, with their file, that callbacks for such words set, or for goals."""
    words: dict[tuple[str, str], set[_Word]] = {}
    for end in node.of_kind(*_TELL):
        is_word = end.type in _CHOICES or end.kind is EntityKind.ACTION_SERVER
        if not is_word or end.name is None or _halts(end.name):
            continue
        for callback in end.creation.callbacks.values():
            for attribute in _sets(code.definition(callback)):
                words.setdefault((callback.place.file, attribute), set()).add((end.kind, end.name))
    return words


def _halts(name: str) -> bool:
    return not _HALTS.isdisjoint(name.lower().replace("/", "_").split("_"))


def _sets(function: facts.Function | None) -> set[str]:
    """The attributes of ``self`` that a callback sets, or passes to a function together with its message."""
    if function is None or not function.params:
        return set()
    message = {param.name for param in function.params} - {"self"}
    attributes: set[str] = set()
    for statement in statements_of(function.body, facts.Assign):
        attributes.update(name for target in statement.targets for name in _of_self(target))
    for call in calls_in(function.body):
        given = [part for argument in call.args for part in parts_of(argument.value, facts.Name)]
        if any(part.id in message for part in given):
            attributes.update(name for argument in call.args for name in _of_self(argument.value))
    return attributes


def _of_self(expression: facts.Base) -> Iterator[str]:
    """The attributes of ``self`` that an expression has, in C++ by their names alone."""
    for part in parts_of(expression):
        if isinstance(part, facts.Implicit) or (isinstance(part, facts.Attribute) and part.value.variable == "self"):
            yield part.attribute


def _guards(body: Sequence[facts.Stmt], span: facts.Span) -> Iterator[facts.Expr]:
    """The conditions of which one outcome keeps a body from getting to a place."""
    graph = graph_of(body)
    for block in graph.deciders(graph.evaluating(span)):
        tests = [edge.test for edge in block.edges if edge.test is not None]
        if tests and not _speaks_anyway(block):
            yield tests[0]


def _speaks_anyway(block: Block) -> bool:
    """Whether something is published after either outcome of a condition, for which the other does not lead there: then
    it chooses what is said, not whether."""
    reached = [reach([edge.target], _in_this_iteration) for edge in block.edges if edge.test is not None]
    return len(reached) > 1 and all(
        any(map(_publishes_in, blocks.difference(*reached[:i], *reached[i + 1 :]))) for i, blocks in enumerate(reached)
    )


def _in_this_iteration(edge: Edge) -> bool:
    return edge.kind is not Kind.BACK and without_exceptions(edge)


def _publishes_in(block: Block) -> bool:
    return any(called_name(call) == "publish" and not _is_stop(call) for call in calls_in(block.fact))


def _is_in(line: int, item: facts.Stmt) -> bool:
    span: tuple[int, int, int, int] | None = getattr(item, "span", None)
    return span is not None and span[0] <= line <= span[2]


def _gives(node: Node) -> frozenset[_Word]:
    """The words that a node says to others, as :func:`_attribute_words` names them."""
    to_user = {EntityKind.PUBLISHER: EntityKind.SUBSCRIBER, EntityKind.CLIENT: EntityKind.SERVICE}
    return frozenset(
        (to_user[end.kind], end.name)
        for end in node.of_kind(EntityKind.PUBLISHER, EntityKind.CLIENT)
        if end.name is not None
    )


__all__ = ["WORDS", "never_speaks", "publishes_of", "publishes_with", "speaks_once", "take_turns"]
