"""EXE014: waits that can take all threads of an executor."""

from __future__ import annotations

import pytest

from checks.callbacks import Run, codes, source

FOUR = """
def main():
    rclpy.init()
    executor = MultiThreadedExecutor(num_threads=4)
    executor.add_node(Robot())
    executor.spin()


if __name__ == '__main__':
    main()
"""
DEFAULT = FOUR.replace("num_threads=4", "")
TWO = FOUR.replace("num_threads=4", "num_threads=2")


def reentrant(wait: str, period: str = "0.1", before: str = "") -> tuple[str, str]:
    constructor = f"""
        self.on = False
        group = ReentrantCallbackGroup()
        self.client = self.create_client(SetBool, 'enable', callback_group=group)
        self.timer = self.create_timer({period}, self.tick, callback_group=group)
    """
    return constructor, f"def tick(self):\n{before}    answer = self.client.{wait}\n    print(answer)\n"


@pytest.mark.parametrize("main", [FOUR, DEFAULT])
def test_a_timer_that_waits_without_limit_beside_itself(run: Run, main: str):
    (found,) = run(source(*reentrant("call(SetBool.Request(data=self.on))"), main))
    assert found.code == "EXE014"
    assert "starts again every 0.1 s while it still waits for the service 'enable'" in found.message
    assert "call_async() and continue in a done callback" in (found.help or "")


@pytest.mark.parametrize(
    ("limit", "period", "starves"),
    [("1.0", "0.1", True), ("0.2", "0.1", False), ("0.4", "0.1", True), ("2.0", "0.5", True), ("1.5", "0.5", False)],
)
def test_a_limit_helps_where_it_ends_before_the_last_thread_is_taken(run: Run, limit: str, period: str, starves: bool):
    found = run(source(*reentrant(f"call(SetBool.Request(data=self.on), timeout_sec={limit})", period), FOUR), "jazzy")
    assert codes(found) == (["EXE014"] if starves else [])


GRIPPER = """
class Caller(Node):
    def __init__(self):
        super().__init__('caller')
        self.client = self.create_client(Trigger, 'close')
        self.create_timer({period}, self.ask)

    def ask(self):
        self.client.call_async(Trigger.Request())


def main():
    rclpy.init()
    executor = MultiThreadedExecutor(num_threads=2)
    executor.add_node(Robot())
    executor.add_node(Caller())
    executor.spin()


if __name__ == '__main__':
    main()
"""


@pytest.mark.parametrize(
    ("limit", "period", "group", "starves"),
    [
        ("0.5", "0.2", "ReentrantCallbackGroup()", True),
        ("0.1", "0.2", "ReentrantCallbackGroup()", False),  # ends before the next request
        ("0.5", "5.0", "ReentrantCallbackGroup()", False),  # called seldom
        ("0.5", "0.2", "MutuallyExclusiveCallbackGroup()", False),  # one request at a time
    ],
)
def test_a_service_that_is_called_while_it_waits(run: Run, limit: str, period: str, group: str, starves: bool):
    constructor = f"""
        self.client = self.create_client(SetBool, 'enable', callback_group=ReentrantCallbackGroup())
        self.create_service(Trigger, 'close', self.close, callback_group={group})
    """
    handler = f"""
    def close(self, request, response):
        answer = self.client.call(SetBool.Request(data=True), timeout_sec={limit})
        response.success = answer is not None and answer.success
        return response
    """
    found = run(source(constructor, handler, GRIPPER.format(period=period)), "jazzy")
    assert [one.code for one in found if one.code in ("EXE014", "SRV003")] == (["EXE014"] if starves else [])
    for one in found:
        if one.code == "EXE014":
            assert "starts again every 0.2 s" in one.message and "every wait then times out" in one.message
            assert one.help.startswith("give Robot.close its own MutuallyExclusiveCallbackGroup()")


def test_how_many_threads_the_default_has_is_not_known(run: Run):
    assert run(source(*reentrant("call(SetBool.Request(data=self.on), timeout_sec=1.0)"), DEFAULT), "jazzy") == []


@pytest.mark.parametrize(
    ("wait", "period", "before"),
    [
        ("call(SetBool.Request(data=self.on))", "5.0", ""),  # seldom
        ("call(SetBool.Request(data=self.on))", "0.1", "    if self.on:\n        return\n"),  # not each time
        ("call(SetBool.Request(data=self.on))", "0.1", "    self.timer.cancel()\n"),  # once
        ("call(SetBool.Request(data=self.on))", "0.1", "    self.asked = True\n"),  # somebody may ask for that
    ],
)
def test_what_does_not_come_often_is_not_reported(run: Run, wait: str, period: str, before: str):
    assert "EXE014" not in codes(run(source(*reentrant(wait, period, before), FOUR)))


