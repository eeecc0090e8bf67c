"""What can be wrong with drawing."""

from __future__ import annotations


class CannotDraw(Exception):
    """There is no Graphviz, or it failed; the message is for the user."""


class NoGraphviz(CannotDraw):
    """There is none."""
