"""The pages of the rule book are written alike, and their index is current."""

from __future__ import annotations

import re
from importlib.machinery import SourceFileLoader
from importlib.util import module_from_spec, spec_from_loader
from pathlib import Path

import pytest

from archlint.checks.registry import registered
from archlint.cli.rule_page import shown
from archlint.rulebook import Rule, pages_folder, rules

ROOT = Path(__file__).parents[1]
CONFIGURED_ELSEWHERE = {"ARC001", "ARC002", "ARC003", "OWN001", "OWN003"}
"""Rules whose options are tables of the configuration itself."""


def prose(text: str) -> str:
    """A page without its code blocks."""
    return re.sub(r"^```.*?^```$", "", text, flags=re.MULTILINE | re.DOTALL)


@pytest.mark.parametrize("rule", rules().values(), ids=lambda rule: rule.code)
def test_a_page_has_these_sections_in_this_order(rule: Rule):
    check = registered().get(rule.code)
    has_options = rule.code in CONFIGURED_ELSEWHERE or (check is not None and bool(check.defaults))
    assert re.findall(r"^## (.*)$", prose(rule.body), re.MULTILINE) == [
        "Reported",
        "Not reported",
        "Why it matters",
        "Bad",
        "Good",
        *(["Fix"] if rule.fix else []),
        *(["Options"] if has_options else []),
        "References",
    ]


@pytest.mark.parametrize("rule", rules().values(), ids=lambda rule: rule.code)
def test_what_is_reported_and_what_is_not_are_lists(rule: Rule):
    sections = dict(zip(*[iter(re.split(r"^## (.*)\n", rule.body, flags=re.MULTILINE)[1:])] * 2, strict=True))
    for heading in ("Reported", "Not reported", "References"):
        assert sections[heading].startswith("- "), heading


@pytest.mark.parametrize("rule", rules().values(), ids=lambda rule: rule.code)
def test_a_page_documents_each_option_of_its_rule(rule: Rule):
    check = registered().get(rule.code)
    for option in check.defaults if check is not None else ():
        assert f"| `{option}` |" in rule.body


@pytest.mark.parametrize("rule", rules().values(), ids=lambda rule: rule.code)
def test_links_to_other_pages_lead_somewhere(rule: Rule):
    for target in re.findall(r"\]\(([^)#:]+)(?:#[^)]*)?\)", prose(rule.body)):
        assert (pages_folder() / target).exists(), target


@pytest.mark.parametrize("rule", rules().values(), ids=lambda rule: rule.code)
def test_a_link_to_documentation_or_source_names_a_release(rule: Rule):
    """A file of a branch may be another one tomorrow."""
    for link in re.findall(r"\]\((https://(?:docs\.ros\.org|github\.com)/[^)]*)\)", rule.body):
        assert re.search(r"/en/jazzy/|/(?:blob|tree)/\d+\.\d+\.\d+(?:/|$)|/(?:issues|pull)/\d+$", link), link


@pytest.mark.parametrize("rule", rules().values(), ids=lambda rule: rule.code)
def test_explain_shows_one_block_of_each_kind(rule: Rule):
    bad, _, rest = shown(rule, "").text.partition("\n## Bad\n")[2].partition("\n## Good\n")
    good = re.split(r"^## ", rest, flags=re.MULTILINE)[0]
    blocks = 0 if rule.code == "LNT003" else 1
    assert [len(re.findall(r"^```\w", text, re.MULTILINE)) for text in (bad, good)] == [blocks, blocks]
    assert bad != good or not blocks


def test_the_index_is_current():
    loader = SourceFileLoader("generate_rule_index", str(ROOT / "scripts" / "generate_rule_index"))
    spec = spec_from_loader(loader.name, loader)
    assert spec is not None
    script = module_from_spec(spec)
    loader.exec_module(script)
    assert (ROOT / "rules" / "README.md").read_text(encoding="utf-8") == script.index(), (
        "run scripts/generate_rule_index"
    )
