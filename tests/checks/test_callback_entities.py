"""EXE005, EXE006, EXE008, CBG002, SRV004, SRV005 and SRV006."""

from __future__ import annotations

import re
import textwrap
from pathlib import Path

import pytest

from archlint.finding import Severity
from checks.callbacks import IMPORTS, ON_ONE_THREAD, ON_SEVERAL_THREADS, Run, codes, source

TIMER = "self.create_timer(5.0, self.tick)\n"


class TestEntitiesOfCallbacks:
    @pytest.mark.parametrize(
        "body",
        [
            pytest.param("self.create_publisher(Empty, 'there', 10).publish(Empty())", id="a publisher"),
            pytest.param("self.later = self.create_timer(1.0, self.note)", id="a timer"),
            pytest.param(
                "try:\n        self.create_client(Trigger, 'a')\n    except OSError:\n        pass", id="in try"
            ),
        ],
    )
    def test_what_is_created_each_time(self, run: Run, body: str):
        method = f"def tick(self):\n    {body}\n\ndef note(self):\n    print('later')\n"
        assert "EXE005" in codes(run(source(TIMER, method)))

    def test_what_the_constructor_of_an_object_creates_is_told_where_a_callback_makes_that(self, run: Run):
        tool = (
            "\n\nclass Tool:\n    def __init__(self, node):\n"
            "        self.client = node.create_client(Trigger, 'go')\n"
            "        self.sender = node.create_publisher(Empty, 'a', 1)\n"
        )
        text = source(TIMER, "def tick(self):\n    self.use()\n\ndef use(self):\n    Tool(self)\n")
        text = text.replace("\n\nclass ", f"{tool}\n\nclass ", 1)
        [told] = [row for row in run(text) if row.code == "EXE005"]
        lines = text.splitlines()
        assert lines[told.place.line - 1].strip() == "Tool(self)"
        assert "makes a Tool, which creates a client of 'go', each time it runs" in told.message
        assert "the old one is never destroyed" in told.message
        assert (told.help or "").startswith("make the Tool once, in the constructor of ")
        created = [lines[row.place.line - 1] for row in told.related if row.message == "it is created here"]
        assert ["create_client" in line for line in created] == [True]

    def test_a_node_that_a_callback_makes_goes_with_its_last_name(self, run: Run):
        camera = (
            "\n\nclass Camera(Node):\n    def __init__(self):\n        super().__init__('camera')\n"
            "        self.create_subscription(Empty, 'image', print, 1)\n"
        )
        text = source(TIMER, "def tick(self):\n    camera = Camera()\n    print(camera)\n")
        [told] = [row for row in run(text.replace("\n\nclass ", f"{camera}\n\nclass ", 1)) if row.code == "EXE005"]
        assert told.message.endswith(
            "makes a Camera, which creates a subscription to 'image', each time it runs, and nothing destroys the old "
            "node: it lasts until Python's garbage collector finds it"
        )

    @pytest.mark.parametrize(("end", "told"), [("self.destroy_node()", False), ("print('gone')", True)])
    def test_a_node_that_goes_with_its_object_takes_what_it_creates_along(self, run: Run, end: str, told: bool):
        tool = (
            "\n\nclass Tool(Node):\n    def __init__(self):\n        super().__init__('tool')\n"
            "        self.client = self.create_client(Trigger, 'go')\n\n"
            f"    def __del__(self):\n        {end}\n"
        )
        text = source(TIMER, "def tick(self):\n    Tool()\n").replace("\n\nclass ", f"{tool}\n\nclass ", 1)
        assert ("EXE005" in codes(run(text))) is told

    @pytest.mark.parametrize(
        "body",
        [
            pytest.param("if self.later is None:\n        self.later = self.create_timer(1.0, self.note)", id="guard"),
            pytest.param(
                "if self.later:\n        return\n    self.later = self.create_timer(1.0, self.note)", id="early return"
            ),
            pytest.param(
                "client = self.create_client(Trigger, 'a')\n    self.destroy_client(client)", id="taken away again"
            ),
            pytest.param("self.create_publisher(Empty, load_name(), 10)", id="a name that data decides"),
        ],
    )
    def test_what_does_not_pile_up(self, run: Run, body: str):
        method = f"def tick(self):\n    {body}\n\ndef note(self):\n    print('later')\n"
        assert "EXE005" not in codes(run(source("self.later = None\n" + TIMER, method)))

    @pytest.mark.parametrize(
        ("end", "expected"),
        [
            pytest.param("self.destroy_subscription(self.kept)", [], id="this one"),
            pytest.param("self.destroy_subscription(self.other)", ["EXE005"], id="another one"),
            pytest.param("self.destroy_timer(self.kept)", ["EXE005"], id="as if it were a timer"),
            pytest.param("self.kept = None", ["EXE005"], id="only forgotten"),
        ],
    )
    def test_what_the_other_arm_destroys_does_not_pile_up(self, run: Run, end: str, expected: list[str]):
        make = "self.kept = self.create_subscription(Empty, 'there', print, 10)"
        method = (
            f"def on_switch(self, request, response):\n    if request.data:\n        {make}\n"
            f"    else:\n        {end}\n    return response\n"
        )
        head = "self.kept = self.other = None\nself.create_service(SetBool, 'switch', self.on_switch)\n"
        assert codes(run(source(head, method))) == expected

    @pytest.mark.parametrize(
        ("body", "expected"),
        [
            pytest.param("if request.data:\n        {make}", ["EXE005"], id="each time the request says so"),
            pytest.param("wanted = request.data\n    if not wanted:\n        return response\n    {make}", ["EXE005"],
                         id="unless the request says no"),
            pytest.param("if request.data:\n        print()\n    else:\n        {make}", ["EXE005"], id="other arm"),
            pytest.param("try:\n        bool(request.data)\n    except TypeError:\n        return response\n    {make}",
                         ["EXE005"], id="unless the request makes no sense"),
            pytest.param("try:\n        self.later.reset()\n    except AttributeError:\n        {make}", [],
                         id="only where something fails"),
            pytest.param("while self.later is not None:\n        return response\n    {make}", [], id="a loop leaves"),
            pytest.param("if request.data and self.later is None:\n        {make}", [], id="not there yet"),
            pytest.param("if request.data and not there():\n        {make}", [], id="a function may know"),
            pytest.param("if self.later is None:\n        return response\n    if request.data:\n        {make}", [],
                         id="a state and the request"),
            pytest.param("if request.data:\n        {make}\n    else:\n        self.later.cancel()", [],
                         id="taken away when the request says so"),
            pytest.param("if request.data:\n        self.start(request.data)", [], id="a helper"),
        ],
    )  # fmt: skip
    def test_what_a_request_decides_happens_again_and_again(self, run: Run, body: str, expected: list[str]):
        make = "self.later = self.create_timer(1.0, self.note)"
        methods = f"def handle(self, request, response):\n    {body.format(make=make)}\n    return response\n\n"
        methods += "def note(self):\n    print('later')\n\n"
        methods += f"def start(self, now):\n    if now:\n        {make}\n"
        setup = "self.later = None\nself.create_service(SetBool, 'start', self.handle)\n"
        text = source(setup, methods) + "\nfrom somewhere import there\n"
        assert [code for code in codes(run(text)) if code == "EXE005"] == expected

    def test_another_callback_takes_it_away(self, run: Run):
        setup = "self.later = None\n"
        setup += "".join(f"self.create_service(SetBool, '{name}', self.{name})\n" for name in ("stop", "start"))
        methods = """
        def stop(self, request, response):
            self.later.cancel()
            return response

        def start(self, request, response):
            if request.data:
                self.later = self.create_timer(1.0, self.note)
            return response

        def note(self):
            print('later')
        """
        assert codes(run(source(setup, methods))) == []
        assert codes(run(source(setup, methods.replace("self.later.cancel()", "pass")))) == ["EXE005"]

    def test_a_timer_that_runs_once_may_set_things_up(self, run: Run):
        method = """
        def tick(self):
            self.timer.cancel()
            self.publisher = self.create_publisher(Empty, 'there', 10)
        """
        assert codes(run(source("self.timer = self.create_timer(0.1, self.tick)\n", method))) == []

    @pytest.mark.parametrize(
        ("create", "destroy", "end"),
        [
            ("create_publisher(Empty, 'a', 1)", "made.destroy()", "the next spin raises InvalidHandle"),
            ("create_client(Trigger, 'a')", "made.destroy()", "destroy() does not remove the old one from the node"),
            ("create_publisher(Empty, 'a', 1)", "self.destroy_publisher(made)", None),
            ("create_client(Trigger, 'a')", "self.destroy_client(made)", None),
        ],
    )
    def test_destroying_it_without_its_node_leaves_it_there(self, run: Run, create: str, destroy: str, end: str | None):
        found = run(source(TIMER, f"def tick(self):\n    made = self.{create}\n    {destroy}"))
        assert [one.message.endswith(end) for one in found if one.code == "EXE005"] == ([True] if end else [])

    @pytest.mark.parametrize(
        ("subscription", "elsewhere", "expected"),
        [
            ("Empty, 'left/go'", "", []),
            ("Empty, 'left/go'", "self.create_publisher(Empty, '/left/go', 10).publish(Empty())", ["EXE005"]),
            ("Empty, 'left/go'", "self.there = self.create_publisher(Empty, '/left/go', 10)", []),
            ("Empty, 'left/go'", "self.create_publisher(Empty, load_name(), 10).publish(Empty())", ["EXE005"]),
            ("Empty, load_name()", "", ["EXE005"]),
            ("Imu, 'left/go'", "", ["EXE005"]),
            ("Imu, 'left/go'", "self.create_publisher(Imu, 'right/go', 10)", []),
        ],
        ids=[
            "nobody sends it",
            "somebody does",
            "its publisher is never used",
            "perhaps under this name",
            "who knows which",
            "a driver may",
            "sent to another robot",
        ],
    )
    def test_a_callback_for_what_nobody_sends_never_runs(
        self, run: Run, tmp_path: Path, subscription: str, elsewhere: str, expected: list[str]
    ):
        """In a lesson, somebody sends it by hand."""
        (tmp_path / "package.xml").write_text("<package format='3'><name>robot</name></package>")
        setup = f"self.create_subscription({subscription}, self.on_go, 10)\n{elsewhere}"
        text = source(setup, "def on_go(self, message):\n    self.create_publisher(Empty, 'gone', 10)\n")
        text = text.replace(
            "from std_msgs", "from sensor_msgs.msg import Imu\nfrom somewhere import load_name\nfrom std_msgs"
        )
        assert "EXE005" in codes(run(text))
        others = "".join(f"    rclpy.create_node('part_{number}')\n" for number in range(5))
        text = text.replace("    rclpy.spin(", f"{others}    rclpy.spin(")
        assert [code for code in codes(run(text)) if code == "EXE005"] == expected

    @pytest.mark.parametrize(("end", "expected"), [("made.destroy()", 0), ("made.server_is_ready()", 1)])
    def test_an_action_client_takes_itself_off_its_node(self, run: Run, end: str, expected: int):
        tick = f"def tick(self):\n    made = ActionClient(self, Fibonacci, 'a')\n    {end}"
        found = [one.message for one in run(source(TIMER, tick)) if one.code == "EXE005"]
        assert len(found) == expected and all("creates an action client" in message for message in found)


