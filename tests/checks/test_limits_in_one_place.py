"""TMO001, TMO003 and TMO004: one finding for a class, what a script may do, and help that fits the place."""

from __future__ import annotations

from pathlib import Path
from textwrap import dedent

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Severity
from checks.judging import Judge
from robot_package import write_robot

CLIENT = """
    import rclpy
    from rclpy.node import Node
    from std_msgs.msg import Empty
    from std_srvs.srv import Trigger


    class Asker(Node):
        def __init__(self):
            super().__init__('asker')
            self.first = self.create_client(Trigger, 'first')
            self.second = self.create_client(Trigger, 'second')
            {more}
            self.first.wait_for_service(){first}
            self.second.wait_for_service()

        def ask(self):
            future = self.first.call_async(Trigger.Request())
            rclpy.spin_until_future_complete(self, future){asked}
            return future.result()

        def ask_again(self):
            future = self.second.call_async(Trigger.Request())
            rclpy.spin_until_future_complete(self, future)
            return future.result()


    def main():
        rclpy.init()
        asker = Asker()
        print(asker.ask(), asker.ask_again())


    if __name__ == '__main__':
        main()
"""
LOST_ANSWERS = "[rules.TMO003]\nlost-answers = true\n"
SUBSCRIBES = "self.create_subscription(Empty, 'in', print, 10)"


def client(more: str = "pass", first: str = "", asked: str = "") -> str:
    return CLIENT.replace("{more}", more).replace("{first}", first).replace("{asked}", asked)


@pytest.mark.parametrize(
    ("more", "severity"),
    [("pass", Severity.INFO), (SUBSCRIBES, Severity.WARNING), ("other.library(self)", Severity.WARNING)],
)
def test_a_script_that_only_asks_gets_information(judge: Judge, more: str, severity: Severity):
    [wait] = judge(
        "TMO001", client(more, first="  # here").replace("import rclpy", "import other\n    import rclpy", 1)
    )
    assert wait.severity is severity
    asks = client(more, asked="" if severity is Severity.INFO else "  # here")  # it waits for what it has found
    asks = asks.replace("import rclpy", "import other\n    import rclpy", 1)
    spins = judge("TMO003", asks, config=LOST_ANSWERS)
    assert [spin.severity for spin in spins] == [Severity.WARNING] * (severity is Severity.WARNING)


def test_a_program_that_a_launch_file_starts_has_nobody_who_watches_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)
    asks = dedent(client())
    for launch, told in (("", []), ('<node pkg="robot" exec="talker"/>', [Severity.WARNING])):
        write_robot(tmp_path, launch, **{"robot/talker.py": asks})
        (tmp_path / "archlint.toml").write_text(f'select = ["TMO003"]\n{LOST_ANSWERS}', encoding="utf-8")
        report = check(Request((".",), load(tmp_path), cached=False, jobs=1))
        assert [finding.severity for finding in report.findings] == told


def test_the_waits_of_a_class_are_one_finding(judge: Judge):
    [wait] = judge("TMO001", client(SUBSCRIBES, first="  # here"))
    assert wait.message.endswith("; another wait in Asker.__init__() does the same")
    assert [related.place.line for related in wait.related if "here, too" in related.message] == [14]
    [spin] = judge("TMO003", client(SUBSCRIBES, asked="  # here"), config=LOST_ANSWERS)
    assert spin.message.endswith("; another line in this file does the same")


def test_the_calls_of_a_function_are_one_finding(judge: Judge):
    text = """
        import rclpy
        from rclpy.callback_groups import ReentrantCallbackGroup
        from rclpy.executors import MultiThreadedExecutor
        from rclpy.node import Node
        from std_srvs.srv import Trigger


        class Planner(Node):
            def __init__(self):
                super().__init__('planner')
                apart = ReentrantCallbackGroup()
                self.path = self.create_client(Trigger, 'path', callback_group=apart)
                self.threat = self.create_client(Trigger, 'threat', callback_group=apart)
                self.create_timer(5.0, self.plan)

            def plan(self):
                self.get_logger().info(str(self.path.call(Trigger.Request())))  # here
                self.get_logger().info(str(self.threat.call(Trigger.Request())))


        def main():
            rclpy.init()
            executor = MultiThreadedExecutor()
            executor.add_node(Planner())
            executor.spin()


        if __name__ == '__main__':
            main()
    """
    [calls] = judge("TMO002", text)
    assert calls.message.endswith("; another call in Planner.plan() does the same")
    assert [related.place.line for related in calls.related if "here, too" in related.message] == [18]


