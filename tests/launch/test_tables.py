"""Launch's tables fit what runs its objects."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

from archlint import launch
from archlint.launch import tables
from archlint.launch.actions.visiting import ACTIONS
from archlint.launch.substitutions.performing import SUBSTITUTIONS


def test_each_class_that_stands_for_a_text_has_one():
    assert SUBSTITUTIONS.keys() == tables.SUBSTITUTIONS


def test_each_substitution_condition_and_action_can_be_made():
    made_by_archlint = {"Branch"}
    assert {*SUBSTITUTIONS, *tables.CONDITIONS, *ACTIONS} - made_by_archlint <= tables.SIGNATURES.keys()


def test_each_class_name_that_code_asks_for_is_a_row():
    """``LaunchObject.kind`` is the name of a row: what nothing is called would never be met."""
    names = {
        name for path in Path(launch.__file__).parent.rglob("*.py") for name in _asked(ast.parse(path.read_text()))
    }
    assert {"IfCondition", "LifecycleNode", "ParameterFile", "LaunchConfiguration"} <= names
    assert names <= tables.SIGNATURES.keys()


def _asked(tree: ast.AST) -> Iterator[str]:
    """Names of classes that a ``kind`` is compared with, or that a pattern has."""
    for node in ast.walk(tree):
        match node:
            case ast.MatchClass(cls=ast.Name(id="LaunchObject"), kwd_attrs=names, kwd_patterns=patterns):
                for name, pattern in zip(names, patterns, strict=True):
                    yield from _constants(pattern) if name == "kind" else ()
            case ast.Compare(
                left=ast.Attribute(attr="kind") | ast.Call(func=ast.Name(id="kind_of")), comparators=texts
            ):
                yield from (name for text in texts for name in _constants(text) if name[:1].isupper())


def _constants(tree: ast.AST) -> Iterator[str]:
    return (node.value for node in ast.walk(tree) if isinstance(node, ast.Constant) and isinstance(node.value, str))
