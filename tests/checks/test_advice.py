"""What a finding says to do works when it is done."""

from __future__ import annotations

import pytest

from checks.judging import Judge

PROGRAM = """
    import threading

    import rclpy
    from example_interfaces.action import Fibonacci
    from rclpy.action import ActionClient, ActionServer
    from rclpy.executors import SingleThreadedExecutor
    from rclpy.node import Node
    from std_msgs.msg import String
    from std_srvs.srv import Trigger


    class Helper(Node):
        def __init__(self):
            super().__init__('helper')
            self.client = self.create_client(Trigger, 'other')


    class Robot(Node):
        def __init__(self):
            super().__init__('robot')
            self.helper = Helper()
            self.apart = SingleThreadedExecutor()
            {helper}
            self.client = self.create_client(Trigger, 'own')
            self.goals = ActionClient(self, Fibonacci, 'count')
            self.heard = threading.Event()
            self.create_subscription(String, 'words', self.on_words, 10)
            {made}

        def on_words(self, message):
            self.heard.set()

        def handle(self, request, response):
            {body}
            return response

        def execute(self, goal):
            {body}
            goal.succeed()
            return Fibonacci.Result()


    def main():
        rclpy.init()
        rclpy.spin(Robot())


    main()
"""
SERVICE = "self.create_service(Trigger, 'serve', self.handle)"
ACTION = "ActionServer(self, Fibonacci, 'act', self.execute)"
SEND = "future = self.{}.call_async(Trigger.Request())\n            "
BY_RCLPY = SEND.format("helper.client") + "rclpy.spin_until_future_complete(self.helper, future{})  # here"
BY_ITSELF = SEND.format("helper.client") + "self.apart.spin_until_future_complete(future{})  # here"
ITS_OWN = SEND.format("client") + "rclpy.spin_until_future_complete(self, future)  # here"


def program(made: str, body: str, helper: str = "pass") -> str:
    text = PROGRAM.format(made=made, body=body, helper=helper)
    unused = "def execute" if made == SERVICE else "def handle"
    start = text.index(f"        {unused}")
    end = text.index("\n\n", start)
    return text[:start] + text[start:end].replace("  # here", "") + text[end:]


@pytest.mark.parametrize(
    ("body", "helper", "help_"),
    [
        (BY_RCLPY.format(""), "pass", "add the other node to a SingleThreadedExecutor() of its own, and call that"),
        (BY_RCLPY.format(", timeout_sec=2.0"), "pass", "add the other node to a SingleThreadedExecutor() of its own"),
        (BY_ITSELF.format(""), "self.apart.add_node(self.helper)", "set timeout_sec, and check future.done()"),
        (BY_ITSELF.format(", timeout_sec=2.0"), "self.apart.add_node(self.helper)", "keep the timeout, and give the"),
        (ITS_OWN, "pass", "make the handler async, give the client its own callback group, and await call_async(…)"),
    ],
)
def test_a_node_that_runs_only_while_it_is_waited_for_answers_no_await(
    judge: Judge, body: str, helper: str, help_: str
):
    """Nobody spins the helper but the handler: an ``await`` in it would never go on."""
    [found] = judge("SRV003", program(SERVICE, body, helper))
    assert found.help.startswith(help_)


def test_an_execute_callback_that_returns_has_ended_its_goal(judge: Judge):
    [spin] = judge("EXE001", program(ACTION, ITS_OWN))
    assert spin.help == "make the execute callback async, and await call_async(…): the goal continues with the response"
    [call] = judge("EXE002", program(ACTION, "self.client.call(Trigger.Request())  # here"))
    assert call.help == spin.help
    [goal] = judge("EXE002", program(ACTION, "self.goals.send_goal(Fibonacci.Goal())  # here"))
    assert "await send_goal_async(…)" in goal.help


A_GOAL = """
            sent = self.goals.send_goal_async(Fibonacci.Goal())
            rclpy.spin_until_future_complete(self, sent)
            self.goal = sent.result()
            {}"""
