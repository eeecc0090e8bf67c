"""Calls of what libraries offer: which row or function answers."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.interpreter.values import ApiMethod, External, Instance, Known, OneOf, Unknown, Value, one_of
from archlint.libraries import absent_names, refused_calls, watched_calls
from archlint.libraries.api_use import ApiUse, Offers, bind_api
from archlint.libraries.rclpy import (
    escapes,
    executors,
    made_messages,
    made_nodes,
    names,
)
from archlint.libraries.rclpy.effects import answer
from archlint.libraries.tables import Api
from archlint.libraries.tables.noted import NOTED
from archlint.libraries.values import FutureValue
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.libraries.run import Run


def call_external(run: Run, offers: Offers, function: External, site: CallSite) -> Value:
    """Call a foreign function or class by its dotted name."""
    path = names.canonical(function.path)
    interface, section_name = names.interface_and_section(path)
    if interface is not None:
        return made_messages.make(run, interface, section_name, site.keywords, site.expression)
    api = offers.row(path)
    if api is not None:
        receiver = None
        if _is_method(path) and site.args and api.node is None and api.effect != "qos_preset":
            receiver, site = site.args[0], replace(site, args=site.args[1:])  # Node.__init__(self, …) and the like
        return use(run, offers, api, receiver, site)
    noted = NOTED.get(path)
    if noted is not None and site.expression is not None:
        bound, _ = bind_api(noted, site.args, site.keywords)
        refused_calls.note(run, noted, None, site, bound)
        watched_calls.note(run, noted, None, bound, site.expression)
    plain = offers.plain.get(path)
    if plain is not None:
        return plain(run, site)
    absent_names.note_function(run, path, site)
    if not escapes.is_own(path):
        escapes.to_call(run, site.values, path, site.expression)
    name = path.rpartition(".")[2]
    if name[:1].isupper() or path in ("dataclasses.field",):
        place = run.place(site.expression.span) if site.expression is not None and run.activations else None
        arguments = {str(i): value for i, value in enumerate(site.args)} | site.keywords
        return Instance(External(path), run.store.new_key(), place, arguments, path)
    return Unknown(f"{path}() is outside of this workspace")


def _is_method(path: str) -> bool:
    owner = path.rpartition(".")[0].rpartition(".")[2]
    return owner[:1].isupper()


def call_method(run: Run, offers: Offers, function: ApiMethod, site: CallSite) -> Value:
    """Call a method of a foreign class, or one that a class of ours inherits from it."""
    path = function.path
    receiver = function.self_value
    api = offers.row(path)
    if api is None and path.endswith(".__init__") and isinstance(receiver, Instance):
        api = offers.row(path.removesuffix(".__init__"))
        if api is not None and api.effect == "executor":
            return executors.adopt_executor(run, api, receiver, site)
        if api is not None and api.effect in offers.bases:
            # A class of ours derived from, say, ActionServer.
            return use(run, offers, api, receiver, site)
        made_nodes.name_by_foreign_base(run, receiver, path)
        escapes.to_call(run, site.values, path, site.expression)
        return Unknown(f"{path} is outside of this workspace")
    if api is not None:
        return use(run, offers, api, receiver, site)
    method = offers.methods.get(path)
    if method is not None:
        return method(run, receiver, site)
    absent_names.note_method(run, path, receiver, site)
    made_nodes.note_foreign_method(run, receiver, path)
    if not escapes.is_own(path) or names.is_missing_method(path):
        escapes.to_call(run, site.values, path.removeprefix("?."), site.expression)
    return Unknown(f"{path.removeprefix('?.')}() is outside of this workspace")


def call_builtin(run: Run, offers: Offers, name: str, site: CallSite) -> Value:
    """``input()`` waits for a user; of ``open()`` only those who read files know what it gives."""
    api = offers.row(f"builtins.{name}")
    if api is not None and site.expression is not None:
        watched_calls.note(run, api, None, {}, site.expression)
    if name == "input":
        return Unknown("keyboard input", of_class="str")
    plain = offers.plain.get(name)
    if plain is None:
        return Unknown(f"the result of {name}()")
    return plain(run, site)


def use(run: Run, offers: Offers, api: Api, receiver: Value | None, site: CallSite) -> Value:
    if isinstance(receiver, OneOf):
        options = [option for option in receiver.values if not isinstance(option, Known)]
        if len(options) > 1:
            return one_of(use(run, offers, api, o, site) for o in options)
        receiver = options[0] if options else receiver
    bound, rest = bind_api(api, site.args, site.keywords)
    refused_calls.note(run, api, receiver, site, bound)
    call = ApiUse(api, receiver, bound, site.expression, site.open, rest, site.keywords)
    if api.watched and site.expression is not None:
        watched_calls.note(run, api, receiver, bound, site.expression)
    return offers.effects[api.effect](run, call)


def note_refusal(run: Run, offers: Offers, method: ApiMethod, site: CallSite) -> None:
    """A callback ends at a call of a method whose arguments do not fit."""
    api = offers.row(method.path)
    if api is not None:
        bound, _ = bind_api(api, site.args, site.keywords)
        refused_calls.note(run, api, method.self_value, site, bound)


def await_future(run: Run, future: FutureValue, expression: facts.Await) -> Value:
    """``await future``: the answer; noted as a wait."""
    api = Api(f"{future.api}.await", watched=True)
    place_call = facts.Call(expression.value, [], expression.span)
    watched_calls.note(run, api, future, {}, place_call)
    return answer(run, future)


__all__ = ["await_future", "call_builtin", "call_external", "call_method", "note_refusal"]
