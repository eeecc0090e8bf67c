"""What is run: each program of ``fixtures/`` as it is, and as launch files start it; with what archlint says of it."""

from __future__ import annotations

import json
import re
import shutil
from dataclasses import dataclass, field
from pathlib import Path

from tests_ros.comparing import ENDS
from tests_ros.environments import OWN_INTERFACES, ROOT, Environment, packages_of_interfaces
from tests_ros.reading import Entity, graph, launched
from tests_ros.running import Program
from tests_ros.variations import VARIATIONS, Variation, every_other_name

FIXTURES = ROOT / "fixtures"
FORMS = FIXTURES / "forms"
SCRIPTS = sorted(path.name for path in FORMS.glob("*.py"))
PACKAGES = sorted(path.parent.name for path in FORMS.glob("*/setup.py"))
WORKSPACES = sorted(path.parent.name for path in FIXTURES.glob("*/expected.toml") if path.parent.name != "bad_input")

LAUNCHES: tuple[tuple[str, str, dict[str, str]], ...] = (
    ("alternatives", "src/base/launch/base.launch.py", {"simulated": "true"}),
    ("alternatives", "src/base/launch/base.launch.py", {"simulated": "false"}),
    ("broken_system", "src/my_first_package/launch/robot.launch.py", {}),
    ("launched", "src/patrol/launch/fleet.launch.py", {}),
    ("launched", "src/patrol/launch/fleet.launch.py", {"record": "false"}),
    ("launched", "src/patrol/launch/robot.launch.xml", {"scan": "/shared/scan"}),
    ("lesson", "src/my_first_package/launch/robot.launch.py", {}),
    ("lesson_extended", "src/my_first_package/launch/robot.launch.py", {}),
    ("lesson_extended", "src/my_first_package/launch/robot.launch.py", {"max_speed_rpm": "80.5"}),
    ("mixed", "src/arm_bringup/launch/arm.launch.py", {}),
    ("problem_1_service_not_available", "src/motor/launch/robot.launch.py", {}),
)
"""The fixtures' own launch files, with arguments."""

REFUSES_ROS_ARGUMENTS = {"patterns.py"}
"""Forms whose parser of the command line ends the program where launch_ros starts it."""


@dataclass(frozen=True)
class Case:
    """``name`` is a form, a package of forms or a workspace; a ``variation`` starts it otherwise than by its defaults,
    a ``launch`` file as that says."""

    name: str
    variation: Variation | None = None
    launch: str | None = None
    given: tuple[tuple[str, str], ...] = ()

    @property
    def id(self) -> str:
        words = [self.name, self.variation.name if self.variation else None]
        words += [Path(self.launch).name if self.launch else None, *(f"{key}={value}" for key, value in self.given)]
        return "-".join(word for word in words if word)


@dataclass(frozen=True)
class Ready:
    """A case to be run: the programs, the folder whose lines count, and the nodes that archlint lists."""

    programs: list[Program]
    root: Path
    nodes: list[Entity]
    interfaces: tuple[Path, ...]
    """The packages of interfaces that it needs, by their folders."""


CANNOT_RUN = {
    "helper_apis.py": "message_filters and tf2_ros have no wheel",
    "importlib_get_message.py": "rosidl_runtime_py has no wheel",
    "transforms": "tf2_ros has no wheel",
    "unbounded.py": "running it would take forever",
}

