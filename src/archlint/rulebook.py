"""The rule book: one Markdown page a rule, the single source of its name, severity and default.

The pages live in ``rules/`` at the top of the repository.  A wheel carries them inside the package; an
editable install reads them where they are written.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from contextvars import ContextVar
from functools import cache
from pathlib import Path
from typing import Final, Literal

from archlint.finding import Severity
from archlint.records import dataclass
from archlint.suggestions import distance, listed, meant, nearest

ON: Final = "on"
OFF: Final = "off"
CLOSED_WORLD: Final = "closed-world"

Default = Literal["on", "off", "closed-world"]
Safety = Literal["", "safe", "unsafe"]
_DEFAULTS: Final[dict[str, Default]] = {ON: ON, OFF: OFF, CLOSED_WORLD: CLOSED_WORLD}
_FIXES: Final[dict[str, Safety]] = {"none": "", "safe": "safe", "unsafe": "unsafe"}
"""What the pages call a fix, and what it is."""

CODE = re.compile(r"[A-Z]{3}\d{3}")
PAGE_NAME = re.compile(rf"{CODE.pattern}-[a-z0-9-]+\.md")
_FRONT_MATTER = re.compile(r"---\r?\n(.*?)\r?\n---\r?\n", re.DOTALL)
_EXPECTATION = re.compile(r"[ \t]*(?:#|//|<!--) expect(?:-file)?:[^\n]*")


class RuleBookError(ValueError):
    """A page of the rule book that cannot be used; the message names the page."""


@dataclass(frozen=True)
class Rule:
    """A rule as its page declares it.

    ``default`` is ``on``, ``off`` or ``closed-world`` (on only where nothing outside the workspace takes
    part).  ``fix`` is ``safe``, ``unsafe`` or empty.  ``body`` is the page below the front matter.
    """

    code: str
    name: str
    severity: Severity
    default: Default
    fix: Safety
    since: str
    summary: str
    body: str
    plugin: str = ""
    """Whose rule it is, as the configuration names the plugin; empty for archlint's own."""

    @property
    def title(self) -> str:
        return f"{self.code} {self.name}"

    @property
    def page(self) -> str:
        """The page as a reader wants it: without the marks that say what the test suite expects."""
        return without_marks(self.body).strip() + "\n"


def without_marks(text: str) -> str:
    """A page, or a part of it, without the marks that say which line breaks which rule."""
    return _EXPECTATION.sub("", text)


def pages_folder() -> Path:
    """Where the pages are: inside an installed package, else beside ``src/``."""
    packaged = Path(__file__).parent / "rulebook_pages"
    return packaged if packaged.is_dir() else Path(__file__).parents[2] / "rules"


@dataclass(frozen=True)
class _Book:
    """The rules of one run, where it has plugins; ``whole`` is false where some of them are left out."""

    rules: Mapping[str, Rule]
    whole: bool


_BOOK: ContextVar[_Book | None] = ContextVar("the rule book of this run", default=None)


def add_rules(added: Mapping[str, Rule], whole: bool) -> None:
    """Have these rules in the rule book, too, for the rest of this context (:mod:`contextvars`); it is not ``whole``
    where there are further rules that nothing is known of."""
    _BOOK.set(_Book(dict(sorted({**own_rules(), **added}.items())), whole))


def rules() -> Mapping[str, Rule]:
    """Every rule by its code, in code order: archlint's own, and those of the plugins of the run."""
    book = _BOOK.get()
    return own_rules() if book is None else book.rules


def may_be_rule(selector: str) -> bool:
    """Whether there are rules that a selector stands for, or may be among those that are left out."""
    book = _BOOK.get()
    return bool(codes_of(selector)) or not (book is None or book.whole)


@cache
def own_rules() -> Mapping[str, Rule]:
    """archlint's own rules."""
    by_code: dict[str, Rule] = {}
    for path in sorted(pages_folder().iterdir(), key=lambda path: path.name):
        if PAGE_NAME.fullmatch(path.name):
            rule = page_of(path.name, path.read_text("utf-8"))
            by_code[rule.code] = rule
    return by_code


