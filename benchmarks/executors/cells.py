"""The cells of the matrix, and the program of each.

A cell is how a callback waits, which callback it is, who spins the node, and which callback groups callback and client
are in.
A program says ``asks`` before a wait, and ``answered`` or ``nothing`` after it.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from textwrap import dedent, indent

LIMIT_S = 0.5
"""Of the waits that have a limit."""
PERIOD_S = 0.2
"""Of the timers, and of what comes from outside."""


@dataclass(frozen=True, order=True)
class Cell:
    """One program: ``wait`` of :data:`WAITS`, ``handler`` of :data:`HANDLERS`, and so on.

    ``latency`` is how long the server takes, in seconds.
    """

    wait: str
    handler: str
    executor: str
    groups: str
    latency: float = 0.0

    @property
    def name(self) -> str:
        slow = f"-{self.latency:g}s" if self.latency else ""
        return f"{self.wait}-{self.handler}-{self.executor}-{self.groups}{slow}"


_SENT = "future = self.client.call_async(Trigger.Request())\n"
_GOOD = "answer = future.result()\n"
_SPIN = "rclpy.spin_until_future_complete"

WAITS = {
    "call": "answer = self.client.call(Trigger.Request())\n",
    "call_limit": f"answer = self.client.call(Trigger.Request(), timeout_sec={LIMIT_S})\n",
    "await": "answer = await self.client.call_async(Trigger.Request())\n",
    "loop": f"{_SENT}while not future.done():\n    time.sleep(0.01)\n{_GOOD}",
    "loop_limit": f"{_SENT}end = time.monotonic() + {LIMIT_S}\n"
    f"while not future.done() and time.monotonic() < end:\n    time.sleep(0.01)\n{_GOOD}",
    "event": f"came = threading.Event()\n{_SENT}future.add_done_callback(lambda _: came.set())\ncame.wait()\n{_GOOD}",
    "event_limit": "came = threading.Event()\n"
    f"{_SENT}future.add_done_callback(lambda _: came.set())\ncame.wait(timeout={LIMIT_S})\n{_GOOD}",
    "spin": f"{_SENT}{_SPIN}(self, future)\n{_GOOD}",
    "spin_limit": f"{_SENT}{_SPIN}(self, future, timeout_sec={LIMIT_S})\n{_GOOD}",
    "spin_here": f"{_SENT}{_SPIN}(self, future, executor=self.executor)\n{_GOOD}",
    "spin_here_limit": f"{_SENT}{_SPIN}(self, future, executor=self.executor, timeout_sec={LIMIT_S})\n{_GOOD}",
    "spin_fresh": f"{_SENT}{_SPIN}(self, future, executor=SingleThreadedExecutor())\n{_GOOD}",
    "spin_helper": f"future = self.helpers_client.call_async(Trigger.Request())\n{_SPIN}(self.helper, future)\n{_GOOD}",
    "spin_once": "end = time.monotonic() + 0.1\nrclpy.spin_once(self, timeout_sec=0.1)\n"
    "answer = time.monotonic() < end\n",
    "result": f"{_SENT}{_GOOD}",
    "rate": "self.rate.sleep()\nanswer = True\n",
    "rate_twice": "self.rate.sleep()\nself.rate.sleep()\nanswer = True\n",
    "slow_rate": "self.rate.sleep()\nanswer = True\n",
    "goal": "answer = self.actions.send_goal(Fibonacci.Goal(order=1))\n",
    "await_goal": "goal = await self.actions.send_goal_async(Fibonacci.Goal(order=1))\n"
    "answer = await goal.get_result_async()\n",
    "message": "self.came.clear()\nself.came.wait()\nanswer = True\n",
    "message_limit": f"self.came.clear()\nanswer = self.came.wait(timeout={LIMIT_S})\n",
    "server": f"answer = self.client.wait_for_service(timeout_sec={LIMIT_S})\n",
    "done": f"{_SENT}future.add_done_callback(self.on_answer)\nreturn_\n",
}
"""How a callback waits; ``server`` and ``done`` do no harm anywhere."""

_CLIENT = "self.client = self.create_client(Trigger, 'inner', callback_group={client})\n"
_SERVER_IS_THERE = "self.client.wait_for_service(timeout_sec=10.0)\n"
_GIVEN_TO = {
    "slow_rate": "self.rate = self.create_rate(2.0)\n",
    "rate": "self.rate = self.create_rate(20.0)\n",
    "goal": "self.actions = ActionClient(self, Fibonacci, 'inner_action', callback_group={client})\n"
    "self.actions.wait_for_server(timeout_sec=10.0)\n",
    "message": "self.came = threading.Event()\n"
    "self.create_subscription(String, 'go', self.on_message, 10, callback_group={client})\n",
    "spin_helper": "self.helper = Node('helper')\n"
    "self.helpers_client = self.helper.create_client(Trigger, 'inner')\n"
    "self.helpers_client.wait_for_service(timeout_sec=10.0)\n",
}

HANDLERS = {
    "service": "self.create_service(Trigger, 'outer', self.on_event, callback_group={own})",
    "timer": f"self.create_timer({PERIOD_S}, self.on_event, callback_group={{own}})",
    "timers": f"self.create_timer({PERIOD_S}, self.on_event, callback_group={{own}})\n"
    f"self.create_timer({PERIOD_S}, self.on_event, callback_group=self.three)",
    "subscription": "self.create_subscription(String, 'go', self.on_event, 10, callback_group={own})",
    "execute": "ActionServer(self, Fibonacci, 'outer_action', self.on_event, callback_group={own})",
    "goal": "ActionServer(self, Fibonacci, 'outer_action', self.execute, goal_callback=self.on_event, "
    "callback_group={own})",
    "accepted": "ActionServer(self, Fibonacci, 'outer_action', self.execute, handle_accepted_callback=self.on_event, "
    "callback_group={own})",
    "guard": f"self.guard = self.create_guard_condition(self.on_event, callback_group={{own}})\n"
    f"self.create_timer({PERIOD_S}, self.guard.trigger)",
    "done": "self.first = self.create_client(Trigger, 'inner')\n"
    f"self.create_timer({PERIOD_S}, lambda: self.first.call_async(Trigger.Request()).add_done_callback(self.on_event))",
    "task": f"self.create_timer({PERIOD_S}, lambda: self.executor.create_task(self.on_event))",
    "parameter": "self.declare_parameter('speed', 0)\nself.add_on_set_parameters_callback(self.on_event)",
    "feedback": "self.goals = ActionClient(self, Fibonacci, 'inner_action', callback_group={own})\n"
    "self.goals.wait_for_server(timeout_sec=10.0)\n"
    f"self.create_timer({PERIOD_S}, self.send)",
}
"""Which callback it is; ``timers`` are two, in groups of their own."""
_NOBODYS = ("rate", "rate_twice", "slow_rate", "spin_helper")
"""Waits that have nothing in the client's group."""
_IN_NO_GROUP = ("done", "task", "parameter")
"""Handlers that are given no group."""
ARGUMENTS = {"service": ", request, response", "timer": "", "timers": "", "guard": "", "task": ""}
RETURNS = {
    "service": "return response",
    "execute": "given.succeed()\nreturn Fibonacci.Result()",
    "goal": "return GoalResponse.ACCEPT",
    "accepted": "given.execute()\nreturn",
    "parameter": "return SetParametersResult(successful=True)",
}

