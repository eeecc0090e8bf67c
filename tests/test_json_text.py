"""JSON that strict readers take."""

from __future__ import annotations

import json

import pytest

from archlint.json_text import json_text


@pytest.mark.parametrize(
    ("document", "text"),
    [
        ({"a": [1, None, "ä"]}, r'{"a": [1, null, "\u00e4"]}'),
        ({"deadline": float("nan"), "rates": (float("inf"), 2.5)}, '{"deadline": null, "rates": [null, 2.5]}'),
        ({"file": "p/\udcfe.py"}, r'{"file": "p/\ufffd.py"}'),
        ({"\udcfe": [float("-inf"), "\udc80\udcff"]}, r'{"\ufffd": [null, "\ufffd\ufffd"]}'),
        ("🤖", r'"\ud83e\udd16"'),
    ],
)
def test_what_json_has_no_word_for(document, text):
    assert json_text(document) == text
    json.loads(text, parse_constant=pytest.fail)
