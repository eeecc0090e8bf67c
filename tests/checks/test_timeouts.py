from __future__ import annotations

from pathlib import Path
from textwrap import dedent

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Severity
from checks.judging import Judge

SCRIPT = """
    import threading

    import rclpy
    from example_interfaces.action import Fibonacci
    from rclpy.action import ActionClient
    from rclpy.callback_groups import ReentrantCallbackGroup
    from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
    from rclpy.task import Future
    from rclpy.wait_for_message import wait_for_message
    from std_msgs.msg import String
    from std_srvs.srv import Trigger
    from somewhere import hand_over


    def main(timeout=None):
        rclpy.init()
        node = rclpy.create_node('script')
        executor = SingleThreadedExecutor()
        client = node.create_client(Trigger, 'far')
        action = ActionClient(node, Fibonacci, 'count')
        {line}


    if __name__ == '__main__':
        main()
"""
REQUEST = "Trigger.Request()"
FUTURE = f"client.call_async({REQUEST})"
LONGER = ", with more seconds than the server ever takes"
SPIN_IN_A_THREAD = "threading.Thread(target=rclpy.spin, args=(node,), daemon=True).start()"


def script(line: str) -> str:
    return SCRIPT.format(line=line)


BESIDE = """
    import threading
    import rclpy
    from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
    from rclpy.node import Node
    from std_srvs.srv import Trigger


    class Handler(Node):
        def __init__(self):
            super().__init__('handler')
            self.far = self.create_client(Trigger, 'far')

        def read_keys(self):
            while input():
                future = self.far.call_async(Trigger.Request())
                rclpy.spin_until_future_complete(self, future{more})  # here


    def main():
        rclpy.init()
        node = Handler()
        thread = threading.Thread(target=node.read_keys, daemon=True)
        thread.start()
        {line}


    if __name__ == '__main__':
        main()
"""
OWN = "executor = MultiThreadedExecutor()\n        executor.add_node(node)\n        executor.spin()"
RAISES = (
    "spins a node, and another thread spins this node already: this works in humble and raises 'Executor is already "
    "spinning' from jazzy on (works in jazzy before rclpy 7.1.9 and kilted before rclpy 9.1.5)"
)
TAKES = (
    "spins a node, and another thread spins this node on its own executor: this takes the node away from its executor, "
    "so none of its callbacks runs again"
)
WAITS = "spins until the response from the service 'far' arrives, without a timeout: "


@pytest.mark.parametrize(
    ("line", "more", "distro", "said"),
    [
        pytest.param("rclpy.spin(node)", "", None, RAISES, id="the global executor"),
        pytest.param("rclpy.spin(node)", "", "humble", WAITS, id="which works in humble"),
        pytest.param(OWN, "", None, TAKES, id="an executor of its own"),
        pytest.param("thread.join()", "", None, WAITS, id="nobody else spins"),
        pytest.param("thread.join()\n        rclpy.spin(node)", "", None, WAITS, id="it is over by then"),
        pytest.param("rclpy.spin(rclpy.create_node('other'))", "", None, WAITS, id="another node"),
        pytest.param("rclpy.spin(node)", ", SingleThreadedExecutor()", None, WAITS, id="an executor is given"),
    ],
)
def test_a_thread_that_spins_what_main_spins(judge: Judge, line: str, more: str, distro: str | None, said: str):
    config = "" if distro is None else f'distro = "{distro}"'
    [found] = judge("TMO003", BESIDE.format(line=line, more=more), config=config)
    assert found.message.startswith(said)


def test_a_method_that_spins_what_a_thread_spins(judge: Judge):
    text = BESIDE.replace("threading.Thread(target=node.read_keys", "threading.Thread(target=executor.spin")
    text = text.replace("node = Handler()", "node = Handler()\n        executor = MultiThreadedExecutor()")
    text = text.replace("import rclpy\n", "import rclpy\n    from PyQt5.QtWidgets import QPushButton\n", 1)
    line = "executor.add_node(node)\n        QPushButton().clicked.connect(node.read_keys)"
    [found] = judge("TMO003", text.format(line=line, more=""))
    assert found.message == TAKES


DRIVEN = """
    import rclpy
    from rclpy.node import Node
    from std_msgs.msg import String
    from std_srvs.srv import Trigger


    class Planner(Node):
        def __init__(self):
            super().__init__('planner')
            self.create_subscription(String, 'words', print, 10)
            self.far = self.create_client(Trigger, 'far')
            self.far.wait_for_service()  # here

        def plan(self):
            self.get_logger().info('planned')


    def main():
        rclpy.init()
        node = Planner()

        def pump(times):
            for _ in range(times):
                rclpy.spin_once(node, timeout_sec=0.05)

        {line}


    if __name__ == '__main__':
        main()
"""


@pytest.mark.parametrize(
    ("line", "severity"),
    [
        ("while rclpy.ok():\n            node.plan()\n            pump(9)", Severity.INFO),
        ("node.plan()\n        while rclpy.ok():\n            pump(9)", Severity.WARNING),
        ("while rclpy.ok():\n            node.get_logger().info('so')\n            pump(9)", Severity.WARNING),
        ("while rclpy.ok():\n            node.plan()\n            rclpy.spin(node)", Severity.WARNING),
    ],
)
def test_the_constructor_of_a_node_that_main_drives_by_hand(judge: Judge, line: str, severity: Severity):
    [found] = judge("TMO001", DRIVEN.format(line=line))
    assert found.severity is severity


def test_a_method_that_nothing_calls_says_nothing_of_those_that_are(judge: Judge):
    text = """
        import rclpy
        from rclpy.node import Node
        from std_srvs.srv import Trigger


        class Robot(Node):
            def __init__(self):
                super().__init__('robot')
                self.far = self.create_client(Trigger, 'far')

            def announce(self):
                rclpy.spin_once(self, timeout_sec=0.1)
                return self.go()

            def go(self):
                self.far.wait_for_service()  # here
                return self.far.call_async(Trigger.Request())


        def main():
            rclpy.init()
            robot = Robot()
            {call}
            rclpy.spin(robot)


        if __name__ == '__main__':
            main()
    """
    [called] = judge("TMO001", text.replace("{call}", "robot.go()"))
    assert called.severity is Severity.INFO
    [ticking] = judge("TMO001", text.replace("{call}", "robot.create_timer(1.0, robot.go)"))
    assert ticking.severity is Severity.WARNING and ticking.help.startswith("check without waiting")
    assert judge("TMO001", text.replace("{call}", "pass").replace("  # here", "")) == []


def test_a_function_that_nothing_calls_waits_for_nothing(judge: Judge):
    text = """
        import rclpy
        from std_srvs.srv import Empty


        def spawn(node, namespace):
            client = node.create_client(Empty, namespace + '/spawn')
            client.wait_for_service()  # here
            client.call(Empty.Request())


        def main():
            rclpy.init()
            node = rclpy.create_node('spawner')
            node.create_timer(1.0, lambda: {call})
            rclpy.spin(node)


        if __name__ == '__main__':
            main()
    """
    [wait] = judge("TMO001", text.replace("{call}", "spawn(node, '/sim')"))
    assert wait.severity is Severity.WARNING
    assert judge("TMO001", text.replace("{call}", "None").replace("  # here", "")) == []


