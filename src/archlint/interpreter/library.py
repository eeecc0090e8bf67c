"""What a machine asks of the world outside of the interpreted code.

:class:`Library` knows nothing: what is foreign stays unknown, and nobody watches.  Those who know the libraries that
the code imports derive from it.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import AbstractContextManager
from typing import TYPE_CHECKING

from archlint.interpreter.values import ApiMethod, External, ForeignValue, Instance, Unknown, Value

if TYPE_CHECKING:
    from collections.abc import Collection, Iterable

    from archlint.branches import Branch
    from archlint.interpreter.activation import Activation
    from archlint.interpreter.call_site import CallSite
    from archlint.interpreter.modules import Module
    from archlint.interpreter.values import Builtin, ClassValue, DictValue, Known
    from archlint.syntax import facts

INSTALL_FOLDER = "where the workspace is installed"


class Library:
    """The answers where nothing is known of any library, and the events where nobody watches."""

    # --------------------------------------------------------------------------------- functions and methods

    def call_function(self, function: External, site: CallSite) -> Value:
        """Call a foreign function or class."""
        return Unknown(f"{function.path}() is outside of this workspace")

    def call_method(self, method: ApiMethod, site: CallSite) -> Value:
        """Call a method of a foreign class, or one that a class of ours inherits from it."""
        return Unknown(f"{method.path}() is outside of this workspace")

    def call_builtin(self, function: Builtin, site: CallSite) -> Value:
        """Call a function of Python's own that asks for something outside of the program: ``open``, ``input``."""
        return Unknown(f"the result of {function.name}()")

    def note_refusal(self, method: ApiMethod, site: CallSite) -> None:
        """Python refuses a call of a method, with which a callback ends."""

    def refuses(self, method: ApiMethod, given: int, keywords: Collection[str]) -> bool:
        """Whether a foreign method certainly raises a TypeError for so many positional arguments and these keywords."""
        return False

    def note_uncallable(self, value: Value, site: CallSite) -> None:
        """What is called is no function, no class, and no object of a class of ours that can be called."""

    def note_key(self, container: DictValue, key: Known, expression: facts.Subscript) -> None:
        """Code takes something out of a dict, under a key that is known."""

    def note_item(self, container: str, key: Value, value: Value, target: facts.Subscript) -> None:
        """Code sets an item of a foreign object, by its dotted name: ``os.environ['X'] = …``."""

    def note_own_read(self, value: Value, name: str, span: facts.Span, result: Value) -> None:
        """Code reads an attribute of what is an object of a class of ours, or one of several such objects."""

    def is_made_plainly(self, cls: ClassValue) -> bool:
        """Whether no foreign base of a class changes how its objects are made."""
        return False

    def awaited(self, value: ForeignValue, expression: facts.Await) -> Value:
        """``await value``."""
        return value

    def around_call(self, function: Value, expression: facts.Call) -> AbstractContextManager[None] | None:
        """What holds while a call expression is followed, its arguments being known; None for nothing."""
        return None

    # ---------------------------------------------------------------------------------------- names, attributes

    def canonical(self, path: str) -> str:
        """The dotted name that a foreign class or function has where it is defined."""
        return path

    def is_module(self, path: str) -> bool:
        """Whether a dotted name is that of a foreign module rather than of something in one."""
        return False

    def speaks_for(self, path: str) -> bool:
        """Whether the library says what ``from package import name`` gives, even where the package is here."""
        return False

    def imported(self, path: str, span: facts.Span) -> Value:
        """What ``from package import name`` gives, for a package that is not here."""
        return External(path)

    def header_missing(self, path: str, span: facts.Span) -> None:
        """A file of C++ includes a header that is not here."""

    def star_sources(self, packages: Sequence[str], name: str) -> Sequence[str]:
        """Those of some foreign packages whose star import may bring a name."""
        return packages

    def attribute_of_external(self, value: External, name: str) -> Value:
        """``value.name`` of a foreign module, class or function."""
        return External(f"{value.path}.{name}", value.via)

    def attribute_of_value(self, value: ForeignValue, name: str) -> Value:
        """``value.name`` of what only a library makes."""
        return Unknown(f"the attribute '{name}' of a value that is not followed")

    def attribute_of_object(self, value: Instance, cls: External, name: str) -> Value:
        """``value.name`` of an object of a foreign class, where nothing was assigned to it."""
        return ApiMethod(f"{cls.path}.{name}", value)

    def inherited(self, value: Value, base: External, name: str) -> Value:
        """``value.name``, which an object of a class of ours has from a foreign base."""
        return ApiMethod(f"{base.path}.{name}", value)

    def method_of_unknown(self, value: Value, name: str) -> Value | None:
        """A method that only one class of the library has: ``value``, of which nothing is known, is of that class."""
        return None

    def method_mixed_in(self, value: Instance, name: str) -> Value | None:
        """The same for an object of a class of ours that has no such attribute: another class mixes it in."""
        return None

    def lacks(self, method: ApiMethod) -> bool:
        """Whether the foreign class of a method certainly has no attribute of this name."""
        return False

    def has_attribute(self, value: ForeignValue, name: str) -> Value | None:
        """``hasattr(value, name)``; None where nothing is known of that."""
        return None

    def item_of_external(self, container: External, index: object) -> Value | None:
        """``container[index]``: of an enum, by name; None where it is no container."""
        return None

    def environment(self, name: object) -> Value | None:
        """What a variable of the environment is in any process; None where that is not known."""
        return None

    # --------------------------------------------------------------------------------------------- classes

    def class_of(self, value: ForeignValue) -> Value | None:
        """``type(value)``."""
        return None

    def is_instance(self, value: ForeignValue, cls: Value, python: type | None) -> bool | None:
        """Whether a value is of a class (``python``: that class, where it is one of Python's own)."""
        return None

    def is_subclass(self, path: str, cls: Value) -> bool | None:
        """Whether a foreign class is the class ``cls`` or derives from it."""
        return None

    def is_ordinary_class(self, path: str) -> bool:
        """Whether a foreign class is one that no constant or collection is ever an object of."""
        return False

    # -------------------------------------------------------------------------------------- what is certain

    def matters(self, function: facts.Function | facts.Lambda) -> bool:
        """Whether it can change the result to run a function once more."""
        return True

    def are_settled(self, parameters: frozenset[str]) -> bool:
        """Whether the values of these parameters are certain while what runs now does."""
        return False

    # ----------------------------------------------------------------------------- events: objects and names

    def allocated(self, instance: Instance) -> None:
        """An object of a class of ours is made; its constructor has not run."""

    def constructing(self, instance: Instance, cls: ClassValue, site: CallSite) -> None:
        """The constructor of an object is about to run."""

    def rebound(self, value: Instance, before: object) -> None:
        """A variable gets an object; ``before`` is what it held."""

    def unbound(self, activation: Activation, name: str) -> None:
        """A variable of a running function is deleted, or the block of C++ that declares it ends."""

    def module_variable(self, module: Module, name: str, value: Value) -> None:
        """A variable of a module is set."""

    def module_done(self, module: Module) -> None:
        """The top level of a module has run."""

    def function_left(self, activation: Activation) -> None:
        """A function has ended, and its variables with it."""

    def coroutines_started(self, function: Value, expression: facts.Call) -> None:
        """A call expression begins, its arguments not being evaluated yet."""

    def read(self, value: Value, name: str, span: facts.Span) -> None:
        """The code reads ``value.name``."""

    def written(self, value: Value, name: str, span: facts.Span, content: Value) -> None:
        """The code writes ``value.name = content``."""

    def put_into(self, container: facts.Attribute, method: str, site: CallSite) -> None:
        """The code calls a method by the name of one that puts something into a container, of what an attribute has."""

    def undecided(self, branch: Branch, test: Value) -> None:
        """Nothing decides the test of a branch."""

    def asked_for_file(self, path: str) -> Value:
        """Whether a file or folder exists, of which the code asks that."""
        return Unknown("whether a file exists")

    def folder_around(self, path: str) -> str | Unknown | None:
        """The folder around one of those that stand for a place, such as ``$(workspace)``; None for any other path."""
        return Unknown(INSTALL_FOLDER) if path.startswith("$(") and "/" not in path else None

    def expects_to_read(self) -> bool:
        """Whether a ``try`` of which everything is known ends without an exception, so that no handler runs."""
        return False

    def matches(self, folder: str, pattern: str) -> list[str] | None:
        """The paths of the files in a folder whose names match; None where that is not known."""
        return None

    def opened(self, path: Known) -> Value:
        """The file that ``path.open()`` of a pathlib.Path gives."""
        return Unknown("a file")

    # ----------------------------------------------------------------------- events: what escapes

    def escaped(self, values: Iterable[Value], reason: str, at: facts.Call | None = None) -> None:
        """Values are passed to code that is not followed: ``at`` a call, else where the run is."""

    def given_away(self, site: CallSite) -> None:
        """The arguments of a call escape: nothing is known of what is called."""

    def lost(self, result: Value, values: Iterable[Value], how: str) -> Value:
        """``result``; where it is unknown, what it was made from escapes."""
        return result

    def kept(self, key: int, values: Iterable[Value], name: str | None = None) -> None:
        """Something is put into a container or an object (as its attribute ``name``) that is followed."""

    def assigned(self, target: Value, name: str, value: Value) -> None:
        """``target.name = value``, where the target may be anything."""


__all__ = ["Library"]
