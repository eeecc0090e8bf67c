"""EXE009: loops of callbacks that wait for what they keep from happening."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
import math
import time

import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import String


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.data = None
        self.goal = 1.0
        self.create_subscription(String, 'data', self.on_data, 10{group})
        self.create_timer(1.0, self.tick)
        self.out = self.create_publisher(String, 'out', 10)
        self.other = Other()

    def on_data(self, message):
        self.data = message

    def tick(self):
        {body}

    def helper(self):
        {helper}

    def wait(self):
        {wait}


class Other:
    def __init__(self):
        self.data = 0

    def work(self):
        self.data = 1


def main():
    rclpy.init()
    {spin}


if __name__ == '__main__':
    main()
"""
ONE_THREAD = "rclpy.spin(Robot())"
THREADS = "executor = MultiThreadedExecutor()\n    executor.add_node(Robot())\n    executor.spin()"


def robot(*lines: str, helper: str = "pass", wait: str = "pass", spin: str = ONE_THREAD, group: str = "") -> str:
    return NODE.format(body="\n        ".join(lines), helper=helper, wait=wait, spin=spin, group=group)


@pytest.mark.parametrize(
    "source",
    [
        robot("while self.data is None:  # here", "    time.sleep(0.1)"),
        robot("while not self.data:  # here", "    pass"),
        robot("while rclpy.ok() and self.data is None:  # here", "    self.get_logger().info('waiting')"),
        robot("while self.data is None:  # here", "    time.sleep(0.1)", spin=THREADS),
        robot("while True:  # here", "    if self.data is not None:", "        break", "    time.sleep(0.1)"),
        robot("while rclpy.ok():  # here", "    if self.data:", "        return", "    time.sleep(0.1)"),
        robot("while self.data is None:  # here", "    if not rclpy.ok():", "        return", "    time.sleep(0.1)"),
        robot("while not self.data:  # here", "    self.out.publish(String(data='?'))", "    time.sleep(0.1)"),
        robot("while not self.data:  # here", "    out = String()", "    out.data = '?'", "    self.out.publish(out)"),
        robot("self.wait()", wait="while self.data is None:  # here\n            time.sleep(0.1)"),
        robot("self.wait()", wait="while self.data is None:  # here\n            pass"),
        robot("self.helper()", helper="self.wait()", wait="while not self.data:  # here\n            pass"),
        robot("while abs(self.goal - self.data.x) > 0.1:  # here", "    self.out.publish(String())"),
        robot("end = 5.0", "while self.data.x < end:  # here", "    time.sleep(0.1)"),
        robot("far = True", "while far:  # here", "    far = math.hypot(self.data.x, self.data.y) > 0.1"),
        robot("while True:  # here", "    error = self.goal - self.data.x", "    if error < 0.1:", "        break"),
    ],
    ids=[
        "sleeps",
        "busy",
        "while ROS runs",
        "several threads, one group",
        "a break",
        "a return",
        "a return when ROS ends",
        "publishes",
        "publishes what it makes",
        "a method that waits",
        "a busy method",
        "a busy method of a method",
        "a distance",
        "a limit",
        "a variable",
        "an error",
    ],
)
def test_a_loop_that_keeps_out_what_would_end_it(judge: Judge, source: str):
    [finding] = judge("EXE009", source)
    assert "only Robot.on_data changes self.data, and it cannot run meanwhile" in finding.message