class TestSignatures:
    @pytest.mark.parametrize(
        ("create", "method", "expected"),
        [
            ("self.create_timer(5.0, self.take)", "def take(self):\n    pass", []),
            ("self.create_timer(5.0, self.take)", "def take(self, event):\n    pass", ["EXE006"]),
            ("self.create_timer(5.0, self.take)", "def take(self, event=None):\n    pass", []),
            ("self.create_timer(5.0, partial(self.take, 1))", "def take(self, one):\n    pass", []),
            ("self.create_timer(5.0, lambda: self.take(1))", "def take(self, one):\n    pass", []),
            ("self.create_timer(5.0, self.take)", "def take(self, *args):\n    pass", []),
            ("self.create_timer(5.0, self.take)", "def take():\n    pass", ["EXE006"]),
            ("self.create_timer(5.0, self.taken)", "def take(self):\n    pass", ["EXE006"]),
            ("self.create_timer(5.0, self.on_take)", "def take(self):\n    pass", ["EXE006"]),
            ("self.create_timer(5.0, self._take)", "def take(self):\n    pass", ["EXE006"]),
            ("self.create_timer(5.0, self.__take)", "def _take(self):\n    pass", ["EXE006"]),
            ("self.create_timer(5.0, self.__take)", "def __take(self):\n    pass", []),
            ("self.create_timer(5.0, self._wake_executor)", "def take(self):\n    pass", []),
            ("self.create_subscription(Empty, 'a', self.take, 10)", "def take(self):\n    pass", ["EXE006"]),
            (
                "self.create_subscription(Empty, 'a', partial(self.take, arm=1), 10)",
                "def take(self, message, arm):\n    pass",
                [],
            ),
            ("self.create_service(Trigger, 'a', self.take)", "def take(self, request):\n    return 1 + 1", ["EXE006"]),
            ("ActionServer(self, Fibonacci, 'a', self.take)", "def take(self):\n    raise OSError", ["EXE006"]),
            ("self.create_timer(5.0, self.take)", "def take(self, *, arm):\n    pass", ["EXE006"]),
            ("self.create_timer(5.0, self.take)", "def take(self, *, arm=1):\n    pass", []),
            ("self.create_timer(5.0, partial(self.take, arm=1))", "def take(self, *, arm):\n    pass", []),
        ],
    )
    def test_what_rclpy_can_call(self, run: Run, create: str, method: str, expected: list[str]):
        assert codes(run(source(create, method))) == expected

    @pytest.mark.parametrize(
        ("given", "parameters", "expected"),
        [
            ("self.take", "self", None),
            ("self.take", "self, arm", "is called with no argument, and Robot.take takes 1 argument (arm)"),
            ("self.take, 1", "self, arm", None),
            ("self.take, 1", "self", "is called with 1 argument, and Robot.take takes no argument"),
            ("self.take, 1, 2", "self, arm", "is called with 2 arguments, and Robot.take takes 1 argument (arm)"),
            ("self.take, arm=1", "self, arm", None),
            ("self.take, 1", "self, arm, *, fast", "takes 1 argument (arm) and needs fast=… by name"),
            ("self.take, 1, fast=True", "self, arm, *, fast", None),
            ("partial(self.take, 1)", "self, arm", None),
            ("self.take, *self.arms", "self, arm", None),
            ("self.taken", "self", "a task of the executor is 'taken', but there is no such method"),
        ],
    )
    def test_a_task_gets_what_create_task_is_given(self, run: Run, given: str, parameters: str, expected: str | None):
        tick = f"self.create_timer(5.0, lambda: self.executor.create_task({given}))\n"
        found = run(source(tick, f"def take({parameters}):\n    pass\n"))
        assert [one.code for one in found] == ([] if expected is None else ["EXE006"])
        assert all(expected in one.message for one in found if expected is not None)

    @pytest.mark.parametrize(
        ("callback", "expected"),
        [("take", []), ("taken", ["EXE006"]), ("_taken", ["EXE006"]), ("trigger_cleanup", [])],
    )
    def test_a_lifecycle_node_has_methods_of_its_own(self, run: Run, callback: str, expected: list[str]):
        text = source(f"self.create_timer(5.0, self.{callback})", "def take(self):\n    pass")
        lifecycle = text.replace("import Node\n", "import Node\nfrom rclpy.lifecycle import LifecycleNode\n")
        assert codes(run(lifecycle.replace("class Robot(Node)", "class Robot(LifecycleNode)"))) == expected

    def test_message_info_came_with_jazzy(self, run: Run):
        text = source("self.create_subscription(Empty, 'a', self.take, 10)", "def take(self, message, info):\n    pass")
        assert codes(run(text, distro="jazzy")) == []
        [found] = run(text, distro="humble")
        assert found.severity is Severity.ERROR
        assert codes(run(text)) == []

    def test_timer_info_came_with_kilted(self, run: Run):
        text = source(TIMER, "def tick(self, info: rclpy.timer.TimerInfo):\n    pass")
        assert codes(run(text, distro="kilted")) == []
        assert codes(run(text, distro="jazzy")) == ["EXE006"]

    def test_timer_info_is_not_known_by_a_text(self, run: Run):
        quoted = source(TIMER, "def tick(self, info: 'rclpy.timer.TimerInfo'):\n    pass")
        assert codes(run(quoted, distro="kilted")) == ["EXE006"]
        plain = source(TIMER, "def tick(self, info: rclpy.timer.TimerInfo):\n    pass")
        assert codes(run(f"from __future__ import annotations\n{plain}", distro="kilted")) == ["EXE006"]

    def test_those_of_a_class_that_fail_alike_are_one_finding(self, run: Run):
        setup = "".join(f"self.create_timer(1.0, self.{name})\n" for name in ("first", "second", "third"))
        setup += "self.create_service(Trigger, 'stop', self.stop)\n"
        methods = "".join(f"def {name}(self, event):\n    pass\n\n" for name in ("first", "second", "third"))
        methods += "def stop(self, request):\n    return Trigger.Response()\n"
        timers, service = run(source(setup, methods))
        assert timers.code == service.code == "EXE006"
        assert "Robot.first takes 1 argument (event); so do 2 others of its class" in timers.message
        assert [one.message for one in timers.related[1:]] == [
            "Robot.second is registered here",
            "Robot.third is registered here",
        ]
        assert "Robot.stop takes 1 argument (request)" in service.message and "so do" not in service.message

    def test_methods_that_are_not_there_are_one_finding(self, run: Run):
        setup = "self.create_timer(1.0, self.first)\nself.create_timer(2.0, self.second)\n"
        [found] = run(source(setup, "def third(self):\n    pass\n"))
        assert "is 'first', but there is no such method; nor is there 'second'" in found.message

    def test_a_wrapper_that_hands_over_many(self, run: Run):
        setup = "self.listen('left', self.on_left)\nself.listen('right', self.on_right)\n"
        methods = "def listen(self, topic, callback):\n    self.create_subscription(Empty, topic, callback, 10)\n\n"
        methods += "def on_left(self):\n    pass\n\ndef on_right(self):\n    pass\n"
        [found] = run(source(setup, methods))
        assert found.related[-1].message == "Robot.on_right, which is also registered there, is defined here"

    def test_a_lambda_that_a_wrapper_passes_on(self, run: Run):
        setup = "self.listen('left', lambda message, name, side: 1)\n"
        setup += "self.listen('right', lambda message, name, side: 2)\nself.listen('good', lambda message: 3)\n"
        methods = "def listen(self, topic, callback):\n    self.create_subscription(Empty, topic, callback, 10)\n"
        text = source(setup, methods)
        [found] = run(text)
        lines = text.splitlines()
        assert "lambda message, name, side: 1" in lines[found.place.line - 1]
        assert [lines[one.place.line - 1].strip()[:16] for one in found.related] == [
            "self.create_subs",
            "self.listen('rig",
        ]
        assert found.related[0].message == "it is registered here"


