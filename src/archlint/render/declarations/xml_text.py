"""Texts of the user's in XML."""

from __future__ import annotations

from xml.sax.saxutils import escape, quoteattr

from archlint.visible import visible


def attribute(words: str) -> str:
    """The value of an attribute, with its quotes."""
    return quoteattr(visible(words))


def content(words: str) -> str:
    """The text of an element."""
    return escape(visible(words))


def comment(words: str, indentation: int = 0) -> str:
    """A comment; two hyphens, which would end it, have a space between them."""
    shown = visible(words)
    while "--" in shown:
        shown = shown.replace("--", "- -")
    return f"{' ' * indentation}<!-- {shown} -->"


__all__ = ["attribute", "comment", "content"]
