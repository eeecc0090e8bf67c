"""Options that commands share, and what they mean for the settings."""

from __future__ import annotations

import argparse
import os
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from archlint.cli import console
from archlint.cli.exits import UsageError
from archlint.counted import counted
from archlint.engine.looked_at import without_plugins
from archlint.suggestions import meant

if TYPE_CHECKING:
    from archlint.config.settings import Settings
    from archlint.engine.executors import ExecutorPool
    from archlint.engine.linked_facts import LinkedFacts
    from archlint.observed.model import Observed


def _group(parser: argparse.ArgumentParser, title: str) -> argparse._ArgumentGroup:
    """The group of options with a title, made where there is none."""
    groups = (group for group in parser._action_groups if group.title == title)
    return next(groups, None) or parser.add_argument_group(title)


def add_paths(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "paths", metavar="PATH", nargs="*", default=[], help="a workspace, a package, a folder or files (default: .)"
    )  # with a default, argparse does not call it required where another word is missing


def add_configuration(parser: argparse.ArgumentParser, with_plugins: bool = False) -> None:
    group = parser.add_argument_group("configuration")
    either = group.add_mutually_exclusive_group()
    either.add_argument("--config", metavar="FILE", help="use this configuration file only")
    either.add_argument("--isolated", action="store_true", help="use no configuration file")
    if with_plugins:
        add_plugins(group)


def add_plugins(parser: argparse._ActionsContainer) -> None:
    parser.add_argument(
        "--plugins",
        action=argparse.BooleanOptionalAction,
        help="run the plugins that the configuration names, code of the repository among them, or leave them out "
        "(default: what ARCHLINT_PLUGINS=1 or 0 says)",
    )


def plugins_of(arguments: argparse.Namespace) -> bool | None:
    """What the command line or ARCHLINT_PLUGINS says of plugins; None where neither does.

    Raises :class:`UsageError`.
    """
    given: bool | None = arguments.plugins
    if given is not None or "ARCHLINT_PLUGINS" not in os.environ:
        return given
    from archlint.plugins.permission import said_by  # hardly anybody has plugins

    try:
        return said_by(os.environ)
    except ValueError as error:
        raise UsageError(str(error)) from None


def plugins_here(arguments: argparse.Namespace) -> str:
    """Have the rules of the plugins that the configuration of this folder names, where somebody allows them to run;
    returns a sentence on those that are left out."""
    from archlint.config.settings import ConfigurationError, load  # as above

    try:
        settings = load(Path(), plugins=plugins_of(arguments) or False)
    except ConfigurationError as error:
        if arguments.plugins:
            raise UsageError(str(error)) from None
        return ""  # what archlint's own rules are does not depend on it
    settings.activate_plugins()
    return next(without_plugins(settings), "")


def add_running(parser: argparse.ArgumentParser) -> None:
    group = _group(parser, "running")
    group.add_argument("--no-cache", action="store_true", help="neither read nor write the cache")
    group.add_argument("--cache-dir", metavar="DIR", help="the folder of the cache")
    group.add_argument("--jobs", metavar="N", type=positive, help="the maximum number of processes")


def add_scheduler(parser: argparse.ArgumentParser) -> None:
    _group(parser, "running").add_argument(
        "--scheduler",
        metavar="ADDRESS",
        help="compile and follow programs on the Dask cluster with this scheduler, such as tcp://10.0.0.1:8786 "
        "(needs archlint[dask])",
    )


@contextmanager
def pool_of(arguments: argparse.Namespace) -> Iterator[ExecutorPool | None]:
    """The machines of ``--scheduler``.  Raises :class:`UsageError` where they cannot be used."""
    if arguments.scheduler is None:
        yield None
        return
    from archlint.engine.dask_cluster import dask_cluster  # most runs are on one machine
    from archlint.engine.executors import PoolError

    try:
        with dask_cluster(arguments.scheduler) as pool:
            yield pool
    except PoolError as error:
        raise UsageError(f"--scheduler: {error}") from None
    if pool.lost and not arguments.quiet:
        console.note(
            f"archlint: warning: {counted(pool.lost, 'task')} did not come back from the cluster and ran here instead"
        )


def add_launch(parser: argparse.ArgumentParser) -> None:
    _group(parser, "what is read").add_argument(
        "--launch",
        metavar=("FILE", "ARG:=VALUE"),
        nargs="+",
        help="only the system that this launch file starts, with these arguments",
    )


def add_facts(parser: argparse.ArgumentParser) -> None:
    _group(parser, "what is read").add_argument(
        "--facts",
        metavar="DIR",
        nargs="+",
        help="link what `archlint facts` has written in these folders, and read no sources",
    )


def linked_of(arguments: argparse.Namespace) -> LinkedFacts | None:
    """The facts in the folders of ``--facts``.  Raises :class:`UsageError` where they cannot be used."""
    if getattr(arguments, "facts", None) is None:
        return None
    if arguments.paths:
        raise UsageError("--facts: no PATH can be given with it: what is checked is what the facts are about")
    from archlint.engine.facts_folder import FactsError  # most runs have none
    from archlint.engine.linked_facts import LinkedFacts

    try:
        return LinkedFacts.of_folders(arguments.facts)
    except FactsError as error:
        raise UsageError(f"--facts: {error}") from None


def add_observed(parser: argparse.ArgumentParser) -> None:
    _group(parser, "what is read").add_argument(
        "--observed",
        metavar="FILE",
        help="compare the system with a running one: a recording (`archlint observe`), the "
        "metadata.yaml of a bag, or a Graph message of rosgraph_monitor_msgs as JSON",
    )


