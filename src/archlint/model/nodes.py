"""A node as one program makes it, and what it creates: endpoints, timers, parameters, callbacks."""

from __future__ import annotations

from dataclasses import field
from typing import TYPE_CHECKING, Literal

from archlint.model.kinds import EntityKind, ExecutorKind, GroupKind, Role
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.branches import BranchArms
    from archlint.finding import Place
    from archlint.model.texts import Text
    from archlint.ros.parameter_types import ParameterType
    from archlint.ros.qos import Qos


GuardKind = Literal["arguments", "state", ""]
"""What is asked before a create call: only what a callback was called with, anything else, or nothing."""

NEVER_CONSTRUCTED = "the node's constructor is not reached"
"""Why the name of an object of a node class is not known where nothing calls ``Node.__init__`` on it."""


@dataclass(frozen=True)
class Group:
    """A callback group: ``key`` sets one group object apart from another inside a program (None: not one object for
    certain)."""

    kind: GroupKind = GroupKind.DEFAULT
    key: str | None = None
    place: Place | None = None


@dataclass(frozen=True)
class Frame:
    """One hop of a chain of calls: ``caller`` calls ``callee`` at ``place``."""

    caller: str
    callee: str
    place: Place


@dataclass(frozen=True)
class FunctionRef:
    """A function, method or lambda of the workspace, by its qualified name and the place of its name; of a lambda, all
    of it."""

    name: str
    place: Place
    is_lambda: bool = False


@dataclass(eq=False)
class Callback:
    """What an executor, a future or a thread is given to run, or code that no callback runs."""

    role: Role
    name: str
    """Qualified name for people: ``SensorNode.on_scan``, ``main``, ``<lambda>``."""
    place: Place
    """Where the function is defined."""
    function: FunctionRef | None
    """None for what is not followed, and for code that is no function."""
    node: Blueprint | None = None
    creation: Creation | None = None
    """The entity whose callback this is."""
    group: Group | None = None
    """None: runs in no callback group."""
    registered: Place | None = None
    """Where it was registered."""
    is_async: bool = False
    bound_arguments: int = 0
    """How many leading positional arguments are already bound (``self``, ``partial``)."""
    bound_keywords: frozenset[str] = frozenset()
    """Parameters that a ``partial`` binds by name."""
    never_starts: bool = False
    """True of a thread that is made and not started."""
    given_count: int | None = None
    """How many arguments a task, or the callback of a message filter, is called with; None of all others, whose role
    says it, and where it is not known."""
    dropped: str = ""
    """Of a synchronizer's callback: the type of a message without a header, which the synchronizer drops, so that it
    never calls anything."""
    file: str = ""
    missing: str | None = None
    """Set when the callback names a method that does not exist: its name."""
    docstring: str = ""
    """That of its function."""


@dataclass(eq=False)
class Creation:
    """One create call of one node: a publisher, subscription, service, client, action, timer …

    ``conditional`` is set where only a branch that could not be decided creates it; ``branch_arms`` says
    which: two creations in different arms of one branch exclude each other.
    """

    kind: EntityKind
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
    callbacks: dict[Role, Callback] = field(default_factory=dict)
    group: Group = field(default_factory=Group)
    conditional: bool = False
    branch_arms: BranchArms = frozenset()
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
    guard: GuardKind = ""
    """What an ``if`` on the way, decided or not, or an early return asks before the create call is made: ``arguments``
    (nothing but what a callback was called with), ``state`` (anything else), or nothing."""
    proven: tuple[tuple[Place, bool], ...] = ()
    """The ``if`` statements around the create call whose conditions ask for no local variable, with how these came
    out."""
    stored: bool = True
    """False where the result of the create call is thrown away."""
    destroyed: bool = False


@dataclass(frozen=True)
class ParameterDescription:
    """What a ``ParameterDescriptor`` says of a parameter, as far as it is known.

    Source: ``rcl_interfaces/msg/ParameterDescriptor``, ``FloatingPointRange`` and ``IntegerRange``.
    """

    text: str = ""
    constraints: str = ""
    """``additional_constraints``: what the range does not say, in the author's words."""
    read_only: bool = False
    lowest: float | None = None
    highest: float | None = None
    """The ends of the range, both inclusive, in the unit of the parameter; None without a range."""
    step: float | None = None
    """None where any value between the ends will do."""


@dataclass(eq=False)
class ParameterDeclaration:
    name: Text
    type: ParameterType | None
    """None where dynamic or unknown."""
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
    """Whether it is in a method that nothing here calls, of a base class say."""
    without_default: bool = False
    """Whether the code gives a type and no value: who reads it while nobody has set it gets an exception
    (``ParameterUninitializedException`` of rclpy)."""
    description: ParameterDescription | None = None
    """None where the code gives no descriptor."""


ClassKey = tuple["Place", str]
"""Where a class is written, and its qualified name."""


