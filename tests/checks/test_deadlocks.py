"""What a callback can wait for, and what it cannot: SRV003, EXE001, EXE002 and CBG001."""

from __future__ import annotations

import textwrap
from pathlib import Path

import pytest

from archlint.finding import Severity
from checks.callbacks import IMPORTS, ON_ONE_THREAD, ON_SEVERAL_THREADS, Run, codes, source
from checks.judging import Judge

CLIENT = "self.client = self.create_client(Trigger, 'check')\n"
CLIENT_APART = (
    "apart = MutuallyExclusiveCallbackGroup()\n"
    "self.client = self.create_client(Trigger, 'check', callback_group=apart)\n"
)
TIMER = "self.create_timer(5.0, self.tick)\n"
HANDLER = "self.create_service(Trigger, 'go', self.tick)\n"
SERVER = "self.server = ActionServer(self, Fibonacci, 'count', self.execute)\n"
CALL = """
def tick(self):
    answer = self.client.call(Trigger.Request(), timeout_sec=1.0)
    self.get_logger().info(str(answer))
"""
AWAIT = """
async def tick(self):
    answer = await self.client.call_async(Trigger.Request())
    self.get_logger().info(str(answer))
"""


# ---------------------------------------------------------------------------------- executor, group and form


@pytest.mark.parametrize(
    ("client", "method", "main", "expected"),
    [
        pytest.param(CLIENT, CALL, ON_ONE_THREAD, ["EXE002"], id="call, one thread"),
        pytest.param(CLIENT_APART, CALL, ON_ONE_THREAD, ["CBG002", "EXE002"], id="call, one thread, group apart"),
        pytest.param(CLIENT, CALL, ON_SEVERAL_THREADS, ["CBG001"], id="call, several threads, one group"),
        pytest.param(CLIENT_APART, CALL, ON_SEVERAL_THREADS, [], id="call, several threads, group apart"),
        pytest.param(CLIENT, AWAIT, ON_ONE_THREAD, ["EXE002"], id="await, one thread, one group"),
        pytest.param(CLIENT, AWAIT, ON_SEVERAL_THREADS, ["CBG001"], id="await, several threads, one group"),
        pytest.param(CLIENT_APART, AWAIT, ON_ONE_THREAD, [], id="await, one thread, group apart"),
        pytest.param(CLIENT_APART, AWAIT, ON_SEVERAL_THREADS, [], id="await, several threads, group apart"),
    ],
)
def test_executor_and_group_decide_whether_a_timer_may_wait(
    run: Run, client: str, method: str, main: str, expected: list[str]
):
    assert codes(run(source(client + TIMER, method, main))) == expected


def test_a_pool_of_one_thread_is_one_thread(run: Run):
    main = ON_SEVERAL_THREADS.replace("MultiThreadedExecutor()", "MultiThreadedExecutor(num_threads=1)")
    assert "EXE002" in codes(run(source(CLIENT_APART + TIMER, CALL, main)))


def test_what_a_timeout_does_depends_on_the_distribution(run: Run):
    text = source(CLIENT + TIMER, CALL)
    [jazzy] = run(text, distro="jazzy")
    [rolling] = run(text, distro="rolling")
    [every] = run(text)
    assert "always times out and returns None:" in jazzy.message
    assert "always times out and raises TimeoutError:" in rolling.message
    assert "returns None in jazzy" in every.message and "raises TimeoutError from kilted on" in every.message


def test_a_finding_shows_the_way_from_the_callback_to_the_executor(run: Run):
    method = CALL.replace("def tick(self):", "def tick(self):\n    self.ask()\n\ndef ask(self):")
    [found] = run(source(CLIENT + TIMER, method))
    assert [related.message for related in found.related] == [
        "Robot.tick is a timer callback",
        "the callback is registered here",
        "Robot.tick calls Robot.ask here",
        "the client is created here",
        "a single-threaded executor spins the node",
    ]


# --------------------------------------------------------------------------------------- callbacks in no group


def test_an_execute_callback_holds_no_group(run: Run):
    setup = CLIENT + "self.server = ActionServer(self, Fibonacci, 'count', self.execute)\n"
    method = """
    def execute(self, goal_handle):
        self.client.call(Trigger.Request(), timeout_sec=1.0)
        goal_handle.succeed()
        return Fibonacci.Result()
    """
    assert codes(run(source(setup, method, ON_SEVERAL_THREADS))) == []
    assert codes(run(source(setup, method, ON_ONE_THREAD))) == ["EXE002"]


