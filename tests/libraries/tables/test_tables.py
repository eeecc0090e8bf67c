"""The API tables: what follows from a row, and what each row has to say."""

from __future__ import annotations

from typing import get_args

import pytest

from archlint.analysis.name_sites import _INTERFACES
from archlint.launch.library import LaunchLibrary
from archlint.libraries import screen, tables
from archlint.libraries.api_signatures import signatures_of
from archlint.libraries.interest import WORDS as INTERESTING
from archlint.libraries.offers import OFFERS
from archlint.libraries.rclpy.names import NODE_METHODS
from archlint.libraries.rclpy.signatures import refuses
from archlint.libraries.tables.api import EffectName


@pytest.mark.parametrize("row", tables.ROWS, ids=lambda row: row.path)
def test_a_row_has_an_effect_or_is_one_that_rules_look_at(row):
    assert row.effect in OFFERS.effects
    assert row.effect != "none" or row.watched, "a row without an effect must be `watched`: otherwise it does nothing"


@pytest.mark.parametrize("row", tables.ROWS, ids=lambda row: row.path)
def test_the_parts_that_a_row_names_are_parameters(row):
    parts = (row.node, row.type, row.name, row.qos, row.group, *(name for name, _ in row.callbacks))
    assert {part for part in parts if part is not None} <= set(row.params)


@pytest.mark.parametrize("row", tables.ROWS, ids=lambda row: row.path)
def test_a_row_has_the_parameters_of_each_distribution(row):
    """What a distribution calls otherwise is not bound to the parameters of the row."""
    for distro, signature in signatures_of(row.path).items():
        if row.effect != "destroy" and not signature.any_positional:  # all that destroy something share one name
            assert row.positional[: len(signature.positional)] == signature.positional, distro


def test_no_call_has_two_rows():
    assert len(tables.TABLE) == len(tables.ROWS)


def test_each_effect_is_named_by_a_row():
    """One that no row names would never run."""
    assert set(LaunchLibrary.offers.effects) == set(get_args(EffectName))
    assert set(OFFERS.effects) == {row.effect for row in tables.ROWS} | {"none"}


@pytest.mark.parametrize("name", [name for name, row in tables.NODE_ROWS.items() if row.creates])
def test_what_creates_on_a_node_is_known_everywhere(name):
    """A mixin that calls nothing else is read, and its class is run."""
    assert name.encode() in screen.WORDS
    assert name in NODE_METHODS and name in INTERESTING
    assert (name in _INTERFACES) == (tables.NODE_ROWS[name].name is not None)


def passes(source: str) -> bool:
    return any(word in source.encode() for word in screen.WORDS)


@pytest.mark.parametrize(
    "source",
    [
        "import rclpy",
        "self.node.create_publisher(String, 'chatter', 10)",
        "self.node.create_lifecycle_publisher(String, 'chatter', 10)",
        "class Mixin:\n    def setup(self): self.create_timer(1.0, self.tick)",
        "server = ActionServer(node, Fibonacci, 'fibonacci', execute)",
        "value = node.get_parameter('rate').value",
        "from tf2_ros import Buffer",
        "x = 1  # archlint: ignore[NME001]",
    ],
)
def test_what_can_create_or_wait_passes_the_screen(source):
    assert passes(source)


@pytest.mark.parametrize(
    "source", ["", "import numpy as np", "class Node:\n    pass", "print('publisher')", "graph.create_node(1)"]
)
def test_what_cannot_does_not(source):
    assert not passes(source)


@pytest.mark.parametrize(
    ("method", "given", "keywords", "refused"),
    [
        ("create_publisher", 3, (), False),
        ("create_publisher", 2, ("qos_profile",), False),
        ("create_publisher", 2, ("callback_group",), True),
        ("create_publisher", 4, (), True),
        ("create_publisher", 3, ("topic",), True),
        ("create_publisher", 3, ("latch",), True),
        ("create_subscription", 4, ("acceptable_buffer_backends",), False),
        ("create_timer", 2, (), False),
        ("create_timer", 1, (), True),
        ("create_timer", 5, (), False),
        ("create_rate", 1, (), False),
        ("get_name", 0, (), False),
        ("get_name", 0, ("short",), True),
        ("get_logger", 1, (), True),
        ("declare_parameter", 0, (), True),
        ("of_the_class_itself", 7, (), False),
    ],
)
def test_what_python_refuses_follows_from_its_signatures(method, given, keywords, refused):
    assert refuses(method, given, keywords) is refused