class TestSpinning:
    TICK = "def tick(self):\n    pass\n"

    def main(self, body: str) -> str:
        lines = "\n".join(f"    {line}" for line in ["rclpy.init()", "robot = Robot()", *body.splitlines()])
        return f"\ndef main():\n{lines}\n\n\nif __name__ == '__main__':\n    main()\n"

    @pytest.mark.parametrize(
        "body",
        [
            "rclpy.spin(robot)",
            "while rclpy.ok():\n    rclpy.spin_once(robot)",
            "threading.Thread(target=rclpy.spin, args=(robot,)).start()",
            "executor = SingleThreadedExecutor()\nexecutor.add_node(robot)\nexecutor.spin()",
            "executor = MultiThreadedExecutor()\n"
            "executor.add_node(robot)\n"
            "threading.Thread(target=executor.spin).start()",
            "executor = MultiThreadedExecutor()\nexecutor.add_node(robot)\nrclpy.spin(robot, executor)",
            "executor = load_executor()\nrclpy.spin(robot, executor=executor)",
            "some_framework.run(robot)",
            "from window import clock\nclock.ticked.connect(lambda: rclpy.spin_once(robot, timeout_sec=0.01))",
            "def spin():\n    while rclpy.ok():\n        rclpy.spin_once(robot)\n\n\n"
            "asyncio.get_event_loop().run_in_executor(None, spin)",
            "executor = MultiThreadedExecutor()\nexecutor.add_node(robot)\n"
            "asyncio.run(asyncio.get_event_loop().run_in_executor(None, executor.spin))",
            "executor = SingleThreadedExecutor()\nfrom window import pool\npool.submit(executor.spin)\n"
            "executor.add_node(robot)",
            "from window import widget\n\n\ndef spin():\n    rclpy.spin_once(robot)\n\n\n"
            "def on_event(event):\n    spin()\n\n\nwidget.timer_event = on_event",
            "from window import widget\n\n\ndef spin():\n    rclpy.spin_once(robot)\n\n\n"
            "widget.timer_event = lambda event: spin()",
            "def spin(node):\n    rclpy.spin(node)\n\n\nfrom window import pool\npool.submit(partial(spin, robot))",
        ],
    )
    def test_a_node_that_is_spun_somehow(self, run: Run, body: str):
        assert codes(run(source(TIMER, self.TICK, self.main(body)))) == []

    @pytest.mark.parametrize(
        ("uses", "help_"),
        [
            ("print(self.eye.model)", "do not create a node for this: move 'model' out of the class"),
            (
                "print(self.eye.model(1), self.eye.names)",
                "do not create a node for this: move 'model' and 'names' out of",
            ),
            ("self.eye.model = 1", "rclpy.spin(node)"),
            ("self.eye.look()", "rclpy.spin(node)"),
            ("print(Eye().look)", "do not create a node for this: move 'look' out of the class"),
            ("Eye().look()", "rclpy.spin(node)"),
            ("self.eye.ask(self.eye.model)", "rclpy.spin(node)"),
            ("print(self.eye.get_name())", "rclpy.spin(node)"),
        ],
    )
    def test_a_node_that_is_made_for_an_attribute(self, run: Run, uses: str, help_: str):
        eye = (
            "class Eye(Node):\n    def __init__(self):\n        super().__init__('eye')\n        self.model = load()\n"
            "        self.names = load()\n        self.create_timer(1.0, self.look)\n\n    def look(self):\n"
            "        pass\n\n    def ask(self, model):\n        pass\n\n\n"
        )
        kept = "" if "Eye()" in uses else "self.eye = Eye()\n"
        text = source(f"{kept}{TIMER}", f"def tick(self):\n    {uses}\n")
        rows = run(text.replace("class Robot", eye + "class Robot", 1))
        [found] = [finding for finding in rows if finding.code == "EXE008"]
        assert found.help.startswith(help_)

    def test_a_function_that_hands_itself_out_anew_has_an_end(self, run: Run):
        body = (
            "from window import clock\n\n\n"
            "def plan():\n    def again():\n        plan()\n        rclpy.spin_once(robot)\n    clock.after(1, again)\n"
            "    clock.after(2, lambda: again() or plan())\n\n\n"
            "plan()"
        )

        assert codes(run(source(TIMER, self.TICK, self.main(body)))) == []

    @pytest.mark.parametrize(
        "body",
        [
            "print('there')",
            "executor = MultiThreadedExecutor()\nexecutor.add_node(robot)\nprint('forgotten')",
            "executor = MultiThreadedExecutor()\nexecutor.add_node(robot)\n"
            "asyncio.get_event_loop().run_in_executor(None, executor.shutdown)",
            "from window import widget\n\n\ndef note():\n    print('event')\n\n\n"
            "def on_event(event):\n    note()\n\n\nwidget.timer_event = on_event",
        ],
    )
    def test_a_node_that_is_not(self, run: Run, body: str):
        assert codes(run(source(TIMER, self.TICK, self.main(body)))) == ["EXE008"]

    @pytest.mark.parametrize(
        ("start", "expected"),
        [
            ("rclpy.init()", ["EXE008"]),
            ("rclpy.init(args=None, domain_id=7)", ["EXE008"]),
            ("from rclpy import init\n    init()", ["EXE008"]),
            ("context = rclpy.Context()\n    context.init()", ["EXE008"]),
            ("# rclpy.init()", []),
            ("rclpy.shutdown()", []),
        ],
    )
    def test_without_init_there_is_no_node(self, run: Run, start: str, expected: list[str]):
        text = source(TIMER, self.TICK, self.main("print('there')"))
        assert text.count("rclpy.init()") == 1
        assert codes(run(text.replace("rclpy.init()", start))) == expected

    @pytest.mark.parametrize(
        ("body", "said"),
        [
            ("executor = MultiThreadedExecutor()\nexecutor.spin()", "the timer is created here"),
            (
                "executor = MultiThreadedExecutor()\nexecutor.add_node(robot)\nexecutor.remove_node(robot)\n"
                "executor.spin()",
                "it is removed from its executor here",
            ),
            (
                "spinner = threading.Thread(target=rclpy.spin, args=(robot,))\nspinner.daemon = True\ntime.sleep(5)",
                "this thread would spin it, but is never started",
            ),
            (
                "threading.Thread(target=lambda: rclpy.spin(robot))\ntime.sleep(5)",
                "this thread would spin it, but is never started",
            ),
        ],
        ids=["no node", "removed", "not started", "thrown away"],
    )
    def test_what_would_spin_it_does_not(self, run: Run, body: str, said: str):
        [found] = run(source(TIMER, self.TICK, self.main(body)))
        assert found.code == "EXE008" and found.related[-1].message == said

    @pytest.mark.parametrize(
        "body",
        [
            "executor = MultiThreadedExecutor()\nfill(executor)\nexecutor.spin()",
            "executor = MultiThreadedExecutor()\nrobot.executor = executor\nexecutor.spin()",
            "executor = MultiThreadedExecutor()\nexecutor.add_node(robot)\nexecutor.spin()\n"
            "executor.remove_node(robot)",
            "executor = MultiThreadedExecutor()\nexecutor.add_node(robot)\n"
            "threading.Thread(target=executor.spin).start()\ntime.sleep(5)\nexecutor.remove_node(robot)",
            "executor = MultiThreadedExecutor()\nexecutor.add_node(robot)\nexecutor.remove_node(robot)\n"
            "executor.add_node(robot)\nexecutor.spin()",
            "spinner = threading.Thread(target=rclpy.spin, args=(robot,))\nspinner.start()",
            "spinner = threading.Thread(target=rclpy.spin, args=(robot,))\nfor one in [spinner]:\n    one.start()",
            "spinner = threading.Thread(target=rclpy.spin, args=(robot,))\nbegin = spinner.start\nbegin()",
            "spinner = threading.Thread(target=rclpy.spin, args=(robot,))\n\n"
            "def begin():\n    spinner.start()\n\nbegin()",
        ],
    )
    def test_what_spins_it_after_all(self, run: Run, body: str):
        text = source(TIMER, self.TICK, self.main(body))
        assert codes(run(f"from robot_tools import fill\n{text}")) == []

    def test_all_that_never_runs_is_named(self, run: Run):
        others = "self.create_subscription(Empty, 'ready', self.on_ready, 10)\n" + TIMER * 2
        [found] = run(source(others, self.ON_READY, self.main("print('there')")))
        assert found.message == "nothing spins this node, so the callbacks of its subscription and 2 more never run"
        assert [one.message for one in found.related] == [
            "the subscription is created here",
            "the timer is created here",
            "the timer is created here",
        ]
        [alone] = run(source(TIMER, self.TICK, self.main("print('there')")))
        assert alone.message == "nothing spins this node, so the callback of its timer never runs"

    ASKING = """\
self.client = self.create_client(Trigger, 'calibrate')
self.create_timer(5.0, self.tick)
future = self.client.call_async(Trigger.Request())
rclpy.spin_until_future_complete(self, future, timeout_sec=2.0)
"""

    def test_a_constructor_that_waits_for_an_answer_is_no_spin_to_the_end(self, run: Run):
        [found] = run(source(self.ASKING, self.TICK, self.main("while rclpy.ok():\n    time.sleep(1.0)")))
        assert found.code == "EXE008" and "after its constructor" in found.message
        assert [one.message for one in found.related] == [
            "the timer is created here",
            "the constructor spins only briefly",
        ]
        assert codes(run(source(self.ASKING, self.TICK, ON_ONE_THREAD))) == []

    WAITING = """\
self.name = None
self.create_subscription(Empty, 'ready', self.on_ready, 10)
while self.name is None:
    rclpy.spin_once(self)
"""
    ON_READY = "def on_ready(self, message):\n    self.name = 'ready'\n\n" + TICK

    def test_a_constructor_may_spin_for_what_it_waits_for(self, run: Run):
        assert codes(run(source(self.WAITING, self.ON_READY, self.main("print(robot.name)")))) == []
        later = self.WAITING + "self.create_timer(5.0, self.tick)\n"
        [found] = run(source(later, self.ON_READY, self.main("print(robot.name)")))
        assert found.code == "EXE008" and "so the callback of its timer no longer runs" in found.message

    @pytest.mark.parametrize(
        ("body", "lines"),
        [
            pytest.param("second = Robot()\nrclpy.spin(robot)", ["second = Robot()"], id="one of a class is spun"),
            pytest.param(
                "second = Robot()\nrclpy.spin(robot)\nrclpy.spin(second)", ["second = Robot()"], id="too late"
            ),
            pytest.param(
                "second = Robot()\nrclpy.spin(robot)\ntry:\n    rclpy.spin(second)\nfinally:\n    rclpy.try_shutdown()",
                ["second = Robot()"],
                id="too late, in a try",
            ),
            pytest.param(
                "second = Robot()\nif input():\n    rclpy.spin(robot)\nrclpy.spin(second)",
                [],
                id="perhaps the first one",
            ),
            pytest.param("rclpy.spin(robot)\nrclpy.init()\nrclpy.spin(Robot())", [], id="one life after the other"),
            pytest.param(
                "second = Robot()\ntry:\n    rclpy.spin(robot)\nexcept SystemExit:\n    pass\nrclpy.spin(second)",
                [],
                id="until it raises",
            ),
            pytest.param(
                "second = Robot()\nwhile rclpy.ok():\n    rclpy.spin_once(robot)\n    rclpy.spin_once(second)",
                [],
                id="in turn",
            ),
            pytest.param(
                "executor = SingleThreadedExecutor()\nfor node in (robot, Robot()):\n    executor.add_node(node)\n"
                "executor.spin()",
                [],
                id="both in one executor",
            ),
        ],
    )
    def test_the_second_of_two_nodes(self, run: Run, body: str, lines: list[str]):
        text = source(TIMER, self.TICK, self.main(body))
        found = run(text)
        assert codes(found) == ["EXE008"] * len(lines)
        assert [text.splitlines()[one.place.line - 1].strip() for one in found] == lines

    def test_a_node_that_only_a_callback_spins_is_spun(self, run: Run):
        setup = (
            "self.helper = rclpy.create_node('helper')\n"
            "self.helper.create_subscription(Empty, 'ready', self.on_ready, 10)\n" + TIMER
        )
        method = "def on_ready(self, message):\n    pass\n\n"
        method += "def tick(self):\n    rclpy.spin_once(self.helper, timeout_sec=0.05)\n"
        assert codes(run(source(setup, method, ON_SEVERAL_THREADS))) == []
        assert codes(run(source(setup, method.replace("rclpy.spin_once", "print"), ON_SEVERAL_THREADS))) == ["EXE008"]

    def test_a_class_that_nothing_makes_is_not_judged(self, run: Run):
        assert codes(run(source(TIMER, self.TICK, ""))) == []

    def test_groups_need_threads(self, run: Run):
        setup = "group = ReentrantCallbackGroup()\nself.create_timer(5.0, self.tick, callback_group=group)"
        assert codes(run(source(setup, self.TICK, ON_ONE_THREAD))) == ["CBG002"]
        assert codes(run(source(setup, self.TICK, ON_SEVERAL_THREADS))) == []

    def test_a_client_that_is_never_asked_runs_no_callback(self, run: Run):
        setup = (
            "self.create_timer(5.0, self.tick)\n"
            "self.client = self.create_client(Trigger, 'a', callback_group=ReentrantCallbackGroup())"
        )
        assert codes(run(source(setup, self.TICK, ON_ONE_THREAD))) == []
        asks = "def tick(self):\n    self.client.call_async(Trigger.Request())\n"
        assert codes(run(source(setup, asks, ON_ONE_THREAD))) == ["CBG002"]

    @pytest.mark.parametrize(
        ("other", "told"),
        [
            ("self.client = self.create_client(Trigger, 'a')", 0),
            ("self.client.call_async(Trigger.Request())", 1),
        ],
    )
    @pytest.mark.parametrize("rest", ["", "def broken(self log_level=0): pass\n"])
    def test_a_client_of_another_file_with_that_name(self, run: Run, tmp_path: Path, other: str, told: int, rest: str):
        """Be it a file that Python cannot read."""
        setup = (
            "self.create_timer(5.0, self.tick)\n"
            "self.client = self.create_client(Trigger, 'a', callback_group=ReentrantCallbackGroup())"
        )
        text = f"from rclpy.node import Node\n\n\nclass Other(Node):\n    def make(self):\n        {other}\n\n\n{rest}"
        (tmp_path / "other.py").write_text(text, encoding="utf-8")
        assert codes(run(source(setup, self.TICK, ON_ONE_THREAD))).count("CBG002") == told

    def test_a_coroutine_that_awaits_keeps_its_group(self, run: Run):
        setup = "group = ReentrantCallbackGroup()\nself.create_timer(5.0, self.tick, callback_group=group)"
        waiting = "async def tick(self):\n    await self.job.completion\n"
        assert codes(run(source(setup, waiting, ON_ONE_THREAD))) == []
        assert codes(run(source(setup, "async def tick(self):\n    pass\n", ON_ONE_THREAD))) == ["CBG002"]

    def test_several_groups_of_one_node_are_one_finding(self, run: Run):
        setup = (
            "self.create_timer(5.0, self.tick, callback_group=ReentrantCallbackGroup())\n"
            "self.create_timer(6.0, self.tick, callback_group=MutuallyExclusiveCallbackGroup())"
        )

        [finding] = run(source(setup, self.TICK, ON_ONE_THREAD))

        assert finding.message.startswith("2 callback groups in a node that a single thread spins")
        assert finding.related[0].message == "a mutually exclusive group is created here"
        assert finding.related[0].place.line == finding.place.line + 1

    ONE_GROUP = """
    group = ReentrantCallbackGroup()
    self.client = self.create_client(Trigger, 'a', callback_group=group)
    self.create_timer(5.0, self.tick, callback_group=group)
    """
    SPINS = """
    def tick(self):
        future = self.client.call_async(Trigger.Request())
        rclpy.spin_until_future_complete(self, future, timeout_sec=1.0)
    """

    def test_a_callback_that_spins_needs_the_group(self, run: Run):
        assert codes(run(source(self.ONE_GROUP, self.SPINS, ON_ONE_THREAD))) == ["EXE001"]
        asks = "def tick(self):\n    self.client.call_async(Trigger.Request())\n"
        assert codes(run(source(self.ONE_GROUP, asks, ON_ONE_THREAD))) == ["CBG002"]

    @pytest.mark.parametrize(
        ("start", "expected"),
        [
            pytest.param("threading.Thread(target=robot.ask, daemon=True).start()", [], id="a thread of its own"),
            pytest.param("broker = Broker()\n    broker.on_message = robot.ask", [], id="code of somebody else"),
            pytest.param("robot.ask()", ["CBG002"], id="one after the other"),
        ],
    )
    def test_a_node_that_a_second_thread_spins(self, run: Run, start: str, expected: list[str]):
        ask = self.SPINS.replace("tick(self)", "ask(self, *given)") + "\n" + textwrap.indent(self.TICK, " " * 4)
        main = f"""
from mqtt import Broker


def main():
    rclpy.init()
    robot = Robot()
    {start}
    rclpy.spin(robot)


if __name__ == '__main__':
    main()
"""
        assert [code for code in codes(run(source(self.ONE_GROUP, ask, main))) if code == "CBG002"] == expected

    def test_one_group_for_everything_only_excludes(self, run: Run):
        setup = "group = MutuallyExclusiveCallbackGroup()\nself.create_timer(5.0, self.tick, callback_group=group)\n"
        assert codes(run(source(setup, self.TICK, ON_ONE_THREAD))) == []
        apart = setup + "self.create_timer(1.0, self.tick)"
        assert codes(run(source(apart, self.TICK, ON_ONE_THREAD))) == ["CBG002"]

    @pytest.mark.parametrize(
        ("kind", "members", "severity"),
        [
            ("MutuallyExclusiveCallbackGroup", 2, Severity.INFO),
            ("MutuallyExclusiveCallbackGroup", 1, Severity.WARNING),
            ("ReentrantCallbackGroup", 2, Severity.WARNING),
        ],
    )
    def test_one_group_that_keeps_some_apart_is_information(
        self, run: Run, kind: str, members: int, severity: Severity
    ):
        inside = "self.create_timer({}.0, self.tick, callback_group=group)\n"
        setup = f"group = {kind}()\n" + "".join(inside.format(number + 2) for number in range(members))
        outside = "self.create_timer(1.0, self.tick)"
        [found] = [one for one in run(source(setup + outside, self.TICK, ON_ONE_THREAD)) if one.code == "CBG002"]
        assert found.severity is severity

    PART = """
from rclpy.callback_groups import {kind}


class Part:
    def __init__(self, node):
        group = {kind}()
        node.create_timer(5.0, self.tick, callback_group=group)
        node.create_timer(6.0, self.tick, callback_group=group)

    def tick(self):
        print('tick')
"""

    @pytest.mark.parametrize(
        ("kind", "expected"), [("MutuallyExclusiveCallbackGroup", []), ("ReentrantCallbackGroup", ["CBG002"])]
    )
    def test_a_part_that_does_not_choose_the_executor(self, run: Run, tmp_path: Path, kind: str, expected: list[str]):
        (tmp_path / "part.py").write_text(self.PART.format(kind=kind))
        setup = "Part(self)\nself.create_timer(1.0, self.tick)"
        main = "from part import Part\n" + textwrap.dedent(ON_ONE_THREAD)
        assert codes(run(source(setup, self.TICK, main))) == expected

    LISTENER = """
import threading

from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import SingleThreadedExecutor
from std_msgs.msg import Empty


class Listener:
    def __init__(self, node, spin_thread=False):
        group = ReentrantCallbackGroup()
        node.create_subscription(Empty, 'news', print, 10, callback_group=group)
        if {condition}:
            self.executor = SingleThreadedExecutor()
            self.executor.add_node(node)
            threading.Thread(target=self.executor.spin, daemon=True).start()
"""

    @pytest.mark.parametrize(
        ("module", "expected"),
        [
            pytest.param(LISTENER.format(condition="spin_thread"), [], id="an option that spins"),
            pytest.param(LISTENER.partition("        if ")[0], ["CBG002"], id="no such option"),
        ],
    )
    def test_a_listener_that_can_spin_by_itself(self, run: Run, tmp_path: Path, module: str, expected: list[str]):
        (tmp_path / "listener.py").write_text(module)
        setup = "Listener(self)\nself.create_timer(1.0, self.tick)"
        main = "from listener import Listener\n" + textwrap.dedent(ON_ONE_THREAD)
        assert codes(run(source(setup, self.TICK, main))) == expected

    def test_a_main_that_chooses_one_thread(self, run: Run):
        main = """
def main():
    rclpy.init()
    node = Robot()
    node.create_timer(6.0, node.tick, callback_group=ReentrantCallbackGroup())
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    executor.spin()


if __name__ == '__main__':
    main()
"""
        assert codes(run(source("self.create_timer(5.0, self.tick)", self.TICK, main))) == ["CBG002"]

    @pytest.mark.parametrize(
        ("executor", "expected"), [("MultiThreadedExecutor", []), ("SingleThreadedExecutor", ["CBG002"])]
    )
    def test_a_line_that_several_nodes_run(self, run: Run, tmp_path: Path, executor: str, expected: list[str]):
        (tmp_path / "part.py").write_text(self.PART.format(kind="ReentrantCallbackGroup"))
        (tmp_path / "other.py").write_text(OTHER_NODE.replace("EXECUTOR", executor))
        main = "from part import Part\n" + textwrap.dedent(ON_ONE_THREAD)
        assert codes(run(source("Part(self)", self.TICK, main))) == expected


