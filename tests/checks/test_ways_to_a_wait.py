"""However a callback gets to a wait, the rule sees it."""

from __future__ import annotations

import pytest

from checks.callbacks import ON_ONE_THREAD, Run, codes, source
from checks.judging import Judge

CLIENT = "self.client = self.create_client(Trigger, 'check')\n"
CALL = "self.client.call(Trigger.Request(), timeout_sec=1.0)"

WAYS = {
    "a lambda": ("self.create_timer(5.0, lambda: self.ask())", f"def ask(self):\n    {CALL}"),
    "a partial": ("self.create_timer(5.0, partial(self.ask, 1))", f"def ask(self, one):\n    {CALL}"),
    "a function inside": (
        "self.create_timer(5.0, self.tick)",
        f"def tick(self):\n    def ask():\n        {CALL}\n    ask()",
    ),
    "two helpers": (
        "self.create_timer(5.0, self.tick)",
        f"def tick(self):\n    self.one()\n\ndef one(self):\n    self.two()\n\ndef two(self):\n    {CALL}",
    ),
    "a helper that is handed the client": (
        "self.create_timer(5.0, self.tick)",
        "def tick(self):\n    self.ask(self.client)\n\n"
        "@staticmethod\ndef ask(client):\n    client.call(Trigger.Request(), timeout_sec=1.0)",
    ),
    "a dict of methods": (
        "self.ways = {'ask': self.ask}\nself.create_timer(5.0, self.tick)",
        f"def tick(self):\n    self.ways['ask']()\n\ndef ask(self):\n    {CALL}",
    ),
    "a subscription": (
        "self.create_subscription(Empty, 'go', self.on_go, 10)",
        f"def on_go(self, message):\n    {CALL}",
    ),
    "a parameter callback": (
        "self.add_on_set_parameters_callback(self.on_set)",
        f"def on_set(self, parameters):\n    {CALL}\n    return self.result",
    ),
    "a property": (
        "self.create_timer(5.0, self.tick)",
        f"def tick(self):\n    print(self.answer)\n\n@property\ndef answer(self):\n    return {CALL}",
    ),
}


@pytest.mark.parametrize(("setup", "methods"), WAYS.values(), ids=WAYS)
def test_a_way_to_a_wait(run: Run, setup: str, methods: str):
    assert codes(run(source(CLIENT + setup, methods, ON_ONE_THREAD))) == ["EXE002"]


def test_a_helper_object_in_another_file(judge: Judge):
    robot = """
    import rclpy
    from rclpy.node import Node
    from node1 import Battery


    class Robot(Node):
        def __init__(self):
            super().__init__('robot')
            self.battery = Battery(self)
            self.create_timer(5.0, self.tick)

        def tick(self):
            self.get_logger().info(self.battery.level())


    def main():
        rclpy.init()
        rclpy.spin(Robot())


    if __name__ == '__main__':
        main()
    """
    battery = """
    from std_srvs.srv import Trigger


    class Battery:
        def __init__(self, node):
            self.client = node.create_client(Trigger, 'level')

        def level(self):
            return self.client.call(Trigger.Request(), timeout_sec=1.0).message  # here
    """
    [found] = judge("EXE002", robot, battery)
    places = [(related.place.file, related.message) for related in found.related]
    assert ("node.py", "Robot.tick calls Battery.level here") in places
    assert ("node1.py", "the client is created here") in places


def test_several_nodes_on_one_executor_share_its_thread(run: Run):
    main = """
    def main():
        rclpy.init()
        executor = SingleThreadedExecutor()
        other = rclpy.create_node('other')
        robot = Robot()
        robot.client = other.create_client(Trigger, 'check')
        executor.add_node(robot)
        executor.add_node(other)
        executor.spin()


    if __name__ == '__main__':
        main()
    """
    setup, method = "self.create_timer(5.0, self.tick)", f"def tick(self):\n    {CALL}\n"
    assert codes(run(source(setup, method, main))) == ["EXE002"]
    threaded = main.replace("executor.add_node(other)", "threading.Thread(target=rclpy.spin, args=(other,)).start()")
    assert codes(run(source(setup, method, threaded))) == []