def test_a_call_of_a_function_that_nothing_calls_is_information(judge: Judge):
    text = """
        from std_srvs.srv import Empty


        def spawn(node, namespace):
            client = node.create_client(Empty, namespace + '/spawn')
            client.call(Empty.Request())  # here
    """
    [uncalled] = judge("TMO002", text)
    assert uncalled.severity is Severity.INFO
    [script_calls] = judge("TMO002", script(f"{SPIN_IN_A_THREAD}\n        client.call({REQUEST})  # here"))
    assert script_calls.severity is Severity.WARNING


@pytest.mark.parametrize(
    ("line", "expected"),
    [("Asker()", 0), ("rclpy.spin(Asker())", 1), ("threading.Thread(target=rclpy.spin, args=(Asker(),)).start()", 1)],
    ids=["nothing spins it", "it is spun", "a thread spins it"],
)
def test_a_call_that_nothing_comes_to_of_a_node_that_nothing_spins(judge: Judge, line: str, expected: int):
    """It would wait for ever, and a limit would always expire: whoever calls it has to spin the node first."""
    text = f"""
        import threading
        import rclpy
        from rclpy.node import Node
        from std_srvs.srv import Trigger


        class Asker(Node):
            def __init__(self):
                super().__init__('asker')
                self.client = self.create_client(Trigger, 'far')
                rclpy.spin_once(self, timeout_sec=1.0)

            def ask(self):
                return self.client.call(Trigger.Request()){"  # here" * expected}


        def main():
            rclpy.init()
            {line}


        if __name__ == '__main__':
            main()
    """
    judge("TMO002", text)


@pytest.mark.parametrize(("config", "expected"), [("", 0), ("[rules.TMO002]\nuncalled = true\n", 1)])
def test_in_a_large_workspace_a_function_that_nothing_calls_is_for_those_who_ask(
    judge: Judge, config: str, expected: int
):
    """Whoever calls a wrapper may well have set its own limit."""
    text = f"""
        import rclpy
        from rclpy.node import Node


        class Asker(Node):
            def ask(self, client, request):
                return client.call(request)


        class Wrapper:
            def __init__(self, node, type_, name):
                self.client = node.create_client(type_, name)

            def call(self, request):
                return self.client.call(request){"  # here" * expected}


        def main():
            rclpy.init()
            nodes = [rclpy.create_node('a'), rclpy.create_node('b'), rclpy.create_node('c')]
            nodes += [rclpy.create_node('d'), rclpy.create_node('e'), rclpy.create_node('f')]


        if __name__ == '__main__':
            main()
    """
    assert len(judge("TMO002", text, config=config)) == expected


SAYS_SO = """
    import rclpy
    from rclpy.node import Node
    from std_msgs.msg import String
    from std_srvs.srv import Trigger


    class Mover(Node):
        def __init__(self):
            {doc}
            super().__init__('mover')
            self.create_subscription(String, 'words', print, 10)
            {above}
            self.client = self.create_client(Trigger, 'arm')
            self.client.wait_for_service()  # here
            # then it waits no more


    def main():
        rclpy.init()
        rclpy.spin(Mover())


    if __name__ == '__main__':
        main()
"""


@pytest.mark.parametrize(
    ("doc", "above", "severity"),
    [
        ("", "", Severity.WARNING),
        ("", "# wait for the arm to come up", Severity.INFO),
        ("", "# make sure that the arm is up", Severity.INFO),
        ("", "# ensure a smooth start", Severity.WARNING),
        ("", "# 等待服务启动", Severity.INFO),
        ("'Make a mover, which waits for the arm.'", "", Severity.INFO),
        ("'Make a mover.'", "# the arm", Severity.WARNING),
        ("", "# rospy.wait_for_service('arm')", Severity.WARNING),
        ("", "# self.wait('arm')", Severity.WARNING),
    ],
    ids=[
        "nothing",
        "a comment",
        "what has to be there",
        "something else",
        "in Chinese",
        "the docstring",
        "other words",
        "code of old",
        "a call of old",
    ],
)
def test_a_start_of_which_a_comment_says_that_it_waits(judge: Judge, doc: str, above: str, severity: Severity):
    [found] = judge("TMO001", SAYS_SO.format(doc=doc, above=above))
    assert found.severity is severity


IN_ORDER = """
    import rclpy
    from rclpy.node import Node
    from std_msgs.msg import String
    from std_srvs.srv import SetBool, Trigger


    class Mover(Node):
        def __init__(self):
            super().__init__('mover')
            self.create_subscription(String, 'words', self.on_word, 10)
            self.client = self.create_client({kind}, '{name}')
            self.client.wait_for_service()  # here
            self.enable = self.create_client(SetBool, 'enable')
            self.enable.wait_for_service()

        def on_word(self, word):
            self.enable.call_async(SetBool.Request(data=True))
            {more}


    def main():
        rclpy.init()
        rclpy.spin(Mover())


    if __name__ == '__main__':
        main()
"""


@pytest.mark.parametrize(
    ("kind", "name", "more", "severity"),
    [
        ("Trigger", "/arm/init_finish", "", Severity.INFO),
        ("Trigger", "arm/ready", "", Severity.INFO),
        ("Trigger", "arm/home", "", Severity.WARNING),
        ("Trigger", "arm/make_ready_now", "", Severity.WARNING),
        ("SetBool", "arm/ready", "", Severity.WARNING),
        ("Trigger", "arm/ready", "self.client.call_async(Trigger.Request())", Severity.WARNING),
    ],
    ids=["its name says so", "ready", "something to do", "a part of a name", "another type", "asked"],
)
def test_a_start_in_the_order_of_services_that_are_there_to_be_waited_for(
    judge: Judge, kind: str, name: str, more: str, severity: Severity
):
    [found] = judge("TMO001", IN_ORDER.format(kind=kind, name=name, more=more))
    assert found.severity is severity


ARMS = """
    import rclpy
    from rclpy.node import Node
    from std_msgs.msg import String
    from std_srvs.srv import Trigger


    class Arm:
        def __init__(self, node, name):
            self.client = node.create_client(Trigger, name)
            self.client.wait_for_service()  # here


    class Mover(Node):
        def __init__(self):
            {doc}
            super().__init__('mover')
            self.create_subscription(String, 'words', print, 10)
            self.arm = Arm(self, 'arm')


    def main():
        rclpy.init()
        rclpy.spin(Mover())


    if __name__ == '__main__':
        main()
"""


@pytest.mark.parametrize(
    ("doc", "severity"),
    [("'Waits for all arms before returning.'", Severity.INFO), ("'Make a mover.'", Severity.WARNING)],
)
def test_a_constructor_that_says_so_has_what_it_makes_wait(judge: Judge, doc: str, severity: Severity):
    [finding] = judge("TMO001", ARMS.format(doc=doc))
    assert finding.severity is severity


