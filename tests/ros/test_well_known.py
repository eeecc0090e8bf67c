"""What the rules take for granted of the topics that every ROS 2 system has."""

from __future__ import annotations

import ast
from pathlib import Path

import archlint
from archlint.ros import well_known


def test_time_has_one_source_and_transforms_have_many():
    assert "/clock" not in well_known.OF_MANY_PUBLISHERS
    assert {"/tf", "/tf_static", "/joint_states", "/diagnostics"} <= well_known.OF_MANY_PUBLISHERS


def test_each_robot_has_its_joint_states_and_all_share_the_time():
    assert "/joint_states" not in well_known.ABSOLUTE
    assert {"/clock", "/tf", "/rosout"} <= well_known.ABSOLUTE


def test_no_node_has_a_robot_description_without_a_word_of_it():
    assert sorted(well_known.OF_EVERY_NODE) == ["/clock", "/parameter_events", "/rosout", "/tf", "/tf_static"]


def test_nobody_in_the_workspace_has_to_read_what_tools_show():
    assert "/robot_description" in well_known.FOR_TOOLS
    assert "/clock" not in well_known.FOR_TOOLS


def test_a_topic_has_one_row():
    names = [topic.name for topic in well_known.TOPICS]
    assert len(names) == len(set(names))


def test_no_other_module_lists_well_known_topics():
    names = {topic.name for topic in well_known.TOPICS}
    source = Path(archlint.__file__).parent
    lists = [
        f"{file.relative_to(source)}:{item.lineno}"
        for file in sorted(source.rglob("*.py"))
        if file != Path(well_known.__file__)
        for text in [file.read_text(encoding="utf-8")]
        if sum(name in text for name in names) > 1  # most modules need not be parsed
        for item in ast.walk(ast.parse(text))
        if isinstance(item, (ast.Set, ast.List, ast.Tuple))
        and len({part.value for part in item.elts if isinstance(part, ast.Constant)} & names) > 1
    ]
    assert lists == []
