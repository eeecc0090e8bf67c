"""Launch's tables fit what runs its objects."""

from __future__ import annotations

from archlint.launch import tables
from archlint.launch.actions.visiting import ACTIONS
from archlint.launch.substitutions.performing import SUBSTITUTIONS
from archlint.launch.tables import LaunchClass


def test_each_class_that_stands_for_a_text_has_one():
    assert SUBSTITUTIONS.keys() == tables.SUBSTITUTIONS


def test_each_substitution_condition_and_action_can_be_made():
    made_by_archlint = {LaunchClass.BRANCH}
    assert {*SUBSTITUTIONS, *tables.CONDITIONS, *ACTIONS} - made_by_archlint <= set(tables.CLASSES.values())


def test_a_class_is_known_by_its_name_wherever_it_is_imported_from():
    for path in ("launch_ros.actions.LifecycleNode", "launch_ros.actions.lifecycle_node.LifecycleNode"):
        row = tables.find(path)
        assert row is not None and row.makes == LaunchClass.LIFECYCLE_NODE
        assert row.positional == () and "autostart" in row.params
    assert tables.find("launch.Branch") is None
