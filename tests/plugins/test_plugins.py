"""Rules that a repository brings are rules as archlint's own are."""

from __future__ import annotations

import json
import sys
from concurrent.futures import ThreadPoolExecutor
from importlib.metadata import EntryPoint
from pathlib import Path

import pytest

import archlint
from archlint.checks.registry import registered
from archlint.cli import main
from archlint.config.settings import ConfigurationError, load
from archlint.live.workspace import Asked, LiveWorkspace
from archlint.plugins import installed
from archlint.rulebook import own_rules, rules
from archlint.server.configuration import Configuration
from archlint.testing import examples_of
from plugins.conftest import EXAMPLE, RULES

PAGE = "tools/XRT001-fast-timer.md"


def found(*options: str) -> tuple[int, list[tuple[str, str, int]]]:
    """The exit status of a check with plugins, and what it finds."""
    status = main(["check", "--plugins", "--output", "json=found.json", "--quiet", *options])
    rows = json.loads(Path("found.json").read_text())["diagnostics"] if status < 2 else []
    return status, [(row["code"], row["severity"], row["line"]) for row in rows]


def change(file: str, old: str, new: str) -> None:
    text = Path(file).read_text()
    assert old in text
    Path(file).write_text(text.replace(old, new))


# --- the example of the documentation


@pytest.mark.parametrize("example", examples_of(EXAMPLE / RULES), ids=str)
def test_the_page_of_the_example_keeps_its_word(example, tmp_path: Path):
    assert example.found(tmp_path) == example.expected


def test_the_example_has_a_mark_to_keep():
    assert [len(example.expected) for example in examples_of(EXAMPLE / RULES)] == [1, 0]


def test_a_page_that_does_not_keep_its_word_is_seen(repository: Path, tmp_path: Path):
    change(PAGE, "0.02", "0.002")
    [_, good] = examples_of(repository / RULES)
    assert good.found(tmp_path) == [("node.py", 7, "XRT001")] != good.expected


@pytest.mark.parametrize("file", ["archlint.toml", "tools/our_rules.py", "tools/test_our_rules.py"])
def test_the_guide_shows_the_example_as_it_is(file: str):
    guide = (EXAMPLE.parent / "plugins.md").read_text()
    assert f"\n{(EXAMPLE / file).read_text()}```\n" in guide


def test_the_names_that_the_guide_tells_are_in_the_api():
    imported = "from archlint.api import Finding, Options, Scope, System, finding, rule"
    assert imported in (EXAMPLE / RULES).read_text()
    assert {"Finding", "Options", "Scope", "System", "finding", "rule"} <= set(archlint.api.__all__)


# --- what a configuration says of its rules


def test_it_finds_what_its_options_say(repository: Path):
    assert found() == (1, [("XRT001", "warning", 8)])
    change("archlint.toml", "50", "200")
    assert found() == (0, [])


@pytest.mark.parametrize(
    ("more", "status", "severities"),
    [
        ('ignore = ["XRT001"]', 0, []),
        ('ignore = ["XRT"]', 0, []),
        ('select = ["fast-timer"]', 1, ["warning"]),
        ('select = ["TMO"]', 0, []),
        ('severity = { XRT001 = "error" }', 1, ["error"]),
        ('per-file-ignores = { "wheels.py" = ["XRT001"] }', 0, []),
        ('preset = "course"', 0, ["info"]),
    ],
)
def test_keys_about_rules_are_about_these_too(more: str, status: int, severities: list[str], repository: Path):
    change("archlint.toml", "plugins =", f"{more}\nplugins =")
    assert found() == (status, [("XRT001", severity, 8) for severity in severities])


def test_options_of_the_command_line(repository: Path):
    assert found("--ignore", "XRT") == (0, [])
    assert found("--select", "XRT001")[0] == 1
    assert found("--select", "XRT009")[0] == 2


def test_a_suppression_and_a_stale_one(repository: Path):
    change("wheels.py", "self.turn)", "self.turn)  # archlint: ignore[XRT001] measured")
    assert found() == (0, [])
    change("wheels.py", "0.01", "0.1")
    assert found() == (1, [("LNT001", "warning", 8)])


def test_a_baseline_holds_it_back(repository: Path):
    assert main(["check", "--plugins", "--write-baseline", "--baseline", "known.txt"]) == 0
    assert "XRT001" in Path("known.txt").read_text()
    assert found("--baseline", "known.txt") == (0, [])


def test_a_rule_that_is_off_is_opt_in(repository: Path):
    change(PAGE, "default: on", "default: off")
    assert found() == (0, [])
    assert found("--extend-select", "XRT001")[0] == 1


def test_sarif_has_its_page(repository: Path):
    found("--output", "sarif=found.sarif")
    [rule] = json.loads(Path("found.sarif").read_text())["runs"][0]["tool"]["driver"]["rules"]
    assert rule["id"] == "XRT001"
    assert "The computer of our robot misses" in rule["help"]["markdown"]