def test_a_done_callback_that_waits_needs_a_second_thread(run: Run):
    method = """
    def tick(self):
        self.client.call_async(Trigger.Request()).add_done_callback(self.on_answer)

    def on_answer(self, future):
        self.client.call(Trigger.Request(), timeout_sec=1.0)
    """
    assert codes(run(source(CLIENT + TIMER, method, ON_ONE_THREAD))) == ["EXE002"]
    assert codes(run(source(CLIENT + TIMER, method, ON_SEVERAL_THREADS))) == []


# -------------------------------------------------------------------------------------------- other waits


def test_a_result_read_straight_after_the_request_is_none(run: Run):
    method = """
    def tick(self):
        future = self.client.call_async(Trigger.Request())
        self.get_logger().info(future.result().message)
    """
    [found] = run(source(CLIENT + TIMER, method))
    assert found.code == "EXE002" and "right after call_async()" in found.message


@pytest.mark.parametrize(
    ("then", "expected"),
    [
        pytest.param("await future\nanswer = future.result()", [], id="awaited as a statement"),
        pytest.param("first = await future\nanswer = future.result()", [], id="awaited into a variable"),
        pytest.param("await asked\nanswer = future.result()", [], id="something else is awaited: time passes"),
        pytest.param("answer = (await future, future.result())", [], id="awaited in the same statement"),
        pytest.param("answer = future.result()\nawait future", ["EXE002"], id="awaited too late"),
        pytest.param(
            "answer = await self.answered.keep(future.result())", ["EXE002"], id="what it has read is awaited"
        ),
        pytest.param("if self.is_patient:\n    await future\nanswer = future.result()", [], id="perhaps awaited"),
    ],
)
def test_a_future_that_was_awaited_has_its_result(run: Run, then: str, expected: list[str]):
    ask = "asked = self.client.call_async(Trigger.Request())\nfuture = self.client.call_async(Trigger.Request())\n"
    body = textwrap.indent(ask + then, "    ")
    assert codes(run(source(CLIENT_APART + TIMER, f"async def tick(self):\n{body}\n"))) == expected


@pytest.mark.parametrize(
    ("then", "expected"),
    [
        pytest.param("if self.is_patient:\n    answer = future.result()", ["EXE002"], id="in a branch"),
        pytest.param("if self.is_patient:\n    print()\nanswer = future.result()", ["EXE002"], id="after a branch"),
        pytest.param("if self.answered.waits_for(future):\n    answer = future.result()", [], id="a function may wait"),
        pytest.param("if future in self.answered:\n    answer = future.result()", [], id="a test of the future"),
        pytest.param("while self.is_patient:\n    pass\nanswer = future.result()", [], id="a loop may wait"),
        pytest.param("future = self.answered\nanswer = future.result()", [], id="another future"),
    ],
)
def test_a_result_on_another_line_of_the_same_way(run: Run, then: str, expected: list[str]):
    body = textwrap.indent("future = self.client.call_async(Trigger.Request())\n" + then, "    ")
    assert codes(run(source(CLIENT + TIMER, f"def tick(self):\n{body}\n"))) == expected


def test_a_goal_and_its_result_may_be_awaited_one_after_the_other(run: Run):
    create = "self.client = ActionClient(self, Fibonacci, 'plan')\nActionServer(self, Fibonacci, 'go', self.execute)\n"
    method = """
    async def execute(self, goal_handle):
        sent = self.client.send_goal_async(Fibonacci.Goal())
        await sent
        asked = sent.result().get_result_async()
        await asked
        goal_handle.succeed()
        return Fibonacci.Result(sequence=asked.result().result.sequence)
    """
    assert codes(run(source(create, method))) == []


def test_a_result_that_is_asked_for_when_it_is_done_is_there(run: Run):
    method = """
    def tick(self):
        if self.future is None:
            self.future = self.client.call_async(Trigger.Request())
        elif self.future.done():
            self.get_logger().info(self.future.result().message)
    """
    assert codes(run(source(CLIENT + "self.future = None\n" + TIMER, method))) == []


