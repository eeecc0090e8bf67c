"""Waits whose outcome was not what one would think: each was tried on a real rclpy (benchmarks/executors)."""

from __future__ import annotations

import pytest

from archlint.execution.blocking import LIMITED_STEAL, ONE, OTHER, REENTRANT, SAME, SPIN, STEAL, Outcome, look_up
from checks.callbacks import ON_SEVERAL_THREADS, Run, codes, source

CLIENT = "self.client = self.create_client(Trigger, 'check')\n"
CALL = "answer = self.client.call(Trigger.Request(), timeout_sec=1.0)\nprint(answer)"
OWN_EXECUTOR = """
def main():
    rclpy.init()
    executor = SingleThreadedExecutor()
    executor.add_node(Robot())
    executor.spin()


if __name__ == '__main__':
    main()
"""


def method(signature: str, body: str) -> str:
    lines = "\n".join(f"    {line}" for line in body.splitlines())
    return f"def {signature}:\n{lines}\n"


def test_the_callback_of_a_guard_condition_is_in_the_group_it_is_given(run: Run):
    made = CLIENT + "self.guard = self.create_guard_condition(self.check{})"
    text = source(made.format(""), method("check(self)", CALL), ON_SEVERAL_THREADS)
    (found,) = run(text, "jazzy")
    assert found.code == "CBG001"
    assert "self.client.call(" in text.splitlines()[found.place.line - 1]
    apart = made.format(", callback_group=MutuallyExclusiveCallbackGroup()")
    assert run(source(apart, method("check(self)", CALL), ON_SEVERAL_THREADS), "jazzy") == []


def test_a_parameter_callback_is_in_the_default_group(run: Run):
    body = f"{CALL}\nreturn SetParametersResult(successful=True)"
    register = "self.add_on_set_parameters_callback(self.on_set)"
    text = source(CLIENT + register, method("on_set(self, parameters)", body), ON_SEVERAL_THREADS)
    imported = "from rcl_interfaces.msg import SetParametersResult\n"
    assert codes(run(imported + text, "jazzy")) == ["CBG001"]
    apart = text.replace("'check')", "'check', callback_group=MutuallyExclusiveCallbackGroup())")
    assert run(imported + apart, "jazzy") == []


def test_a_task_holds_the_one_thread_of_the_executor_that_runs_it(run: Run):
    made = CLIENT + "self.timer = self.create_timer(1.0, self.tick)"
    tick = method("tick(self)", "self.executor.create_task(self.check)")
    (found,) = run(source(made, tick + method("check(self)", CALL), OWN_EXECUTOR), "jazzy")
    assert found.code == "EXE002"
    assert "the executor's only thread is blocked" in found.message
    assert run(source(made, tick + method("check(self)", CALL), ON_SEVERAL_THREADS), "jazzy") == []


def test_a_service_handler_that_waits_for_an_event_that_it_keeps_out(run: Run):
    made = """
        self.came = threading.Event()
        self.create_subscription(Empty, 'go', self.on_go, 10{})
        self.create_service(Trigger, 'wait', self.serve)
    """
    serve = method("serve(self, request, response)", "self.came.wait()\nreturn response")
    body = method("on_go(self, message)", "self.came.set()") + serve
    (found,) = run(source(made.format(""), body))
    assert found.code == "EXE002"
    assert "the handler of the service 'wait' waits for an event" in found.message
    apart = made.format(", callback_group=MutuallyExclusiveCallbackGroup()")
    assert run(source(apart, body, ON_SEVERAL_THREADS)) == []


@pytest.mark.parametrize(("group", "ends"), [("", "deadlocks"), ("ReentrantCallbackGroup()", "takes the node")])
def test_a_spin_on_an_executor_made_for_it(run: Run, group: str, ends: str):
    groups = f", callback_group={group}" if group else ""
    made = f"""
        self.client = self.create_client(Trigger, 'check'{groups})
        self.create_subscription(Empty, 'go', self.on_go, 10)
    """
    body = """\
future = self.client.call_async(Trigger.Request())
rclpy.spin_until_future_complete(self, future, executor=SingleThreadedExecutor())
"""
    found = [one for one in run(source(made, method("on_go(self, message)", body))) if one.code == "EXE001"]
    assert len(found) == 1
    assert f"its node is spun by another executor: this {ends}" in found[0].message


