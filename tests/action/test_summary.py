"""The summary of a job, as Markdown."""

from __future__ import annotations

import re
from html import unescape
from typing import Any

import pytest
from drawing import Drawing
from hypothesis import given, strategies
from markdown_it import MarkdownIt
from summary import MOST_CHARACTERS, MOST_EDGES, MOST_FINDINGS, SourceLinks, failure, markdown

COUNTS = {"files": 3, "nodes": 2, "errors": 1, "warnings": 0, "infos": 0, "suppressed": 0, "unresolved": 0}


def finding(**changes: Any) -> dict[str, Any]:
    first = {"code": "TOP001", "severity": "error", "message": "no", "file": "robot/a.py", "line": 3}
    return first | changes


def report(*findings: dict[str, Any], **counts: int) -> dict[str, Any]:
    return {"diagnostics": [*findings], "summary": COUNTS | counts}


def test_the_counts_come_first_and_errors_before_the_rest():
    text = markdown(report(finding(severity="info"), finding(), warnings=2, infos=1), Drawing(), SourceLinks())
    assert text.startswith("## archlint: 1 error, 2 warnings, 1 information\n\nIn 3 files with 2 nodes.\n")
    assert [line.split()[1] for line in text.splitlines() if "TOP001" in line] == ["error", "info"]


def test_what_is_not_reported_is_counted():
    text = markdown(report(suppressed=1, baselined=4, older=2), Drawing(), SourceLinks(), "origin/main")
    assert "What is new since origin/main, in 3 files with 2 nodes; 1 suppressed; 4 held back by the baseline; " in text
    assert "; 2 not new.\n" in text


def test_a_long_table_says_what_it_leaves_out():
    text = markdown(report(*[finding()] * (MOST_FINDINGS + 7)), Drawing(), SourceLinks())
    assert text.count("| error |") == MOST_FINDINGS
    assert "… and 7 more: " in text


@pytest.mark.parametrize(
    ("hostile", "shown"),
    [
        ("a | b", r"a \| b"),
        ("a\n## b", r"a \#\# b"),
        ("<img src=x>", "&lt;img src=x&gt;"),
        ("[a](https://example.com)", r"\[a\](https://example.com)"),
        ("@kim `x` *y*", r"&#64;kim \`x\` \*y\*"),
    ],
)
def test_text_of_the_source_is_shown_and_means_nothing(hostile: str, shown: str):
    text = markdown(report(finding(message=hostile, file=f"{hostile}.py")), Drawing(), SourceLinks())
    assert f"| {shown}.py:3 | {shown} |\n" in text


def test_a_file_is_linked_from_the_root_of_the_repository():
    links = SourceLinks("https://github.com/kim/robot/blob/c0ffee", "ws")
    assert links.place("src/a b.py", 3) == "[src/a b.py:3](https://github.com/kim/robot/blob/c0ffee/ws/src/a%20b.py#L3)"
    assert links.place("../../elsewhere.py", 3) == "../../elsewhere.py:3"


def graph(edges: int) -> str:
    return "flowchart LR\n" + "".join(f"  n{number} --> n0\n" for number in range(edges))


@pytest.mark.parametrize(
    ("drawn", "fits"),
    [
        (graph(MOST_EDGES), True),
        (graph(MOST_EDGES + 1), False),
        ("flowchart LR\n  n0[" + "x" * MOST_CHARACTERS + "]\n", False),
    ],
)
def test_a_graph_is_drawn_where_github_can(drawn: str, fits: bool):
    text = markdown(report(finding()), Drawing("the nodes", drawn), SourceLinks())
    assert (f"```mermaid\n{drawn}```\n" in text) is fits
    assert ("too large for GitHub to draw" in text) is not fits


def test_the_reason_of_a_failure_is_a_block_of_plain_text():
    assert failure("error: <b>\n```") == "## archlint: the run failed\n\n    error: <b>\n    ```\n\n"


def test_a_graph_that_would_end_its_block_is_left_out():
    assert "evil" not in markdown(report(), Drawing("the nodes", "flowchart LR\n```\nevil\n"), SourceLinks())


@given(strategies.text("ab1 \\`*_{}[]()<>#+-.!|~&;:/@$^='\"\n\t", min_size=1))
def test_every_message_is_read_back_as_it_was(message: str):
    rendered = MarkdownIt("gfm-like", {"linkify": False}).render(
        markdown(report(finding(message=message)), Drawing(), SourceLinks())
    )
    [cell] = re.findall(r"<td>robot/a.py:3</td>\n<td>(.*?)</td>", rendered, re.DOTALL)
    assert "<" not in cell
    shown = "".join(char if char.isprintable() else " " for char in message)
    assert unescape(cell).split() == shown.split()