def test_a_variable_that_ends_with_the_callback_keeps_nobody_from_the_next_wait(run: Run):
    local = reentrant("call(SetBool.Request(data=self.on))", before="    asked = True\n")
    assert "EXE014" in codes(run(source(*local, FOUR)))
    shared = reentrant("call(SetBool.Request(data=self.on))", before="    global asked\n    asked = True\n")
    assert "EXE014" not in codes(run(source(*shared, FOUR)))


def test_a_done_callback_and_an_await_keep_no_thread(run: Run):
    sent = "call_async(SetBool.Request(data=self.on)).add_done_callback(print)"
    assert run(source(*reentrant(sent), FOUR)) == []
    constructor, tick = reentrant("call_async(SetBool.Request(data=self.on))")
    awaited = tick.replace("def tick", "async def tick").replace("answer = ", "answer = await ")
    assert run(source(constructor, awaited, FOUR)) == []


TWO_TIMERS = """
    self.on = False
    answers = MutuallyExclusiveCallbackGroup()
    self.arm = self.create_client(SetBool, 'arm', callback_group=answers)
    self.base = self.create_client(SetBool, 'base', callback_group=answers)
    self.create_timer(2.0, self.ask_arm, callback_group=MutuallyExclusiveCallbackGroup())
    self.create_timer(2.0, self.ask_base{group})
"""
ASK_BOTH = """
    def ask_arm(self):
        print(self.arm.call(SetBool.Request(data=self.on)))

    def ask_base(self):
        print(self.base.call(SetBool.Request(data=self.on)))
"""


def test_as_many_waiting_callbacks_as_threads(run: Run):
    text = source(TWO_TIMERS.format(group=""), ASK_BOTH, TWO)
    (found,) = [one for one in run(text) if one.code == "EXE014"]
    assert text.splitlines()[found.place.line - 1].strip() == "executor = MultiThreadedExecutor(num_threads=2)"
    assert "Robot.ask_arm and Robot.ask_base may wait at the same time" in found.message
    assert found.help == "num_threads=3: one more than there are waiting callbacks"


def test_a_thread_more_than_waiting_callbacks_is_enough(run: Run):
    three = TWO.replace("num_threads=2", "num_threads=3")
    assert "EXE014" not in codes(run(source(TWO_TIMERS.format(group=""), ASK_BOTH, three)))


def test_callbacks_of_one_group_do_not_wait_at_the_same_time(run: Run):
    one_group = TWO_TIMERS.replace("callback_group=MutuallyExclusiveCallbackGroup())", "callback_group=self.one)")
    text = source(
        "self.one = MutuallyExclusiveCallbackGroup()" + one_group.format(group=", callback_group=self.one"),
        ASK_BOTH,
        TWO,
    )
    assert "EXE014" not in codes(run(text))


POLLED = """
def tick(self):
    future = self.client.call_async(SetBool.Request(data=self.on))
    {before}while not future.done(){clock}:
        time.sleep(0.01)
    print(future.result())
"""


@pytest.mark.parametrize(
    ("before", "clock", "starves"),
    [
        ("", "", True),
        ("end = time.monotonic() + 1.0\n    ", " and time.monotonic() < end", True),
        ("end = time.monotonic() + 0.2\n    ", " and time.monotonic() < end", False),  # over before the last thread
    ],
)
def test_a_loop_until_the_answer_is_there_takes_threads_like_a_call(run: Run, before: str, clock: str, starves: bool):
    constructor, _ = reentrant("")
    text = source(constructor, POLLED.format(before=before, clock=clock), FOUR)
    found = [one for one in run(text) if one.code == "EXE014"]
    assert [text.splitlines()[one.place.line - 1].strip()[:5] for one in found] == (["while"] if starves else [])


def test_an_event_that_is_made_each_time(run: Run):
    ask = """
    def ask_arm(self):
        self.ask()

    def ask_base(self):
        self.ask()

    def ask(self):
        came = threading.Event()
        self.arm.call_async(SetBool.Request(data=self.on)).add_done_callback(lambda _: came.set())
        came.wait()
    """
    found = [one for one in run(source(TWO_TIMERS.format(group=""), ask, TWO)) if one.code == "EXE014"]
    assert [one.message.partition(",")[0] for one in found] == [
        "Robot.ask_arm and Robot.ask_base may wait at the same time"
    ]


