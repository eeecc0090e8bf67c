"""LCH001: executables that a launch file starts and that are not installed."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.pinned import is_for_humble_or_newer, is_from_before_galactic
from archlint.checks.executables_instead import advice_on, advice_on_launch_file, include_of, installed_by, stem_of
from archlint.checks.folding import folds, with_places
from archlint.checks.packages import is_ignored_by_cmake
from archlint.checks.registry import Options, finding, rule
from archlint.checks.ros_arguments import refused_ros_arguments, refused_words_for_ros
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related, Severity
from archlint.launch.kinds import StartedKind
from archlint.launch.old_keywords import has_old_executable
from archlint.launch_files.shown_files import is_shown_only
from archlint.launch_files.unadded_programs import unadded_programs
from archlint.packaging.absent_packages import is_nowhere, is_placeholder, owners_of_component, package_that_installs
from archlint.packaging.entry_points import only_defines_node
from archlint.packaging.refused_manifests import mistyped_packages
from archlint.ros.released_programs import launch_file_instead, programs_instead
from archlint.suggestions import did_you_mean, listed, nearest

if TYPE_CHECKING:
    from archlint.launch.started import Started
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.workspace.installed import Executable, Installs


@rule("LCH001", scope=Scope.LAUNCH_FILE, in_use=True)
def unknown_executable(system: System, options: Options) -> Iterator[Finding]:
    """Started executables that their package does not install."""
    if system.launched is None or system.workspace is None:
        return
    for started in system.launched.started:
        yield from _of_program(system, system.workspace, options, started)
    for started in unadded_programs(system):  # which launch would look for, once something adds them
        for told in _of_program(system, system.workspace, options, started):
            yield replace(told, severity=Severity.INFO)
    yield from refused_ros_arguments(system)
    yield from refused_words_for_ros(system)


def _of_program(system: System, workspace: WorkspaceIndex, options: Options, started: Started) -> Iterator[Finding]:
    """The finding for one program, if it cannot be started."""
    installs = workspace.installs.get(started.package.text or "")
    name = started.executable.text
    if name is None or started.executable.resolution != "exact" or _ends_before(workspace, started):
        return
    if started.kind is StartedKind.COMPONENT and installs is None:
        yield from _component_from_no_package(workspace, started, name)
    if started.kind not in (StartedKind.NODE, StartedKind.CONTAINER):
        return
    if installs is None and started.package.text in options.external:
        return
    if installs is None:
        yield from _from_no_package(system, workspace, started, name)
        return
    entry = installs.executables.get(name)
    package = workspace.packages.get(installs.package)
    if entry is not None and not (is_ignored_by_cmake(package, entry) and not _is_named_by_cmake(installs, name)):
        yield from _not_in_sight(installs, started, name)
        yield from _idle(workspace, started, entry)
        return
    if posixpath.isabs(name):
        return  # launch_ros starts that file, and asks the package only for its folder: a Python of its own, say
    unread = package is None or package.build_type not in ("ament_python", "ament_cmake")
    if unread or installs.open_executables or not installs.build_files or name in installs.mentioned:
        return
    if entry is not None and installs.package in mistyped_packages(workspace):
        return  # PKG011: with the right type, setup.py is read
    if entry is not None:
        yield _unread_entry(started, name, entry, installed_by(workspace, installs))
        return
    advice = advice_on_launch_file(installs, started, name, workspace) or advice_on(installs, name, workspace)
    told = finding(
        "LCH001",
        started.places.get("executable", started.place),
        f"package '{installs.package}' installs no executable '{name}'{advice.hint}",
        help=advice.help,
        identity=(installs.package, name),
        group=(installs.package, _LEFT_OUT if advice.is_left_out else name),
    )
    # A file that only shows how one is written may have made-up names.
    is_meant = advice.is_on_purpose or (not advice.hint and is_shown_only(system))
    yield replace(told, severity=Severity.INFO) if is_meant else told


def _ends_before(workspace: WorkspaceIndex, started: Started) -> bool:
    """Whether launch stops at the keyword that names the executable, as LCH005 says, and looks for no program."""
    return has_old_executable(started.places) and not is_from_before_galactic(workspace)


def _not_in_sight(installs: Installs, started: Started, name: str) -> Iterator[Finding]:
    """The finding for a program that CMake builds and does not install; one that it installs elsewhere PKG013 tells."""
    astray, built = installs.astray.get(name), installs.executables[name]
    if astray is not None and not astray.folder:
        yield finding(
            "LCH001",
            started.places.get("executable", started.place),
            f"package '{installs.package}' builds the executable '{name}' and does not install it",
            help=f"add install(TARGETS {name} DESTINATION lib/${{PROJECT_NAME}}) to its CMakeLists.txt",
            related=[Related(built.place, "it is built here")],
            identity=(installs.package, name),
            group=(installs.package, _BUILT),
        )


def _idle(workspace: WorkspaceIndex, started: Started, entry: Executable) -> Iterator[Finding]:
    """The finding for a script that defines a node and never makes one."""
    node = None if entry.script is None else only_defines_node(workspace, entry.script)
    if node is not None:
        yield finding(
            "LCH001",
            started.places.get("executable", started.place),
            f"'{entry.name}' of package '{entry.package}' ends at once: {entry.script} defines {node}, and makes none",
            help="give the script a main() that makes the node and spins it, and call that",
            related=[Related(entry.place, "it is installed as a program here")],
            identity=(entry.package, entry.name),
            group=(entry.package, entry.name),
        )


def _unread_entry(started: Started, name: str, entry: Executable, installed: dict[str, Executable]) -> Finding:
    """The finding for an executable that only a setup.py names, in a package that CMake builds."""
    own = [other for other in sorted(installed) if stem_of(installed[other]) == stem_of(entry)]
    instead = own[0] if len(own) == 1 else ""
    hint = f": {_NOT_READ}"
    hint += f"; {installed[instead].script or instead} is installed as '{instead}'" if instead else ""
    return finding(
        "LCH001",
        started.places.get("executable", started.place),
        f"package '{entry.package}' installs no executable '{name}'{hint}",
        help=f"start '{instead}'"
        if instead
        else f"install a script as '{name}' in CMakeLists.txt: install(PROGRAMS … DESTINATION lib/${{PROJECT_NAME}})",
        related=[Related(entry.place, f"the entry of '{name}' is here")],
        identity=(entry.package, name),
        group=(entry.package, _UNREAD),
        meant=instead,
    )


_NOT_READ = "CMake builds it, and its setup.py is not read"
_UNREAD, _LEFT_OUT, _BUILT = "setup.py ", "left out ", "built "
"""What the entries of a setup.py that CMake does not read have in common, the scripts that a package does not
install, and the programs that it only builds: the names of no executable."""


def _is_named_by_cmake(installs: Installs, name: str) -> bool:
    """Whether a CMake file has the name of an executable, or of the script that may become it, among its words."""
    stem = name.removesuffix(".py")
    return any(posixpath.basename(word).removesuffix(".py") == stem for word in installs.words)


@folds("LCH001", across_systems=True)
def _of_one_executable(several: Sequence[Finding]) -> Finding:
    """One finding for an executable that is not there, however many launch actions start it; for all that are not there
    because CMake does not read the setup.py, and for all scripts of a package that are not installed."""
    names = dict.fromkeys(finding.identity[1] for finding in several)
    if len(names) == 1:
        return with_places(several, "it is started here, too")
    first = several[0]
    those = f"none of these {len(names)} executables: {listed(sorted(names))}"
    instead = [finding.meant for finding in several]
    related = [
        row
        for finding in several
        for row in (Related(finding.place, f"'{finding.identity[1]}' is started here"), *finding.related)
    ]
    if first.group[1] == _BUILT:
        line = f"install(TARGETS {' '.join(sorted(names))} DESTINATION lib/${{PROJECT_NAME}})"
        return replace(
            first,
            message=f"package '{first.identity[0]}' installs {those}: CMake builds them and no more",
            help=f"add {line} to its CMakeLists.txt",
            related=tuple(dict.fromkeys(related[1:])),
        )
    if first.group[1] == _LEFT_OUT:
        return replace(
            first,
            message=f"package '{first.identity[0]}' installs {those}; their files exist but are not installed",
            help="install each, in setup.py or CMakeLists.txt, under the name that the launch files use",
            related=tuple(dict.fromkeys(related[1:])),
        )
    return replace(
        first,
        message=f"package '{first.identity[0]}' installs {those}: {_NOT_READ}",
        help=f"start what CMake installs: {listed(sorted(set(instead)))}"
        if all(instead)
        else "install the scripts in CMakeLists.txt, install(PROGRAMS … DESTINATION lib/${PROJECT_NAME}), "
        "and start them by the names of their files",
        related=tuple(dict.fromkeys(related[1:])),
        meant="",
    )


def _from_no_package(system: System, workspace: WorkspaceIndex, started: Started, name: str) -> Iterator[Finding]:
    """The finding for a package that is nowhere, if one of almost the same name installs the executable, or its name
    only stands for another one."""
    package = started.package.text
    if package is None or started.package.resolution != "exact":
        return
    if name.endswith(_LAUNCH_FILES):
        yield _launch_file(started, package, name)
    elif not posixpath.isabs(name) and (programs := programs_instead(package, name)):
        yield _no_program(started, package, name, programs)
    elif programs := _programs_since_humble(workspace, started.file, package, name):
        yield _no_program(started, package, name, programs, " since Humble, which this workspace is for")
    if not is_nowhere(workspace, package):
        return
    near = nearest(
        package, [own for own, installs in workspace.installs.items() if name in installed_by(workspace, installs)]
    )
    near = near or _without_spaces(workspace, package) or package_that_installs(workspace, package, name, started.file)
    if near is not None:
        yield _with_share_folders(system, _no_package(started, name, near, "installs"), package)
    elif is_placeholder(package) and not is_shown_only(system):
        yield _with_share_folders(system, _no_package(started, name, None, "installs"), package)


def _with_share_folders(system: System, told: Finding, package: str) -> Finding:
    """A finding about a package that is not there, with the places that look for its share folder: they stop the launch
    as well."""
    references = () if system.launched is None else system.launched.references
    places = dict.fromkeys(reference.place for reference in references if reference.package == package)
    rows = (Related(place, "its share folder is looked for here") for place in places if place != told.place)
    return replace(told, related=(*told.related, *rows))


def _programs_since_humble(workspace: WorkspaceIndex, file: str, package: str, name: str) -> list[str]:
    """The programs of a package of ROS that lost the one of a name before Humble, in a workspace for Humble or later.
    A launch file that asks for the distribution may start either."""
    programs = programs_instead(package, name, since_humble=True)
    asks = programs and workspace.code.mentions(file, "ROS_DISTRO")
    return programs if programs and not asks and is_for_humble_or_newer(workspace) else []


def _no_program(started: Started, package: str, name: str, programs: Sequence[str], since: str = "") -> Finding:
    """The finding for a package of ROS that has not got the program, or has not got it ``since`` a distribution."""
    launch_file = launch_file_instead(package, name)
    return finding(
        "LCH001",
        started.places.get("executable", started.place),
        f"package '{package}' installs no executable '{name}'{since}{did_you_mean(name, programs)}",
        help=f"include its {launch_file}" if launch_file else f"start one that it has: {listed(programs)}",
        identity=(package, name),
        group=(package, name),
    )


def _without_spaces(workspace: WorkspaceIndex, package: str) -> str | None:
    """The known package that a name means which begins or ends with a space."""
    plain = package.strip()
    return plain if plain != package and not is_nowhere(workspace, plain) else None


def _component_from_no_package(workspace: WorkspaceIndex, started: Started, plugin: str) -> Iterator[Finding]:
    """The finding for a package that is nowhere, if another one registers the component."""
    package = started.package.text
    if package is None or started.package.resolution != "exact" or not is_nowhere(workspace, package):
        return
    owners = owners_of_component(workspace, plugin)
    if len(owners) == 1:
        yield _no_package(started, plugin, owners[0], "registers")
    elif is_placeholder(package):
        yield _no_package(started, plugin, None, "registers")


def _no_package(started: Started, name: str, right: str | None, verb: str) -> Finding:
    package = started.package.text or ""
    if right is None:
        reason = ": the name only stands for that of a package"
    elif right == package.strip():
        reason = ": its name has a space too many"
    else:
        reason = f"; did you mean '{right}', which {verb} '{name}'?"
    return finding(
        "LCH001",
        started.places.get("package", started.place),
        f"there is no package '{package}'{reason}",
        help=f"write the name of the package that {verb} '{name}'"
        if right is None
        else f"start it from package '{right}'",
        identity=(package, name),
        group=(package, name),
        meant=right or "",
    )


_LAUNCH_FILES = (".launch.py", "_launch.py", ".launch.xml", ".launch.yaml", ".launch.yml")


def _launch_file(started: Started, package: str, name: str) -> Finding:
    """The finding for a launch file of a package from elsewhere that is started as if it were a program."""
    return finding(
        "LCH001",
        started.places.get("executable", started.place),
        f"'{name}' is a launch file, and no program: package '{package}' installs no executable of that name",
        help=f"include it instead: {include_of(started)}",
        identity=(package, name),
        group=(package, name),
    )
