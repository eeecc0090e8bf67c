"""What ``archlint explain`` shows of a rule's page: all that is said, and of the examples one of each kind.

A page has the sections ``## Reported``, ``## Not reported``, ``## Why it matters``, ``## Bad``, ``## Good``,
``## Fix``, ``## Options`` and ``## References``.  In ``Bad`` and ``Good`` a ``###`` heading starts a further example,
and a line such as `` `launch/robot.launch.py`: `` in front of a block names its file.
"""

from __future__ import annotations

import re

from archlint.records import dataclass
from archlint.rulebook import Rule, without_marks

_SECTION = re.compile(r"^## (.+)\n", re.MULTILINE)
_EXAMPLE = re.compile(r"^### .+\n", re.MULTILINE)
_FOLDED = re.compile(r"^<details>.*?^</details>\n?", re.MULTILINE | re.DOTALL)
_BLOCK = re.compile(r"(?:^`(?P<name>[^`\n]+)`:\n+)?^```[a-z]*\n.*?^```\n?", re.MULTILINE | re.DOTALL)
_OTHER_PAGE = re.compile(r"\[([^\]]+)\]\([A-Z]{3}\d{3}-[a-z0-9-]+\.md\)")
_README = re.compile(r"\[([^\]]+)\]\(\.\./README\.md[^)]*\)")


@dataclass(frozen=True)
class Shown:
    """The part of a page that ``explain`` prints; ``has_more`` where ``--all`` would print further examples."""

    text: str
    has_more: bool


def shown(rule: Rule, facts: str) -> Shown:
    """A page with one Bad and one Good block; ``facts`` is the line below the title."""
    title, *pieces = _SECTION.split(rule.body)
    parts = [f"{title.strip()}\n\n{facts}\n"]
    wrong: list[re.Match[str]] = []
    has_more = False
    for heading, text in zip(pieces[::2], pieces[1::2], strict=True):
        if heading in ("Bad", "Good") and _BLOCK.search(text):
            example, blocks = _first_example(text)
            chosen = _chosen(rule.code, blocks, wrong)
            wrong = wrong or [chosen, *(block for block in blocks if block is not chosen)]
            has_more = has_more or len(_BLOCK.findall(_FOLDED.sub("", text))) > 1
            text = f"{example[: blocks[0].start()].strip()}\n\n{chosen[0]}".strip()
        parts.append(f"## {heading}\n{text.strip()}\n")
    return Shown(_for_a_terminal("\n".join(parts)), has_more)


def full_page(rule: Rule, facts: str) -> str:
    """The page with all examples, without the files that are folded away."""
    title, _, rest = rule.body.strip().partition("\n")
    return f"{title}\n\n{facts}\n{_for_a_terminal(_FOLDED.sub('', rest))}\n"


def _for_a_terminal(text: str) -> str:
    """Without the test suite's marks, and without links that lead from one file of the repository to another."""
    return _README.sub(r"\1, in archlint's README", _OTHER_PAGE.sub(r"\1", without_marks(text)))


def _first_example(section: str) -> tuple[str, list[re.Match[str]]]:
    """The first example of a section, and its blocks."""
    first = next(text for text in _EXAMPLE.split(_FOLDED.sub("", section)) if text.strip())
    return first, list(_BLOCK.finditer(first))


def _chosen(code: str, blocks: list[re.Match[str]], wrong: list[re.Match[str]]) -> re.Match[str]:
    """The block that carries the finding; of a Good example, the one that corrects what is ``wrong``: a file of the
    same name, or the first one that is not as it was."""
    marked = [block for block in blocks if re.search(rf"expect:[^\n]*{code}", block[0])]
    as_it_was = {without_marks(block[0]) for block in wrong}
    changed = [block for block in blocks if block[0] not in as_it_was]
    corrected = [block for block in changed if wrong and block["name"] == wrong[0]["name"]]
    return (marked or corrected or changed or blocks)[0]
