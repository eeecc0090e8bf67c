from __future__ import annotations

import pytest

from archlint.finding import Severity
from checks.judging import Judge

GRIPPER = """
    import rclpy
    from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
    from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
    from rclpy.node import Node
    from std_srvs.srv import SetBool, Trigger


    class Gripper(Node):
        def __init__(self):
            super().__init__('gripper')
            {init}

        def close(self, request, response):
            {body}


    def main():
        rclpy.init()
        {main}


    if __name__ == '__main__':
        main()
"""
CLIENT = "self.motor = self.create_client(SetBool, 'enable_motor'{group})"
SERVICE = "self.create_service(Trigger, 'close_gripper', self.close{group})"
SPIN = ["rclpy.spin(Gripper())"]
THREADS = ["executor = MultiThreadedExecutor()", "executor.add_node(Gripper())", "executor.spin()"]
CALL = ["self.motor.call(SetBool.Request(), timeout_sec=1.0)  # here", "return response"]


def gripper(body: list[str], main: list[str] = SPIN, client: str = "", service: str = "", extra: str = "") -> str:
    init = [
        "self.apart = MutuallyExclusiveCallbackGroup()",
        "self.free = ReentrantCallbackGroup()",
        CLIENT.format(group=client),
        SERVICE.format(group=service),
    ]
    source = GRIPPER.format(
        init="\n            ".join(init), body="\n            ".join(body), main="\n        ".join(main)
    )
    return source.replace("    def main():", extra + "\n    def main():", 1)


class TestWaysToWait:
    def test_a_call(self, judge: Judge):
        [found] = judge("SRV003", gripper(CALL))

        assert found.severity is Severity.ERROR
        assert found.node == "/gripper"
        assert "'close_gripper'" in found.message
        assert "'enable_motor'" in found.message

    def test_a_loop_until_the_future_is_done(self, judge: Judge):
        judge(
            "SRV003",
            gripper(
                [
                    "future = self.motor.call_async(SetBool.Request())",
                    "while rclpy.ok() and not future.done():  # here",
                    "    pass",
                    "return response",
                ]
            ),
        )

    def test_a_loop_that_spins_the_node_once_and_again(self, judge: Judge):
        [found] = judge(
            "SRV003",
            gripper(
                [
                    "future = self.motor.call_async(SetBool.Request())",
                    "while not future.done():  # here",
                    "    rclpy.spin_once(self)",
                    "return response",
                ],
                main=THREADS,
                client=", callback_group=self.apart",
            ),
        )

        assert found.severity is Severity.ERROR
        assert "its node is spun by another executor" in found.message

    def test_a_loop_that_spins_the_executor_that_is_spinning(self, judge: Judge):
        [found] = judge(
            "SRV003",
            gripper(
                [
                    "future = self.motor.call_async(SetBool.Request())",
                    "while not future.done():  # here",
                    "    rclpy.spin_once(self)",
                    "return response",
                ]
            ),
        )

        assert "its executor is already spinning" in found.message

    def test_an_event_that_the_done_callback_sets(self, judge: Judge):
        judge(
            "SRV003",
            gripper(
                [
                    "import threading",
                    "answered = threading.Event()",
                    "future = self.motor.call_async(SetBool.Request())",
                    "future.add_done_callback(lambda _: answered.set())",
                    "answered.wait()  # here",
                    "return response",
                ]
            ),
        )

    @pytest.mark.parametrize(("main", "mark"), [(SPIN, "  # here"), (THREADS, "")])
    def test_an_event_in_a_file_that_two_programs_run(self, judge: Judge, main: list[str], mark: str):
        """Each program has a client of its own, at the same place in the source."""
        body = [
            "import threading",
            "answered = threading.Event()",
            "future = self.motor.call_async(SetBool.Request())",
            "future.add_done_callback(lambda _: answered.set())",
            f"answered.wait(timeout=5.0){mark}",
            "return response",
        ]
        group = ", callback_group=self.free"
        second = "from node import main\n\nif __name__ == '__main__':\n    main()\n"

        judge("SRV003", gripper(body, main, client=group, service=group), second)

    def test_an_event_that_something_else_sets_is_no_wait_for_a_service(self, judge: Judge):
        judge(
            "SRV003",
            gripper(["import threading", "moved = threading.Event()", "moved.wait(1.0)", "return response"]),
        )

    def test_a_request_without_a_wait(self, judge: Judge):
        judge("SRV003", gripper(["self.motor.call_async(SetBool.Request())", "return response"]))

    def test_a_look_at_a_future_that_may_not_be_done_waits_for_nothing(self, judge: Judge):
        judge(
            "SRV003",
            gripper(
                [
                    "future = self.motor.call_async(SetBool.Request())",
                    "response.success = future.done()",
                    "return response",
                ]
            ),
        )


