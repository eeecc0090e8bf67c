"""What a callback plays out: words, and moves with pauses."""

from __future__ import annotations

import pytest

from api_calls import call_in
from archlint.execution.staged import is_between_moves, speaks_beside


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        ("self.speak('hello')\n    sleep()", True),
        ("sd.play(sound)\n    sd.wait()\n    sleep()", True),
        ("self.client.wait()\n    sleep()", False),
        ("self.hear('hello')\n    sleep()", False),
    ],
)
def test_words_beside_a_pause(body: str, expected: bool) -> None:
    assert speaks_beside(*call_in(f"def tick(self):\n    {body}", "sleep")) is expected


def test_words_of_the_callback_beside_a_pause_of_its_helper() -> None:
    text = "def tick(self):\n    self.say('hello')\n    self.rest()\n\n\ndef rest(self):\n    sleep()\n"
    assert speaks_beside(*call_in(text, "sleep", "rest"))


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        ("self.arm.publish(up)\n    sleep()\n    self.arm.publish(down)", True),
        ("self.arm.publish(up)\n    sleep()\n    self.hand.publish(shut)", False),
        ("sleep()\n    self.arm.publish(down)", False),
    ],
)
def test_several_messages_of_one_publisher_are_moves(body: str, expected: bool) -> None:
    assert is_between_moves(*call_in(f"def tick(self):\n    {body}", "sleep")) is expected