@pytest.mark.parametrize(
    "source",
    [
        robot("while self.data is None:", "    rclpy.spin_once(self)"),
        robot("while self.data is None:", "    self.helper()", helper="self.data = 1"),
        robot("while self.data is None:", "    time.sleep(0.1)", helper="self.data = 1"),
        robot("while self.data is None:", "    if time.time() > 5:", "        break"),
        robot("tries = 0", "while self.data is None and tries < 9:", "    tries += 1"),
        robot("while self.data is None:", "    self.data = String()"),
        robot("while rclpy.ok():", "    time.sleep(0.1)"),
        robot("while self.data is None and not rclpy.ok():", "    time.sleep(0.1)"),
        robot(
            "while self.data is None:",
            "    time.sleep(0.1)",
            spin=THREADS,
            group=", callback_group=ReentrantCallbackGroup()",
        ),
        robot("if self.data is None:", "    return"),
        robot("while True:", "    if self.data:", "        break", "    if time.time() > 5:", "        return"),
        robot("while True:", "    if self.data:", "        pass", "    elif time.time() > 5:", "        break"),
        robot("end = time.time() + 5", "while self.data is None and time.time() < end:", "    time.sleep(0.1)"),
        robot("while self.other.data < 1:", "    self.other.work()"),
        robot("while self.data is None:", "    time.sleep(0.1)", wait="self.__dict__['data'] = 1"),
        robot("while self.data is None:", "    time.sleep(0.1)", wait="setattr(self, 'data', 1)"),
        robot("while self.data is None:", "    self.data = self.out.publish(String())"),
        robot("far = True", "while far:", "    far = self.data is None and time.time() < 5"),
        robot("x = 0.0", "while self.data.x > x:", "    x = x + 0.1"),
        robot("x = 0.0", "while self.data.x > x:", "    x += 0.1"),
        robot("names = []", "while not names and not self.data:", "    time.sleep(0.1)"),
        robot("other = self.other", "while self.data.x > other.x:", "    time.sleep(0.1)"),
        robot("while self.data.x > self.step():", "    time.sleep(0.1)"),
        robot("while self.data.x > self.goal:", "    time.sleep(0.1)", helper="self.goal = 1.0"),
        robot("self.other.wait()", wait="while self.data is None:\n            time.sleep(0.1)"),
        robot("self.other.wait()", wait="while self.data is None:\n            pass"),
        robot("print(self.wait)", wait="while self.data is None:\n            pass"),
        robot("while not self.other.data:", "    pass").replace("self.data = message", "self.other.data = message"),
    ],
    ids=[
        "it spins",
        "it calls what changes it",
        "a method that nobody is seen to call changes it",
        "it breaks off",
        "it counts",
        "it changes it",
        "it waits for nothing",
        "not entered while ROS is up",
        "another group",
        "no loop",
        "a time in another test",
        "a time in an elif",
        "a time in its test",
        "the attribute of another object",
        "by a text in __dict__",
        "by setattr",
        "it assigns what publish() gives",
        "a time in a variable",
        "a variable that grows",
        "a variable that is added to",
        "a list that something else may fill",
        "an object that something else may change",
        "a method in its test",
        "a second attribute that may change",
        "a method of another object",
        "a busy method of another object",
        "a method that is not called",
        "a field of an object that may change itself",
    ],
)
def test_a_loop_that_may_end(judge: Judge, source: str):
    judge("EXE009", source)


ASKS = """
import time

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from rclpy.task import Future
from std_srvs.srv import Trigger


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.answer = None
        self.client = self.create_client(Trigger, 'far'{group})
        self.create_timer(1.0, self.tick{group})

    def on_answer(self, future):
        self.answer = future.result()

    def tick(self):
        self.answer = None
        {future}.add_done_callback(self.on_answer)
        while self.answer is None:{mark}
            time.sleep(0.1)


def main():
    rclpy.init()
    {spin}


if __name__ == '__main__':
    main()
"""
SENT = "self.client.call_async(Trigger.Request())"
OF_OWN_GROUP = SENT.replace(
    "self.client", "self.create_client(Trigger, 'near', callback_group=MutuallyExclusiveCallbackGroup())"
)


def test_a_loop_until_a_done_callback_has_the_response(judge: Judge):
    [finding] = judge("EXE009", ASKS.format(future=SENT, group="", spin=ONE_THREAD, mark="  # here"))
    assert "only Robot.on_answer changes self.answer, and it cannot run meanwhile" in finding.message
    assert finding.help == "return instead, and go on in Robot.on_answer"


BUSY = """while self.busy:{mark}
            pass
        self.busy = True
        try:
            self.out.publish(String())
        except Exception:
            self.get_logger().info('later')
        {after}
        self.busy = False"""


@pytest.mark.parametrize(
    ("after", "mark"),
    [
        ("self.goal = 2.0", ""),
        ("if self.goal:\n            return", "  # here"),
        ("self.busy = self.goal > 1.0", "  # here"),
    ],
    ids=["always cleared", "left before that", "another value"],
)
def test_a_flag_that_each_callback_clears_behind_its_work_is_never_found_set(judge: Judge, after: str, mark: str):
    flags = robot(BUSY.format(after=after, mark=mark)).replace("self.data = None\n", "self.busy = False\n", 1)
    judge("EXE009", flags.replace("        self.data = message", "        self.busy = True\n        self.busy = False"))


