"""Paths that launch finds: of packages and of the launch file itself."""

from __future__ import annotations

import posixpath
from typing import TYPE_CHECKING

from archlint.interpreter.values import Known, Unknown, Value, reason
from archlint.launch.objects import LaunchObject, known_text
from archlint.launch.substitutions.texts import concatenate, each_text

if TYPE_CHECKING:
    from archlint.launch.run import LaunchRun


def package_share(name: str) -> Known:
    """The share folder of a package, as a path that says so."""
    return Known(f"$(find-pkg-share {name})")


def package_prefix(name: str) -> Known:
    """The folder that a package is installed to, as a path that says so."""
    return Known(f"$(find-pkg-prefix {name})")


def share(run: LaunchRun, value: LaunchObject) -> Value:
    return each_text(run.perform(value.argument("package")), package_share)


def prefix(run: LaunchRun, value: LaunchObject) -> Value:
    name = run.perform(value.argument("package"))
    text = known_text(name)
    return Unknown(reason(name)) if text is None else package_prefix(text)


def executable(run: LaunchRun, value: LaunchObject) -> Value:
    package = run.perform(value.argument("package"))
    name = run.perform(value.argument("executable"))
    parts = [Known("$(find-pkg-prefix "), package, Known(")/lib/"), package, Known("/"), name]
    return concatenate(parts)


def here(run: LaunchRun, value: LaunchObject) -> Value:
    return Known(posixpath.dirname(run.file_path))


def this_file(run: LaunchRun, value: LaunchObject) -> Value:
    return Known(run.file_path)
