"""EXE008: does a callback of the node ever run?"""

from __future__ import annotations

from collections.abc import Iterator

from benchmarks.claims.model import Claim, Judged, main, method, words
from benchmarks.executors.cells import ARGUMENTS, HANDLERS, IMPORTS, RETURNS
from benchmarks.executors.running import Said

RUNS, NEVER = "runs", "never runs"

_PARTNER = "other = Node('partner')\nother.create_timer(0.2, lambda: print('says partner'))\n"
_ALIVE = "while rclpy.ok():\n    time.sleep(0.1)\n"
FORMS = {
    "spin": "node = Asker()\nrclpy.spin(node)",
    "nothing": f"node = Asker()\n{_ALIVE}",
    "spin_once_loop": "node = Asker()\nwhile rclpy.ok():\n    rclpy.spin_once(node, timeout_sec=0.1)",
    "executor": "node = Asker()\nexecutor = SingleThreadedExecutor()\nexecutor.add_node(node)\nexecutor.spin()",
    "executor_once_loop": "node = Asker()\nexecutor = SingleThreadedExecutor()\nexecutor.add_node(node)\n"
    "while rclpy.ok():\n    executor.spin_once(timeout_sec=0.1)",
    "executor_idle": f"node = Asker()\nexecutor = SingleThreadedExecutor()\nexecutor.add_node(node)\n{_ALIVE}",
    "executor_empty": "node = Asker()\nexecutor = SingleThreadedExecutor()\nwhile rclpy.ok():\n"
    "    executor.spin_once(timeout_sec=0.1)\nprint(node)",
    "executor_given": "node = Asker()\nrclpy.spin(node, executor=MultiThreadedExecutor())",
    "executor_removed": "node = Asker()\nexecutor = SingleThreadedExecutor()\nexecutor.add_node(node)\n"
    "executor.remove_node(node)\nwhile rclpy.ok():\n    executor.spin_once(timeout_sec=0.1)",
    "thread": "node = Asker()\nspinner = threading.Thread(target=rclpy.spin, args=(node,), daemon=True)\n"
    f"spinner.start()\n{_ALIVE}",
    "thread_not_started": "node = Asker()\nspinner = threading.Thread(target=rclpy.spin, args=(node,), daemon=True)\n"
    f"{_ALIVE}print(spinner)",
    "thread_executor": "node = Asker()\nexecutor = SingleThreadedExecutor()\nexecutor.add_node(node)\n"
    f"spinner = threading.Thread(target=executor.spin, daemon=True)\nspinner.start()\n{_ALIVE}",
    "other_spun": f"node = Asker()\n{_PARTNER}rclpy.spin(other)\nprint(node)",
    "second_spin": f"node = Asker()\n{_PARTNER}rclpy.spin(other)\nrclpy.spin(node)",
    "both_added": f"node = Asker()\n{_PARTNER}executor = SingleThreadedExecutor()\nexecutor.add_node(node)\n"
    "executor.add_node(other)\nexecutor.spin()",
    "one_added": f"node = Asker()\n{_PARTNER}executor = SingleThreadedExecutor()\n"
    "executor.add_node(other)\nexecutor.spin()\nprint(node)",
    "both_once": f"node = Asker()\n{_PARTNER}while rclpy.ok():\n    rclpy.spin_once(node, timeout_sec=0.1)\n"
    "    rclpy.spin_once(other, timeout_sec=0.1)",
    "in_constructor": f"node = SpinsItself()\n{_ALIVE}",
    "constructor_waits": f"node = WaitsForAnswer()\n{_ALIVE}",
    "constructor_first": f"node = SpinsFirst()\n{_ALIVE}",
    "until_answer": "node = Asker()\nclient = node.create_client(Trigger, 'absent')\n"
    "future = client.call_async(Trigger.Request())\nrclpy.spin_until_future_complete(node, future)",
    "future_elsewhere": f"node = Asker()\n{_PARTNER}client = other.create_client(Trigger, 'absent')\n"
    "future = client.call_async(Trigger.Request())\nrclpy.spin_until_future_complete(other, future)\nprint(node)",
    "add_returns": "node = Asker()\nexecutor = rclpy.get_global_executor()\nexecutor.add_node(node)\nexecutor.spin()",
}
HANDLED = ("timer", "subscription", "service", "execute")
_SUBCLASSES = """

class SpinsItself(Asker):
    def __init__(self):
        super().__init__()
        rclpy.spin(self)


class WaitsForAnswer(Node):
    def __init__(self):
        super().__init__('asker')
        {registered}
        self.client = self.create_client(Trigger, 'inner')
        self.client.wait_for_service()
        rclpy.spin_until_future_complete(self, self.client.call_async(Trigger.Request()))

{methods}

class SpinsFirst(Node):
    def __init__(self):
        super().__init__('asker')
        rclpy.spin_once(self, timeout_sec=0.1)
        {registered}

{methods}
"""


def claims() -> Iterator[Claim]:
    for form in FORMS:
        for handler in HANDLED:
            yield Claim("EXE008", form, handler)


def source(claim: Claim) -> str:
    registered = HANDLERS[claim.handler].format(own="None")
    body = f"print('says runs')\n{RETURNS.get(claim.handler, 'return')}"
    methods = method(f"on_event(self{ARGUMENTS.get(claim.handler, ', given')})", body)
    asker = f"{IMPORTS}\n\nclass Asker(Node):\n" + method("__init__(self)", f"super().__init__('asker')\n{registered}")
    special = claim.form in ("in_constructor", "constructor_waits", "constructor_first")
    more = _SUBCLASSES.format(registered=registered, methods=methods) if special else ""
    return asker + methods + more + main(FORMS[claim.form])


def needs(claim: Claim) -> list[str]:
    return {"subscription": ["publish"], "execute": ["send_goals"], "service": ["ask"]}.get(claim.handler, [])


def outcome(claim: Claim, said: Said) -> str:
    """A callback that runs a few times while a constructor waits does not count: it has to go on."""
    late = [word for when, word in said if word == "says runs"]
    other = next((word for word in words(said) if word.startswith("raised")), None)
    if other:
        return other.split(":")[0]
    return RUNS if len(late) >= 3 else NEVER


JUDGED = Judged("EXE008", claims, source, outcome, frozenset({NEVER}), needs, seconds=2.0)