@pytest.mark.parametrize(
    ("given", "expected"),
    [("list(future.result().message)", []), ("load(future)", ["EXE001"])],
)
def test_what_a_property_asks_for_once_is_there_when_callbacks_run(run: Run, given: str, expected: list[str]):
    setup = CLIENT + "self.kept = None\nself.create_timer(5.0, self.tick)\nprint(self.names)"
    methods = f"""
@property
def names(self):
    if self.kept is None:
        self.kept = self.ask()
    return self.kept

def ask(self):
    future = self.client.call_async(Trigger.Request())
    rclpy.spin_until_future_complete(self, future, timeout_sec=1.0)
    return {given}

def tick(self):
    print(self.names)
"""
    assert [code for code in codes(run(source(setup, methods, ON_ONE_THREAD))) if code == "EXE001"] == expected


@pytest.mark.parametrize(("given", "expected"), [("message.data", []), ("load(message)", ["TMO001"])])
def test_a_field_of_a_message_is_never_none(run: Run, given: str, expected: list[str]):
    setup = "self.create_service(SetBool, 'switch', self.on_switch)"
    methods = f"""
def on_switch(self, message, response):
    self.load({given})
    return response

def load(self, key):
    if key is None:
        self.create_client(Trigger, 'mask').wait_for_service()
"""
    assert [code for code in codes(run(source(setup, methods, ON_ONE_THREAD))) if code == "TMO001"] == expected


class TestACoroutineThatIsHandedToAnEventLoop:
    """``asyncio.create_task(self.ask())`` makes a coroutine and returns: the callback waits for nothing."""

    SETUP = CLIENT + "self.create_timer(5.0, self.tick)"
    ASK = (
        "async def ask(self):\n"
        "    future = self.client.call_async(Trigger.Request())\n"
        "    while not future.done():\n        await asyncio.sleep(0.1)\n"
    )

    @pytest.mark.parametrize(
        "start",
        [
            "asyncio.create_task(self.ask())",
            "asyncio.ensure_future(self.ask())",
            "asyncio.run_coroutine_threadsafe(self.ask(), self.loop)",
            "self.loop.create_task(self.ask(), name='ask')",
        ],
    )
    def test_the_callback_goes_on(self, run: Run, start: str):
        setup = self.SETUP + "\nself.loop = asyncio.new_event_loop()"

        found = codes(run(source(setup, f"def tick(self):\n    {start}\n\n{self.ASK}", ON_ONE_THREAD)))

        assert [code for code in found if code != "EXE010"] == []

    @pytest.mark.parametrize(
        ("body", "expected"),
        [
            pytest.param("await future", [], id="it awaits"),
            pytest.param("time.sleep(3.0)", ["EXE003"], id="it holds up the thread"),
        ],
    )
    def test_a_task_of_the_executor_is_in_no_callback_group(self, run: Run, body: str, expected: list[str]):
        ask = f"async def ask(self):\n    future = self.client.call_async(Trigger.Request())\n    {body}\n"
        tick = f"def tick(self):\n    self.executor.create_task(self.ask())\n\n{ask}"
        found = run(source(self.SETUP, tick, ON_ONE_THREAD))

        assert codes(found) == expected
        assert all("task of the executor" in finding.message for finding in found)

    def test_a_callback_that_runs_it_to_its_end(self, run: Run):
        tick = f"def tick(self):\n    asyncio.run(self.ask())\n\n{self.ASK}"

        assert codes(run(source(self.SETUP, tick, ON_ONE_THREAD))) == ["EXE002"]

    def test_what_it_is_given_is_still_asked_for_in_the_callback(self, run: Run):
        note = "async def note(self, answer):\n    pass\n"
        tick = f"def tick(self):\n    asyncio.create_task(self.note({CALL}))\n\n{note}"

        assert codes(run(source(self.SETUP, tick, ON_ONE_THREAD))) == ["EXE010", "EXE002"]