def observed_of(arguments: argparse.Namespace) -> Observed | None:
    """What the file of ``--observed`` says.  Raises :class:`UsageError` where it cannot be read."""
    if arguments.observed is None:
        return None
    from archlint.observed.read import CannotRead, read  # most runs have no recording

    try:
        return read(arguments.observed)
    except CannotRead as error:
        raise UsageError(f"--observed: {error}") from None


def launch_of(arguments: argparse.Namespace) -> tuple[str | None, tuple[tuple[str, str], ...]]:
    """The launch file from the working directory and its arguments; words after them are paths.

    Raises :class:`UsageError` for a file that does not exist.
    """
    if not arguments.launch:
        return None, ()
    file, *words = arguments.launch
    if not (getattr(arguments, "facts", None) or Path(file).is_file()):
        from archlint.cli.near_paths import no_such_launch_file  # as below

        raise UsageError(no_such_launch_file(file, words))
    unlike = next((word for word in words if "=" in word and ":=" not in word and not Path(word).exists()), None)
    if unlike is not None:
        raise UsageError(f"--launch: write {unlike.replace('=', ':=', 1)}, as for `ros2 launch`, and not {unlike}")
    given = [word for word in words if ":=" in word]
    arguments.paths = [*arguments.paths, *(word for word in words if ":=" not in word)]
    pairs = tuple((name, value) for name, _, value in (word.partition(":=") for word in given))
    return Path(os.path.relpath(file)).as_posix(), pairs


def add_talking(parser: argparse.ArgumentParser) -> None:
    group = parser.add_argument_group("messages")
    group.add_argument("-q", "--quiet", action="store_true", help="print the result only: no progress, no summary")
    group.add_argument(
        "-v",
        "--verbose",
        action="store_true",
        help="show the slowest files and programs, and tracebacks of internal errors",
    )
    group.add_argument("--color", metavar="WHEN", choices=("auto", "always", "never"), default="auto",
                       help="auto (default), always or never; NO_COLOR is honoured")  # fmt: skip


def positive(text: str) -> int:
    if not text.isdecimal() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"must be a number of at least 1, not {text}")
    return int(text)


def paths_of(arguments: argparse.Namespace) -> tuple[str, ...]:
    """The paths given, ``.`` without any.  Raises :class:`UsageError` for one that does not exist."""
    paths: Sequence[str] = arguments.paths or ["."]
    for path in paths:
        if not path:
            raise UsageError("an empty word is no path: is a variable of the shell unset?")
        if not os.path.exists(path):  # of a name that is too long, Path.exists raises an error
            from archlint.cli.near_paths import no_such_path  # looks around, and most paths are right

            words = getattr(arguments, "words", [])
            raise UsageError(no_such_path(path, words[:1] == [path], words[1:]))
    return tuple(paths)


def settings_of(arguments: argparse.Namespace, start: str, plugins: bool | None = False) -> Settings:
    """The settings for what is checked at ``start``, with the command line on top, and with the rules of the plugins
    where these run (:func:`archlint.config.settings.load`).

    Raises :class:`UsageError` for a configuration that cannot be used.
    """
    from archlint.config.settings import ConfigurationError, Settings, load  # `explain` and `rules` have none

    file = None if arguments.config is None else Path(arguments.config)
    try:
        settings = Settings() if arguments.isolated else load(Path(start), file, plugins=plugins)
    except ConfigurationError as error:
        if file is not None and not file.exists():
            from archlint.cli.near_paths import near_path  # as above

            raise UsageError(f"{error}{meant(near_path(arguments.config))}") from None
        raise UsageError(str(error)) from None
    settings.activate_plugins()
    cache_dir = getattr(arguments, "cache_dir", None)
    if cache_dir is not None:
        settings = _changed(settings, "cache-dir", cache_dir=cache_dir)
    if getattr(arguments, "all_files", False):
        origins = {**settings.origins, "unused-files": "command line"}
        settings = replace(settings, origins=origins, unused_files=True)
    return _with_selection(settings, arguments)


def _with_selection(settings: Settings, arguments: argparse.Namespace) -> Settings:
    """The settings with ``--select``, ``--extend-select`` and ``--ignore`` as the last layer."""
    from archlint.config.selection import Layer

    given = {
        key: split_selectors(getattr(arguments, key.replace("-", "_"), None), f"--{key}")
        for key in ("select", "extend-select", "ignore")
    }
    layer = Layer(given["select"], given["extend-select"] or (), given["ignore"] or ())
    if layer == Layer():
        return settings
    for key in (key for key, value in given.items() if value is not None):
        settings = _changed(settings, key)
    return replace(settings, layers=(*settings.layers, layer))


def split_selectors(values: Sequence[str] | None, option: str) -> tuple[str, ...] | None:
    """Codes from a repeatable option with commas; None where it was not given."""
    if values is None:
        return None
    from archlint.config.values import unknown_rule
    from archlint.rulebook import may_be_rule

    selectors = tuple(part.strip() for value in values for part in value.split(",") if part.strip())
    if not selectors and option == "--select":
        raise UsageError(f"{option}: no rule is named, so nothing would be checked")
    for selector in selectors:
        if not may_be_rule(selector):
            raise UsageError(f"{option}: {unknown_rule(selector)}")
    return selectors


def _changed(settings: Settings, key: str, **values: str) -> Settings:
    origins = {**settings.origins, key: "command line"}
    return replace(settings, origins=origins, cache_dir=values.get("cache_dir", settings.cache_dir))
