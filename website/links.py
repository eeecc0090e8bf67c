"""Links between documents of the repository, as links between pages of the site."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Callable, Iterator
from pathlib import Path

from archlint.project import REPOSITORY

_FENCED = re.compile(r"^( *)(```+|~~~+).*?^\1\2[`~]*[ \t]*$\n?", re.MULTILINE | re.DOTALL)
_LINK = re.compile(r"(?P<code>(`+)(?!`).+?(?<!`)\2(?!`))|(?P<before>\]\()(?P<target>[^()\s]+)(?=\))", re.DOTALL)
_HEADING = re.compile(r"^(#{1,6}) +(.+?) *#*$", re.MULTILINE)
_ITEM = re.compile(r" *([-*]|\d+\.) ")


class BrokenLink(ValueError):
    """A link in a document that leads nowhere; the message names both."""


def outside_of_code(text: str, change: Callable[[str], str]) -> str:
    """A text in which everything but fenced code is changed."""
    pieces, end = [], 0
    for block in _FENCED.finditer(text):
        pieces += [change(text[end : block.start()]), block[0]]
        end = block.end()
    return "".join([*pieces, change(text[end:])])


def targets_of(text: str) -> Iterator[str]:
    """What the links of a text lead to."""
    prose = _FENCED.sub("", text)
    return (link["target"] for link in _LINK.finditer(prose) if link["target"] is not None)


def anchors_of(text: str) -> list[str]:
    """The anchors of the headings of a text, as GitHub makes them."""
    anchors: list[str] = []
    for _, title in _HEADING.findall(_FENCED.sub("", text)):
        plain = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", title)
        anchor = re.sub(r"[^\w\- ]", "", plain.lower()).strip().replace(" ", "-")
        number = anchors.count(anchor)
        anchors.append(f"{anchor}_{number}" if number else anchor)
    return anchors


def with_links(text: str, path: str, page: str, homes: dict[str, str], root: Path) -> str:
    """The text of a file of the repository, with links that hold on a page of the site.

    ``homes`` has the page of a file, and of a file with one of its anchors.  What is no page stays in the repository.
    Raises :class:`BrokenLink`.
    """

    def link(match: re.Match[str]) -> str:
        target = match["target"]
        if target is None or re.match(r"[a-z]+:", target):
            return match[0]
        return match["before"] + _moved(target, path, page, homes, root)

    return outside_of_code(text, lambda prose: _LINK.sub(link, prose))


def _moved(target: str, path: str, page: str, homes: dict[str, str], root: Path) -> str:
    file, sharp, anchor = target.partition("#")
    there = posixpath.normpath(posixpath.join(posixpath.dirname(path), file)) if file else path
    home = homes.get(f"{there}#{anchor}", homes.get(there))
    if home is None and homes.get(f"{there}/README.md"):
        home = homes[f"{there}/README.md"]
    if home is not None:
        return posixpath.relpath(home, posixpath.dirname(page) or ".") + (sharp + anchor if sharp else "")
    if not (root / there).exists():
        raise BrokenLink(f"{path}: {target} leads nowhere")
    if there.endswith((".svg", ".png")):
        return posixpath.relpath(f"pictures/{posixpath.basename(there)}", posixpath.dirname(page) or ".")
    return f"{REPOSITORY}/blob/main/{there}" + (sharp + anchor if sharp else "")


def for_python_markdown(text: str) -> str:
    """What GitHub reads as a list or as Markdown inside of HTML, so that Python-Markdown reads the same."""

    def change(prose: str) -> str:
        lines: list[str] = []
        for line in prose.replace("<details>", '<details markdown="1">').split("\n"):
            before = lines[-1] if lines else ""
            starts = _ITEM.match(line) and before.strip() and not _ITEM.match(before) and not before.startswith("  ")
            if starts and not before.startswith("#"):
                lines.append("")
            lines.append(line)
        return "\n".join(lines)

    return outside_of_code(text, change)
