from __future__ import annotations

from collections.abc import Callable
from functools import partial

import pytest

from archlint.finding import Finding, Severity
from checks.judging import Judge

START_UP = "[rules.endless-wait-loop]\nstart-up = true"

SCRIPT = """
    import sys
    import time

    import rclpy
    from example_interfaces.action import Fibonacci
    from rclpy.action import ActionClient
    from std_srvs.srv import Trigger


    def main():
        rclpy.init()
        node = rclpy.create_node('script')
        near = node.create_client(Trigger, 'near')
        far = node.create_client(Trigger, 'far')
        action = ActionClient(node, Fibonacci, 'count')
        tries = 0
        {lines}


    if __name__ == '__main__':
        main()
"""


@pytest.fixture
def judge(judge: Judge) -> Callable[..., list[Finding]]:
    """A judge of loops that say what they wait for, too."""
    return partial(judge, config=START_UP)


WAIT = "far.wait_for_service(timeout_sec=1.0)"


def script(*lines: str) -> str:
    return SCRIPT.format(lines="\n        ".join(lines))


LISTED = """
    import rclpy
    from std_srvs.srv import Trigger


    def main():
        rclpy.init()
        node = rclpy.create_node('script')
        {names}
            {make}
            client = node.create_client(Trigger, name)
            while not client.wait_for_service(timeout_sec=1.0):{here}
                print('waiting')


    if __name__ == '__main__':
        main()
"""


@pytest.mark.parametrize(
    ("names", "make", "reported"),
    [
        ("for name, kinds in node.get_service_names_and_types():", "print(kinds)", False),
        ("for found in node.get_service_names_and_types():", "name = found[0]", False),
        ("for name in [n for n, _ in node.get_service_names_and_types()]:", "print(name)", False),
        ("for name, kinds in node.get_service_names_and_types():", "name = f'{name}/reset'", True),
        ("for name, kinds in node.get_service_names_and_types():", "name = name + '/reset'", True),
        ("for name, kinds in node.get_node_names_and_namespaces():", "print(kinds)", True),
        ("for name in input().split():", "print(name)", True),
    ],
    ids=["each", "an item", "chosen", "made of it", "joined", "nodes", "anything"],
)
def test_a_service_that_ros_has_named_is_there(judge: Judge, names: str, make: str, reported: bool):
    judge("TMO004", LISTED.format(names=names, make=make, here="  # here" if reported else ""))


@pytest.mark.parametrize(
    "lines",
    [
        (f"while not {WAIT}:  # here", "    node.get_logger().info('waiting')"),
        (f"while not {WAIT}:  # here", "    pass"),
        (f"while {WAIT} is False:  # here", "    print('waiting')"),
        (
            f"while not (near.wait_for_service(timeout_sec=1.0) and {WAIT}):  # here",
            "    time.sleep(0.1)",
        ),
        ("while not action.wait_for_server(timeout_sec=1.0):  # here", "    print('waiting')"),
        ("while not far.service_is_ready():  # here", "    rclpy.spin_once(node)"),
        ("while True:", f"    if {WAIT}:  # here", "        break", "    print('waiting')"),
        ("while True:", f"    if not {WAIT}:  # here", "        print('waiting')", "    else:", "        break"),
        ("ready = False", "while not ready:", f"    ready = {WAIT}  # here"),
        (f"while not {WAIT}:  # here", "    for second in range(3):", "        print(second)"),
    ],
    ids=[
        "tutorial",
        "empty",
        "compared",
        "two servers",
        "action",
        "poll",
        "break when there",
        "break unless missing",
        "variable",
        "a loop inside",
    ],
)
def test_only_the_server_ends_it(judge: Judge, lines: tuple[str, ...]):
    judge("TMO004", script(*lines))