FORM_CASES = [Case(name) for name in (*SCRIPTS, *PACKAGES)]
STARTED_FORMS = [
    Case(name, one)
    for name in (*SCRIPTS, *PACKAGES)
    for one in VARIATIONS
    if name not in (*REFUSES_ROS_ARGUMENTS, *CANNOT_RUN)
]
WORKSPACE_CASES = [Case(name) for name in WORKSPACES]
STARTED_WORKSPACES = [
    Case(name, one) for name in WORKSPACES for one in VARIATIONS if name not in ("broken_system", *CANNOT_RUN)
]
ONLY_FULL = frozenset(
    case
    for cases in (STARTED_FORMS, STARTED_WORKSPACES)
    for number, case in enumerate(cases)
    if case.variation is not VARIATIONS[number // len(VARIATIONS) % len(VARIATIONS)]
)
"""Without ``--full``, each is started in one of the ways, and its neighbour in the next."""
LAUNCHED = [Case(name, None, launch, tuple(given.items())) for name, launch, given in LAUNCHES]


@dataclass
class Preparation:
    """Makes cases ready, for one distribution; ``folder`` is for copies of workspaces and for parameter files."""

    environment: Environment
    folder: Path
    _forms: dict[str | None, tuple[list[Entity], dict[str, Program]]] = field(default_factory=dict)
    _workspaces: dict[Path, list[Entity]] = field(default_factory=dict)

    def ready(self, case: Case) -> Ready:
        if case.name in SCRIPTS or case.name in PACKAGES:
            return self._form(case)
        if case.launch is not None:
            return self._launched(case)
        return self._workspace(case)

    # ------------------------------------------------------------------------------------------------ forms

    def _form(self, case: Case) -> Ready:
        """One of all forms, which archlint reads together."""
        key = case.variation.name if case.variation else None
        root = FORMS if case.variation is None else self.folder / f"forms-{key}"
        if key not in self._forms:
            self._forms[key] = self._started_forms(case.variation, root) if case.variation else self._plain_forms()
        nodes, programs = self._forms[key]
        mine = [node for node in nodes if case.name in Path(node["file"]).parts]
        started = [one for name, one in programs.items() if name.partition("/")[0] == case.name]
        return Ready(started, root, mine, needed(FORMS / case.name, FORMS))

    def _plain_forms(self) -> tuple[list[Entity], dict[str, Program]]:
        return graph(FORMS, distro=self.environment.distro), self._programs_of_forms(FORMS)

    def _started_forms(self, variation: Variation, root: Path) -> tuple[list[Entity], dict[str, Program]]:
        """All forms in one workspace, and one launch file that starts them."""
        copy_forms(root)
        plain, _ = self._forms.setdefault(None, self._plain_forms())
        actions, started = [], {}
        for name, program in self._programs_of_forms(root).items():
            form, _, executable = name.partition("/")
            if form in REFUSES_ROS_ARGUMENTS:
                continue
            nodes = [node for node in plain if form in Path(node["file"]).parts]
            names = every_other_name(nodes, self._kinds())
            settings = variation.of(nodes, root / f"{form}.yaml", names)
            actions.append(settings.action(form if executable else "forms", executable or form))
            started[name] = Program(program.target, program.folders, (*program.arguments, *settings.arguments()))
        (root / "all.launch.xml").write_text(f"<launch>{''.join(actions)}</launch>")
        nodes, _ = launched(root, "all.launch.xml", {}, root, self.environment.distro)
        return nodes, started

    def _programs_of_forms(self, root: Path) -> dict[str, Program]:
        """Scripts by their names, those of packages as ``package/executable``."""
        folder = root if root == FORMS else root / "forms"
        scripts = {name: script(name, self.folder, folder) for name in SCRIPTS if name not in CANNOT_RUN}
        below = {package: programs_below(root / package) for package in PACKAGES}
        packages = {f"{name}/{one}": program for name, found in below.items() for one, (program, _) in found.items()}
        return scripts | packages

    # ------------------------------------------------------------------------------------------------ workspaces

    def _workspace(self, case: Case) -> Ready:
        distro = self.environment.distro
        root = FIXTURES / case.name
        if case.variation is None:
            programs = [program for program, _ in programs_below(root).values()]
            return Ready(programs, root, self._plain(root), needed(root, FIXTURES / case.name))
        plain = self._plain(root)
        root = self._copy(case)
        names = every_other_name(plain, self._kinds())
        actions, started = [], []
        for executable, (program, package) in programs_below(root).items():
            nodes = [node for node in plain if executable in node["executables"]]
            settings = case.variation.of(nodes, root / f"{executable}.yaml", names)
            actions.append(settings.action(package, executable))
            started.append(Program(program.target, program.folders, settings.arguments()))
        (root / "all.launch.xml").write_text(f"<launch>{''.join(actions)}</launch>")
        nodes, _ = launched(root, "all.launch.xml", {}, root, distro)
        return Ready(started, root, nodes, needed(root, FIXTURES / case.name))

    def _plain(self, root: Path) -> list[Entity]:
        """The nodes of a workspace under their defaults."""
        if root not in self._workspaces:
            self._workspaces[root] = graph(root, distro=self.environment.distro)
        return self._workspaces[root]

    def _launched(self, case: Case) -> Ready:
        assert case.launch is not None
        root = self._copy(case)
        nodes, processes = launched(root, case.launch, dict(case.given), root, self.environment.distro)
        below = programs_below(root)
        started = [
            Program(below[one.executable][0].target, below[one.executable][0].folders, one.arguments)
            for one in processes
        ]
        return Ready(started, root, nodes, needed(root, FIXTURES / case.name))

    def _copy(self, case: Case) -> Path:
        root = self.folder / case.id
        shutil.copytree(FIXTURES / case.name, root)
        return root

    def _kinds(self) -> tuple[str, ...]:
        """The kinds of endpoints that get remap rules."""
        return ENDS if self.environment.remaps_actions else ENDS[:4]


def script(name: str, scratch: Path, folder: Path = FORMS) -> Program:
    """One form of ``folder``, with the words of its command line if it wants any; files for it go to ``scratch``."""
    if name != "patterns.py":
        return Program(str(folder / name))
    settings = scratch / "settings.json"
    settings.write_text(json.dumps({"topic": "from_settings", "robots": ["one", "two"]}))
    return Program(str(folder / name), (), ("falcon", str(settings)), (("ROBOT_NAME", "tern"),))


def copy_forms(root: Path) -> None:
    """Makes a workspace of the forms, the scripts being executables of a package ``forms``."""
    for name in (*PACKAGES, *(one.name for one in packages_of_interfaces(FORMS))):
        shutil.copytree(FORMS / name, root / name)
    package = root / "forms"
    package.mkdir()
    for name in SCRIPTS:
        shutil.copy(FORMS / name, package)
    (package / "CMakeLists.txt").write_text(CMAKE.format(scripts=" ".join(SCRIPTS)))
    (package / "package.xml").write_text(MANIFEST)


def needed(code: Path, workspace: Path) -> tuple[Path, ...]:
    """The packages of interfaces, of a workspace and of those without a wheel, that ``code`` mentions."""
    files = [code] if code.is_file() else sorted(code.rglob("*.py"))
    words = {word for path in files for word in re.findall(r"\w+", path.read_text("utf-8"))}
    return tuple(one for one in packages_of_interfaces(workspace, OWN_INTERFACES) if one.name in words)


def programs_below(root: Path) -> dict[str, tuple[Program, str]]:
    """The executables below ``root``, each with its package: what the setup files name."""
    setups = sorted(root.rglob("setup.py"))
    folders = tuple(path.parent for path in setups)
    return {
        executable: (Program(target, folders), path.parent.name)
        for path in setups
        for executable, target in re.findall(r"""['"](\w+) *= *([\w.]+:\w+)['"]""", path.read_text("utf-8"))
    }


CMAKE = """cmake_minimum_required(VERSION 3.8)
project(forms)
find_package(ament_cmake REQUIRED)
install(PROGRAMS {scripts} DESTINATION lib/${{PROJECT_NAME}})
ament_package()
"""
MANIFEST = """<?xml version="1.0"?>
<package format="3">
  <name>forms</name>
  <version>0.1.0</version>
  <description>All forms as executables of one package.</description>
  <maintainer email="robot@example.com">Robot</maintainer>
  <license>Apache-2.0</license>
  <buildtool_depend>ament_cmake</buildtool_depend>
  <export><build_type>ament_cmake</build_type></export>
</package>
"""
