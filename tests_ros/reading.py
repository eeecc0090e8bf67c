"""What archlint says: the nodes of ``archlint graph --format json --all``, and what a launch file starts them with."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import yaml

from archlint.config.settings import load
from archlint.engine.pipeline import Request
from archlint.engine.pipeline import graph as system_of
from archlint.launch.parameter_sources import ParameterFileUse, ParameterSetting
from archlint.launch.started import Started
from archlint.render.json import render
from archlint.syntax.parameter_files import NotKnown

if TYPE_CHECKING:
    from archlint.systems.model import System
    from archlint.systems.nodes import Node

Entity = dict[str, Any]

not_built: set[str] = set()
"""The nodes of this test run that are in C++, and are left out: PyPI has no wheel of rclcpp."""


def graph(folder: Path, *paths: str, distro: str | None = None) -> list[Entity]:
    """The nodes in Python that archlint lists for ``paths``, from ``folder``."""
    return _nodes(_system(folder, paths or (".",), distro))


@dataclass(frozen=True)
class Process:
    """A process that a launch file starts, with the words of its command line after the executable."""

    package: str
    executable: str
    arguments: tuple[str, ...]


def launched(
    folder: Path, launch: str, given: Mapping[str, str], scratch: Path, distro: str | None = None
) -> tuple[list[Entity], list[Process]]:
    """The nodes in Python of a launch file's system, and its processes with such a node.

    The command lines are those that launch_ros makes; parameters of a dict go to files in ``scratch``, as it does.
    """
    system = _system(folder, (".",), distro, launch, tuple(given.items()))
    started = {id(node.started): node.started for node in system.nodes if node.started and _can_run(node)}
    processes = [_process(one, folder, scratch / f"{number}.yaml") for number, one in enumerate(started.values())]
    return _nodes(system), processes


def _process(started: Started, folder: Path, file: Path) -> Process:
    words = [*_known(started.arguments), "--ros-args", *_known(started.ros_arguments)]
    for rule, text in (("__node", started.name), ("__ns", started.namespace)):
        words += ["-r", f"{rule}:={text.text}"] if text is not None else []
    own: dict[str, Any] = {}
    for parameter in started.parameters:
        if isinstance(parameter, ParameterFileUse):
            assert parameter.reference.source is not None and not own
            words += ["--params-file", str(folder / parameter.reference.source)]
        else:
            assert isinstance(parameter, ParameterSetting) and parameter.name is not None
            assert not isinstance(parameter.value, NotKnown)
            own[parameter.name] = parameter.value
    if own:
        file.write_text(yaml.safe_dump({"/**": {"ros__parameters": own}}))
        words += ["--params-file", str(file)]
    words += [word for one in started.remaps for word in ("-r", f"{one.source.text}:={one.target.text}")]
    package, executable = _known([started.package.text, started.executable.text])
    return Process(package, executable, tuple(words))


def _known(words: list[str | None]) -> list[str]:
    assert None not in words, "only launch files of which all is known can be followed here"
    return [word for word in words if word is not None]


def _system(
    folder: Path,
    paths: tuple[str, ...],
    distro: str | None,
    launch: str | None = None,
    arguments: tuple[tuple[str, str], ...] = (),
) -> System:
    with _inside(folder):
        settings = replace(load(Path(), None), distro=distro)
        request = Request(paths, settings, cached=False, jobs=1, launch=launch, launch_arguments=arguments)
        return system_of(request, everything=True)


def _nodes(system: System) -> list[Entity]:
    nodes: list[Entity] = json.loads(render(system))["nodes"]
    own = [node for node in nodes if node["is_node"] and not node["external"]]
    not_built.update(f"{node['name']} ({node['file']})" for node in own if not _in_python(node["file"]))
    return [node for node in own if _in_python(node["file"])]


def _can_run(node: Node) -> bool:
    return not node.external and node.blueprint is not None and _in_python(node.blueprint.place.file)


def _in_python(file: str) -> bool:
    return file.endswith(".py")


@contextmanager
def _inside(folder: Path) -> Iterator[None]:
    before = Path.cwd()
    os.chdir(folder)
    try:
        yield
    finally:
        os.chdir(before)