def unmarked(source: str) -> str:
    """The same program, in which nothing is to be found."""
    return source.replace("  # here", "")


class TestExecutorsAndGroups:
    def test_several_threads_and_a_group_apart_only_block(self, judge: Judge):
        [found] = judge("SRV003", gripper(CALL, THREADS, client=", callback_group=self.apart"))

        assert found.severity is Severity.WARNING
        assert "since the client is in another callback group" in found.message
        assert found.help.startswith("send the request with call_async(), return, and publish")
        ignored = ["self.motor.call(SetBool.Request())  # here", "return response"]
        [found] = judge("SRV003", gripper(ignored, THREADS, client=", callback_group=self.apart"))
        assert found.help == "make the handler async, and await call_async(…): no thread is blocked then"

    @pytest.mark.parametrize(
        ("line", "help"),
        [
            ("{}  # here", "send the request with call_async() and do not wait: nobody looks at the response here"),
            (
                "response.success = {}.success  # here",
                "send the request with call_async(), and wait with a limit for a threading.Event that its done "
                "callback sets",
            ),
        ],
        ids=["thrown away", "used"],
    )
    def test_a_handler_that_is_called_directly_cannot_be_async(self, judge: Judge, line: str, help: str):
        """The coroutine of the direct call would be dropped, and nothing of it would run."""
        body = [line.format("self.motor.call(SetBool.Request())"), "return response"]
        stop = "\n        def stop(self):\n            self.close(None, Trigger.Response())\n\n"
        [found] = judge("SRV003", gripper(body, THREADS, client=", callback_group=self.apart", extra=stop))
        assert found.help == help
        awaited = stop.replace("def", "async def").replace("self.close(", "await self.close(")
        [found] = judge("SRV003", gripper(body, THREADS, client=", callback_group=self.apart", extra=awaited))
        assert found.help == "make the handler async, and await call_async(…): no thread is blocked then"

    def test_a_loop_without_a_limit_is_told_to_have_one(self, judge: Judge):
        ask = "future = self.motor.call_async(SetBool.Request())"
        body = (ask, "while not future.done():  # here", "    time.sleep(0.1)", "return future.result()")
        apart = ", callback_group=self.apart"
        [found] = judge("SRV003", gripper(list(body), THREADS, client=apart))

        assert "has no time limit: if the response never comes, the handler never returns" in found.message
        assert found.help == "end the loop after a time limit, too, and respond that it failed then"
        limited = (ask, "end = time.time() + 2.0", "while not future.done() and time.time() < end:", *body[2:])
        judge("SRV003", gripper(list(limited), THREADS, client=apart))

    def test_several_threads_and_the_default_group_deadlock(self, judge: Judge):
        [found] = judge("SRV003", gripper(CALL, THREADS))

        assert found.severity is Severity.ERROR

    def test_one_exclusive_group_for_both_deadlocks(self, judge: Judge):
        group = ", callback_group=self.apart"
        [found] = judge("SRV003", gripper(CALL, THREADS, client=group, service=group))

        assert found.severity is Severity.ERROR

    def test_one_reentrant_group_for_both_only_blocks(self, judge: Judge):
        group = ", callback_group=self.free"
        [found] = judge("SRV003", gripper(CALL, THREADS, client=group, service=group))

        assert found.severity is Severity.WARNING
        assert "since the handler and the client share a reentrant callback group" in found.message

    def test_a_pool_of_one_thread_deadlocks(self, judge: Judge):
        main = ["executor = MultiThreadedExecutor(num_threads=1)", *THREADS[1:]]
        [found] = judge("SRV003", gripper(CALL, main, client=", callback_group=self.apart"))

        assert found.severity is Severity.ERROR

    def test_a_node_that_nobody_here_spins_is_not_proved_safe(self, judge: Judge):
        [found] = judge("SRV003", gripper(CALL, ["Gripper()"], client=", callback_group=self.apart"))

        assert found.severity is Severity.ERROR

    def test_a_spin_of_the_own_node_is_never_safe(self, judge: Judge):
        body = [
            "future = self.motor.call_async(SetBool.Request())",
            "rclpy.spin_until_future_complete(self, future, timeout_sec=1.0)  # here",
            "return response",
        ]
        [found] = judge("SRV003", gripper(body, THREADS, client=", callback_group=self.apart"))

        assert found.severity is Severity.ERROR

    def test_a_spin_of_another_node_on_an_executor_of_its_own_only_blocks(self, judge: Judge):
        [found] = judge(
            "SRV003",
            gripper(
                [
                    "helper = rclpy.create_node('helper')",
                    "client = helper.create_client(SetBool, 'enable_motor')",
                    "future = client.call_async(SetBool.Request())",
                    "executor = SingleThreadedExecutor()",
                    "executor.add_node(helper)",
                    "executor.spin_until_future_complete(future, timeout_sec=1.0)  # here",
                    "return response",
                ]
            ),
        )

        assert found.severity is Severity.WARNING


