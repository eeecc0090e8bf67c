"""TMO002, TMO003 and SRV003: waits without a limit for a server that has been found are told on demand."""

from __future__ import annotations

from pathlib import Path
from textwrap import dedent

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from checks.judging import Judge
from robot_package import write_files

OTHERS = "import rclpy\nfrom rclpy.node import Node\n" + "".join(
    f"\n\nclass Idle{number}(Node):\n    def __init__(self):\n        super().__init__('idle{number}')\n"
    for number in range(5)
)
"""What makes a workspace too large for a lesson."""

ASKER = """
    import rclpy
    from rclpy.node import Node
    from std_srvs.srv import Trigger


    class Asker(Node):
        def __init__(self):
            super().__init__('asker')
            self.server = {server}
            self.client = self.create_client(Trigger, 'map')
            self.create_subscription(Trigger.Request, 'go', print, 10)

        def serve(self, request, response):
            return response

        def ask(self):
            {looks}
            future = self.client.call_async(Trigger.Request())
            rclpy.spin_until_future_complete(self, future){here}
            {after}


    def main():
        rclpy.init()
        asker = Asker()
        asker.ask()
        rclpy.spin(asker)


    if __name__ == '__main__':
        main()
"""
FOUND = "if not self.client.wait_for_service(timeout_sec=2.0):\n                return None"
READS = "return future.result().success"
ASKS = "if future.result() is None:\n                return False"


def asker(looks: str, after: str, here: str = "", server: str = "None") -> str:
    values = {"looks": looks, "after": after, "here": here, "server": server}
    return ASKER.replace("Trigger.Request, 'go'", "Trigger.Request.Event, 'go'").format(**values)


@pytest.mark.parametrize(
    ("looks", "after", "here"),
    [
        (FOUND, READS, ""),
        ("pass", READS, "  # here"),
        (FOUND, ASKS, "  # here"),
        (FOUND, "answer = future.result()\n            if not answer:\n                return False", "  # here"),
        (FOUND, "if not future.done():\n                return False", "  # here"),
        (FOUND, "answer = future.result()\n            if not answer.success:\n                return False", ""),
        ("if self.ready:\n                self.client.wait_for_service(timeout_sec=2.0)", READS, "  # here"),
    ],
    ids=["found", "not looked for", "None", "nothing", "not done", "no success", "looked for now and then"],
)
def test_the_answer_of_a_server_that_has_been_found(judge: Judge, looks: str, after: str, here: str):
    """It seldom gets lost; whoever has a branch for that branch wants a limit."""
    judge("TMO003", asker(looks, after, here), OTHERS)
    judge("TMO003", asker(looks, after, "  # here"), OTHERS, config="[rules.spin-without-timeout]\nlost-answers = true")


def test_in_a_lesson_a_server_is_found_where_something_looks_at_it(judge: Judge):
    """Whoever learns waits for two seconds, and then asks whoever is there."""
    judge("TMO003", asker(FOUND, READS))
    judge("TMO003", asker("self.client.wait_for_service(timeout_sec=2.0)", READS, "  # here"))
    judge("TMO003", asker("self.client.wait_for_service(timeout_sec=2.0)", READS), OTHERS)


LOOPS = "while not client.wait_for_service(timeout_sec=1.0):\n            print('waiting')"
SPAWNER = """
    import rclpy
    from std_srvs.srv import Trigger


    def main():
        rclpy.init()
        node = rclpy.create_node('spawner')
        {more}
        client = node.create_client(Trigger, 'spawn')
        {looks}
        if True:
            future = client.call_async(Trigger.Request())
            rclpy.spin_until_future_complete(node, future){here}
            if future.result() is None:
                print('failed')


    if __name__ == '__main__':
        main()
"""


@pytest.mark.parametrize(
    ("more", "looks", "here"),
    [
        ("pass", LOOPS, ""),
        ("node.create_timer(1.0, print)", LOOPS, ""),
        ("node.create_timer(1.0, print)", "if not client.wait_for_service(2.0):\n            return", "  # here"),
        ("pass", "if not client.wait_for_service(2.0):\n            return", ""),
    ],
    ids=["it only asks", "it waits until the server comes", "it may find nobody", "only clients, in a loop"],
)
def test_a_program_that_asks_as_the_tutorial_does(judge: Judge, more: str, looks: str, here: str):
    """Its branch for no answer is the tutorial's, and whoever starts it has nothing else of it."""
    text = SPAWNER.replace("{more}", more).replace("{looks}", looks)
    judge("TMO003", text.replace("{here}", here), OTHERS)
    judge("TMO003", text.replace("{here}", here))
    again = text.replace("{here}", "  # here" if "timer" in more else "").replace(
        "    if True:", "    for _ in range(3):"
    )
    judge("TMO003", again, OTHERS)


