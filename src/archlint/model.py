"""What linking yields: programs, the nodes they make, what those create, and the calls that matter.

Names here are still as the code gives them (relative, ``~``); the load floor expands them for a system.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.libraries.rclpy.message_uses import FieldUse, UnknownInterface
    from archlint.syntax import facts

PUBLISHER = "publisher"
SUBSCRIBER = "subscriber"
SERVICE = "service"
CLIENT = "client"
ACTION_SERVER = "action_server"
ACTION_CLIENT = "action_client"
TIMER = "timer"
GUARD = "guard_condition"

NEVER_CONSTRUCTED = "the node's constructor is not reached"
"""Why the name of an object of a node class is not known where nothing calls ``Node.__init__`` on it."""

ENDPOINT_KINDS = (PUBLISHER, SUBSCRIBER, SERVICE, CLIENT, ACTION_SERVER, ACTION_CLIENT)


@dataclass(frozen=True)
class Text:
    """A string that the code computes: a name, as far as it is known.

    ``resolution`` is ``exact`` (one known text), ``parameter`` (``text`` is the default or override of the
    parameter called ``parameter``, or built from it), ``partial`` (``*`` in ``text`` stands for what only
    data decides) or ``unknown`` (``text`` is None).  ``reason`` says why for the last two.
    ``origin`` is where the text is written down, if it is written in one place; ``origin_kind`` is
    ``literal``, ``format`` (an f-string or an operation on literals), ``argument_default``, ``node_name`` (made
    from the name or namespace of a node) or ``other``.
    """

    text: str | None
    resolution: str
    parameter: str | None = None
    reason: str | None = None
    origin: Place | None = None
    origin_kind: str = "other"


@dataclass(frozen=True)
class Qos:
    """A quality-of-service profile.  Values are lower case as in rmw (``keep_last``, ``best_effort``,
    ``transient_local``, ``system_default``, ``best_available`` …); None is what could not be resolved.
    Durations are in seconds, None where the default (infinite) stands.  ``explicit`` names the policies that
    the code set itself."""

    history: str | None = "keep_last"
    depth: int | None = 10
    reliability: str | None = "reliable"
    durability: str | None = "volatile"
    deadline: float | None = None
    lifespan: float | None = None
    liveliness: str | None = "system_default"
    liveliness_lease: float | None = None
    explicit: frozenset[str] = frozenset()
    unknown_durations: frozenset[str] = frozenset()
    parameter: str | None = None
    """The parameter that decides (part of) the profile, if one does."""
    place: Place | None = None
    """Where the profile is written."""
    overridable: bool = False
    """True where the code passes ``qos_overriding_options``: parameters may change the profile."""

    @property
    def known(self) -> bool:
        """True where history, depth, reliability and durability are all resolved."""
        return None not in (self.history, self.reliability, self.durability) and (
            self.depth is not None or self.history != "keep_last"
        )


@dataclass(frozen=True)
class Group:
    """A callback group: ``kind`` is ``default``, ``mutually_exclusive``, ``reentrant`` or ``unknown``;
    ``key`` tells one group object from another inside a program (None: not one object for certain)."""

    kind: str = "default"
    key: str | None = None
    place: Place | None = None


@dataclass(frozen=True)
class Frame:
    """One hop of a chain of calls: ``caller`` calls ``callee`` at ``place``."""

    caller: str
    callee: str
    place: Place
    body: Sequence[facts.Stmt] = field(default=(), compare=False, repr=False)
    """Body of the caller."""


@dataclass(eq=False)
class Callback:
    """What an executor, a future or a thread is given to run.

    ``role`` is ``subscription``, ``timer``, ``service``, ``execute`` (of an action), ``goal``, ``cancel``,
    ``accepted``, ``feedback``, ``done`` (of a future), ``parameter``, ``event``, ``guard``, ``task``, ``thread``,
    ``lifecycle``, ``filter``; for code that no callback runs: ``init``, ``main``, ``module``, ``method``
    (a method that nothing in the workspace calls).
    """

    role: str
    name: str
    """Qualified name for people: ``SensorNode.on_scan``, ``main``, ``<lambda>``."""
    place: Place
    """Where the function is defined."""
    function: facts.Function | facts.Lambda | None
    node: Blueprint | None = None
    creation: Creation | None = None
    """The entity whose callback this is."""
    group: Group | None = None
    """None: runs in no callback group."""
    registered: Place | None = None
    """Where it was handed over."""
    is_async: bool = False
    bound_arguments: int = 0
    """How many leading positional arguments are already bound (``self``, ``partial``)."""
    bound_keywords: frozenset[str] = frozenset()
    """Parameters that a ``partial`` binds by name."""
    file: str = ""
    missing: str | None = None
    """Set when the callback names a method that does not exist: its name."""


@dataclass(eq=False)
class Creation:
    """One create call of one node: a publisher, subscription, service, client, action, timer …

    ``conditional`` is set where only a branch that could not be decided creates it; ``arms`` names those
    branches as ``(branch, arm)``: two creations with one branch and different arms exclude each other.
    """

    kind: str
    api: str
    """The call as rclpy knows it, such as ``rclpy.node.Node.create_publisher``."""
    node: Blueprint
    place: Place
    name: Text
    type: str | None
    """``package/msg/Name``; None with ``type_reason`` where unknown."""
    type_reason: str | None = None
    type_place: Place | None = None
    qos: Qos | None = None
    callbacks: dict[str, Callback] = field(default_factory=dict)
    """By role; a subscription has ``subscription``, an action server ``execute``, ``goal`` …"""
    group: Group = field(default_factory=Group)
    conditional: bool = False
    arms: frozenset[tuple[str, int]] = frozenset()
    chain: tuple[Frame, ...] = ()
    """The calls that lead from the start of the run to the create call."""
    context: Callback | None = None
    """What was running: ``init``, ``main`` or a callback."""
    period: float | None = None
    """Seconds, of timers and rates; None where unknown."""
    period_parameter: str | None = None
    type_parameter: str | None = None
    """The parameters that choose the type, separated by commas."""
    function: str = ""
    """Qualified name of the function that holds the create call."""
    name_place: Place | None = None
    """The argument that gives the name, at the create call."""
    raw: bool = False
    guard: str = ""
    """What an ``if`` on the way, decided or not, or an early return asks before the create call is made: ``arguments``
    (nothing but what a callback was called with), ``state`` (anything else), or nothing."""
    proven: tuple[tuple[facts.Expr, bool], ...] = ()
    """The conditions around the create call, with how they came out, that ask for no local variable."""
    stored: bool = True
    """False where the result of the create call is thrown away."""
    destroyed: bool = False
    key: int = 0


@dataclass(eq=False)
class ParameterDeclaration:
    name: Text
    type: str | None
    """ROS type name: ``bool``, ``integer``, ``double``, ``string``, ``byte_array``, ``bool_array``,
    ``integer_array``, ``double_array``, ``string_array``; None where dynamic or unknown."""
    default: object
    """The Python value; None where there is none or it is unknown (see ``known``)."""
    known: bool
    place: Place
    node: Blueprint
    conditional: bool = False
    ignore_override: bool = False
    dynamic: bool = False
    chain: tuple[Frame, ...] = ()
    given: tuple[object, ...] = ()
    """The value that the constructor's ``parameter_overrides`` give it, which wins over all others; empty: none."""
    uncalled: bool = False
    """Whether it stands in a method that nothing here calls, of a base class say."""


