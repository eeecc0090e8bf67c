"""What a run over a hostile workspace asks of the system, as Python's own audit events tell it."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

WATCHED = """\
import json, sys
events = []
def note(event, given):
    if event == "open" and isinstance(given[0], (str, bytes)):
        events.append([event, str(given[0])])
    elif event.startswith(("socket.", "subprocess.", "os.system", "os.exec", "os.spawn", "os.posix_spawn", "pty.")):
        events.append([event, ""])
    elif event == "exec" and hasattr(given[0], "co_filename"):
        events.append([event, given[0].co_filename])
sys.addaudithook(note)
from archlint.cli import main
status = main(sys.argv[2:])
with open(sys.argv[1], "w") as stream:
    json.dump([status, events], stream)
"""
MANIFEST = """\
<?xml version="1.0"?>
<!DOCTYPE package [<!ENTITY secret SYSTEM "file://{secret}">]>
<package format="3"><name>robot</name><version>0.0.1</version><description>&secret;</description>
<maintainer email="kim@example.com">Kim</maintainer><license>MIT</license>
<export><build_type>ament_python</build_type></export></package>
"""
EVIL = """\
import os, socket, subprocess
os.system("true")
subprocess.run(["true"])
socket.create_connection(("::1", 9))
"""
NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String
text = open({secret!r}).read()
rclpy.init()
Node('talker').create_publisher(String, text, 10)
"""


@pytest.fixture
def secret(tmp_path: Path) -> Path:
    """A file beside the workspace."""
    secret = tmp_path / "secret.yaml"
    secret.write_text("talker:\n  ros__parameters:\n    password: hunter2\n")
    return secret


@pytest.fixture
def hostile(tmp_path: Path, secret: Path) -> Path:
    """A workspace whose every file asks for something outside, or does something where it is run."""
    files = {
        "package.xml": MANIFEST.format(secret=secret),
        "setup.py": f"{EVIL}from setuptools import setup\nsetup(name='robot', version=open({str(secret)!r}).read())\n",
        "setup.cfg": f"[metadata]\nname = file: {secret}\n",
        "robot/__init__.py": EVIL,
        "robot/talker.py": NODE.format(secret=str(secret)) + EVIL,
        "launch/a.launch.py": EVIL + "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n"
        "def generate_launch_description():\n    os.system('true')\n"
        f"    return LaunchDescription([Node(package='robot', executable='talker', parameters=[{str(secret)!r}])])\n",
        "launch/b.launch.xml": f"<launch><include file='{secret}'/><let name='a' value='$(command true)'/>"
        f"<node pkg='robot' exec='talker'><param from='../../{secret.name}'/></node></launch>",
        "launch/c.launch.yaml": f"launch:\n- include: {{file: '{secret}'}}\n- executable: {{cmd: 'true'}}\n",
        "CMakeLists.txt": f"include({secret})\nfile(READ {secret} text)\nexecute_process(COMMAND true)\n",
        "src/talker.cpp": f'#include "{secret}"\n#include "../../../{secret.name}"\n#include "rclcpp/rclcpp.hpp"\n',
        "archlint.toml": f'baseline = "{secret}"\nlaunch = ["{secret}"]\n',
        "conftest.py": EVIL,
        "sitecustomize.py": EVIL,
    }
    workspace = tmp_path / "workspace"
    for name, text in files.items():
        (workspace / name).parent.mkdir(parents=True, exist_ok=True)
        (workspace / name).write_text(text)
    return workspace


def events_of(workspace: Path, *words: str) -> tuple[int, list[tuple[str, str]]]:
    """How a command ended, and the events of its process."""
    told = workspace.parent / "events.json"
    command = [sys.executable, "-I", "-c", WATCHED, str(told), *words]
    done = subprocess.run(command, cwd=workspace, capture_output=True, check=False)
    assert told.exists(), done.stderr.decode()
    status, events = json.loads(told.read_text())
    return status, [(event, path) for event, path in events]


@pytest.mark.parametrize(
    "words",
    [
        ("check", ".", "--isolated", "--select", "ALL"),
        ("graph", ".", "--isolated", "-o", "../picture.mmd"),
        ("docs", ".", "--isolated", "-o", "../docs"),
    ],
)
def test_nothing_is_executed_nothing_outside_is_read_and_nobody_is_called(
    hostile: Path, secret: Path, words: tuple[str, ...]
) -> None:
    more = ("--no-cache", "--jobs", "1") if words[0] == "check" else ()
    status, events = events_of(hostile, *words, *more)
    assert status in (0, 1)
    names = {event for event, _ in events}
    assert "open" in names and "exec" in names
    assert not {name for name in names if name not in ("open", "exec")}
    assert not [path for event, path in events if event == "exec" and Path(path).is_relative_to(hostile)]
    assert not [path for event, path in events if event == "open" and Path(hostile, path).resolve() == secret]


def test_a_baseline_outside_of_the_repository_is_refused(hostile: Path, secret: Path) -> None:
    status, events = events_of(hostile, "check", ".", "--no-cache", "--jobs", "1", "--write-baseline")
    assert status == 2
    assert secret.read_text().startswith("talker:")
    assert not [event for event, _ in events if event.startswith(("socket", "subprocess", "os."))]
