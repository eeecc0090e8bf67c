"""Reads the examples on the pages of rules, so that tests can run what the pages promise.

A page has the sections ``## Bad`` and ``## Good``; a heading below them such as ``### In a helper`` starts another
example.  Every example is a small workspace of its own: its fenced blocks are the files.  A line such as
`` `launch/robot.launch.py`: `` before a block names its file; without one a ``python`` block is ``node.py`` and a
``toml`` block ``archlint.toml``.  Blocks in other languages are files only where they are named, so that a page may
also show a terminal.  A file that the example needs and a reader does not is folded away: its name stands in
``<details><summary><code>setup.py</code></summary>``.

What most examples need is written once, in ``scaffold`` beside archlint's own pages:

- A block with one node class and no ``main`` gets the ``main()`` of ``scaffold/main.py``, which spins that node.
- An example with a ``setup.py``, a ``setup.cfg`` or with files in ``robot/``, ``launch/`` or ``config/`` lies in the
  package of ``scaffold/``: its ``package.xml``, ``setup.py``, ``setup.cfg`` and ``robot/talker.py`` are there unless it
  brings its own.
  An example with a ``package.xml`` of its own gets a ``setup.cfg`` beside each ``setup.py``, and nothing else.

A line that must carry a finding ends in ``# expect: SRV003`` or ``# expect: SRV003, TMO002``
(``<!-- expect: LNT002 -->`` in XML, ``// expect: PKG001`` in C++).  A marker may name a rule that has no page yet: the
line breaks that rule too, and is held to it as soon as the rule exists.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import field
from pathlib import Path

from archlint.records import dataclass
from archlint.rulebook import pages_folder

NAME_WITHOUT_A_NAME = {"python": "node.py", "toml": "archlint.toml"}

PACKAGE_FILES = ("package.xml", "setup.py", "setup.cfg", "robot/talker.py")
IN_PACKAGE = ("robot/", "launch/", "config/", "setup.py", "setup.cfg")

_FILE_NAME = re.compile(r"^(?:`(?P<shown>[^`]+)`:|<details><summary><code>(?P<folded>[^<]+)</code>[^<]*</summary>)$")
_NODE_CLASS = re.compile(r"^class (\w+)\((?:\w+\.)?(?:Lifecycle)?Node\):", re.MULTILINE)
_FENCE = re.compile(r"^```(?P<language>[a-z]*)$")
_MARKER = re.compile(
    r"\s*(?:(?:#|//)\s*expect:\s*(?P<hash>[A-Z0-9, ]+?)|<!--\s*expect:\s*(?P<xml>[A-Z0-9, ]+?)\s*-->)\s*$"
)
_CODE = re.compile(r"[A-Z]{3}\d{3}")


class PageError(ValueError):
    """A page is not written as this module reads it; the message says where and why."""


@dataclass
class Example:
    """One ``Bad`` or ``Good`` section: its files without markers, and what a run over them must report.

    ``expected`` holds (path, line from 1, code) in reading order; it is empty for a ``good`` section.
    """

    page_code: str
    section: str
    title: str
    files: dict[str, str] = field(default_factory=dict)
    expected: list[tuple[str, int, str]] = field(default_factory=list)

    @property
    def id(self) -> str:
        """A name for test reports, such as ``SRV003-bad-in a helper``."""
        return "-".join(part for part in (self.page_code, self.section, self.title) if part)

    def write(self, folder: Path) -> None:
        """Lay the files out under ``folder``."""
        for path, text in self.files.items():
            target = folder / path
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(text, encoding="utf-8")


def load_examples(rules_dir: Path) -> list[Example]:
    """The examples of all pages in ``rules_dir``, in order; only rules with a page there are expected."""
    pages = {path.name[:6]: path for path in sorted(rules_dir.glob("[A-Z][A-Z][A-Z][0-9][0-9][0-9]-*.md"))}
    examples = [
        example for code, path in pages.items() for example in read_page(code, path.read_text(encoding="utf-8"))
    ]
    for example in examples:
        example.expected = [place for place in example.expected if place[2] in pages]
    return examples


def read_page(code: str, text: str) -> list[Example]:
    """The examples of the page ``code``; raises `PageError` where a section cannot be understood."""
    examples: list[Example] = []
    for (section, title), block_name, language, lines in _blocks(code, text):
        if section not in ("Bad", "Good"):
            continue
        kind = section.lower()
        if not examples or (examples[-1].section, examples[-1].title) != (kind, title):
            examples.append(Example(code, kind, title))
        name = block_name or NAME_WITHOUT_A_NAME.get(language)
        if name is not None:
            _add_file(examples[-1], name, lines)
    for example in examples:
        if example.section == "good" and example.expected:
            raise PageError(f"{example.id}: a Good section cannot expect a finding")
        _add_scaffold(example)
    return examples


def _scaffold() -> Path:
    return pages_folder() / "scaffold"


def _add_scaffold(example: Example) -> None:
    """Add what the page leaves out: a ``main()`` for each node, and the package around its files."""
    for name, text in example.files.items():
        if name.endswith(".py"):
            example.files[name] = _with_main(text)
    in_package = any(name.startswith(IN_PACKAGE) for name in example.files)
    if in_package and "package.xml" not in example.files:
        for name in PACKAGE_FILES:
            example.files.setdefault(name, _with_main((_scaffold() / name).read_text(encoding="utf-8")))
    for name, text in list(example.files.items()):
        folder, _, file = name.rpartition("setup.py")
        package = _NAME_OF_PACKAGE.search(example.files.get(f"{folder}package.xml", ""))
        if not file and package is not None and text:
            config = (_scaffold() / "setup.cfg").read_text(encoding="utf-8")
            example.files.setdefault(f"{folder}setup.cfg", config.replace("robot", package[1]))


_NAME_OF_PACKAGE = re.compile(r"<name>\s*([\w-]+)\s*</name>")


def _with_main(text: str) -> str:
    """A module that holds one node class and no ``main()`` of its own, with the one that spins the node."""
    classes = _NODE_CLASS.findall(text)
    if len(classes) != 1 or "def main(" in text:
        return text
    return text + (_scaffold() / "main.py").read_text(encoding="utf-8").replace("TheNode", classes[0])


def front_matter(text: str) -> dict[str, str]:
    """The keys between the two ``---`` lines at the top of a page, quotes and comments taken off."""
    head = text.split("---\n", 2)[1]
    pairs = (line.split("#", 1)[0].partition(":") for line in head.splitlines() if ":" in line)
    return {key.strip(): value.strip().strip('"') for key, _, value in pairs}


def split_marker(line: str) -> tuple[str, list[str]]:
    """A line without its marker, and the codes that the marker names."""
    marker = _MARKER.search(line)
    if marker is None:
        if re.search(r"(#|//|<!--)\s*expect\b", line):
            raise PageError(f"not a marker: {line.strip()!r}")
        return line, []
    codes = [code.strip() for code in (marker["hash"] or marker["xml"]).split(",")]
    if wrong := [code for code in codes if not _CODE.fullmatch(code)]:
        raise PageError(f"not a rule code: {wrong[0]!r} in {line.strip()!r}")
    return line[: marker.start()], codes


def _add_file(example: Example, name: str, lines: list[str]) -> None:
    if name in example.files:
        raise PageError(f"{example.id}: two blocks are called {name!r}")
    stripped: list[str] = []
    for number, line in enumerate(lines, start=1):
        plain, codes = split_marker(line)
        stripped.append(plain)
        example.expected += [(name, number, code) for code in codes]
    example.files[name] = "".join(f"{line}\n" for line in stripped)


def _blocks(code: str, text: str) -> Iterator[tuple[tuple[str, str], str | None, str, list[str]]]:
    """Each fenced block: the headings it stands under (``##``, ``###``), its file name if given, language and lines."""
    section, title, language = "", "", ""
    name: str | None = None
    lines: list[str] | None = None
    for line in text.splitlines():
        if lines is not None:
            if line == "```":
                yield (section, title), name, language, lines
                name, lines = None, None
            else:
                lines.append(line)
        elif fence := _FENCE.match(line):
            language, lines = fence["language"], []
        elif line.startswith("## "):
            section, title, name = line[3:], "", None
        elif line.startswith("### "):
            title, name = line[4:], None
        elif file_name := _FILE_NAME.match(line):
            name = file_name["shown"] or file_name["folded"]
        elif line.strip():
            name = None
    if lines is not None:
        raise PageError(f"{code}: a fenced block under {section!r} is never closed")
