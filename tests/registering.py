"""Puts rules of a test in the place of the real ones."""

from __future__ import annotations

import sys
from itertools import count
from types import ModuleType

import pytest

from archlint import checks
from archlint.checks.registry import Check, registered

registered()  # the real rules are read before a test puts another rule book in the place of theirs
_numbers = count()


def only(monkeypatch: pytest.MonkeyPatch, *rules: Check, beside: tuple[str, ...] = ()) -> None:
    """For one test these rules are all that there are, beside those of the modules named."""
    module = ModuleType(f"archlint.checks.of_a_test_{next(_numbers)}")
    for number, rule in enumerate(rules):
        setattr(module, f"rule_{number}", rule)
    monkeypatch.setitem(sys.modules, module.__name__, module)
    monkeypatch.setattr(checks, "MODULES", (*beside, module.__name__.rpartition(".")[2]))