@dataclass(eq=False)
class ApiCall:
    """A call of an API that checks care about: blocking calls, spins, sleeps, parameter reads …

    ``api`` is the canonical dotted name; ``arguments`` maps the API's own parameter names to values of the
    link floor.  ``chain`` leads from ``context`` (what is running) to the call.
    """

    api: str
    place: Place
    context: Callback
    chain: tuple[Frame, ...]
    arguments: dict[str, object]
    argument_places: dict[str, Place]
    receiver: object = None
    """The link floor's value the method is called on."""
    creation: Creation | None = None
    """The endpoint the call is made on or waits for, where it is known."""
    node: Blueprint | None = None
    function: str = ""
    file: str = ""
    expression: facts.Call | None = None
    statement: facts.Stmt | None = None
    loops: tuple[facts.While | facts.For, ...] = ()
    """The loops of the same function that go round it, outermost first: not those that it always leaves."""
    body: list[facts.Stmt] = field(default_factory=list)
    """Body of the enclosing function."""
    conditional: bool = False
    awaited: bool = False
    in_try: bool = False
    """Whether a ``try`` is around it, here or in a caller."""
    rounds: tuple[Place, ...] = ()
    """The loops that go round it, also those of its callers, outermost first."""
    arms: tuple[tuple[str, int], ...] = ()
    """The arms of undecided branches that lead to it, outermost first."""
    limits: tuple[float | None, ...] = ()
    """For each of ``loops`` the seconds after which it ends, where it watches the clock for a known time."""
    cleaning: bool = False
    """Whether it is reached only where something has failed, and the callback ends with it."""
    ways: list[tuple[tuple[Frame, ...], tuple[Place, ...], tuple[Creation, ...]]] = field(default_factory=list)
    """Other chains (the loops on them, the endpoints it is for) from the same context, through the same arms."""

    @property
    def looped(self) -> bool:
        """Whether a loop, be it in a caller, goes round it."""
        return bool(self.rounds)


