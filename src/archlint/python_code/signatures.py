"""What callbacks can be called with."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.source_code import FunctionFacts, source_code
from archlint.records import dataclass
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.model import Callback
    from archlint.systems.model import System

_LEAVE_ALONE = frozenset({"staticmethod", "classmethod"})
"""Decorators that leave the parameters as they are."""


@dataclass(frozen=True)
class Signature:
    """The parameters of a callback, of which some are bound already: ``self``, what a ``partial`` gives."""

    params: tuple[facts.Param, ...]
    bound: int
    """How many leading positional ones are bound."""
    given: frozenset[str]
    """Those that are given by name."""

    @property
    def open_count(self) -> int:
        """How many parameters are left, of whatever kind."""
        return len(self.params) - self.bound

    @property
    def lacks_self(self) -> bool:
        """Whether it does not even take what is bound."""
        return len(self._positional) < self.bound

    @property
    def names(self) -> list[str]:
        """The positional parameters that are left."""
        return [param.name for param in self._positional[self.bound :] if param.name not in self.given]

    @property
    def needed_by_name(self) -> list[str]:
        """The parameters that must be given by name: rclpy gives none so."""
        return [
            param.name
            for param in self.params
            if param.kind == "keyword_only" and param.default is None and param.name not in self.given
        ]

    @property
    def wants_timer_info(self) -> bool:
        """Whether a parameter is annotated with ``TimerInfo``."""
        annotations = (param.annotation for param in self.params if param.annotation is not None)
        return any(annotation.last_name == "TimerInfo" for annotation in annotations)

    def takes(self, count: int) -> bool:
        """Whether it can be called with so many arguments besides those that are bound."""
        wanted = [param for param in self._positional if param.name not in self.given]
        needed, passed = sum(param.default is None for param in wanted), self.bound + count
        endless = any(param.kind == "star" for param in self.params)
        return not self.needed_by_name and needed <= passed and (endless or passed <= len(wanted))

    @property
    def _positional(self) -> list[facts.Param]:
        return [param for param in self.params if param.kind in ("positional_only", "normal")]


def signature_of(system: System, callback: Callback) -> Signature | None:
    """The signature of a callback; None where it is not seen, or a decorator may change it."""
    function = source_code(system).function(callback)
    if function is None or not _is_plain(function):
        return None
    return Signature(tuple(function.params), callback.bound_arguments, callback.bound_keywords)


def _is_plain(function: FunctionFacts) -> bool:
    decorators = function.decorators if isinstance(function, facts.Function) else []
    return all(decorator.variable in _LEAVE_ALONE for decorator in decorators)


def annotations_are_texts(system: System, callback: Callback) -> bool:
    """Whether a callback is in a file with ``from __future__ import annotations``."""
    file_facts = None if system.workspace is None else system.workspace.facts_at(callback.place.file)
    return file_facts is not None and hints_are_postponed(file_facts)


def hints_are_postponed(code: facts.Facts) -> bool:
    """Whether a file says so: ``from __future__ import annotations``."""
    imports = (statement for statement in code.body if isinstance(statement, facts.ImportFrom))
    return any(each.module == "__future__" and ("annotations", "annotations") in each.names for each in imports)


__all__ = ["Signature", "annotations_are_texts", "hints_are_postponed", "signature_of"]