def test_the_loops_of_a_class_that_wait_for_one_attribute_are_one_finding(judge: Judge):
    waits = "while self.data is None:  {}\n            time.sleep(0.1)"
    lines = waits.format("# here"), waits.format("").replace("data is None", "data is not None")
    [told] = judge("EXE009", robot(*lines))
    assert told.message.endswith("; another loop waits for self.data like that")


def test_several_threads_do_not_help_while_the_group_of_the_client_is_held(judge: Judge):
    [finding] = judge("EXE009", ASKS.format(future=SENT, group="", spin=THREADS, mark="  # here"))
    assert "is in the mutually exclusive callback group of this callback" in finding.message


def test_an_execute_callback_cannot_go_on_in_another(judge: Judge):
    goals = (
        robot("pass")
        .replace("        {body}", "        pass")
        .replace(
            "    def on_data(self, message):",
            """    def execute(self, goal):
        while self.data is None:  # here
            time.sleep(0.1)
        goal.succeed()
        return Fibonacci.Result()

    def on_data(self, message):""",
        )
    )
    goals = goals.replace(
        "self.data = None\n", "self.data = None\n        ActionServer(self, Fibonacci, 'count', self.execute)\n", 1
    )
    imports = "from example_interfaces.action import Fibonacci\nfrom rclpy.action import ActionServer\n"
    [finding] = judge("EXE009", imports + goals.lstrip("\n"))
    assert finding.help == ("give this callback its own callback group, and spin the node with a MultiThreadedExecutor")


@pytest.mark.parametrize(
    ("future", "group", "spin"),
    [
        (SENT, ", callback_group=ReentrantCallbackGroup()", THREADS),
        (OF_OWN_GROUP, "", THREADS),
        ("Future()", "", ONE_THREAD),  # whoever has it may be in another thread
        ("rclpy.create_node('other').create_client(Trigger, 'far').call_async(Trigger.Request())", "", ONE_THREAD),
    ],
)
def test_a_response_that_may_come(judge: Judge, future: str, group: str, spin: str):
    judge("EXE009", ASKS.format(future=future, group=group, spin=spin, mark=""))


def test_only_the_stronger_is_said_of_a_line(judge: Judge):
    judge("EXE003", robot("while self.data is None:", "    time.sleep(0.1)"))
    judge(
        "SRV008",
        """
        import time

        import rclpy
        from rclpy.node import Node
        from std_msgs.msg import String
        from std_srvs.srv import Trigger


        class Robot(Node):
            def __init__(self):
                super().__init__('robot')
                self.data = None
                self.create_subscription(String, 'data', self.on_data, 10)
                self.create_service(Trigger, 'wait', self.wait)

            def on_data(self, message):
                self.data = message

            def wait(self, request, response):
                while self.data is None:
                    time.sleep(1.0)
                return response


        def main():
            rclpy.init()
            rclpy.spin(Robot())
        """,
    )


AT_START = """
import threading
import time

import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Trigger


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.data = self.answer = None
        self.create_subscription(String, 'data', self.on_data, 10)
        {constructor}

    def on_data(self, message):
        self.data = message

    def spin(self):
        rclpy.spin(self)

    def done(self, future):
        self.answer = future.result()


class Scanner(threading.Thread):
    def __init__(self, node):
        super().__init__(daemon=True)
        self.node = node

    def run(self):
        rclpy.spin(self.node)


def main():
    rclpy.init()
    robot = Robot()
    {main}


if __name__ == '__main__':
    main()
"""


def at_start(*lines: str, constructor: tuple[str, ...] = ("pass",)) -> str:
    return AT_START.format(main="\n    ".join(lines), constructor="\n        ".join(constructor))


ASKED = (
    "future = self.create_client(Trigger, 'go').call_async(Trigger.Request())",
    "future.add_done_callback(self.done)",
)