_OWN = "executor = {}\nexecutor.add_node(node)\nexecutor.spin()"
EXECUTORS = {
    "spin": "rclpy.spin(node)",
    "single": _OWN.format("SingleThreadedExecutor()"),
    "multi2": _OWN.format("MultiThreadedExecutor(num_threads=2)"),
    "multi4": _OWN.format("MultiThreadedExecutor(num_threads=4)"),
    "multi1": _OWN.format("MultiThreadedExecutor(num_threads=1)"),
    "spin_multi": "rclpy.spin(node, executor=MultiThreadedExecutor(num_threads=4))",
    "once": "while rclpy.ok():\n    rclpy.spin_once(node)",
    "thread": "executor = SingleThreadedExecutor()\nexecutor.add_node(node)\n"
    "spinner = threading.Thread(target=executor.spin, daemon=True)\nspinner.start()\nspinner.join()",
}
"""Who spins the node.  An EventsExecutor of the wheels runs no callback, and is not among them."""

GROUPS = {
    "default": (None, None),
    "same": ("one", "one"),
    "apart": ("one", "two"),
    "client_apart": (None, "two"),
    "callback_apart": ("one", None),
    "reentrant": ("many", "many"),
    "client_reentrant": (None, "many"),
    "callback_reentrant": ("many", None),
    "two_reentrant": ("many", "more"),
}
"""The groups of the callback and of the client; None is the node's default group."""
MADE = {
    "one": "self.one = MutuallyExclusiveCallbackGroup()\n",
    "three": "self.three = MutuallyExclusiveCallbackGroup()\n",
    "two": "self.two = MutuallyExclusiveCallbackGroup()\n",
    "many": "self.many = ReentrantCallbackGroup()\n",
    "more": "self.more = ReentrantCallbackGroup()\n",
}