def test_a_script_may_wait_for_what_it_needs(judge: Judge):
    [script_waits] = judge("TMO001", script("client.wait_for_service()  # here"))
    assert script_waits.severity is Severity.INFO
    [of_message] = judge("TMO001", script("wait_for_message(String, node, 'words')  # here"))
    assert of_message.severity is Severity.WARNING
    lines = "node.create_timer(1.0, lambda: client.wait_for_service())  # here\n        rclpy.spin(node)"
    [in_callback] = judge("TMO001", script(lines))
    assert in_callback.severity is Severity.WARNING
    constructor = """
        import rclpy
        from rclpy.node import Node
        from std_srvs.srv import Trigger

        class Robot(Node):
            def __init__(self):
                super().__init__('robot')
                self.create_client(Trigger, 'near').wait_for_service()  # here

        def main():
            rclpy.init()
            rclpy.spin(Robot())

        main()
    """
    [in_constructor] = judge("TMO001", constructor)
    assert in_constructor.severity is Severity.WARNING


STARTS = """
    import rclpy
    from rclpy.node import Node
    from std_msgs.msg import String
    from std_srvs.srv import Trigger


    class {name}(Node):
        def __init__(self):
            super().__init__('{name}')
            self.create_subscription(String, 'words', self.on_word, 10)
            self.far = self.create_client(Trigger, 'far')
            {lines}

        def on_word(self, msg):
            self.far.call_async(Trigger.Request())

        def answer(self, request, response):
            return response


    def main():
        rclpy.init()
        rclpy.spin({name}())


    if __name__ == '__main__':
        main()
"""
NEAR = "self.near = self.create_client(Trigger, 'near')"
SOUGHT = "self.get_logger().info('connecting')"
LOG, WAIT = "self.get_logger().info('waiting')", "self.far.wait_for_service()  # here"


@pytest.mark.parametrize(
    ("lines", "severity"),
    [
        ([LOG, WAIT], None),
        ([LOG, "self.ready = False", WAIT], None),
        ([f"{LOG[:-1]} if input() else None)", WAIT], None),
        ([SOUGHT, "if not self.far.service_is_ready():", f"    {WAIT}"], None),
        ([SOUGHT, "if not self.arrived():", f"    {WAIT}"], Severity.WARNING),
        ([WAIT], Severity.WARNING),
        ([WAIT, LOG], Severity.WARNING),
        ([LOG.replace("waiting", "hello"), "self.create_timer(1.0, print)", WAIT], Severity.WARNING),
        ([LOG, "self.create_timer(1.0, print)", WAIT], None),
        ([f"if input(): {LOG}", WAIT], Severity.WARNING),
        ([LOG, WAIT, "self.create_service(Trigger, 'near', self.answer)"], None),
        ([NEAR, SOUGHT, "self.near.wait_for_service()", WAIT], None),
        (
            [NEAR, SOUGHT, "self.near.wait_for_service(timeout_sec=9.0)", "self.create_timer(1.0, print)", WAIT],
            Severity.WARNING,
        ),
        ([LOG, "self.create_timer(1.0, lambda: self.far.wait_for_service())  # here"], Severity.WARNING),
    ],
    ids=[
        "announced",
        "with an assignment between",
        "whatever the words",
        "asked whether it is there",
        "something else done between",
        "not announced",
        "announced too late",
        "said of something else",
        "said earlier that it waits",
        "said now and then",
        "a node that serves others",
        "right behind another wait",
        "something else done behind another wait",
        "in a callback",
    ],
)
def test_a_node_that_says_that_it_waits_before_it_starts(judge: Judge, lines: list[str], severity: Severity | None):
    text = STARTS.format(name="Robot", lines="\n            ".join(lines))
    found = judge("TMO001", text if severity is not None else text.replace("  # here", ""))
    assert [one.severity for one in found] == ([] if severity is None else [severity])


@pytest.mark.parametrize(
    ("first", "marks"),
    [
        ("self.far.wait_for_service()  # here", ""),  # told there
        ("self.get_logger().info('waiting')\n            self.far.wait_for_service()", ""),
        ("self.far.wait_for_service(timeout_sec=5.0)", "  # here"),
        ("self.near.wait_for_service()  # here", "  # here"),
    ],
    ids=["it came", "it came, as announced", "perhaps it did not", "another one"],
)
def test_a_callback_waits_for_what_came_before_the_program_span(judge: Judge, first: str, marks: str):
    lines = (
        "self.near = self.create_client(Trigger, 'near')",
        first,
        f"self.create_timer(1.0, lambda: self.far.wait_for_service()){marks}",
    )
    judge("TMO001", STARTS.format(name="Robot", lines="\n            ".join(lines)))


BESIDE_OTHERS = """
    import rclpy
    from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
    from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
    from rclpy.node import Node
    from std_srvs.srv import Trigger


    class Robot(Node):
        def __init__(self):
            super().__init__('robot')
            self.group = {group}()
            self.far = self.create_client(Trigger, 'far')
            self.create_timer(1.0, self.tick, callback_group=self.group)
            self.create_timer(9.0, print, callback_group=self.group)

        def tick(self):
            {log}
            self.far.wait_for_service()  # here


    def main():
        rclpy.init()
        executor = {executor}()
        executor.add_node(Robot())
        executor.spin()


    main()
"""


@pytest.mark.parametrize(
    ("group", "log", "executor", "told"),
    [
        ("ReentrantCallbackGroup", LOG, "MultiThreadedExecutor", False),
        ("ReentrantCallbackGroup", "pass", "MultiThreadedExecutor", True),
        ("MutuallyExclusiveCallbackGroup", LOG, "MultiThreadedExecutor", True),
        ("ReentrantCallbackGroup", LOG, "SingleThreadedExecutor", True),
    ],
)
def test_a_callback_that_says_that_it_waits_beside_all_others(
    judge: Judge, group: str, log: str, executor: str, told: bool
):
    text = BESIDE_OTHERS.format(group=group, log=log, executor=executor)
    judge("TMO001", text if told else text.replace("  # here", ""))


def test_what_a_script_waits_for_is_told_in_a_lesson_and_on_demand(judge: Judge):
    others = "".join(f"rclpy.create_node('part_{number}'); " for number in range(5))
    wait = script(f"{others}\n        client.wait_for_service()  # here")
    judge("TMO001", wait.replace("  # here", ""))
    [found] = judge("TMO001", wait, config="[rules.wait-without-timeout]\nscripts = true\n")
    assert found.severity is Severity.INFO


