"""The hooks that pre-commit users name."""

from __future__ import annotations

import importlib
import re
import shlex
from pathlib import Path
from typing import Any

import pytest
import yaml

MANIFEST = Path(__file__).parents[2] / ".pre-commit-hooks.yaml"
HOOKS = {hook["id"]: hook for hook in yaml.safe_load(MANIFEST.read_text("utf-8"))}

each_hook = pytest.mark.parametrize("hook", HOOKS.values(), ids=HOOKS)


def test_the_hooks_have_the_ids_that_the_readme_names():
    assert list(HOOKS) == ["archlint", "archlint-changed"]


@each_hook
def test_a_hook_is_a_command_that_archlint_understands(hook: dict[str, Any]):
    program, command, *options = shlex.split(hook["entry"])
    assert program == "archlint"
    importlib.import_module(f"archlint.cli.{command}").parser().parse_args(options)


def test_the_second_hook_compares_with_the_last_commit():
    assert shlex.split(HOOKS["archlint-changed"]["entry"])[-2:] == ["--new-only", "HEAD"]
    assert "--new-only" not in HOOKS["archlint"]["entry"]


@each_hook
def test_a_hook_judges_the_whole_system_once(hook: dict[str, Any]):
    assert (hook["pass_filenames"], hook["require_serial"]) == (False, True)


@each_hook
@pytest.mark.parametrize(
    "file",
    [
        "src/robot/robot/node.py",
        "src/robot/scripts/talker",
        "src/driver/src/driver.cpp",
        "src/driver/include/driver/driver.hpp",
        "src/robot_msgs/msg/Reading.msg",
        "src/robot_msgs/srv/SetMotor.srv",
        "src/robot_msgs/action/Dock.action",
        "src/robot/launch/robot.launch",
        "src/robot/launch/robot.launch.xml",
        "src/robot/launch/robot.launch.yaml",
        "src/robot/config/parameters.yaml",
        "src/robot/config/parameters.yml",
        "src/robot_msgs/CMakeLists.txt",
        "src/robot/package.xml",
        "src/robot/setup.py",
        "src/robot/setup.cfg",
        "setup.cfg",
        "pyproject.toml",
        ".archlint.toml",
        "archlint-baseline.txt",
        "src/old_robot/COLCON_IGNORE",
        ".gitignore",
    ],
)
def test_a_hook_runs_for_a_change_of(hook: dict[str, Any], file: str):
    assert re.search(hook["files"], file)
    assert not {"types", "types_or"} & hook.keys(), "pre-commit has no type for .msg, .srv and .action"


@each_hook
@pytest.mark.parametrize(
    "file",
    ["README.md", "docs/notes.txt", "src/driver/src/driver.c", "src/robot/meshes/arm.stl", "src/robot/msg.html"],
)
def test_a_hook_does_not_run_for_a_change_of(hook: dict[str, Any], file: str):
    assert re.search(hook["files"], file) is None