@pytest.mark.parametrize(
    ("test", "words"),
    [
        ("not future.done()", "deadlocks"),
        ("rclpy.ok() and not future.done()", "deadlocks"),
        ("not future.done() and time.time() < end", "always times out"),
    ],
)
def test_a_loop_around_a_future_waits_as_long_as_its_test_lets_it(run: Run, test: str, words: str):
    method = f"""
    def tick(self):
        end = time.time() + 3.0
        future = self.client.call_async(Trigger.Request())
        while {test}:
            time.sleep(0.01)
    """
    [found] = run(source(CLIENT + TIMER, method))
    assert found.code == "EXE002" and f"and {words}:" in found.message


def test_an_event_that_a_callback_of_the_same_group_sets_never_comes(run: Run):
    setup = "self.there = threading.Event()\nself.create_subscription(Empty, 'there', self.on_there, 10)\n" + TIMER
    method = """
    def on_there(self, message):
        self.there.set()

    def tick(self):
        self.there.wait()
    """
    assert codes(run(source(setup, method, ON_ONE_THREAD))) == ["EXE002"]
    assert codes(run(source(setup, method, ON_SEVERAL_THREADS))) == ["EXE002"]
    apart = setup.replace("self.tick", "self.tick, callback_group=MutuallyExclusiveCallbackGroup()")
    assert codes(run(source(apart, method, ON_SEVERAL_THREADS))) == []


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        ("if self.pose is None:\n            return\n        self.there.wait()", []),
        ("if not self.pose:\n            return\n        self.there.wait()", []),
        ("if self.pose is not None:\n            self.there.wait()", []),
        ("if self.pose is None:\n            return\n        self.read()", []),
        ("if self.pose is not None:\n            return\n        self.there.wait()", ["EXE002"]),
        ("if self.pose is None:\n            self.there.wait()", ["EXE002"]),
        ("if self.pose is None:\n            print('no pose')\n        self.there.wait()", ["EXE002"]),
        ("if self.goal is None:\n            return\n        self.there.wait()", ["EXE002"]),
        ("if self.both is None:\n            return\n        self.there.wait()", ["EXE002"]),
        (
            "if self.pose is None:\n            return\n        self.there.clear()\n        self.there.wait()",
            ["EXE002"],
        ),
    ],
)
def test_an_event_that_is_set_together_with_what_a_guard_asks_for(run: Run, body: str, expected: list[str]):
    setup = """
self.there = threading.Event()
self.pose = self.goal = self.both = None
self.create_subscription(Empty, 'there', self.on_there, 10)
self.create_subscription(Empty, 'goal', self.on_goal, 10)
"""
    method = f"""
    def on_there(self, message):
        self.pose = message
        self.both = message
        self.there.set()

    def on_goal(self, message):
        self.goal = message
        self.both = message

    def read(self):
        self.there.wait()
        return self.pose

    def tick(self):
        {body}
    """
    assert codes(run(source(setup + TIMER, method, ON_ONE_THREAD))) == expected
    cleared = setup.replace("Event()", "Event()\nself.there.clear()")  # as new as it was
    assert codes(run(source(cleared + TIMER, method, ON_ONE_THREAD))) == expected


CAMERAS = """
class File:
    threaded = False

    def __init__(self, node):
        self.there = None

    def frame(self, fresh=False):
        return read()


class Topic(File):
    def __init__(self, node):
        self.there = threading.Event()
        node.create_subscription(Empty, 'frames', self.on_frame, 10)

    def on_frame(self, message):
        self.there.set()

    def frame(self, fresh=False):
        if fresh:
            self.there.wait(0.1)
        return read()


"""


@pytest.mark.parametrize(
    ("camera", "expected"),
    [
        ("Topic(self) if read() else File(self)", []),
        ("open_camera(self)", []),
        ("Topic(self)", ["EXE002"]),
    ],
)
def test_an_event_in_one_of_several_objects(run: Run, camera: str, expected: list[str]):
    method = "def tick(self):\n    self.camera.frame(fresh=getattr(self.camera, 'kind', read()))\n"
    text = source(f"self.camera = {camera}\n{TIMER}", method).replace("class Robot", CAMERAS + "class Robot", 1)
    assert [one for one in codes(run(text)) if one == "EXE002"] == expected


def test_an_event_that_a_done_callback_sets_is_the_answer(run: Run):
    method = """
    def tick(self):
        there = threading.Event()
        self.client.call_async(Trigger.Request()).add_done_callback(lambda future: there.set())
        there.wait()
    """
    assert codes(run(source(CLIENT + TIMER, method, ON_ONE_THREAD))) == ["EXE002"]
    assert codes(run(source(CLIENT_APART + TIMER, method, ON_SEVERAL_THREADS))) == []


