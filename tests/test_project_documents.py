"""The documents beside the README: addresses that agree, issue forms that ask for what is needed, a changelog."""

from __future__ import annotations

import re
import sys
from pathlib import Path

import pytest
import yaml

from archlint import __version__
from archlint.project import REPOSITORY, is_placeholder, issue_tracker

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

ROOT = Path(__file__).parents[1]
FORMS = sorted(path for path in (ROOT / ".github" / "ISSUE_TEMPLATE").glob("*.yml") if path.name != "config.yml")
WITH_ADDRESS = ("pyproject.toml", "README.md", "SECURITY.md", ".github/ISSUE_TEMPLATE/config.yml")
DOCUMENTS = sorted({*ROOT.glob("*.md"), *(ROOT / ".github").rglob("*.*"), ROOT / "pyproject.toml"})


def addresses(path: Path) -> list[str]:
    """What a file gives as an address of archlint itself: the placeholder's host, or the repository's."""
    return [found for found in re.findall(r"https?://[^\s\"'`<>)]+", path.read_text("utf-8")) if "archlint" in found]


@pytest.mark.parametrize(
    ("address", "placeholder"),
    [
        ("https://archlint.invalid", True),
        ("https://archlint.invalid/issues", True),
        ("https://github.com/somebody/archlint", False),
        ("https://github.com/somebody/archlint.invalid", False),
    ],
)
def test_a_placeholder_is_told_from_a_real_address(address: str, placeholder: bool):
    assert is_placeholder(address) is placeholder


def test_a_message_shows_only_an_address_that_leads_somewhere():
    assert issue_tracker("https://archlint.invalid") == "archlint's issue tracker"
    assert issue_tracker("https://github.com/somebody/archlint") == "https://github.com/somebody/archlint/issues"


@pytest.mark.parametrize("path", DOCUMENTS, ids=lambda path: path.relative_to(ROOT).as_posix())
def test_every_address_of_archlint_is_the_repository(path: Path):
    assert [one for one in addresses(path) if not one.startswith(REPOSITORY)] == []


@pytest.mark.parametrize("name", WITH_ADDRESS)
def test_what_needs_an_address_has_it(name: str):
    assert addresses(ROOT / name)


def test_the_package_says_where_it_comes_from():
    urls = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]["urls"]
    assert urls["Source"] == REPOSITORY
    assert urls["Issues"] == f"{REPOSITORY}/issues"


@pytest.mark.parametrize("path", FORMS, ids=lambda path: path.stem)
def test_an_issue_form_asks_for_the_version_and_the_smallest_file(path: Path):
    body = {part["id"]: part for part in yaml.safe_load(path.read_text("utf-8"))["body"] if "id" in part}
    assert "archlint --version" in body["version"]["attributes"]["description"]
    assert "smallest file" in body["file"]["attributes"]["label"]
    wanted = path.stem != "question"
    assert all(body[one].get("validations", {}).get("required", False) is wanted for one in ("version", "file"))


def test_there_is_a_form_for_each_kind_of_issue():
    assert [path.stem for path in FORMS] == ["crash", "false-finding", "missed-finding", "question"]


def test_the_changelog_keeps_to_its_format():
    text = (ROOT / "CHANGELOG.md").read_text("utf-8")
    versions = re.findall(r"^## \[(.+?)\]", text, re.MULTILINE)
    groups = set(re.findall(r"^### (.+)$", text, re.MULTILINE))
    assert versions[0] == "Unreleased"
    assert groups <= {"Added", "Changed", "Deprecated", "Removed", "Fixed", "Security"}
    released = versions[1:]
    assert not released or released[0] == __version__


@pytest.mark.parametrize("name", ["CHANGELOG.md", "SECURITY.md", "CONTRIBUTING.md", "ARCHITECTURE.md"])
def test_what_a_document_points_at_exists(name: str):
    text = (ROOT / name).read_text("utf-8")
    for link in re.findall(r"\]\(([^)#]+)[^)]*\)", text):
        assert link.startswith("https://") or (ROOT / link).exists(), link


@pytest.mark.parametrize("name", ["CHANGELOG.md", "SECURITY.md", "ARCHITECTURE.md"])
def test_a_rule_that_a_document_names_exists(name: str):
    text = (ROOT / name).read_text("utf-8")
    codes = set(re.findall(r"\b[A-Z]{3}\d{3}\b", text))
    assert [code for code in sorted(codes) if not list((ROOT / "rules").glob(f"{code}-*.md"))] == []


def test_the_rule_of_the_recipe_is_one_that_there_is_not():
    [code] = re.findall(r"`rules/([A-Z]{3}\d{3})-", (ROOT / "CONTRIBUTING.md").read_text("utf-8"))
    assert list((ROOT / "rules").glob(f"{code}-*")) == []


def test_the_paths_of_the_recipes_exist():
    text = (ROOT / "CONTRIBUTING.md").read_text("utf-8")
    named = set(re.findall(r"`((?:src|tests|tests_ros|scripts|fixtures|benchmarks)/[\w/.]+)`", text))
    assert len(named) > 12
    assert [path for path in sorted(named) if not (ROOT / path).exists()] == []


def test_the_tests_of_the_promises_exist():
    text = (ROOT / "SECURITY.md").read_text("utf-8")
    named = re.findall(r"`(tests(?:_page)?/[\w/]+\.py)::(\w+)`", text)
    assert len(named) > 28
    assert [path for path in re.findall(r"`(tests(?:_page)?/[\w/.]+)`", text) if not (ROOT / path).exists()] == []
    missing = [test for file, test in named if f"def {test}(" not in (ROOT / file).read_text("utf-8")]
    assert missing == []