class TestCarefulCode:
    """A limit, several threads, a group apart, and a caller that needs the answer: there is nothing to mend."""

    BOUNDED = (
        "answer = self.motor.call(SetBool.Request(), timeout_sec=1.0)  # here",
        "response.success = answer.success",
        "return response",
    )
    POLLED = (
        "future = self.motor.call_async(SetBool.Request())",
        "deadline = time.monotonic() + 2.0",
        "while not future.done() and time.monotonic() < deadline:  # here",
        "    time.sleep(0.01)",
        "response.success = future.done()",
        "return response",
    )
    SIGNALLED = (
        "ready = threading.Event()",
        "future = self.motor.call_async(SetBool.Request())",
        "future.add_done_callback(lambda _: ready.set())",
        "response.success = ready.wait(2.0)  # here",
        "return response",
    )

    def careful(self, body: tuple[str, ...], service: str = "", more: str = "", extra: str = "") -> str:
        text = gripper(list(body), THREADS, ", callback_group=self.apart", service, extra)
        text = text.replace("    import rclpy\n", "    import threading\n    import time\n\n    import rclpy\n", 1)
        created = SERVICE.format(group=service)
        return text.replace(created, f"{created}\n            {more}", 1)

    def test_nothing_is_said(self, judge: Judge):
        for body in (self.BOUNDED, self.POLLED, self.SIGNALLED):
            judge("SRV003", unmarked(self.careful(body)))

    def test_a_limit_that_is_not_known_is_one(self, judge: Judge):
        body = tuple(line.replace("wait(2.0)", "wait(load_limit())") for line in self.SIGNALLED)
        judge("SRV003", unmarked(self.careful(body)))

        body = tuple(line.replace("wait(2.0)", "wait(None)") for line in self.SIGNALLED)
        [found] = judge("SRV003", self.careful(body))
        assert found.severity is Severity.WARNING

    OPEN = """
        def open(self, request, response):
            return self.close(request, response)

        def stop(self, request, response):
            return response
"""

    def test_handlers_that_wait_at_the_same_line_are_kept_apart(self, judge: Judge):
        opens = "self.create_service(Trigger, 'open', self.open)"
        judge("SRV003", unmarked(self.careful(self.BOUNDED, more=opens, extra=self.OPEN)))

        stops = f"{opens}\n            self.create_service(Trigger, 'stop', self.stop)"
        [found] = judge("SRV003", self.careful(self.BOUNDED, more=stops, extra=self.OPEN))

        assert found.severity is Severity.WARNING
        assert found.message.endswith("and the other callbacks of its group cannot run: the service 'stop'")
        assert found.help == "give the service 'stop' a different callback group from the handlers that wait here"

    def test_a_wait_without_a_limit_stays_a_warning(self, judge: Judge):
        body = ("answer = self.motor.call(SetBool.Request())  # here", *self.BOUNDED[1:])
        [found] = judge("SRV003", self.careful(body))

        assert found.severity is Severity.WARNING

    def test_an_answer_that_nobody_looks_at_stays_a_warning(self, judge: Judge):
        body = ("self.motor.call(SetBool.Request(), timeout_sec=1.0)  # here", "return response")
        [found] = judge("SRV003", self.careful(body))

        assert found.severity is Severity.WARNING

    STOP = """
        def stop(self, request, response):
            return response

        def look(self):
            pass
"""

    def test_who_waits_in_the_same_group_is_named(self, judge: Judge):
        more = "self.create_service(Trigger, 'stop', self.stop)\n            self.create_timer(1.0, self.look)"
        [found] = judge("SRV003", self.careful(self.BOUNDED, more=more, extra=self.STOP))

        assert found.severity is Severity.WARNING
        assert found.message.endswith(
            "its own caller waits, and the other callbacks of its group cannot run: the service 'stop' and Gripper.look"
        )
        assert found.help.startswith("give the service 'close_gripper' its own callback group")

    def test_what_is_in_other_groups_waits_for_nothing(self, judge: Judge):
        more = "self.create_service(Trigger, 'stop', self.stop, callback_group=MutuallyExclusiveCallbackGroup())"
        judge("SRV003", unmarked(self.careful(self.BOUNDED, more=more, extra=self.STOP)))

    MOTOR = """
    import rclpy
    from rclpy.callback_groups import ReentrantCallbackGroup
    from rclpy.executors import MultiThreadedExecutor
    from rclpy.node import Node
    from std_srvs.srv import SetBool


    class Motor(Node):
        def __init__(self):
            super().__init__('motor')
            self.power = self.create_client(SetBool, 'power', callback_group=ReentrantCallbackGroup())
            self.create_service(SetBool, 'enable_motor', self.enable)

        def enable(self, request, response):
            {body}
            return response


    def main():
        rclpy.init()
        executor = MultiThreadedExecutor()
        executor.add_node(Motor())
        executor.spin()


    if __name__ == '__main__':
        main()
    """

    def test_a_handler_behind_it_that_waits_itself_is_named(self, judge: Judge):
        waits = self.MOTOR.format(body="response.success = self.power.call(request, timeout_sec=3.0).success")
        [outer] = judge("SRV003", self.careful(self.BOUNDED), waits)

        assert outer.severity is Severity.WARNING
        assert "(the handler of /enable_motor itself waits for /power)" in outer.message
        assert outer.help == "make the timeout here longer than the total time that /enable_motor may wait"

    def test_a_handler_behind_it_that_answers_at_once(self, judge: Judge):
        judge("SRV003", unmarked(self.careful(self.BOUNDED)), self.MOTOR.format(body="self.power.call_async(request)"))