# ------------------------------------------------------------------------------------------------- spins


def test_a_nested_spin_does_something_else_in_each_distribution(run: Run):
    method = """
    def tick(self):
        future = self.client.call_async(Trigger.Request())
        rclpy.spin_until_future_complete(self, future, timeout_sec=1.0)
    """
    text = source(CLIENT + TIMER, method)
    [humble] = run(text, distro="humble")
    [jazzy] = run(text, distro="jazzy")
    assert humble.code == jazzy.code == "EXE001"
    assert "always times out" in humble.message
    assert "raises 'Executor is already spinning'" in jazzy.message


ANSWER_AND_MORE = """
def tick(self):
    future = self.client.call_async(Trigger.Request())
    rclpy.spin_until_future_complete(self, future, timeout_sec=1.0)
    rclpy.spin_once(self, timeout_sec=0.1)
"""
ROUND_BY_ROUND = ON_ONE_THREAD.replace("rclpy.spin(Robot())", "node = Robot()\n    while rclpy.ok():\n        {}")
LOST = "; in humble before rclpy 3.3.17 it takes the node away from its executor, so none of its callbacks runs again"


def test_spin_once_loses_the_node_in_humble_and_leads_what_works_there(run: Run):
    apart = "group = ReentrantCallbackGroup()\n"
    apart += "self.client = self.create_client(Trigger, 'check', callback_group=group)\n" + TIMER
    [found] = run(source(apart, ANSWER_AND_MORE))
    assert found.code == "EXE001" and found.severity is Severity.ERROR and LOST in found.message
    [first] = [each for each in found.related if each.message == "it spins here, too"]
    assert first.place.line == found.place.line - 1
    [alone] = run(source(apart, ANSWER_AND_MORE.replace("rclpy.spin_once", "print")))
    assert alone.severity is Severity.WARNING


@pytest.mark.parametrize(
    ("main", "lost"),
    [
        (ON_ONE_THREAD, True),
        (ROUND_BY_ROUND.format("rclpy.spin_once(node)"), False),  # each round adds the node again
    ],
)
def test_who_gives_the_node_back_to_its_executor(run: Run, main: str, lost: bool):
    found = run(source(TIMER, "def tick(self):\n    rclpy.spin_once(self, timeout_sec=0.1)\n", main))
    assert [LOST in one.message for one in found if one.code == "EXE001"] == [lost]


def test_a_spin_on_another_executor_strands_the_node(run: Run):
    method = """
    def tick(self):
        rclpy.spin_once(self, timeout_sec=0.1)
    """
    [found] = run(source(TIMER, method, ON_SEVERAL_THREADS))
    assert found.code == "EXE001" and "none of its callbacks runs again" in found.message


@pytest.mark.parametrize(
    ("setup", "head", "main", "advice"),
    [
        (
            HANDLER,
            "def tick(self, request, response):",
            ON_SEVERAL_THREADS,
            "wait for a threading.Event with a timeout",
        ),
        (
            HANDLER,
            "def tick(self, request, response):",
            ON_ONE_THREAD,
            "spin the node with a MultiThreadedExecutor, and wait for a threading.Event",
        ),
        (SERVER, "def execute(self, goal_handle):", ON_SEVERAL_THREADS, "use time.sleep(…)"),
        (
            SERVER,
            "def execute(self, goal_handle):",
            ON_ONE_THREAD,
            "spin the node with a MultiThreadedExecutor, and use time.sleep",
        ),
        (TIMER, "def tick(self):", ON_SEVERAL_THREADS, "return instead"),
    ],
)
def test_what_to_do_instead_of_a_loop_of_spins(run: Run, setup: str, head: str, main: str, advice: str):
    body = "    while load():\n        rclpy.spin_once(self, timeout_sec=0.1)\n"
    found = [one for one in run(source(setup, f"{head}\n{body}{body}", main)) if one.code == "EXE001"]
    [one] = found
    assert one.help.startswith(advice)
    assert [(r.message, r.place.line - one.place.line) for r in one.related][-1] == ("it spins here, too", 2)


