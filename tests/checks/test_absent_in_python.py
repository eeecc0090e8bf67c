"""API002: names that modules of Python's library have in no version."""

from __future__ import annotations

import pytest

from checks.judging import Judge

FILE = """
import datetime
import itertools
import json
import logging
import math
import os
import string
import sys
import time
import urllib

import rclpy
from rclpy.node import Node


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.create_timer(1.0, self.tick)

    def tick(self):
        {line}


rclpy.init()
rclpy.spin(Robot())
"""


@pytest.mark.parametrize(
    ("line", "message", "help"),
    [
        ("time.slep(1.0)", "time has no 'slep': …; did you mean 'sleep'?", "write time.sleep"),
        ("print(math.pii)", "math has no 'pii': …; did you mean 'pi'?", "write math.pi"),
        ("os.path.joinn('a', 'b')", "os.path has no 'joinn': …; did you mean 'join'?", "write os.path.join"),
        ("os.join('a', 'b')", "os has no 'join': …; did you mean 'os.path.join'?", "write os.path.join"),
        (
            "datetime.now()",
            "datetime has no 'now': …; did you mean 'datetime.datetime.now'?",
            "write datetime.datetime.now",
        ),
        ("time.clock()", "time has no 'clock': …; did you mean 'time.perf_counter'?", "write time.perf_counter"),
        ("print(sys.maxint)", "sys has no 'maxint': …; did you mean 'sys.maxsize'?", "write sys.maxsize"),
        ("itertools.izip([], [])", "itertools has no 'izip': …; did you mean 'zip'?", "write zip"),
        (
            "urllib.urlencode({{}})",
            "urllib has no 'urlencode': …; did you mean 'urllib.parse.urlencode'?",
            "import urllib.parse and write urllib.parse.urlencode",
        ),
        (
            "math.clamp(1, 2, 3)",
            "math has no 'clamp': …",
            "remove it, or name what there is: the line fails when that function runs",
        ),
        (  # what decodes is not what encodes
            "raise json.JSONEncodeError",
            "json has no 'JSONEncodeError': …; did you mean 'JSONEncoder'?",
            "write json.JSONEncoder",
        ),
    ],
)
def test_what_no_version_of_python_has(judge: Judge, line: str, message: str, help: str):
    [finding] = judge("API002", FILE.format(line=f"{line}  # here").replace("{{}}", "{}"))
    expected = message.replace("…", "this line fails with an AttributeError")
    assert (finding.message, finding.help) == (f"Python's module {expected}", help)


@pytest.mark.parametrize(
    ("line", "help"),
    [
        ("from time import slep", "write `from time import sleep`"),
        ("from collections import OrderedDic as Ordered", "write `from collections import OrderedDict`"),
        ("from urllib import quote", "write `from urllib.parse import quote`"),
        ("from itertools import izip", "remove it, and write zip"),
    ],
)
def test_an_import_of_such_a_name(judge: Judge, line: str, help: str):
    [finding] = judge("API002", FILE.format(line=f"{line}  # here"))
    assert finding.help == help
    assert "fails with an ImportError" in finding.message


def test_a_module_by_another_name(judge: Judge):
    [finding] = judge("API002", FILE.format(line="import datetime as dt; dt.utcnow()  # here"))
    assert finding.help == "write dt.datetime.utcnow"


@pytest.mark.parametrize(
    "line",
    [
        "time.sleep(0.1); time.time_ns(); math.prod([1.0])",
        "print(datetime.UTC, math.sumprod, itertools.batched)",  # newer than most
        "import collections; print(collections.Mapping, collections.abc.Mapping)",  # Python 3.9 has the first
        "import signal; print(signal.CTRL_C_EVENT, os.O_BINARY, os.startfile)",  # on Windows
        "import socket; print(socket.SO_INCOMING_CPU_OF_THIS_SYSTEM)",  # constants of a system
        "import ctypes; print(ctypes.windll)",
        "import concurrent.futures as f; f.ThreadPoolExecutor()",  # which it makes when it is asked for
        "import xml.dom.minidom; import logging.handlers; logging.handlers.RotatingFileHandler('x')",
        "import importlib; importlib.util.find_spec('x')",
        "print(sys.frozen, logging.success, logging.TRACE)",  # which others add
        "time.slep = time.sleep; time.slep(1.0)",
        "print(hasattr(math, 'clamp') and math.clamp(1, 2, 3))",
        "print(math.clamp(1, 2, 3) if sys.version_info > (3, 99) else 1)",
        "time = self.get_clock(); time.slep(1.0)",
        "math.__name__",
    ],
)
def test_what_some_version_has_or_is_not_the_module(judge: Judge, line: str):
    judge("API002", FILE.format(line=line))


@pytest.mark.parametrize("kind", ["AttributeError", "Exception"])
def test_a_line_that_is_tried(judge: Judge, kind: str):
    judge("API002", FILE.format(line=f"try:\n            time.clock()\n        except {kind}:\n            pass"))


def test_a_star_import_that_may_bring_another_module_of_the_name(judge: Judge):
    source = FILE.replace("import rclpy\n", "import rclpy\nfrom numpy import *\n")
    judge("API002", source.format(line="math.clamp(1, 2)"))


def test_a_parameter_of_that_name(judge: Judge):
    judge(
        "API002", FILE.format(line="self.wait(self.get_clock())\n\n    def wait(self, time):\n        time.slep(1.0)")
    )


def test_a_method_that_nothing_calls(judge: Judge):
    judge("API002", FILE.format(line="pass\n\n    def wait(self):\n        time.slep(1.0)"))


def test_a_module_of_the_workspace(judge: Judge):
    (judge.folder / "time.py").write_text("def slep(seconds): ...\n", encoding="utf-8")
    judge("API002", FILE.format(line="time.slep(1.0)"))


def test_a_file_that_adds_the_name(judge: Judge):
    judge("API002", FILE.format(line="time.slep(1.0)"), "import time\nimport rclpy\n\ntime.slep = time.sleep\n")


def test_a_file_for_a_small_computer(judge: Judge):
    judge("API002", FILE.format(line="import machine; time.sleep_ms(1)"))
