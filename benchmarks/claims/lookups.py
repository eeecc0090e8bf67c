"""EXE007: does a transform come while a callback waits for it?  With tf2_ros's own listener and buffer."""

from __future__ import annotations

import shutil
import sys
from collections.abc import Iterator
from pathlib import Path

from tests_ros.environments import Environment

from benchmarks.claims.model import Claim, Judged, method, program, words
from benchmarks.executors.cells import ARGUMENTS, HANDLERS, MADE, RETURNS
from benchmarks.executors.running import Said

FOUND, IN_VAIN, AT_ONCE = "it comes", "waits in vain", "does not wait"

_HERE = Path(__file__).parent / "tf2"
_NOW = "self.get_clock().now()"
FORMS = {
    "lookup": f"self.buffer.lookup_transform('map', 'base', {_NOW}, timeout=Duration(seconds=0.6))",
    "lookup_fourth": f"self.buffer.lookup_transform('map', 'base', {_NOW}, Duration(seconds=0.6))",
    "can": f"self.buffer.can_transform('map', 'base', {_NOW}, timeout=Duration(seconds=0.6))",
    "zero": f"self.buffer.can_transform('map', 'base', {_NOW}, timeout=Duration())",
    "none": f"self.buffer.can_transform('map', 'base', {_NOW})",
    "async": f"await self.buffer.wait_for_transform_async('map', 'base', {_NOW})",
}
LISTENERS = {
    "listener": "TransformListener(self.buffer, self)",
    "own_thread": "TransformListener(self.buffer, self, spin_thread=True)",
    "other_node": "TransformListener(self.buffer, Node('listener'), spin_thread=True)",
}
_GROUPS = {"default": None, "callback_apart": "one", "callback_reentrant": "many"}
_MORE = "from rclpy.duration import Duration\nfrom tf2_ros import Buffer, TransformException, TransformListener\n"


def claims() -> Iterator[Claim]:
    for form in FORMS:
        for executor in ("spin", "single", "once", "multi1", "multi2", "multi4"):
            for groups in _GROUPS:
                yield Claim("EXE007", form, "timer.listener", executor, groups)
        for handler in ("subscription", "service"):
            yield Claim("EXE007", form, f"{handler}.listener", "spin")
            yield Claim("EXE007", form, f"{handler}.listener", "multi4")
        for listener in ("own_thread", "other_node"):
            for executor in ("spin", "single", "once", "multi4"):
                yield Claim("EXE007", form, f"timer.{listener}", executor)


def source(claim: Claim) -> str:
    handler, _, listener = claim.handler.partition(".")
    group = _GROUPS[claim.groups]
    made = MADE[group] if group else ""
    made += f"self.buffer = Buffer()\nself.listener = {LISTENERS[listener]}\n"
    registered = HANDLERS[handler].format(own=f"self.{group}" if group else "None")
    body = f"print('asks')\nbegan = time.monotonic()\ntry:\n    found = {FORMS[claim.form]}\n"
    body += "except TransformException:\n    found = None\n"
    body += "print('says at_once' if time.monotonic() - began < 0.01 and not found else '')\n"
    body += f"print('answered' if found else 'nothing')\n{RETURNS.get(handler, 'return')}"
    asked = method(f"on_event(self{ARGUMENTS.get(handler, ', given')})", body, coroutine=claim.form == "async")
    return program(made + registered, asked, claim.executor, _MORE)


def needs(claim: Claim) -> list[str]:
    handler = claim.handler.partition(".")[0]
    return ["send_transforms", *{"subscription": ["publish"], "service": ["ask"]}.get(handler, [])]


def outcome(claim: Claim, said: Said) -> str:
    """The newest transform is always older than now, so that one has to come."""
    all_ = words(said)
    raised = next((word for word in all_ if word.startswith("raised")), None)
    if raised or "asks" not in all_:
        return (raised or "never ran").split(":")[0]
    if claim.form in ("zero", "none"):
        return AT_ONCE if "at_once" in all_ else IN_VAIN
    return FOUND if "answered" in all_ else IN_VAIN


def prefixes(environment: Environment, tf2_ros: Path, folder: Path) -> list[Path]:
    """Install prefixes with tf2_ros's Python from a checkout of geometry2, and what it needs."""
    packages = folder / "lib" / f"python3.{sys.version_info.minor}" / "site-packages"
    (packages / "tf2_ros").mkdir(parents=True)
    shutil.copy(_HERE / "tf2_py.py", packages)
    for name in ("buffer.py", "buffer_interface.py", "transform_listener.py"):
        shutil.copy(tf2_ros / name, packages / "tf2_ros")
    lines = ["from tf2_py import TransformException", "from .buffer_interface import *", "from .buffer import Buffer"]
    lines += ["from .transform_listener import TransformListener"]
    (packages / "tf2_ros" / "__init__.py").write_text("\n".join(lines) + "\n")
    return [folder, *environment.interfaces(_HERE)]


def left_alone(claim: Claim) -> bool:
    """An await blocks nobody; what a listener's own thread brings does not wake the executor, but all else does."""
    return claim.form == "async"


JUDGED = Judged("EXE007", claims, source, outcome, frozenset({IN_VAIN}), needs, seconds=2.5, left_alone=left_alone)
