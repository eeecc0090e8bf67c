"""Calls of launch's API in any code: the objects that it makes, and what is known of them where nothing is launched."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter import containers
from archlint.interpreter.values import (
    NONE,
    ClassValue,
    External,
    Instance,
    Items,
    OneOf,
    Unknown,
    Value,
    reason,
)
from archlint.launch.copied_parameters import with_copied_parameters
from archlint.launch.objects import (
    ENTITIES,
    GIVEN,
    MADE_BY_BASE,
    LaunchObject,
    entities_of,
    given,
    kind_of,
    launch_object,
)
from archlint.launch.substitutions.paths import package_share
from archlint.launch.substitutions.texts import each_text
from archlint.launch.tables import CLASSES, CONDITIONS, SUBSTITUTIONS, LaunchClass
from archlint.libraries.api_use import argument_places

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.interpreter.call_site import CallSite
    from archlint.libraries.api_use import ApiUse
    from archlint.libraries.run import Run


DECLARES = (LaunchClass.DECLARE_LAUNCH_ARGUMENT, LaunchClass.DECLARE_BOOLEAN_LAUNCH_ARGUMENT)
PACKAGES_OF_THE_MACHINE = "the environment variable AMENT_PREFIX_PATH"
"""Names the folders that packages are installed to."""


def made_object(run: Run, call: ApiUse) -> LaunchObject:
    """An action, substitution, condition … with its arguments by name, where each is written, and the branches
    of the launch file's own code that it is made in."""
    kind = CLASSES[call.api.makes]
    instance = launch_object(
        run.store.new_key(),
        kind,
        run.place(call.expression.span) if call.expression is not None and run.activations else None,
        with_copied_parameters(run, kind, dict(call.arguments)),
        places=argument_places(run, call.api, call.expression),
        rest=tuple(call.rest),
        open=call.open,
        branch_arms=frozenset(run.branch_arms),
        called_at=_call_of_helper(run),
    )
    if isinstance(call.receiver, Instance):
        run.store.set(
            call.receiver.key, MADE_BY_BASE, instance
        )  # super().__init__(…) of a class derived from an action
    return instance


def _call_of_helper(run: Run) -> Place | None:
    """Where the function is called that makes an object of what it is given; where another such function does that,
    the call of that one."""
    place = None
    for activation in reversed(run.activations):
        if activation.scope.kind == "comprehension":
            continue
        function = activation.function
        own = 0 if activation.self_value is None else 1
        if function is None or activation.call_place is None or len(function.ir.params) <= own:
            break
        place = activation.call_place
    return place


def _made_description(run: Run, call: ApiUse) -> LaunchObject:
    """A ``LaunchDescription`` with its first actions."""
    description = made_object(run, call)
    run.store.set(description.key, ENTITIES, _items(run, call.arguments.get("initial_entities")))
    return description


def _items(run: Run, value: Value | None) -> Items:
    match given(value):
        case None:
            return Items(())
        case OneOf() as several:
            return Items((several,))
        case actions:
            return actions.items(run) or Items((actions,), True)


def _package_path(run: Run, call: ApiUse) -> Value:
    return Unknown("the path of an installed package")


def _search_paths(run: Run, call: ApiUse) -> Value:
    return Unknown(PACKAGES_OF_THE_MACHINE)


EFFECTS = {
    "launch_object": made_object,
    "launch_description": _made_description,
    "package_share": _package_path,
    "package_prefix": _package_path,
    "search_paths": _search_paths,
}
"""By the names that the rows of launch's table have."""


def add(run: Run, receiver: Value, site: CallSite) -> Value:
    """``LaunchDescription.add_action``."""
    if not isinstance(receiver, Instance):
        return NONE
    items = entities_of(run, receiver) or Items(())
    for value in site.values:
        items = Items((*items.values, _in_branch(run, value)), items.open)
    run.store.set(receiver.key, ENTITIES, items)
    return NONE


def _in_branch(run: Run, value: Value) -> Value:
    """An action that is added in a branch of the code is conditional, wherever it was made."""
    if not run.branch_arms:
        return value
    arms = frozenset(run.branch_arms)
    return launch_object(run.store.new_key(), LaunchClass.BRANCH, None, {"action": value}, branch_arms=arms)


