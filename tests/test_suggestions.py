"""Which word was meant."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from archlint import suggestions
from archlint.suggestions import did_you_mean, distance, limited_suggestions, listed_for, nearest


@pytest.mark.parametrize(
    ("one", "other", "edits"),
    [("talker", "talker", 0), ("taker", "talker", 1), ("tlaker", "talker", 1), ("a", "bcd", 3)],
)
def test_distance(one, other, edits):
    assert distance(one, other, 5) == edits


@given(st.text("abcÄß1_", max_size=8), st.text("abcÄß1_", max_size=8), st.integers(0, 3))
def test_words_that_are_near_have_nearly_the_same_letters(one, other, limit):
    if distance(one.lower(), other.lower(), limit) <= limit:
        letters = suggestions._letters(one), suggestions._letters(other)
        assert suggestions._may_be_near(*letters, limit)


@pytest.mark.parametrize(
    ("word", "most", "meant"), [("camxxa", 2, "camera"), ("camxxa", 1, None), ("camera1", 0, None)]
)
def test_no_more_edits_than_are_asked_for(word, most, meant):
    assert nearest(word, ["camera", "gripper"], most) == meant


def test_words_of_other_letters_are_not_compared(monkeypatch):
    compared = []
    monkeypatch.setattr(suggestions, "distance", lambda *words: (compared.append(words[1]), distance(*words))[1])
    assert nearest("camera", ["gripper", "kinect", "camara"]) == "camara"
    assert set(compared) == {"camara"}


def test_the_nearest_word_is_near():
    assert nearest("taker", ["listener", "talker"]) == "talker"
    assert did_you_mean("x", ["talker"]) == ""


@pytest.mark.parametrize(
    ("word", "meant"),
    [
        ("cmd_topc", "cmd_topic"),
        ("sub_ids", "sub_id"),
        ("maxspeed", "max_speed"),
        ("robot_maxspeed", "robot_max_speed"),
        ("Camra", "camera"),
        ("unsubscibe_topic", "unsubscribe_topic"),
        ("desable_motors", "disable_motors"),
        ("dstart_mapping", "start_mapping"),
    ],
)
def test_a_word_that_is_misspelt_in_a_name(word: str, meant: str):
    assert nearest(word, [meant]) == meant


@pytest.mark.parametrize(
    ("word", "other"),
    [
        ("cmd_topic", "imu_topic"),
        ("publish_odom", "publish_rate"),
        ("motor_1", "motor_2"),
        ("linear_x", "linear_y"),
        ("kp", "kd"),
        ("input_gain", "output_gain"),
        ("RobotGoStraight", "RobotStatus"),
        ("robot_go_home_goal", "robot_stop_goal"),
        ("unsubscribe_topic", "subscribe_topic"),
        ("unsubscribeTopic", "subscribeTopic"),
        ("enable_motors", "disable_motors"),
        ("disable", "enable"),
        ("start_mapping", "stop_mapping"),
        ("deactivate", "activate"),
        ("disconnect", "connect"),
        ("attach_arm", "detach_arm"),
        ("increase_speed", "decrease_speed"),
        ("import_map", "export_map"),
        ("inactive_goal", "active_goal"),
    ],
)
def test_two_names_of_which_neither_is_misspelt(word: str, other: str):
    assert nearest(word, [other]) is None


def test_long_names_reach_the_limit_sooner(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(suggestions, "MOST_COMPARED", 50)

    def hints(name: str) -> int:
        """How often a slip in a name is answered with the name."""
        with limited_suggestions():
            return sum(nearest(name[1:], [name]) == name for _ in range(100))

    assert (hints("talker"), hints("talk" * 16)) == (50, 3)


def test_a_word_is_not_held_against_more_names_than_the_limit(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(suggestions, "MOST_COMPARED", 50)
    known = ["talker", *(f"tal{number}" for number in range(10, 99))]
    assert nearest("taker", known) == "talker"
    with limited_suggestions():
        assert nearest("taker", known[:10]) == "talker"
        assert nearest("taker", known) is None


def test_of_many_names_those_with_a_word_of_the_one_that_is_missing_come_first():
    names = [f"gain_{letter}" for letter in "abcdefgh"] + ["input_image_topic"]
    assert listed_for("camera_topic", names) == (
        "input_image_topic, gain_a, gain_b, gain_c, gain_d, gain_e, gain_f, gain_g and 1 more"
    )
    assert listed_for("camera_topic", ["zoom", "rate", "map_topic"]) == "map_topic, rate, zoom"
    assert listed_for("camera", []) == "none"