class TestHelpersThatPoll:
    """``self.wait(future, 2.0)``: the helper asks in the body of its loop, and gives up after the limit it is given."""

    HANDLER = (
        "response.success = self.wait(self.motor.call_async(SetBool.Request()), 2.0) is not None",
        "return response",
    )
    HELPER = """
        def wait(self, future, limit):
            start = time.monotonic()
            while rclpy.ok():
                if {done}:
                    return future.result()
                if {late}:
                    return None
                time.sleep(0.01)
"""

    def helper(self, main: list[str], done: str = "future.done()  # here", late: str = "") -> str:
        end = late or "time.monotonic() - start >= limit"
        extra = self.HELPER.format(done=done, late=end).replace("  # here:", ":  # here")
        text = gripper(list(self.HANDLER), main, ", callback_group=self.apart", extra=extra)
        return text.replace("    import rclpy\n", "    import time\n\n    import rclpy\n", 1)

    def test_on_one_thread_the_response_never_comes(self, judge: Judge):
        [found] = judge("SRV003", self.helper(SPIN))

        assert found.severity is Severity.ERROR
        assert "times out" in found.message

    def test_on_several_threads_it_is_done_right(self, judge: Judge):
        judge("SRV003", unmarked(self.helper(THREADS)))

    def test_a_loop_that_does_something_else_meanwhile_is_no_wait(self, judge: Judge):
        judge("SRV003", self.helper(SPIN, done="future.done()", late="self.moved()"))

    def test_a_loop_that_goes_on_with_the_next_future_is_no_wait(self, judge: Judge):
        judge("SRV003", self.helper(SPIN, done="future.done() and self.idle"))


