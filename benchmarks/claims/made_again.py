"""EXE005: does what a callback creates pile up on its node?"""

from __future__ import annotations

from collections.abc import Iterator

from benchmarks.claims.model import Claim, Judged, method, program, words
from benchmarks.executors.cells import ARGUMENTS, HANDLERS, RETURNS
from benchmarks.executors.running import Said

GROWS, STAYS = "piles up", "does not"

KINDS = {
    "publisher": "self.create_publisher(String, 'made', 10)",
    "subscription": "self.create_subscription(String, 'made', print, 10)",
    "client": "self.create_client(Trigger, 'made')",
    "service": "self.create_service(Trigger, 'made', self.serve)",
    "timer": "self.create_timer(100.0, self.tick)",
    "action_client": "ActionClient(self, Fibonacci, 'made')",
}
_LISTS = {"action_client": "waitables"}
FORMS = {
    "local": "made = {create}\nself.last = made",
    "kept": "self.made = {create}",
    "if_message": "if given.data:\n    self.made = {create}",
    "unless_message": "if not given.data:\n    print('says', {number})\n    return\nself.made = {create}",
    "once": "if self.made is None:\n    self.made = {create}",
    "destroyed": "made = {create}\nself.destroy_{kind}(made)",
    "destroyed_before": "if self.made is not None:\n    self.destroy_{kind}(self.made)\nself.made = {create}",
    "itself": "made = {create}\nmade.destroy()",
    "dropped": "made = {create}\ndel made",
    "cancelled": "made = {create}\nmade.cancel()",
    "by_number": "self.count += 1\nself.made = {create}",
}
_TAKES_A_MESSAGE = ("if_message", "unless_message")


def claims() -> Iterator[Claim]:
    for kind in KINDS:
        for form in FORMS:
            if _makes_sense(kind, form):
                yield Claim("EXE005", form, f"subscription.{kind}")
        for handler in ("timer", "service", "execute"):
            yield Claim("EXE005", "kept", f"{handler}.{kind}")
            yield Claim("EXE005", "once", f"{handler}.{kind}")
    for kind in ("publisher", "timer"):
        yield Claim("EXE005", "kept", f"subscription.{kind}", "multi4")


def _makes_sense(kind: str, form: str) -> bool:
    if form == "cancelled":
        return kind == "timer"
    if form == "by_number":
        return kind not in ("timer",)
    if form in ("destroyed", "destroyed_before"):
        return kind != "action_client"
    return True


def source(claim: Claim) -> str:
    handler, _, kind = claim.handler.partition(".")
    create = KINDS[kind].replace("'made'", "f'made{self.count}'") if claim.form == "by_number" else KINDS[kind]
    number = f"len(list(self.{_LISTS.get(kind, kind + 's')}))"
    body = FORMS[claim.form].format(create=create, kind=kind, number=number)
    body += f"\nprint('says', {number})\n{RETURNS.get(handler, 'return')}"
    constructor = "self.made = None\nself.count = 0\n" + HANDLERS[handler].format(own="None")
    methods = method(f"on_event(self{ARGUMENTS.get(handler, ', given')})", body)
    methods += method("serve(self, request, response)", "return response") + method("tick(self)", "pass")
    return program(constructor, methods, claim.executor)


def needs(claim: Claim) -> list[str]:
    handler = claim.handler.partition(".")[0]
    return {"subscription": ["publish"], "execute": ["send_goals"], "service": ["ask"]}.get(handler, [])


def outcome(claim: Claim, said: Said) -> str:
    numbers = [int(word) for word in words(said) if word.isdigit()]
    if len(numbers) < 3:
        return next((word for _, word in said if word.startswith("raised")), "never ran").split(":")[0]
    return GROWS if numbers[-1] - numbers[0] >= len(numbers) - 1 else STAYS


def left_alone(claim: Claim) -> bool:
    """Names that data decides are other endpoints; of a cancelled timer only its entry in a list stays."""
    return claim.form in ("by_number", "cancelled")


_HARMFUL = frozenset({GROWS, "raised InvalidHandle"})
JUDGED = Judged("EXE005", claims, source, outcome, _HARMFUL, needs, seconds=1.5, left_alone=left_alone)
