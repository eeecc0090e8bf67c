"""Interfaces that code imports, and those that are not there."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.interpreter.values import Unknown, Value
from archlint.libraries.rclpy import names
from archlint.model import UnknownInterface
from archlint.ros.interfaces import is_interface_name, parts_of_type
from archlint.syntax.interfaces import INTERFACE_KINDS, KIND_OF_SUFFIX

if TYPE_CHECKING:
    from archlint.libraries.run import Run
    from archlint.syntax.facts import Span
    from archlint.syntax.interfaces import InterfaceKind


def note_interface(run: Run, path: str, span: Span) -> None:
    """Note an interface that the code takes from a package which does not define it.  ``path`` is dotted."""
    interface, section_name = names.interface_and_section(path)
    if run.interfaces is None or interface is None or section_name or not _imported_for_sure(run) or run.branch_arms:
        return
    package, kind, name = parts_of_type(interface)
    if not is_missing(run, path):
        return
    if run.activation.module.file.kind == "cpp" and not _is_judged_in_cpp(run, package, name, span):
        return
    _note(run, package, kind, name, span)


_NOWHERE = (1, 1)
"""Where the lowering puts what stands behind a condition of the preprocessor alone."""


def _is_judged_in_cpp(run: Run, package: str, name: str, span: Span) -> bool:
    """Whether a name of C++ is that of an interface: ``Foo_Request`` and ``to_yaml`` are others."""
    assert run.interfaces is not None
    return span[:2] != _NOWHERE and is_interface_name(name) and run.interfaces.is_known(package)


_HEADER = re.compile(r"(\w+)/(msg|srv|action)/([a-z][a-z0-9]*(?:_[a-z0-9]+)*)\.hpp")


def note_header(run: Run, path: str, span: Span) -> None:
    """Note the header of an interface that its package, one of the workspace, does not define."""
    header = _HEADER.fullmatch(path)
    if header is None or run.interfaces is None or not _imported_for_sure(run) or run.branch_arms:
        return
    package, kind = header[1], KIND_OF_SUFFIX[header[2]]
    name = run.interfaces.missing_header(package, kind, header[3])
    if name is not None:
        _note(run, package, kind, name, span)


def _note(run: Run, package: str, kind: InterfaceKind, name: str, span: Span) -> None:
    assert run.interfaces is not None
    others = tuple(
        f"{package}/{other}/{name}" for other in INTERFACE_KINDS if run.interfaces.defines(package, other, name)
    )
    run.program.unknown_interfaces.append(
        UnknownInterface(
            run.place(span),
            package,
            kind,
            name,
            (*others, *run.interfaces.of_package(package, kind)),
            run.interfaces.is_left_out(package, kind, name),
            run.interfaces.packages_with(kind, name),
            run.activation.scope.kind != "module",
        )
    )


def is_missing(run: Run, path: str) -> bool:
    """Whether a dotted path names an interface that its package certainly does not define: nothing is known of it."""
    interface, section_name = names.interface_and_section(path)
    if run.interfaces is None or interface is None or section_name:
        return False
    package, kind, name = parts_of_type(interface)
    return not names.is_part_of_interface(name) and run.interfaces.defines(package, kind, name) is False


def missing_interface(run: Run, path: str) -> Value | None:
    """What stands for an interface that is missing; None where it is there, or not known."""
    if not is_missing(run, path):
        return None
    interface, _ = names.interface_and_section(path)
    package, _, name = path.split(".")[:3]
    return Unknown(f"{package} defines no '{name}'", interface=interface)


def star_sources(run: Run, packages: Sequence[str], name: str) -> Sequence[str]:
    """Those of some foreign packages that a star import may take a name from.

    Interface packages hold class names only, and the table of interfaces says which of them have this one; where none
    has it, it comes from another package.
    """
    interfaces = [package for package in packages if _has_interfaces(package)]
    if not interfaces or not name[:1].isupper() or run.interfaces is None:
        return interfaces if interfaces and name[:1].isupper() else list(packages)
    defines = run.interfaces.defines
    verdicts = {p: defines(*parts_of_type("/".join([*p.rsplit(".", 1), name]))) for p in interfaces}
    sure = [p for p in interfaces if verdicts[p]]
    perhaps = [p for p in interfaces if verdicts[p] is None]
    return sure or perhaps or [p for p in packages if p not in verdicts]


def _has_interfaces(package: str) -> bool:
    """Whether a package is the one of a kind of interfaces, ``std_msgs.msg``.  C++ may include
    ``<std_msgs/msg/string.msg>`` by mistake."""
    above, _, kind = package.rpartition(".")
    return above.isidentifier() and kind in KIND_OF_SUFFIX


def _imported_for_sure(run: Run) -> bool:
    return bool(run.activations) and not any(activation.tries for activation in run.activations)
