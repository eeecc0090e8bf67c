"""The reader of the comments in ``fixtures/forms``, and that every comment there can be read."""

from __future__ import annotations

from pathlib import Path

import pytest

from form_entities import FormEntity, read_form, read_forms

FORMS = Path(__file__).parents[1] / "fixtures" / "forms"


def test_a_comment_at_the_end_of_a_line_describes_that_line():
    text = "import rclpy\nmake()  # entity: publisher /a std_msgs/msg/String depth=3 conditional\n"
    assert read_form("node.py", text) == [
        FormEntity("node.py", 2, "publisher", "/a", "std_msgs/msg/String", True, {"depth": "3"})
    ]


def test_comment_lines_below_belong_to_the_line_above():
    text = "make()  # entity: client /a std_srvs/srv/Empty\n# entity: timer 0.5; timer 2.0\n"
    assert [(entity.line, entity.kind, entity.name) for entity in read_form("node.py", text)] == [
        (1, "client", "/a"),
        (1, "timer", "0.5"),
        (1, "timer", "2.0"),
    ]


def test_a_parameter_is_named_after_the_resolution():
    text = "make()  # entity: publisher /a std_msgs/msg/String resolution=parameter:arm.topic\n"
    (entity,) = read_form("node.py", text)
    assert (entity.resolution, entity.parameter) == ("parameter", "arm.topic")


@pytest.mark.parametrize("words", ["publisher /a", "topic /a std_msgs/msg/String", "timer", ""])
def test_what_is_no_entity_is_refused(words: str):
    with pytest.raises(ValueError, match="not an entity"):
        read_form("node.py", f"make()  # entity: {words}\n")


def test_the_forms_are_read_and_point_at_code():
    entities = read_forms(FORMS)
    assert len({entity.file for entity in entities}) > 25
    for entity in entities:
        line = (FORMS / entity.file).read_text(encoding="utf-8").splitlines()[entity.line - 1]
        assert "(" in line, f"{entity.file}:{entity.line} creates nothing"
