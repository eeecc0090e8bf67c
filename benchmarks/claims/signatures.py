"""EXE006: what happens to a callback that cannot take what rclpy passes, and to its node?"""

from __future__ import annotations

from collections.abc import Iterator

from benchmarks.claims.model import Claim, Judged, method, program, words
from benchmarks.executors.cells import HANDLERS, RETURNS
from benchmarks.executors.running import Said

WORKS, NEVER, ENDS, GOES_ON = "works", "never ran", "raises, and the node ends", "raises, and the node goes on"
REFUSED, NOT_THERE = "refused when it is registered", "nothing to import"

TAKES = {
    "none": "self",
    "one": "self, a",
    "two": "self, a, b",
    "three": "self, a, b, c",
    "any": "self, *given",
    "one_default": "self, a=1",
    "two_default": "self, a, b=1",
    "keyword": "self, a, *, b",
    "info": "self, a, info",
    "timer_info": "self, info: TimerInfo",
    "timer_info_text": "self, info: 'TimerInfo'",
    "partial": "self, a, b",
    "lambda_none": "",
    "lambda_one": "a",
    "missing": "self",
}
_MORE = {
    "cancel": "ActionServer(self, Fibonacci, 'outer_action', self.execute, cancel_callback=self.on_event, "
    "callback_group=ReentrantCallbackGroup())"
}
_MORE["done"] = HANDLERS["done"].replace("self.first = ", "self.first = ")
ROLES = (
    "subscription", "service", "timer", "guard", "execute", "goal", "accepted", "cancel", "feedback", "done",
    "parameter", "task",
)  # fmt: skip
_ONLY = {"info": "subscription", "timer_info": "timer", "timer_info_text": "timer"}
_RETURNS = {**RETURNS, "cancel": "return CancelResponse.ACCEPT", "task": "return"}
_ACTIONS = ("execute", "goal", "accepted", "cancel")


def claims() -> Iterator[Claim]:
    for role in ROLES:
        for takes in TAKES:
            if _ONLY.get(takes, role) != role:
                continue
            yield Claim("EXE006", takes, role, "multi4" if role == "cancel" else "spin")
    for role in ("subscription", "service", "timer", "execute"):
        for takes in ("none", "one", "two"):
            yield Claim("EXE006", takes, role, "multi4")


def source(claim: Claim) -> str:
    role = claim.handler
    registered = (HANDLERS | _MORE)[role].format(own="None")
    if claim.form == "partial":
        registered = registered.replace("self.on_event", "partial(self.on_event, 1)")
    if claim.form.startswith("lambda"):
        registered = registered.replace(
            "self.on_event", f"lambda {TAKES[claim.form]}: self.called()".replace(" :", ":")
        )
    answer = _RETURNS.get(role, "return").replace("given.succeed()\n", "").replace("given.execute()\n", "")
    name = "on_other" if claim.form == "missing" else "on_event"
    takes = TAKES[claim.form] if not claim.form.startswith("lambda") else "self"
    methods = method(f"{name}({takes})", f"self.called()\n{answer}")
    methods += method("called(self)", "print('says called')") + method("beat(self)", "print('says beat')")
    if role == "feedback":
        methods += method("send(self)", "self.goals.send_goal_async(Fibonacci.Goal(), feedback_callback=self.on_event)")
    if role in _ACTIONS:
        methods += method("execute(self, goal)", "time.sleep(1.0)\ngoal.succeed()\nreturn Fibonacci.Result()")
    more = "from functools import partial\n\nfrom rclpy.action import CancelResponse\n"
    more += "from rclpy.timer import TimerInfo\n" if claim.form.startswith("timer_info") else ""
    return program("self.create_timer(0.1, self.beat)\n" + registered, methods, claim.executor, more)


def needs(claim: Claim) -> list[str]:
    return {
        "subscription": ["publish"],
        "service": ["ask"],
        "execute": ["send_goals"],
        "goal": ["send_goals"],
        "accepted": ["send_goals"],
        "cancel": ["cancel_goals"],
        "feedback": ["serve_goals"],
        "parameter": ["set_parameter"],
    }.get(claim.handler, [])


def outcome(claim: Claim, said: Said) -> str:
    all_ = words(said)
    wrong = [at for at, word in enumerate(all_) if word.startswith(("raised TypeError", "raised AttributeError"))]
    if wrong:
        return GOES_ON if all_[wrong[0] :].count("beat") >= 3 else ENDS
    other = next((word for word in all_ if word.startswith("raised")), None)
    if "called" in all_:
        return WORKS
    if other and claim.handler == "subscription" and other.startswith("raised RuntimeError"):
        return REFUSED
    if other and other.startswith("raised ImportError"):
        return NOT_THERE
    return other.split(":")[0] if other else NEVER


JUDGED = Judged("EXE006", claims, source, outcome, frozenset({ENDS, GOES_ON, REFUSED, NOT_THERE}), needs, seconds=2.0)
