"""What comes from elsewhere: modules, names of packages that are not in this workspace, and what libraries make."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from dataclasses import field, replace
from typing import TYPE_CHECKING, ClassVar

from archlint.interpreter.values.base import NO_PARAMETERS, Value
from archlint.records import dataclass
from archlint.syntax.parts import Itself

if TYPE_CHECKING:
    from archlint.interpreter.modules import Module


@dataclass(frozen=True, slots=True)
class External(Value):
    """Something of a package that is not in this workspace, by its dotted name; ``via`` names the ROS parameters
    that chose it."""

    path: str
    via: frozenset[str] = field(default=NO_PARAMETERS, compare=False)

    @property
    def dotted(self) -> str:
        return self.path

    def chosen_by(self, parameters: frozenset[str]) -> External:
        return replace(self, via=self.via | parameters)

    def entry_key(self) -> Hashable:
        return self


@dataclass(frozen=True, slots=True, eq=False)
class ModuleValue(Value):
    """A module of the workspace."""

    module: Module

    @property
    def is_object(self) -> bool:
        return True


class ForeignValue(Value):
    """What only a library makes, in a form of its own; the library says what its attributes are."""

    __slots__ = ()

    is_hashable: ClassVar[bool] = False
    """Whether the machine follows it as the key of a dict."""
    may_be_none: ClassVar[bool] = False
    """Whether it may be ``None``, and is not the same as itself alone."""

    @property
    def has_identity(self) -> bool:
        return not self.may_be_none

    def identity(self, key_of: Callable[[Value], Hashable]) -> tuple[Hashable, ...] | None:
        """What sets it apart from others of its class, values in it by ``key_of``; None: its ``heap_key``."""
        return None

    def kind(self) -> Hashable | None:
        """What is the same whenever the code that makes it runs; None: no more than its class."""
        return None

    def entry_key(self) -> Hashable | None:
        return Itself(self) if self.is_hashable else None
