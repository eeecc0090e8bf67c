"""Launch among the libraries of a launch file's own run, in which its context and its files decide."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import TYPE_CHECKING, Concatenate, ParamSpec

from archlint.interpreter.values import External, Instance, Known, Unknown, Value
from archlint.launch import (
    calls_in_launches,
    file_texts,
    loaded_modules,
    mathematics,
    read_files,
    search_paths,
    tables,
    written_files,
)
from archlint.launch.library import LaunchLibrary
from archlint.launch.objects import LaunchObject, kind_of
from archlint.libraries.api_use import Offers

if TYPE_CHECKING:
    from archlint.interpreter.values import DictValue
    from archlint.launch.run import LaunchRun
    from archlint.libraries.run import Run
    from archlint.syntax import facts


_P = ParamSpec("_P")
_CONSTANTS = {
    **mathematics.CONSTANTS,
    **{f"os.{where}{name}": Known(text) for where in ("", "path.") for name, text in (("sep", "/"), ("pathsep", ":"))},
}
"""Robots run Linux."""
_OF_PACKAGE = re.compile(r"\$\(find-pkg-share ([\w.-]+)\)/")
_SAID_BY_COMPONENTS = {
    "package": "package",
    "node_plugin": "plugin",
    "node_name": "name",
    "node_namespace": "namespace",
}
"""The properties of a ``ComposableNode`` that give back an argument, and which."""


class LaunchFileLibrary(LaunchLibrary):
    """What Python's own library, rclpy and launch are known to do in the run of a launch file."""

    def __init__(self, run: LaunchRun) -> None:
        super().__init__(run)
        known = LaunchLibrary.offers
        self.offers = Offers(
            known.row,
            {**known.effects, **{name: _of(run, act) for name, act in calls_in_launches.EFFECTS.items()}},
            {**known.methods, **{name: _of(run, act) for name, act in calls_in_launches.METHODS.items()}},
            {**known.plain, **{name: _of(run, act) for name, act in calls_in_launches.PLAIN.items()}},
            known.bases,
        )
        self._launch = run

    def attribute_of_object(self, value: Instance, cls: External, name: str) -> Value:
        """Also what a component says of itself: ``description.node_name``."""
        if name == "name" and written_files.is_written_file(value):
            return written_files.name_of(value)
        if name == "loader" and cls.path == loaded_modules.SPEC:
            return loaded_modules.loader_of(self._launch, value)
        given = value.argument(_SAID_BY_COMPONENTS.get(name, "")) if isinstance(value, LaunchObject) else None
        is_component = kind_of(value) == tables.LaunchClass.COMPOSABLE_NODE
        return given if is_component and given is not None else super().attribute_of_object(value, cls, name)

    def imported(self, path: str, span: facts.Span) -> Value:
        return _CONSTANTS.get(path) or super().imported(path, span)

    def attribute_of_external(self, value: External, name: str) -> Value:
        return _CONSTANTS.get(f"{value.path}.{name}") or super().attribute_of_external(value, name)

    def expects_to_read(self) -> bool:
        """What a launch file reads of the workspace is there, for all that is seen."""
        return True

    def note_key(self, container: DictValue, key: Known, expression: facts.Subscript) -> None:
        read_files.note_key(self._launch, container, key, expression)

    def note_item(self, container: str, key: Value, value: Value, target: facts.Subscript) -> None:
        if container == "os.environ" and key.text is not None:
            search_paths.note_assigned(self._launch, key.text, value, self._launch.place(target.span))

    def matches(self, folder: str, pattern: str) -> list[str] | None:
        return read_files.matches(self._launch, folder, pattern)

    def opened(self, path: Known) -> Value:
        return file_texts.opened(self._launch, path)

    def asked_for_file(self, path: str) -> Value:
        unknown = super().asked_for_file(path)
        package = _OF_PACKAGE.match(path)
        elsewhere = package is not None and not self._launch.paths.has(package[1])
        if elsewhere or path.startswith(("/", "~", "$(find-pkg-prefix ")):
            return Unknown(read_files.FILE_OF_THE_MACHINE)
        # What is not there is LCH004's: the launch file may stop where it asks.
        return Known(True) if read_files.is_there(self._launch, path) else unknown


def _of(launch: LaunchRun, act: Callable[Concatenate[LaunchRun, _P], Value]) -> Callable[Concatenate[Run, _P], Value]:
    """What happens in a launch, for whoever passes its run as that of any code."""

    def in_launch(run: Run, /, *args: _P.args, **kwargs: _P.kwargs) -> Value:
        return act(launch, *args, **kwargs)

    return in_launch


__all__ = ["LaunchFileLibrary"]
