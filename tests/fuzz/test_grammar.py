"""Templates that become texts."""

from __future__ import annotations

import random

import pytest
from benchmarks.fuzz.grammar import Grammar
from benchmarks.fuzz.pick import Pick


def pick(seed: int) -> Pick:
    chance = random.Random(seed)

    class Chosen(Pick):
        def number(self, low: int, high: int) -> int:
            return chance.randint(low, high)

    return Chosen(lambda strategy: None)


def test_a_text_ends_though_its_templates_do_not():
    grammar = Grammar({"sum": ["(«sum» + «sum»)", "«digit»"], "digit": ["1"]}, {}, depth=5)
    texts = {grammar.text(pick(seed), "sum") for seed in range(30)}
    assert len(texts) > 3
    assert all(set(text) <= set("(1 +)") and text.count("(") == text.count(")") < 32 for text in texts)


def test_a_placeholder_alone_on_its_line_is_indented():
    grammar = Grammar({"code": ["if x:\n    «block»\nelse: «word»"], "block": ["a\nb"]}, {"word": lambda pick: "c"})
    assert grammar.text(pick(0), "code") == "if x:\n    a\n    b\nelse: c"


def test_templates_that_never_end_are_refused():
    with pytest.raises(ValueError, match="a"):
        Grammar({"a": ["«b»"], "b": ["«a»"]}, {})