IMPORTS = """\
import threading
import time

import rclpy
from rcl_interfaces.msg import SetParametersResult
from rclpy.action import ActionClient, ActionServer, GoalResponse
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Trigger
from test_msgs.action import Fibonacci
"""


def program(cell: Cell) -> str:
    """The source of a cell's program."""
    return (
        f"{IMPORTS}\n\nclass Asker(Node):\n"
        + _method("__init__(self)", f"super().__init__('asker')\n{_constructor(cell)}")
        + _method(f"on_event(self{ARGUMENTS.get(cell.handler, ', given')})", _callback(cell), "await" in cell.wait)
        + "".join(_method(signature, body) for signature, body in _further(cell))
        + f"\ndef main():\n    rclpy.init()\n    node = Asker()\n{indent(EXECUTORS[cell.executor], '    ')}\n"
        + "\n\nif __name__ == '__main__':\n    main()\n"
    )


_PARTNERS = {
    "service": ("self.sender = self.create_client(Trigger, 'outer')", "self.sender.call_async(Trigger.Request())"),
    "subscription": (
        "self.sender = self.create_publisher(String, 'go', 10)",
        "self.sender.publish(String(data='go'))",
    ),
    "execute": (
        "self.sender = ActionClient(self, Fibonacci, 'outer_action')",
        "self.sender.send_goal_async(Fibonacci.Goal())",
    ),
}
"""What the other end of a program sends, and how it is made; ``other_end.py`` does the same."""


def partner(cell: Cell) -> str:
    """The source of the other end as archlint may read it; empty where it is not about how often something comes."""
    if cell.handler not in _PARTNERS:
        return ""
    made, sends = _PARTNERS[cell.handler]
    constructor = f"super().__init__('other')\n{made}\nself.create_timer({PERIOD_S}, self.send)\n"
    return (
        f"{IMPORTS}\n\nclass Other(Node):\n"
        + _method("__init__(self)", constructor)
        + _method("send(self)", sends)
        + "\ndef main():\n    rclpy.init()\n    rclpy.spin(Other())\n\n\nif __name__ == '__main__':\n    main()\n"
    )


def _method(signature: str, body: str, coroutine: bool = False) -> str:
    return f"    {'async ' if coroutine else ''}def {signature}:\n{indent(dedent(body).rstrip(), ' ' * 8)}\n\n"