LIMITED = ASK_BOTH.replace("data=self.on))", "data=self.on), timeout_sec=1.0)")


def test_two_timers_of_one_period_run_into_their_limits_together(run: Run):
    (found,) = [one for one in run(source(TWO_TIMERS.format(group=""), LIMITED, TWO), "jazzy") if one.code == "EXE014"]
    assert "wait at the same time, and this executor has 2 threads" in found.message
    assert "they time out" in found.message


@pytest.mark.parametrize(
    "timers",
    [
        TWO_TIMERS.replace("create_timer(2.0, self.ask_arm", "create_timer(3.0, self.ask_arm"),
        TWO_TIMERS.replace(
            "    self.create_timer(2.0, self.ask_base", "    time.sleep(0.5)\n    self.create_timer(2.0, self.ask_base"
        ),
    ],
    ids=["other periods", "one begins later"],
)
def test_timers_that_seldom_meet_are_left_alone_where_their_waits_end(run: Run, timers: str):
    assert "EXE014" not in codes(run(source(timers.format(group=""), LIMITED, TWO), "jazzy"))


LISTENS = """
    group = ReentrantCallbackGroup()
    self.client = self.create_client(Trigger, 'ask', callback_group=group)
    self.create_subscription(Empty, 'go', self.on_go, 10, callback_group=group)
"""
ASKS = "def on_go(self, message):\n    print(self.client.call(Trigger.Request()))\n"
SENDER = """

class Sender(Node):
    def __init__(self):
        super().__init__('sender')
        self.sender = self.create_publisher(Empty, 'go', 10)
        self.timer = self.create_timer({period}, self.send)

    def send(self):
        {before}self.sender.publish(Empty())
"""
BOTH = TWO.replace("executor.add_node(Robot())", "executor.add_node(Robot())\n    executor.add_node(Sender())")


def test_a_subscription_to_what_a_timer_publishes(run: Run):
    [found] = run(source(LISTENS, ASKS, SENDER.format(period=0.2, before="") + BOTH))
    assert found.code == "EXE014" and "starts again every 0.2 s while it still waits" in found.message
    assert found.related[-1].message == "it is published here every 0.2 s"


@pytest.mark.parametrize(
    ("period", "before"), [("5.0", ""), ("0.2", "if self.count_subscribers('go') > 2: "), ("float(input())", "")]
)
def test_a_subscription_to_what_comes_seldom_or_nobody_knows_when(run: Run, period: str, before: str):
    [found] = run(source(LISTENS, ASKS, SENDER.format(period=period, before=before) + BOTH))
    assert found.code == "TMO002"
    assert "if messages come faster than responses, all threads wait" in found.message


def test_goals_run_beside_each_other(run: Run):
    serves = """
        self.client = self.create_client(Trigger, 'ask', callback_group=ReentrantCallbackGroup())
        self.server = ActionServer(self, Fibonacci, 'count', self.count)
    """
    counts = (
        "def count(self, goal):\n    self.client.call(Trigger.Request())\n"
        "    goal.succeed()\n    return Fibonacci.Result()\n"
    )
    [found] = run(source(serves, counts, TWO))
    assert found.code == "TMO002" and "if goals come faster than responses" in found.message
    sender = SENDER.format(period=0.2, before="").replace("create_publisher(Empty, 'go', 10)", "goals")
    sender = sender.replace("self.goals", "ActionClient(self, Fibonacci, 'count')")
    sender = sender.replace("publish(Empty())", "send_goal_async(Fibonacci.Goal())")
    [found] = run(source(serves, counts, sender + BOTH))
    assert found.code == "EXE014" and found.related[-1].message == "a goal is sent here every 0.2 s"


HEARS = """
    self.came = threading.Event()
    group = ReentrantCallbackGroup()
    self.create_subscription(Empty, 'news', self.on_news, 10, callback_group=group)
    self.timer = self.create_timer({period}, self.tick, callback_group={group})
"""
WAITS_FOR_NEWS = """
def tick(self):
    self.came.clear()
    {before}self.came.wait({limit})

def on_news(self, message):
    self.came.set()
"""