class TestTheOnlyThread:
    BODY = (
        "future = self.outside.call_async(SetBool.Request())",
        "answered = threading.Event()",
        "future.add_done_callback(lambda _: answered.set())",
        "answered.wait(timeout=3.0)  # here",
        "response.success = future.done()",
        "return response",
    )
    HELPER = (
        "self.helper = rclpy.create_node('helper')",
        "executor = SingleThreadedExecutor()",
        "executor.add_node(self.helper)",
        "threading.Thread(target=executor.spin, daemon=True).start()",
        "self.outside = self.helper.create_client(SetBool, 'enable_motor')",
        "self.create_timer(1.0, self.look, callback_group=MutuallyExclusiveCallbackGroup())",
    )

    def test_a_group_of_its_own_needs_more_threads(self, judge: Judge):
        text = gripper(list(self.BODY), extra="\n        def look(self):\n            pass\n")
        text = text.replace("    import rclpy\n", "    import threading\n\n    import rclpy\n", 1)
        created = SERVICE.format(group="")
        text = text.replace(created, "\n            ".join([created, *self.HELPER]), 1)
        [found] = judge("SRV003", text)

        assert found.severity is Severity.WARNING
        assert found.message.endswith("the other callbacks of its node cannot run: Gripper.look")
        assert found.help.startswith("spin the node with a MultiThreadedExecutor, and give the service")
        judge("SRV003", unmarked(text.replace(SPIN[0], "\n        ".join(THREADS))))


