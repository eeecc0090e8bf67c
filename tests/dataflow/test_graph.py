"""Which callback sends what, and what comes to which callback."""

from __future__ import annotations

from dataflow.tracing import Traced, links_of

TALKER = """
def __init__(self):
    super().__init__("talker")
    self.pub = self.create_publisher(String, "chatter", 10)
    self.create_timer(0.1, self.tick)

def tick(self):
    self.pub.publish(String())
"""
RELAY = """
def __init__(self):
    super().__init__("relay")
    self.create_subscription(String, "chatter", self.on_chatter, 10)
    self.create_subscription(String, "other", self.on_other, 10)
    self.pub = self.create_publisher(String, "relayed", 10)

def on_chatter(self, message):
    self.forward(message)

def on_other(self, message):
    pass

def forward(self, message):
    self.pub.publish(message)
"""
CALLER = """
def __init__(self):
    super().__init__("caller")
    self.client = self.create_client(Trigger, "stop")
    self.pub = self.create_publisher(String, "said", 10)
    self.create_timer(1.0, self.ask)

def ask(self):
    self.client.call_async(Trigger.Request()).add_done_callback(self.on_answer)

def on_answer(self, future):
    self.pub.publish(String(data=future.result().message))
"""
SERVER = """
def __init__(self):
    super().__init__("server")
    self.create_service(Trigger, "stop", self.stop)

def stop(self, request, response):
    return response
"""


def test_a_message_goes_through_the_callback_that_publishes(traced: Traced) -> None:
    traced(talker=TALKER, relay=RELAY)
    assert traced.before("/relayed") == {"Relay.on_chatter", "topic /chatter", "Talker.tick"}
    assert traced.after("/chatter") == {"Relay.on_chatter", "topic /relayed"}
    assert traced.after("/other") == {"Relay.on_other"}


def test_an_answer_comes_from_the_handler_to_the_done_callback(traced: Traced) -> None:
    traced(caller=CALLER, server=SERVER)
    before = traced.before("/said")
    assert before == {"Caller.on_answer", "answer /stop", "Server.stop", "service /stop", "Caller.ask"}


def test_code_that_waits_gets_the_answer_itself(traced: Traced) -> None:
    caller = CALLER.replace(
        "self.client.call_async(Trigger.Request()).add_done_callback(self.on_answer)", "self.wait()"
    )
    caller += """
def wait(self):
    answer = self.client.call(Trigger.Request())
    self.pub.publish(String(data=answer.message))
"""
    traced(caller=caller, server=SERVER)
    assert traced.before("/said") == {"Caller.ask", "answer /stop", "Server.stop", "service /stop"}


def test_goals_and_their_results(traced: Traced) -> None:
    traced(
        client="""
        def __init__(self):
            super().__init__("client")
            self.client = ActionClient(self, Fibonacci, "count")
            self.pub = self.create_publisher(String, "counted", 10)
            self.create_timer(1.0, self.ask)

        def ask(self):
            self.client.send_goal_async(Fibonacci.Goal(), feedback_callback=self.on_feedback)

        def on_feedback(self, feedback):
            self.pub.publish(String())
        """,
        server="""
        def __init__(self):
            super().__init__("server")
            self.server = ActionServer(self, Fibonacci, "count", self.execute)

        def execute(self, goal):
            goal.succeed()
            return Fibonacci.Result()
        """,
    )
    counted = traced.before("/counted")
    assert counted == {"Client.on_feedback", "result /count", "Server.execute", "action /count", "Client.ask"}


def test_filtered_messages_come_together(traced: Traced) -> None:
    traced(
        fuser="""
        def __init__(self):
            super().__init__("fuser")
            self.left = message_filters.Subscriber(self, String, "left")
            self.right = message_filters.Subscriber(self, String, "right")
            self.both = message_filters.TimeSynchronizer([self.left, self.right], 10)
            self.both.registerCallback(self.on_both)
            self.pub = self.create_publisher(String, "fused", 10)

        def on_both(self, left, right):
            self.pub.publish(left)
        """
    )
    assert traced.before("/fused") == {"Fuser.on_both", "topic /left", "topic /right"}


def test_a_client_that_is_never_used_calls_nothing(traced: Traced) -> None:
    traced(caller=CALLER.replace("self.create_timer", "# "), server=SERVER)
    traced(
        other="""
        def __init__(self):
            super().__init__("other")
            self.unused = self.create_client(Trigger, "stop")
        """
    )
    [link] = links_of(traced.flow, "unknown idle", "service /stop")
    assert link.broken == "no call of it is seen"


def test_what_publishes_is_not_known_where_a_publisher_is_handed_away(traced: Traced) -> None:
    traced(
        giver="""
        def __init__(self):
            super().__init__("giver")
            self.pub = self.create_publisher(String, "given", 10)
            self.create_subscription(String, "order", self.on_order, 10)

        def on_order(self, message):
            elsewhere.work(self.pub)
        """
    )
    [link] = links_of(traced.flow, "unknown sender", "topic /given")
    assert (link.doubt, link.broken) == ("where it is published is not known", "")
    assert traced.before("/given") == {"unknown sender", "Giver.on_order", "topic /order"}


def test_incompatible_qos_carries_nothing(traced: Traced) -> None:
    best_effort = TALKER.replace('"chatter", 10)', '"chatter", rclpy.qos.qos_profile_sensor_data)')
    traced(talker=best_effort, relay=RELAY)
    [link] = links_of(traced.flow, "topic /chatter", "Relay.on_chatter")
    assert link.broken == "best effort offered, reliable requested"
    assert traced.before("/relayed") == {"Relay.on_chatter"}


def test_a_method_that_nothing_calls_sends_nothing(traced: Traced) -> None:
    traced(relay=RELAY + '\ndef say(self):\n    self.pub.publish(String(data="never"))\n')
    [link] = links_of(traced.flow, "Relay.say", "topic /relayed")
    assert link.broken == "nothing here calls this method"
