"""What some things lead to, directly or not."""

from __future__ import annotations

from collections import Counter

from archlint.workspace.closure import closure


def test_all_that_one_leads_to_and_each_is_asked_once():
    needs = {"arm": ["driver", "msgs"], "driver": ["msgs"], "msgs": [], "gripper": ["arm"]}
    asked: Counter[str] = Counter()

    def needed(name: str) -> list[str]:
        asked[name] += 1
        return needs[name]

    assert closure(["arm"], needed) == {"arm", "driver", "msgs"}
    assert asked == {"arm": 1, "driver": 1, "msgs": 1}


def test_a_circle_ends():
    assert closure(["a"], {"a": ["b"], "b": ["a"]}.__getitem__) == {"a", "b"}


def test_nothing_leads_nowhere():
    assert closure([], {}.__getitem__) == frozenset()