class TestOneFindingAHandler:
    STEPS = (
        "while not self.motor.wait_for_service(timeout_sec=1.0):",
        "    pass",
        "self.motor.call(SetBool.Request())  # here",
        "self.motor.call(SetBool.Request())",
        "self.motor.call(SetBool.Request())",
        "return response",
    )

    def test_with_several_threads_it_says_what_the_waits_cost(self, judge: Judge):
        [found] = judge("SRV003", gripper(list(self.STEPS), THREADS, client=", callback_group=self.apart"))

        assert found.severity is Severity.WARNING
        assert "waits for the service 'enable_motor', at 3 places, which works here" in found.message
        assert found.message.endswith(
            "but has no time limit: if the response never comes, the handler never returns; until then its own caller "
            "waits, and one thread is blocked"
        )
        waits = [one.place.line for one in found.related if one.message.startswith("it waits for")]
        assert waits == [found.place.line + 1, found.place.line + 2]

    @pytest.mark.parametrize("main", [SPIN, THREADS])
    def test_an_await_that_holds_nothing_up_has_no_limit(self, judge: Judge, main: list[str]):
        free = ", callback_group=self.free"
        body = ["response.success = (await self.motor.call_async(SetBool.Request())).success  # here"]
        source = gripper([*body, "return response"], main, client=free, service=free)
        [found] = judge("SRV003", source.replace("def close", "async def close"))

        assert found.severity is Severity.INFO
        assert found.message.endswith(
            "but the await has no timeout: if the response never comes, the handler and its caller wait forever"
        )
        assert found.help.startswith("add a timeout: a timer")

    TWO = "self.light = self.create_client(SetBool, 'switch_light', callback_group=self.apart)"

    def two_servers(self, *body: str) -> str:
        text = gripper([*body, "return response"], THREADS, client=", callback_group=self.apart")
        service = SERVICE.format(group="")
        return text.replace(service, f"{self.TWO}\n            {service}", 1)

    def test_either_one_or_the_other(self, judge: Judge):
        [found] = judge(
            "SRV003",
            self.two_servers(
                "if request.hurry:",
                "    self.motor.call(SetBool.Request())  # here",
                "else:",
                "    self.light.call(SetBool.Request())",
            ),
        )

        assert "waits for the service 'enable_motor' or the service 'switch_light', which works" in found.message

    def test_one_after_the_other_where_the_first_has_worked(self, judge: Judge):
        [found] = judge(
            "SRV003",
            self.two_servers(
                "answer = self.motor.call(SetBool.Request())  # here",
                "if answer.success:",
                "    self.light.call(SetBool.Request())",
            ),
        )

        assert "'enable_motor' and the service 'switch_light' one after the other, which works" in found.message

    def test_what_helps_a_handler_that_needs_the_answer(self, judge: Judge):
        apart = ", callback_group=self.apart"
        answer = ["answer = self.motor.call(SetBool.Request())  # here", "response.success = answer.success"]
        [needs] = judge("SRV003", gripper([*answer, "return response"]))
        [sends] = judge("SRV003", gripper(["self.motor.call(SetBool.Request())  # here", "return response"]))
        waits = ["answer = self.motor.call(SetBool.Request(), timeout_sec=1.0)", *answer[1:]]
        judge("SRV003", gripper([*waits, "return response"], THREADS, client=apart))

        assert "and await call_async(…)" in needs.help
        assert sends.help.startswith("send the request with call_async(), return, and publish")

    def test_what_hangs_hangs_at_the_first_wait(self, judge: Judge):
        [found] = judge("SRV003", gripper(list(self.STEPS)))

        assert "deadlocks" in found.message

    def test_the_other_rules_about_waits_are_silent_there(self, judge: Judge):
        steps = [step.removesuffix("  # here") for step in self.STEPS]
        judge("SRV005", gripper(steps, THREADS, client=", callback_group=self.apart"))
        judge("TMO002", gripper(steps, THREADS, client=", callback_group=self.apart"))
        judge("TMO004", gripper(steps, THREADS, client=", callback_group=self.apart"))


