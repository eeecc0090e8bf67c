"""Actions that change the launch context: groups, arguments and configurations, namespaces, remappings, parameters."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.finding import Place
from archlint.interpreter.values import DictValue, Known, Unknown, Value, one_of, reason
from archlint.launch import search_paths
from archlint.launch.actions.branches import callable_value
from archlint.launch.actions.choices import note_no_choice
from archlint.launch.actions.idle_groups import note_idle_group
from archlint.launch.model import DeclaredArgument
from archlint.launch.namespaces import absolute, prefix_namespace
from archlint.launch.objects import LaunchObject, known_text
from archlint.launch.parameters import file_use, setting
from archlint.launch.shared_paths import note_argument
from archlint.launch.started import Remap
from archlint.launch.substitutions.texts import written_at
from archlint.launch.tables import LaunchClass
from archlint.libraries.texts import text_of_value

if TYPE_CHECKING:
    from archlint.launch.run import LaunchRun


def visit_actions(run: LaunchRun, entity: LaunchObject) -> None:
    """The actions that an action is given."""
    value = entity.argument("actions")
    if value is not None and not callable_value(value):
        run.visit(value)


def group(run: LaunchRun, entity: LaunchObject) -> None:
    """``GroupAction``: configurations and environment come back after it, if it is scoped."""
    if entity.argument("scoped") == Known(False):
        visit_actions(run, entity)
        return
    kept = run.launch.copy()
    note_idle_group(run, entity, kept)
    outermost = run.around_groups is None
    if outermost:
        run.around_groups = kept
    configurations = entity.argument("launch_configurations")
    given = _configurations(run, configurations)
    if entity.argument("forwarding") == Known(False):
        # What a dict that is not known keeps may be any of them.
        keeps_some = configurations is not None and not _is_wholly_known(run, configurations)
        kept_perhaps = Unknown("the group does not forward it, and what it keeps is not known")
        run.launch.configurations = dict.fromkeys(run.launch.configurations, kept_perhaps) if keeps_some else {}
        run.launch.namespace = run.launch.remaps = run.launch.parameters = None
    run.launch.configurations.update(given)
    visit_actions(run, entity)
    run.launch.restore(kept)
    if outermost:
        run.around_groups = None


@contextmanager
def later(run: LaunchRun) -> Iterator[None]:
    """What a timer or an event starts: by then the groups around it have ended, and what they push or set for the
    nodes in them is gone.

    Source: launch, where a scoped ``GroupAction`` is followed by ``PopLaunchConfigurations``; namespaces, remappings
    and parameters for all nodes are kept among these.  ``PopEnvironment`` does the same for the environment.
    """
    run.later += 1
    try:
        with _without_groups(run), _after_the_description(run):
            yield
    finally:
        run.later -= 1


@contextmanager
def _after_the_description(run: LaunchRun) -> Iterator[None]:
    """What is set here is read by other timers and events only: by then all the rest has been visited.

    Source: launch, ``TimerAction.execute`` schedules a future, and ``RegisterEventHandler.execute`` registers a
    handler; both leave the actions to the event loop, which has visited the whole description before.
    """
    outside = run.launch.configurations
    before = run.set_later | outside
    run.launch.configurations = dict(before)
    try:
        yield
    finally:
        now, run.launch.configurations = run.launch.configurations, outside
        if not run.is_dormant:
            perhaps = (Unknown("a timer or an event sets it under a condition"),) if run.is_conditional else ()
            changed = {name: value for name, value in now.items() if before.get(name) is not value}
            run.set_later |= {name: one_of((*perhaps, value)) for name, value in changed.items()}


@contextmanager
def _without_groups(run: LaunchRun) -> Iterator[None]:
    around = run.around_groups
    if around is None:
        yield
        return
    now = run.launch
    before = now.namespace, now.remaps, now.parameters, now.environment, now.configurations
    arms, gone = run.current_arms, run.gone
    without = run.without_namespace
    run.without_namespace = without or now.namespace != around.namespace
    now.namespace, now.remaps, now.parameters = around.namespace, around.remaps, around.parameters
    now.environment = dict(around.environment)
    run.gone = {name: value for name, value in now.configurations.items() if name not in around.configurations}
    now.configurations = now.configurations | around.configurations
    run.around_groups = None
    try:
        yield
    finally:
        run.around_groups = around
        run.without_namespace = without
        now.namespace, now.remaps, now.parameters, now.environment, now.configurations = before
        run.current_arms, run.gone = arms, gone


def timer(run: LaunchRun, entity: LaunchObject) -> None:
    """``TimerAction``."""
    with later(run):
        visit_actions(run, entity)


def _is_wholly_known(run: LaunchRun, value: Value) -> bool:
    """Whether all entries of a dict are known, and their keys."""
    known = isinstance(value, DictValue) and not value.entries(run).open
    return known and all(run.text_of(key) is not None for key, _ in run.entries(value))


def _configurations(run: LaunchRun, value: Value | None) -> dict[str, Value]:
    """What a group sets, read before it forgets the configurations around it."""
    configurations: dict[str, Value] = {}
    for key, item in run.entries(value):
        name = run.text_of(key)
        if name is not None:
            configurations[name] = run.perform(item)
    return configurations


def declare(run: LaunchRun, entity: LaunchObject) -> None:
    text = _name_in(run, entity, "launch argument")
    if text is None:
        return
    default = entity.argument("default_value")
    run.declaring = text
    value = None if default is None else written_at(run.perform(default), entity.places.get("default_value"))
    run.declaring = None
    if value is not None:
        _note_default(run, text, value, entity.places.get("default_value", run.place_now))
    if not run.is_dormant or text not in run.launch.configurations:
        missing = Unknown(f"the launch argument '{text}' has no default")
        run.launch.configurations.setdefault(text, value if value is not None else missing)
        run.argument_behind(text)
    note_no_choice(run, entity, text, value)
    choices = map(known_text, run.items(entity.argument("choices")))
    allowed = tuple(choice for choice in choices if choice is not None)
    shown = None if value is None else text_of_value(value, "no default")
    run.result.declared.append(DeclaredArgument(text, shown, run.place_now, run.file, allowed, run.is_dormant))


def _note_default(run: LaunchRun, name: str, default: Value, place: Place) -> None:
    before = run.launch.configurations.get(name)
    if before is None:
        note_argument(run, name, default, place)
        run.given.note_default(name, default, place, run.file, run.includes)
    elif not run.is_conditional:
        run.given.note_no_default(name, before, default, place, run.file, run.includes)


def _name_in(run: LaunchRun, entity: LaunchObject, what: str) -> str | None:
    """The name that an action is given; where it is not known, that is a gap."""
    name = run.perform(entity.argument("name"))
    text = known_text(name)
    if text is None:
        run.gap(f"the name of a {what}: {reason(name)}")
    return text


def let(run: LaunchRun, entity: LaunchObject) -> None:
    name = _name_in(run, entity, "launch configuration")
    if name is not None:
        value = run.perform(entity.argument("value"))
        run.launch.configurations[name] = value
        note_argument(run, name, value, entity.places.get("value", run.place_now))


def unset(run: LaunchRun, entity: LaunchObject) -> None:
    name = run.text_of(entity.argument("name"))
    if name is not None:
        run.launch.configurations.pop(name, None)


def environment(run: LaunchRun, entity: LaunchObject) -> None:
    name = run.text_of(entity.argument("name"))
    if name is not None:
        run.launch.environment[name] = run.perform(entity.argument("value"))
        search_paths.note_variable(run, entity)


def forget_environment(run: LaunchRun, entity: LaunchObject) -> None:
    name = run.text_of(entity.argument("name"))
    if name is not None:
        run.launch.environment.pop(name, None)


def push_namespace(run: LaunchRun, entity: LaunchObject) -> None:
    pushed = run.perform(entity.argument("namespace"))
    run.launch.namespace = absolute(prefix_namespace(run.launch.namespace or Known(""), pushed))


def set_remap(run: LaunchRun, entity: LaunchObject) -> None:
    source, target = run.perform(entity.argument("src")), run.perform(entity.argument("dst"))
    run.launch.add_remap(remap(source, target, run.place_now, group=True))


def remap(source: Value, target: Value, place: Place, group: bool = False) -> Remap:
    return Remap(text_of_value(source, "no name"), text_of_value(target, "no name"), place, group)


def set_parameter(run: LaunchRun, entity: LaunchObject) -> None:
    name = (
        Known("use_sim_time") if entity.kind == LaunchClass.SET_USE_SIM_TIME else run.perform(entity.argument("name"))
    )
    parameter = setting(run, name, entity.given("value"), run.place_now)
    run.launch.add_parameter(replace(parameter, shared=True))


def set_parameters_from_file(run: LaunchRun, entity: LaunchObject) -> None:
    use = file_use(run, entity.argument("filename"), run.place_now)
    run.launch.add_parameter(replace(use, shared=True))