OTHER_NODE = """
import rclpy
from part import Part
from rclpy.executors import EXECUTOR
from rclpy.node import Node

if __name__ == '__main__':
    rclpy.init()
    node = Node('other')
    part = Part(node)
    executor = EXECUTOR()
    executor.add_node(node)
    executor.spin()
"""


class TestCreatedEachTime:
    def test_two_arms_of_one_function_are_one_finding(self, run: Run):
        handle = """
        def handle(self, request, response):
            if request.data:
                self.talk = self.create_publisher(Empty, 'a', 10)
            else:
                self.talk = self.create_publisher(Empty, 'b', 10)
            return response
        """
        [found] = [
            one for one in run(source("self.create_service(SetBool, 'c', self.handle)", handle)) if one.code == "EXE005"
        ]
        assert [one.message for one in found.related][-1] == "another one is created here each time"
        assert "creates a publisher of 'a' each time" in found.message

    def test_a_name_that_is_one_of_many_is_not_quoted(self, run: Run):
        handle = """
        def handle(self, request, response):
            device = read(request)
            if device is None:
                device = 'default'
            if request.data:
                self.talk = self.create_publisher(Empty, f'{device}/a', 10)
            return response
        """
        [found] = [
            one for one in run(source("self.create_service(SetBool, 'c', self.handle)", handle)) if one.code == "EXE005"
        ]
        assert "creates a publisher each time" in found.message
        assert found.help.startswith("store the result of create_publisher() in a dict by name")