@pytest.mark.parametrize(
    ("source", "advice"),
    [
        (
            at_start("rclpy.spin(robot)", constructor=("while self.data is None:  # here", "    time.sleep(0.1)")),
            "rclpy.spin_once(self, timeout_sec=0.1)",
        ),
        (
            at_start("rclpy.spin(robot)", constructor=(*ASKED, "while not self.answer:  # here", "    pass")),
            "rclpy.spin_once(self, timeout_sec=0.1)",
        ),
        (
            at_start("while robot.data is None:  # here", "    time.sleep(0.1)", "rclpy.spin(robot)"),
            "rclpy.spin_once(robot, timeout_sec=0.1)",
        ),
        (
            at_start(
                "rclpy.spin_once(robot)", "while not robot.data:  # here", "    print('waiting')", "rclpy.spin(robot)"
            ),
            "rclpy.spin_once(robot, timeout_sec=0.1)",
        ),
    ],
    ids=["constructor", "an answer", "main", "after a spin"],
)
def test_a_loop_before_anybody_spins(judge: Judge, source: str, advice: str):
    [finding] = judge("EXE009", source)
    assert "once the program is in this loop, it never ends" in finding.message
    assert finding.help == f"spin in the loop: {advice}"


WAITS = ("while robot.data is None:", "    time.sleep(0.1)")


@pytest.mark.parametrize(
    "source",
    [
        at_start("while robot.data is None:", "    rclpy.spin_once(robot)"),
        at_start("threading.Thread(target=rclpy.spin, args=(robot,), daemon=True).start()", *WAITS),
        at_start("threading.Thread(target=lambda: rclpy.spin(robot)).start()", *WAITS),
        at_start("threading.Thread(target=robot.spin).start()", *WAITS),
        at_start("Scanner(robot).start()", *WAITS),
        at_start(
            "executor = SingleThreadedExecutor()",
            "executor.add_node(robot)",
            "threading.Thread(target=executor.spin).start()",
            *WAITS,
        ),
        at_start("robot.data = 1", *WAITS),
        at_start("rclpy.spin(robot)", constructor=("while self.data is None:", "    rclpy.spin_once(self)")),
        at_start(
            "rclpy.spin(robot)",
            constructor=("threading.Thread(target=self.spin).start()", "while self.data is None:", "    pass"),
        ),
        at_start("other = robot", "robot = Scanner(other)", "while robot.data is None:", "    pass"),
    ],
    ids=[
        "it spins",
        "a thread",
        "a lambda in a thread",
        "a method in a thread",
        "a class of threads",
        "an executor in a thread",
        "main changes it",
        "the constructor spins",
        "the constructor starts a thread",
        "the variable is another object",
    ],
)
def test_a_loop_while_somebody_spins(judge: Judge, source: str):
    judge("EXE009", source)


QUEUE = """
import queue
import threading
from queue import Queue

import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import String


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.data = queue.Queue()
        self.names = {{}}
        self.ready = threading.Event()
        {constructor}
        self.create_subscription(String, 'data', self.on_data, 10{group})
        self.create_timer(1.0, self.tick)

    def on_data(self, message):
        self.data.put(message)
        self.ready.set()

    def tick(self):
        {body}

    def helper(self):
        {helper}


def main():
    rclpy.init()
    {spin}


if __name__ == '__main__':
    main()
"""


def with_queue(
    *lines: str, constructor: str = "pass", helper: str = "pass", spin: str = ONE_THREAD, group: str = ""
) -> str:
    body = "\n        ".join(lines) or "pass"
    return QUEUE.format(body=body, constructor=constructor, helper=helper, spin=spin, group=group)


@pytest.mark.parametrize(
    ("source", "says"),
    [
        (
            with_queue("self.data.get()  # here"),
            "get() never returns where self.data is empty: only Robot.on_data puts",
        ),
        (with_queue("message = self.data.get(True)  # here"), "since the executor's only thread is blocked"),
        (with_queue("self.data.get()  # here", constructor="self.data = Queue()"), "get() never returns"),
        (with_queue("self.data.get()  # here", spin=THREADS), "both are in the same mutually exclusive callback group"),
        (with_queue("pass", constructor="self.data.get()  # here"), "since nothing spins the node while this thread"),
        (
            with_queue("pass", constructor="self.ready.wait()  # here"),
            "wait() never returns where self.ready is not set",
        ),
    ],
    ids=["get", "by position", "another import", "one group", "constructor", "an event in the constructor"],
)
def test_a_queue_that_nobody_fills_meanwhile(judge: Judge, source: str, says: str):
    [finding] = judge("EXE009", source)
    assert says in finding.message


