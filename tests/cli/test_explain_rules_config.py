"""``archlint explain``, ``archlint rules``, ``archlint config``, ``--version`` and ``--help``."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from archlint import __version__
from archlint.cli import COMMANDS, main
from archlint.rulebook import rules


def printed(capsys: pytest.CaptureFixture[str], *arguments: str) -> str:
    assert main(list(arguments)) == 0
    shown = capsys.readouterr()
    assert shown.err == ""
    return shown.out


@pytest.mark.parametrize("asked", ["LCH001", "lch001", "unknown-executable"])
def test_explain_prints_what_matters_of_a_page(capsys: pytest.CaptureFixture[str], asked: str):
    page = printed(capsys, "explain", asked)
    start = "# LCH001 unknown-executable\n\n*error, on by default, no automatic fix, since 0.1*\n\n## Reported\n- "
    assert page.startswith(start)
    assert [line for line in page.splitlines() if line.startswith("#")] == [
        "# LCH001 unknown-executable",
        *("## Reported", "## Not reported", "## Why it matters", "## Bad", "## Good", "## References"),
    ]
    assert page.count("```python") == 2
    assert "expect:" not in page
    assert "package.xml" not in page[page.index("## Bad") :]
    assert page.endswith("\n*More examples: `archlint explain LCH001 --all`*\n")


def test_explain_shows_the_block_with_the_mistake_and_its_correction(capsys: pytest.CaptureFixture[str]):
    page = printed(capsys, "explain", "PKG001")
    bad, good = page[page.index("## Bad") : page.index("## Fix")].split("## Good")
    assert bad.count("```") == good.count("```") == 2
    assert "`robot/talker.py`:" in bad
    assert "<exec_depend>std_msgs</exec_depend>" in good


@pytest.mark.parametrize(
    ("code", "words"),
    [
        ("TOP001", "- A type that its package does not define: MSG002 reports it.\n"),
        ("LNT003", "- Exit status, in archlint's README\n"),
    ],
)
def test_explain_has_no_links_between_files(capsys: pytest.CaptureFixture[str], code: str, words: str):
    assert words in printed(capsys, "explain", code)


def test_explain_all_prints_every_example(capsys: pytest.CaptureFixture[str]):
    page = printed(capsys, "explain", "LCH001", "--all")
    assert page.startswith("# LCH001 unknown-executable\n\n*error, ")
    assert "### A script that CMake installs into a folder of its own" in page
    assert "<details>" not in page
    assert "expect:" not in page


def test_explain_renders_the_page_where_colours_are_wanted(capsys: pytest.CaptureFixture[str]):
    page = printed(capsys, "explain", "SRV003", "--color", "always")
    assert "\x1b[" in page
    assert "```" not in page
    assert "\x1b[?" not in page  # no cursor control


@pytest.mark.parametrize(
    ("asked", "hint"),
    [
        ("SRV3", "did you mean SRV003?"),
        ("nested-servce-call", "did you mean nested-service-call (SRV003)?"),
        ("qqqqqq", "`archlint rules` lists them"),
    ],
)
def test_explain_suggests_the_nearest_rule(capsys: pytest.CaptureFixture[str], asked: str, hint: str):
    assert main(["explain", asked]) == 2
    assert capsys.readouterr() == ("", f"archlint: error: unknown rule `{asked}`; {hint}\n")


def test_rules_is_a_table_of_all_rules(capsys: pytest.CaptureFixture[str]):
    head, *lines = printed(capsys, "rules").splitlines()
    assert head.split() == ["code", "name", "severity", "default", "fix", "finds"]
    assert [line.split()[0] for line in lines] == list(rules())


def test_rules_as_json(capsys: pytest.CaptureFixture[str]):
    document = json.loads(printed(capsys, "rules", "--format", "json"))
    assert document["version"] == 1
    [entry] = [rule for rule in document["rules"] if rule["code"] == "SRV003"]
    assert entry.pop("summary")
    assert entry == {
        "code": "SRV003",
        "name": "nested-service-call",
        "severity": "error",
        "default": "on",
        "fix": None,
        "since": "0.1",
        "plugin": None,
    }


def test_config_says_where_each_value_came_from(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.chdir(tmp_path)
    Path("pyproject.toml").write_text(
        "[tool.archlint]\ndistro = 'jazzy'\nselect = ['SRV']\n"
        "[tool.archlint.severity]\nSRV003 = 'info'\n[tool.archlint.per-file-ignores]\n'test/*' = ['SRV']\n"
    )
    lines = [line.split("  # ") for line in printed(capsys, "config").splitlines()[:-1]]
    assert {text.rstrip(): origin for text, origin in lines} == {
        'select = ["SRV"]': "pyproject.toml:3",
        "extend-select = []": "default",
        "ignore = []": "default",
        'severity = { "SRV003" = "info" }': "pyproject.toml:4",
        "exclude = []": "default",
        'per-file-ignores = { "test/*" = ["SRV"] }': "pyproject.toml:6",
        "per-package-ignores = {}": "default",
        'distro = "jazzy"': "pyproject.toml:2",
        "closed-world = false": "default",
        "launch = []": "default",
        "external = []": "default",
        "shared-topics = []": "default",
        "unused-files = false": "default",
        "rules = {}": "default",
    }


def test_config_lists_the_rules_that_run(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.chdir(tmp_path)
    Path("archlint.toml").write_text("select = ['SRV003']")
    assert printed(capsys, "config").endswith("\n# rules that run: LNT002, LNT003, SRV003\n")
    assert "SRV002" in printed(capsys, "config", "--isolated")


def test_version(capsys: pytest.CaptureFixture[str]):
    assert printed(capsys, "--version") == f"archlint {__version__}\n"


def test_help_names_every_command(capsys: pytest.CaptureFixture[str]):
    text = printed(capsys, "--help")
    for command in COMMANDS:
        assert f"\n  {command}" in text
        assert printed(capsys, command, "--help").startswith(f"usage: archlint {command} ")