@pytest.mark.parametrize(
    "lines",
    [
        (f"while rclpy.ok() and not {WAIT}:", "    pass"),
        (f"while not {WAIT} and tries < 5:", "    tries += 1"),
        (f"while not {WAIT}:", "    tries += 1", "    if tries > 5:", "        break"),
        (f"while not {WAIT}:", "    if not rclpy.ok():", "        return"),
        (f"while not {WAIT}:", "    raise RuntimeError('no server')"),
        (f"while not {WAIT}:", "    sys.exit(1)"),
        ("while True:", f"    if {WAIT}:", "        break", "    tries += 1", "    if tries > 5:", "        break"),
        ("while rclpy.ok():", f"    if {WAIT}:", "        break"),
        ("for attempt in range(5):", f"    if {WAIT}:", "        break"),
        (f"while not {WAIT}:", "    give_up_after_a_while()"),
        (f"while {WAIT}:", "    print('still there')"),
        (f"while not {WAIT}:", "    node.get_logger('waiting')"),
        ("def wait(seconds):", "    time.sleep(seconds)", f"while not {WAIT}:", "    wait()"),
    ],
    ids=[
        "ok",
        "counted in the test",
        "counted",
        "returns on shutdown",
        "raises",
        "exits",
        "counted poll",
        "poll while ok",
        "bounded",
        "a call that may raise",
        "until it goes away",
        "a method that refuses its argument",
        "a function that lacks its argument",
    ],
)
def test_something_else_ends_it(judge: Judge, lines: tuple[str, ...]):
    judge("TMO004", script(*lines))


def test_a_first_wait_without_limit_is_another_rules_matter(judge: Judge):
    judge("TMO004", script("while not far.wait_for_service():", "    pass"))


def test_a_node_that_starts_up_may_wait_and_a_callback_may_not(judge: Judge):
    [starting] = judge("TMO004", script(f"while not {WAIT}:  # here", "    pass"))
    assert starting.severity is Severity.INFO

    lines = ("def tick():", f"    while not {WAIT}:  # here", "        pass", "node.create_timer(1.0, tick)")
    [ticking] = judge("TMO004", script(*lines, "rclpy.spin(node)"))
    assert ticking.severity is Severity.WARNING and "service_is_ready" in ticking.help


def test_a_callback_shares_a_loop_with_the_start(judge: Judge):
    """The node has to wait while it starts, or nothing would be there for it."""
    reset = ("def reset():", f"    while not {WAIT}:  # here", "        print('waiting')")
    [told] = judge("TMO004", script(*reset, "reset()", "node.create_timer(1.0, reset)", "rclpy.spin(node)"))
    assert told.help == (
        "wait where the node starts, before it calls this, and only check here: if not ….service_is_ready():"
    )


def test_a_handler_that_waits_for_the_answer_next_is_one_finding(judge: Judge):
    lines = (
        "def handle(request, response):",
        f"    while not {WAIT}:",
        "        pass",
        "    return far.call(request)",
        "node.create_service(Trigger, 'near', handle)",
        "rclpy.spin(node)",
    )
    judge("TMO004", script(*lines))
    judge("SRV003", script(*(f"{line}  # here" if "far.call" in line else line for line in lines)))


DRIVER = """
    import rclpy
    from rclpy.node import Node
    from std_srvs.srv import Trigger


    class Driver(Node):
        def __init__(self):
            super().__init__('driver')
            self.left = self.create_client(Trigger, 'left')
            self.right = self.create_client(Trigger, 'right')
            self.lift = self.create_client(Trigger, 'lift')
            while not self.left.wait_for_service(timeout_sec=1.0):  # here
                pass
            while not self.right.wait_for_service(timeout_sec=1.0):
                pass
            while not self.lift.wait_for_service(timeout_sec=1.0):
                pass


    def main():
        rclpy.init()
        rclpy.spin(Driver())


    if __name__ == '__main__':
        main()
"""


def test_the_loops_of_one_file_are_one_finding(judge: Judge):
    [found] = judge("TMO004", DRIVER)

    assert found.severity is Severity.INFO
    assert "ends only when the service 'left' becomes available" in found.message
    assert found.message.endswith("; 2 more loops in this file do the same")
    places = [one.place.line - found.place.line for one in found.related if one.message == "another such loop is here"]
    assert places == [2, 4]


def test_the_loops_of_one_package_are_one_finding(judge: Judge, tmp_path):
    (tmp_path / "package.xml").write_text(
        "<package format='3'><name>robot</name><version>0.0.1</version><description>d</description>"
        "<maintainer email='a@b.org'>a</maintainer><license>MIT</license></package>"
    )
    [found] = judge("TMO004", DRIVER, DRIVER.replace("driver", "other").replace("  # here", ""))

    assert found.message.endswith("; 5 more loops of the package 'robot' do the same")
    assert len({related.place.file for related in found.related}) == 2


