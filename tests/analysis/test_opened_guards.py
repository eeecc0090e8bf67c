"""Guards in front of a wait: what must be something, not None, for a function to get there."""

from __future__ import annotations

import textwrap

import pytest

from api_calls import call_in
from archlint.analysis.opened_guards import asked_before


def asked(source: str) -> set[str]:
    """What is asked on the way to the call of ``wait()`` in a function."""
    code, call = call_in("def run(self):\n" + textwrap.indent(source, "    "), "wait")
    return set(asked_before(code.body(call), call.place)) - {""}


@pytest.mark.parametrize(
    "source",
    [
        "if self.pose is None:\n    return\nself.ready.wait()",
        "if not self.pose:\n    raise RuntimeError\nself.ready.wait()",
        "if self.pose is not None:\n    self.ready.wait()",
        "if self.pose:\n    self.ready.wait()",
        "if self.pose is None:\n    log()\nelse:\n    self.ready.wait()",
        "with lock:\n    if self.pose is None:\n        return\nself.ready.wait()",
        "try:\n    if self.pose is None:\n        return\nfinally:\n    log()\nself.ready.wait()",
        "if self.pose is None:\n    if quiet:\n        return\n    raise RuntimeError\nself.ready.wait()",
        "while self.pose is None:\n    log()\nself.ready.wait()",
        "for _ in range(3):\n    if self.pose == None:\n        continue\n    self.ready.wait()",
    ],
)
def test_what_is_asked_on_every_way(source: str) -> None:
    assert asked(source) == {"self.pose"}


@pytest.mark.parametrize(
    "source",
    [
        "self.ready.wait()",
        "if self.pose is None:\n    log()\nself.ready.wait()",
        "self.ready.wait()\nif self.pose is None:\n    return",
        "if self.pose is None:\n    self.ready.wait()",
        "try:\n    if self.pose is None:\n        raise OSError\nexcept OSError:\n    pass\nself.ready.wait()",
        "if quiet:\n    if self.pose is None:\n        return\nself.ready.wait()",
        "if self.pose is None and quiet:\n    return\nself.ready.wait()",
    ],
)
def test_what_is_not_asked_on_every_way(source: str) -> None:
    assert asked(source).isdisjoint({"self.pose"})


def test_several_conditions_are_all_asked() -> None:
    source = "if self.pose is None or not self.map:\n    return\nif self.goal and self.path:\n    self.ready.wait()"
    assert asked(source) == {"self.pose", "self.map", "self.goal", "self.path"}