def test_where_callers_leave_out_the_limit_the_help_is_about_them(judge: Judge):
    text = """
        import rclpy
        from rclpy.node import Node
        from std_srvs.srv import Trigger


        class Compatible(Node):
            def new_client(self, name, timeout_sec=None):
                client = self.create_client(Trigger, name)
                if not client.wait_for_service(timeout_sec=timeout_sec):  # here
                    raise TimeoutError(name)
                return client


        def main():
            rclpy.init()
            node = Compatible('bridge')
            node.create_timer(1.0, lambda: None)
            node.new_client('first'{limit})
            rclpy.spin(node)


        if __name__ == '__main__':
            main()
    """
    [wait] = judge("TMO001", text.replace("{limit}", ""))
    assert wait.help.startswith("pass new_client() a timeout where it is called")
    judge("TMO001", text.replace("{limit}", ", timeout_sec=5.0").replace("  # here", ""))


def test_a_loop_for_a_client_that_the_callback_has_just_made(judge: Judge):
    text = """
        import rclpy
        from rclpy.node import Node
        from std_srvs.srv import Trigger


        class Battery(Node):
            def __init__(self):
                super().__init__('battery')
                self.led = self.create_client(Trigger, 'led')
                self.create_timer(1.0, self.tick)

            def tick(self):
                {client}
                while not client.wait_for_service(1.0):  # here
                    self.get_logger().warning('no led yet')
                client.call_async(Trigger.Request())


        def main():
            rclpy.init()
            rclpy.spin(Battery())


        if __name__ == '__main__':
            main()
    """
    [loop] = judge("TMO004", text.replace("{client}", "client = self.create_client(Trigger, 'set_led')"))
    assert loop.help.startswith("create the client in the constructor")
    [loop] = judge("TMO004", text.replace("{client}", "client = self.led"))
    assert loop.help.startswith("check without waiting")


def test_a_service_with_one_name_for_each_object_has_none_in_the_message(judge: Judge):
    text = """
        import rclpy
        from rclpy.node import Node
        from std_srvs.srv import Trigger


        class Arm:
            def __init__(self, node, name):
                client = node.create_client(Trigger, f'{name}/info')
                rclpy.spin_until_future_complete(node, client.call_async(Trigger.Request()))  # here


        def main():
            rclpy.init()
            node = Node('arms')
            Arm(node, 'left')
            {more}


        if __name__ == '__main__':
            main()
    """
    [one_arm] = judge("TMO003", text.replace("{more}", "pass"))
    assert "the service 'left/info'" in one_arm.message
    [two_arms] = judge("TMO003", text.replace("{more}", "Arm(node, 'right')"))
    assert "the response from a service arrives" in two_arms.message


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        ("node, future", True),
        ("node, future, None", True),
        ("node, future, executor", True),
        ("node, future, executor=given.executor", True),
        ("node, future, given.limit", False),
        ("node, future, given.other", False),
        ("node, future, 10.0", False),
    ],
)
def test_what_may_be_a_limit_in_the_place_of_the_executor(judge: Judge, arguments: str, told: bool):
    text = f"""
        import argparse

        import rclpy
        from rclpy.executors import SingleThreadedExecutor
        from rclpy.node import Node
        from std_srvs.srv import Trigger


        def main():
            rclpy.init()
            parser = argparse.ArgumentParser()
            parser.add_argument('--limit', type=float, default=10.0)
            parser.add_argument('--other')
            given = parser.parse_args()
            node = Node('spawner')
            executor = SingleThreadedExecutor()
            future = node.create_client(Trigger, 'spawn').call_async(Trigger.Request())
            rclpy.spin_until_future_complete({arguments}){"  # here" if told else ""}


        if __name__ == '__main__':
            main()
    """
    judge("TMO003", text)
    refused = arguments in ("node, future, 10.0", "node, future, given.limit")
    text = text.replace("  # here", "")
    findings = judge("API001", text.replace(f"({arguments})", f"({arguments})  # here") if refused else text)
    assert [finding.help.partition(",")[0] for finding in findings] == ["give the timeout by name"] * refused


CORE = """
    import rclpy
    from rclpy.node import Node
    from std_srvs.srv import Trigger


    class Core{base}:
        def __init__(self, name):
            {init}
            self.node = Node('robot')
            self.info = self.node.create_client(Trigger, 'info')

        {method}


    class Turret:
        def __init__(self, core: Core):
            self.core = core
            future = core.info.call_async(Trigger.Request())
            rclpy.spin_until_future_complete(self.core, future){mark}
            rclpy.spin_once(self.core)


    def main():
        rclpy.init()
        Turret(Core('left'))


    if __name__ == '__main__':
        main()
"""
DELEGATES = "def __getattr__(self, name): return getattr(self.node, name)"


