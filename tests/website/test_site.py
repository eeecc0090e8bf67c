"""The pages of the site are made of what is there, and lead to each other; nothing is built here."""

from __future__ import annotations

import importlib
import posixpath
import re
from pathlib import Path

import pytest
import yaml
from website.__main__ import main
from website.links import anchors_of, targets_of
from website.sources import ROOT, highlighted

from archlint import api
from archlint.checks.registry import registered
from archlint.cli import COMMANDS
from archlint.config.schema import ConfigurationFile
from archlint.rulebook import rules
from website import site


@pytest.fixture(scope="module")
def pages() -> dict[str, str]:
    return site.pages()


def test_every_rule_has_a_page_without_marks(pages: dict[str, str]):
    for rule in rules().values():
        page = pages[f"rules/{rule.code}-{rule.name}.md"]
        assert page.startswith(f"# {rule.title}\n\n*{rule.severity.label}, ")
        assert "expect:" not in page


def test_a_line_that_breaks_a_rule_has_a_colour():
    page = "```python\na()\nb()  # expect: SRV003\nc()\nd()  # expect: SRV003, TMO002\n```\n\n```python\na()\n```\n"
    assert highlighted(page) == '```python hl_lines="2 4"\na()\nb()\nc()\nd()\n```\n\n```python\na()\n```\n'


@pytest.mark.parametrize("command", COMMANDS)
def test_every_command_has_its_options(command: str, pages: dict[str, str]):
    part = pages["commands.md"].partition(f"## archlint {command}\n")[2].partition("\n## ")[0]
    for action in importlib.import_module(f"archlint.cli.{command}").parser()._actions:
        for option in action.option_strings:
            assert re.search(rf"`[^`]*{option}\b", part) or option in ("-h", "--help")


def test_every_key_and_every_option_is_in_the_reference(pages: dict[str, str]):
    page = pages["configuration.md"]
    assert page.startswith("# Configure\n")
    for key in ConfigurationFile.__struct_encode_fields__:
        assert f"| `{key}` | " in page
    for code, check in registered().items():
        for option in check.defaults:
            assert f"-{rules()[code].name}.md#options) | `{option}` | " in page


def test_every_public_name_is_in_the_reference(pages: dict[str, str]):
    titles = re.findall(r"^### (\w+)$", pages["docs/api.md"], re.MULTILINE)
    assert titles == api.__all__
    assert ":class:" not in pages["docs/api.md"]


def test_every_link_leads_to_a_page_and_a_heading(pages: dict[str, str]):
    pictures = {
        f"pictures/{picture.name}" for ending in ("svg", "png") for picture in (ROOT / "docs").glob(f"*.{ending}")
    }
    anchors = {page: anchors_of(text) for page, text in pages.items()}
    lost = []
    for page, text in pages.items():
        for target in (target for target in targets_of(text) if not re.match(r"[a-z]+:", target)):
            path, _, anchor = target.partition("#")
            there = posixpath.normpath(posixpath.join(posixpath.dirname(page), path)) if path else page
            if there not in pages.keys() | pictures or (anchor and anchor not in anchors[there]):
                lost.append(f"{page}: {target}")
    assert lost == []


def test_the_menu_has_every_page_once(pages: dict[str, str]):
    assert sorted(page for _, page in site._flat(site.navigation(pages))) == sorted(pages)


def test_what_is_written_is_what_mkdocs_reads(tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    assert main(tmp_path) == 0
    assert "links elsewhere, listed in" in capsys.readouterr().out
    made = yaml.safe_load((tmp_path / "mkdocs.yml").read_text())
    assert (tmp_path / made["docs_dir"] / "index.md").is_file()
    assert (tmp_path / "external-links.txt").read_text().startswith("http")
    assert Path(made["INHERIT"]).is_file()
    look = yaml.load((ROOT / "mkdocs.yml").read_text(), Loader=_Plain)
    assert all((tmp_path / "pages" / file).is_file() for file in look["extra_css"])
    assert look["theme"]["font"] is False  # nothing is loaded from elsewhere


class _Plain(yaml.SafeLoader):
    """Takes the names of Python functions for what they are applied to."""


_Plain.add_multi_constructor("", lambda loader, suffix, node: loader.construct_mapping(node))