@pytest.mark.parametrize(
    ("lines", "told"),
    [
        ("word = sys.argv[1]\n        client.wait_for_service()", False),
        ("words = sys.argv\n        client.wait_for_service()  # here", True),
    ],
    ids=["a word says what to do", "as rclpy takes them"],
)
def test_a_command_that_asks_one_thing_may_wait_in_a_lesson(judge: Judge, lines: str, told: bool):
    found = judge("TMO001", script(lines).replace("import rclpy\n", "import sys\n\n    import rclpy\n", 1))
    assert bool(found) is told


def test_a_constructor_that_ends_its_program_is_a_command(judge: Judge):
    once = """
        import rclpy
        from rclpy.node import Node
        from std_srvs.srv import Trigger


        class Once(Node):
            def __init__(self):
                super().__init__('once')
                client = self.create_client(Trigger, 'go')
                client.wait_for_service(){mark}
                client.call_async(Trigger.Request())
                {end}


        def main():
            rclpy.init()
            Once()


        if __name__ == '__main__':
            main()
    """
    judge("TMO001", once.format(mark="", end="exit()"))
    judge("TMO001", once.format(mark="  # here", end="print('asked')"))


LOST_ANSWERS = "[rules.TMO003]\nlost-answers = true\n"

START = """
    import rclpy
    from control_msgs.action import FollowJointTrajectory
    from rclpy.action import ActionClient
    from rclpy.node import Node


    class Replay(Node):
        def __init__(self):
            super().__init__('replay')
            self.arm = ActionClient(self, FollowJointTrajectory, 'follow')
            self.step = self.create_timer(5.0, self.on_step)
            self.timer = self.create_timer(1.0, self.start)

        def start(self):
            {first}
            self.send()

        def on_step(self):
            {again}

        def send(self):
            self.arm.wait_for_server(){here}
            self.arm.send_goal_async(FollowJointTrajectory.Goal())


    def main():
        rclpy.init()
        {more}
        rclpy.spin(Replay())


    if __name__ == '__main__':
        main()
"""


@pytest.mark.parametrize(
    ("first", "again", "told"),
    [
        ("self.timer.cancel()", "pass", False),
        ("self.timer.cancel()", "self.send()", False),
        ("self.step.cancel()", "pass", True),
        ("print('again')", "self.send()", True),
    ],
    ids=["it starts", "what comes later finds it", "another timer ends", "again and again"],
)
def test_a_timer_that_ends_itself_is_the_start_of_a_program(judge: Judge, first: str, again: str, told: bool):
    """Whoever runs a player of motions wants it to wait for its arm, once: in a lesson it is told, as information."""
    others = "".join(f"rclpy.create_node('part_{number}'); " for number in range(5))
    text = START.replace("{first}", first).replace("{again}", again)
    judge("TMO001", text.format(here="  # here" if told else "", more=others))
    [wait] = judge("TMO001", text.format(here="  # here", more="pass"))
    assert wait.severity is (Severity.WARNING if told else Severity.INFO)
    assert ("server_is_ready" in (wait.help or "")) == told


def test_what_the_scripts_of_one_package_wait_for_is_one_finding(judge: Judge, tmp_path):
    (tmp_path / "package.xml").write_text("<package format='3'><name>robot</name><version>0.0.1</version></package>")
    lines = "client = node.create_client(Trigger, 'far')\n        client.wait_for_service()  # here"
    first, second = (script(lines), script(lines).replace("  # here", ""))
    [found] = judge("TMO001", first, second)
    assert found.severity is Severity.INFO
    assert found.message.endswith("; another wait of the package 'robot' does the same")


SEVERAL = """
    import rclpy
    from rclpy.node import Node
    from std_srvs.srv import Trigger


    class Arm(Node):
        def __init__(self):
            super().__init__('arm')
            self.brake = self.create_client(Trigger, 'brake')
            self.motor = self.create_client(Trigger, '{motor}')
            self.find(self.brake)
            self.find(self.motor)

        def find(self, client):
            client.wait_for_service()  # here


    def main():
        rclpy.init()
        rclpy.spin(Arm())


    main()
"""


@pytest.mark.parametrize(("motor", "awaited"), [("motor", "a service"), ("brake", "the service 'brake'")])
def test_a_helper_that_waits_for_one_server_after_the_other_names_none(judge: Judge, motor: str, awaited: str):
    [wait] = judge("TMO001", SEVERAL.format(motor=motor))
    assert wait.message.startswith(f"wait_for_service() waits for {awaited} without a timeout: ")


def test_a_method_that_nothing_calls_for_a_client_that_nothing_makes(judge: Judge):
    code = """
        import rclpy
        from rclpy.node import Node
        from std_srvs.srv import Trigger

        class Robot(Node):
            def __init__(self):
                super().__init__('robot')
                self.near = self.create_client(Trigger, 'near')

            def ask(self):
                rclpy.spin_until_future_complete(self, self.far.call_async(Trigger.Request()))
                rclpy.spin_until_future_complete(self, self.near.call_async(Trigger.Request()))  # here

        def main():
            rclpy.init()
            rclpy.spin(Robot())
    """
    judge("TMO003", code)


class TestWaitWithoutTimeout:
    @pytest.mark.parametrize(
        "line",
        [
            "client.wait_for_service()",
            "client.wait_for_service(None)",
            "client.wait_for_service(timeout_sec=None)",
            "client.wait_for_service(timeout)",
            "found = client.wait_for_service()",
            "action.wait_for_server()",
            "wait_for_message(String, node, 'words')",
            "wait_for_message(String, node, 'words', time_to_wait=-1)",
        ],
    )
    def test_without_a_limit(self, judge: Judge, line: str):
        judge("TMO001", script(line + "  # here"))

    @pytest.mark.parametrize(
        "line",
        [
            "client.wait_for_service(1.0)",
            "client.wait_for_service(timeout_sec=-1.0)",  # does not wait at all
            "client.wait_for_service(timeout_sec=float(input()))",
            "client.wait_for_service(**{'timeout_sec': 1.0})",
            "action.wait_for_server(timeout_sec=0.5)",
            "wait_for_message(String, node, 'words', time_to_wait=2)",
        ],
    )
    def test_with_a_limit(self, judge: Judge, line: str):
        judge("TMO001", script(line))

    def test_a_limit_that_is_a_parameter(self, judge: Judge):
        judge(
            "TMO001",
            script("client.wait_for_service(node.declare_parameter('patience', 2.0).value)"),
        )

    def test_a_helper_whose_callers_choose(self, judge: Judge):
        judge(
            "TMO001",
            """
            from std_srvs.srv import Trigger


            class Far:
                def __init__(self, node):
                    self.client = node.create_client(Trigger, 'far')

                def wait(self, timeout=None):
                    return self.client.wait_for_service(timeout_sec=timeout)
            """,
        )

    def test_a_helper_that_a_caller_gives_no_limit(self, judge: Judge):
        [found] = judge(
            "TMO001",
            script(
                "def wait(limit=None):\n            client.wait_for_service(timeout_sec=limit)  # here\n        wait()"
            ),
        )

        assert [related.message for related in found.related] == [
            "main calls main.wait here",
            "the client is created here",
        ]

    def test_a_test_may_wait(self, judge: Judge):
        (judge.folder / "test").mkdir()
        (judge.folder / "test" / "test_far.py").write_text(
            "import rclpy\n"
            "from std_srvs.srv import Trigger\n"
            "def test_far():\n"
            "    node = rclpy.create_node('far')\n"
            "    node.create_client(Trigger, 'far').wait_for_service()\n"
        )

        judge("TMO001")


