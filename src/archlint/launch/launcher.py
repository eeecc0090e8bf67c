"""The run of a launch file with all of its rooms: actions, substitutions, conditions and the languages of files."""

from __future__ import annotations

import posixpath
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.finding import Place
from archlint.interpreter.values import FunctionValue, Instance, Known, ListValue, OneOf, reason
from archlint.launch import conditions
from archlint.launch.actions import visiting
from archlint.launch.file_library import LaunchFileLibrary
from archlint.launch.files import GENERATE
from archlint.launch.frontends.elements import actions_of
from archlint.launch.kinds import FileKind, FileStatus, GapKind
from archlint.launch.named_files import why_unknown
from archlint.launch.run import LaunchRun
from archlint.launch.substitutions import performing
from archlint.launch.undefined import undefined_name
from archlint.syntax import facts as code_facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.interpreter.values import Value
    from archlint.launch.model import Launched
    from archlint.launch.named_files import FileReference
    from archlint.launch.run import Surroundings
    from archlint.launch.verdict import Verdict

INCLUDE_DEPTH = 24
INCLUDES = 400
"""How many includes one launch file may come to."""


class Launcher(LaunchRun):
    """A launch run that can run."""

    def __init__(self, surroundings: Surroundings, file: str, result: Launched) -> None:
        super().__init__(lambda _: LaunchFileLibrary(self), surroundings, file, result)

    def perform(self, value: Value | None) -> Value:
        return performing.perform(self, value)

    def judge(self, condition: Value | None) -> Verdict:
        return conditions.judge(self, condition)

    def visit(self, entity: Value) -> None:
        visiting.visit(self, entity)

    def include(self, reference: FileReference, plain: bool = False, called_at: Place | None = None) -> None:
        self.included += 1
        if reference.source is None:
            if reference.status == FileStatus.UNKNOWN:
                self.gap(why_unknown(reference), GapKind.INCLUDE, reference.place)
            return
        if reference.source in self.stack:
            self.gap(f"{reference.source} includes itself")
            circle = self.stack[self.stack.index(reference.source) :]
            if plain and not self.is_conditional and reference.source == min(circle):  # each circle once
                place = reference.place
                words = "this include never ends" if reference.source == place.file else "these includes never end"
                self.files.note_endless(place, f"{words}: {reference.source} is included again")
            return
        if len(self.stack) >= INCLUDE_DEPTH or self.included > INCLUDES:
            self.gap("more includes than can be followed")
            return
        self.includes.append(called_at or reference.place)
        self.enter(reference.source)
        self.includes.pop()

    def enter(self, path: str) -> None:
        """Run a launch file."""
        kept, kept_place = self.file, self.place_now
        self.file = path
        self.place_now = Place(path, 1, 1, 1, 1)
        self.stack.append(path)
        try:
            if self.files.is_frontend(path):
                self._enter_frontend(path)
            else:
                self._enter_python(path)
        except Exception as error:
            self.note_fault("following this launch file", error, Place(path, 1, 1, 1, 1))
        finally:
            self.stack.pop()
            self.file, self.place_now = kept, kept_place
            if not self.stack:
                self._settle_defaults()

    def _settle_defaults(self) -> None:
        """The files in defaults of arguments that need not be there: code that gets the argument asks if its file is,
        and ends in no exception if not."""
        for at, reference in enumerate(self.result.references):
            asked = posixpath.normpath(reference.written or "") in self.asked_files
            if asked and reference.kind == FileKind.ARGUMENT and not self._raises(reference.place.file):
                self.result.references[at] = replace(reference, optional=True)

    def _raises(self, path: str) -> bool:
        code = self.files.python(path) if path.endswith(".py") else None
        return code is not None and any(everything_in(code.body, code_facts.Raise))

    def _enter_frontend(self, path: str) -> None:
        facts = self.files.frontend(path)
        if facts.ros1:
            self.result.ros1 = self.result.ros1 or len(self.stack) == 1
            if len(self.stack) > 1:
                self.gap(f"{path} is a launch file of ROS 1")
        elif facts.root is not None:
            for action in actions_of(self, path, facts.root):
                self.visit(action)
        else:
            why = facts.problems[0].message if facts.problems else "it is not a launch file"
            self.gap(f"{path} cannot be read: {why}")

    def _enter_python(self, path: str) -> None:
        file = self.files.source_file(path)
        module = None if file is None else self.index.module(file)
        if module is None:
            self.gap(f"{path} cannot be read")
            return
        lost = None if (facts := self.files.python(path)) is None else undefined_name(facts, GENERATE)
        if lost is not None:
            self.result.undefined[Place(path, *lost.span)] = lost.id
            self.gap(f"{path} fails at '{lost.id}', which is not defined")
        with self.root(module):
            self.import_module(module)
            assert module.scope is not None
            self.activations[0].scope = module.scope
            function = self.module_attribute(module, GENERATE)
            if not isinstance(function, FunctionValue):
                self.result.is_launch_file = self.result.is_launch_file and len(self.stack) > 1
                self.gap(f"{path} has no {GENERATE}()")
                return
            description = self.call(function)
        if not isinstance(description, (Instance, ListValue, OneOf)):
            why = "it returns nothing" if isinstance(description, Known) else reason(description)
            self.gap(f"{GENERATE}() of {path} returns an unknown launch description: {why}")
        self.visit(description)
