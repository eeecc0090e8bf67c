"""EXE003: who waits while a callback keeps its thread?  A timer beats beside it."""

from __future__ import annotations

from collections.abc import Iterator

from benchmarks.claims.model import Claim, Judged, method, program
from benchmarks.executors.cells import ARGUMENTS, HANDLERS, MADE, RETURNS
from benchmarks.executors.running import Said

WAIT, RUN, MOMENT = "others wait", "others run", "over in a moment"
_MOMENT_S = 0.5

FORMS = {
    "sleep": "time.sleep(0.8)",
    "sleeps": "for _ in range(8):\n    time.sleep(0.1)",
    "short": "time.sleep(0.02)",
    "pauses": "for _ in ('a', 'b', 'c'):\n    time.sleep(0.01)",
    "process": "subprocess.run(['sleep', '0.8'], check=False)",
    "process_call": "os.system('sleep 0.8')",
    "process_limit": "try:\n    subprocess.run(['sleep', '0.8'], check=False, timeout=0.1)\n"
    "except subprocess.TimeoutExpired:\n    pass",
    "process_wait": "subprocess.Popen(['sleep', '0.8']).wait()",
    "process_ended": "process = subprocess.Popen(['sleep', '5'])\nprocess.terminate()\nprocess.wait(timeout=2.0)",
    "network": "with urlopen(f'http://127.0.0.1:{PORT}/') as page:\n    page.read()",
    "lock": "with open(LOCK, 'w') as file:\n    fcntl.flock(file, fcntl.LOCK_EX)",
    "discovery": "self.absent.wait_for_service(timeout_sec=1.2)",
    "pool": "POOL.submit(time.sleep, 0.8)",
    "thread": "threading.Thread(target=time.sleep, args=(0.8,), daemon=True).start()",
    "task": "self.executor.create_task(self.work)",
}
_WORLD = """\
import fcntl
import os
import socket
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor
from urllib.request import urlopen

POOL = ThreadPoolExecutor()
LOCK = os.path.join(tempfile.gettempdir(), f'lock-{os.getpid()}')
SERVER = socket.create_server(('127.0.0.1', 0))
PORT = SERVER.getsockname()[1]


def serve():
    while True:
        connection, _ = SERVER.accept()
        connection.recv(4096)
        time.sleep(0.8)
        connection.sendall(b'HTTP/1.0 200 OK\\r\\n\\r\\nfine')
        connection.close()


def hold():
    while True:
        with open(LOCK, 'w') as file:
            fcntl.flock(file, fcntl.LOCK_EX)
            time.sleep(1.4)
        time.sleep(0.02)
"""
_RUNS = {"network": "threading.Thread(target=serve, daemon=True).start()\n"}
_RUNS["lock"] = "threading.Thread(target=hold, daemon=True).start()\ntime.sleep(0.1)\n"

PLACES = (
    ("spin", "default"),
    ("spin", "callback_apart"),
    ("single", "default"),
    ("multi1", "callback_apart"),
    ("multi2", "callback_apart"),
    ("multi4", "default"),
    ("multi4", "same"),
    ("multi4", "callback_apart"),
    ("multi4", "callback_reentrant"),
    ("multi4", "reentrant"),
)
_GROUPS = {"default": (None, None), "same": ("one", "one"), "callback_apart": ("one", None)}
_GROUPS |= {"callback_reentrant": ("many", None), "reentrant": ("many", "many")}
_HANDLERS = {"timer": "self.create_timer(1.5, self.on_event, callback_group={own})"}
_HANDLERS["fast_timer"] = "self.create_timer(0.3, self.on_event, callback_group={own})"


def claims() -> Iterator[Claim]:
    for form in FORMS:
        for executor, groups in PLACES:
            yield Claim("EXE003", form, "subscription", executor, groups)
        for executor, groups in (("spin", "default"), ("multi4", "default"), ("multi4", "callback_apart")):
            yield Claim("EXE003", form, "timer", executor, groups)
            yield Claim("EXE003", form, "execute", executor, groups)
            if "sleep" not in form:
                yield Claim("EXE003", form, "service", executor, groups)
    for executor, groups in PLACES:
        yield Claim("EXE003", "sleep", "fast_timer", executor, groups)


def source(claim: Claim) -> str:
    own, beating = (("None" if one is None else f"self.{one}") for one in _GROUPS[claim.groups])
    made = "".join(MADE[name] for name in dict.fromkeys(_GROUPS[claim.groups]) if name)
    absent = "self.absent = self.create_client(Trigger, 'absent')\n" if claim.form == "discovery" else ""
    registered = (_HANDLERS | {k: v for k, v in HANDLERS.items() if k != "timer"})[claim.handler].format(own=own)
    beat = f"self.create_timer(0.05, self.beat, callback_group={beating})\n"
    arguments = "" if "timer" in claim.handler else ARGUMENTS.get(claim.handler, ", given")
    end = RETURNS.get(claim.handler, "return")
    # It keeps something: a callback that only sleeps and says so is there to show what waits, and left alone.
    inside = f"print('says starts')\nself.has_run = True\n{FORMS[claim.form]}\n"
    own_end = claim.form in ("task", "pool", "thread")
    body = inside + ("" if own_end else "print('says over')\n") + end
    methods = method(f"on_event(self{arguments})", body) + method("beat(self)", "print('says beat')")
    if claim.form == "task":
        methods += method(
            "work(self)", "print('says starts')\nself.has_run = True\ntime.sleep(0.8)\nprint('says over')"
        )
    if claim.form in ("pool", "thread"):
        methods = methods.replace("            return\n", "")
    return program(made + absent + _RUNS.get(claim.form, "") + beat + registered, methods, claim.executor, _WORLD)


def needs(claim: Claim) -> list[str]:
    return {"subscription": ["publish"], "execute": ["send_goals"], "service": ["ask"]}.get(claim.handler, [])


def outcome(claim: Claim, said: Said) -> str:
    """Of all callbacks that began and ended: did a beat come between?  One may be late."""
    if any(word.startswith("raised") for _, word in said):
        return next(word for _, word in said if word.startswith("raised")).split(":")[0]
    if claim.form in ("pool", "thread"):
        return _gap(said)
    began: float | None = None
    beats = 0
    seen: list[tuple[float, int]] = []
    for when, word in said:
        if word == "says starts" and began is None:
            began, beats = when, 0
        elif word == "says beat":
            beats += 1
        elif word == "says over" and began is not None:
            seen.append((when - began, beats))
            began = None
    if not seen:
        return "never ran"
    if all(length < _MOMENT_S for length, _ in seen):
        return MOMENT
    return RUN if max(beats for _, beats in seen) >= 4 else WAIT


def _gap(said: Said) -> str:
    """Whether beats go on all the time after the first callback."""
    first = next((when for when, word in said if word == "says starts"), None)
    if first is None:
        return "never ran"
    return RUN if sum(when > first and word == "says beat" for when, word in said) >= 10 else WAIT


def left_alone(claim: Claim) -> bool:
    """A file lock, which other processes rarely hold for as long as the one here does."""
    return claim.form == "lock"


JUDGED = Judged(
    "EXE003",
    claims,
    source,
    outcome,
    frozenset({WAIT}),
    needs,
    seconds=4.0,
    judges=("EXE003", "SRV003", "SRV008"),
    left_alone=left_alone,
)
