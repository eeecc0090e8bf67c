"""The pages of our rules keep their word."""

from pathlib import Path

import pytest

from archlint.testing import examples_of

EXAMPLES = examples_of(Path(__file__).with_name("our_rules.py"))


@pytest.mark.parametrize("example", EXAMPLES, ids=str)
def test_a_page_keeps_its_word(example, tmp_path):
    assert example.found(tmp_path) == example.expected