ClassKey = tuple["Place", str]
"""Where a class is written, and its qualified name."""


@dataclass(eq=False)
class Blueprint:
    """A node as one program makes it, before a launch file renames or remaps anything.

    ``name`` and ``namespace`` are the constructor's; ``class_name`` the class (or function, for
    ``create_node``).  With ``held`` it is no node: what a class or function creates on a node that nothing here
    is seen to hand it, and what a class with a base from elsewhere creates on itself while nothing shows that
    the base is a node.
    """

    class_name: str
    name: Text
    namespace: Text
    place: Place
    package: str | None
    lifecycle: bool = False
    held: bool = False
    classes: tuple[ClassKey, ...] = ()
    """Its class and the bases of that which are of this workspace."""
    annotated: tuple[ClassKey, str] | None = None
    """What annotations tell of a node that nothing here hands in: its class, or the class of what holds it and the
    attribute there."""
    creations: list[Creation] = field(default_factory=list)
    parameters: list[ParameterDeclaration] = field(default_factory=list)
    callbacks: list[Callback] = field(default_factory=list)
    executables: tuple[str, ...] = ()
    executor: str = "none"
    """``single_threaded``, ``multi_threaded``, ``none`` (never spun) or ``unknown``."""
    test: bool = False
    """True where the node is defined in test code: never judged together with others."""
    complete: bool = True
    """False where something that may create entities could not be followed; ``gaps`` says what."""
    gaps: list[tuple[Place, str]] = field(default_factory=list)
    key: str = ""
    allow_undeclared_parameters: bool = False
    automatically_declare_parameters: bool = False
    made_at: Place | None = None
    """The call that makes it, where one does."""
    arms: frozenset[tuple[str, int]] = frozenset()
    """The branches that make it, as ``Creation.arms``."""
    instead_of: Blueprint | None = None
    """The node of the same class and name that it took the place of in a variable."""
    served_apart: bool = False
    """True where an executor was given it, and not one of several nodes."""
    handed_out: bool = False
    """True where code that is not in this workspace is given the node: that may spin it."""
    number: int = 0
    """How many nodes the program had made before this one."""
    until: int | None = None
    """How many it had made when this one was freed, as the function that held it returned; None where it may stay."""
    made_by: Callback | None = None
    """What ran as it was made: ``main``, or a callback."""
    destroyed_at: int | None = None
    """How many nodes the program had made when ``destroy_node()`` ran on this one, whatever branch was taken, in what
    ``made_by`` is; None where it may live on."""
    enable_rosout: bool = True
    start_parameter_services: bool = True
    use_global_arguments: bool = True
    """False where the command line of the process (names, remappings, parameters) does not reach the node."""
    cli_arguments: tuple[str, ...] = ()

    @property
    def made_again(self) -> bool:
        """Whether it is another node once more, that one being gone: ``while not node.ready: node = Driver()``."""
        first = self.instead_of
        return first is not None and not (self.served_apart and first.served_apart)


FOR_A_MOMENT = 0
"""A spin that gives one thing a chance: one round, until a future is done, in the constructor of the node."""
FOR_A_WHILE = 1
"""A loop of spins that ends by itself."""
TO_THE_END = 2
"""A spin that lasts until the program ends."""


@dataclass(frozen=True)
class Spell:
    """A spin that was given a node itself: its executor serves the node for that time only."""

    place: Place
    lasting: int
    """:data:`FOR_A_MOMENT`, :data:`FOR_A_WHILE` or :data:`TO_THE_END`."""
    in_constructor: bool
    """True where the node's own constructor spins."""
    for_answer: bool
    """True where it lasts until the answer of a client is there."""
    creations: int
    """How many entities the node had by then."""