class TestPolling:
    CLIENT = "self.client = self.create_client(Trigger, 'level')\n"
    SHOW = "\ndef show(self, future):\n    self.get_logger().info(future.result().message)\n"
    ASK = "def tick(self):\n    self.client.call_async(Trigger.Request()).add_done_callback(self.show)\n" + SHOW

    @pytest.mark.parametrize(
        ("line", "expected"),
        [
            ("self.get_logger().info(future.result().message)", ["SRV004"]),
            ("answer = future.result()\n    self.level = float(answer.message)", ["SRV004"]),
            ("self.get_logger().info(f'done: {future.result()}')", []),  # a command, and what became of it
            ("self.get_logger().info(str(future.result().success))", []),
            ("pass", []),
        ],
    )
    def test_what_is_asked_for_data_is_polled(self, run: Run, line: str, expected: list[str]):
        show = self.ASK.replace("self.get_logger().info(future.result().message)", line)
        assert codes(run(source(self.CLIENT + "self.create_timer(1.0, self.tick)", show))) == expected

    @pytest.mark.parametrize(("period", "expected"), [("0.1", ["SRV004"]), ("1.0", ["SRV004"]), ("2.0", [])])
    def test_how_often_is_polling(self, run: Run, period: str, expected: list[str]):
        assert codes(run(source(self.CLIENT + f"self.create_timer({period}, self.tick)", self.ASK))) == expected

    @pytest.mark.parametrize(
        "body",
        [
            pytest.param("if self.wanted:\n        self.client.call_async(SetBool.Request())", id="an occasion"),
            pytest.param("self.client.call_async(SetBool.Request(data=self.wanted))", id="a request that changes"),
            pytest.param(
                "if not self.wanted:\n        return\n    self.client.call_async(SetBool.Request())", id="left"
            ),
            pytest.param("self.timer.cancel()\n    self.client.call_async(SetBool.Request())", id="once"),
        ],
    )
    def test_what_has_an_occasion_is_no_polling(self, run: Run, body: str):
        setup = "self.wanted = load()\nself.client = self.create_client(SetBool, 'on')\n"
        setup += "self.timer = self.create_timer(0.1, self.tick)\n"
        assert codes(run(source(setup, f"def tick(self):\n    {body}\n"))) == []

    @pytest.mark.parametrize(
        ("tick", "expected"),
        [("if self.wanted:\n        self.ask()", []), ("self.count()\n    self.ask()", ["SRV004"])],
        ids=["with an occasion", "without one"],
    )
    def test_a_method_that_asks_is_called_with_an_occasion(self, run: Run, tick: str, expected: list[str]):
        setup = "self.wanted = load()\n" + self.CLIENT + "self.create_timer(0.1, self.tick)\n"
        ask = self.ASK.replace("tick", "ask") + "\ndef count(self):\n    pass\n"
        assert codes(run(source(setup, ask + f"\ndef tick(self):\n    {tick}\n"))) == expected

    THREE = "".join(f"self.client{i} = self.create_client(Trigger, 's{i}')\n" for i in range(3))
    MAIN = """
    def main():
        rclpy.init()
        robot = Robot()
        threading.Thread(target=rclpy.spin, args=(robot,), daemon=True).start()
        while rclpy.ok():
            robot.tick()
            time.sleep(5.0)


    if __name__ == '__main__':
        main()
    """

    def in_turn(self, *bodies: str) -> str:
        return "def tick(self):\n" + "".join(f"    {body}\n" for body in bodies)

    def test_three_waits_in_a_loop_of_main(self, run: Run):
        calls = [f"self.client{i}.call(Trigger.Request(), timeout_sec=1.0)" for i in range(3)]
        assert codes(run(source(self.THREE, self.in_turn(*calls), self.MAIN))) == ["SRV005"]
        assert codes(run(source(self.THREE, self.in_turn(*calls[:2]), self.MAIN))) == []

    def test_three_waits_through_one_helper(self, run: Run):
        helper = "\ndef ask(self, client):\n    return client.call(Trigger.Request(), timeout_sec=1.0)\n"
        calls = [f"self.ask(self.client{i})" for i in range(3)]
        text = source(self.THREE, self.in_turn(*calls) + helper, self.MAIN)
        [found] = run(text)
        assert found.code == "SRV005" and "the responses of 3 servers" in found.message
        assert "self.ask(self.client0)" in text.splitlines()[found.place.line - 1]  # not the one line of the helper

    def test_the_goal_and_the_result_of_an_action_are_one_wait(self, run: Run):
        setup = "self.plan = ActionClient(self, Fibonacci, 'plan', callback_group=MutuallyExclusiveCallbackGroup())\n"
        setup += "self.client = self.create_client(Trigger, 'clear', callback_group=MutuallyExclusiveCallbackGroup())\n"
        method = """
        async def tick(self):
            await self.client.call_async(Trigger.Request())
            goal = await self.plan.send_goal_async(Fibonacci.Goal())
            await goal.get_result_async()
        """
        assert codes(run(source(setup + "self.create_timer(5.0, self.tick)\n", method))) == []

    def test_one_server_that_is_asked_again_may_need_its_order(self, run: Run):
        calls = ["self.client0.call(Trigger.Request(), timeout_sec=1.0)"] * 3
        assert codes(run(source(self.THREE, self.in_turn(*calls), self.MAIN))) == []

    CALL = "self.client{}.call(Trigger.Request(), timeout_sec=1.0)"

    @pytest.mark.parametrize(
        ("lines", "expected"),
        [
            pytest.param(("a = {0}", "b = {1}", "c = {2}", "print(a, b, c)"), ["SRV005"], id="all read afterwards"),
            pytest.param(("a = {0}", "if not a.success: return", "{1}", "{2}"), [], id="a test in between"),
            pytest.param(("a = {0}", "print(a.message)", "{1}", "{2}"), [], id="a use in between"),
            pytest.param(("a = {0}", "self.seen = 1", "{1}", "{2}"), ["SRV005"], id="something else in between"),
        ],
    )
    def test_an_answer_may_decide_about_the_next_request(self, run: Run, lines: tuple[str, ...], expected: list[str]):
        calls = [self.CALL.format(i) for i in range(3)]
        body = [line.format(*calls) for line in lines]
        assert codes(run(source(self.THREE, self.in_turn(*body), self.MAIN))) == expected

    def test_commands_have_an_order(self, run: Run):
        calls = [self.CALL.format(i).replace("Trigger", "SetBool") for i in range(3)]
        text = source(self.THREE.replace("Trigger", "SetBool"), self.in_turn(*calls), self.MAIN)
        assert codes(run(text)) == []

    def test_awaits_in_turn_are_to_be_sent_first(self, run: Run):
        apart = self.THREE.replace("')", "', callback_group=MutuallyExclusiveCallbackGroup())")
        awaits = "".join(f"    await self.client{i}.call_async(Trigger.Request())\n" for i in range(3))
        [found] = run(source(apart + "self.create_timer(5.0, self.tick)\n", "async def tick(self):\n" + awaits))
        assert found.code == "SRV005" and "await their futures" in found.help

    @pytest.mark.parametrize(
        ("line", "told"),
        [
            ("await self.ask(self.client0)\n    await self.ask(self.client1)\n    await self.ask(self.client2)", True),
            ("await asyncio.gather(self.ask(self.client0), self.ask(self.client1), self.ask(self.client2))", False),
            ("".join(f"await self.gather(self.client{i})\n    " for i in range(3)).rstrip(), True),
        ],
    )
    def test_coroutines_that_run_beside_each_other(self, run: Run, line: str, told: bool):
        apart = self.THREE.replace("')", "', callback_group=MutuallyExclusiveCallbackGroup())")
        methods = f"async def tick(self):\n    {line}\n\n"
        for name in ("ask", "gather"):  # the second is a method of one's own
            methods += f"async def {name}(self, client):\n    await client.call_async(Trigger.Request())\n\n"
        text = "import asyncio\n" + source(apart + "self.create_timer(5.0, self.tick)\n", methods)
        assert ("SRV005" in codes(run(text))) is told

    def test_waits_of_different_branches_do_not_add_up(self, run: Run):
        calls = [f"if self.mode == {i}: self.client{i}.call(Trigger.Request(), timeout_sec=1.0)" for i in range(3)]
        assert codes(run(source("self.mode = load()\n" + self.THREE, self.in_turn(*calls), self.MAIN))) == []

    def test_a_script_that_asks_three_times_and_ends(self, run: Run):
        calls = [f"self.client{i}.call(Trigger.Request(), timeout_sec=1.0)" for i in range(3)]
        main = self.MAIN.replace("while rclpy.ok():", "if rclpy.ok():")
        assert codes(run(source(self.THREE, self.in_turn(*calls), main))) == []


