"""What the README says is true of the program."""

from __future__ import annotations

import importlib
import re
import shlex
import sys
from pathlib import Path

import pytest
import yaml

from archlint.cli import COMMANDS, main
from archlint.config.settings import load
from archlint.rulebook import rules

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

ROOT = Path(__file__).parents[1]
README = (ROOT / "README.md").read_text("utf-8")


def blocks(language: str) -> list[str]:
    return re.findall(rf"```{language}\n(.*?)```", README, re.DOTALL)


def commands() -> list[list[str]]:
    """Each archlint command that a line of a code block starts, in words."""
    started = r"^\s*(?:- |run: |entry: )*(?:pipx run |uvx )?archlint (.*)$"
    return [shlex.split(line, comments=True) for line in re.findall(started, README, re.MULTILINE)]


def test_the_readme_shows_commands():
    assert len(commands()) > 8


@pytest.mark.parametrize("words", commands(), ids=" ".join)
def test_a_command_is_one_that_archlint_understands(words: list[str]):
    assert words[0] in COMMANDS
    importlib.import_module(f"archlint.cli.{words[0]}").parser().parse_words(words[1:])


@pytest.mark.parametrize("option", sorted(set(re.findall(r"`(--[a-z-]+)", README))))
def test_an_option_is_in_the_help(option: str, capsys: pytest.CaptureFixture[str]):
    for command in COMMANDS:
        main([command, "--help"])
    assert option in capsys.readouterr().out


def test_the_formats_are_those_of_check(capsys: pytest.CaptureFixture[str]):
    said = re.search(r"Formats: (.*?)\. ", README, re.DOTALL)
    main(["check", "--help"])
    offered = re.search(r"--format F\s+one of (.*?)\n\s+-", capsys.readouterr().out, re.DOTALL)
    assert said and offered
    assert re.findall(r"`(\w+)`", said[1]) == re.findall(r"\w+", offered[1])


def test_the_configuration_is_one_that_archlint_reads(tmp_path: Path):
    [example] = blocks("toml")
    (tmp_path / "archlint.toml").write_text(example, "utf-8")
    settings = load(tmp_path)
    assert settings.distro == "jazzy"
    assert len(settings.contracts) == 2
    assert set(tomllib.loads(example)) >= {"severity", "per-file-ignores", "owners", "layers"}


@pytest.mark.parametrize("number", range(len(blocks("yaml"))))
def test_what_goes_into_ci_is_yaml(number: int):
    assert yaml.safe_load(blocks("yaml")[number])


def test_each_family_of_rules_is_in_the_table():
    assert {rule.code[:3] for rule in rules().values()} == set(re.findall(r"`([A-Z]{3})`", README))


@pytest.mark.parametrize("code", sorted(set(re.findall(r"\b[A-Z]{3}\d{3}\b", README))))
def test_a_rule_that_is_named_exists(code: str):
    assert list((ROOT / "rules").glob(f"{code}-*.md"))


@pytest.mark.parametrize("link", sorted(set(re.findall(r"\]\((?!https://)([^)#]+)\)", README))))
def test_a_link_leads_somewhere(link: str):
    assert (ROOT / link).exists()
