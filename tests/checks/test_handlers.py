"""SRV007 and ACT003: every path through a handler."""

from __future__ import annotations

import textwrap

import pytest

from checks.callbacks import Run, codes, source

SERVICE = "self.create_service(Trigger, 'start', self.handle)\n"
SERVER = "self.server = ActionServer(self, Fibonacci, 'count', self.execute)\n"
OWN = ("busy", "go", "step", "wait")
"""Methods of the node that say nothing of its goal."""


def handler(body: str) -> str:
    head = "def handle(self, request, response):\n"
    return source(SERVICE, head + textwrap.indent(textwrap.dedent(body).strip("\n"), "    ") + "\n")


def execute(body: str) -> str:
    head = "def execute(self, goal_handle):\n"
    others = "".join(f"\n    def {name}(self):\n        return self.count_publishers('{name}')\n" for name in OWN)
    text = source(SERVER, head + textwrap.indent(textwrap.dedent(body).strip("\n"), "    ") + "\n")
    return text.replace("\n\ndef main():", f"{others}\n\ndef main():")


def test_the_ends_of_one_execute_callback_are_one_finding(run: Run):
    ends = """
        if self.busy():
            return Fibonacci.Result()
        if self.wait():
            return Fibonacci.Result()
        goal_handle.succeed()
        return Fibonacci.Result()
    """
    [found] = [one for one in run(execute(ends)) if one.code == "ACT003"]
    assert found.message.endswith("; another end of it does the same")
    assert [one.message for one in found.related].count("this end, too") == 1


RETURNS = {
    "straight": "return response",
    "both arms": """
        if self.ready:
            return response
        else:
            return Trigger.Response()
    """,
    "the other path raises": """
        if self.ready:
            return response
        raise RuntimeError('not ready')
    """,
    "either way of one question": """
        if request.on:
            return response
        elif not request.on:
            return Trigger.Response()
    """,
    "forever": """
        while True:
            if self.ready:
                return response
    """,
    "tried and caught": """
        try:
            self.start()
        except OSError:
            return Trigger.Response(success=False)
        return response
    """,
    "finally": """
        try:
            self.start()
        finally:
            return response
    """,
    "finally that goes on": """
        try:
            return response
        finally:
            self.get_logger().info('done')
    """,
    "with": """
        with self.lock:
            return response
    """,
    "match with a last case": """
        match request:
            case None:
                return response
            case _:
                return response
    """,
    "a helper's answer": "return self.answer(response)",
    "nothing written yet": "pass",
}


@pytest.mark.parametrize("body", RETURNS.values(), ids=RETURNS)
def test_every_path_gives_the_response(run: Run, body: str):
    assert "SRV007" not in codes(run(handler(body)))


MISSING = {
    "no return": ("response.success = True", [1]),
    "one arm": ("if self.ready:\n    return response", [1]),
    "empty return": ("if self.ready:\n    return  # here\nreturn response", [3]),
    "true": ("return True", [2]),
    "a pair": ("return response, 'done'", [2]),
    "a loop that may not run": ("for item in self.items:\n    return response", [1]),
    "a loop that is left": ("while True:\n    if self.ready:\n        break\n    return response", [1]),
    "an exception that is swallowed": ("try:\n    return self.start()\nexcept OSError:\n    self.note()", [1]),
    "its request": ("request.done = True\nreturn request", [3]),
    "the class of its response": ("return Trigger.Response", [2]),
    "one question, and another": (
        "if request.on:\n    return response\nelif not request.off:\n    return response",
        [1],
    ),
    "asked again of something else": (
        "if request:\n    return response\nrequest = self.load()\nif not request:\n    return response",
        [1],
    ),
    "two ways": ("if self.ready:\n    return\nreturn None", [3]),
}


@pytest.mark.parametrize(("body", "lines"), MISSING.values(), ids=MISSING)
def test_a_path_without_the_response(run: Run, body: str, lines: list[int]):
    text = handler(body)
    first = text.splitlines().index("    def handle(self, request, response):") + 1
    found = [one for one in run(text) if one.code == "SRV007"]
    assert [one.place.line - first + 1 for one in found] == lines


