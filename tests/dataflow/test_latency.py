"""How long data takes along a way, and what does not fit."""

from __future__ import annotations

import pytest

from archlint.dataflow.latency import total
from archlint.dataflow.misfits import misfits
from archlint.dataflow.pace import interval
from dataflow.test_graph import RELAY, SERVER, TALKER
from dataflow.tracing import Traced

CONTROL = """
def __init__(self):
    super().__init__("control")
    self.create_subscription(String, "chatter", self.on_chatter, {depth})
    self.client = self.create_client(Trigger, "stop")
    self.create_timer({period}, self.control)

def on_chatter(self, message):
    {handle}
    self.latest = message

def control(self):
    {before}
    if self.latest:
        self.client.call_async(Trigger.Request())
"""


def control(depth: int = 10, period: float = 0.1, before: str = "pass", handle: str = "pass") -> str:
    return CONTROL.format(depth=depth, period=period, before=before, handle=handle)


def test_a_sensor_a_controller_and_a_motor(traced: Traced) -> None:
    traced(talker=TALKER, control=control(), server=SERVER)
    assert traced.way("stop", origin="talker") == [
        (0.1, "Talker.tick of /talker has its turn every 0.1 s"),
        (0.1, "Control.control of /control reads it every 0.1 s"),
        (None, "the service /stop takes its time"),
    ]


def test_a_callback_waits_for_the_others_of_its_thread(traced: Traced) -> None:
    traced(talker=TALKER, control=control(period=2.0, before="time.sleep(0.5)"), server=SERVER)
    assert traced.way("stop", origin="talker")[1:4] == [
        (0.5, "Control.on_chatter of /control waits while Control.control runs: it sleeps for 0.5 s"),
        (2.0, "Control.control of /control reads it every 2 s"),
        (0.5, "Control.control sleeps for 0.5 s at control.py:26"),
    ]


def test_a_wait_without_a_limit_is_no_figure(traced: Traced) -> None:
    traced(talker=TALKER, control=control(before="self.client.call(Trigger.Request())"), server=SERVER)
    [way] = traced.trace("stop", origin="talker").ways
    assert total(way.terms) == pytest.approx(0.2)
    waits = [term.words for term in way.terms if term.seconds is None]
    assert waits[1] == "Control.control waits for the answer of the service 'stop' at control.py:26"


def test_the_period_of_a_timer_that_is_stopped_is_not_known(traced: Traced) -> None:
    stopped = (
        TALKER.replace("self.create_timer(0.1", "self.timer = self.create_timer(0.1") + "    self.timer.cancel()\n"
    )
    traced(talker=stopped, relay=RELAY)
    assert traced.way("relayed", origin="talker") == [
        (None, "how often Talker.tick of /talker sends is not known"),
    ]


def test_a_loop_that_sleeps_has_a_period(traced: Traced) -> None:
    traced.file(
        "node.py",
        """
        import time
        import rclpy
        from std_msgs.msg import String

        rclpy.init()
        node = rclpy.create_node("talker")
        publisher = node.create_publisher(String, "chatter", 10)
        while rclpy.ok():
            publisher.publish(String())
            time.sleep(0.25)
        """,
    )
    traced(relay=RELAY)
    assert traced.way("relayed", origin="/talker") == [(0.25, "node of /talker has its turn every 0.25 s")]


def test_what_one_loop_sends_to_two_topics_has_the_same_period(traced: Traced) -> None:
    traced.file(
        "node.py",
        """
        import time
        import rclpy
        from std_msgs.msg import String

        rclpy.init()
        node = rclpy.create_node("talker")
        first = node.create_publisher(String, "first", 10)
        second = node.create_publisher(String, "second", 10)
        while rclpy.ok():
            first.publish(String())
            second.publish(String())
            time.sleep(0.25)
        """,
    )
    traced(
        **{name: RELAY.replace("chatter", name).replace("relayed", f"{name}_relayed") for name in ("first", "second")}
    )
    flow = traced.flow
    callbacks = [step for step in flow.steps if step.callback is not None and interval(flow, step) is not None]
    assert [interval(flow, step) for step in callbacks] == [0.25, 0.25]


