"""Launch's tables fit what runs its objects."""

from __future__ import annotations

from archlint.launch import tables
from archlint.launch.actions.visiting import ACTIONS
from archlint.launch.substitutions.performing import SUBSTITUTIONS


def test_each_class_that_stands_for_a_text_has_one():
    assert SUBSTITUTIONS.keys() == tables.SUBSTITUTIONS


def test_each_substitution_condition_and_action_can_be_made():
    made_by_archlint = {"Branch"}
    assert {*SUBSTITUTIONS, *tables.CONDITIONS, *ACTIONS} - made_by_archlint <= tables.SIGNATURES.keys()