def test_the_ends_of_one_handler_are_one_finding(run: Run):
    [told] = [one for one in run(handler("if self.ready:\n    return\nself.note()")) if one.code == "SRV007"]
    assert told.message.endswith("; another end of it does the same")
    assert [one.message for one in told.related].count("this end, too") == 1


ALL = {
    "the truth": "if args:\n    return args[1]\nreturn",
    "their number": "if len(args) == 2:\n    return args[1]\nreturn",
    "too few": "if len(args) < 2:\n    return\nreturn args[1]",
    "none": "if not args:\n    return\nreturn args[1]",
}
NOT_ALL = {
    "another number": "if len(args) == 3:\n    return args[2]\nreturn",
    "set before": "args = args[2:]\nif args:\n    return args[1]\nreturn",
    "another name": "if self.busy():\n    return args[1]\nreturn",
}


@pytest.mark.parametrize(
    ("body", "expected"),
    [*((body, []) for body in ALL.values()), *((body, ["SRV007"]) for body in NOT_ALL.values())],
    ids=[*ALL, *NOT_ALL],
)
def test_rclpy_gives_a_handler_all_its_arguments(run: Run, body: str, expected: list[str]):
    """A bare ``return`` for whoever calls the method without any is none of the handler."""
    text = handler(body).replace("(self, request, response)", "(self, *args)")
    assert [code for code in codes(run(text)) if code == "SRV007"] == expected


OTHERS = {
    "at once": "return SetBool.Response(success=True)",
    "by a variable": "answer = SetBool.Response()\nanswer.success = True\nreturn answer",
}


@pytest.mark.parametrize("body", OTHERS.values(), ids=OTHERS)
def test_the_response_of_another_service(run: Run, body: str):
    [told] = [one for one in run(handler(body)) if one.code == "SRV007"]
    assert told.message == (
        "the handler of the service 'start' returns a response of std_srvs/srv/SetBool here, which is not one of "
        "std_srvs/srv/Trigger: rclpy raises a TypeError, and the caller never gets a response"
    )
    assert told.help == "return the response that the handler is given"


RIGHT = {
    "a variable of the request's name": "request = response\nreturn request",
    "its own": "answer = Trigger.Response()\nreturn answer",
    "its own, made of another's": "other = SetBool.Response()\nresponse.success = other.success\nreturn response",
    "a variable that is set again": "answer = SetBool.Response()\nanswer = Trigger.Response()\nreturn answer",
    "a variable of a loop": "answer = SetBool.Response()\nfor answer in self.answers:\n    pass\nreturn answer",
    "a name that means something else here": "from robot import Trigger as SetBool\nreturn SetBool.Response()",
    "a class that is not known": "return Unknown.Response()",
}


@pytest.mark.parametrize("body", RIGHT.values(), ids=RIGHT)
def test_a_response_that_may_be_the_right_one(run: Run, body: str):
    assert "SRV007" not in codes(run(handler(body)))


def test_a_handler_of_several_services_may_know_which_one_asks(run: Run):
    """It may tell them apart by the request."""
    text = handler("if hasattr(request, 'data'):\n    return SetBool.Response()\nreturn response")
    assert "SRV007" in codes(run(text))
    enable = "self.create_service(SetBool, 'enable', self.handle)"
    assert "SRV007" not in codes(run(text.replace(SERVICE, f"{SERVICE}        {enable}\n")))


def test_a_lambda_gives_its_value(run: Run):
    create = "self.create_service(Trigger, 'a', lambda request, response: {})\n"
    assert codes(run(source(create.format("response"), "pass"))) == []
    assert codes(run(source(create.format("None"), "pass"))) == ["SRV007"]


