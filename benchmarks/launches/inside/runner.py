"""Runs jobs, each in a process of its own that may do nothing but compute: ``python runner.py SETTINGS.json``.

SETTINGS has ``install`` (the share folders), ``launch`` (a checkout of ros2/launch), ``work`` (a folder to write in)
and ``jobs``. A job is a ``setup.py`` (``{"setup": path}``) or a launch file (``{"launch": path}``); for each, one
line of JSON goes to the standard output.
"""

from __future__ import annotations

import json
import os
import re
import select
import signal
import sys
import time
from typing import Any

SECONDS = 60
MISSING = re.compile(r"missing required argument '([^']+)'|launch configuration '([^']+)' does not exist")
GIVEN = "given"
"""The value of an argument that has no default, and of a launch configuration that nothing sets."""
CHOICES = re.compile(r"Argument \"([^\"]+)\" provided value \"given\" is not valid. Valid options are: \['([^']+)'")
NO_VARIABLE = re.compile(r"KeyError: '([A-Z][A-Z0-9_]+)'|[Ee]nvironment variable '(\w+)'")


def main() -> None:
    with open(sys.argv[1], encoding="utf-8") as file:
        settings = json.load(file)
    sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
    if any("launch" in job for job in settings["jobs"]):
        _load(settings)
    for job in settings["jobs"]:
        runs = [apart(_setup, job["setup"])] if "setup" in job else _runs(settings, job["launch"])
        print(json.dumps({**job, "runs": runs}), flush=True)


def _load(settings: dict[str, Any]) -> None:
    """Load launch once, for all processes that are made from here."""
    from inside import stand_ins

    places = stand_ins.Places(settings["install"], settings["work"], settings["launch"], settings["libraries"])
    settings["places"] = places
    settings["environment"] = dict(os.environ)
    stand_ins.packages(places)
    stand_ins.modules()
    stand_ins.descriptions(places)
    import launch_xml
    import launch_yaml
    from inside import recorder  # noqa: F401
    from launch.frontend import Parser
    from launch.frontend.parse_substitution import parse_substitution
    from launch_ros.actions import node

    Parser.extensions_loaded = True
    Parser.frontend_parsers = {"xml": launch_xml.Parser, "yaml": launch_yaml.Parser}
    parse_substitution("$(var once)")  # builds the grammar
    node.g_entry_points_impl = {}  # no extensions: looking for them takes long


def _runs(settings: dict[str, Any], path: str) -> list[dict[str, Any]]:
    """One launch file with its defaults, and once for each other value."""
    os.environ.clear()
    os.environ.update(settings["environment"])
    given: dict[str, str] = {}
    invented: list[str] = []
    for _ in range(20):
        first = apart(_launch, settings, path, given)
        missing = MISSING.search(first["error"] or "")
        variable = NO_VARIABLE.search(first["error"] or "")
        choices = CHOICES.search(first["error"] or "")
        if "but got 'given'" in (first["error"] or ""):
            given = {name: "true" if value == GIVEN else value for name, value in given.items()}
        elif choices is not None:
            given = {**given, choices[1]: choices[2]}
        elif missing is not None and (name := missing[1] or missing[2]) not in given:
            given = {**given, name: GIVEN}
        elif variable is not None and (name := variable[1] or variable[2]) not in os.environ:
            os.environ[name] = "of_the_environment"
            invented.append(name)
        else:
            break
    others = first.pop("others", [])
    found = [{**first, "arguments": given}]
    for arguments in others:
        run = apart(_launch, settings, path, arguments)
        run.pop("others", None)
        found.append({**run, "arguments": arguments})
    for run in found:
        run["environment"] = sorted({*run.get("environment", ()), *invented})
    return found


def apart(function: Any, *args: Any) -> dict[str, Any]:
    """What a function returns, called in a process that ends with it."""
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(reading)
        _quiet()
        try:
            answer = function(*args)
        except BaseException as error:
            answer = {"error": f"{type(error).__name__}: {error}"[:600]}
        with os.fdopen(writing, "wb") as pipe:
            pipe.write(json.dumps(answer, default=str).encode())
        os._exit(0)
    os.close(writing)
    return json.loads(_read(reading, child) or b'{"error": "no answer in time"}')


def _quiet() -> None:
    nothing = os.open(os.devnull, os.O_RDWR)
    for number in (0, 1, 2):
        os.dup2(nothing, number)


def _read(reading: int, child: int) -> bytes:
    chunks, end = [], time.monotonic() + SECONDS
    while (left := end - time.monotonic()) > 0 and select.select([reading], [], [], left)[0]:
        chunk = os.read(reading, 65536)
        if not chunk:
            break
        chunks.append(chunk)
    else:
        os.kill(child, signal.SIGKILL)
        chunks = []
    os.close(reading)
    os.waitpid(child, 0)
    return b"".join(chunks)


# ----------------------------------------------------------------------------------------------- what a process does


def _launch(settings: dict[str, Any], path: str, arguments: dict[str, str]) -> dict[str, Any]:
    import launch
    from inside import asked, guard, recorder, stand_ins

    made = recorder.Recorder(settings["places"])
    asked.follow(launch)
    recorder.follow(made)
    stand_ins.Environment.follow()
    guard.install()
    stand_ins.sort_folders()
    os.chdir(settings["work"])
    sys.argv = _command_line(settings["install"], path, arguments)
    error = None
    try:
        made.run(path, arguments)
    except BaseException as raised:
        error = f"{type(raised).__name__}: {raised}"[:600]
    return {
        "nodes": made.nodes,
        "error": None if error is None else settings["places"].shown(error),
        "absent": sorted(stand_ins.absent),
        "not_there": sorted(set(made.not_there)),
        "environment": sorted(stand_ins.Environment.missing),
        "others": asked.others(arguments),
    }


def _command_line(install: str, path: str, arguments: dict[str, str]) -> list[str]:
    """The words of ``ros2 launch package file name:=value …``."""
    package = os.path.relpath(path, install).partition(os.sep)[0]
    given = [f"{name}:={value}" for name, value in arguments.items()]
    return ["ros2", "launch", package, os.path.basename(path), *given]


def _setup(path: str) -> dict[str, Any]:
    """What a ``setup.py`` gives to ``setup()``."""
    import runpy

    import setuptools
    from inside import guard

    given: dict[str, Any] = {}
    setuptools.setup = lambda **keywords: given.update(keywords)
    guard.install()
    folder = os.path.dirname(path)
    os.chdir(folder)
    sys.path.insert(0, folder)
    sys.argv = ["setup.py", "install"]
    try:
        runpy.run_path(path, run_name="__main__")
    except BaseException as raised:
        given.setdefault("error", f"{type(raised).__name__}: {raised}"[:300])
    rows = [[str(folder), [str(file) for file in files]] for folder, files in given.get("data_files") or ()]
    packages = [str(name) for name in given.get("packages") or ()]
    return {
        "data_files": rows,
        "packages": packages,
        "package_dir": {str(k): str(v) for k, v in (given.get("package_dir") or {}).items()},
        "error": given.get("error") if isinstance(given.get("error"), str) else None,
    }


if __name__ == "__main__":
    main()