class TestCallWithoutTimeout:
    @pytest.mark.parametrize(
        "line",
        [
            f"client.call({REQUEST})",
            f"client.call({REQUEST}, timeout_sec=None)",
            "action.send_goal(Fibonacci.Goal())",
        ],
    )
    def test_without_a_limit(self, judge: Judge, line: str):
        judge("TMO002", script(f"{SPIN_IN_A_THREAD}\n        {line}  # here"))

    @pytest.mark.parametrize("line", [f"client.call({REQUEST})", "action.send_goal(Fibonacci.Goal())"])
    def test_nobody_spins_while_it_waits(self, judge: Judge, line: str):
        """It is certain then, and only that is said."""
        source = script(f"{line}  # here\n        rclpy.spin(node)")
        [finding] = judge("EXE009", source)
        assert "never returns: nothing spins the node of" in finding.message
        judge("TMO002", source.replace("  # here", ""))

    @pytest.mark.parametrize(
        "lines",
        [
            f"{SPIN_IN_A_THREAD}\n        client.call({REQUEST})",
            f"hand_over(node)\n        client.call({REQUEST})",
            f"client.call({REQUEST}, timeout_sec=1.0)",
            f"node.create_timer(1.0, lambda: client.call({REQUEST}))\n        rclpy.spin(node)",
        ],
        ids=["a thread spins", "other code may spin", "a timeout", "in a callback"],
    )
    def test_somebody_may_spin_while_it_waits(self, judge: Judge, lines: str):
        judge("EXE009", script(lines))

    @pytest.mark.parametrize(
        "line",
        [
            f"client.call({REQUEST}, timeout_sec=2.0)",
            f"client.call({REQUEST}, 2.0)",
            FUTURE,
            "action.send_goal_async(Fibonacci.Goal())",
        ],
    )
    def test_with_a_limit_or_without_a_wait(self, judge: Judge, line: str):
        judge("TMO002", script(line))

    def test_a_try_around_it_sets_no_limit(self, judge: Judge):
        judge(
            "TMO002",
            script(
                f"{SPIN_IN_A_THREAD}\n        try:\n            client.call({REQUEST})  # here\n"
                "        except Exception:\n            pass"
            ),
        )

    @pytest.mark.parametrize(
        ("code", "before", "distro", "help_"),
        [
            (
                "EXE009",
                "pass",
                "humble",
                "call_async() and rclpy.spin_until_future_complete(node, future, timeout_sec=…)" + LONGER,
            ),
            (
                "EXE009",
                "pass",
                "jazzy",
                "call_async() and rclpy.spin_until_future_complete(node, future, timeout_sec=…)" + LONGER,
            ),
            (
                "EXE009",
                "executor.add_node(node)",
                "jazzy",
                "call_async() and executor.spin_until_future_complete(future, timeout_sec=…)" + LONGER,
            ),
            ("TMO002", SPIN_IN_A_THREAD, "jazzy", "call(request, timeout_sec=…)" + LONGER),
            (
                "TMO002",
                SPIN_IN_A_THREAD,
                "humble",
                "another thread spins the node: call_async(), and wait with event.wait(timeout=…) for an Event "
                "that a done callback sets" + LONGER,
            ),
            (
                "TMO002",
                "hand_over(node)",
                "jazzy",
                "call_async() and continue in a done callback: future.add_done_callback(…)",
            ),
        ],
        ids=["humble", "later", "an executor that spins later", "another thread", "and in humble", "who knows"],
    )
    def test_what_helps_depends_on_who_spins_the_node(
        self, judge: Judge, code: str, before: str, distro: str, help_: str
    ):
        lines = f"{before}\n        client.call({REQUEST})  # here\n        executor.spin()"
        [found] = judge(code, script(lines), config=f'distro = "{distro}"')

        assert found.help == help_

    def test_a_call_that_can_never_be_answered_needs_no_limit(self, judge: Judge):
        judge("TMO002", script(f"node.create_timer(1.0, lambda: client.call({REQUEST}))\n        rclpy.spin(node)"))

    def test_a_callback_is_not_told_to_spin(self, judge: Judge):
        lines = (
            "client = node.create_client(Trigger, 'far', callback_group=ReentrantCallbackGroup())",
            f"node.create_timer(1.0, lambda: client.call({REQUEST}))  # here",
            "executor = MultiThreadedExecutor()",
            "executor.add_node(node)",
            "executor.spin()",
        )
        [found] = judge("TMO002", script("\n        ".join(lines)))

        assert found.help == "call_async() and continue in a done callback: future.add_done_callback(…)"

    @pytest.mark.parametrize(
        ("returned", "distro", "help_"),
        [
            ("return response.success", "jazzy", "call(request, timeout_sec=…)" + LONGER),
            (
                "return response.success",
                "humble",
                "another thread spins the node: call_async(), and wait with event.wait(timeout=…) for an Event "
                "that a done callback sets" + LONGER,
            ),
            ("print(response)", "jazzy", "call_async() and continue in a done callback: future.add_done_callback(…)"),
        ],
        ids=["the answer is returned", "and in humble", "it is not"],
    )
    def test_what_a_helper_returns_cannot_come_later(self, judge: Judge, returned: str, distro: str, help_: str):
        """The callback, and who waits for its result, goes on with what the helper has returned."""
        text = ASKING.replace("return response.success", returned)
        [finding] = judge("TMO002", text, config=f'distro = "{distro}"')

        assert finding.help == help_
        assert finding.message.endswith("; another call in the class Asking does the same")


ASKING = """
    import rclpy
    from rclpy.callback_groups import ReentrantCallbackGroup
    from rclpy.executors import MultiThreadedExecutor
    from rclpy.node import Node
    from std_srvs.srv import SetBool


    class Asking(Node):
        def __init__(self):
            super().__init__('asking')
            group = ReentrantCallbackGroup()
            self.switch = self.create_client(SetBool, 'switch', callback_group=group)
            self.create_timer(10.0, self.tick, callback_group=group)

        def tick(self):
            print(self.turn_on(), self.turn_off())

        def turn_on(self):
            response = self.switch.call(SetBool.Request(data=True))  # here
            return response.success

        def turn_off(self):
            response = self.switch.call(SetBool.Request(data=False))
            return response.success


    def main():
        rclpy.init()
        executor = MultiThreadedExecutor()
        executor.add_node(Asking())
        executor.spin()
"""
FILTER = """
    import rclpy
    from rclpy.node import Node
    from std_msgs.msg import String
    from std_srvs.srv import Trigger


    class Filter(Node):
        def __init__(self):
            super().__init__('filter')
            self.maps = self.create_client(Trigger, 'map')
            self.other = self.create_client(Trigger, 'other')
            {before}
            {inside}
            self.create_subscription(String, 'scan', print, 10)

        def load(self):
            future = self.maps.call_async(Trigger.Request())
            rclpy.spin_until_future_complete(self, future){mark}
            self.map = future.result()


    def main():
        rclpy.init()
        node = Filter()
        {later}
        rclpy.spin(node)


    if __name__ == '__main__':
        main()
"""