def test_explain_rules_and_config_know_it(repository: Path, capsys: pytest.CaptureFixture[str]):
    assert main(["explain", "fast-timer", "--plugins"]) == 0
    assert "of tools/our_rules.py*" in capsys.readouterr().out
    main(["rules", "--plugins", "--format", "json"])
    listed = {row["code"]: row["plugin"] for row in json.loads(capsys.readouterr().out)["rules"]}
    assert (listed["XRT001"], listed["SRV001"]) == ("tools/our_rules.py", None)
    main(["config", "--plugins", "--schema"])
    options = json.loads(capsys.readouterr().out)["properties"]["rules"]["properties"]
    assert options["fast-timer"]["properties"]["max-rate"]["default"] == 100
    main(["config", "--plugins"])
    assert 'plugins = ["tools/our_rules.py"]' in capsys.readouterr().out


def test_explain_says_where_its_rule_may_be(repository: Path, capsys: pytest.CaptureFixture[str]):
    assert main(["explain", "XRT001"]) == 2
    assert "the rules of tools/our_rules.py are left out; --plugins runs them" in capsys.readouterr().err


# --- nothing of it stays


def test_the_next_run_knows_nothing_of_it(repository: Path):
    before = dict(sys.modules)
    assert found()[0] == 1
    assert rules() is own_rules()
    assert "XRT001" not in registered()
    assert not [name for name in sys.modules.keys() - before.keys() if "archlint_plugin" in name]


def test_two_workspaces_with_one_code_each_have_their_own(repository: Path, tmp_path: Path):
    other = tmp_path / "other"
    (other / "tools").mkdir(parents=True)
    for name in ("archlint.toml", "wheels.py", RULES, PAGE):
        (other / name).write_text(Path(name).read_text().replace("our computer", "their computer"))
    spaces = [archlint.load(folder, plugins=True) for folder in (repository, other) * 2]
    with ThreadPoolExecutor(4) as pool:
        messages = [result.findings[0].message for result in pool.map(archlint.Workspace.check, spaces)]
    assert ["our computer" in message for message in messages] == [True, False, True, False]


def test_a_kept_result_is_one_of_the_same_plugin(repository: Path, capsys: pytest.CaptureFixture[str]):
    main(["check", "--plugins"])
    change(RULES, "our computer can", "this computer can")
    main(["check", "--plugins"])
    change(PAGE, "severity: warning", "severity: error")
    main(["check", "--plugins"])
    first, second, third = capsys.readouterr().out.split("[XRT001]")[1:]
    assert "our computer can" in first
    assert "this computer can" in second
    assert second.endswith("error")
    assert "this computer can" in third