@pytest.mark.parametrize(
    "source",
    [
        with_queue("self.data.get(timeout=1.0)"),
        with_queue("self.data.get(True, 1.0)"),
        with_queue("self.data.get(False)"),
        with_queue("self.data.get_nowait()"),
        with_queue("if not self.data.empty():", "    self.data.get()"),
        with_queue("while self.data.qsize():", "    self.data.get()"),
        with_queue("if self.ready.is_set():", "    self.data.get()"),
        with_queue("if not self.names:", "    return", "self.data.get()"),
        with_queue("self.data.put(1)", "self.data.get()"),
        with_queue("self.on_data(1)", "self.data.get()"),
        with_queue("self.data.get()", constructor="self.data.put(1)"),
        with_queue("self.data.get()", helper="self.data.put(1)"),
        with_queue("self.data.get()", constructor="threading.Thread(target=work, args=(self.data,)).start()"),
        with_queue("self.data.get()", constructor="self.data = open_queue()"),
        with_queue("self.names.get('a')"),
        with_queue("self.data.get()", spin=THREADS, group=", callback_group=ReentrantCallbackGroup()"),
        with_queue("pass", constructor="self.ready.wait(1.0)"),
        with_queue("pass", constructor="threading.Thread(target=rclpy.spin, args=(self,)).start(); self.ready.wait()"),
    ],
    ids=[
        "a timeout",
        "a timeout by position",
        "without waiting",
        "get_nowait",
        "it asks first",
        "as many as there are",
        "behind an event",
        "behind another attribute",
        "it puts something in",
        "it calls what puts something in",
        "the constructor puts something in",
        "a method that nobody is seen to call",
        "somebody else has it",
        "an unknown queue",
        "a dict",
        "another group",
        "an event with a timeout",
        "a thread spins",
    ],
)
def test_a_queue_that_may_be_filled(judge: Judge, source: str):
    judge("EXE009", source)


def _with_condition(*lines: str, made: str = "threading.Condition()", spin: str = ONE_THREAD, group: str = "") -> str:
    """A callback that notifies, and one that waits for that."""
    source = with_queue(*lines, constructor=f"self.news = {made}", spin=spin, group=group)
    gives = "self.news.release()" if "Semaphore" in made else "with self.news:\n            self.news.notify_all()"
    return source.replace("self.data.put(message)", gives)


@pytest.mark.parametrize(
    ("source", "says"),
    [
        (
            _with_condition("with self.news:", "    self.news.wait()  # here"),
            "wait() never returns: only Robot.on_data notifies self.news",
        ),
        (
            _with_condition("with self.news:", "    while not self.names:", "        self.news.wait()  # here"),
            "wait() never returns: only Robot.on_data notifies self.news",
        ),
        (
            _with_condition("with self.news:", "    self.news.wait_for(lambda: self.names)  # here"),
            "wait_for() never returns: only Robot.on_data notifies self.news",
        ),
        (
            _with_condition("self.news.acquire()  # here", made="threading.Semaphore(0)"),
            "acquire() never returns where self.news is 0: only Robot.on_data releases it",
        ),
    ],
    ids=["a condition", "in a loop", "with a predicate", "a semaphore"],
)
def test_a_notice_that_cannot_come_meanwhile(judge: Judge, source: str, says: str):
    [finding] = judge("EXE009", source)
    assert says in finding.message


@pytest.mark.parametrize(
    "source",
    [
        _with_condition("with self.news:", "    self.news.wait(1.0)"),
        _with_condition("with self.news:", "    self.news.wait_for(lambda: self.names, 1.0)"),
        _with_condition("with self.news:", "    self.news.notify()", "    self.news.wait()"),
        _with_condition("with self.news:", "    pass"),
        _with_condition("self.news.acquire()", made="threading.Semaphore(1)"),
        _with_condition("self.news.acquire(blocking=False)", made="threading.Semaphore(0)"),
        _with_condition("self.news.acquire(timeout=1.0)", made="threading.Semaphore(0)"),
        _with_condition(
            "with self.news:",
            "    self.news.wait()",
            spin=THREADS,
            group=", callback_group=ReentrantCallbackGroup()",
        ),
    ],
    ids=[
        *("a timeout", "a predicate and a timeout", "it notifies itself", "no wait", "one is free", "no blocking"),
        *("a timeout of a semaphore", "another group"),
    ],
)
def test_a_notice_that_may_come(judge: Judge, source: str):
    judge("EXE009", source)
