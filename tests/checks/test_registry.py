"""How rules are registered, selected and run."""

from __future__ import annotations

import pytest

from archlint.checks.registry import Options, finding, registered, rule, unreadable
from archlint.checks.scope import Scope
from archlint.config.options import options_for
from archlint.config.settings import Settings
from archlint.engine.judging import judge
from archlint.finding import Place, Severity
from archlint.systems.model import System
from registering import only

HERE = Place("a.py", 3, 1, 3, 9)
EMPTY = System(name="robot.launch.py", nodes=[], programs=[])


def test_a_finding_takes_name_and_severity_from_the_rules_page():
    found = finding("SRV003", HERE, "it waits", help="do not", node="/a", identity=("/a", "/b"))
    assert (found.name, found.severity) == ("nested-service-call", Severity.ERROR)
    assert (found.message, found.help, found.node, found.identity) == ("it waits", "do not", "/a", ("/a", "/b"))


def test_findings_carry_the_system_they_are_about(monkeypatch: pytest.MonkeyPatch):
    @rule("SRV003", scope=Scope.CODE)
    def one(system, options):
        yield finding("SRV003", HERE, "it waits")

    only(monkeypatch, one)
    [found] = judge(EMPTY, options_for(Settings(), ["SRV003"]))
    assert found.system == "robot.launch.py"


def test_only_what_is_selected_runs(monkeypatch: pytest.MonkeyPatch):
    @rule("SRV003", scope=Scope.CODE)
    def one(system, options):
        pytest.fail("not selected")

    @rule("SRV002", scope=Scope.CODE)
    def other(system, options):
        yield finding("SRV002", HERE, "types differ")

    only(monkeypatch, one, other)
    assert [found.code for found in judge(EMPTY, options_for(Settings(), ["SRV002"]))] == ["SRV002"]


def test_a_code_has_one_function(monkeypatch: pytest.MonkeyPatch):
    def function(system, options):
        return iter(())

    one, other = (rule("SRV003", scope=Scope.CODE)(function) for _ in range(2))
    only(monkeypatch, one, one)
    assert registered() == {"SRV003": one}
    only(monkeypatch, one, other)
    with pytest.raises(ValueError, match="SRV003 is registered twice"):
        registered()


def test_a_rule_says_its_scope():
    with pytest.raises(TypeError, match="scope"):
        rule("SRV003")  # type: ignore[call-arg]


def test_nobody_can_add_a_rule_to_the_others(monkeypatch: pytest.MonkeyPatch):
    one = rule("SRV003", scope=Scope.CODE, limit=3)(lambda system, options: iter(()))
    only(monkeypatch, one)
    with pytest.raises(TypeError):
        registered()["SRV002"] = one  # type: ignore[index]
    with pytest.raises(TypeError):
        one.defaults["limit"] = 4  # type: ignore[index]


def test_options_have_their_defaults_and_the_configurations_values(monkeypatch: pytest.MonkeyPatch):
    own = rule("SRV003", scope=Scope.CODE, max_depth=3, strict=False, allowed=("/ping",), unit="s")
    only(monkeypatch, own(lambda *_: iter(())))
    settings = Settings(rules={"SRV003": {"max-depth": 5}}, distro="jazzy", shared_topics=("/bus/*",))
    options = options_for(settings, ["SRV003", "LNT002"])["SRV003"]
    assert (options.number("max-depth"), options.flag("strict")) == (5, False)
    assert (options.texts("allowed"), options.text("unit")) == (("/ping",), "s")
    assert options.distros == ("jazzy",)
    assert (options.is_shared("/bus/left"), options.is_shared("/bus")) == (True, False)


def test_a_rule_that_raises_takes_nothing_else_down(monkeypatch: pytest.MonkeyPatch):
    @rule("SRV002", scope=Scope.CODE)
    def broken(system, options: Options):
        raise ZeroDivisionError("by zero")
        yield

    @rule("SRV003", scope=Scope.CODE)
    def sound(system, options):
        yield finding("SRV003", HERE, "it waits")

    only(monkeypatch, broken, sound)
    failed, found = judge(EMPTY, options_for(Settings(), registered()))
    assert (failed.code, found.code) == ("LNT003", "SRV003")
    assert failed.place.file == "robot.launch.py"
    assert failed.message.startswith(
        "the rule SRV002 service-type-mismatch failed with ZeroDivisionError: by zero (test_registry.py:"
    )


def test_what_cannot_be_read_is_the_users_file_or_our_fault():
    theirs = unreadable("a.py", 3, 7, "syntax error: expected ':'")
    assert (theirs.code, theirs.message) == ("LNT002", "syntax error: expected ':'")
    assert theirs.place == Place("a.py", 3, 7, 3, 7)
    ours = unreadable("a.py", 1, 1, "KeyError: 'x'", internal=True)
    assert ours.code == "LNT003"
    assert unreadable("a.py", 1, 1, "internal error: KeyError: 'x'").code == "LNT002"
    assert ours.message == "reading this file failed with KeyError: 'x'; everything else was checked"
    assert "please report it" in ours.help