class TestSpinWithoutTimeout:
    @pytest.mark.parametrize(
        "line",
        [
            f"rclpy.spin_until_future_complete(node, {FUTURE})",
            f"rclpy.spin_until_future_complete(node, {FUTURE}, executor)",
            f"rclpy.spin_until_future_complete(node, {FUTURE}, timeout_sec=None)",
            f"rclpy.spin_until_future_complete(node, {FUTURE}, timeout_sec=-1)",
            f"executor.spin_until_future_complete({FUTURE})",
        ],
    )
    def test_without_a_limit(self, judge: Judge, line: str):
        judge("TMO003", script(line + "  # here"))

    @pytest.mark.parametrize(
        "line",
        [
            f"rclpy.spin_until_future_complete(node, {FUTURE}, timeout_sec=1.0)",
            f"rclpy.spin_until_future_complete(node, {FUTURE}, executor, 1.0)",
            f"executor.spin_until_future_complete({FUTURE}, 1.0)",
            "rclpy.spin_once(node)",
        ],
    )
    def test_with_a_limit(self, judge: Judge, line: str):
        judge("TMO003", script(line))

    @pytest.mark.parametrize(
        ("loop", "between", "mark"),
        [
            ("while not answer.done(): rclpy.spin_once(node)", "pass", ""),
            ("while not answer.done(): rclpy.spin_once(node)", "print('done')", ""),
            ("while not other.done(): rclpy.spin_once(node)", "pass", "  # here"),
            ("while not answer.done(): rclpy.spin_once(node)", f"answer = {FUTURE}", "  # here"),
            ("while rclpy.ok() and not answer.done(): rclpy.spin_once(node)", "pass", "  # here"),
            ("while not answer.done():\n            rclpy.spin_once(node)\n            break", "pass", "  # here"),
        ],
    )
    def test_what_a_loop_has_waited_for(self, judge: Judge, loop: str, between: str, mark: str):
        lines = (f"answer = other = {FUTURE}", loop, between, f"rclpy.spin_until_future_complete(node, answer){mark}")
        judge("TMO003", script("\n        ".join(lines)))

    def test_the_goal_and_its_result_are_one_finding(self, judge: Judge):
        lines = [
            "node.create_timer(1.0, print); goal = action.send_goal_async(Fibonacci.Goal())",
            "rclpy.spin_until_future_complete(node, goal)",
            "result = goal.result().get_result_async()",
            "rclpy.spin_until_future_complete(node, result)  # here",
        ]
        [found] = judge("TMO003", script("\n        ".join(lines)))
        assert found.message.startswith("spins until the result from the action 'count' arrives")
        looked_for = ["if not action.wait_for_server(timeout_sec=2.0): return", *lines]
        looked_for[3] = f"if not goal.result(): return\n        {lines[2]}"
        [after] = judge("TMO003", script("\n        ".join(looked_for)))
        assert "so it spins for the answer to the goal" in [one.message for one in after.related]
        limited = [lines[0], lines[1].replace("goal)", "goal, timeout_sec=2.0)"), *lines[2:]]
        [of_result] = judge("TMO003", script("\n        ".join(limited)))
        assert "cancel the goal" in of_result.help and "cancel the goal" in found.help
        alone = [lines[0], f"{lines[1]}  # here", "goal.result()", "node.destroy_node()"]
        [of_goal] = judge("TMO003", script("\n        ".join(alone)))
        assert "the response from the action 'count'" in of_goal.message and "cancel the goal" not in of_goal.help

    @pytest.mark.parametrize(
        ("before", "mark"),
        [
            ("if client.wait_for_service(timeout_sec=2.0): print('there')", ""),
            ("while not client.wait_for_service(timeout_sec=1.0): print('waiting')", ""),
            ("client.wait_for_service(timeout_sec=2.0)", "  # here"),  # nobody looks at what it says
            ("pass", "  # here"),
            ("client.wait_for_service(); node.create_timer(1.0, print)", "  # here"),
        ],
    )
    def test_a_script_that_asks_a_server_which_it_has_found(self, judge: Judge, before: str, mark: str):
        text = script(f"{before}\n        rclpy.spin_until_future_complete(node, {FUTURE}){mark}")
        judge("TMO003", text, config=LOST_ANSWERS)

    @pytest.mark.parametrize(
        ("before", "inside", "mark"),
        [
            ("while not self.maps.wait_for_service(timeout_sec=1.0): print('waiting')", "self.load()", ""),
            ("self.maps.wait_for_service()", "self.load()", ""),
            ("self.maps.wait_for_service(timeout_sec=1.0)", "self.load()", "  # here"),  # it may not be there
            ("self.other.wait_for_service()", "self.load()", "  # here"),
            ("self.maps.wait_for_service()", "pass", "  # here"),  # main() calls it later
        ],
    )
    def test_a_constructor_that_has_waited_for_the_server(self, judge: Judge, before: str, inside: str, mark: str):
        later = "node.load()" if inside == "pass" else "pass"
        text = FILTER.format(before=before, inside=inside, later=later, mark=mark)
        judge("TMO003", text, config=LOST_ANSWERS)

    def test_a_loop_until_the_future_is_done_asks_already(self, judge: Judge):
        lines = (
            f"future = {FUTURE}",
            "while rclpy.ok() and not future.done():",
            "    rclpy.spin_until_future_complete(node, future)  # here",
        )
        [spin] = judge("TMO003", script("\n        ".join(lines)))
        assert spin.help == "set timeout_sec, and end the loop after some attempts"

    def test_a_future_that_the_code_completes_itself_is_no_answer(self, judge: Judge):
        judge("TMO003", script("rclpy.spin_until_future_complete(node, Future())"))

    @pytest.mark.parametrize(
        ("setup", "end", "mark"),
        [
            pytest.param("", "print(done.result())", "  # here", id="only a message completes it"),
            pytest.param("", "node.destroy_node()", "", id="a message ends the program"),
            pytest.param(
                "node.create_timer(5.0, lambda: done.set_result(None))",
                "print(done.result())",
                "",
                id="so does a timer",
            ),
        ],
    )
    def test_a_future_that_a_subscription_completes(self, judge: Judge, setup: str, end: str, mark: str):
        lines = (
            "done = Future()",
            "node.create_subscription(String, 'words', lambda message: done.set_result(message), 10)",
            setup or "pass",
            f"rclpy.spin_until_future_complete(node, done){mark}",
            end,
        )
        judge("TMO003", script("\n        ".join(lines)))