# ------------------------------------------------------------------------------------------------- misfits


def misfits_of(traced: Traced) -> list[str]:
    flow = traced.flow
    return [f"{each.step.name}: {each.words}" for each in misfits(flow, {id(step) for step in flow.steps})]


def test_a_callback_that_takes_longer_than_its_messages_come(traced: Traced) -> None:
    traced(talker=TALKER, control=control(handle="time.sleep(0.2)", period=5.0), server=SERVER)
    assert misfits_of(traced) == [
        "Control.on_chatter: 10 messages a second arrive, and it sleeps for 0.2 s with each: its queue keeps the last "
        "10, and all others are lost"
    ]
    [_, queue, *_] = traced.way("stop", origin="talker")
    assert queue == (
        2.0,
        "Control.on_chatter of /control is behind: up to 10 messages of /chatter are before it in the queue",
    )


def test_a_queue_that_is_too_short_for_what_keeps_its_thread(traced: Traced) -> None:
    traced(talker=TALKER, control=control(depth=2, period=5.0, before="time.sleep(1.0)"), server=SERVER)
    assert misfits_of(traced) == [
        "Control.on_chatter: Control.control keeps its thread for 1 s each time, in which 10 messages arrive; its "
        "queue keeps the last 2, and the others are lost"
    ]


def test_a_timer_that_sleeps_longer_than_its_period(traced: Traced) -> None:
    traced(talker=TALKER.replace("    self.pub.publish", "    time.sleep(0.3)\n    self.pub.publish"))
    assert misfits_of(traced) == ["Talker.tick: it sleeps for 0.3 s each time, and is due every 0.1 s"]


FITS = {
    "in time": control(handle="time.sleep(0.05)"),
    "only sometimes": control(handle="if message.data: time.sleep(0.2)"),
    "the queue is long enough": control(period=5.0, before="time.sleep(1.0)", depth=20),
    "for a time that is not known": control(handle="time.sleep(self.pause)"),
}


@pytest.mark.parametrize("body", FITS.values(), ids=FITS)
def test_what_fits_or_is_not_known_is_not_reported(traced: Traced, body: str) -> None:
    assert misfits_of(traced(talker=TALKER, control=body, server=SERVER)) == []


def test_several_publishers_add_up(traced: Traced) -> None:
    traced(talker=TALKER, other=TALKER.replace('"talker"', '"other"'))
    traced(control=control(handle="time.sleep(0.06)"), server=SERVER)
    [words] = misfits_of(traced)
    assert words.startswith("Control.on_chatter: 20 messages a second arrive, and it sleeps for 0.06 s with each")


def test_a_branch_in_a_loop_decides(traced: Traced) -> None:
    traced.file(
        "node.py",
        """
        import time
        import rclpy
        from std_msgs.msg import String

        rclpy.init()
        node = rclpy.create_node("talker")
        publisher = node.create_publisher(String, "chatter", 10)
        while rclpy.ok():
            if read():
                publisher.publish(String())
            time.sleep(0.25)
        """,
    )
    traced(relay=RELAY)
    assert traced.way("relayed", origin="/talker") == [(None, "how often node of /talker sends is not known")]


def test_a_rate_goes_through_many_topics(traced: Traced) -> None:
    for number in range(20):
        relay = RELAY.replace("chatter", f"topic{number}").replace("relayed", f"topic{number + 1}")
        traced(**{f"relay{number}": relay.replace('"relay"', f'"relay{number}"')})
    traced(talker=TALKER.replace("chatter", "topic0"))
    flow = traced.flow
    [last] = [step for step in flow.steps if step.name == "Relay19.on_topic19"]
    assert interval(flow, last) == 0.1


def test_the_shortest_interval_counts(traced: Traced) -> None:
    traced(talker=TALKER, slow=TALKER.replace('"talker"', '"slow"').replace("0.1", "5.0"), relay=RELAY)
    flow = traced.flow
    [relay] = [step for step in flow.steps if step.name == "Relay.on_chatter"]
    assert interval(flow, relay) == 0.1
