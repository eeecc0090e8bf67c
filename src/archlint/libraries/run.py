"""The run of one program: an abstract interpretation, and what it has found of ROS."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

from archlint import model
from archlint.finding import Place
from archlint.interpreter.interpreter import Interpreter
from archlint.interpreter.machine import Phase
from archlint.libraries.state import Callbacks, Calls, Escapes, Messages, Nodes

if TYPE_CHECKING:
    from archlint.branches import Branch
    from archlint.interpreter.heap import Store
    from archlint.interpreter.library import Library
    from archlint.interpreter.modules import Module, ModuleIndex
    from archlint.interpreter.values import Value
    from archlint.ros.interfaces import InterfaceTable


class Run(Interpreter):
    """The state of the run of one program.  ``library`` makes what knows the libraries that it imports."""

    def __init__(
        self,
        library: Callable[[Run], Library],
        index: ModuleIndex,
        store: Store,
        program: model.Program,
        context: model.Callback,
        interfaces: InterfaceTable | None = None,
        overrides: model.Overrides | None = None,
    ) -> None:
        super().__init__(index, store)
        self.library = library(self)
        self.program = program
        self.refused = program.refused
        self.context = context
        self.interfaces = interfaces
        self.overrides = model.Asked(overrides or model.Overrides())
        self.first_module: Module | None = None
        """The module that the program begins with."""
        self.distro: str | None = None
        """The distribution that the workspace is for, where that was said."""
        self.argv: Value | None = None
        """The list ``sys.argv``, where the command line is known."""
        self.nodes = Nodes()
        self.noted = Calls()
        self.callbacks = Callbacks()
        self.messages = Messages()
        self.escapes = Escapes()
        self.at_spin: Callable[[Run], None] | None = None
        """Runs what is pending when main spins: callbacks see the state of then, not what main does at the end."""
        self.after_moment: Callable[[Run], None] | None = None
        """Says after a spin that ends what callbacks may have left in attributes meanwhile."""

    @property
    def phase(self) -> Phase:
        return _PHASES.get(self.context.role, Phase.LATER)

    def give_up(self) -> None:
        self.program.exhausted = True

    @contextmanager
    def importing(self, module: Module) -> Iterator[None]:
        kept = self.context
        self.context = model.Callback(model.Role.MODULE, module.name, Place(module.path, 1, 1, 1, 1), None)
        try:
            yield
        finally:
            self.context = kept

    def note_open_test(self, branch: Branch, test: Value) -> None:
        """Nothing decides the test of a branch; a launch notes why."""

    def note_asked_file(self, path: str) -> None:
        """The code asks whether a file exists; a launch notes which."""

    def chain(self) -> tuple[model.Frame, ...]:
        """The calls that lead from the start of this root to what runs now."""
        frames = []
        for caller, callee in zip(self.activations, self.activations[1:], strict=False):
            if callee.call_place is not None:
                frames.append(model.Frame(caller.qualified, callee.qualified, callee.call_place))
        return tuple(frames)


_PHASES = {model.Role.MODULE: Phase.IMPORT, model.Role.INIT: Phase.START, model.Role.MAIN: Phase.START}
"""By the role of what runs."""

__all__ = ["Run"]