@dataclass(eq=False)
class ExecutorUse:
    """An executor of a program: what spins which nodes, with how many threads."""

    kind: str
    """``single_threaded``, ``multi_threaded``, ``events`` or ``unknown``."""
    threads: int | None
    nodes: list[Blueprint]
    place: Place | None
    in_thread: bool = False
    spun: bool = False
    lasting: int = FOR_A_MOMENT
    """How long the most lasting of its spins goes on, as for :class:`Spell`."""
    spun_at: Place | None = None
    """The first call of those that spin it longest."""
    spells: dict[Blueprint, list[Spell]] = field(default_factory=dict)
    """The nodes that are only there while a spin that is given them lasts, with these spins."""
    astray: bool = False
    """True where it was given a node that is not known."""

    def lasts_for(self, node: Blueprint) -> int:
        """How long it spins one of its nodes."""
        spells = self.spells.get(node)
        return self.lasting if spells is None else max(spell.lasting for spell in spells)

    def spins_at(self, node: Blueprint) -> Place | None:
        """The call that spins one of its nodes longest."""
        lasting = self.lasts_for(node)
        return next((spell.place for spell in self.spells.get(node, ()) if spell.lasting == lasting), self.spun_at)


@dataclass(frozen=True)
class Overrides:
    """What one process gets from outside: the values of parameters, and the names of its nodes.

    ``of_nodes`` are those of its nodes, by the name and namespace that their constructors give; ``others`` are
    for a node that is not among them.  ``settled`` are the parameters whose values are certain while the
    process starts: set on every node that has them, or left to their defaults for sure.  ``names`` has the final
    name and namespace of each node that is given others than its constructor's.
    """

    of_nodes: Mapping[tuple[str | None, str | None], Mapping[str, object]] = field(default_factory=dict)
    others: Mapping[str, object] = field(default_factory=dict)
    settled: frozenset[str] = frozenset()
    names: Mapping[tuple[str | None, str | None], tuple[Text, Text]] = field(default_factory=dict)

    def of(self, node: Blueprint | None) -> Mapping[str, object]:
        """Values by parameter name."""
        return self.others if node is None else self.of_nodes.get(node_key(node), self.others)

    @property
    def key(self) -> tuple[object, ...]:
        """What tells two of them apart."""
        rows = [(repr(node), _rows(values)) for node, values in self.of_nodes.items()]
        names = [(repr(node), repr(names)) for node, names in self.names.items()]
        return (*sorted(rows), _rows(self.others), *sorted(self.settled), *sorted(names))


def _rows(values: Mapping[str, object]) -> tuple[tuple[str, str], ...]:
    return tuple(sorted((name, repr(value)) for name, value in values.items()))


def node_key(node: Blueprint) -> tuple[str | None, str | None]:
    """The name and namespace that a node's constructor gives."""
    return node.name.text, node.namespace.text


@dataclass(eq=False)
class Program:
    """One executable (or a class or function that no executable reaches), run symbolically."""

    name: str
    """Executable name, or the qualified name of the class or function that was run."""
    package: str | None
    file: str
    nodes: list[Blueprint] = field(default_factory=list)
    calls: list[ApiCall] = field(default_factory=list)
    callbacks: list[Callback] = field(default_factory=list)
    executors: list[ExecutorUse] = field(default_factory=list)
    field_uses: list[FieldUse] = field(default_factory=list)
    callers: dict[Place, set[Place | None]] = field(default_factory=dict)
    """Where the functions that use fields of their parameters are called; None for code that is not here."""
    unknown_interfaces: list[UnknownInterface] = field(default_factory=list)
    refused: set[Place] = field(default_factory=set)
    """The calls that Python refuses: the arguments do not fit."""
    reads_command_line: bool = False
    parses_command_line: bool = False
    """Whether it looks at ``sys.argv``, and whether argparse divides that up for it."""
    reads_node_names: bool = False
    """Whether it asks a node for its name, which may be another than that in the code."""
    exhausted: bool = False
    """True where a bound on depth or steps cut the run short."""
    late: bool = False
    """True where it was cut short since other programs of the workspace had run so much."""
    executable: bool = True

    def executors_of(self, node: Blueprint) -> list[ExecutorUse]:
        """The executors that spin a node; of several those that do so longest.

        Where the program is not all there is (nothing starts it, or the node comes from outside), a spin for a
        moment says nothing of who spins the node later.
        """
        uses = [use for use in self.executors if use.spun and node in use.nodes]
        least = FOR_A_WHILE if node.held or not self.executable else FOR_A_MOMENT
        longest = max((use.lasts_for(node) for use in uses), default=least)
        return [use for use in uses if use.lasts_for(node) == longest >= least]
