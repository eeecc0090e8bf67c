"""CBG002: do callback groups change anything?  What they let run at the same time, and what they let in."""

from __future__ import annotations

from collections.abc import Iterator

from benchmarks.claims.model import Claim, Judged, method, program
from benchmarks.executors.cells import ARGUMENTS, HANDLERS, MADE, RETURNS
from benchmarks.executors.running import Said

TURNS, ASKED = "one after the other", "one after the other, as its group says"
BESIDE, LETS_IN, STUCK = "at the same time", "lets the answer in", "stuck"

GROUPS = {"reentrant": ("many", "many"), "two": ("one", "two"), "one_and_default": ("one", None), "one": ("one", "one")}
GROUPS |= {"default": (None, None), "two_reentrant": ("many", "more")}
_KEEP_APART = ("default", "one")
"""Where one callback at a time is just what the groups say."""
FORMS = {
    "sleep": "time.sleep(0.4)",
    "await": "await self.client.call_async(Trigger.Request())",
    "spin": "future = self.client.call_async(Trigger.Request())\n"
    "rclpy.spin_until_future_complete(self, future, executor=self.executor, timeout_sec=0.4)",
}
_EXECUTORS = {
    "sleep": ("spin", "single", "once", "thread", "multi1", "multi2", "multi4", "spin_multi"),
    "await": ("spin", "single", "multi1", "multi4"),
    "spin": ("single", "multi4"),
}


def claims() -> Iterator[Claim]:
    for form in FORMS:
        for groups in GROUPS:
            for executor in _EXECUTORS[form]:
                for handler in ("subscription", "timer"):
                    yield Claim("CBG002", form, handler, executor, groups)
    for groups in GROUPS:
        yield Claim("CBG002", "sleep", "service", "spin", groups)
        yield Claim("CBG002", "sleep", "service", "multi4", groups)


def source(claim: Claim) -> str:
    own, other = GROUPS[claim.groups]
    made = "".join(MADE[name] for name in dict.fromkeys((own, other)) if name)
    mine, theirs = (("None" if one is None else f"self.{one}") for one in (own, other))
    client = (
        ""
        if claim.form == "sleep"
        else f"self.client = self.create_client(Trigger, 'inner', callback_group={theirs})\n"
        "self.client.wait_for_service(timeout_sec=10.0)\n"
    )
    beat = f"self.create_timer(0.05, self.beat, callback_group={theirs})\n"
    body = f"print('asks')\n{FORMS[claim.form]}\nprint('answered')\n{RETURNS.get(claim.handler, 'return')}"
    methods = method(f"on_event(self{ARGUMENTS.get(claim.handler, ', given')})", body, coroutine=claim.form == "await")
    return program(
        made + client + beat + HANDLERS[claim.handler].format(own=mine),
        methods + method("beat(self)", "print('says beat')"),
        claim.executor,
    )


def needs(claim: Claim) -> list[str]:
    return {"subscription": ["publish"], "service": ["ask"]}.get(claim.handler, [])


def outcome(claim: Claim, said: Said) -> str:
    """Whether beats come between a callback's beginning and its end."""
    words = [word for _, word in said]
    raised = next((word for word in words if word.startswith("raised")), None)
    if raised and claim.form == "sleep":
        return raised.split(":")[0]
    if "asks" not in words:
        return "never ran"
    if claim.form == "await":
        return LETS_IN if "answered" in words else STUCK
    beats, best, inside = 0, 0, False
    for word in words:
        if word == "asks" and not inside:
            inside, beats = True, 0
        elif word == "answered":
            inside = False
        elif word == "says beat" and inside:
            beats += 1
            best = max(best, beats)
    if claim.form == "spin":
        return raised.split(":")[0] if raised else (LETS_IN if "answered" in words else STUCK)
    if best >= 3:
        return BESIDE
    return ASKED if claim.groups in _KEEP_APART else TURNS


JUDGED = Judged("CBG002", claims, source, outcome, frozenset({TURNS}), needs, seconds=2.5)