def test_a_node_that_serves_itself(judge: Judge):
    judge("TMO003", asker("pass", READS, server="self.create_service(Trigger, 'map', self.serve)"), OTHERS)
    judge("TMO003", asker("pass", READS, "  # here", "self.create_service(Trigger, 'other', self.serve)"), OTHERS)


@pytest.mark.parametrize(
    ("folder", "told"),
    [("robot", True), ("robot/examples", False), ("arm_tutorial/arm_tutorial", False), ("exampled", True)],
)
@pytest.mark.parametrize("code", ["TMO001", "TMO002", "TMO003"])
def test_whoever_runs_an_example_looks_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, code: str, folder: str, told: bool
):
    """A callback that waits there keeps others waiting all the same."""
    lines = {
        "TMO001": "self.client.wait_for_service()",
        "TMO002": "self.client.call(Trigger.Request())",
        "TMO003": "rclpy.spin_until_future_complete(self, self.client.call_async(Trigger.Request()))",
    }
    asks = asker("pass", "pass").replace("rclpy.spin_until_future_complete(self, future)", lines[code])
    if code == "TMO002":  # somebody else spins the node
        asks = asks.replace("asker.ask()\n        rclpy.spin(asker)", "threading.Thread(target=asker.ask).start()")
        asks = asks.replace("import rclpy\n", "import threading\n\n    import rclpy\n").replace(
            ".start()", ".start()\n        rclpy.spin(asker)"
        )
    if code == "TMO001":  # what a constructor waits for
        asks = asks.replace("10)\n\n        def serve", f"10)\n            {lines[code]}\n\n        def serve")
    write_files(tmp_path, {f"{folder}/asker.py": dedent(asks), "idle.py": OTHERS})
    monkeypatch.chdir(tmp_path)
    (tmp_path / "archlint.toml").write_text(f'select = ["{code}"]')
    assert bool(check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings) == told


def test_functions_of_a_file_are_one_finding(judge: Judge):
    """As the methods of a class are."""
    function = """

    def {name}(node):
        future = client.call_async(Trigger.Request())
        rclpy.spin_until_future_complete(node, future){here}
        return future.result()
"""
    text = (
        "    import rclpy\n    from std_srvs.srv import Trigger\n\n    rclpy.init()\n"
        "    node = rclpy.create_node('web')\n    node.create_timer(1.0, print)\n"
        "    client = node.create_client(Trigger, 'map')\n"
        + function.format(name="load", here="  # here")
        + function.format(name="save", here="")
        + "\n\n    load(node)\n    save(node)\n"
    )
    [spin] = judge("TMO003", text)
    assert spin.message.endswith("; another line in this file does the same")


HANDLER = """
    import rclpy
    from rclpy.callback_groups import ReentrantCallbackGroup
    from rclpy.executors import MultiThreadedExecutor
    from rclpy.node import Node
    from std_srvs.srv import Trigger


    class Relay(Node):
        def __init__(self):
            super().__init__('relay')
            group = ReentrantCallbackGroup()
            self.client = self.create_client(Trigger, 'fire', callback_group=group)
            self.create_service(Trigger, 'relay', self.relay, callback_group=group)
            {more}

        {handler}


    def main():
        rclpy.init()
        executor = MultiThreadedExecutor()
        executor.add_node(Relay())
        executor.spin()


    if __name__ == '__main__':
        main()
"""
CALLS = """def relay(self, request, response):
            {looks}
            return self.client.call(Trigger.Request()){here}"""
AWAITS = """async def relay(self, request, response):
            {looks}
            return await self.client.call_async(Trigger.Request()){here}"""


def relay(handler: str, looks: str, here: str, more: str = "pass") -> str:
    handler = handler.replace("{looks}", looks).replace("{here}", here)
    return HANDLER.replace("{handler}", handler).replace("{more}", more)


@pytest.mark.parametrize("handler", [CALLS, AWAITS], ids=["a call", "an await"])
def test_a_handler_that_has_looked_for_the_server(judge: Judge, handler: str):
    looks = "self.client.wait_for_service(timeout_sec=2.0)"
    judge("SRV003", relay(handler, looks, ""))
    judge("SRV003", relay(handler, looks, ""), OTHERS)
    judge("SRV003", relay(handler, "pass", "  # here"), OTHERS)
    judge("SRV003", relay(handler, looks, "  # here"), OTHERS, config="[rules.SRV003]\nlost-answers = true")


def test_a_helper_that_looks_for_each_of_several_servers(judge: Judge):
    """It does so in one line, for one client after the other."""
    handler = """def is_there(self, client):
            return client.wait_for_service(timeout_sec=2.0)

        def relay(self, request, response):
            if not all([{looked for}]):
                return response
            self.client.call(Trigger.Request())
            return self.other.call(Trigger.Request()){here}"""
    other = "self.other = self.create_client(Trigger, 'smoke', callback_group=group)"
    both = "self.is_there(self.client), self.is_there(self.other)"
    text = relay(handler.replace("{looked for}", both), "", "", other)
    judge("SRV003", text.replace("self.client.call(", "answer = self.client.call("), OTHERS)
    text = relay(handler.replace("{looked for}", "self.is_there(self.client)"), "", "", other)
    text = text.replace("self.client.call(Trigger.Request())", "answer = self.client.call(Trigger.Request())  # here")
    judge("SRV003", text, OTHERS)