@pytest.mark.parametrize(
    ("test", "said"),
    [
        ("not (near.wait_for_service(timeout_sec=1.0) or {far})", "the service 'near' or the service 'far' becomes"),
        ("not near.wait_for_service(timeout_sec=1.0) and not {far}", "the service 'near' or the service 'far' becomes"),
        ("not (near.wait_for_service(timeout_sec=1.0) and {far})", "the service 'near' and the service 'far' become"),
        ("not near.wait_for_service(timeout_sec=1.0) or not {far}", "the service 'near' and the service 'far' become"),
        ("not (far.service_is_ready() and {far})", "the service 'far' becomes"),
    ],
)
def test_all_servers_that_end_a_loop_are_named(judge: Judge, test: str, said: str):
    [found] = judge("TMO004", script(f"while {test.format(far=WAIT)}:  # here", "    print('waiting')"))
    assert found.message.startswith(f"this loop ends only when {said} available:")


@pytest.mark.parametrize(
    "test",
    [
        "not (near.wait_for_service(timeout_sec=1.0) or unknown.wait_for_service(timeout_sec=1.0))",
        f"not (action.wait_for_server(timeout_sec=1.0) or (near.service_is_ready() and {WAIT}))",
    ],
    ids=["one that is not known may end it", "not said in a line"],
)
def test_servers_of_which_too_little_is_known(judge: Judge, test: str):
    judge("TMO004", script("from somewhere import unknown", f"while {test}:", "    print('waiting')"))


ASKED_TWICE = """
    import rclpy
    from rclpy.node import Node
    from std_srvs.srv import Trigger


    class Remote:
        def __init__(self, node: Node):
            self.client = node.create_client(Trigger, 'far')
            self.other = node.create_client(Trigger, 'other')
            {first}


    def main():
        rclpy.init()
        node = rclpy.create_node('script')
        node.create_timer(1.0, print)
        remote = Remote(node)
        while not remote.client.wait_for_service(timeout_sec=1.0):{mark}
            print('waiting')
        rclpy.spin(node)


    if __name__ == '__main__':
        main()
"""


@pytest.mark.parametrize(
    ("first", "mark"),
    [
        ("while not self.client.wait_for_service(timeout_sec=1.0):  # here\n                print('waiting')", ""),
        ("self.client.wait_for_service()", ""),
        ("self.client.wait_for_service(timeout_sec=5.0)", "  # here"),
        ("self.other.wait_for_service()", "  # here"),
        ("if input():\n                self.client.wait_for_service()", "  # here"),
        (
            "while not (self.client.service_is_ready() or self.other.service_is_ready()):  # here\n"
            "                print('waiting')",
            "",  # told with the first
        ),
    ],
    ids=["a loop", "a wait without limit", "a limited wait", "for another", "sometimes", "for one of two"],
)
def test_a_loop_after_a_wait_for_the_same_server_never_repeats(judge: Judge, first: str, mark: str):
    [*found] = judge("TMO004", ASKED_TWICE.format(first=first, mark=mark))
    again = [related for finding in found for related in finding.related if related.message.startswith("another")]
    assert len(again) == ("or self" in first)


HELPER = """
    import rclpy
    from rclpy.node import Node
    from std_srvs.srv import Trigger


    class Helper:
        def __init__(self, node: Node):
            self.node = node
            self.far = node.create_client(Trigger, 'far')
            while not self.far.wait_for_service(timeout_sec=1.0):{mark}
                {say}

        {more}


    class Robot(Node):
        def __init__(self):
            super().__init__('robot')
            {made}


    def main():
        rclpy.init()
        rclpy.spin(Robot())


    if __name__ == '__main__':
        main()
"""


@pytest.mark.parametrize(
    ("say", "more", "mark"),
    [
        ("self.get_logger().info('waiting')", "", ""),
        ("self.node.get_logger().info('waiting')", "", "  # here"),
        ("self.get_logger().info('waiting')", "def get_logger(self): return self.node.get_logger()", "  # here"),
        ("self.get_logger().info('waiting')", "def use(self, log): self.get_logger = log", "  # here"),
        (
            "self.get_logger().info('waiting')",
            "def __getattr__(self, name): return getattr(self.node, name)",
            "  # here",
        ),
    ],
)
def test_a_loop_whose_first_round_asks_for_a_method_that_is_not_there(judge: Judge, say: str, more: str, mark: str):
    judge("TMO004", HELPER.format(say=say, more=more, mark=mark, made="self.helper = Helper(self)"))


