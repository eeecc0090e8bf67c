"""Every program of ``fixtures/`` really runs, and what it is then is what archlint read from its source."""

from __future__ import annotations

import json
import re
import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests_ros.comparing import ENDS, Comparison, Entity, compare, counted, graph
from tests_ros.environments import OWN_INTERFACES, ROOT, Environment
from tests_ros.running import Observed, Observer, Program, observe
from tests_ros.variations import VARIATIONS, Variation

FIXTURES = ROOT / "fixtures"
FORMS = FIXTURES / "forms"
SCRIPTS = sorted(path.name for path in FORMS.glob("*.py"))
PACKAGES = sorted(path.parent.name for path in FORMS.glob("*/setup.py"))
WORKSPACES = sorted(path.parent.name for path in FIXTURES.glob("*/expected.toml") if path.parent.name != "bad_input")

CANNOT_RUN = {
    "helper_apis.py": "message_filters and tf2_ros have no wheel",
    "importlib_get_message.py": "rosidl_runtime_py has no wheel",
    "unbounded.py": "running it would take for ever",
}

NOT_REACHED = {
    "branches.py": {62: "chance decides whether its method ends before"},
    "lazy_endpoints.py": {
        23: "nobody publishes what it waits for",
        28: "its timer takes three seconds",
        34: "nobody calls the service",
        40: "nobody calls the service",
        50: "nothing calls the method",
        53: "nothing calls the method",
    },
    "parameters.py": {80: "main makes no such node", 81: "main makes no such node"},
    "patterns.py": {36: "nobody publishes what it waits for"},
    "wrappers.py": {34: "nobody publishes what it waits for"},
    "broken_system": {
        18: "the control's constructor waits for a service that is nowhere",
        19: "the sensor's constructor waits for a service that is nowhere",
    },
    "problem_4_dead_nodes": {13: "the driver's constructor waits for a service, for ever if it is not there"},
    "problem_1_service_not_available": {16: "its constructor waits for a service that is nowhere"},
}
"""Lines of entities that are read from the source, and that the run does not come to; all others must exist."""

REMAPS_ACTIONS = {"jazzy": False, "kilted": True}
"""Whether a rule for an action's name does anything: rcl_action 9.2.8, of Jazzy, has nothing that resolves it."""


@pytest.fixture(scope="session")
def prefixes(environment: Environment) -> list[Path]:
    """What the forms need: their own interfaces, and those without a wheel."""
    return environment.interfaces(FORMS, OWN_INTERFACES)


@pytest.fixture(scope="session")
def observer(environment: Environment, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Observer]:
    one = Observer(environment, [], tmp_path_factory.mktemp("observer"))
    yield one
    one.close()


@pytest.mark.parametrize("name", SCRIPTS)
def test_a_form_is_what_runs(
    name: str, environment: Environment, prefixes: list[Path], observer: Observer, tmp_path: Path
):
    if name in CANNOT_RUN:
        pytest.skip(CANNOT_RUN[name])
    observed = observe(environment, prefixes, [script(name, tmp_path)], FORMS, observer)
    judge(name, graph(FORMS, name), observed)


def script(name: str, folder: Path) -> Program:
    """One form, with the words of its command line if it wants any."""
    if name != "patterns.py":
        return Program(str(FORMS / name))
    settings = folder / "settings.json"
    settings.write_text(json.dumps({"topic": "from_settings", "robots": ["one", "two"]}))
    return Program(str(FORMS / name), (), ("falcon", str(settings)), (("ROBOT_NAME", "tern"),))


@pytest.mark.parametrize("name", PACKAGES)
def test_a_package_of_forms_is_what_runs(name: str, environment: Environment, prefixes: list[Path], observer: Observer):
    observed = observe(environment, prefixes, [one for one, _ in programs(FORMS / name).values()], FORMS, observer)
    judge(name, graph(FORMS, name), observed)


@pytest.mark.parametrize("name", WORKSPACES)
def test_a_workspace_is_what_runs(name: str, environment: Environment, observer: Observer):
    root = FIXTURES / name
    built = environment.interfaces(root, OWN_INTERFACES)
    observed = observe(environment, built, [one for one, _ in programs(root).values()], root, observer)
    judge(name, graph(root, "."), observed)


@pytest.mark.parametrize("variation", VARIATIONS, ids=lambda variation: variation.name)
@pytest.mark.parametrize("name", [name for name in WORKSPACES if name != "broken_system"])
def test_a_launched_workspace_is_what_runs(
    name: str, variation: Variation, environment: Environment, observer: Observer, tmp_path: Path
):
    """The same names, remappings and parameters, in a launch file for archlint and on command lines for ROS."""
    root = tmp_path / "workspace"
    shutil.copytree(FIXTURES / name, root)
    built = environment.interfaces(root, OWN_INTERFACES)
    nodes = graph(root, ".")
    kinds = ENDS if REMAPS_ACTIONS[environment.distro] else ENDS[:4]
    started = [
        (
            program,
            package,
            executable,
            variation.of([one for one in nodes if executable in one["executables"]], root, kinds),
        )
        for executable, (program, package) in programs(root).items()
    ]
    actions = "".join(setting.action(package, executable) for _, package, executable, setting in started)
    (root / "all.launch.xml").write_text(f"<launch>{actions}</launch>")

    commanded = [Program(one.target, one.folders, setting.arguments()) for one, _, _, setting in started]
    observed = observe(environment, built, commanded, root, observer)

    judge(name, graph(root, ".", "--launch", "all.launch.xml"), observed)


def test_an_action_is_remapped_by_its_name_in_some_distributions(
    environment: Environment, prefixes: list[Path], observer: Observer
):
    held = Program(str(FORMS / "held_nodes.py"), (), ("--ros-args", "-r", "left/focus:=moved"))
    nodes = observe(environment, prefixes, [held], FORMS, observer).nodes
    final = "/moved" if REMAPS_ACTIONS[environment.distro] else "/left/focus"
    assert nodes["/left_arm"]["action_clients"] == [[final, "example_interfaces/action/Fibonacci", None]]


def programs(root: Path) -> dict[str, tuple[Program, str]]:
    """The executables below ``root``, each with its package: what the setup files name."""
    setups = sorted(root.rglob("setup.py"))
    folders = tuple(path.parent for path in setups)
    return {
        executable: (Program(target, folders), path.parent.name)
        for path in setups
        for executable, target in re.findall(r"""['"](\w+) *= *([\w.]+:\w+)['"]""", path.read_text("utf-8"))
    }


def judge(name: str, nodes: list[Entity], observed: Observed) -> None:
    comparison = compare(nodes, observed)
    allowed = NOT_REACHED.get(name, {})
    late = [what for what in comparison.never_ran if int(what.split(" ")[0].rpartition(":")[2]) not in allowed]
    count(comparison)
    assert comparison.compared, "nothing ran"
    assert comparison.differences + [f"{what} is in the graph, and its line never ran" for what in late] == []


def count(comparison: Comparison) -> None:
    counted["runs"] += 1
    counted["compared"] += comparison.compared
    counted["left open"] += comparison.left_open