class TestIgnoredWaitResult:
    @pytest.mark.parametrize(
        "line",
        [
            "client.wait_for_service(timeout_sec=1.0)",
            "action.wait_for_server(timeout_sec=1.0)",
            "found = client.wait_for_service(timeout_sec=1.0)",
        ],
    )
    def test_thrown_away(self, judge: Judge, line: str):
        judge("TMO005", script(line + "  # here"))

    @pytest.mark.parametrize(
        "line",
        [
            "found = client.wait_for_service(timeout_sec=1.0)\n        print(found)",
            "found = client.wait_for_service(timeout_sec=1.0)\n        node.create_timer(1.0, lambda: print(found))",
            "node.found = client.wait_for_service(timeout_sec=1.0)",
            "assert client.wait_for_service(timeout_sec=1.0)",
            "client.wait_for_service(timeout_sec=1.0) or print('no server')",
            "client.wait_for_service()",  # has no result to ignore: it ends when the server is there
        ],
    )
    def test_looked_at(self, judge: Judge, line: str):
        judge("TMO005", script(line))

    @pytest.mark.parametrize(
        ("before", "after", "count"),
        [
            ("node.create_service(Trigger, 'near', serve)", "pass", 0),
            ("node.create_service(Trigger, 'other', serve)", "pass", 1),
            ("pass", "node.create_service(Trigger, 'near', serve)", 1),
            ("if random() > 0.5:\n            node.create_service(Trigger, 'near', serve)", "pass", 1),
        ],
    )
    def test_a_service_that_the_node_serves_itself(self, judge: Judge, before: str, after: str, count: int):
        lines = (
            "from random import random",
            "serve = lambda request, response: response",
            before,
            "near = node.create_client(Trigger, 'near')",
            f"near.wait_for_service(timeout_sec=1.0){'  # here' * count}",
            after,
        )
        judge("TMO005", script("\n        ".join(lines)))

    def test_all_waits_of_a_function_are_one_finding(self, judge: Judge):
        waits = "client.wait_for_service(timeout_sec=1.0)  # here\n        action.wait_for_server(timeout_sec=1.0)"
        [found] = judge("TMO005", script(waits))
        assert found.message.endswith("; another wait in main() does the same")
        assert [row.message for row in found.related[-1:]] == ["the result of this wait is ignored, too"]

    def test_a_later_question_about_the_same_client_counts(self, judge: Judge):
        judge(
            "TMO005",
            script("client.wait_for_service(timeout_sec=1.0)\n        print(client.service_is_ready())"),
        )

    def test_a_later_question_about_another_client_does_not(self, judge: Judge):
        judge(
            "TMO005",
            script("client.wait_for_service(timeout_sec=1.0)  # here\n        print(action.server_is_ready())"),
        )

    def test_two_programs_that_run_one_line_make_one_finding(self, judge: Judge):
        judge(
            "TMO005",
            """
            import rclpy
            from node1 import Far


            def main():
                rclpy.init()
                rclpy.spin(Far())


            if __name__ == '__main__':
                main()
            """,
            """
            import rclpy
            from rclpy.node import Node
            from std_srvs.srv import Trigger


            class Far(Node):
                def __init__(self):
                    super().__init__('far')
                    self.client = self.create_client(Trigger, 'far')
                    self.client.wait_for_service(timeout_sec=1.0)  # here


            def main():
                rclpy.init()
                rclpy.spin(Far())


            if __name__ == '__main__':
                main()
            """,
        )


CALLS_APART = """
    import threading

    import rclpy
    from rclpy.node import Node
    from std_srvs.srv import Trigger


    class Robot(Node):
        def __init__(self):
            super().__init__('robot')
            self.arm = self.create_client(Trigger, 'arm')
            self.create_service(Trigger, 'up', self.up)

        def up(self, request, response):
            def move():
                {move}

            {start}
            return response


    def main():
        rclpy.init()
        rclpy.spin(Robot())


    main()
"""
ONCE = "self.get_logger().info(str(self.arm.call(Trigger.Request())))"
DAEMON = "threading.Thread(target=move, daemon=True).start()"


@pytest.mark.parametrize(
    ("move", "start", "told"),
    [
        (ONCE, DAEMON, False),
        (ONCE, "timer = threading.Timer(0, move)\n            timer.daemon = True\n            timer.start()", False),
        (ONCE, "threading.Thread(target=move).start()", True),  # the program cannot end
        (ONCE, "threading.Thread(target=move, daemon=False).start()", True),
        (f"while rclpy.ok():\n                    {ONCE}", DAEMON, True),  # its other rounds wait
    ],
)
def test_a_daemon_thread_that_is_made_for_one_call_may_wait(judge: Judge, move: str, start: str, told: bool):
    judge("TMO002", CALLS_APART.format(move=move + "  # here" * told, start=start))


UNUSED = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Trigger


class Panel(Node):
    def __init__(self):
        super().__init__('panel')
        self.lamp = self.create_client(Trigger, 'lamp')
        self.state = self.create_publisher(String, 'state', 10)
        {line}

    def blink(self):
        while not self.lamp.wait_for_service(timeout_sec=1.0):
            time.sleep(1.0)
        rclpy.spin_until_future_complete(self, self.lamp.call_async(Trigger.Request()))


