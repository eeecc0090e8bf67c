"""Classes whose objects nobody has but their own methods, and the variable that the program makes one in.

That is how most nodes are: ``main()`` makes one, spins it and shuts it down.  Nothing else can give such an object an
attribute.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence, Set
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept
from archlint.python_code.class_chains import Chain, ClassInFile, chain_of, derived_from, files_with, targets_of
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in, once_for

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

KEEPS_OUT = frozenset({"super", "ActionClient", "ActionServer", "TransformListener", "TransformBroadcaster"}) | {
    *(
        "StaticTransformBroadcaster",
        "Subscriber",
        "Buffer",
        "Client",
        "Publisher",
        "print",
        "str",
        "repr",
        "id",
        "hasattr",
    )
}
"""What is often given the object, and sets nothing of a node."""
_RUNS = frozenset({"spin", "spin_once", "spin_until_future_complete", "add_node", "remove_node"})
"""What a program gives its node to, and sets nothing of it either."""
_BY_TEXT = frozenset({"hasattr", "getattr", "setattr", "delattr"})


def may_be_given(workspace: WorkspaceIndex, cls: ClassInFile, name: str) -> bool | None:
    """Whether code beside the methods of a class gives one of its objects an attribute; None where others may have the
    object, so that its file alone does not say."""
    if not is_unshared(workspace, cls):
        return None
    file_facts = workspace.facts_at(cls.file)
    return file_facts is None or name in given_in(file_facts, cls.code.name) | asked_in(file_facts)


def is_unshared(workspace: WorkspaceIndex, cls: ClassInFile) -> bool:
    """Whether no other class derives from a class, nothing else makes an object of it, and none gives itself away."""
    return kept(
        workspace, (is_unshared, Itself(cls.code)), lambda: _is_unshared(workspace, cls, chain_of(workspace, cls))
    )


def _is_unshared(workspace: WorkspaceIndex, cls: ClassInFile, chain: Chain) -> bool:
    file_facts = workspace.facts_at(cls.file)
    if file_facts is None or any(_gives_itself(each.code) for each in chain.own):
        return False
    if any(True for _ in derived_from(workspace, cls)) or not _is_made_in_variables(file_facts, cls.code.name):
        return False
    others = (file for file in files_with(workspace, cls.code.name) if file != cls.file)
    return not any(_has(workspace, file, cls) for file in others)


@once_for
def _gives_itself(code: facts.Class) -> bool:
    """Whether methods of a class hand their object on, or keep it somewhere."""
    owners = {Itself(part.value) for part in everything_in(code.body, facts.Attribute)}
    harmless = {*owners, *_arguments_of(code.body, KEEPS_OUT)}
    names = (name for name in everything_in(code.body, facts.Name) if name.id == "self")
    return any(Itself[facts.Base](name) not in harmless for name in names)


def _arguments_of(body: Sequence[facts.Base], functions: frozenset[str]) -> Iterator[Itself[facts.Base]]:
    for call in everything_in(body, facts.Call):
        if call.func.last_name in functions:
            yield from (Itself[facts.Base](argument.value) for argument in call.args)


def _is_made_in_variables(file_facts: facts.Facts, name: str) -> bool:
    """Whether all that a file does with a class is to make objects in variables, to spin or to shut down."""
    calls = [call for call in everything_in(file_facts.body, facts.Call) if call.func.variable == name]
    variables = _variables(file_facts, name)
    makers = {Itself[facts.Base](call.func) for call in calls}
    placed = {Itself[facts.Base](assign.value) for assign in _makings(file_facts, name)}
    run = {*_arguments_of(file_facts.body, _RUNS)}
    if not calls or not all(Itself[facts.Base](call) in placed | run for call in calls):
        return False
    owners = {Itself[facts.Base](part.value) for part in everything_in(file_facts.body, facts.Attribute)}
    targets = {Itself[facts.Base](target) for target in targets_of(file_facts.body)}
    compared = {
        Itself[facts.Base](operand)
        for compare in everything_in(file_facts.body, facts.Compare)
        for operand in compare.children()
    }
    tested = {Itself[facts.Base](branch.test) for branch in everything_in(file_facts.body, facts.If)}
    harmless = owners | targets | compared | tested | run
    for used in everything_in(file_facts.body, facts.Name):
        key = Itself[facts.Base](used)
        if (used.id == name and key not in makers | owners) or (used.id in variables and key not in harmless):
            return False
    return not any(part.attr == name for part in everything_in(file_facts.body, facts.Attribute))


def _makings(file_facts: facts.Facts, name: str) -> Iterator[facts.Assign]:
    for assign in everything_in(file_facts.body, facts.Assign):
        if not isinstance(assign.value, facts.Call) or assign.value.func.variable != name:
            continue
        if len(assign.targets) == 1 and assign.targets[0].variable:
            yield assign


def _variables(file_facts: facts.Facts, name: str) -> frozenset[str]:
    return frozenset(assign.targets[0].variable for assign in _makings(file_facts, name))


def _has(workspace: WorkspaceIndex, file: str, cls: ClassInFile) -> bool:
    """Whether another file gets a class, or one that it may mean: it imports it, or asks a module for it."""
    file_facts, name = workspace.facts_at(file), cls.code.name
    if file_facts is None or any(part.attr == name for part in everything_in(file_facts.body, facts.Attribute)):
        return True
    for statement in everything_in(file_facts.body, facts.ImportFrom):
        if any(own in (name, "*") for own, _ in statement.names):
            path = workspace.code.path_of_import(file, statement.module, statement.level)
            if path == cls.file or (path is not None and any(own == name for own, _ in statement.names)):
                return True
    return False


def given_in(file_facts: facts.Facts, name: str) -> frozenset[str]:
    """The attributes that a file assigns to a class, or to an object of it that a variable holds."""
    variables = {name, *_variables(file_facts, name)}
    return frozenset(
        target.attr
        for target in targets_of(file_facts.body)
        if isinstance(target, facts.Attribute) and target.value.variable in variables
    )


@once_for
def asked_in(code: facts.Facts | facts.Class) -> frozenset[str]:
    """The names that a file or a class asks an object for as a text, or gives it so."""
    return texts_given_to(_BY_TEXT, code.body)


def texts_given_to(functions: Set[str], body: Sequence[facts.Base]) -> frozenset[str]:
    """The texts among the arguments of calls of some functions; an empty one stands for all that is no text."""
    return frozenset(
        argument.value.text or ""
        for call in everything_in(body, facts.Call)
        if call.func.last_name in functions
        for argument in call.args
    )


__all__ = ["KEEPS_OUT", "asked_in", "given_in", "is_unshared", "may_be_given", "texts_given_to"]