OUTCOMES = {
    "succeed": "goal_handle.succeed()\nreturn Fibonacci.Result()",
    "either": """
        if goal_handle.is_cancel_requested:
            goal_handle.canceled()
            return Fibonacci.Result()
        goal_handle.succeed()
        return Fibonacci.Result()
    """,
    "by a helper": "self.finish(goal_handle)\nreturn Fibonacci.Result()",
    "a raise": "raise RuntimeError('no')",
    "somebody else has": """
        if not goal_handle.is_active:
            return Fibonacci.Result()
        goal_handle.succeed()
        return Fibonacci.Result()
    """,
    "in finally": """
        try:
            return self.count()
        finally:
            goal_handle.succeed()
    """,
    "a flag remembers": """
        order, success = goal_handle.request.order, None
        success = True
        for _ in range(order):
            if goal_handle.is_cancel_requested:
                goal_handle.canceled()
                success = False
                break
        if success:
            goal_handle.succeed()
        return Fibonacci.Result()
    """,
    "asked twice": """
        reached = self.go()
        if not reached:
            goal_handle.abort()
        self.get_logger().info('there')
        if reached:
            goal_handle.succeed()
        return Fibonacci.Result()
    """,
    "one of a few": """
        state = None
        if self.go():
            state = 'done'
            goal_handle.succeed()
        if state is None:
            goal_handle.abort()
        return Fibonacci.Result()
    """,
    "kept, and ended under that name": """
        self.goal = goal_handle
        self.goal.succeed()
        return Fibonacci.Result()
    """,
    "kept for another callback": """
        self.goal = goal_handle
        self.create_timer(1.0, lambda: self.goal.succeed())
        return Fibonacci.Result()
    """,
    "handed to somebody who is not here": "count(goal_handle)\nreturn Fibonacci.Result()",
    "a helper may have ended it before it raised": """
        done = False
        try:
            done = count(goal_handle)
        except RuntimeError as error:
            self.get_logger().error(str(error))
        if done:
            goal_handle.succeed()
        elif not goal_handle.is_cancel_requested:
            goal_handle.abort()
        return Fibonacci.Result()
    """,
    "a try around nothing but the outcome": """
        try:
            self.step()
            goal_handle.succeed()
        except RuntimeError:
            try:
                if not goal_handle.is_cancel_requested:
                    goal_handle.abort()
                else:
                    goal_handle.canceled()
            except Exception:
                pass
        return Fibonacci.Result()
    """,
    "a method that no goal has": """
        if self.ready:
            goal_handle.succeed()
        else:
            goal_handle.fail()
        return Fibonacci.Result()
    """,
    "a name of ROS 1, at which it fails": "self.server.set_succeeded([])\nreturn Fibonacci.Result()",
}


@pytest.mark.parametrize("body", OUTCOMES.values(), ids=OUTCOMES)
def test_a_goal_with_an_outcome_on_every_path(run: Run, body: str):
    assert "ACT003" not in codes(run(execute(body)))


@pytest.mark.parametrize(
    "body",
    [
        "return Fibonacci.Result()",
        "if self.ready:\n    goal_handle.succeed()\nreturn Fibonacci.Result()",
        "for _ in range(goal_handle.request.order):\n    goal_handle.succeed()\nreturn Fibonacci.Result()",
        "order = goal_handle.request.order\nif order:\n    goal_handle.succeed()\nreturn Fibonacci.Result()",
        "self.goal = goal_handle\nif self.ready:\n    self.goal.succeed()\nreturn Fibonacci.Result()",
        "print(goal_handle)\nif self.ready:\n    goal_handle.succeed()\nreturn Fibonacci.Result()",
        "try:\n    self.go()\nexcept RuntimeError:\n    return Fibonacci.Result()\n"
        "goal_handle.succeed()\nreturn Fibonacci.Result()",
        "if self.ready:\n    self.server.set_succeeded([])\nreturn Fibonacci.Result()",
        "try:\n    self.go()\n    goal_handle.succeed()\nexcept Exception:\n    pass\nreturn Fibonacci.Result()",
        "ready = self.go()\nif ready:\n    goal_handle.succeed()\nready = self.go()\n"
        "if not ready:\n    goal_handle.abort()\nreturn Fibonacci.Result()",
    ],
)
def test_a_goal_without_an_outcome_on_some_path(run: Run, body: str):
    assert "ACT003" in codes(run(execute(body)))