def test_a_node_of_its_own_may_be_spun_while_another_executor_runs(run: Run):
    setup = "self.helper = rclpy.create_node('helper')\n"
    setup += "self.client = self.helper.create_client(Trigger, 'check')\n" + TIMER
    method = """
    def tick(self):
        future = self.client.call_async(Trigger.Request())
        rclpy.spin_until_future_complete(self.helper, future, timeout_sec=1.0)
    """
    assert codes(run(source(setup, method, ON_SEVERAL_THREADS))) == []
    assert codes(run(source(setup, method, ON_ONE_THREAD))) == ["EXE001"]


CAMERA = """
class Camera(Node):
    def __init__(self):
        super().__init__('camera')
        self.create_subscription(Empty, 'image', self.keep, 10)

    def keep(self, message):
        self.image = message


"""


@pytest.mark.parametrize(("image", "told"), [("ros:humble", 0), ("ros:jazzy", 1), ("ubuntu", 1)])
def test_what_works_in_the_only_distribution_that_a_workspace_is_for(run: Run, tmp_path: Path, image: str, told: int):
    (tmp_path / "Dockerfile").write_text(f"FROM {image}\n", encoding="utf-8")
    text = source("self.camera = Camera()\n" + TIMER, "def tick(self):\n    rclpy.spin_once(self.camera)\n")
    assert len(run(text.replace("class Robot", CAMERA + "class Robot"))) == told


def test_the_readme_at_the_top_says_more_than_those_of_copied_packages(run: Run, tmp_path: Path):
    (tmp_path / "README.md").write_text("Made with ROS 2 Humble.\n", encoding="utf-8")
    (tmp_path / "control").mkdir()
    (tmp_path / "control" / "README.md").write_text("| Humble | Iron | Rolling |\n", encoding="utf-8")
    text = source("self.camera = Camera()\n" + TIMER, "def tick(self):\n    rclpy.spin_once(self.camera)\n")
    text = text.replace("class Robot", CAMERA + "class Robot")
    assert run(text) == []
    (tmp_path / "README.md").write_text("A robot.\n", encoding="utf-8")
    assert len(run(text)) == 1


@pytest.mark.parametrize("head", ["def tick(self, request, response):", "def tick(self):"])
def test_a_node_that_only_a_callback_spins_needs_an_executor_of_its_own(run: Run, head: str):
    """Its groups are its own, so humble lets the spin in; but nothing else would ever run its callbacks."""
    setup = "self.camera = Camera()\n" + (HANDLER if "request" in head else TIMER)
    answer = "\n    return response" if "request" in head else ""
    method = f"{head}\n    rclpy.spin_once(self.camera)\n    self.newest()\n    rclpy.spin_once(self.camera){answer}\n"
    text = source(setup, method + "\ndef newest(self):\n    rclpy.spin_once(self.camera)\n")
    text = text.replace("class Robot", CAMERA + "class Robot")
    [found] = run(text)
    assert found.code == "EXE001" and "this works in humble and raises" in found.message
    assert found.severity is Severity.WARNING and run(text, distro="jazzy")[0].severity is Severity.ERROR
    assert found.help == (
        "add the other node to a SingleThreadedExecutor() of its own, and call that executor's spin_once() here"
    )
    assert [one.message for one in found.related].count("it spins here, too") == 2
    assert run(text, distro="humble") == []
    mended = text.replace("Camera()\n", "Camera()\n        self.eyes = SingleThreadedExecutor()\n", 1)
    mended = mended.replace(
        "self.eyes = SingleThreadedExecutor()\n",
        "self.eyes = SingleThreadedExecutor()\n        self.eyes.add_node(self.camera)\n",
    )
    assert run(mended.replace("rclpy.spin_once(self.camera)", "self.eyes.spin_once()")) == []


def test_an_executor_for_a_node_mends_all_callbacks_that_spin_it(run: Run):
    setup = f"self.camera = Camera()\n{TIMER}\nself.create_subscription(Empty, 'go', self.on_go, 10)\n"
    spin = "\n    rclpy.spin_once(self.camera)\n"
    text = source(setup, f"def tick(self):{spin}\ndef on_go(self, message):{spin}")
    [found] = run(text.replace("class Robot", CAMERA + "class Robot"))
    assert [row.message for row in found.related].count("it spins here, too") == 1


