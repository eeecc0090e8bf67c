"""Links between documents, as links between pages."""

from __future__ import annotations

from pathlib import Path

import pytest
from website.links import BrokenLink, anchors_of, for_python_markdown, targets_of, with_links

HOMES = {
    "README.md": "index.md",
    "README.md#configure": "configuration.md",
    "rules/SRV003-nested.md": "rules/SRV003-nested.md",
    "rules/README.md": "rules/index.md",
}


@pytest.mark.parametrize(
    ("path", "page", "target", "expected"),
    [
        ("README.md", "index.md", "rules/SRV003-nested.md", "rules/SRV003-nested.md"),
        ("README.md", "index.md", "rules/README.md", "rules/index.md"),
        ("README.md", "index.md", "rules", "rules/index.md"),
        ("README.md", "configuration.md", "#use", "index.md#use"),
        ("README.md", "index.md", "#configure", "configuration.md#configure"),
        ("rules/README.md", "rules/index.md", "../README.md#configure", "../configuration.md#configure"),
        ("rules/SRV003-nested.md", "rules/SRV003-nested.md", "#bad", "SRV003-nested.md#bad"),
        ("README.md", "index.md", "LICENSE", "https://archlint.invalid/blob/main/LICENSE"),
        ("docs/api.md", "docs/api.md", "check.svg", "../pictures/check.svg"),
        ("README.md", "index.md", "https://docs.ros.org/", "https://docs.ros.org/"),
    ],
)
def test_a_link_leads_to_the_page_of_its_file(path: str, page: str, target: str, expected: str, tmp_path: Path):
    for name in ("LICENSE", "docs/check.svg"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).touch()
    assert with_links(f"see [this]({target}).", path, page, HOMES, tmp_path) == f"see [this]({expected})."


def test_a_link_to_nothing_is_an_error(tmp_path: Path):
    with pytest.raises(BrokenLink, match=r"README.md: docs/none.md leads nowhere"):
        with_links("[none](docs/none.md)", "README.md", "index.md", HOMES, tmp_path)


@pytest.mark.parametrize("text", ["`[a](b)`", "```toml\n[a](b)\n```\n", "  ```\n  [a](b)\n  ```\n"])
def test_code_has_no_links(text: str, tmp_path: Path):
    assert with_links(text, "README.md", "index.md", HOMES, tmp_path) == text
    assert list(targets_of(text)) == []


def test_anchors_are_those_of_github_but_for_the_second_of_a_name():
    text = "# A `b`: c-d!\n```sh\n# no heading\n```\n## [Link](x.md) _e_\n### Bad\n### Bad\n"
    assert anchors_of(text) == ["a-b-c-d", "link-_e_", "bad", "bad_1"]


def test_a_list_behind_a_line_is_a_list():
    assert for_python_markdown("Say:\n- one\n- two\n  more\n- three") == "Say:\n\n- one\n- two\n  more\n- three"
    assert for_python_markdown("## Reported\n- one\n") == "## Reported\n- one\n"
    assert for_python_markdown("```\na\n- b\n```\n") == "```\na\n- b\n```\n"