@pytest.mark.parametrize(
    ("accept", "expected"),
    [
        ("self.goal = goal_handle", []),  # a timer ends the goal; nothing ever calls the execute callback
        ("goal_handle.execute()", ["ACT003"]),
        ("threading.Thread(target=goal_handle.execute).start()", ["ACT003"]),
    ],
)
def test_goals_that_the_server_accepts_itself(run: Run, accept: str, expected: list[str]):
    server = (
        "self.server = ActionServer(self, Fibonacci, 'count', self.execute, handle_accepted_callback=self.accept)\n"
    )
    methods = (
        "def execute(self, goal_handle):\n    return Fibonacci.Result()\n\n"
        f"def accept(self, goal_handle):\n    {accept}\n"
    )
    assert [code for code in codes(run(source(server, methods))) if code == "ACT003"] == expected


def test_a_helper_that_only_tells_how_far_things_are_ends_no_goal(run: Run):
    body = "self.tell(goal_handle)\nif self.ready:\n    goal_handle.succeed()\nreturn Fibonacci.Result()"
    tell = "\n    def tell(self, goal):\n        goal.publish_feedback(Fibonacci.Feedback()){}\n\n\ndef main():"
    text = execute(body)
    assert "ACT003" in codes(run(text.replace("\n\ndef main():", tell.format(""))))
    assert "ACT003" not in codes(run(text.replace("\n\ndef main():", tell.format("\n        goal.abort()"))))


@pytest.mark.parametrize(
    ("created_if", "left_if", "expected"),
    [
        ("PRESENT and Driver is not None", "not PRESENT or Driver is None", []),
        ("PRESENT", "not PRESENT", []),
        ("Driver != None", "Driver is None", []),
        ("PRESENT", "PRESENT", ["SRV007"]),
        ("PRESENT", "not PRESENT or self.busy", ["SRV007"]),
        ("self.ready", "not self.ready", ["SRV007"]),
        ("not PRESENT", "not PRESENT", ["SRV007"]),
        ("True", "not PRESENT", ["SRV007"]),
    ],
)
def test_a_service_that_is_not_there_has_no_handler_either(
    run: Run, created_if: str, left_if: str, expected: list[str]
):
    create = f"self.ready = load()\nif {created_if}:\n    {SERVICE}"
    method = f"def handle(self, request, response):\n    if {left_if}:\n        return\n    return response\n"
    gate = "PRESENT = load()\nDriver = load()\n"
    text = source(create, method).replace("class Robot", f"{gate}\n\nclass Robot", 1)
    assert codes(run(text)) == expected


def test_a_handler_may_set_what_was_asked_before(run: Run):
    create = f"if PRESENT:\n    {SERVICE}"
    method = (
        "def handle(self, request, response):\n    PRESENT = read()\n    if not PRESENT:\n        return\n"
        "    return response\n"
    )
    text = source(create, method).replace("class Robot", "PRESENT = load()\n\n\nclass Robot", 1)
    assert codes(run(text)) == ["SRV007"]


@pytest.mark.parametrize(
    ("test", "expected"),
    [
        ("rclpy.ok()", []),
        ("self.context.ok()", []),
        ("self.busy()", ["ACT003"]),
        ("rclpy.ok() and self.busy()", ["ACT003"]),
    ],
)
def test_a_goal_whose_outcome_only_the_end_of_ros_prevents(run: Run, test: str, expected: list[str]):
    body = f"""
        while {test}:
            if self.step():
                goal_handle.succeed()
                return Fibonacci.Result()
            self.wait()
    """
    assert [one for one in codes(run(execute(body))) if one == "ACT003"] == expected


def test_an_early_end_since_ros_is_shut_down(run: Run):
    body = """
        if not rclpy.ok():
            return Fibonacci.Result()
        goal_handle.succeed()
        return Fibonacci.Result()
    """
    assert "ACT003" in codes(run(execute(body.replace("not rclpy.ok()", "self.late"))))
    assert "ACT003" not in codes(run(execute(body)))


