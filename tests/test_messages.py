"""No code branches on the text of a message or of a reason: what it has to know of them is a type or a field."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
SOURCE = ROOT / "src" / "archlint"
PROSE = re.compile(r"message|reason|why(?:_|$)|_help$|^help$")
"""What is called so is a text for people to read."""
SEARCHES = frozenset(
    {"startswith", "endswith", "removeprefix", "removesuffix", "find", "index", "partition", "rpartition"}
)
OF_OTHERS = "cli/parser.py"
"""Where the text of somebody else's error is the only thing that tells what went wrong."""


def is_prose(node: ast.expr) -> bool:
    match node:
        case ast.Name(id=name) | ast.Attribute(attr=name):
            return PROSE.search(name) is not None
        case ast.BoolOp(values=[first, *_]):
            return is_prose(first)
    return False


def has_words(node: ast.expr) -> bool:
    """Whether it is a text, and not the empty one."""
    return isinstance(node, ast.JoinedStr) or (
        isinstance(node, ast.Constant) and isinstance(node.value, str) and node.value != ""
    )


def decided_by_words(tree: ast.AST) -> Iterator[int]:
    """The lines that search prose or compare it with a text."""
    for node in ast.walk(tree):
        match node:
            case ast.Call(func=ast.Attribute(value=text, attr=name)) if name in SEARCHES and is_prose(text):
                yield node.lineno
            case ast.Compare(left=left, ops=[ast.Eq() | ast.NotEq()], comparators=[right]):
                if (is_prose(left) and has_words(right)) or (has_words(left) and is_prose(right)):
                    yield node.lineno
            case ast.Compare(left=left, ops=[ast.In() | ast.NotIn()], comparators=[right]) if is_prose(right):
                if has_words(left):
                    yield node.lineno


@pytest.mark.parametrize(
    "code",
    [
        "why.startswith('the value')",
        "(name.reason or '').startswith(PREFIX)",
        "'not declared' in value.reason",
        "found.message == 'gone'",
        "of = found.message.partition(' has no ')[0]",
    ],
)
def test_a_decision_by_words_is_seen(code: str):
    assert list(decided_by_words(ast.parse(code))) == [1]


@pytest.mark.parametrize(
    "code",
    ["why == ''", "one.message != other.message", "found.message in seen", "name.startswith('/')", "why is None"],
)
def test_what_only_passes_words_on_is_none(code: str):
    assert list(decided_by_words(ast.parse(code))) == []


def test_no_code_branches_on_words():
    decided = {
        path.relative_to(SOURCE).as_posix()
        for path in SOURCE.rglob("*.py")
        if any(decided_by_words(ast.parse(path.read_text("utf-8"))))
    }
    assert decided == {OF_OTHERS}
