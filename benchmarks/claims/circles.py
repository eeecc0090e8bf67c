"""SRV006: does a circle of service handlers ever answer?"""

from __future__ import annotations

import re
from collections.abc import Iterator

from benchmarks.claims.model import Claim, Judged, main, method
from benchmarks.executors.cells import IMPORTS, MADE
from benchmarks.executors.running import Said

GOOD, LATE, NEVER, FAILS = "answers", "answers, without having been answered", "never answers", "a handler raises"

STUCK = "a single wait hangs"
"""Without a circle: of that other rules speak."""

FORMS = {
    "call": "answer = self.next.call(Trigger.Request())",
    "call_limit": "answer = self.next.call(Trigger.Request(), timeout_sec=0.4)",
    "await": "answer = await self.next.call_async(Trigger.Request())",
    "loop": "future = self.next.call_async(Trigger.Request())\nwhile not future.done():\n    time.sleep(0.01)\n"
    "answer = future.result()",
    "event_limit": "came = threading.Event()\nfuture = self.next.call_async(Trigger.Request())\n"
    "future.add_done_callback(lambda _: came.set())\ncame.wait(timeout=0.4)\nanswer = future.result()",
    "only_sent": "self.next.call_async(Trigger.Request())\nanswer = None",
    "one_only_sent": "answer = self.next.call(Trigger.Request())",
    "one_publishes": "answer = self.next.call(Trigger.Request())",
    "open": "answer = self.next.call(Trigger.Request())",
}
_NO_CIRCLE = ("one_only_sent", "one_publishes", "open")
SIZES = (1, 2, 3)
_GROUPS = {"apart": "self.two", "default": "None", "reentrant": "self.many"}
_SPUN = {"multi4": "MultiThreadedExecutor(num_threads=4)", "single": "SingleThreadedExecutor()"}


def claims() -> Iterator[Claim]:
    for form in FORMS:
        for size in SIZES:
            for executor in _SPUN:
                for groups in _GROUPS:
                    if form in _NO_CIRCLE and (size == 1 or groups == "default"):
                        continue
                    yield Claim("SRV006", form, f"{size} nodes", executor, groups)


def source(claim: Claim) -> str:
    size = int(claim.handler[0])
    text = IMPORTS
    for number in range(size):
        text += _node(claim, number, size)
    nodes = "".join(
        f"node{number} = Node{number}()\nexecutor{number} = {_SPUN[claim.executor]}\n"
        f"executor{number}.add_node(node{number})\n"
        f"threading.Thread(target=executor{number}.spin, daemon=True).start()\n"
        for number in range(size)
    )
    ask = (
        f"asker = Node('asker')\nclient = asker.create_client(Trigger, '{_part(claim, 0)}')\n"
        "client.wait_for_service(timeout_sec=5.0)\ntime.sleep(0.3)\n"
        "print('asks')\nfuture = client.call_async(Trigger.Request())\n"
        "rclpy.spin_until_future_complete(asker, future, timeout_sec=3.0)\n"
        "if future.done():\n    print('answered' if future.result().success else 'nothing')\n"
        "print('says over')\n"
    )
    return text + main(nodes + ask)


def _part(claim: Claim, number: int) -> str:
    """A service's name; of its own for each program, since archlint sees all of them as one workspace."""
    return re.sub(r"\W", "_", f"{claim.form}_{claim.executor}_{claim.groups}_{claim.handler}_{number}")


def _node(claim: Claim, number: int, size: int) -> str:
    last = number == size - 1
    group = _GROUPS[claim.groups]
    made = "".join(MADE[name] for name in ("two", "many") if f"self.{name}" == group)
    own = group if claim.groups == "reentrant" else "None"
    wait = FORMS[claim.form]
    if last and claim.form == "one_only_sent":
        wait = FORMS["only_sent"].replace("None", "True")
    if last and claim.form in ("one_publishes", "open"):
        wait = "answer = Trigger.Response(success=True)"
    body = f"{wait}\nresponse.success = bool(answer and getattr(answer, 'success', True))\nreturn response"
    following = _part(claim, (number + 1) % size)
    client = f"self.next = self.create_client(Trigger, '{following}', callback_group={group})\n"
    constructor = f"super().__init__('node{number}')\n{made}{client}"
    constructor += f"self.create_service(Trigger, '{_part(claim, number)}', self.serve, callback_group={own})"
    return (
        f"\n\nclass Node{number}(Node):\n"
        + method("__init__(self)", constructor)
        + method("serve(self, request, response)", body, coroutine=claim.form == "await")
    )


def outcome(claim: Claim, said: Said) -> str:
    words = [word for _, word in said]
    if "asks" not in words:
        return "never asked"
    if any(word.startswith("raised") for word in words):
        return FAILS
    if "answered" in words:
        return GOOD
    if claim.form in _NO_CIRCLE:
        return STUCK
    return LATE if "nothing" in words and claim.form != "only_sent" else GOOD if "nothing" in words else NEVER


JUDGED = Judged("SRV006", claims, source, outcome, frozenset({NEVER, LATE, FAILS}), seconds=4.0)