@pytest.mark.parametrize(("uses", "mark"), [("", ""), ("HELPERS = [Helper]", "  # here")])
def test_a_class_that_nothing_names(judge: Judge, tmp_path, uses: str, mark: str):
    text = HELPER.format(say="pass", more="", mark=mark, made=uses or "pass")
    (tmp_path / "package.xml").write_text(
        "<package format='3'><name>robot</name><version>0.0.1</version><description>d</description>"
        "<maintainer email='a@b.org'>a</maintainer><license>MIT</license>"
        "<export><build_type>ament_python</build_type></export></package>"
    )
    (tmp_path / "setup.py").write_text(
        "from setuptools import setup\n\n"
        "setup(name='robot', py_modules=['node'], entry_points={'console_scripts': ['robot = node:main']})\n"
    )
    judge("TMO004", text)


@pytest.mark.parametrize(
    ("inside", "mark"),
    [
        ("print('waiting')", ""),
        ("node.get_logger().info('waiting')", ""),
        ("time.sleep(1.0)", "  # here"),  # nobody sees it
    ],
)
def test_a_program_that_starts_up_may_wait_where_it_says_so(judge: Judge, inside: str, mark: str):
    lines = (f"while not {WAIT}:{mark}", f"    {inside}", "node.create_timer(1.0, print)", "rclpy.spin(node)")
    judge("TMO004", script(*lines), config="")


def test_a_callback_may_not(judge: Judge):
    lines = (
        "def tick():",
        f"    while not {WAIT}:  # here",
        "        print('waiting')",
        "node.create_timer(1.0, tick)",
    )
    judge("TMO004", script(*lines, "rclpy.spin(node)"), config="")


MANY_NODES = "".join(f"rclpy.create_node('part_{number}'); " for number in range(5))


@pytest.mark.parametrize(("others", "mark"), [("pass", "  # here"), (MANY_NODES, "")], ids=["a lesson", "six nodes"])
def test_a_silent_start_is_told_in_a_lesson_only(judge: Judge, others: str, mark: str):
    lines = (others, f"while not {WAIT}:{mark}", "    time.sleep(1.0)", "rclpy.spin(node)")
    judge("TMO004", script(*lines), config="")


THREADS = """
    import rclpy
    from rclpy.callback_groups import ReentrantCallbackGroup
    from rclpy.executors import MultiThreadedExecutor
    from rclpy.node import Node
    from std_msgs.msg import Empty
    from std_srvs.srv import Trigger


    class Driver(Node):
        def __init__(self):
            super().__init__('driver')
            self.motor = self.create_client(Trigger, 'enable_motor')
            group = {group}
            self.create_subscription(Empty, 'go', self.on_go, 10, callback_group=group)
            {other}

        def on_go(self, message):
            while not self.motor.wait_for_service(timeout_sec=1.0):{mark}
                self.get_logger().info('waiting')
            self.motor.call_async(Trigger.Request())


    def main():
        rclpy.init()
        executor = {executor}()
        executor.add_node(Driver())
        executor.spin()


    if __name__ == '__main__':
        main()
"""
BEAT = "self.create_timer(0.1, lambda: print('alive'))"


@pytest.mark.parametrize(
    ("executor", "group", "other", "mark"),
    [
        ("MultiThreadedExecutor", "ReentrantCallbackGroup()", BEAT, ""),
        ("MultiThreadedExecutor", "None", BEAT, "  # here"),
        ("rclpy.executors.SingleThreadedExecutor", "ReentrantCallbackGroup()", BEAT, "  # here"),
        ("rclpy.executors.SingleThreadedExecutor", "None", "pass", "  # here"),
        ("rclpy.executors.SingleThreadedExecutor", "None", MANY_NODES, ""),
    ],
    ids=[
        "other threads go on",
        "the timer is in its group",
        "one thread",
        "nothing else happens in the node of a lesson",
        "nothing else happens in a node of several",
    ],
)
def test_a_callback_that_keeps_nobody_may_wait(judge: Judge, executor: str, group: str, other: str, mark: str):
    judge("TMO004", THREADS.format(executor=executor, group=group, other=other, mark=mark), config="")


IN_A_THREAD = """
    import threading

    import rclpy
    from rclpy.node import Node
    from std_srvs.srv import Trigger


    class Demo(Node):
        def __init__(self):
            super().__init__('demo')
            self.client = self.create_client(Trigger, 'far')
            self.create_timer(1.0, self.tick)
            {start}

        def tick(self):
            pass

        def run(self):
            while not self.client.wait_for_service(timeout_sec=1.0):  # here
                self.tick()


    def main():
        rclpy.init()
        rclpy.spin(Demo())


    if __name__ == '__main__':
        main()
"""


