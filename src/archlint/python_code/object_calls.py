"""Calls of methods of objects of the workspace's classes with arguments that their parameters do not take."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.python_code.made_objects import calls_of_objects, class_of_object
from archlint.python_code.misfits import OwnCall
from archlint.python_code.own_calls import RefusedOwnCall, method_meant, refusal_of

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex


def refused_object_calls(workspace: WorkspaceIndex) -> Iterator[RefusedOwnCall]:
    """Every such call in the files that were asked for, but for test code."""
    for file, _ in workspace.code.judged():
        path = file.relative
        if file.kind not in ("python", "launch_python") or workspace.roles.is_test(path):
            continue
        for called in calls_of_objects(workspace, path) or ():
            if called.starred or "TypeError" in called.forgiven:
                continue
            cls = class_of_object(workspace, path, called)
            meant = None if cls is None else method_meant(workspace, cls, called.name)
            call = OwnCall(called.written, called.call, None, called.given, called.keywords)
            refused = refusal_of(workspace, path, call, meant)
            if refused is not None:
                yield refused


__all__ = ["refused_object_calls"]
