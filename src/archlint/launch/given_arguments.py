"""What is passed to includes, and who reads it after them: an include is not scoped.

Source: launch, ``IncludeLaunchDescription.execute`` sets each argument in the context of the including file, and
``DeclareLaunchArgument.execute`` sets the default of an argument only where it has no value there.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

from archlint.launch.mistakes import LeakedArgument
from archlint.launch.named_files import is_made_by_launch
from archlint.launch.objects import known_text

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.interpreter.values import Value
    from archlint.launch.model import Launched


class _Given(NamedTuple):
    value: Value
    place: Place
    file: str
    include: Place
    before: Value | None
    """What it was in front of all of these includes."""
    earlier: tuple[Place, ...]
    the_same: bool
    """Whether the earlier ones set it to this value, too."""


class _Default(NamedTuple):
    value: Value
    place: Place
    file: str
    includes: tuple[Place, ...]


class GivenArguments:
    """What includes have set last, by the name of the launch configuration, and which defaults files have set.

    Of a launch, ``read_on`` gets the places of what is read after includes, by those where the values are written;
    ``set_by_includes`` gets files, each with a configuration that only its includes give a value and that it reads
    after them: that is what they are for.  ``leaked`` gets what is another value then.  ``reach_later`` gets the places
    of values that a later include may read, because it declares the argument or because nobody knows what it reads.
    """

    def __init__(self, result: Launched) -> None:
        self._given: dict[str, _Given] = {}
        self._defaults: dict[str, _Default] = {}
        self._passed: list[frozenset[str]] = []
        """The names that the includes around what is visited pass on, outermost first."""
        self._literals: dict[str, tuple[Value, Place]] = {}
        self._late: set[tuple[Place, str]] = set()
        """Includes, each with an argument that a timer or an event of what it includes reads."""
        self._in_vain: dict[str, list[tuple[Value, LeakedArgument]]] = {}
        """The values that files which declare an argument themselves have instead of their own default, each with the
        leak that it is once something reads it."""
        self._result = result

    def note_literal(self, name: str, value: Value, place: Place) -> None:
        """An include writes down the value that it gives an argument, instead of a substitution."""
        self._literals[name] = value, place

    def written(self, name: str, value: Value | None) -> Place | None:
        """Where an include writes down the value that a configuration has; None where it comes from elsewhere."""
        literal, place = self._literals.get(name, (None, None))
        return place if literal is not None and literal is value else None

    def note(self, name: str, value: Value, place: Place, file: str, include: Place, before: Value | None) -> None:
        """An include in a file gives an argument a value; ``place`` is where that is written, ``before`` the value of
        the configuration in front of it."""
        last = self._given.get(name)
        earlier: tuple[Place, ...] = ()
        the_same = True
        if last is not None and last.value is before:
            before = last.before
            earlier = tuple(dict.fromkeys((*last.earlier, last.place))) if last.file == file else ()
            the_same = last.the_same and known_text(last.value) == known_text(value)
        self._given[name] = _Given(value, place, file, include, before, earlier, the_same)

    @contextmanager
    def passing(self, names: Collection[str]) -> Iterator[None]:
        """What is visited here is an include that passes arguments of these names."""
        self._passed.append(frozenset(names))
        try:
            yield
        finally:
            self._passed.pop()

    def note_read(self, name: str, value: Value | None, file: str, action: Place, *, late: bool, dormant: bool) -> None:
        """An action of a file reads a value, perhaps one that an include in front of it has set there; ``late`` if a
        timer or an event runs the action, ``dormant`` if nothing does with the arguments as they are."""
        for leaked_value, in_vain in [] if dormant else self._in_vain.get(name, ()):
            if leaked_value is value:
                self._tell(in_vain)
        given = self._given.get(name)
        if late and given is not None and given.value is value and given.file != file:
            self._late.add((given.include, name))
        if given is None or given.value is not value or given.file != file or given.include == action:
            return
        if given.before is None:
            self._result.set_by_includes.add((file, name))
            return
        self._result.read_on.setdefault(given.place, action)
        leak = self._leak(name, value, given.before, given.place, action, file, given.include, earlier=given.earlier)
        if leak is not None:
            self._tell(leak)

    def note_unread_include(self, configurations: Mapping[str, Value]) -> None:
        """An include is visited whose file is not here: it may read everything that is set now."""
        for name, given in self._given.items():
            if configurations.get(name) is given.value:
                self._result.reach_later.add(given.place)

    def note_default(self, name: str, value: Value, place: Place, file: str, includes: Sequence[Place]) -> None:
        """A file sets the default of an argument; ``includes`` lead to it."""
        self._defaults[name] = _Default(value, place, file, tuple(includes))

    def note_no_default(
        self, name: str, value: Value, own: Value, place: Place, file: str, includes: Sequence[Place]
    ) -> None:
        """A file declares an argument that has a value, so that its ``own`` default counts for nothing: the value may
        be left over from another include, while none of those around the file passes the argument."""
        if any(name in names for names in self._passed):
            return
        given, other = self._given.get(name), self._defaults.get(name)
        if given is not None and given.value is value and given.include not in includes:
            self._result.reach_later.add(given.place)
            leak = self._leak(name, value, own, given.place, place, file, given.include, earlier=given.earlier)
            if leak is not None and given.the_same and leak.earlier:
                leak = replace(leak, the_same=True)
            self._note_in_vain(value, leak)
        elif other is not None and other.value is value and other.file != file:
            beside = [include for include in other.includes if include not in includes]
            if beside:
                leak = self._leak(name, value, own, other.place, place, file, beside[0], default=True)
                self._note_in_vain(value, leak)

    def _leak(
        self,
        name: str,
        value: Value,
        own: Value | None,
        given: Place,
        read: Place,
        file: str,
        include: Place,
        *,
        default: bool = False,
        earlier: tuple[Place, ...] = (),
    ) -> LeakedArgument | None:
        text, own_text = known_text(value), known_text(own)
        if text is None or own_text is None or is_made_by_launch(text):
            # A file that a launch makes, of another mostly: it may well have what the other has.
            return None
        if text.lower() == own_text.lower():
            return None
        late, others = (include, name) in self._late, tuple(place for place in earlier if place != given)
        return LeakedArgument(name, text, own_text, given, read, file, include, default, late, others)

    def _note_in_vain(self, value: Value, leak: LeakedArgument | None) -> None:
        """A leak that matters once something reads the value."""
        if leak is not None:
            self._in_vain.setdefault(leak.name, []).append((value, leak))

    def _tell(self, leak: LeakedArgument) -> None:
        if leak not in self._result.leaked:
            self._result.leaked.append(leak)