def page_of(name: str, text: str) -> Rule:
    """The rule on a page that has the name of its rule.  Raises :class:`RuleBookError`."""
    rule = parse_page(text, name)
    if name != f"{rule.code}-{rule.name}.md":
        raise RuleBookError(f"{name}: the file should be called {rule.code}-{rule.name}.md")
    return rule


def parse_page(text: str, source: str) -> Rule:
    """The rule on a page; ``source`` names the page in a :class:`RuleBookError`."""
    matter = _FRONT_MATTER.match(text)
    if matter is None:
        raise RuleBookError(f"{source}: a page starts with front matter between two lines of ---")
    fields = _fields(matter[1], source)
    try:
        severity = Severity.parse(fields["severity"])
        default, fix = _DEFAULTS.get(fields["default"]), _FIXES.get(fields["fix"])
        if default is None or fix is None:
            raise RuleBookError(f"{source}: default is on, off or closed-world; fix is safe, unsafe or none")
        return Rule(
            code=fields["code"],
            name=fields["name"],
            severity=severity,
            default=default,
            fix=fix,
            since=fields["since"],
            summary=fields["summary"],
            body=text[matter.end() :],
        )
    except KeyError as error:
        raise RuleBookError(f"{source}: {error.args[0]} is missing or not a known word") from None


def _fields(matter: str, source: str) -> dict[str, str]:
    """``key: value`` lines; a value may be in quotes, and a comment may follow one that does not."""
    fields: dict[str, str] = {}
    for line in matter.splitlines():
        key, colon, value = line.partition(":")
        if not colon or not re.fullmatch(r"[a-z]+", key) or key in fields:
            raise RuleBookError(f"{source}: {line!r} is not a line of `key: value`")
        value = value.strip()
        quoted = len(value) > 1 and value[0] == value[-1] and value[0] in "\"'"
        fields[key] = value[1:-1] if quoted else value.partition(" #")[0].rstrip()
    return fields


def find_rule(text: str) -> Rule | None:
    """The rule with this code or name, in any case."""
    wanted = text.strip()
    by_code = rules().get(wanted.upper())
    return by_code or next((rule for rule in rules().values() if rule.name == wanted.lower()), None)


def codes_of(selector: str) -> list[str]:
    """The codes that a code, a prefix of codes, a rule's name or ``ALL`` stands for; none if unknown."""
    if selector == "ALL":
        return list(rules())
    rule = find_rule(selector)
    if rule is not None:
        return [rule.code]
    if not re.fullmatch(r"[A-Za-z]+\d*", selector):
        return []
    return [code for code in rules() if code.startswith(selector.upper())]


def suggestion(selector: str) -> str:
    """``; did you mean …?`` for an unknown code or name, or where the rules are listed."""
    near = _nearest(selector.upper()) or _nearest_name(selector.lower()) or _with_part(selector.lower())
    return meant(near) or "; `archlint rules` lists them"


def _nearest(selector: str) -> str | None:
    """The nearest code, or prefix of codes for what has no digits."""
    match = re.fullmatch(r"([A-Z]+)(\d*)", selector)
    if match is None:
        return None
    if not match[2]:
        prefixes = sorted({code[:3] for code in rules()} | {"ALL"})
        return nearest(selector, prefixes)
    padded = f"{match[1]}{int(match[2][-9:]):03}"
    if padded in rules():
        return padded
    return nearest(selector, rules()) or _one_digit_off(padded)


def _one_digit_off(code: str) -> str | None:
    """The first code that differs in one character: the digits of codes are no count, as those of names mostly are."""
    return next((known for known in rules() if distance(code, known, 1) == 1), None)


def _with_part(word: str) -> str:
    """The rules that have a word in their name, or a part of one."""
    parts = [f"{rule.name} ({rule.code})" for rule in rules().values() if word in rule.name]
    return listed(parts, "", shown=3) if len(word) > 2 else ""


def _nearest_name(selector: str) -> str | None:
    names = {rule.name: rule for rule in rules().values()}
    near = nearest(selector, names)
    return None if near is None else f"{near} ({names[near].code})"