CANCEL = "rclpy.spin_until_future_complete(self, self.goal.cancel_goal_async())  # here"
RESULT = "rclpy.spin_until_future_complete(self, self.goal.get_result_async())  # here"


@pytest.mark.parametrize(("body", "sends"), [(CANCEL, "cancel_goal_async()"), (RESULT, "get_result_async()")])
def test_what_a_handler_awaits_is_what_it_has_asked(judge: Judge, body: str, sends: str):
    """Whoever cancels a goal is not told to send one."""
    [found] = judge("SRV003", program(SERVICE, body).replace(SERVICE, A_GOAL.format(SERVICE)))
    assert found.help == f"make the handler async, give the client its own callback group, and await {sends}"


def test_who_cancels_a_goal_in_a_callback_continues_in_another(judge: Judge):
    """A done callback gets the answer: nothing else has to be sent."""
    [found] = judge("EXE001", program(A_GOAL.format("self.create_timer(1.0, lambda: self.execute(None))"), CANCEL))
    assert found.help == "cancel_goal_async().add_done_callback(…), return, and continue there"


def test_who_waits_for_a_transform_has_sent_no_request(judge: Judge):
    body = (
        "transform = self.buffer.wait_for_transform_async('map', 'base', rclpy.time.Time())\n"
        "            rclpy.spin_until_future_complete(self, transform)  # here"
    )
    [found] = judge("EXE001", program("self.create_timer(1.0, lambda: self.execute(None))", body))
    assert found.help == "transform.add_done_callback(…), return, and continue there"
    assert "may deadlock" in found.message
    [limited] = judge("EXE001", program("self.create_timer(1.0, lambda: self.execute(None))", _LIMITED))
    assert "may time out" in limited.message
    assert "deadlock" not in limited.message
    [unnamed] = judge("EXE001", program("self.create_timer(1.0, lambda: self.execute(None))", _UNNAMED))
    assert (unnamed.help or "").startswith("give the future a done callback with add_done_callback(…)")
    [goal] = judge("EXE001", program(ACTION, body))
    assert goal.help == "make the execute callback async, and await transform: the goal continues with the response"


_LIMITED = (
    "transform = self.buffer.wait_for_transform_async('map', 'base', rclpy.time.Time())\n"
    "            rclpy.spin_until_future_complete(self, transform, timeout_sec=1.0)  # here"
)
_UNNAMED = (
    "rclpy.spin_until_future_complete(self, "
    "self.buffer.wait_for_transform_async('map', 'base', rclpy.time.Time()))  # here"
)


@pytest.mark.parametrize("made", [SERVICE, ACTION], ids=["service", "action"])
def test_a_handler_must_have_heard_before_it_returns(judge: Judge, made: str):
    [found] = judge("EXE002", program(made, "self.heard.wait()  # here"))
    assert found.help == (
        "spin the node with a MultiThreadedExecutor, give the callback that sets the event its own callback group, "
        "and wait here with a timeout"
    )


def test_a_timer_may_leave_the_rest_to_the_callback_that_hears(judge: Judge):
    tick = "self.create_timer(1.0, lambda: self.heard.wait())  # here"
    [found] = judge("EXE002", program(tick, "pass"))
    assert found.help == "continue in the callback that sets the event"


LIBRARY = """
    from rclpy.node import Node
    from std_srvs.srv import Trigger


    class Remote(Node):
        def __init__(self):
            super().__init__('remote')
            self.client = self.create_client(Trigger, 'own')

        def ask(self):
            {use}self.client.call(Trigger.Request())  # here
"""


@pytest.mark.parametrize(
    ("use", "help_"),
    [
        ("return ", "in a thread that does not spin: call_async(), and wait with"),
        ("", "call_async() and continue in a"),
    ],
)
def test_who_reads_a_response_at_once_cannot_continue_later(judge: Judge, use: str, help_: str):
    [found] = judge("TMO002", LIBRARY.format(use=use))
    assert found.help.startswith(help_)
