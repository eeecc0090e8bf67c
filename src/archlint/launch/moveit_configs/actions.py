"""The actions that ``moveit_configs_utils.launch_utils`` makes, and what more a launch description needs.

Source: ``launch_utils.py`` of moveit_configs_utils of MoveIt 2 (branches jazzy and main).
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from archlint.interpreter import containers
from archlint.interpreter.values import NONE, Instance, Items, Known, Unknown, Value
from archlint.launch import calls
from archlint.launch.moveit_configs.builder import arguments
from archlint.launch.objects import ENTITIES, LaunchObject, launch_object
from archlint.launch.tables import LaunchClass

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.launch.run import LaunchRun

_MODULE = "moveit_configs_utils.launch_utils"
_OF_HELPER = ("ld", "package", "executable", "condition_name", "commands_file", "extra_debug_args")
"""The parameters of ``add_debuggable_node()``; what else it is given is for the nodes."""


class Actions:
    """Actions that are made one after the other: all of them stand where the launch file calls for them."""

    def __init__(self, run: LaunchRun, site: CallSite) -> None:
        self.run = run
        self.place = run.place(site.expression.span) if site.expression is not None and run.activations else None
        self.actions: list[Value] = []

    def description(self) -> LaunchObject:
        """A launch description of them."""
        whole = self.object(LaunchClass.LAUNCH_DESCRIPTION, {})
        self.run.store.set(whole.key, ENTITIES, Items(tuple(self.actions)))
        return whole

    def object(self, kind: LaunchClass, given: dict[str, Value]) -> LaunchObject:
        arms = frozenset(self.run.branch_arms)
        return launch_object(self.run.store.new_key(), kind, self.place, given, branch_arms=arms)

    def configuration(self, name: Value) -> LaunchObject:
        return self.object(LaunchClass.LAUNCH_CONFIGURATION, {"variable_name": name})

    def list(self, *values: Value) -> Value:
        return containers.new_list(self.run, list(values))

    def dict(self, values: Mapping[str, Value]) -> Value:
        return containers.dict_of_names(self.run, values)

    def whether(self, name: Value, kind: LaunchClass = LaunchClass.IF_CONDITION) -> LaunchObject:
        return self.object(kind, {"predicate_expression": self.configuration(name)})

    def declare(self, name: str, default: Value) -> None:
        given = {"name": Known(name), "default_value": default}
        self.actions.append(self.object(LaunchClass.DECLARE_LAUNCH_ARGUMENT, given))

    def boolean_argument(self, name: Value, default: Value | None, description: Value | None = None) -> LaunchObject:
        text = Known(str(default.value)) if isinstance(default, Known) else default or Known("False")
        given: dict[str, Value] = {"name": name, "default_value": text, "description": description or NONE}
        given["choices"] = self.list(*(Known(choice) for choice in ("true", "false", "True", "False")))
        return self.object(LaunchClass.DECLARE_LAUNCH_ARGUMENT, given)

    def node(self, package: Value, executable: Value, **given: Value) -> None:
        names: dict[str, Value] = {"package": package, "executable": executable}
        self.actions.append(self.object(LaunchClass.NODE, {**names, **given}))

    def debuggable_node(
        self, package: Value, executable: Value, asks: Value, more: Value | None = None, **given: Value
    ) -> None:
        """A node, and the same under gdb, with ``more`` arguments; the launch configuration ``asks`` says which."""
        self.node(package, executable, condition=self.whether(asks, LaunchClass.UNLESS_CONDITION), **given)
        words = given.get("arguments")
        if words is not None and more is not None and more != NONE:
            given["arguments"] = self._joined(words, more)
        self.node(package, executable, condition=self.whether(asks), **given)

    def _joined(self, words: Value, more: Value) -> Value:
        first, last = words.items(self.run), more.items(self.run)
        if first is None or last is None or first.open or last.open:
            return Unknown("words of a command line that are not known")
        return self.list(*first.values, *last.values)


def _boolean(run: LaunchRun, site: CallSite) -> Value:
    """``DeclareBooleanLaunchArg(name, default_value=False)``."""
    (name,) = arguments(site, "name")
    default, description = site.keywords.get("default_value"), site.keywords.get("description")
    return Actions(run, site).boolean_argument(name or Unknown("no name is given"), default, description)


def _debuggable(run: LaunchRun, site: CallSite) -> Value:
    """``add_debuggable_node(ld, package, executable, …)``."""
    receiver, package, executable, asks, _, more = arguments(site, *_OF_HELPER)
    actions = Actions(run, site)
    given = {name: value for name, value in site.keywords.items() if name not in _OF_HELPER}
    missing = Unknown("what add_debuggable_node() is given")
    actions.debuggable_node(package or missing, executable or missing, asks or Known("debug"), more, **given)
    if isinstance(receiver, Instance):
        calls.add(run, receiver, type(site)(actions.actions))
    return NONE


PLAIN = {f"{_MODULE}.DeclareBooleanLaunchArg": _boolean, f"{_MODULE}.add_debuggable_node": _debuggable}

__all__ = ["PLAIN", "Actions"]