CIRCLE = (
    IMPORTS
    + """

class {Name}(Node):
    def __init__(self):
        super().__init__('{name}')
        apart = MutuallyExclusiveCallbackGroup()
        self.client = self.create_client(Trigger, '{asks}', callback_group=apart)
        self.create_service(Trigger, '{name}', self.handle)

    def handle(self, request, response):
        return self.client.call(Trigger.Request(), timeout_sec=1.0)
"""
)


class TestCircles:
    def file(self, asks: dict[str, str]) -> str:
        nodes = [CIRCLE.format(Name=name.title(), name=name, asks=other) for name, other in asks.items()]
        names = ", ".join(f"{name.title()}()" for name in asks)
        main = f"""
def main():
    rclpy.init()
    executor = MultiThreadedExecutor()
    for node in ({names},):
        executor.add_node(node)
    executor.spin()


if __name__ == '__main__':
    main()
"""
        return "\n".join([*nodes, main])

    def test_three_nodes_in_a_circle_are_one_finding(self, run: Run):
        found = [one for one in run(self.file({"a": "b", "b": "c", "c": "a"})) if one.code == "SRV006"]
        assert len(found) == 1
        assert "/c → /a → /b → /c" in found[0].message

    def test_where_all_handlers_ask_each_other_each_wait_is_in_a_circle_of_two(self, run: Run):
        text = self.file(dict.fromkeys("abcdefghij", "x"))
        call = "return self.client.call(Trigger.Request(), timeout_sec=1.0)"
        for name in "abcdefghij":
            others = [other for other in "abcdefghij" if other != name]
            made = [f"self.{o} = self.create_client(Trigger, '{o}', callback_group=apart)" for o in others]
            asked = [f"self.{o}.call(Trigger.Request(), timeout_sec=1.0)" for o in others]
            text = text.replace(
                "self.client = self.create_client(Trigger, 'x', callback_group=apart)", "; ".join(made), 1
            )
            text = text.replace(call, f"{'; '.join(asked)}; return response", 1)
        found = [one for one in run(text) if one.code == "SRV006"]
        assert {one.message.count("→") for one in found} == {2}
        pairs = {re.search(r"circle: (/.) → (/.)", one.message).groups() for one in found}
        assert len({frozenset(pair) for pair in pairs}) == 45

    def test_a_line_is_no_circle(self, run: Run):
        assert "SRV006" not in codes(run(self.file({"a": "b", "b": "c", "c": "d"})))

    def test_a_handler_that_asks_itself(self, run: Run):
        [found] = [one for one in run(self.file({"a": "a"})) if one.code == "SRV006"]
        assert "which it serves itself" in found.message

    @pytest.mark.parametrize(("limit", "end"), [("", "ever responds"), (", timeout_sec=1.0", "all of them time out")])
    def test_a_limit_ends_the_waits_and_brings_no_answer(self, run: Run, limit: str, end: str):
        text = self.file({"a": "b", "b": "a"}).replace(", timeout_sec=1.0)", f"{limit})")
        [found] = [one for one in run(text) if one.code == "SRV006"]
        assert found.message.endswith(end)
