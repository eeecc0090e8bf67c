"""What an ``except`` is there for."""

from __future__ import annotations

import pytest

from archlint.interpreter import caught
from archlint.syntax import facts
from archlint.syntax.python.lowering import lower


def handler_of(head: str, body: str) -> facts.Handler:
    [statement] = lower(f"try:\n    run()\nexcept {head}:\n    {body}\n").body
    assert isinstance(statement, facts.Try)
    return statement.handlers[0]


@pytest.mark.parametrize(
    ("head", "expected"),
    [
        ("ImportError", True),
        ("(ImportError, ModuleNotFoundError)", True),
        ("(ImportError, ValueError)", False),
        ("ValueError", False),
        ("errors.ImportError", False),
        ("Exception", False),
    ],
)
def test_for_imports_that_fail(head: str, expected: bool):
    assert caught.is_import_error(handler_of(head, "pass").type) is expected


@pytest.mark.parametrize(
    ("head", "body", "expected"),
    [
        ("AttributeError", "log.error('no')", True),
        ("errors.AttributeError", "pass", True),
        ("ValueError", "pass", False),
        ("(ValueError, AttributeError)", "pass", True),
        ("Exception", "pass", True),
        ("Exception as error", "print(error)", False),
        ("Exception as error", "print('failed: ' + name)", False),
        ("Exception as error", "log.warning(f'failed: {name}')", False),
        ("Exception as error", "log.warning(str(name))", False),
        ("Exception", "log.exception()", False),
        ("Exception", "print(scan.ranges)", True),
        ("Exception", "raise", False),
        ("Exception", "self.data = None", True),
        ("Exception", "log.error('no'); return", False),
        ("Exception", "log.error('no'); return None", False),
        ("Exception", "log.error('no'); return 0", True),
        ("Exception", "log.error('no'); self.data = None", True),
        ("Exception", "return", True),
    ],
)
def test_for_an_attribute_that_is_missing(head: str, body: str, expected: bool):
    assert caught.may_expect_missing_attribute(handler_of(head, body)) is expected


@pytest.mark.parametrize(
    ("body", "expected"),
    [("continue", True), ("pass", True), ("print('again')", True), ("break", False), ("retry()", False)],
)
def test_only_goes_on(body: str, expected: bool):
    [loop] = lower(f"while True:\n    try:\n        run()\n    except OSError:\n        {body}\n").body
    assert isinstance(loop, facts.While)
    [statement] = loop.body
    assert isinstance(statement, facts.Try)
    assert caught.only_goes_on(statement.handlers[0]) is expected
