"""The text of a file without its comments, for who only asks which words stand in it."""

from __future__ import annotations

import re

_COMMENT = re.compile(r"<!--.*?-->|(?:^|(?<=\s))#[^\n]*", re.DOTALL | re.MULTILINE)


def without_comments(text: str) -> str:
    """A text of Python, TOML, INI, YAML or XML without its comments.  A ``#`` starts one at the start of a line or
    after a space, so that a colour (``'#fff'``) is none."""
    return _COMMENT.sub("", text)


__all__ = ["without_comments"]
