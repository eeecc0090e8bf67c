"""Paths that launch finds: of packages and of the launch file itself."""

from __future__ import annotations

import posixpath
from typing import TYPE_CHECKING

from archlint.interpreter.values import Instance, Known, Unknown, Value, alternatives, one_of, reason
from archlint.launch.objects import argument
from archlint.launch.substitutions.texts import concatenate

if TYPE_CHECKING:
    from archlint.launch.run import LaunchRun


def package_share(name: str) -> Known:
    """The share folder of a package, as a path that says so."""
    return Known(f"$(find-pkg-share {name})")


def share(run: LaunchRun, value: Instance) -> Value:
    rows = alternatives(run.perform(argument(value, "package")))
    return one_of(package_share(str(n.value)) if isinstance(n, Known) else Unknown(reason(n)) for n in rows)


def prefix(run: LaunchRun, value: Instance) -> Value:
    name = run.perform(argument(value, "package"))
    return Known(f"$(find-pkg-prefix {name.value!s})") if isinstance(name, Known) else Unknown(reason(name))


def executable(run: LaunchRun, value: Instance) -> Value:
    package = run.perform(argument(value, "package"))
    name = run.perform(argument(value, "executable"))
    parts = [Known("$(find-pkg-prefix "), package, Known(")/lib/"), package, Known("/"), name]
    return concatenate(parts)


def here(run: LaunchRun, value: Instance) -> Value:
    return Known(posixpath.dirname(run.file_path))


def this_file(run: LaunchRun, value: Instance) -> Value:
    return Known(run.file_path)