def test_a_handler_that_keeps_others_waiting(judge: Judge):
    text = relay(CALLS, "self.client.wait_for_service(timeout_sec=2.0)", "  # here", "self.create_timer(1.0, print)")
    alone = text.replace("'relay', self.relay, callback_group=group", "'relay', self.relay")
    judge("SRV003", alone, OTHERS)


SPINS_IN_TURN = """
    import rclpy
    from rclpy.node import Node
    from std_srvs.srv import Trigger


    class Robot(Node):
        def __init__(self):
            super().__init__('robot')
            self.all = [self.create_client(Trigger, name) for name in ('a', 'b', 'c')]
            self.create_timer(1.0, self.tick)

        def tick(self):
            first = self.all[0].call_async(Trigger.Request())
            rclpy.spin_until_future_complete(self, first){spin}
            second = self.all[1].call_async(Trigger.Request())
            rclpy.spin_until_future_complete(self, second)
            third = self.all[2].call_async(Trigger.Request())
            rclpy.spin_until_future_complete(self, third)


    def main():
        rclpy.init()
        rclpy.spin(Robot())


    if __name__ == '__main__':
        main()
"""


def test_spins_that_cannot_be_there_are_not_too_many(judge: Judge):
    """EXE001 says what to do, and then they add up no longer."""
    judge("EXE001", SPINS_IN_TURN.replace("{spin}", "  # here"))
    judge("SRV005", SPINS_IN_TURN.replace("{spin}", ""))


CALLER = """
    from threading import Thread

    import rclpy
    from rclpy.node import Node
    from std_srvs.srv import Trigger


    class Caller(Node):
        def __init__(self):
            super().__init__('caller')
            self.client = self.create_client(Trigger, 'map')
            {looks}
            {more}

        def ask(self):
            return self.client.call(Trigger.Request()){here}


    def main():
        rclpy.init()
        caller = Caller()
        Thread(target=rclpy.spin, args=(caller,), daemon=True).start()
        {loop}print(caller.ask().message)
        rclpy.shutdown()


    if __name__ == '__main__':
        main()
"""
LOOKS = "while not self.client.wait_for_service(timeout_sec=1.0):\n                self.get_logger().info('waiting')"


@pytest.mark.parametrize(
    ("looks", "more", "loop", "told"),
    [
        (LOOKS, "pass", "", False),
        ("pass", "pass", "", True),
        (LOOKS, "self.create_subscription(Trigger.Request.Event, 'go', print, 10)", "", True),
        (LOOKS, "pass", "while rclpy.ok(): ", True),
    ],
    ids=["asks once", "not looked for", "has something else to do", "asks again and again"],
)
def test_a_program_that_is_there_to_ask_once(judge: Judge, looks: str, more: str, loop: str, told: bool):
    """The tutorial's client: whoever runs it sees that it waits."""
    text = CALLER.replace("{looks}", looks).replace("{more}", more).replace("{loop}", loop)
    marked = text.replace("{here}", "  # here")
    judge("TMO002", marked)
    judge("TMO002", marked if told else text.replace("{here}", ""), OTHERS)
    judge("TMO002", marked, OTHERS, config="[rules.call-without-timeout]\nlost-answers = true")


HELPER = """
    import rclpy
    from rclpy.node import Node
    from std_srvs.srv import Trigger


    class Asking:
        def __init__(self, node, name):
            self.node = node
            self.client = node.create_client(Trigger, name)
            {looks}

        def ask(self):
            future = self.client.call_async(Trigger.Request())
            rclpy.spin_until_future_complete(self.node, future){here}
            return future.result()

        def send(self):
            self.client.call_async(Trigger.Request())


    class Winch(Node):
        def __init__(self):
            super().__init__('winch')
            self.brake = Asking(self, 'brake')
            self.motor = Asking(self, 'motor')
            self.brake.ask()
            self.create_timer(1.0, self.wind)

        def wind(self):
            self.motor.send()


    def main():
        rclpy.init()
        rclpy.spin(Winch())


    if __name__ == '__main__':
        main()
"""


@pytest.mark.parametrize(("looks", "here"), [(LOOKS.replace("self.get", "node.get"), ""), ("pass", "  # here")])
def test_a_helper_whose_constructor_waits_for_the_server(judge: Judge, looks: str, here: str):
    """Its method is judged by the call that is seen, not by the other objects of the helper's class."""
    text = HELPER.replace("{looks}", looks).replace("{here}", here)
    judge("TMO003", text, OTHERS, config="[rules.spin-without-timeout]\nlost-answers = true")
