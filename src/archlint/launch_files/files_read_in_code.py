"""Parameter files that code reads itself, or tests do: what stands there is used, though no node declares it."""

from __future__ import annotations

import posixpath
from collections.abc import Collection, Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import once_for_each_file
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in
from archlint.syntax.walk import called_name

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_LOADERS = frozenset({"safe_load", "full_load", "unsafe_load", "load"})
_CPP_LOADER = "LoadFile"


def is_read_in_code(workspace: WorkspaceIndex | None, file: str, key: str) -> bool:
    """Whether code that names a YAML file loads YAML, and so may use what is there: a node all of it, be it in C++
    (``YAML::LoadFile(…)``), a launch file what it asks for by ``key``."""
    if workspace is None:
        return False
    name = posixpath.basename(file)
    if any(workspace.code.mentions(path, name) for path in workspace.code.cpp_files_that_mention(_CPP_LOADER)):
        return True
    readers = (path for path in workspace.code.files_that_mention("yaml") if workspace.code.mentions(path, name))
    if any(_keys_asked_for(workspace, path) is not None for path in readers):
        return True
    launches = (path for path in workspace.launch_files.all() if path.endswith(".py"))
    return any(
        key in (_keys_asked_for(workspace, path) or ()) for path in launches if workspace.code.mentions(path, name)
    )


def reader_in_code(workspace: WorkspaceIndex, file: str) -> str | None:
    """A launch file in Python that names a YAML file and loads YAML: it takes what is there as it is."""
    name = posixpath.basename(file)
    launches = (path for path in workspace.launch_files.all() if path.endswith(".py"))
    readers = (path for path in launches if workspace.code.mentions(path, name))
    return next((path for path in sorted(readers) if _keys_asked_for(workspace, path) is not None), None)


def is_for_a_test(workspace: WorkspaceIndex, file: str, name: str) -> bool:
    """Whether a launch file of test code, which is not judged, names a parameter file and a node."""
    words = (posixpath.basename(file), name)
    texts = [workspace.tree.text(path) or "" for path in workspace.launch_files.of_tests()]
    return any(all(word in text for word in words) for text in texts)


def is_taken_out_again(workspace: WorkspaceIndex | None, file: str, name: str) -> bool:
    """Whether a launch file in Python takes a value out of a dict by this name itself: it goes by what it sets there,
    and gives the dict to a node for the rest of it."""
    return workspace is not None and name in (_keys_read(workspace, file) or ())


@once_for_each_file
def _keys_read(file_facts: facts.Facts) -> frozenset[str]:
    every = [*everything_in(file_facts.body)]
    changed = {Itself[facts.Base](target) for part in every if isinstance(part, _CHANGES) for target in _targets(part)}
    return frozenset(text for key in _keys(file_facts.body, changed) if (text := key.text) is not None)


_CHANGES = (facts.Assign, facts.Augmented, facts.Delete)


def _targets(statement: facts.Assign | facts.Augmented | facts.Delete) -> Sequence[facts.Expr]:
    return [statement.target] if isinstance(statement, facts.Augmented) else statement.targets


@once_for_each_file
def _keys_asked_for(file_facts: facts.Facts) -> frozenset[str] | None:
    """The texts with which a file takes something out of a mapping; None for a file that loads no YAML."""
    if not any(called_name(call) in _LOADERS for call in everything_in(file_facts.body, facts.Call)):
        return None
    keys = (*_keys(file_facts.body), *_keys_given_to_helpers(file_facts))
    return frozenset(text for key in keys if (text := key.text) is not None)


def _keys(body: Sequence[facts.Stmt], changed: Collection[Itself[facts.Base]] = ()) -> Iterator[facts.Expr]:
    """What stands for keys in a body, but for those of entries that statements change."""
    for part in everything_in(body, facts.Subscript):
        if Itself(part) not in changed:
            yield part.index
    for call in everything_in(body, facts.Call):
        if called_name(call) == "get" and call.args:
            yield call.args[0].value


def _keys_given_to_helpers(file_facts: facts.Facts) -> Iterator[facts.Expr]:
    """What calls give to those parameters of the file's own functions that are keys there:
    ``section_of(file, 'talker')``."""
    helpers: dict[str, list[facts.Function]] = {}
    for function in everything_in(file_facts.body, facts.Function):
        helpers.setdefault(function.name, []).append(function)
    for call in everything_in(file_facts.body, facts.Call):
        for helper in helpers.get(call.func.last_name, ()):
            asked = {key.variable for key in _keys(helper.body)} - {None}
            names = [parameter.name for parameter in helper.params]
            for position, argument in enumerate(call.args):
                name = argument.keyword or (names[position] if position < len(names) else None)
                if name in asked:
                    yield argument.value


__all__ = ["is_for_a_test", "is_read_in_code", "is_taken_out_again", "reader_in_code"]