@dataclass(frozen=True)
class NodeClass:
    """A class of this workspace that a node is an object of."""

    place: Place
    """Where its name is written."""
    name: str
    """Its qualified name."""
    bases: tuple[ClassKey, ...] = ()
    """What it derives from, near and far, of this workspace."""
    just_rclpy: bool = False
    """Whether it is just an rclpy node: it derives from rclpy's Node, and from nothing else that is not in this
    workspace and may create or declare something."""
    docstring: str = ""

    @property
    def key(self) -> ClassKey:
        return self.place, self.name


@dataclass(eq=False)
class Blueprint:
    """A node as one program makes it, before a launch file renames or remaps anything.

    ``name`` and ``namespace`` are the constructor's; ``class_name`` the class (or function, for
    ``create_node``).  With ``caller_unknown`` it is no node: what a class or function creates on a node that
    no caller in sight passes to it, and what a class with a base from elsewhere creates on itself while nothing
    shows that the base is a node.
    """

    class_name: str
    name: Text
    namespace: Text
    place: Place
    package: str | None
    lifecycle: bool = False
    caller_unknown: bool = False
    classes: tuple[NodeClass, ...] = ()
    """Its class and the bases of that which are of this workspace."""
    annotated: tuple[ClassKey, str] | None = None
    """What annotations say of a node that nothing here passes: its class, or the class of what holds it and the
    attribute there."""
    creations: list[Creation] = field(default_factory=list)
    parameters: list[ParameterDeclaration] = field(default_factory=list)
    callbacks: list[Callback] = field(default_factory=list)
    executables: tuple[str, ...] = ()
    scripts: tuple[str, ...] = ()
    """The files that start it and that no package installs."""
    executor: ExecutorKind = ExecutorKind.NONE
    test: bool = False
    """True where the node is defined in test code: never judged together with others."""
    complete: bool = True
    """False where something that may create entities could not be followed; ``gaps`` says what."""
    gaps: list[tuple[Place, str]] = field(default_factory=list)
    object_key: int | None = None
    """The object that it is, as :attr:`archlint.model.given.Object.key`; None where no class of the workspace makes
    it."""
    allow_undeclared_parameters: bool = False
    automatically_declare_parameters: bool = False
    constructed: bool = False
    """Whether ``Node.__init__`` is reached on it, here or in code that is not followed."""
    made_at: Place | None = None
    """The call that makes it, where one does."""
    branch_arms: BranchArms = frozenset()
    """The branches that make it, as ``Creation.branch_arms``."""
    ended_arms: BranchArms = frozenset()
    """Branches that end the function before it is made: it is never there beside what they make."""
    instead_of: Blueprint | None = None
    """The node of the same class and name that it took the place of in a variable."""
    has_own_executor: bool = False
    """True where an executor was given it, and not one of several nodes."""
    escapes: bool = False
    """True where code that is not in this workspace is given the node: that may spin it."""
    runs_elsewhere: bool = False
    """True where code of a base class that is not in this workspace runs on the node, or a thread of tf2's listener
    has it: these may spin it."""
    never_starting: Place | None = None
    """The thread that would spin it and is never started."""
    removed_at: Place | None = None
    """The call that takes it off its executor before that spins."""
    number: int = 0
    """How many nodes the program had made before this one."""
    until: int | None = None
    """How many it had made when this one was freed, as the function or block around it ended; None if it may stay."""
    made_by: Callback | None = None
    """What ran as it was made: ``main``, or a callback."""
    destroyed_at: int | None = None
    """How many nodes the program had made when ``destroy_node()`` ran on this one, whatever branch was taken, in what
    ``made_by`` is; None where it may live on."""
    gone: tuple[tuple[BranchArms, int], ...] = ()
    """Each ``destroy_node()`` on it, and each ``rclpy.spin()`` in an import, which returns once all nodes are shut
    down: the branches that run it, and how many nodes the program had made by then."""
    enable_rosout: bool = True
    start_parameter_services: bool = True
    use_global_arguments: bool = True
    """False where the command line of the process (names, remappings, parameters) does not reach the node: its
    constructor or ``rclpy.init(args=[])`` for its context says so."""
    cli_arguments: tuple[str, ...] = ()

    @property
    def just_rclpy(self) -> bool:
        """Whether it is just an rclpy node (:attr:`NodeClass.just_rclpy`); what ``Node(…)`` and ``create_node(…)`` make
        is."""
        return not self.caller_unknown and (not self.classes or self.classes[0].just_rclpy)

    @property
    def docstring(self) -> str:
        """What its class says of itself; empty where it has none, or no class of the workspace."""
        return self.classes[0].docstring if self.classes and self.classes[0].name == self.class_name else ""

    @property
    def made_again(self) -> bool:
        """Whether it is another node once more, that one being gone: ``while not node.ready: node = Driver()``."""
        first = self.instead_of
        return first is not None and not (self.has_own_executor and first.has_own_executor)