def test_a_stolen_node_hangs_where_its_own_group_keeps_the_answer_out():
    assert set(look_up(STEAL, ONE, SAME, "").outcomes.values()) == {Outcome.HANGS}
    assert set(look_up(STEAL, ONE, REENTRANT, "").outcomes.values()) == {Outcome.STRANDS}
    assert set(look_up(LIMITED_STEAL, ONE, SAME, "").outcomes.values()) == {Outcome.STRANDS}


def test_the_first_releases_let_a_nested_spin_in():
    nested = look_up(SPIN, ONE, OTHER, "", ["jazzy"])
    assert nested.words == "raises 'Executor is already spinning' (works before rclpy 7.1.9)"
    everywhere = look_up(SPIN, ONE, SAME, "").words
    assert everywhere.startswith("deadlocks in humble and raises 'Executor is already spinning' from jazzy on")
    assert everywhere.endswith("(deadlocks in jazzy before rclpy 7.1.9 and kilted before rclpy 9.1.5)")
    assert "before" not in look_up(SPIN, ONE, SAME, "", ["humble"]).words


SPIN_HERE = """
future = self.client.call_async(Trigger.Request())
rclpy.spin_until_future_complete(self, future, executor=self.executor)
"""


@pytest.mark.parametrize(
    ("executor", "before", "with_a_limit"),
    [
        ("SingleThreadedExecutor()", "works", "works"),
        (
            "MultiThreadedExecutor(num_threads=4)",
            "sometimes deadlocks or raises ValueError",
            "sometimes times out or raises ValueError",
        ),
        (
            "MultiThreadedExecutor()",
            "sometimes deadlocks or raises ValueError",
            "sometimes times out or raises ValueError",
        ),
        ("MultiThreadedExecutor(num_threads=1)", "deadlocks", "always times out"),
    ],
)
def test_a_nested_spin_of_an_executor_with_several_threads(run: Run, executor: str, before: str, with_a_limit: str):
    made = """
        self.client = self.create_client(Trigger, 'check', callback_group=MutuallyExclusiveCallbackGroup())
        self.create_subscription(Empty, 'go', self.on_go, 10)
    """
    main = OWN_EXECUTOR.replace("SingleThreadedExecutor()", executor)
    (found,) = run(source(made, method("on_go(self, message)", SPIN_HERE), main), "jazzy")
    assert found.code == "EXE001"
    assert found.message.endswith(f"this raises 'Executor is already spinning' ({before} before rclpy 7.1.9)")
    limited = SPIN_HERE.replace("executor=", "timeout_sec=1.0, executor=")
    (found,) = run(source(made, method("on_go(self, message)", limited), main), "humble")
    assert found.message.endswith(f"this {with_a_limit}")


def test_a_nested_spin_with_several_threads_and_an_action_client(run: Run):
    made = """
        self.client = self.create_client(Trigger, 'check', callback_group=MutuallyExclusiveCallbackGroup())
        self.actions = ActionClient(self, Fibonacci, 'count')
        self.create_subscription(Empty, 'go', self.on_go, 10)
    """
    main = OWN_EXECUTOR.replace("SingleThreadedExecutor()", "MultiThreadedExecutor(num_threads=4)")
    (found,) = run(source(made, method("on_go(self, message)", SPIN_HERE), main), "jazzy")
    assert found.message.endswith("(sometimes deadlocks or raises RCLError or ValueError before rclpy 7.1.9)")
    (found,) = run(source(made, method("on_go(self, message)", SPIN_HERE), OWN_EXECUTOR), "jazzy")
    assert found.message.endswith("(works before rclpy 7.1.9)")


def test_a_rate_may_also_not_sleep_at_all(run: Run):
    made = "self.rate = self.create_rate(10.0)\nself.create_subscription(Empty, 'go', self.on_go, 10)"
    (once,) = run(source(made, method("on_go(self, message)", "self.rate.sleep()")))
    assert once.code == "EXE004"
    assert once.message.endswith("; if the timer has already fired, it does not sleep at all")
    (looped,) = run(source(made, method("on_go(self, message)", "for _ in range(9):\n    self.rate.sleep()")))
    assert looped.message.endswith("needs the thread that is sleeping")
