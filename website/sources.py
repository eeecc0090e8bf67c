"""Which file of the repository becomes which page."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from archlint.rulebook import pages_folder, rules, without_marks

ROOT = Path(__file__).resolve().parents[1]

README = "README.md"
OF_README = {"Configure": "configuration.md", "In your editor": "editors.md", "In CI": "ci.md"}
"""Sections of the README that are the beginning of a page; the figures are those of the page on accuracy, and the other
sections are the first page."""
ELSEWHERE = {"How accurate is it?": "accuracy.md", "From Python": "docs/api.md", "Develop": "contributing.md"}
"""Sections that another page says at length."""

DOCUMENTS = {
    "ARCHITECTURE.md": "how-it-works.md",
    "CONTRIBUTING.md": "contributing.md",
    "SECURITY.md": "security.md",
    "CHANGELOG.md": "changelog.md",
    "benchmarks/README.md": "accuracy.md",
    "benchmarks/accuracy/README.md": "accuracy-of-graphs.md",
    "rules/README.md": "rules/index.md",
}


@dataclass(frozen=True)
class Source:
    """Markdown of the repository: the path of its file, its text, and the page that it goes to."""

    path: str
    text: str
    page: str


def sources() -> list[Source]:
    """All that becomes a page, in the order in which one page follows from several."""
    parts = [*_of_readme()]
    files = {**DOCUMENTS, **_pages_of("docs", "docs"), **_pages_of("benchmarks/figures", "figures")}
    parts += [Source(path, _written((ROOT / path).read_text("utf-8")), page) for path, page in files.items()]
    return [*parts, *_of_rules()]


def _pages_of(folder: str, pages: str) -> dict[str, str]:
    """Each document of a folder of the repository, and its page in a folder of the site."""
    return {f"{folder}/{path.name}": f"{pages}/{path.name}" for path in sorted((ROOT / folder).glob("*.md"))}


def _written(text: str) -> str:
    """A document without what is said to those who would edit it."""
    return re.sub(r"^This file is written by .*\n\n", "", text, flags=re.MULTILINE)


def _of_readme() -> list[Source]:
    """The README in parts: what stands before the first section, and each section under a title of its own."""
    head, *rest = re.split(r"^## (.+)\n", (ROOT / README).read_text("utf-8"), flags=re.MULTILINE)
    parts = dict(zip(rest[::2], rest[1::2], strict=True))
    if missing := (OF_README.keys() | ELSEWHERE.keys()) - parts.keys():
        raise ValueError(f"the README has no section {', '.join(sorted(missing))}")
    first = "".join(f"## {title}\n{text}" for title, text in parts.items() if title not in {**OF_README, **ELSEWHERE})
    pages = [Source(README, head + first, "index.md")]
    return [*pages, *(Source(README, f"# {title}\n{parts[title]}", page) for title, page in OF_README.items())]


def highlighted(page: str) -> str:
    """The page of a rule, whose marks become lines with a colour."""

    def block(match: re.Match[str]) -> str:
        lines = match["code"].splitlines()
        marked = [str(number) for number, line in enumerate(lines, 1) if without_marks(line) != line]
        return f'{match["fence"]} hl_lines="{" ".join(marked)}"\n{match["code"]}```' if marked else match[0]

    return without_marks(_BLOCK.sub(block, page))


_BLOCK = re.compile(r"^(?P<fence>```[a-z]+)\n(?P<code>.*?)^```", re.MULTILINE | re.DOTALL)


def _of_rules() -> list[Source]:
    folder = pages_folder()
    return [
        Source(f"rules/{rule.code}-{rule.name}.md", highlighted(rule.body), f"rules/{rule.code}-{rule.name}.md")
        for rule in rules().values()
        if (folder / f"{rule.code}-{rule.name}.md").is_file()
    ]