class TestTheWayThere:
    HELPER = """
    class Motor:
        def __init__(self, client):
            self.client = client

        def enable(self):
            return self.client.call(SetBool.Request(), timeout_sec=1.0)  # here

"""

    def test_every_hop_is_listed_in_order(self, judge: Judge):
        [found] = judge(
            "SRV003",
            gripper(["Motor(self.motor).enable()", "return response"], extra=self.HELPER),
        )

        assert [related.message for related in found.related] == [
            "Gripper.close handles the service 'close_gripper'",
            "Gripper.close calls Motor.enable here",
            "the client is created here",
            "a single-threaded executor spins the node",
        ]

    def test_a_function_that_is_handed_over(self, judge: Judge):
        judge(
            "SRV003",
            """
            from functools import partial

            import rclpy
            from std_srvs.srv import Trigger


            def relay(client, request, response):
                return client.call(request)  # here


            def main():
                rclpy.init()
                node = rclpy.create_node('relay')
                client = node.create_client(Trigger, 'far')
                node.create_service(Trigger, 'near', partial(relay, client))
                rclpy.spin(node)


            if __name__ == '__main__':
                main()
            """,
        )

    def test_a_lambda(self, judge: Judge):
        judge(
            "SRV003",
            """
            import rclpy
            from std_srvs.srv import Trigger


            def main():
                rclpy.init()
                node = rclpy.create_node('relay')
                client = node.create_client(Trigger, 'far')
                node.create_service(Trigger, 'near', lambda request, response: client.call(request))  # here
                rclpy.spin(node)


            if __name__ == '__main__':
                main()
            """,
        )

    def test_an_inherited_method(self, judge: Judge):
        [found] = judge(
            "SRV003",
            """
            import rclpy
            from rclpy.node import Node
            from std_srvs.srv import Trigger


            class Base(Node):
                def ask(self):
                    return self.far.call(Trigger.Request())  # here


            class Relay(Base):
                def __init__(self):
                    super().__init__('relay')
                    self.far = self.create_client(Trigger, 'far')
                    self.create_service(Trigger, 'near', self.on_near)

                def on_near(self, request, response):
                    return self.ask()


            def main():
                rclpy.init()
                rclpy.spin(Relay())


            if __name__ == '__main__':
                main()
            """,
        )

        assert found.node == "/relay"

    def test_two_handlers_and_one_call_are_one_finding(self, judge: Judge):
        [found] = judge(
            "SRV003",
            """
            import rclpy
            from rclpy.node import Node
            from std_srvs.srv import Trigger


            class Relay(Node):
                def __init__(self):
                    super().__init__('relay')
                    self.far = self.create_client(Trigger, 'far')
                    self.create_service(Trigger, 'left', self.on_left)
                    self.create_service(Trigger, 'right', self.on_right)

                def on_left(self, request, response):
                    return self.ask()

                def on_right(self, request, response):
                    return self.ask()

                def ask(self):
                    return self.far.call(Trigger.Request())  # here


            def main():
                rclpy.init()
                rclpy.spin(Relay())


            if __name__ == '__main__':
                main()
            """,
        )

        assert found.related[-1].message == "Relay.on_right, the handler of the service 'right', gets here too"

    def test_the_same_call_in_a_timer_is_another_rules_matter(self, judge: Judge):
        judge(
            "SRV003",
            """
            import rclpy
            from rclpy.node import Node
            from std_srvs.srv import Trigger


            class Asker(Node):
                def __init__(self):
                    super().__init__('asker')
                    self.far = self.create_client(Trigger, 'far')
                    self.create_timer(1.0, self.ask)

                def ask(self):
                    return self.far.call(Trigger.Request())


            def main():
                rclpy.init()
                rclpy.spin(Asker())


            if __name__ == '__main__':
                main()
            """,
        )


FLAG = ["if {flag}:", "    return response", "try:", "    self.busy = True", *(f"    {line}" for line in CALL)]


@pytest.mark.parametrize(
    ("body", "many"),
    [
        (CALL, True),
        ([line.format(flag="self.busy") for line in FLAG], False),
        ([line.format(flag="self.busy or request is None") for line in FLAG], False),
        ([line.format(flag="self.busy and request is None") for line in FLAG], True),
        (["with self.lock:", "    if self.busy:", "        return response", "    self.busy = True", *CALL], False),
        (["if self.state == 'busy':", "    return response", "self.state = 'busy'", *CALL], False),
        (["if self.state == 'busy':", "    return response", "self.state = 'idle'", *CALL], True),
        (["if self.state != 'idle':", "    return response", "self.state = 'busy'", *CALL], False),
        (["if not self.lock.acquire(blocking=False):", "    return response", *CALL], False),
        (["if not self.lock.acquire(timeout=9.0):", "    return response", *CALL], True),
        ([line.format(flag="self.idle") for line in FLAG], True),  # nothing sets that one
        (["if self.busy:", "    print('busy')", "self.busy = True", *CALL], True),  # and it goes on
    ],
)
def test_a_handler_that_refuses_a_second_request(judge: Judge, body: list[str], many: bool):
    free = ", callback_group=self.free"
    ends = ["finally:", "    self.busy = False"] if "try:" in body else []
    (told,) = judge("SRV003", gripper([*body, *ends], THREADS, free, free))
    assert ("simultaneous requests" in told.message) is many
    assert many or told.message.endswith("its own caller waits, and one thread is blocked")