def news(period: str = "0.2", group: str = "group", before: str = "", limit: str = "") -> str:
    return source(HEARS.format(period=period, group=group), WAITS_FOR_NEWS.format(before=before, limit=limit), TWO)


def test_a_timer_that_waits_beside_itself_for_an_event(run: Run):
    text = news()
    (found,) = [one for one in run(text) if one.code == "EXE014"]
    assert text.splitlines()[found.place.line - 1].strip() == "self.came.wait()"
    assert "starts again every 0.2 s while it still waits for an event that Robot.on_news sets" in found.message
    assert found.message.endswith("all 2 threads wait, and no thread is left to run Robot.on_news: it then deadlocks")
    assert (found.help or "").startswith("give Robot.tick its own MutuallyExclusiveCallbackGroup()")
    (found,) = [one for one in run(news(limit="timeout=0.5")) if one.code == "EXE014"]
    assert found.message.endswith("every wait then times out")


@pytest.mark.parametrize(
    "text",
    [
        news(group="MutuallyExclusiveCallbackGroup()"),  # as the help says
        news(limit="timeout=0.1"),  # ends before the second thread is taken
        news(period="5.0"),
        news(before="if self.count_publishers('news'):\n        "),
        news()
        .replace("self.on_news, 10, callback_group=group", "print, 10")
        .replace("def on_news(self, message)", "def on(self)"),
    ],
)
def test_an_event_that_leaves_a_thread(run: Run, text: str):
    assert "EXE014" not in codes(run(text))


def test_requests_that_come_while_a_handler_waits_for_an_event(run: Run):
    made = """
        self.came = threading.Event()
        group = ReentrantCallbackGroup()
        self.create_subscription(Empty, 'news', self.on_news, 10, callback_group=group)
        self.create_service(Trigger, 'look', self.look, callback_group=group)
    """
    methods = WAITS_FOR_NEWS.format(before="", limit="").replace("def tick(self)", "def look(self, request, response)")
    methods = methods.replace("self.came.wait()", "self.came.wait()\n    return response")
    asks = SENDER.format(period="0.2", before="")
    asks = asks.replace("self.create_publisher(Empty, 'go', 10)", "self.create_client(Trigger, 'look')")
    asks = asks.replace("self.sender.publish(Empty())", "self.sender.call_async(Trigger.Request())")
    (found,) = [one for one in run(source(made, methods, asks + BOTH)) if one.code == "EXE014"]
    assert "starts again every 0.2 s" in found.message
    assert [one.message for one in found.related if "every" in one.message] == ["it is called here every 0.2 s"]
    assert "EXE014" not in codes(run(source(made, methods, TWO)))  # nothing says how often


def sleeping(frequency: str, period: str = "0.2", sleep: str = "self.rate.sleep()") -> tuple[str, str]:
    constructor = f"""
        self.on = False
        self.rate = self.create_rate({frequency})
        self.create_timer({period}, self.tick, callback_group=ReentrantCallbackGroup())
    """
    return constructor, f"def tick(self):\n    {sleep}\n    print(self.on)\n"


def test_a_rate_that_takes_all_threads_before_its_own_timer_gets_one(run: Run):
    (found,) = run(source(*sleeping("2.0"), TWO))
    assert found.code == "EXE014"
    assert (
        "starts again every 0.2 s while it still sleeps for up to 0.5 s in Rate.sleep(): all 2 threads sleep"
        in found.message
    )


@pytest.mark.parametrize(
    ("frequency", "period", "main"),
    [
        ("2.0", "0.2", FOUR),  # two or three sleep at a time
        ("2.0", "0.2", DEFAULT),  # the machine decides how many threads there are
        ("2.0", "0.5", TWO),  # each is awake before the next one starts
        ("float(input())", "0.2", TWO),
        ("0.0", "0.2", TWO),
    ],
)
def test_a_rate_that_leaves_a_thread_is_not_reported(run: Run, frequency: str, period: str, main: str):
    assert run(source(*sleeping(frequency, period), main)) == []


def test_a_rate_of_another_node_or_a_sleep_that_does_not_come_each_time_is_not_reported(run: Run):
    assert run(source(*sleeping("2.0", sleep="if self.on:\n        return\n    self.rate.sleep()"), TWO)) == []
    helper = sleeping("2.0")[0].replace("self.create_rate", "rclpy.create_node('helper').create_rate")
    assert run(source(helper, sleeping("2.0")[1], TWO)) == []
