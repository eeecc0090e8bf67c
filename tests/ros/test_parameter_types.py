"""The types of parameters, as ROS names them."""

from __future__ import annotations

import pytest

from archlint.ros.parameter_types import array_of, type_of


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        (True, "bool"),
        (1, "integer"),
        (1.0, "double"),
        ("1", "string"),
        ([1, 2], "integer_array"),
        (("a",), "string_array"),
        ([True, 1], None),  # no array of ROS holds both
        ([1, 2.0], None),
        ([], None),
        ([[1]], None),
        (None, None),
        ({"a": 1}, None),
    ],
)
def test_type_of_a_value(value: object, expected: str | None):
    assert type_of(value) == expected


def test_type_of_a_list_by_those_of_its_items():
    assert array_of({"double"}) == "double_array"
    assert array_of({"double", None}) is None
    assert array_of({"double_array"}) is None