@pytest.mark.parametrize(
    ("base", "init", "method", "refused"),
    [
        ("", "pass", "", True),
        ("", "pass", DELEGATES, False),
        ("(Node)", "super().__init__(name)", "", False),
        ("(Unknown)", "super().__init__(name)", "", False),
    ],
)
def test_what_is_spun_is_no_node(judge: Judge, base: str, init: str, method: str, refused: bool):
    text = CORE.replace("{base}", base).replace("{init}", init).replace("{method}", method)
    text = text.replace("import rclpy", "import rclpy\n    from elsewhere import Unknown", 1)
    judge("TMO003", text.replace("{mark}", "" if refused else "  # here"))
    findings = judge("API001", text.replace("{mark}", "  # here" if refused else ""))
    assert [finding.message for finding in findings] == (
        [
            "spin_until_future_complete() fails: 'node' takes a node, not an object of class Core; "
            "another call in this file fails in the same way"
        ]
        if refused
        else []
    )


IMPORTS_OF_WAITS = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Trigger

"""


def test_a_client_that_a_helper_makes_behind_an_early_end(judge: Judge):
    text = (
        IMPORTS_OF_WAITS
        + """
class Algorithm(Node):
    def __init__(self):
        super().__init__('algorithm')
        self.goal = None
        self.create_subscription(String, 'goal', self.on_goal, 10)
        self.create_subscription(String, 'fix', self.on_fix, 10)

    def on_goal(self, message):
        self.goal = message.data

    def on_fix(self, message):
        if self.goal is not None:
            self.ask()
            self.goal = None

    def ask(self):
        self.client = self.create_client(Trigger, 'next')
        while not self.client.wait_for_service(timeout_sec=1.0):  # here
            self.get_logger().info('waiting')
"""
    )
    [loop] = judge("TMO004", text)
    assert loop.help.startswith("create the client in the constructor")


def test_a_loop_over_clients_waits_for_several(judge: Judge):
    text = (
        IMPORTS_OF_WAITS
        + """
class Planner(Node):
    def __init__(self):
        super().__init__('planner')
        self.inverse = self.create_client(Trigger, 'inverse')
        self.forward = self.create_client(Trigger, 'forward')
        self.create_subscription(String, 'goal', print, 10)
        for client in (self.inverse, self.forward):
            client.wait_for_service()  # here
"""
    )
    [wait] = judge("TMO001", text)
    assert wait.message.startswith("wait_for_service() waits for service after service without a timeout")


def test_a_callback_that_spins_needs_no_more_threads(judge: Judge):
    text = (
        IMPORTS_OF_WAITS
        + """
class Adapter(Node):
    def __init__(self):
        super().__init__('adapter')
        self.client = self.create_client(Trigger, 'forward')
        self.create_subscription(String, 'move', self.on_move, 10)
        self.create_timer(0.1, self.tick)

    def tick(self):
        self.get_logger().info("on")

    def on_move(self, message):
        if self.client.wait_for_service(timeout_sec=5.0):
            {spin}
"""
    )
    spin = "rclpy.spin_once(self, timeout_sec=0.1)"
    assert judge("EXE003", text.replace("{spin}", spin)) == []
    judge("EXE003", text.replace("{spin}", "pass").replace("5.0):", "5.0):  # here"))


OWN_TASK = """
    import rclpy
    from rclpy.executors import SingleThreadedExecutor
    from rclpy.node import Node


    class Analyst(Node):
        def __init__(self):
            super().__init__('analyst')

        {kind} analyse(self):
            {work}


    def main():
        rclpy.init()
        analyst = Analyst()
        executor = SingleThreadedExecutor()
        executor.add_node(analyst)
        task = executor.create_task(analyst.analyse)
        executor.spin_until_future_complete(task)


    if __name__ == '__main__':
        main()
"""


@pytest.mark.parametrize(
    ("kind", "work", "told"),
    [("def", "return sum(range(10))", False), ("async def", "await self.answer", True)],
)
def test_a_limit_does_not_end_a_function_that_the_spin_itself_calls(judge: Judge, kind: str, work: str, told: bool):
    """The executor asks for the time only after its task has returned, or has begun to wait."""
    text = OWN_TASK.replace("{kind}", kind).replace("{work}", work)
    judge("TMO003", text.replace("complete(task)", "complete(task)  # here") if told else text)


def test_a_file_that_no_program_uses_waits_for_whoever_starts_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """In a lesson it is information, elsewhere nothing."""
    monkeypatch.chdir(tmp_path)
    asks = dedent(client(SUBSCRIBES))
    others = "".join(
        f"class Idle{n}(Node):\n    def __init__(self):\n        super().__init__('i{n}')\n\n\n" for n in range(5)
    )
    for talker, told in (("def main():\n    pass\n", 1), ("from rclpy.node import Node\n\n\n" + others, 0)):
        write_robot(tmp_path, **{"robot/talker.py": talker, "robot/asks.py": asks})
        (tmp_path / "archlint.toml").write_text('select = ["TMO001"]\nunused-files = true', encoding="utf-8")
        report = check(Request((".",), load(tmp_path), cached=False, jobs=1))
        assert [finding.severity for finding in report.findings] == [Severity.INFO] * told