def _constructor(cell: Cell) -> str:
    own, client = GROUPS[cell.groups]
    given = next((text for word, text in _GIVEN_TO.items() if word in cell.wait), "")
    client_made = "" if given else _CLIENT + _SERVER_IS_THERE
    text = (client_made + given + HANDLERS[cell.handler]).format(own=_group(own), client=_group(client))
    return "".join(made for name, made in MADE.items() if f"self.{name})" in text or f"self.{name}," in text) + text


def _group(name: str | None) -> str:
    return "None" if name is None else f"self.{name}"


def _callback(cell: Cell) -> str:
    returns = RETURNS.get(cell.handler, "return")
    body = f"print('asks')\n{WAITS[cell.wait]}"
    if cell.wait == "done":
        return body.replace("return_", returns)
    return f"{body}print('answered' if answer else 'nothing')\n{returns}\n"


def _further(cell: Cell) -> Iterator[tuple[str, str]]:
    if cell.handler in ("goal", "accepted"):
        yield "execute(self, goal)", "goal.succeed()\nreturn Fibonacci.Result()"
    if cell.handler == "feedback":
        yield "send(self)", "self.goals.send_goal_async(Fibonacci.Goal(), feedback_callback=self.on_event)"
    if "message" in cell.wait:
        yield "on_message(self, message)", "self.came.set()"
    if cell.wait == "done":
        yield "on_answer(self, future)", "print('answered' if future.result() else 'nothing')"


def makes_sense(cell: Cell) -> bool:
    """Whether a program says what its cell says."""
    own, client = GROUPS[cell.groups]
    if cell.handler in _IN_NO_GROUP and own is not None:
        return False
    if cell.wait in _NOBODYS and client is not None and cell.groups != "same":
        return False  # nothing is in the client's group
    if cell.wait.startswith("await") and cell.handler == "parameter":
        return False  # rclpy does not await it
    if cell.latency > LIMIT_S and cell.wait.endswith("limit"):
        return False  # the server is slower than the wait is long
    return not (cell.wait.startswith("spin_here") and cell.executor == "once")


_EVERYWHERE = ("service", "timer", "subscription")
_MAIN_EXECUTORS = ("spin", "single", "multi2", "multi4")
_KEEPING = ("call", "call_limit", "loop", "loop_limit", "event", "event_limit")
"""Waits that keep their thread."""
_MAIN_GROUPS = ("default", "same", "apart", "client_apart", "reentrant", "client_reentrant")
_FEW_GROUPS = ("default", "apart", "reentrant")


def all_cells() -> list[Cell]:
    """Every cell that is tried, in order."""
    rare = tuple(handler for handler in HANDLERS if handler not in (*_EVERYWHERE, "timers"))
    some = ("call", "call_limit", "await", "loop", "event", "spin", "spin_here", "result", "rate_twice", "message")
    blocks: list[tuple[Iterable[str], ...]] = [
        (WAITS, _EVERYWHERE, _MAIN_EXECUTORS, _MAIN_GROUPS, (0.0,)),
        (WAITS, ("timer",), _MAIN_EXECUTORS, GROUPS, (0.0,)),
        (some, rare, ("spin", "single", "multi4"), ("default", "client_apart", "reentrant"), (0.0,)),
        ((*some, "goal"), ("service", "timer"), ("multi1", "spin_multi", "once", "thread"), _FEW_GROUPS, (0.0,)),
        # Whether threads are left for the answers: two callbacks, or one that may run beside itself and a slow server.
        (_KEEPING, ("timers",), ("multi2", "multi4"), ("apart", "client_apart", "reentrant"), (0.0,)),
        (
            (*_KEEPING, "await", "done"),
            ("timer", "subscription", "service", "execute"),
            ("multi2", "multi4"),
            ("client_apart", "reentrant", "callback_reentrant"),
            (0.1, 0.3, 1.5),
        ),
    ]
    cells = {Cell(*words) for block in blocks for words in itertools.product(*block)}
    return sorted(filter(makes_sense, cells))
