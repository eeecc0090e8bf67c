"""Runs many small programs under a real rclpy, each with its other end in a domain of its own: what do they print?

``driver.py DOMAIN …`` under the Python of a ROS 2 environment, one program at a time for each domain.  It reads lines
of JSON, ``{"name": …, "source": …, "needs": […], "latency": …, "program_first": …, "enough": …, "limit": …}``, and
writes one for each: ``{"name": …, "said": [[seconds, word], …]}``.  rclpy is imported once; each program is a fork of
this process.

A program says a word of ``WORDS``, or anything after ``says``. ``enough`` is how many words ``answered`` end a
program early, ``limit`` how many seconds after its first word it ends.
"""

from __future__ import annotations

import ctypes
import json
import os
import re
import select
import signal
import sys
import threading
import time
import traceback
from collections.abc import Callable
from contextlib import suppress
from typing import Any

import other_end
import rclpy
import rclpy.action
import rclpy.executors
import rclpy.lifecycle
import rclpy.type_support
from rcl_interfaces.msg import ParameterEvent
from rcl_interfaces.srv import SetParameters
from std_msgs.msg import String
from std_srvs.srv import Trigger
from test_msgs.action import Fibonacci

WORDS = ("asks", "answered", "nothing", "ended")
START_S = 25.0
"""How long a program may take to its first word."""


class Run:
    """One program and its other end."""

    def __init__(self, task: dict[str, Any], domain: int) -> None:
        self.task, self.domain = task, domain
        self.started = self.first = time.monotonic()
        self.said: list[tuple[float, str]] = []
        self.rest = b""
        self.over = False
        self.reading, writing = os.pipe()
        starts = [lambda: program(task["source"], task["name"]), lambda: other_end.run(task["needs"], task["latency"])]
        outputs = [writing, None]
        order = (0, 1) if task["program_first"] else (1, 0)
        self.processes = [forked(starts[one], domain, outputs[one]) for one in order]
        os.close(writing)

    def read(self) -> None:
        data = os.read(self.reading, 65536)
        self.over = self.over or not data
        *lines, self.rest = (self.rest + data).split(b"\n")
        now = time.monotonic()
        if not self.said:
            self.first = now
        for line in lines:
            word = word_of(line.decode(errors="replace"))
            if word is not None:
                self.said.append((round(now - self.first, 2), word))

    def finished(self) -> bool:
        now = time.monotonic()
        if not self.said:
            return self.over or now - self.started > START_S
        answers = sum(word == "answered" for _, word in self.said)
        return self.over or now - self.first > self.task["limit"] or answers >= self.task["enough"]

    def end(self) -> dict[str, Any]:
        for process in self.processes:
            with suppress(ProcessLookupError):
                os.killpg(process, signal.SIGKILL)
            with suppress(ProcessLookupError):
                os.kill(process, signal.SIGKILL)
            os.waitpid(process, 0)
        os.close(self.reading)
        return {"name": self.task["name"], "said": self.said}


def word_of(line: str) -> str | None:
    """A line without what is of no interest; the end of a traceback tells what rclpy itself has caught."""
    caught = re.match(r"(?:rclpy\.\w+\.)*(\w+Error)(?::|$)", line)
    if caught:
        return f"raised {caught.group(1)}"
    return line if line in WORDS or line.startswith(("raised ", "says ")) else None


def forked(work: Callable[[], None], domain: int, output: int | None) -> int:
    """Runs ``work`` in a process of its own, whose standard output is the file descriptor ``output``."""
    parent = os.getpid()
    child = os.fork()
    if child:
        return child
    os.setsid()
    ctypes.CDLL(None).prctl(1, signal.SIGKILL)  # PR_SET_PDEATHSIG: not to outlive the test
    if os.getppid() != parent:
        os._exit(0)
    silent = os.open(os.devnull, os.O_RDWR)
    os.dup2(silent, 0)
    os.dup2(silent if output is None else output, 1)
    os.dup2(1, 2)
    os.closerange(3, 256)
    sys.stdout = os.fdopen(1, "w", buffering=1)
    os.environ["ROS_DOMAIN_ID"] = str(domain)
    try:
        work()
    finally:
        os._exit(0)


def program(source: str, name: str) -> None:
    threading.excepthook = lambda given: print(f"raised {given.exc_type.__name__}")
    try:
        exec(compile(source, name, "exec", dont_inherit=True), {"__name__": "__main__"})
    except BaseException as error:
        where = traceback.extract_tb(error.__traceback__)[-1]
        print(f"raised {type(error).__name__}: {' '.join(str(error).split())[:120]} ({where.name})")
    else:
        print("ended")


def main() -> None:
    free = [int(domain) for domain in sys.argv[1:]]
    for kind in (String, Trigger, SetParameters, ParameterEvent):
        rclpy.type_support.check_for_type_support(kind)
    rclpy.type_support.check_for_type_support(Fibonacci)
    tasks = [json.loads(line) for line in sys.stdin]
    tasks.reverse()
    runs: list[Run] = []
    while tasks or runs:
        if tasks and free:
            runs.append(Run(tasks.pop(), free.pop()))
        ready, _, _ = select.select([run.reading for run in runs], [], [], 0 if tasks and free else 0.05)
        for run in runs.copy():
            if run.reading in ready:
                run.read()
            if run.finished():
                runs.remove(run)
                print(json.dumps(run.end()), flush=True)
                free.insert(0, run.domain)


if __name__ == "__main__":
    main()
