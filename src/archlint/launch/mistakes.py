"""What a launch file says that launch refuses, ignores or cannot know."""

from __future__ import annotations

from archlint.finding import Place
from archlint.records import dataclass


@dataclass(frozen=True)
class UndeclaredUse:
    """A launch configuration that is read and that nothing has declared or set.

    It stands at ``place``, and the action for which it is performed is at ``read_at``.  ``own_default`` is the
    declaration whose default value reads the argument that it declares; ``unseen`` is an include in front of the read
    whose file is not there: nobody can say what that one would have declared.  What is read ``later`` is of an action
    that a timer or an event starts: all of the file has been visited by then.
    """

    name: str
    place: Place
    read_at: Place
    file: str
    conditional: bool = False
    own_default: Place | None = None
    unseen: Place | None = None
    later: bool = False


@dataclass(frozen=True)
class LeakedArgument:
    """A launch configuration that has another value behind an include than in front of it, at a place that reads it.

    ``given`` is where the ``include`` sets it to ``value``, ``own`` what it would be at ``read`` otherwise, in a file.
    One of a ``default`` is a file's own argument, which another file in the include has declared with another default.
    A value is ``read_late`` if a timer or an event of what is included reads it, too.  ``earlier`` are the places at
    which includes in front of this one have set it, so that it would be one of their values without this one; it is
    ``the_same`` if all of these have set it to this value.
    """

    name: str
    value: str
    own: str
    given: Place
    read: Place
    file: str
    include: Place
    default: bool = False
    read_late: bool = False
    earlier: tuple[Place, ...] = ()
    the_same: bool = False

    @property
    def is_declared_in_vain(self) -> bool:
        """Whether ``read`` is where another included file declares the argument."""
        return self.default or self.file != self.include.file


@dataclass(frozen=True)
class UnknownAttribute:
    """A keyword or attribute that an action does not have; ``known`` are those that it does."""

    action: str
    name: str
    known: tuple[str, ...]
    place: Place
    of_element: bool = False
    """Whether the action is an element of XML or YAML."""
    nested: bool = False
    """Whether it is an element inside of that one, instead of an attribute."""
    given: frozenset[str] = frozenset()
    """What a call in Python gives by name."""


@dataclass(frozen=True)
class NotACondition:
    """What an action is given as its ``condition=`` that launch cannot ask: ``what`` names it."""

    action: str
    what: str
    callable: bool
    place: Place


@dataclass(frozen=True)
class RefusedExpression:
    """A text that a ``PythonExpression`` or ``$(eval …)`` hands to Python, which knows no ``name`` in it."""

    text: str
    name: str
    place: Place


@dataclass(frozen=True)
class WithoutContext:
    """A ``perform()`` that fails: a ``substitution`` is ``given`` what is no launch context, or (empty) a new one, in
    which no launch argument has a value."""

    substitution: str
    given: str
    place: Place


@dataclass(frozen=True)
class AbsentKey:
    """A ``key`` that code takes out of what a file holds, where there is none; ``known`` are those that are there."""

    key: str
    known: tuple[str, ...]
    file: str
    place: Place


@dataclass(frozen=True)
class NotAPath:
    """A ``substitution`` (or, empty, a tuple) that ``os.path.join()`` is given; ``package`` is the one whose folder it
    stands for."""

    substitution: str
    package: str | None
    place: Place


@dataclass(frozen=True)
class JoinedFolder:
    """Two parts of the search path ``variable``, one right behind the other; ``separator`` belongs between them."""

    variable: str
    before: str
    after: str
    separator: str
    place: Place


@dataclass(frozen=True)
class RefusedValue:
    """A value that launch takes for no text: ``what`` says which, and ``parameter`` of which action it is for.

    It is a word ``in_list``, the value of a launch ``argument`` that an include is given, or what stands for the
    ``pairs`` of all of these; or else what a node is given ``as_parameter``, and launch_ros makes no parameter of.
    """

    action: str
    parameter: str
    what: str
    place: Place
    in_list: bool = False
    argument: bool = False
    pairs: bool = False
    as_parameter: bool = False


@dataclass(frozen=True)
class NoAction:
    """An object of a class of launch that stands ``among`` actions and is none, or that is an action and the
    predicate of a condition; ``name`` is the launch argument that it reads or declares."""

    class_name: str
    among: bool
    name: str
    place: Place


@dataclass(frozen=True)
class MissingArguments:
    """A call, or an element of XML or YAML, that makes an action without the arguments ``names``, which it needs."""

    action: str
    names: tuple[str, ...]
    place: Place
    of_element: bool = False


@dataclass(frozen=True)
class NotAChoice:
    """A ``value`` of a launch ``argument`` that is none of the ``choices`` of its declaration: the ``default`` there,
    or what an include passes at ``place``."""

    argument: str
    value: str
    choices: tuple[str, ...]
    place: Place
    declared: Place
    default: bool = False


@dataclass(frozen=True)
class IdleGroup:
    """A scoped group that makes ``settings`` and has nothing in it that they are for; ``place`` is the group's."""

    settings: tuple[str, ...]
    place: Place
