"""The hook that pre-commit users name."""

from __future__ import annotations

import importlib
import shlex
from pathlib import Path

import yaml

MANIFEST = Path(__file__).parents[2] / ".pre-commit-hooks.yaml"


def test_the_hook_is_a_command_that_archlint_understands():
    [hook] = yaml.safe_load(MANIFEST.read_text("utf-8"))
    program, command, *options = shlex.split(hook["entry"])
    assert program == "archlint"
    importlib.import_module(f"archlint.cli.{command}").parser().parse_args(options)


def test_the_hook_judges_the_whole_system_once():
    [hook] = yaml.safe_load(MANIFEST.read_text("utf-8"))
    assert (hook["pass_filenames"], hook["require_serial"]) == (False, True)
