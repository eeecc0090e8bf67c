"""MSG002: interfaces that a package does not define."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint import suggestions
from archlint.analysis.pinned import knows_interfaces_of
from archlint.checks.folding import folds
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related
from archlint.launch_files.missing_files import namesake
from archlint.python_code.message_variables import fields_set
from archlint.ros.interfaces import is_interface_name
from archlint.suggestions import listed, nearest
from archlint.workspace.kinds import is_cpp

if TYPE_CHECKING:
    from archlint.model import UnknownInterface
    from archlint.systems.model import System, WorkspaceIndex

_SHOWN = 12
"""How many names a help line lists."""


@rule("MSG002", scope=Scope.CODE)
def unknown_interface(system: System, options: Options) -> Iterator[Finding]:
    """Interfaces imported from a package that does not define them."""
    unknown = {
        (interface.place, interface.name): interface
        for run in system.programs
        for interface in run.unknown_interfaces
        if not is_cpp(interface.place.file) or _is_built(system, run.file)
        if knows_interfaces_of(system.workspace, interface.package)
    }
    rows = [unknown[key] for key in sorted(unknown)]
    for interface in rows:
        beside = {
            other.name for other in rows if other.place.file == interface.place.file and _are_alike(other, interface)
        }
        told = _unknown_interface(interface, _meant(system, interface))
        is_own = system.workspace is not None and interface.package in system.workspace.packages
        yield _of_own_package(system.workspace, told, interface, beside) if is_own else told


def _are_alike(other: UnknownInterface, interface: UnknownInterface) -> bool:
    return (other.package, other.kind) == (interface.package, interface.kind)


def _of_own_package(
    workspace: WorkspaceIndex | None, told: Finding, interface: UnknownInterface, beside: Collection[str]
) -> Finding:
    """The finding with what it has in common with those of other files that lack the same of a package of the
    workspace: what mends one mends all.  ``beside`` are the names that its file lacks of the package."""
    if _generates_nothing(workspace, interface.package) and not interface.elsewhere:
        help = (
            "define it in a package whose build calls rosidl_generate_interfaces(), as that of "
            f"{interface.package} does not, and import it from there"
        )
        return replace(told, help=help, group=(_OWN, interface.package, interface.kind, *sorted(beside)))
    if interface.left_out:
        return replace(told, group=(_LEFT_OUT, interface.package, interface.kind, interface.name))
    if len(interface.elsewhere) == 1 and is_cpp(interface.place.file):
        return replace(told, group=(_ELSEWHERE, interface.package, interface.kind, *interface.elsewhere))
    if interface.elsewhere or _part(interface) is not None:
        return told
    help = told.help
    # Below msg/, say, where rosidl makes no message of it.
    elsewhere = None if workspace is None else namesake(workspace, interface.package, _file(interface))
    if elsewhere is not None:
        help = f'move {elsewhere} to {interface.kind}/, and list "{_file(interface)}" in rosidl_generate_interfaces()'
        told = replace(told, message=told.message.replace(_instead(told.meant), ""), meant="")
    elif not told.meant and not is_cpp(interface.place.file) and is_interface_name(interface.name):
        help = f"{help}; if it is meant to be one of its own, add {_file(interface)} to {interface.package}"
    return replace(told, help=help, group=(_OWN, interface.package, interface.kind, *sorted(beside)))


def _generates_nothing(workspace: WorkspaceIndex | None, package: str) -> bool:
    """Whether no command of the build of a package can make interfaces, so that no file that is added makes one."""
    installs = None if workspace is None else workspace.installs.get(package)
    return installs is not None and installs.generates_nothing


_OWN, _LEFT_OUT, _ELSEWHERE = "of the workspace", "left out", "of another package"


def _is_built(system: System, file: str) -> bool:
    """Whether a CMakeLists.txt builds a source in any case: code that nothing compiles may name what it likes."""
    installs = () if system.workspace is None else system.workspace.installs.values()
    return any(file in package.sources for package in installs)


def _meant(system: System, interface: UnknownInterface) -> str:
    """The interface that was perhaps meant: one of another kind, with the package, or one of almost its name that has
    the fields which the file sets; empty for none."""
    moved = [other for other in interface.others if "/" in other]
    names = [other for other in interface.others if "/" not in other]
    meant = moved[0] if moved else "" if _part(interface) else nearest(interface.name, names) or ""
    if moved or not meant or interface.kind != "msg" or system.workspace is None:
        return meant
    file_facts, table = system.workspace.facts_at(interface.place.file), system.workspace.interfaces
    module, full = f"{interface.package}.msg", f"{interface.package}/msg/{meant}"
    fields = set() if file_facts is None else fields_set(file_facts, module, interface.name)
    lacks = table is not None and any(table.has(full, "", field) is False for field in fields)
    return "" if lacks else meant


def _unknown_interface(interface: UnknownInterface, meant: str) -> Finding:
    names = [other for other in interface.others if "/" not in other]
    hint = _instead(meant)
    place = interface.place
    what = {"msg": "message", "srv": "service", "action": "action"}[interface.kind]
    if interface.left_out:
        hint = f": {_file(interface)} is not listed in rosidl_generate_interfaces() of its CMakeLists.txt"
    return finding(
        "MSG002",
        place,
        f"{interface.package} defines no {what} '{interface.name}'{hint}",
        help=_cure(interface, names),
        identity=(interface.package, interface.kind, interface.name),
        group=_cause(interface),
        meant=meant,
    )


def _cause(interface: UnknownInterface) -> tuple[str, ...]:
    """What findings have in common that say the same: the file, or the line where the advice is for what it imports."""
    if interface.left_out:
        return ()
    place = interface.place
    line = str(place.line) if interface.elsewhere or _part(interface) is not None else ""
    return place.file, line, interface.package, interface.kind


@folds("MSG002")
def of_one_file(findings: Sequence[Finding]) -> Finding:
    """The finding for all that one file imports in vain, or several of a package of the workspace, with what each was
    perhaps meant to be; the advice is that for the first."""
    first, *others = findings
    names = list(dict.fromkeys(diagnostic.identity[2] for diagnostic in findings))
    here = first.place.file, first.place.line
    lines = {at: other for other in others if (at := (other.place.file, other.place.line)) != here}
    verb = "named" if is_cpp(first.place.file) else "imported"
    rows = tuple(Related(other.place, f"'{other.identity[2]}' is {verb} here") for other in lines.values())
    if len(names) == 1:
        return replace(first, related=(*first.related, *rows))
    package, kind, _ = first.identity
    listed = f"{', '.join(repr(name) for name in names[:-1])} and {names[-1]!r}"
    several = {"msg": "messages", "srv": "services", "action": "actions"}[kind]
    hints = [_instead(diagnostic.meant, diagnostic.identity[2]) for diagnostic in findings]
    message = f"{package} defines no {several} {listed}{''.join(dict.fromkeys(hints))}"
    help = first.help
    if first.group[0] == _ELSEWHERE:
        help = (help or "").replace("take it", "take them").replace("defines it", "defines them")
    return replace(first, message=message, help=help, related=(*first.related, *rows), identity=(package, kind, *names))


def _instead(meant: str, name: str = "") -> str:
    """The words for an interface that was perhaps meant: one of this kind, by one of several names, or of another."""
    if not meant:
        return ""
    if "/" in meant:
        return f"; there is {meant}"
    by = f" by '{name}'" if name else ""
    return suggestions.meant(f"'{meant}'{by}")


def _part(interface: UnknownInterface) -> tuple[str, str] | None:
    """The service and its part that ROS 1 gave a class of its own: ``Empty`` and ``Request`` of ``EmptyRequest``."""
    for part in ("Request", "Response"):
        service = interface.name.removesuffix(part)
        if interface.kind == "srv" and service != interface.name and service in interface.others:
            return service, part
    return None


def _file(interface: UnknownInterface) -> str:
    return f"{interface.kind}/{interface.name}.{interface.kind}"


def _renamed(name: str) -> str:
    """How an interface of ROS 2 would be called that is called otherwise in ROS 1: ``VfrHud`` for ``VFR_HUD``."""
    words = filter(None, name.split("_"))
    return "".join(word.capitalize() if word.isupper() else word[:1].upper() + word[1:] for word in words)


def _cure(interface: UnknownInterface, names: Sequence[str]) -> str:
    """The import line to write where the interface is found elsewhere, what the build lacks, or what there is."""
    if interface.left_out and not is_interface_name(interface.name):  # rosidl refuses the file: no build comes through
        file = f"{interface.kind}/{_renamed(interface.name)}.{interface.kind}"
        return f"rename it to {file}, as names of interfaces have no '_', and list that in rosidl_generate_interfaces()"
    if interface.left_out:
        return f'add "{_file(interface)}" to rosidl_generate_interfaces() in the CMakeLists.txt of {interface.package}'
    is_of_cpp = is_cpp(interface.place.file)
    if (part := _part(interface)) is not None and not is_of_cpp:
        return f"in ROS 2 it belongs to the service: import {part[0]} and write {part[0]}.{part[1]}()"
    elsewhere = interface.elsewhere if len(names) == len(interface.others) else ()
    if is_of_cpp:
        return _cure_in_cpp(interface, elsewhere, names)
    if len(elsewhere) == 1:
        return f"write `from {elsewhere[0]}.{interface.kind} import {interface.name}`: that package defines it"
    if elsewhere:
        return f"import it from a package that defines it: {listed(elsewhere, shown=_SHOWN)}"
    if not names and not is_interface_name(interface.name):
        return f"look for {_renamed(interface.name)}: the names of interfaces have no '_'"
    when = "that function runs" if interface.in_function else "the node starts"
    return f"the import fails when {when}; {interface.package}.{interface.kind} has {listed(names, shown=_SHOWN)}"


def _cure_in_cpp(interface: UnknownInterface, elsewhere: Sequence[str], names: Sequence[str]) -> str:
    if len(elsewhere) == 1:
        return f"take it from {elsewhere[0]}::{interface.kind}, which defines it"
    if elsewhere:
        return f"take it from a package that defines it: {listed(elsewhere, shown=_SHOWN)}"
    return f"this does not compile; {interface.package}::{interface.kind} has {listed(names, shown=_SHOWN)}"
