"""The libraries that the code of a workspace imports: what a run asks of them, and what they watch."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Sequence
from contextlib import AbstractContextManager
from typing import TYPE_CHECKING

from archlint.interpreter.library import Library
from archlint.interpreter.values import ApiMethod, Builtin, External, ForeignValue, Instance, Known, Unknown, Value
from archlint.libraries import calls, classes, interest, own_attributes, refused_calls
from archlint.libraries.api_signatures import attributes_of
from archlint.libraries.module_names import module_behind
from archlint.libraries.offers import OFFERS
from archlint.libraries.python import command_line, environment, tasks
from archlint.libraries.rclpy import (
    attributes,
    changed_profiles,
    escapes,
    executors,
    field_values,
    interfaces,
    message_constants,
    message_uses,
    messages,
    mistaken_futures,
    names,
    node_classes,
    nodes,
    policies,
    refusals,
    short_lived,
)
from archlint.libraries.values import FutureValue, MessageValue
from archlint.model import Role

if TYPE_CHECKING:
    from archlint.branches import Branch
    from archlint.interpreter.activation import Activation
    from archlint.interpreter.call_site import CallSite
    from archlint.interpreter.modules import Module
    from archlint.interpreter.values import ClassValue
    from archlint.libraries.run import Run
    from archlint.syntax import facts


_SHARE = re.compile(r"\$\(find-pkg-share ([^()/]+)\)")


class RosLibrary(Library):
    """What Python's own library, rclpy and its kin are known to do in a run."""

    offers = OFFERS

    def __init__(self, run: Run) -> None:
        self.run = run

    # --------------------------------------------------------------------------------- functions and methods

    def call_function(self, function: External, site: CallSite) -> Value:
        return calls.call_external(self.run, self.offers, function, site)

    def call_method(self, method: ApiMethod, site: CallSite) -> Value:
        return calls.call_method(self.run, self.offers, method, site)

    def call_builtin(self, function: Builtin, site: CallSite) -> Value:
        return calls.call_builtin(self.run, self.offers, function.name, site)

    def note_refusal(self, method: ApiMethod, site: CallSite) -> None:
        calls.note_refusal(self.run, self.offers, method, site)

    def refuses(self, method: ApiMethod, given: int, keywords: Collection[str]) -> bool:
        return refusals.refuses(method, given, keywords)

    def is_made_plainly(self, cls: ClassValue) -> bool:
        return node_classes.has_only(cls)

    def awaited(self, value: ForeignValue, expression: facts.Await) -> Value:
        return calls.await_future(self.run, value, expression) if isinstance(value, FutureValue) else value

    def around_call(self, function: Value, expression: facts.Call) -> AbstractContextManager[None] | None:
        return tasks.as_own_task(self.run, expression, function)

    # ---------------------------------------------------------------------------------------- names, attributes

    def canonical(self, path: str) -> str:
        return names.canonical(path)

    def is_module(self, path: str) -> bool:
        return refusals.is_module(path)

    def imported(self, path: str, span: facts.Span) -> Value:
        interfaces.note_interface(self.run, path, span)
        return interfaces.missing_interface(self.run, path) or External(module_behind(path) or path)

    def header_missing(self, path: str, span: facts.Span) -> None:
        interfaces.note_header(self.run, path, span)

    def star_sources(self, packages: Sequence[str], name: str) -> Sequence[str]:
        return interfaces.star_sources(self.run, packages, name)

    def attribute_of_external(self, value: External, name: str) -> Value:
        path = f"{value.path}.{name}"
        if path == "sys.argv":
            return command_line.program_arguments(self.run)
        if (package := module_behind(path)) is not None:
            return External(package, value.via)
        constant = attributes.interface_constant(self.run, value.path, name)
        return constant or interfaces.missing_interface(self.run, path) or External(path, value.via)

    def attribute_of_value(self, value: ForeignValue, name: str) -> Value:
        return attributes.of_value(self.run, value, name)

    def attribute_of_object(self, value: Instance, cls: External, name: str) -> Value:
        return attributes.of_object(self.run, value, names.canonical(cls.path), name)

    def inherited(self, value: Value, base: External, name: str) -> Value:
        return attributes.inherited(self.run, value, names.canonical(base.path), name)

    def method_of_unknown(self, value: Value, name: str) -> Value | None:
        return attributes.of_unknown(value, name)

    def method_mixed_in(self, value: Instance, name: str) -> Value | None:
        return attributes.mixed_in(value, name)

    def lacks(self, method: ApiMethod) -> bool:
        owner, _, name = method.path.rpartition(".")
        return names.is_missing_method(method.path) and name not in (attributes_of(owner) or ())

    def has_attribute(self, value: ForeignValue, name: str) -> Value | None:
        return messages.has_field(self.run, value, name) if isinstance(value, MessageValue) else None

    def item_of_external(self, container: External, index: object) -> Value | None:
        return policies.policy_by_name(container.path, index)

    def environment(self, name: object) -> Known | None:
        return environment.variable(self.run, name)

    # --------------------------------------------------------------------------------------------- classes

    def class_of(self, value: ForeignValue) -> Value | None:
        return classes.class_of(value)

    def is_instance(self, value: ForeignValue, cls: Value, python: type | None) -> bool | None:
        return classes.is_instance(value, cls, python)

    def is_ordinary_class(self, path: str) -> bool:
        return classes.is_ordinary(path)

    # -------------------------------------------------------------------------------------- what is certain

    def matters(self, function: facts.Function | facts.Lambda) -> bool:
        return interest.interesting(function)

    def are_settled(self, parameters: frozenset[str]) -> bool:
        return self.run.context.role in (Role.MAIN, Role.INIT) and self.run.overrides.are_settled(parameters)

    # ----------------------------------------------------------------------------- events: objects and names

    def allocated(self, instance: Instance) -> None:
        nodes.adopt(self.run, instance)

    def rebound(self, value: Instance, before: object) -> None:
        nodes.note_replaced(self.run, value, before)

    def unbound(self, activation: Activation, name: str) -> None:
        short_lived.free(self.run, activation, name)

    def module_variable(self, module: Module, name: str, value: Value) -> None:
        escapes.named(self.run, module, name, value)

    def module_done(self, module: Module) -> None:
        escapes.share(self.run, module)

    def function_left(self, activation: Activation) -> None:
        for node, _ in self.run.nodes.short_lived.pop(activation, ()):
            node.until = len(self.run.nodes.by_key) if node.until is None else node.until

    def coroutines_started(self, function: Value, expression: facts.Call) -> None:
        tasks.note_started(self.run, expression, function)

    def read(self, value: Value, name: str, span: facts.Span) -> None:
        if isinstance(value, External):
            if value.path.endswith((".msg", ".srv", ".action")):
                interfaces.note_interface(self.run, f"{value.path}.{name}", span)
            message_constants.note_constant(self.run, value.path, name, span)
        else:
            message_uses.note_use(self.run, value, name, span, "read")
            mistaken_futures.note_read(self.run, value, name, span)

    def written(self, value: Value, name: str, span: facts.Span, content: Value) -> None:
        message_uses.note_use(self.run, value, name, span, "write")
        field_values.note_value(self.run, value, name, span, content)

    def put_into(self, container: facts.Attribute, method: str, site: CallSite) -> None:
        field_values.note_put(self.run, container, method, site)

    def undecided(self, branch: Branch, test: Value) -> None:
        self.run.note_open_test(branch, test)

    def folder_around(self, path: str) -> str | Unknown | None:
        share = _SHARE.fullmatch(path)
        return f"$(find-pkg-prefix {share[1]})/share" if share is not None else super().folder_around(path)

    def asked_for_file(self, path: str) -> Value:
        self.run.note_asked_file(path)
        return super().asked_for_file(path)

    # ----------------------------------------------------------------------- events: what escapes

    def escaped(self, values: Iterable[Value], reason: str, at: facts.Call | None = None) -> None:
        escapes.escape(self.run, values, reason, at)

    def note_uncallable(self, value: Value, site: CallSite) -> None:
        refused_calls.note_uncallable(self.run, value, site)

    def note_own_read(self, value: Value, name: str, span: facts.Span, result: Value) -> None:
        own_attributes.note_read(self.run, value, name, span, result)

    def given_away(self, site: CallSite) -> None:
        escapes.to_call(self.run, site.values, "", site.expression)

    def lost(self, result: Value, values: Iterable[Value], how: str) -> Value:
        return escapes.lost(self.run, result, values, how)

    def kept(self, key: int, values: Iterable[Value], name: str | None = None) -> None:
        escapes.kept(self.run, key, values, name)

    def assigned(self, target: Value, name: str, value: Value) -> None:
        escapes.assigned(self.run, target, name, value)
        mistaken_futures.note_set(self.run, target, name)
        if name == "executor":
            executors.set_executor(self.run, target, value)
        if isinstance(target, External):
            changed_profiles.change_preset(self.run, target, name, value)


__all__ = ["RosLibrary"]
