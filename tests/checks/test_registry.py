"""How rules are registered, selected and run."""

from __future__ import annotations

import pytest

from archlint import checks
from archlint.checks import registry
from archlint.checks.registry import Options, finding, judge, options_for, registered, rule, unreadable
from archlint.config.settings import Settings
from archlint.finding import Place, Severity
from archlint.systems.model import System

HERE = Place("a.py", 3, 1, 3, 9)
EMPTY = System(name="robot.launch.py", nodes=[], programs=[])


@pytest.fixture(autouse=True)
def no_rules(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(registry, "_REGISTERED", {})
    monkeypatch.setattr(checks, "MODULES", ())


def test_a_finding_takes_name_and_severity_from_the_rules_page():
    found = finding("SRV003", HERE, "it waits", help="do not", node="/a", identity=("/a", "/b"))
    assert (found.name, found.severity) == ("nested-service-call", Severity.ERROR)
    assert (found.message, found.help, found.node, found.identity) == ("it waits", "do not", "/a", ("/a", "/b"))


def test_findings_carry_the_system_they_are_about():
    @rule("SRV003")
    def one(system, options):
        yield finding("SRV003", HERE, "it waits")

    [found] = judge(EMPTY, options_for(Settings(), ["SRV003"]))
    assert found.system == "robot.launch.py"


def test_only_what_is_selected_runs():
    @rule("SRV003")
    def one(system, options):
        pytest.fail("not selected")

    @rule("SRV002")
    def other(system, options):
        yield finding("SRV002", HERE, "types differ")

    assert [found.code for found in judge(EMPTY, options_for(Settings(), ["SRV002"]))] == ["SRV002"]


def test_a_code_has_one_function():
    def register(module: str) -> None:
        def function(system, options):
            return iter(())

        function.__module__ = module
        rule("SRV003")(function)

    register("archlint.checks.services")
    with pytest.raises(ValueError, match="SRV003 is registered twice"):
        register("archlint.checks.topics")


def test_options_have_their_defaults_and_the_configurations_values():
    rule("SRV003", max_depth=3, strict=False, allowed=("/ping",), unit="s")(lambda *_: iter(()))
    settings = Settings(rules={"SRV003": {"max-depth": 5}}, distro="jazzy", shared_topics=("/bus/*",))
    options = options_for(settings, ["SRV003", "LNT002"])["SRV003"]
    assert (options.number("max-depth"), options.flag("strict")) == (5, False)
    assert (options.texts("allowed"), options.text("unit")) == (("/ping",), "s")
    assert options.distros == ("jazzy",)
    assert (options.is_shared("/bus/left"), options.is_shared("/bus")) == (True, False)


def test_a_rule_that_raises_takes_nothing_else_down():
    @rule("SRV002")
    def broken(system, options: Options):
        raise ZeroDivisionError("by zero")
        yield

    @rule("SRV003")
    def sound(system, options):
        yield finding("SRV003", HERE, "it waits")

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
    ours = unreadable("a.py", 1, 1, "internal error: KeyError: 'x'")
    assert ours.code == "LNT003"
    assert ours.message == "reading this file failed with KeyError: 'x'; everything else was checked"
    assert "please report it" in ours.help
