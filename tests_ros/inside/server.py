"""One warm process of a distribution, which ``tests_ros/running.py`` keeps: rclpy is imported once, and every program
and every observer is a fork of it.

A line of JSON on the standard input starts one; the answer is a line with its process id.  The end of the input ends
everything.  The server itself uses nothing of ROS, so that each fork starts as a new process does.
"""

from __future__ import annotations

import ctypes
import importlib
import json
import os
import signal
import sys
import traceback
from typing import Any

import observer
import runner

IMPORTED_BY_MOST = ("std_msgs.msg", "std_srvs.srv", "geometry_msgs.msg", "sensor_msgs.msg", "nav_msgs.msg")
"""These only define names."""
JOBS = {"program": runner.main, "observer": observer.main}


def main() -> None:
    for name in IMPORTED_BY_MOST:
        importlib.import_module(name)
    forget_own_modules()
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # nobody waits for the children
    for line in sys.stdin:
        print(start(json.loads(line)), flush=True)


def forget_own_modules() -> None:
    """A program may have modules of the same names."""
    sys.path.pop(0)
    for name in ("observer", "runner"):
        del sys.modules[name]


def start(order: dict[str, Any]) -> int:
    child = os.fork()
    if child:
        return child
    try:
        become(order)
        JOBS[order["job"]](*order["words"])
    except BaseException:
        traceback.print_exc()
    finally:
        os._exit(0)


def become(order: dict[str, Any]) -> None:
    """Makes this fork a process of its own: folder, log, environment, search path, and nothing to read."""
    os.setsid()
    ctypes.CDLL(None).prctl(1, signal.SIGKILL)  # PR_SET_PDEATHSIG: not to outlive the server
    signal.signal(signal.SIGCHLD, signal.SIG_DFL)
    signal.alarm(order["limit"])
    os.chdir(order["folder"])
    log = os.open(order["log"], os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
    nothing = os.open(os.devnull, os.O_RDONLY)
    for old, new in ((nothing, 0), (log, 1), (log, 2)):
        os.dup2(old, new)
    sys.stdin = open(0, closefd=False)  # noqa: SIM115
    os.environ.update(order["variables"])
    sys.path[:0] = order["path"]


if __name__ == "__main__":
    main()