@pytest.mark.parametrize(("variable", "codes"), [("1", ["XRT001"]), ("0", []), ("", [])])
def test_an_editor_shows_it_where_the_environment_says_so(
    variable: str, codes: list[str], repository: Path, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.setenv("ARCHLINT_PLUGINS", variable)
    settings = Configuration().again(str(repository), {}).settings
    seen = LiveWorkspace(str(repository)).analyse(Asked((str(repository),), settings), {})
    assert [found.code for found in seen.findings] == codes


def test_an_editor_has_it_as_it_is_now(repository: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setenv("ARCHLINT_PLUGINS", "1")
    first = Configuration().again(str(repository), {})
    assert [name for name in (RULES, PAGE, "wheels.py") if first.is_read_from(str(repository / name))] == [RULES, PAGE]
    change(RULES, "our computer", "this computer")
    edited = first.again(str(repository), {})
    assert edited.settings != first.settings
    assert not edited.mistakes
    change(RULES, "def fast_timer", "def")
    [mistake] = first.again(str(repository), {}).mistakes
    assert (mistake.path, mistake.line) == (str(repository / "archlint.toml"), 1)
    assert "our_rules.py: line 11: SyntaxError" in mistake.message


# --- rules that fail


@pytest.mark.parametrize(
    ("code", "said"),
    [
        ("raise ZeroDivisionError('no rate')", "ZeroDivisionError: no rate (our_rules.py:"),
        ("options.number('rate')", "KeyError: 'rate' (our_rules.py:14)"),
        ("raise SystemExit(0)", "it ends the process: sys.exit(0)"),
        ("yield finding('NME001', system.nodes[0].blueprint.place, 'm')", "which is no finding of XRT001"),
        ("yield 'a text'", "it yields 'a text', which is no finding of XRT001"),
    ],
)
def test_a_rule_that_fails_is_a_finding(code: str, said: str, repository: Path):
    change(RULES, "    for node in system.nodes:", f"    {code}\n    for node in system.nodes:")
    result = archlint.load(repository, plugins=True).check()
    [failure] = [one for one in result.findings if one.code == "LNT003"]
    assert said in failure.message
    assert failure.help == "this is an error in tools/our_rules.py, which brings the rule"
    assert main(["check", "--plugins"]) == 2


# --- plugins that cannot be used

OTHER = '@rule("SRV900", scope=Scope.CODE)\ndef other(system, options):\n    yield from ()\n'


@pytest.mark.parametrize(
    ("file", "old", "new", "said"),
    [
        (RULES, "from __future__", "nonsense ", "line 3: SyntaxError"),
        (RULES, "@rule", "1 / 0\n\n\n@rule", "line 10: ZeroDivisionError: division by zero"),
        (RULES, "@rule", "raise SystemExit(3)\n@rule", "line 10: SystemExit: 3"),
        (RULES, "@rule", "def rule(*a, **b):\n    return print\n@rule", "no rule in it"),
        (RULES, '"XRT001", scope', '"XRT002", scope', "XRT002 has no page: XRT002-<its name>.md beside the plugin"),
        (RULES, '"XRT001", scope', '"FAST", scope', "'FAST' is no code of a rule"),
        (PAGE, "name: fast-timer", "name: quick-timer", "should be called XRT001-quick-timer.md"),
        (PAGE, "severity: warning", "severity: grave", "is missing or not a known word"),
        (PAGE, "fix: none", "fix: safe", "the rules of plugins have no fixes"),
    ],
)
def test_what_is_wrong_with_a_plugin_is_said_at_the_key(file: str, old: str, new: str, said: str, repository: Path):
    change(file, old, new)
    with pytest.raises(ConfigurationError) as raised:
        load(repository, plugins=True)
    assert (raised.value.file, raised.value.line) == ("archlint.toml", 1)
    assert raised.value.message.startswith("tools/our_rules.py: ")
    assert said in raised.value.message


@pytest.mark.parametrize(
    ("page", "said"),
    [
        ("SRV900-other-rule", "SRV, with which SRV900 starts, is taken by archlint"),
        ("XRT001-fast-timer", "XRT, with which XRT001 starts, is taken by tools/our_rules.py"),
        ("XAB001-nested-service-call", "SRV003 is called nested-service-call, too: rename XAB001"),
        ("XAB001-fast-timer", "XRT001 is called fast-timer, too: rename XAB001"),
    ],
)
def test_no_two_rules_share_a_prefix_or_a_name(page: str, said: str, repository: Path):
    code, _, name = page.partition("-")
    more = repository / "more"
    more.mkdir()
    text = Path(PAGE).read_text().replace("code: XRT001", f"code: {code}").replace("name: fast-timer", f"name: {name}")
    (more / f"{page}.md").write_text(text)
    (more / "more.py").write_text(f"from archlint.api import Scope, rule\n{OTHER.replace('SRV900', code)}")
    change("archlint.toml", f'["{RULES}"]', f'["{RULES}", "more/more.py"]')
    with pytest.raises(ConfigurationError, match=f"more/more.py: {said}"):
        load(repository, plugins=True)


def test_no_code_of_archlint_starts_with_x():
    """The guide promises that: such codes are the teams' own."""
    assert [code for code in own_rules() if code.startswith("X")] == []


# --- installed plugins


@pytest.fixture
def team_rules(repository: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The same rules as a module that is installed outside of the repository, under the name ``team``."""
    folder = tmp_path / "installed" / "team_rules"
    folder.mkdir(parents=True)
    for name in (RULES, PAGE):
        Path(name).rename(folder / Path(name).name)
    (folder / "our_rules.py").rename(folder / "__init__.py")
    change("archlint.toml", RULES, "team")
    monkeypatch.syspath_prepend(folder.parent)
    monkeypatch.delitem(sys.modules, "team_rules", raising=False)
    point = EntryPoint("team", "team_rules", installed.GROUP)
    monkeypatch.setattr(installed, "entry_points", lambda group: [point] if group == "archlint.rules" else [])
    return folder


def test_what_is_installed_needs_no_permission(team_rules: Path, capsys: pytest.CaptureFixture[str]):
    assert main(["check", "--format", "concise"]) == 1
    assert "XRT001" in capsys.readouterr().out
    assert main(["check", "--no-plugins"]) == 0


def test_what_is_installed_from_the_repository_needs_one(team_rules: Path, repository: Path, monkeypatch):
    team_rules.rename(repository / "team_rules")
    monkeypatch.syspath_prepend(repository)
    with pytest.raises(ConfigurationError, match="the plugin team is Python code of this repository"):
        load(repository)
    assert "team_rules" not in sys.modules
    assert [plugin.name for plugin in load(repository, plugins=True).running_plugins] == ["team"]


def test_a_name_that_nothing_has(team_rules: Path):
    change("archlint.toml", '"team"', '"teem"')
    with pytest.raises(ConfigurationError, match=r"no plugin of that name is installed.*did you mean `team`"):
        load(Path())
