"""What breaks when something is taken away or changed."""

from __future__ import annotations

from archlint.dataflow.impacts import Impact, impacts_of
from dataflow.test_graph import CALLER, RELAY, SERVER, TALKER
from dataflow.tracing import Traced

LISTENER = """
def __init__(self):
    super().__init__("listener")
    self.create_subscription(String, "relayed", self.on_relayed, 10)

def on_relayed(self, message):
    print(message.data)
"""


def impact(traced: Traced, name: str) -> Impact:
    [only] = impacts_of(traced.systems, name)
    return only


def direct(traced: Traced, name: str) -> set[tuple[str | None, str]]:
    return {(effect.node, effect.words) for effect in impact(traced, name).direct}


def test_users_of_a_topic(traced: Traced) -> None:
    traced(talker=TALKER, relay=RELAY, listener=LISTENER)
    assert direct(traced, "/chatter") == {
        ("/talker", "publishes on it"),
        ("/relay", "gets no message any more"),
    }


def test_those_who_depend_on_the_users(traced: Traced) -> None:
    traced(talker=TALKER, relay=RELAY, listener=LISTENER)
    further = impact(traced, "talker").further
    assert {(effect.node, effect.name, effect.perhaps) for effect in further} == {
        (None, "/chatter", False),
        ("/relay", "Relay.on_chatter", False),
        (None, "/relayed", False),
        ("/listener", "Listener.on_relayed", False),
    }


def test_another_publisher_is_left(traced: Traced) -> None:
    traced(talker=TALKER, other=TALKER.replace('"talker"', '"other"'), relay=RELAY)
    assert direct(traced, "talker") == {("/relay", "gets no message of /chatter from it, but from /other")}


def test_nobody_else_listens(traced: Traced) -> None:
    traced(talker=TALKER, relay=RELAY)
    assert direct(traced, "relay") == {("/talker", "nobody else subscribes to /chatter")}


def test_a_server_that_is_asked(traced: Traced) -> None:
    traced(caller=CALLER, server=SERVER)
    assert direct(traced, "server") == {("/caller", "gets no answer of /stop any more")}
    assert {effect.name for effect in impact(traced, "server").further} == {"Caller.on_answer", "/said"}


def test_what_is_in_doubt_says_so(traced: Traced) -> None:
    traced(
        talker=TALKER,
        giver="""
        def __init__(self):
            super().__init__("giver")
            self.pub = self.create_publisher(String, "given", 10)
            self.create_subscription(String, "chatter", self.on_chatter, 10)

        def on_chatter(self, message):
            elsewhere.work(self.pub)
        """,
    )
    assert {(effect.name, effect.perhaps) for effect in impact(traced, "/chatter").further} == {
        ("Giver.on_chatter", False),
        ("/given", True),
    }


def test_an_interface_and_all_that_names_it(traced: Traced) -> None:
    traced(talker=TALKER, listener=LISTENER)
    [string] = impacts_of(traced.systems, "std_msgs/String")
    assert (string.kind, string.name) == ("interface", "std_msgs/msg/String")
    uses = [(use.kind, use.place.file, use.words) for use in string.uses]
    assert uses == [
        ("endpoint", "listener.py", "subscriber of /relayed in /listener"),
        ("endpoint", "talker.py", "publisher of /chatter in /talker"),
        ("field", "listener.py", "reads data"),
        ("import", "listener.py", "imports it"),
        ("import", "talker.py", "imports it"),
    ]
