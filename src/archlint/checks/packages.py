"""PKG001 to PKG003: what a package says of itself, held against its files."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.checks.near import did_you_mean, distance, nearest
from archlint.checks.registry import Options, finding, rule
from archlint.checks.ros_packages import BROUGHT, package_of_module
from archlint.checks.whole import walk
from archlint.facts import model as facts
from archlint.finding import Edit, Finding, Fix, Place
from archlint.workspace.manifest import condition_holds

if TYPE_CHECKING:
    from archlint.program.installs import Executable
    from archlint.system.launched import World
    from archlint.system.model import System
    from archlint.workspace.model import Package


def _world(system: System) -> World | None:
    """Packages are judged once: with the open system, or with the only one there is."""
    world = system.world
    return world if world is not None and (system.launched is None or world.explicit) else None


# ------------------------------------------------------------------------------------------------- PKG001


@rule("PKG001")
def undeclared_dependency(system: System, options: Options) -> Iterator[Finding]:
    """ROS packages that are imported or launched and that package.xml does not name."""
    world = _world(system)
    if world is None or world.loader is None:
        return
    told: set[tuple[str, str]] = set()
    for owner, needed, place, how in [*_imported(world), *_launched(world)]:
        package = world.packages.get(owner)
        if package is None or needed == owner or (owner, needed) in told or package.build_type == "catkin":
            continue
        declared = {d.name for d in package.dependencies if condition_holds(d.condition)}
        there = declared | _brought(declared, world)
        if needed in there or _ALSO.get(needed) in there or needed in options.external:
            continue
        told.add((owner, needed))
        near = nearest(needed, declared - set(world.packages))
        hint = f"; did you mean '{needed}' by '{near}'?" if near and distance(needed, near, 2) <= 2 else ""
        found = finding(
            "PKG001",
            place,
            f"package '{owner}' {how} '{needed}', which its package.xml does not declare{hint}",
            help=f"add <exec_depend>{needed}</exec_depend> to {package.manifest.relative}",
            identity=(owner, needed),
        )
        yield replace(found, fix=_declared_fix(world, package, needed))


_AT_RUN_TIME = frozenset({"depend", "exec", "run", "build_export"})


def _brought(declared: set[str], world: World) -> set[str]:
    """What the declared packages need when they run, and what that needs: it is installed with them."""
    found: set[str] = set()
    waiting = sorted(declared)
    while waiting:
        name = waiting.pop()
        package = world.packages.get(name)
        further = set(BROUGHT.get(name, ()))
        if package is not None:
            needed = [d for d in package.dependencies if d.kind in _AT_RUN_TIME]
            further.update(d.name for d in needed if condition_holds(d.condition))
        waiting.extend(sorted(further - found))
        found |= further
    return found


def _declared_fix(world: World, package: Package, needed: str) -> Fix | None:
    """A line for the manifest, after the last of its kind, or where the first would stand."""
    text = None if world.loader is None else world.loader.tree.text(package.manifest.relative)
    lines = [] if text is None else text.splitlines()
    in_force = _COMMENT.sub(lambda found: "\n" * found[0].count("\n"), "\n".join(lines)).split("\n")
    after = [number for number, line in enumerate(in_force, start=1) if _DEPEND.match(line)]
    after = after or [number for number, line in enumerate(in_force, start=1) if _ABOUT.match(line)]
    if not after:
        return None
    indent = lines[after[-1] - 1][: -len(lines[after[-1] - 1].lstrip())]
    place = Place(package.manifest.relative, after[-1] + 1, 1, after[-1] + 1, 1)
    edit = Edit(place, f"{indent}<exec_depend>{needed}</exec_depend>\n")
    return Fix("safe", (edit,), f"declare {needed}")


_DEPEND = re.compile(r"\s*<(?:exec_|build_export_|buildtool_|build_|)depend\b.*</\w*depend>\s*$")
_ABOUT = re.compile(r"\s*<(?:maintainer|license|url|author)\b.*</(?:maintainer|license|url|author)>\s*$")
_COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)

_ALSO = {"tf2_ros": "tf2_ros_py", "tf2_ros_py": "tf2_ros", "launch": "launch_ros", "ament_index_python": "launch_ros"}


_OF_ROS2_LAUNCH = frozenset({"launch", "launch_ros", "launch_xml", "launch_yaml", "ament_index_python"})
"""What is there wherever a launch file is launched."""


def _imported(world: World) -> Iterator[tuple[str, str, Place, str]]:
    assert world.loader is not None
    for file, found in world.loader.python_facts():
        if file.package is None or file.kind == "setup_py" or _beside_the_code(file.relative):
            continue
        of_launch = file.kind == "launch_python" or "/launch/" in f"/{file.relative}"
        for statement in _unguarded(found.body):
            module = statement.module
            if isinstance(statement, facts.ImportFrom) and statement.level:
                continue
            names = [n for n, _ in statement.names] if isinstance(statement, facts.ImportFrom) else []
            needed = package_of_module(module, names, world.packages)
            if of_launch and needed in _OF_ROS2_LAUNCH:
                continue
            if needed is not None and not world.loader.is_local(file, module):
                yield file.package, needed, Place(file.relative, *statement.span), "imports"


_BESIDE = frozenset({"test", "tests", "doc", "docs", "example", "examples"})


def _beside_the_code(path: str) -> bool:
    """Test code, documentation and examples need not be installed with what they use."""
    return any(part in _BESIDE for part in path.split("/")) or posixpath.basename(path).startswith(
        ("test_", "conftest")
    )


def _unguarded(body: list[facts.Stmt]) -> Iterator[facts.Import | facts.ImportFrom]:
    """The imports of a module that always run: not inside functions, nor where a failure is caught."""
    for statement in body:
        if isinstance(statement, (facts.Import, facts.ImportFrom)):
            yield statement


def _launched(world: World) -> Iterator[tuple[str, str, Place, str]]:
    assert world.loader is not None
    for launched in world.launched:
        for started in launched.started:
            owner = world.loader.package_of(started.file)
            name = started.package.text
            exact = started.package.resolution == "exact" and not started.dormant
            if owner is not None and name and exact and started.kind in ("node", "container"):
                yield owner, name, started.places.get("package", started.place), "starts a node of"


# ------------------------------------------------------------------------------------------------- PKG002


@rule("PKG002")
def broken_entry_point(system: System, options: Options) -> Iterator[Finding]:
    """Console scripts whose module or function is not there."""
    world = _world(system)
    if world is None or world.loader is None:
        return
    for name in sorted(world.installs):
        for executable in world.installs[name].executables.values():
            if executable.module is not None:
                yield from _broken(world, executable)


def _broken(world: World, executable: Executable) -> Iterator[Finding]:
    assert world.loader is not None and executable.module is not None
    modules = world.loader.modules_of(executable.package)
    if not modules:
        return
    module, function = executable.module, executable.function
    paths = [path for name, path in modules.items() if name == module]
    paths = paths or world.loader.files_named(executable.package, module)
    if not paths:
        top = module.partition(".")[0]
        ours = {name.partition(".")[0] for name in modules}
        if top not in ours and nearest(top, ours) is None:
            return  # a module of another distribution
        yield _entry_finding(executable, f"module '{module}' is not there{_near_module(module, modules)}")
        return
    found = world.loader.facts_at(paths[0])
    if found is None or found.problems or function is None:
        return
    names, open_ = _top_level(found.body)
    head = function.partition(".")[0]
    if head not in names and not open_:
        yield _entry_finding(executable, f"'{module}' has no function '{head}'{did_you_mean(head, names)}")


def _near_module(module: str, known: Iterable[str]) -> str:
    """The hint for a module: one beside it by the last part of its name, else by the whole name."""
    parent, _, last = module.rpartition(".")
    beside = [name.rpartition(".")[2] for name in known if name.rpartition(".")[0] == parent]
    if not beside:
        return did_you_mean(module, known)
    near = nearest(last, beside)
    return f"; did you mean '{parent}.{near}'?" if near is not None else ""


def _entry_finding(executable: Executable, what: str) -> Finding:
    return finding(
        "PKG002",
        executable.place,
        f"the executable '{executable.name}' cannot start: {what}",
        help="an entry point is 'name = package.module:function'",
        identity=(executable.package, executable.name),
    )


def _top_level(body: list[facts.Stmt]) -> tuple[set[str], bool]:
    """The names that a module binds, and whether there may be more."""
    names: set[str] = set()
    open_ = False
    for item in walk(body):
        if isinstance(item, (facts.Function, facts.Class)):
            names.add(item.name)
        elif isinstance(item, facts.ImportFrom):
            names.update(bound for _, bound in item.names)
            open_ = open_ or any(name == "*" for name, _ in item.names)
        elif isinstance(item, facts.Import):
            names.add(item.alias or item.module.partition(".")[0])
        elif isinstance(item, facts.Assign):
            names.update(target.id for target in item.targets if isinstance(target, facts.Name))
        elif isinstance(item, facts.Name) and item.id in ("globals", "setattr"):
            open_ = True
    return names, open_


# ------------------------------------------------------------------------------------------------- PKG003

_BUILD = frozenset({"depend", "build", "build_export", "buildtool", "buildtool_export", "exec", "run"})


@rule("PKG003")
def circular_dependency(system: System, options: Options) -> Iterator[Finding]:
    """Packages that need each other."""
    world = _world(system)
    if world is None:
        return
    needs = {name: _needs(package, world.packages) for name, package in sorted(world.packages.items())}
    told: set[str] = set()
    for start in needs:
        circle = [] if start in told else _circle(start, needs)
        if not circle:
            continue
        told.update(circle)
        package = world.packages[start]
        line = needs[start][circle[1]]
        yield finding(
            "PKG003",
            Place(package.manifest.relative, line, 1, line, 1),
            f"packages need each other in a circle: {' → '.join(circle)}",
            help="colcon cannot order them; move what both need into a package of its own",
            identity=tuple(sorted(circle[:-1])),
        )


def _needs(package: Package, packages: object) -> dict[str, int]:
    """The packages of this workspace that one needs, with the line that says so."""
    assert isinstance(packages, dict)
    return {
        d.name: d.line
        for d in reversed(package.dependencies)
        if d.kind in _BUILD and d.name in packages and condition_holds(d.condition)
    }


def _circle(start: str, needs: dict[str, dict[str, int]]) -> list[str]:
    """A shortest way from a package back to itself; empty where there is none."""
    waiting = [[start]]
    seen: set[str] = set()
    while waiting:
        path = waiting.pop(0)
        for name in sorted(needs[path[-1]]):
            if name == start:
                return [*path, start]
            if name not in seen:
                seen.add(name)
                waiting.append([*path, name])
    return []