SUCCEEDED = "goal_handle.succeed()\n"


@pytest.mark.parametrize(
    ("end", "line"),
    [
        ("", "def execute(self, goal_handle):"),
        ("return", "return"),
        ("return [0, 1]", "return [0, 1]"),
        ("return goal_handle", "return goal_handle"),
        ("return Fibonacci.Result", "return Fibonacci.Result"),
        ("if self.busy():\n    return Fibonacci.Result()", "def execute(self, goal_handle):"),
        ("self.create_timer(1.0, self.step)\nreturn None", "return None"),
    ],
)
def test_an_execute_callback_that_gives_no_result(run: Run, end: str, line: str):
    text = execute(SUCCEEDED + end)
    [finding] = [finding for finding in run(text) if finding.code == "ACT003"]
    assert text.splitlines()[finding.place.line - 1].strip() == line
    assert finding.message.endswith("the client never gets one")


@pytest.mark.parametrize(
    "end",
    [
        "return Fibonacci.Result()",
        "result = Fibonacci.Result()\nreturn result",
        "return self.step()",
        "raise RuntimeError('busy')",
        "while rclpy.ok():\n    if self.busy():\n        return Fibonacci.Result()",
        "if self.busy():\n    return Fibonacci.Result(sequence=[1])\nelse:\n    return self.step()",
    ],
)
def test_an_execute_callback_that_gives_its_result(run: Run, end: str):
    assert "ACT003" not in codes(run(execute(SUCCEEDED + end)))


def test_a_stub_gives_no_result_yet(run: Run):
    assert "ACT003" not in codes(run(execute("pass")))


DECIDING = (
    "self.server = ActionServer(\n    self, Fibonacci, 'count', self.execute, goal_callback=self.on_goal, "
    "cancel_callback=self.on_cancel\n)\n"
)


def deciding(on_goal: str, on_cancel: str) -> str:
    def method(head: str, body: str) -> str:
        return f"def {head}:\n{textwrap.indent(body, '    ')}\n\n"

    methods = (
        method("on_goal(self, goal)", on_goal)
        + method("on_cancel(self, goal_handle)", on_cancel)
        + method("execute(self, goal_handle)", SUCCEEDED + "return Fibonacci.Result()")
    )
    text = source(DECIDING, methods)
    return text.replace(
        "import ActionClient, ActionServer", "import ActionClient, ActionServer, CancelResponse, GoalResponse"
    )


ACCEPT, LET = "return GoalResponse.ACCEPT", "return CancelResponse.ACCEPT"


@pytest.mark.parametrize(
    ("on_goal", "on_cancel", "said"),
    [
        ("print(goal)", LET, "goal callback"),
        ("return True", LET, "goal callback"),
        ("if goal.order:\n    return GoalResponse.ACCEPT", LET, "goal callback"),
        (ACCEPT, "print('cancel')", "cancel callback"),
        (ACCEPT, "return True", "cancel callback"),
    ],
)
def test_a_callback_that_says_neither_yes_nor_no(run: Run, on_goal: str, on_cancel: str, said: str):
    [finding] = [finding for finding in run(deciding(on_goal, on_cancel)) if finding.code == "ACT003"]
    assert finding.message.startswith(f"the {said} of the action 'count'")


@pytest.mark.parametrize(
    ("on_goal", "on_cancel"),
    [
        (ACCEPT, LET),
        ("return GoalResponse.ACCEPT if goal.order else GoalResponse.REJECT", LET),
        (ACCEPT, "if goal_handle.is_active:\n    return CancelResponse.ACCEPT"),  # to reject is what falls off here
        (ACCEPT, "return self.decide(goal_handle)"),
        ("pass", "pass"),
    ],
)
def test_callbacks_that_decide(run: Run, on_goal: str, on_cancel: str):
    assert "ACT003" not in codes(run(deciding(on_goal, on_cancel)))
