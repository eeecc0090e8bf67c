"""What the options that commands share ask of a run."""

from __future__ import annotations

import argparse

from archlint.cli.options import launch_of, linked_of, paths_of, settings_of
from archlint.engine.request import Request


def request_of(arguments: argparse.Namespace, plugins: bool | None = False) -> Request:
    """What is to be read, and how; the rest of a request is the command's own.  ``plugins`` is that of
    :func:`archlint.cli.options.settings_of`.

    Raises :class:`UsageError` for an option, a path or a configuration that cannot be used.
    """
    launch, launch_arguments = launch_of(arguments)  # first: the words behind a launch file may be paths
    linked = linked_of(arguments)
    paths = paths_of(arguments)
    return Request(
        paths if linked is None else tuple(arguments.facts),
        settings_of(arguments, paths[0], plugins),
        cached=not arguments.no_cache and linked is None,
        jobs=arguments.jobs,
        launch=launch,
        launch_arguments=launch_arguments,
        linked=linked,
    )


__all__ = ["request_of"]
