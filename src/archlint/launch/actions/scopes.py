"""Actions that change the launch context: groups, arguments and configurations, namespaces, remappings, parameters."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.finding import Place
from archlint.interpreter import containers
from archlint.interpreter.values import DictValue, Instance, Known, Unknown, Value, reason
from archlint.launch.actions.branches import callable_value
from archlint.launch.context import absolute, prefix_namespace
from archlint.launch.model import DeclaredArgument, Remap
from archlint.launch.objects import argument, kind_of, places_of
from archlint.launch.parameters import file_use, setting
from archlint.launch.substitutions.texts import written_at
from archlint.libraries.texts import text_of_value

if TYPE_CHECKING:
    from archlint.launch.run import LaunchRun


def visit_actions(run: LaunchRun, entity: Instance) -> None:
    """The actions that an action is given."""
    value = argument(entity, "actions")
    if value is not None and not callable_value(value):
        run.visit(value)


def group(run: LaunchRun, entity: Instance) -> None:
    """``GroupAction``: configurations and environment come back after it, if it is scoped."""
    if argument(entity, "scoped") == Known(False):
        visit_actions(run, entity)
        return
    kept = run.launch.copy()
    given = _configurations(run, argument(entity, "launch_configurations"))
    if argument(entity, "forwarding") == Known(False):
        run.launch.configurations = {}
        run.launch.namespace = run.launch.remaps = run.launch.parameters = None
    run.launch.configurations.update(given)
    visit_actions(run, entity)
    run.launch.restore(kept)


def _configurations(run: LaunchRun, value: Value | None) -> dict[str, Value]:
    """What a group sets, read before it forgets the configurations around it."""
    found: dict[str, Value] = {}
    if isinstance(value, DictValue):
        for key, item in containers.entries_of(run, value).entries.values():
            name = run.perform(key)
            if isinstance(name, Known):
                found[str(name.value)] = run.perform(item)
    return found


def declare(run: LaunchRun, entity: Instance) -> None:
    name = run.perform(argument(entity, "name"))
    if not isinstance(name, Known):
        run.gap(f"the name of a launch argument: {reason(name)}")
        return
    text = str(name.value)
    default = entity.arguments.get("default_value")
    given = default is not None and default != Known(None)
    run.declaring = text
    value = written_at(run.perform(default), places_of(entity).get("default_value")) if given else None
    run.declaring = None
    if not run.is_dormant or text not in run.launch.configurations:
        missing = Unknown(f"the launch argument '{text}' has no default")
        run.launch.configurations.setdefault(text, value if value is not None else missing)
        run.argument_behind(text)
    choices = argument(entity, "choices")
    allowed = [str(c.value) for c in run.items(choices) if isinstance(c, Known)] if choices is not None else []
    shown = None if value is None else text_of_value(value, "no default")
    run.result.declared.append(DeclaredArgument(text, shown, run.place_now, run.file, tuple(allowed), run.is_dormant))


def let(run: LaunchRun, entity: Instance) -> None:
    name = run.perform(argument(entity, "name"))
    if isinstance(name, Known):
        run.launch.configurations[str(name.value)] = run.perform(argument(entity, "value"))
    else:
        run.gap(f"the name of a launch configuration: {reason(name)}")


def unset(run: LaunchRun, entity: Instance) -> None:
    name = run.perform(argument(entity, "name"))
    if isinstance(name, Known):
        run.launch.configurations.pop(str(name.value), None)


def environment(run: LaunchRun, entity: Instance) -> None:
    name = run.perform(argument(entity, "name"))
    if isinstance(name, Known):
        run.launch.environment[str(name.value)] = run.perform(argument(entity, "value"))


def push_namespace(run: LaunchRun, entity: Instance) -> None:
    pushed = run.perform(argument(entity, "namespace"))
    run.launch.namespace = absolute(prefix_namespace(run.launch.namespace or Known(""), pushed))


def set_remap(run: LaunchRun, entity: Instance) -> None:
    source, target = run.perform(argument(entity, "src")), run.perform(argument(entity, "dst"))
    run.launch.add_remap(remap(source, target, run.place_now, group=True))


def remap(source: Value, target: Value, place: Place, group: bool = False) -> Remap:
    return Remap(text_of_value(source, "no name"), text_of_value(target, "no name"), place, group)


def set_parameter(run: LaunchRun, entity: Instance) -> None:
    name = Known("use_sim_time") if kind_of(entity) == "SetUseSimTime" else run.perform(argument(entity, "name"))
    made = setting(run, name, entity.arguments.get("value", Known(None)), run.place_now)
    run.launch.add_parameter(replace(made, shared=True))


def set_parameters_from_file(run: LaunchRun, entity: Instance) -> None:
    made = file_use(run, argument(entity, "filename"), run.place_now)
    run.launch.add_parameter(replace(made, shared=True))