{main}
"""
MAIN = "def main():\n    rclpy.init()\n    rclpy.spin(Panel())\n\n\nif __name__ == '__main__':\n    main()\n"
CALLS_IT = MAIN.replace("rclpy.spin(Panel())", "panel = Panel()\n    panel.blink()\n    rclpy.spin(panel)")


@pytest.mark.parametrize(
    ("main", "mark"), [(MAIN, ""), (CALLS_IT, "  # here")], ids=["nothing calls it", "it is called"]
)
def test_a_spin_in_a_method_of_a_program_that_nothing_calls(judge: Judge, tmp_path, main: str, mark: str):
    (tmp_path / "package.xml").write_text("<package format='3'><name>panel</name><version>0.0.1</version></package>")
    text = UNUSED.format(line="self.create_timer(1.0, print)", main=main)
    text = text.replace("Trigger.Request()))", f"Trigger.Request())){mark}")
    judge("TMO003", text, "class Lamp:\n    def blink(self):\n        pass\n", config=LOST_ANSWERS)


def test_a_method_of_that_name_in_a_file_that_only_says_the_name_of_the_module(judge: Judge, tmp_path):
    (tmp_path / "package.xml").write_text("<package format='3'><name>panel</name><version>0.0.1</version></package>")
    text = UNUSED.format(line="self.create_timer(1.0, print)", main=MAIN)
    own = "class Lamp:\n    def blink(self):\n        self.blink() or print('node')\n"
    judge("TMO003", text, own, config=LOST_ANSWERS)
    marked = text.replace("Trigger.Request()))", "Trigger.Request()))  # here")
    judge("TMO003", text, "from node import Panel\n" + own, config=LOST_ANSWERS)
    calls = own.replace("print('node')", "Panel().blink()")
    judge("TMO003", marked, "from node import Panel\n" + calls, config=LOST_ANSWERS)


@pytest.mark.parametrize(
    ("line", "main", "other", "expected"),
    [
        pytest.param("pass", MAIN, "", [], id="nothing names it"),
        pytest.param("pass", CALLS_IT, "", ["TMO003", "TMO004"], id="it is called"),
        pytest.param("start(self.blink)", MAIN, "", ["TMO003", "TMO004"], id="it is handed on"),
        pytest.param("pass", MAIN, "def use(panel):\n    panel.blink()\n", [], id="a file that nothing imports"),
        pytest.param(
            "pass",
            CALLS_IT.replace("panel.blink()", "import other\n    other.use(panel)"),
            "def use(panel):\n    panel.blink()\n",
            ["TMO003", "TMO004"],
            id="another file",
        ),
        pytest.param("pass", "", "", ["TMO003", "TMO004"], id="a library's"),
    ],
)
def test_a_method_that_no_file_of_the_workspace_names_does_not_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, line: str, main: str, other: str, expected: list[str]
):
    package = tmp_path / "panel"
    package.mkdir()
    (package / "package.xml").write_text(
        "<package format='3'><name>panel</name><version>0.0.1</version>"
        "<export><build_type>ament_python</build_type></export></package>",
        encoding="utf-8",
    )
    scripts = ["panel = panel:main"] if main else []
    (package / "setup.py").write_text(
        "from setuptools import setup\n\n"
        f"setup(name='panel', py_modules=['panel', 'other'], entry_points={{'console_scripts': {scripts}}})\n",
        encoding="utf-8",
    )
    (package / "panel.py").write_text(UNUSED.format(line=line, main=main), encoding="utf-8")
    (package / "other.py").write_text(other, encoding="utf-8")
    (tmp_path / "archlint.toml").write_text(f'select = ["TMO003", "TMO004"]\n{LOST_ANSWERS}', encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    found = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert sorted(one.code for one in found) == expected


# The loop of TMO004 comes after the wait of TMO001, and never repeats.
@pytest.mark.parametrize(("main", "count"), [(MAIN, 0), (CALLS_IT, 2)])
def test_a_method_of_a_script_in_no_package_that_nothing_calls(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, main: str, count: int
):
    text = UNUSED.format(line="pass", main=main)
    more = "    def blink(self):\n        self.lamp.wait_for_service()\n"
    (tmp_path / "panel.py").write_text(text.replace("    def blink(self):\n", more), encoding="utf-8")
    (tmp_path / "lamp.py").write_text("class Lamp:\n    def blink(self):\n        pass\n", encoding="utf-8")
    (tmp_path / "archlint.toml").write_text(
        f'select = ["TMO001", "TMO003", "TMO004"]\n{LOST_ANSWERS}', encoding="utf-8"
    )
    monkeypatch.chdir(tmp_path)
    assert len(check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings) == count


HELPER = """
import rclpy
from rclpy.node import Node
from std_srvs.srv import Trigger


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.lamp = self.create_client(Trigger, 'lamp')
        self.ask({given})

    def ask(self, limit=None):
        future = self.lamp.call_async(Trigger.Request())
        rclpy.spin_until_future_complete(self, future, timeout_sec={limit}){mark}


def main():
    rclpy.init()
    rclpy.spin(Robot())


main()
"""


@pytest.mark.parametrize(
    ("given", "limit", "help_"),
    [
        ("", "limit", "pass ask() a timeout where it is called, or give the parameter a default other than None"),
        ("", "None", "set timeout_sec, and check future.done() afterwards"),
        ("2.0", "limit", None),
    ],
)
def test_a_limit_that_a_helper_passes_on(judge: Judge, given: str, limit: str, help_: str | None):
    found = judge("TMO003", HELPER.format(given=given, limit=limit, mark="  # here" if help_ else ""))
    assert [one.help for one in found] == ([help_] if help_ else [])


BLOCK = """
from rclpy.node import Node
from std_srvs.srv import Trigger


class Gripper(Node):
    def __init__(self):
        super().__init__('gripper')
        self.client = self.create_client(Trigger, 'reboot')

    def reboot(self, block: bool = False):
        if block:
            self.client.call(Trigger.Request())  # here
        else:
            {otherwise}
"""


@pytest.mark.parametrize(
    ("otherwise", "distro", "help_"),
    [
        ("self.client.call_async(Trigger.Request())", "humble", "event.wait(timeout=…)"),
        ("self.client.call_async(Trigger.Request())", "jazzy", "call(request, timeout_sec=…)" + LONGER),
        ("pass", "humble", "future.add_done_callback"),
    ],
)
def test_who_wants_to_wait_is_not_told_to_go_on(judge: Judge, otherwise: str, distro: str, help_: str):
    [found] = judge("TMO002", BLOCK.format(otherwise=otherwise), config=f'distro = "{distro}"')
    assert help_ in found.help


@pytest.mark.parametrize(("asks", "mark"), [("call", ""), ("call_async", "  # here")])
def test_a_spin_behind_a_call_that_never_returns(judge: Judge, asks: str, mark: str):
    lines = (f"future = client.{asks}({REQUEST})", f"rclpy.spin_until_future_complete(node, future){mark}")
    judge("TMO003", script("\n        ".join(lines)), config=LOST_ANSWERS)


@pytest.mark.parametrize(
    ("at_the_end", "told"),
    [
        ("if goal is not None:\n            goal.cancel_goal_async()", 0),
        ("pass", 1),
        ("node.destroy_node()\n        rclpy.shutdown()", 1),
        ("node.get_logger().info('stopped')", 1),
    ],
)
def test_a_script_that_ctrl_c_ends_on_purpose(tmp_path: Path, monkeypatch, at_the_end: str, told: int):
    line = (
        "goal = None\n    try:\n        action.wait_for_server()\n        goal = action.send_goal(Fibonacci.Goal())\n"
        f"    except KeyboardInterrupt:\n        {at_the_end}"
    )
    monkeypatch.chdir(tmp_path)
    Path("script.py").write_text(dedent(SCRIPT).format(line=line))
    Path("archlint.toml").write_text('select = ["TMO001"]\n[rules.TMO001]\nscripts = true\n')
    assert len(check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings) == told


def test_a_server_of_which_part_of_the_name_is_known(judge: Judge):
    text = """
        import rclpy
        from rclpy.node import Node
        from std_srvs.srv import Empty


        class Spawner(Node):
            def __init__(self):
                super().__init__('spawner')
                for name in open('robots.txt').read().split():
                    client = self.create_client(Empty, f'/{name}/spawn')
                    client.wait_for_service()  # here


        def main():
            rclpy.init()
            rclpy.spin(Spawner())


        if __name__ == '__main__':
            main()
    """
    [wait] = judge("TMO001", text)
    assert wait.message.startswith("wait_for_service() waits for a service called '/…/spawn' without a timeout")