def test_a_node_that_a_thread_spins_as_well_needs_no_further_executor(run: Run):
    setup = "self.camera = Camera()\nthreading.Thread(target=rclpy.spin, args=(self.camera,), daemon=True).start()\n"
    text = source(setup + TIMER, "def tick(self):\n    rclpy.spin_once(self.camera)\n")
    [found] = [one for one in run(text.replace("class Robot", CAMERA + "class Robot")) if one.code == "EXE001"]
    assert found.help.startswith("return instead")


WHILE_NOBODY_SPINS = """
    import threading

    import rclpy
    from rclpy.callback_groups import ReentrantCallbackGroup
    from rclpy.executors import MultiThreadedExecutor
    from rclpy.node import Node
    from std_msgs.msg import Empty
    from std_srvs.srv import Trigger


    def is_up():
        return up if 'up' in globals() else False


    class Robot(Node):
        def __init__(self):
            super().__init__('robot')
            self.up = 'up' in globals()
            self.create_subscription(Empty, 'joy', self.on_joy, 10)
            self.client = self.create_client(Trigger, 'torque', callback_group=ReentrantCallbackGroup())

        def wait(self, future):
            if {test}:
                self.create_rate(20.0).sleep()
            else:
                rclpy.spin_until_future_complete(self, future)

        def on_joy(self, message):
            self.wait(self.client.call_async(Trigger.Request()))


    def start(node):
        global up
        {set}
        executor = MultiThreadedExecutor()
        executor.add_node(node)
        threading.Thread(target=executor.spin).start()


    def main():
        rclpy.init()
        start(Robot())


    if __name__ == '__main__':
        main()
"""


@pytest.mark.parametrize(
    ("test", "set_", "told"),
    [
        ("is_up()", "up = True", False),
        ("self.up", "node.up = True", False),
        ("is_up()", "up = False", True),
        ("self.client.service_is_ready()", "up = True", True),
    ],
)
def test_a_spin_for_as_long_as_nobody_else_spins(run: Run, test: str, set_: str, told: bool):
    text = WHILE_NOBODY_SPINS.replace("{test}", test).replace("{set}", set_)
    assert ("EXE001" in codes(run(textwrap.dedent(text).lstrip()))) == told


def test_another_node_of_the_executor_that_runs_is_taken_from_it(run: Run):
    setup = "self.client = helper.create_client(Trigger, 'check')\nself.helper = helper\n" + TIMER
    main = """
    def main():
        rclpy.init()
        helper = rclpy.create_node('helper')
        executor = MultiThreadedExecutor()
        executor.add_node(helper)
        executor.add_node(Robot(helper))
        executor.spin()


    if __name__ == '__main__':
        main()
    """
    method = """
    def tick(self):
        future = self.client.call_async(Trigger.Request())
        rclpy.spin_until_future_complete(self.helper, future, timeout_sec=1.0)
    """
    text = source(setup, method, main).replace("__init__(self)", "__init__(self, helper)", 1)
    [found] = run(text)
    assert (
        found.code == "EXE001"
        and "already spins that node: this takes the node away from its executor" in found.message
    )


@pytest.mark.parametrize(
    "wait",
    [
        pytest.param("rclpy.spin_until_future_complete(self, future, timeout_sec=1.0)", id="until it is done"),
        pytest.param("while not future.done():\n        rclpy.spin_once(self)", id="round by round"),
    ],
)
def test_a_handler_that_spins_for_an_answer_is_told_once(run: Run, wait: str):
    method = f"def tick(self, request, response):\n    future = self.client.call_async(Trigger.Request())\n    {wait}\n"
    [found] = run(source(CLIENT + HANDLER, method + "    return response\n"))
    assert found.code == "SRV003"
    assert "spins until the service 'check' has responded, and its executor is already spinning: this" in found.message


def test_a_handler_that_spins_for_anything_else_is_told_that_it_spins(run: Run):
    method = "def tick(self, request, response):\n    rclpy.spin_once(self, timeout_sec=0.1)\n    return response\n"
    assert codes(run(source(HANDLER, method))) == ["EXE001"]


