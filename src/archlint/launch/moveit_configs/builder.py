"""One builder: the object of a run, the files of its package, and what it has collected so far.

Source: ``launch_param_builder`` and ``moveit_configs_utils`` of MoveIt 2 (branches jazzy and main).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter import containers
from archlint.interpreter.values import (
    ENTRIES,
    NONE,
    DictValue,
    Entries,
    Instance,
    Known,
    Unknown,
    Value,
    reason,
)
from archlint.launch import read_files
from archlint.launch.objects import known_text
from archlint.launch.substitutions.paths import package_share

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.launch.run import LaunchRun


SEMANTIC_FILE = "path of the SRDF"
"""Where the store has it, of a builder and of what it makes."""


class Builder:
    """One builder: the object of a run, and what it was made with."""

    def __init__(self, run: LaunchRun, instance: Instance) -> None:
        self.run = run
        self.instance = instance
        robot, prefix, package = given_by(instance.arguments, "robot_name", "robot_description", "package_name")
        self.robot = known_text(robot)
        self.prefix = known_text(prefix) if prefix is not None else "robot_description"
        named = package if package not in (None, NONE) else None
        self.package = known_text(named) if named is not None else self.robot and f"{self.robot}_moveit_config"

    # ------------------------------------------------------------------------------------------- what it has

    def part(self, name: str) -> DictValue | None:
        """What is collected under a name so far; an open dict where a branch that is not decided has collected it."""
        collected = self.run.store.get(self.instance.key, slot(name))
        if collected in (None, NONE):
            return None
        return collected if isinstance(collected, DictValue) else self.open_dict()

    def forget(self, *names: str) -> None:
        """Begin without these parts."""
        for name in names:
            self.run.store.set(self.instance.key, slot(name), NONE)

    def keep(self, name: str, value: DictValue) -> None:
        self.run.store.set(self.instance.key, slot(name), value)

    def dict_of(self, values: dict[str, Value], open_: bool = False) -> DictValue:
        return containers.dict_of_names(self.run, values, open_)

    def prefixed(self, suffix: str, value: Value) -> DictValue:
        """A dict with one entry, whose key begins with the name of the robot description."""
        return self.open_dict() if self.prefix is None else self.dict_of({self.prefix + suffix: value})

    def open_dict(self) -> DictValue:
        """A dict of which nothing is known."""
        return self.dict_of({}, open_=True)

    # -------------------------------------------------------------------------------------------------- files

    @property
    def share(self) -> str | None:
        return None if self.package is None else str(known_text(package_share(self.package)))

    def path(self, given: Value | None, default: str | None) -> str | None:
        """The path that a method is given, below the package; None where it is not known."""
        below = default if given in (None, NONE) else known_text(self.run.perform(given))
        if below is None or self.share is None:
            return None
        return below if below.startswith(("$(", "/")) else f"{self.share}/{below}"

    def is_there(self, path: str | None) -> bool | None:
        return None if path is None else read_files.is_there(self.run, path)

    def yaml(self, path: str | None) -> DictValue:
        """The dict in a YAML file; an open one where it is not known."""
        content = Unknown("a path") if path is None else read_files.yaml_file(self.run, Known(path))
        return content if isinstance(content, DictValue) else self.open_dict()

    def names(self, ending: str) -> list[str] | None:
        """What the names of the package's configuration files have before an ending, sorted."""
        files = None if self.package is None else self.run.paths.names_in(self.package, "config")
        return None if files is None else [name.removesuffix(ending) for name in files if name.endswith(ending)]


def entry(run: LaunchRun, value: Value | None, name: str) -> Value | None:
    """``value.get(name)``: None where there is none, an unknown value where that is not known."""
    entries = None if value is None else value.entries(run)
    if entries is None:
        return None if value is None else Unknown(reason(value))
    row = entries.entries.get(Known(name).entry_key() or "")
    return row[1] if row is not None else Unknown("a dict that is only partly known") if entries.open else None


def update(run: LaunchRun, target: DictValue, more: DictValue) -> None:
    """``target.update(more)``."""
    first, second = target.entries(run), more.entries(run)
    run.store.set(target.key, ENTRIES, Entries({**first.entries, **second.entries}, first.open or second.open))


def slot(name: str) -> str:
    return f"collected {name}"


def given_by(arguments: dict[str, Value], *names: str) -> list[Value | None]:
    """Arguments by name or position."""
    return [arguments.get(name, arguments.get(str(number))) for number, name in enumerate(names)]


def arguments(site: CallSite, *names: str) -> list[Value | None]:
    return given_by({**{str(number): value for number, value in enumerate(site.args)}, **site.keywords}, *names)


__all__ = ["SEMANTIC_FILE", "Builder", "arguments", "entry", "update"]
