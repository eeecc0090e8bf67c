"""Which classes an ``except`` names."""

from __future__ import annotations

import pytest

from archlint.syntax import facts
from archlint.syntax.python.lowering import lower


@pytest.mark.parametrize(
    ("written", "names"),
    [
        ("", set()),
        (" TypeError", {"TypeError"}),
        (" TypeError as error", {"TypeError"}),
        (" (TypeError, ValueError)", {"TypeError", "ValueError"}),
        (" (TypeError, (KeyError, ValueError))", {"TypeError", "KeyError", "ValueError"}),
        (" (TypeError, *OTHERS)", {"TypeError", "OTHERS"}),
        (" OTHERS + (TypeError,)", {"TypeError", "OTHERS"}),
        (" json.JSONDecodeError", {"json", "JSONDecodeError"}),
    ],
)
def test_the_names_of_the_classes_that_it_is_for(written: str, names: set[str]):
    [attempt] = lower(f"try:\n    work()\nexcept{written}:\n    pass\n").body
    assert isinstance(attempt, facts.Try)
    [handler] = attempt.handlers
    assert handler.caught == names