@pytest.mark.parametrize(
    ("wait", "main"),
    [
        pytest.param(
            "future = self.client.call_async(Trigger.Request())\n"
            "while not future.done():\n    rclpy.spin_once(self.helper)\n    rclpy.spin_once(self)\n",
            ON_SEVERAL_THREADS,
            id="in the constructor",
        ),
        pytest.param(
            "self.ready = load()\n",
            ON_SEVERAL_THREADS.replace(
                "executor.add_node(Robot())",
                "robot = Robot()\n    while not robot.ready:\n        rclpy.spin_once(robot)\n"
                "    executor.add_node(robot)",
            ),
            id="in main, before the executor that stays",
        ),
    ],
)
def test_a_wait_loop_that_has_ended_is_not_the_executor_that_runs(run: Run, wait: str, main: str):
    setup = "self.helper = rclpy.create_node('helper')\n"
    setup += "self.client = self.helper.create_client(Trigger, 'check')\n" + wait + TIMER
    method = """
    def tick(self):
        future = self.client.call_async(Trigger.Request())
        rclpy.spin_until_future_complete(self.helper, future, timeout_sec=1.0)
    """
    assert codes(run(source(setup, method, main))) == []


def test_a_loop_of_spins_that_lasts_is_the_executor_that_runs(run: Run):
    main = ON_ONE_THREAD.replace(
        "rclpy.spin(Robot())", "robot = Robot()\n    while rclpy.ok():\n        rclpy.spin_once(robot)"
    )
    method = """
    def tick(self):
        future = self.client.call_async(Trigger.Request())
        rclpy.spin_until_future_complete(self, future, timeout_sec=1.0)
    """
    assert codes(run(source(CLIENT + TIMER, method, main))) == ["EXE001"]


# ----------------------------------------------------------------------------------- what must stay silent


def test_a_nested_call_that_cannot_deadlock_is_a_warning_that_says_so(run: Run):
    method = """
    def handle(self, request, response):
        answer = self.client.call(Trigger.Request())
        response.success = answer is not None
        return response
    """
    setup = CLIENT_APART + "self.create_service(Trigger, 'start', self.handle)\n"
    [found] = run(source(setup, method, ON_SEVERAL_THREADS))
    assert (found.code, found.severity) == ("SRV003", Severity.WARNING)
    assert "works here" in found.message and "its own caller waits" in found.message


def test_a_blocking_helper_that_only_main_calls_may_wait(run: Run):
    main = """
    def main():
        rclpy.init()
        robot = Robot()
        threading.Thread(target=rclpy.spin, args=(robot,), daemon=True).start()
        robot.tick()


    if __name__ == '__main__':
        main()
    """
    assert codes(run(source(CLIENT, CALL, main))) == []


def test_a_thread_of_its_own_may_wait(run: Run):
    setup = CLIENT + "threading.Thread(target=self.tick, daemon=True).start()\n"
    assert codes(run(source(setup, CALL))) == []


def test_a_guard_that_the_run_can_decide_decides(run: Run):
    method = """
    def tick(self):
        self.ask(wait=False)

    def ask(self, wait):
        future = self.client.call_async(Trigger.Request())
        if wait:
            rclpy.spin_until_future_complete(self, future, timeout_sec=1.0)
        return future
    """
    assert codes(run(source(CLIENT + TIMER, method))) == []
    assert codes(run(source(CLIENT + TIMER, method.replace("wait=False", "wait=True")))) == ["EXE001"]


def test_an_object_of_something_else_has_a_call_method_too(run: Run):
    methods = """
    def tick(self):
        self.model.call('now')
        subprocess_like.call('now')
    """
    assert codes(run(source("self.model = load_model()\n" + TIMER, methods))) == []


def test_asyncio_is_no_executor_of_ros(run: Run):
    method = """
    async def tick(self):
        await asyncio.sleep(1.0)
        await self.fetch()

    async def fetch(self):
        return await asyncio.gather()
    """
    assert codes(run(source(TIMER, method))) == ["EXE010"]


def test_what_nothing_calls_is_no_callback(run: Run):
    assert codes(run(source(CLIENT, CALL))) == []


