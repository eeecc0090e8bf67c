"""Markdown as GitHub reads it: what a page shows, whatever stands in its source."""

from __future__ import annotations

from collections.abc import Iterator

from markdown_it import MarkdownIt
from markdown_it.token import Token

READER = MarkdownIt("commonmark", {"html": True}).enable(["table", "strikethrough"])
"""HTML is read as such, so that what becomes HTML can be told."""


def tokens(source: str) -> Iterator[Token]:
    for token in READER.parse(source):
        yield token
        yield from token.children or ()


def html_in(source: str) -> list[str]:
    """All HTML in a source."""
    return [token.content for token in tokens(source) if token.type in ("html_inline", "html_block")]


def shown(inline: Token) -> str:
    """What is shown of a line: its texts, those in the type of code among them."""
    breaks = {"softbreak": " ", "hardbreak": "\n"}
    return "".join(breaks.get(child.type, child.content) for child in inline.children or ())


def tables(source: str) -> list[list[list[str]]]:
    """The tables of a page: rows of the texts of cells, titles first."""
    rows_of_tables: list[list[list[str]]] = []
    for token in READER.parse(source):
        if token.type == "table_open":
            rows_of_tables.append([])
        elif token.type == "tr_open":
            rows_of_tables[-1].append([])
        elif token.type == "inline" and rows_of_tables and rows_of_tables[-1] and token.level >= 4:
            rows_of_tables[-1][-1].append(shown(token))
    return rows_of_tables


def table_under(source: str, title: str) -> list[list[str]]:
    """The rows of the first table under a heading, without its titles."""
    below = source.partition(f"\n## {title}\n")[2]
    assert below, f"no heading {title}"
    return tables(below.partition("\n## ")[0])[0][1:]


def links_in(source: str) -> list[str]:
    """The targets of all links."""
    return [str(token.attrs["href"]) for token in tokens(source) if token.type == "link_open"]


def headings(source: str) -> list[str]:
    read = READER.parse(source)
    return [shown(read[at + 1]) for at, token in enumerate(read) if token.type == "heading_open"]
