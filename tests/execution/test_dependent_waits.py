"""Waits in turn: whether a later one may depend on an earlier one."""

from __future__ import annotations

import textwrap

import pytest

from archlint.execution.dependent_waits import build_on_answers
from archlint.syntax.python.lowering import lower


def depend(source: str) -> bool:
    """Whether the lines that call ``wait()`` depend on each other."""
    text = textwrap.dedent(source).strip()
    lines = {number for number, line in enumerate(text.splitlines(), start=1) if "wait(" in line}
    return build_on_answers(lower(text).body, lines)


@pytest.mark.parametrize(
    "source",
    [
        "a = wait(1)\nb = wait(2)\nc = wait(3)",
        "wait(1)\nlog('next')\nwait(2)",
        "if ready():\n    wait(1)\n    wait(2)",
        "future = send()\nwait(future)\nother = send()\nwait(other)",
        "self.a = wait(1)\nself.b = wait(self.client)",
        "wait(1)\nwait(2)\nreturn_value = 3\nif return_value:\n    pass",
    ],
)
def test_waits_that_could_be_one(source: str) -> None:
    assert not depend(source)


@pytest.mark.parametrize(
    "source",
    [
        "a = wait(1)\nb = wait(a)",
        "a = wait(1)\nrequest.x = a\nb = wait(request)",
        "wait(1)\nif ready():\n    wait(2)",
        "wait(1)\nassert ready()\nwait(2)",
        "wait(1)\nx = future.result()\nwait(x)",
        "wait(1)\nwhile busy():\n    pass\nwait(2)",
        "self.a = wait(1)\nwait(self.a)",
    ],
)
def test_what_lies_between_may_decide(source: str) -> None:
    assert depend(source)
