"""The sources of the whole site, as texts by path."""

from __future__ import annotations

import re
from collections.abc import Iterator

from archlint.checks.registry import registered
from archlint.cli.explain import LEVELS
from archlint.rulebook import Rule, rules
from website import reference
from website.links import anchors_of, for_python_markdown, targets_of, with_links
from website.sources import ELSEWHERE, README, ROOT, Source, sources

CONFIGURATION = ROOT / "mkdocs.yml"
"""How the site looks; its navigation is made here."""

MADE = {
    "commands.md": reference.commands,
    "configuration.md": reference.configuration,
    "docs/api.md": reference.python_api,
}
"""Pages that are made of the program, or end in what is."""

FIRST = (("First run", "index.md"), ("Configuration", "configuration.md"), ("Commands", "commands.md"))
LATER = (
    ("What a change does", "docs/diff.md"),
    ("Pages and declarations", "docs/interfaces.md"),
    ("In CI", (("Formats and hooks", "ci.md"), ("Recipes", "docs/ci.md"))),
    ("In an editor", "editors.md"),
    ("Python API", "docs/api.md"),
    ("Rules of your own", "docs/plugins.md"),
    ("Compile and link", "docs/facts.md"),
)
FIGURES = (
    ("Figures", "accuracy.md"),
    ("The graph", (("Figures", "figures/graph.md"), ("What is counted", "accuracy-of-graphs.md"))),
    ("What a text search finds", "figures/coverage.md"),
    ("C++", "figures/cpp.md"),
    ("Launch files", "figures/launch-files.md"),
    ("Pictures", "figures/pictures.md"),
    ("Findings", "figures/findings.md"),
    ("What is missed", "figures/faults.md"),
    ("Fixes", "figures/fixes.md"),
    ("Speed", "figures/speed.md"),
    ("Robustness", "figures/robustness.md"),
    ("Structure", "figures/structure.md"),
    ("Adoption", "figures/adoption.md"),
)
LAST = (
    ("How it works", "how-it-works.md"),
    ("Accuracy and speed", FIGURES),
    ("Security", "security.md"),
    ("Contributing", "contributing.md"),
    ("Changelog", "changelog.md"),
)
Entries = tuple[tuple[str, "str | Entries"], ...]


def pages() -> dict[str, str]:
    """Every page by its path.  Raises :class:`website.links.BrokenLink`."""
    parts = sources()
    homes = _homes(parts)
    texts: dict[str, list[str]] = {}
    for source in parts:
        text = with_links(source.text, source.path, source.page, homes, ROOT)
        texts.setdefault(source.page, []).append(for_python_markdown(_with_facts(source, text)))
    for page, make in MADE.items():
        texts.setdefault(page, []).append(make())
    return {page: "\n".join(text.strip() + "\n" for text in several) for page, several in sorted(texts.items())}


def _homes(parts: list[Source]) -> dict[str, str]:
    """The page of each file, and of each section of one that is on several pages."""
    homes = {source.path: source.page for source in reversed(parts)}
    for source in parts:
        homes |= {f"{source.path}#{anchor}": source.page for anchor in anchors_of(source.text)}
    for title, page in ELSEWHERE.items():
        homes[f"{README}#{anchors_of(f'# {title}')[0]}"] = homes.get(page, page)
    return homes


def _with_facts(source: Source, text: str) -> str:
    """The page of a rule with what stands in its head."""
    rule = rules().get(source.page.removeprefix("rules/")[:6]) if source.page.startswith("rules/") else None
    if rule is None:
        return text
    title, _, rest = text.strip().partition("\n")
    return f"{title}\n\n{_facts(rule)}\n{rest}"


def _facts(rule: Rule) -> str:
    check = registered().get(rule.code)
    scope = f", about {check.scope.value.replace('-', ' ')}" if check is not None else ""
    fix = f"{rule.fix} fix" if rule.fix else "no automatic fix"
    facts = f"*{rule.severity.label}, {LEVELS[rule.default]}, {fix}{scope}, since {rule.since}*"
    return f"{facts}\n\n{rule.summary[0].upper()}{rule.summary[1:]}."


def navigation(made: dict[str, str]) -> Entries:
    """The pages in the order of the menu; the rules by family, with the titles of their index."""
    families: list[tuple[str, Entries]] = []
    for part in re.split(r"^## ", made["rules/index.md"], flags=re.MULTILINE)[1:]:
        title, _, table = part.partition("\n")
        rows = re.findall(r"\]\(([A-Z]{3}\d{3}-[a-z0-9-]+\.md)\)", table)
        families.append((title.strip(), tuple((row[:-3].replace("-", " ", 1), f"rules/{row}") for row in rows)))
    named = {page for _, page in _flat((*FIRST, *LATER, *LAST))}
    others = sorted(page for page in made if page.startswith("docs/") and page not in named)
    more = tuple((made[page].partition("\n")[0].removeprefix("# "), page) for page in others)
    return (*FIRST, ("Rules", (("All rules", "rules/index.md"), *families)), *LATER, *more, *LAST)


def _flat(entries: Entries) -> Iterator[tuple[str, str]]:
    for title, page in entries:
        if isinstance(page, str):
            yield title, page
        else:
            yield from _flat(page)


def configuration(entries: Entries) -> str:
    """The configuration of MkDocs beside the pages."""
    return f"INHERIT: {CONFIGURATION}\ndocs_dir: pages\nsite_dir: site\nnav:\n" + "".join(_rows(entries, 1))


def _rows(entries: Entries, depth: int) -> Iterator[str]:
    indent = "  " * depth
    for title, page in entries:
        if isinstance(page, str):
            yield f'{indent}- "{title}": "{page}"\n'
        else:
            yield f'{indent}- "{title}":\n'
            yield from _rows(page, depth + 2)


def external_links(made: dict[str, str]) -> list[str]:
    """The addresses elsewhere that pages link to; nothing here asks whether they are still there."""
    return sorted({target for text in made.values() for target in targets_of(text) if "://" in target})
