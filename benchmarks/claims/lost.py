"""TMO002: what becomes of a call whose answer never comes, and of what its page says to write in its place?"""

from __future__ import annotations

from collections.abc import Iterator

from benchmarks.claims.model import Claim, Judged, main
from benchmarks.executors.cells import IMPORTS
from benchmarks.executors.running import Said

ENDS, HANGS = "goes on", "waits forever"

_LOST = """

class Lost(Node):
    def __init__(self):
        super().__init__('lost')
        group = ReentrantCallbackGroup()
        self.create_service(Trigger, 'lost', self.serve, callback_group=group)
        ActionServer(self, Fibonacci, 'lost_action', self.execute, callback_group=group)

    def serve(self, request, response):
        time.sleep(60.0)
        return response

    def execute(self, goal):
        time.sleep(60.0)
        return Fibonacci.Result()
"""
_ASK = "asker = Node('asker')\nclient = asker.create_client(Trigger, 'lost')\nclient.wait_for_service()\n"
_GOAL = "asker = Node('asker')\nactions = ActionClient(asker, Fibonacci, 'lost_action')\nactions.wait_for_server()\n"
_SPINNER = "threading.Thread(target=rclpy.spin, args=(asker,), daemon=True).start()\n"
_SENT = "future = client.call_async(Trigger.Request())\n"
FORMS = {
    "call": f"{_ASK}{_SPINNER}print('asks')\nclient.call(Trigger.Request())",
    "call_in_try": f"{_ASK}{_SPINNER}print('asks')\ntry:\n    client.call(Trigger.Request())\n"
    "except Exception as error:\n    print(error)",
    "call_limit": f"{_ASK}{_SPINNER}print('asks')\ntry:\n    client.call(Trigger.Request(), timeout_sec=0.5)\n"
    "except TimeoutError:\n    pass",
    "call_none": f"{_ASK}{_SPINNER}print('asks')\nclient.call(Trigger.Request(), timeout_sec=None)",
    "goal": f"{_GOAL}{_SPINNER}print('asks')\nactions.send_goal(Fibonacci.Goal())",
    "event": f"{_ASK}{_SPINNER}print('asks')\n{_SENT}came = threading.Event()\n"
    "future.add_done_callback(lambda _: came.set())\ncame.wait(timeout=0.5)",
    "script": f"{_ASK}print('asks')\n{_SENT}rclpy.spin_until_future_complete(asker, future, timeout_sec=0.5)",
    "executor": f"{_ASK}executor = SingleThreadedExecutor()\nexecutor.add_node(asker)\nprint('asks')\n{_SENT}"
    "executor.spin_until_future_complete(future, timeout_sec=0.5)",
    "done": f"{_ASK}{_SPINNER}print('asks')\n{_SENT}future.add_done_callback(print)",
}


def claims() -> Iterator[Claim]:
    for form in FORMS:
        yield Claim("TMO002", form, "server that never answers")


def source(claim: Claim) -> str:
    lost = "executor_of_lost = MultiThreadedExecutor(num_threads=8)\nexecutor_of_lost.add_node(Lost())\n"
    lost += "threading.Thread(target=executor_of_lost.spin, daemon=True).start()\n"
    return IMPORTS + _LOST + main(lost + FORMS[claim.form] + "\nprint('answered')")


def outcome(claim: Claim, said: Said) -> str:
    words = [word for _, word in said]
    if "asks" not in words:
        return "never asked"
    raised = next((word.split(":")[0] for word in words if word.startswith("raised")), None)
    return raised or (ENDS if "answered" in words else HANGS)


JUDGED = Judged("TMO002", claims, source, outcome, frozenset({HANGS}), seconds=2.5)
