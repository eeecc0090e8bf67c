"""The most that a number may come to, as the function around it shows."""

from __future__ import annotations

import textwrap

import pytest

from archlint.execution.bounds import most
from archlint.syntax import facts
from archlint.syntax.python.lowering import lower
from archlint.syntax.walk import called_name, calls_in


def most_of(source: str) -> float | None:
    """The most that ``sleep()`` is given in a function of ``request``."""
    [function] = lower("def f(request):\n" + textwrap.indent(textwrap.dedent(source), "    ")).body
    assert isinstance(function, facts.Function)
    *_, sleep = [call for call in calls_in(function.body) if called_name(call) == "sleep"]
    return most(sleep.args[0].value, function.body, function.params)


@pytest.mark.parametrize(
    ("source", "expected"),
    [
        ("sleep(2)", 2.0),
        ("sleep(-2)", -2.0),
        ("sleep(min(request.a, 5.0))", 5.0),
        ("sleep(max(min(request.a, 5.0), 1.0))", 5.0),
        ("sleep(min(request.a, 5.0) * 2)", 10.0),
        ("sleep(max(0.0, min(request.a, 5.0)) * 2)", 10.0),
        ("sleep(max(0.0, min(request.a, 6.0)) / 3)", 2.0),
        ("sleep(1 - 3)", -2.0),
        ("sleep(abs(-4))", 4.0),
        ("x = 3\nsleep(x)", 3.0),
        ("x = 3\nif request.a:\n    x = 4\nsleep(x)", 4.0),
        ("x: float = 3.0\nsleep(x)", 3.0),
        ("x = request.a if request.a < 3 else 3\nsleep(x)", 3.0),
        ("if request.a < 3:\n    x = request.a\nelse:\n    x = 2\nsleep(x)", 3.0),
        ("if not request.a >= 3:\n    x = request.a\nelse:\n    x = 0\nsleep(x)", 3.0),
        ("if request.ok and request.a < 3:\n    x = request.a\nelse:\n    x = 0\nsleep(x)", 3.0),
        ("if request.a > 3:\n    return\nsleep(request.a)", 3.0),
        ("if not request.a <= 3:\n    raise ValueError\nwith lock:\n    sleep(request.a)", 3.0),
        ("if request.a < 3:\n    sleep(request.a)", 3.0),
        ("x = request.a\nif x > 3:\n    return\nsleep(x)", 3.0),
        ("if request.a > 3:\n    return\nx = request.a * 2\nsleep(max(x, 0))", 6.0),
        ("if request.a < 3:\n    x = request.a\n    request.a = 9\nelse:\n    x = 0\nsleep(x)", 3.0),
        ("while request.a > 3:\n    shrink()\nsleep(request.a)", 3.0),
        ("if 0 < request.a < 3:\n    x = request.a\nelse:\n    x = 0\nsleep(x)", 3.0),
    ],
)
def test_what_the_function_shows(source: str, expected: float | None) -> None:
    assert most_of(source) == expected


@pytest.mark.parametrize(
    "source",
    [
        "sleep(request.a)",
        "sleep(True)",
        "sleep(min(request.a))",
        "sleep(min(*request.a, 5))",
        "sleep(1 / request.a)",
        "x = 3\nx += 1\nsleep(x)",
        "x = 3\nfor x in request.a:\n    pass\nsleep(x)",
        "x = 3\nwith open(request.a) as x:\n    pass\nsleep(x)",
        "x, y = 3, 4\nsleep(x)",
        "x = 3\nuse((x := request.a))\nsleep(x)",
        "global x\nx = 3\nsleep(x)",
        "request = 3\nsleep(request)",
        "if request.a < 3:\n    request.a = 9\n    x = request.a\nelse:\n    x = 0\nsleep(x)",
        "if request.a > 3:\n    warn()\nsleep(request.a)",
        "if request.a > 3:\n    return\nrequest.a = 9\nsleep(request.a)",
        "if request.a > 3:\n    return\nif request.ok:\n    request = other\nsleep(request.a)",
        "if request.a > 3:\n    return\nwhile request.ok:\n    sleep(request.a)\n    request.a += 1",
        "if request.a > 3:\n    return\nfor request in other:\n    sleep(request.a)",
        "try:\n    if request.a > 3:\n        raise ValueError\nexcept ValueError:\n    pass\nsleep(request.a)",
        "if request.ok or request.a < 3:\n    x = request.a\nelse:\n    x = 0\nsleep(x)",
    ],
)
def test_nothing_limits_it(source: str) -> None:
    assert most_of(source) is None