def test_a_class_that_nothing_spins_here_is_not_judged_where_its_executor_matters(run: Run):
    text = source(CLIENT_APART + TIMER, CALL, "")
    assert text.startswith(IMPORTS) and codes(run(text)) == []


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        ("try:\n            future.result()\n        except Exception:\n            pass\n        break", []),
        ("if future.cancelled():\n            return\n        raise RuntimeError('too early')", []),
        ("if future.cancelled():\n            break\n        time.sleep(0.01)", ["EXE002"]),
        ("if future.cancelled():\n            continue\n        break", ["EXE002"]),
        ("for part in (1, 2):\n            break", ["EXE002"]),
    ],
)
def test_a_loop_that_is_always_left_does_not_wait(run: Run, body: str, expected: list[str]):
    method = "def tick(self):\n    future = self.client.call_async(Trigger.Request())\n    while not future.done():\n"
    found = codes(run(source(CLIENT + TIMER, f"{method}        {body}\n")))
    assert [code for code in found if code == "EXE002"] == expected


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        ("await self.pause()", []),
        ("if (await self.other).success:\n            self.count += 1", []),
        ("if goal_handle.is_cancel_requested:\n            return None\n        await self.pause()", []),
        ("if self.hurry:\n            continue\n        await self.pause()", ["EXE002"]),
        ("time.sleep(0.1)", ["EXE002"]),
    ],
)
def test_a_loop_that_awaits_in_each_round_lets_others_run(run: Run, body: str, expected: list[str]):
    method = f"""
async def execute(self, goal_handle):
    future = self.client.call_async(Trigger.Request())
    while not future.done():
        {body}
    return Fibonacci.Result()
"""
    found = codes(run(source(CLIENT + SERVER, method)))
    assert [code for code in found if code == "EXE002"] == expected


def test_a_loop_that_awaits_holds_the_group_of_its_callback(run: Run):
    method = """
async def tick(self):
    future = self.client.call_async(Trigger.Request())
    while not future.done():
        await self.pause()
"""
    assert codes(run(source(CLIENT + TIMER, method))) == ["EXE002"]
    assert codes(run(source(CLIENT_APART + TIMER, method))) == []


KEPT = """
    from dataclasses import dataclass

    import rclpy
    from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
    from rclpy.client import Client
    from rclpy.node import Node
    from std_srvs.srv import Trigger


    @dataclass
    class Arm:
        home: Client


    class Gateway(Node):
        def __init__(self):
            super().__init__('gateway')
            self.arms = {{}}
            self.clients_group = MutuallyExclusiveCallbackGroup()
            self.handlers_group = MutuallyExclusiveCallbackGroup()
            self.create_service(Trigger, 'add', self.add, callback_group=self.handlers_group)
            self.create_service(Trigger, 'home', self.home, callback_group=self.handlers_group)

        def add(self, request, response):
            home = self.create_client(Trigger, 'arm/home', callback_group={group})
            self.arms[str(len(self.arms))] = Arm(home)
            return response

        def home(self, request, response):
            future = self.arms['left'].home.call_async(Trigger.Request())
            rclpy.spin_until_future_complete(self, future, timeout_sec=0.1)  # here
            return response


    def main():
        rclpy.init()
        rclpy.spin(Gateway())


    if __name__ == '__main__':
        main()
"""


@pytest.mark.parametrize(
    ("group", "words"),
    [
        ("self.clients_group", "this works in humble and raises"),
        ("self.handlers_group", "this may time out in humble and raises"),
    ],
)
def test_a_client_out_of_sight_has_the_group_that_all_of_its_node_have(judge: Judge, group: str, words: str):
    [found] = judge("EXE001", KEPT.format(group=group))
    assert words in found.message


ASKS_IN_A_HELPER = """
def handle(self, request, response):
    {handler}
    return response

def tick(self):
    self.ask()

def ask(self):
    future = self.client.call_async(Trigger.Request())
    rclpy.spin_until_future_complete(self, future)
"""


@pytest.mark.parametrize(("handler", "told"), [("self.ask()", ["SRV003"]), ("pass", ["EXE001"])])
def test_a_spin_that_a_handler_and_a_timer_share_is_told_once(run: Run, handler: str, told: list[str]):
    create = "self.client = self.create_client(Trigger, 'a')\nself.create_service(Trigger, 'b', self.handle)\n"
    create += "self.create_timer(1.0, self.tick)\n"
    found = codes(run(source(create, ASKS_IN_A_HELPER.replace("{handler}", handler))))
    assert [code for code in found if code in ("SRV003", "EXE001")] == told


def test_nobody_knows_the_group_of_a_node_of_another_package(run: Run):
    method = """
    def tick(self):
        from robots import Navigator
        rclpy.spin_once(Navigator(), timeout_sec=0.1)
    """
    assert run(source(TIMER, method), distro="humble") == []
    [found] = run(source(TIMER, method))
    assert "raises 'Executor is already spinning' from jazzy on" in found.message and "always" not in found.message