def _find(run: Run, receiver: Value, site: CallSite) -> Value:
    """``FindPackageShare('pkg').find('pkg')``."""
    names = site.values
    return each_text(names[0], package_share) if names else Unknown("no value")


def _declared(run: Run, receiver: Value, site: CallSite) -> Value:
    """``description.get_launch_arguments()``: the declarations in it; in what it includes, there may be more."""
    actions = (entities_of(run, receiver) if isinstance(receiver, Instance) else None) or Items((), True)
    declared = [action for action in actions.values if kind_of(action) in DECLARES]
    others = (action for action in actions.values if kind_of(action) not in (*DECLARES, *_WITHOUT_ACTIONS))
    return containers.new_list(run, declared, "list", actions.open or any(True for _ in others))


_WITHOUT_ACTIONS = (LaunchClass.NODE, LaunchClass.LIFECYCLE_NODE, LaunchClass.SET_LAUNCH_CONFIGURATION)


def _performed(run: Run, receiver: Value, site: CallSite) -> Value:
    return Unknown("a substitution outside of a launch file")


def _evaluated(run: Run, receiver: Value, site: CallSite) -> Value:
    return Unknown(UNDECIDED)


UNDECIDED = "a condition that is not known"

METHODS = {
    "launch.LaunchDescription.add_action": add,
    "launch.LaunchDescription.add_entity": add,
    "launch.LaunchDescription.get_launch_arguments": _declared,
    "launch.LaunchContext.perform_substitution": _performed,
    "launch.FindPackageShare.find": _find,
    "launch.FindPackagePrefix.find": _find,
    **{f"launch.{name}.perform": _performed for name in SUBSTITUTIONS},
    **{f"launch.{name}.evaluate": _evaluated for name in CONDITIONS},
}


def _performed_all(run: Run, site: CallSite) -> Value:
    return Unknown("a substitution outside of a launch file")


def _same(run: Run, site: CallSite) -> Value:
    return site.args[0] if site.args else Unknown("no argument")


def _path(run: Run, site: CallSite) -> Value:
    return Instance(External("pathlib.Path"), run.store.new_key(), None, {str(i): a for i, a in enumerate(site.args)})


def _path_of_machine(run: Run, site: CallSite) -> Value:
    return Unknown("a path of this machine")


def _open(run: Run, site: CallSite) -> Value:
    return Unknown(reason(*site.args) if site.args else "a file")


def _yaml(run: Run, site: CallSite) -> Value:
    return Unknown("the content of a YAML file")


def _nothing(run: Run, site: CallSite) -> Value:
    return NONE


PLAIN = {
    **dict.fromkeys(("os.remove", "os.unlink", "os.mkdir", "os.makedirs", "shutil.rmtree", "time.sleep"), _nothing),
    "open": _open,
    "yaml.safe_load": _yaml,
    "yaml.load": _yaml,
    "yaml.full_load": _yaml,
    "launch.utilities.perform_substitutions": _performed_all,
    "launch.utilities.normalize_to_list_of_substitutions": _same,
    "launch.some_substitutions_type.SomeSubstitutionsType": _same,
    "pathlib.Path": _path,
    "pathlib.PurePath": _path,
    "os.path.abspath": _path_of_machine,
    "os.path.realpath": _path_of_machine,
    "os.path.normpath": _path_of_machine,
}


def note_given(run: Run, instance: Instance, cls: ClassValue, site: CallSite) -> None:
    """Keep what the constructor of a class that derives from one of launch's is given, by name or position."""
    if site.open or not any(path.startswith("launch") for path in cls.external_bases()):
        return
    named = sorted(site.keywords.items(), key=lambda row: row[0])
    rows = [*((str(number), value) for number, value in enumerate(site.args)), *named]
    run.store.set(instance.key, GIVEN, tuple(rows))


def entities(run: Run, description: Instance) -> Value | None:
    """``LaunchDescription.entities``."""
    actions = entities_of(run, description)
    return None if actions is None else containers.new_list(run, actions.values, "list", actions.open)


__all__ = ["EFFECTS", "METHODS", "PLAIN", "UNDECIDED", "entities", "made_object", "note_given"]