@pytest.mark.parametrize(
    ("start", "who"),
    [
        ("threading.Thread(target=self.run, daemon=True).start()", "this thread does nothing else"),
        ("self.run()", "the node does nothing else"),
    ],
)
def test_a_thread_that_waits_does_not_keep_the_node(judge: Judge, start: str, who: str):
    text = IN_A_THREAD.replace("{start}", start).replace("self.tick()\n\n\n", "print('waiting')\n\n\n")
    [found] = judge("TMO004", text)
    assert found.message.endswith(who)


def test_a_program_that_waits_while_a_thread_spins(judge: Judge):
    main = (
        "demo = Demo()\n        executor = MultiThreadedExecutor()\n        executor.add_node(demo)\n"
        "        threading.Thread(target=executor.spin, daemon=True).start()\n        demo.run()"
    )
    text = IN_A_THREAD.replace("{start}", "pass").replace("rclpy.spin(Demo())", main)
    text = text.replace("self.tick()\n\n\n", "pass\n\n\n")
    text = text.replace("import rclpy\n", "import rclpy\n    from rclpy.executors import MultiThreadedExecutor\n", 1)
    [found] = judge("TMO004", text)
    assert found.message.endswith("this thread does nothing else")


SEVERAL_WAITS = """
    import rclpy
    from rclpy.node import Node
    from std_msgs.msg import Empty
    from std_srvs.srv import Trigger


    class Robot(Node):
        def __init__(self):
            super().__init__('robot')
            self.near = self.create_client(Trigger, 'near')
            self.far = self.create_client(Trigger, 'far')
            self.create_subscription(Empty, 'go', self.on_go, 10)
            self.create_subscription(Empty, 'back', self.on_back, 10)
            self.create_subscription(Empty, 'stop', self.on_stop, 10)

        def on_go(self, message):
            while not self.near.wait_for_service(timeout_sec=1.0):  # here
                pass
            self.ask('start')

        def on_back(self, message):
            while not self.far.wait_for_service(timeout_sec=1.0):
                pass
            self.ask('turn')

        def on_stop(self, message):
            self.ask('stop')

        def ask(self, name):
            client = self.create_client(Trigger, name)
            while not client.wait_for_service(timeout_sec=1.0):  # here
                pass
            client.call_async(Trigger.Request())


    def main():
        rclpy.init()
        rclpy.spin(Robot())


    if __name__ == '__main__':
        main()
"""


def test_loops_of_a_class_with_one_cure_are_one_finding(judge: Judge):
    """A client that a helper of several callbacks makes in front of its loop is to be made earlier."""
    near, new = judge("TMO004", SEVERAL_WAITS)
    assert near.message.endswith("; another loop in the class Robot does the same")
    assert near.help == "check without waiting, and handle the case that it is missing: if not ….service_is_ready():"
    assert [row.message for row in near.related][-1] == "another such loop is here"
    assert new.help.startswith("create the client in the constructor")


ASYNC = """
    import asyncio
    import time

    import rclpy
    from rclpy.node import Node
    from std_srvs.srv import Trigger


    class Relay(Node):
        def __init__(self):
            super().__init__('relay')
            self.far = self.create_client(Trigger, 'far')
            self.create_subscription(Trigger, 'go', self.on_go, 10)
            self.create_timer(1.0, self.tick)

        async def tick(self):
            while not self.far.wait_for_service(timeout_sec=0.5):{here}
                {pause}

        def on_go(self, message):
            print(message)


    def main():
        rclpy.init()
        rclpy.spin(Relay())
"""


@pytest.mark.parametrize(
    ("pause", "code"),
    [("time.sleep(0.1)", "TMO004"), ("await asyncio.sleep(0)", "TMO004"), ("await asyncio.sleep(0.1)", "EXE010")],
)
def test_a_loop_that_raises_in_its_first_round(judge: Judge, pause: str, code: str):
    told = "  # here"
    if code == "EXE010":
        judge("EXE010", ASYNC.format(here="", pause=f"{pause}{told}"))
        judge("TMO004", ASYNC.format(here="", pause=pause))
    else:
        judge("TMO004", ASYNC.format(here=told, pause=pause))
