"""What catkin_pkg refuses in a package.xml that is XML: colcon does not take the folder for a package of ROS then.

Source: ``parse_package_string`` and ``Package.validate`` of catkin_pkg 1.1.1; ``_get_package`` of colcon-ros 0.5.0,
which warns and goes on, or raises where a condition cannot be read, with which colcon goes on, too.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import field
from xml.parsers import expat

from archlint.records import dataclass
from archlint.workspace.conditions import is_condition

_VERSION = re.compile(r"[0-9]+\.[0-9]+\.[0-9]+")
_EMAIL = re.compile(r"[-\w%+]+(?:\.[-\w%+]+)*@[-a-zA-Z0-9%]+(?:\.[-a-zA-Z0-9%]+)*\.[a-zA-Z]{2,}", re.ASCII)

_NEEDED = frozenset({"name", "version", "description", "maintainer", "license"})
_MOST = 4
"""Of those: a file that has fewer is a sketch, of a test say, and nobody builds it."""
_ONCE = ("version", "description")
_AT_MOST_ONCE = ("name", "export")
_OF_DEPENDENCY = frozenset({"version_lt", "version_lte", "version_eq", "version_gte", "version_gt"})
_ATTRIBUTES: dict[str, frozenset[str]] = {
    **dict.fromkeys(("name", "description", "license", "export"), frozenset[str]()),
    **dict.fromkeys(("build_depend", "buildtool_depend", "test_depend", "conflict", "replace"), _OF_DEPENDENCY),
    **dict.fromkeys(("maintainer", "author"), frozenset({"email"})),
    "version": frozenset({"compatibility"}),
    "url": frozenset({"type"}),
}
"""The elements of all formats, with their attributes."""
_NOT_IN_1 = ("build_export_depend", "buildtool_export_depend", "depend", "exec_depend", "doc_depend")
_FORMAT_3 = 'write <package format="3">'
_COVERED = ("build_depend", "build_export_depend", "exec_depend")
"""What ``<depend>`` stands for."""


@dataclass(frozen=True)
class Refusal:
    """One mistake of a manifest: in which line, what it is, and what helps."""

    line: int
    what: str
    help: str


@dataclass
class _Element:
    """A child of ``<package>``."""

    tag: str
    attributes: dict[str, str]
    line: int
    text: str = ""
    inner: list[_Element] = field(default_factory=list)

    @property
    def children(self) -> list[str]:
        return [child.tag for child in self.inner]


def refusals(text: str) -> list[Refusal]:
    """What is refused in a manifest, in the order of its lines; nothing of one that is no XML."""
    reader = _Reader()
    try:
        reader.parser.Parse(text, True)
    except (expat.ExpatError, ValueError, LookupError):
        return []
    if len({element.tag for element in reader.elements} & _NEEDED) < _MOST:
        return []
    rules = (_of_one, _of_people, _of_licenses, _of_tags, _of_dependencies, _of_groups, _of_conditions, _of_types)
    refused = [refusal for rule in rules for refusal in rule(reader.format, reader.elements)]
    refused += _of_root(reader.root)
    return sorted(refused, key=lambda refusal: refusal.line)


class _Reader:
    """Collects the children of ``<package>``; no entity is ever expanded."""

    def __init__(self) -> None:
        self.parser = expat.ParserCreate()
        self.parser.StartElementHandler = self._start
        self.parser.EndElementHandler = self._end
        self.parser.CharacterDataHandler = self._data
        self.parser.StartDoctypeDeclHandler = self._doctype
        self.root = _Element("package", {}, 1)
        self.format = 1
        self._depth = 0

    @property
    def elements(self) -> list[_Element]:
        return self.root.inner

    def _doctype(self, *_: object) -> None:
        raise ValueError("a document type is not allowed here")

    def _start(self, tag: str, attributes: dict[str, str]) -> None:
        self._depth += 1
        element = _Element(tag, attributes, self.parser.CurrentLineNumber)
        if self._depth == 1:
            self.root = element
            number = attributes.get("format", "1").strip()
            self.format = int(number) if number in ("1", "2", "3") else 3
        elif self._depth == 2:
            self.elements.append(element)
        elif self._depth == 3:
            self.elements[-1].inner.append(element)

    def _data(self, text: str) -> None:
        if self._depth == 2:
            self.elements[-1].text += text
        elif self._depth == 3:
            self.elements[-1].inner[-1].text += text

    def _end(self, _: str) -> None:
        self._depth -= 1


_Rule = Callable[[int, Sequence[_Element]], Iterator[Refusal]]


def _with(elements: Sequence[_Element], *tags: str) -> list[_Element]:
    return [element for element in elements if element.tag in tags]


def _of_root(root: _Element) -> Iterator[Refusal]:
    number = root.attributes.get("format", "1").strip()
    if number not in ("1", "2", "3"):
        yield Refusal(root.line, f"there is no format '{number}'", _FORMAT_3)
    wrong = [name for name in root.attributes if name not in ("format", "xmlns") and ":" not in name]
    if wrong:
        yield Refusal(root.line, f"<package> has no attribute '{wrong[0]}'", "remove it")


def _of_one(_: int, elements: Sequence[_Element]) -> Iterator[Refusal]:
    """What there must be exactly once, and what there may be once."""
    for tag in _AT_MOST_ONCE:
        rows = _with(elements, tag)
        if len(rows) > 1:
            help = "put all into one of them" if tag == "export" else "keep one of them"
            yield Refusal(rows[1].line, f"there are {len(rows)} <{tag}>s", help)
    for tag in _ONCE:
        rows = _with(elements, tag)
        if not rows:
            yield Refusal(1, f"there is no <{tag}>", f"add a <{tag}>")
        elif len(rows) > 1:
            yield Refusal(rows[1].line, f"there are {len(rows)} <{tag}>s", "keep one of them")
        elif not rows[0].text.strip() and not rows[0].children:
            yield Refusal(rows[0].line, f"<{tag}> is empty", "write something into it")
        elif tag == "version" and not _VERSION.fullmatch(rows[0].text.strip()):
            yield Refusal(
                rows[0].line, f"'{rows[0].text.strip()}' is no version of three numbers", "write one like 0.1.0"
            )


def _of_people(_: int, elements: Sequence[_Element]) -> Iterator[Refusal]:
    if not _with(elements, "maintainer"):
        yield Refusal(1, "there is no <maintainer>", "add one, with an email")
    for person in _with(elements, "maintainer", "author"):
        email = person.attributes.get("email")
        if email and not _EMAIL.fullmatch(email):
            yield Refusal(person.line, f"'{email}' is no email address", "write one like name@example.com")
        elif not email and (person.tag == "maintainer" or email is not None):
            yield Refusal(person.line, f"the {person.tag} has no email", 'add email="…"')


def _of_licenses(_: int, elements: Sequence[_Element]) -> Iterator[Refusal]:
    licenses = _with(elements, "license")
    if not licenses:
        yield Refusal(1, "there is no <license>", "add one")
    for element in licenses:
        if not element.text.strip():
            yield Refusal(element.line, "<license> is empty", "write the name of the license into it")


def _of_tags(number: int, elements: Sequence[_Element]) -> Iterator[Refusal]:
    known = _known(number)
    for element in elements:
        attributes = known.get(element.tag)
        if attributes is None:
            yield Refusal(element.line, f"there is no <{element.tag}> in format {number}", _instead_of(element, number))
            continue
        wrong = [name for name in element.attributes if name not in attributes and name != "xmlns" and ":" not in name]
        if wrong:
            what = f"<{element.tag}> has no attribute '{wrong[0]}' in format {number}"
            yield Refusal(element.line, what, _FORMAT_3 if wrong[0] == "condition" else "remove it")
        if element.children and element.tag not in ("description", "export"):
            what = f"<{element.children[0]}> cannot stand inside <{element.tag}>"
            yield Refusal(element.line, what, "write it beside the other one")


def _known(number: int) -> dict[str, frozenset[str]]:
    """The elements of a format, with their attributes."""
    if number == 1:
        return {**_ATTRIBUTES, "run_depend": _OF_DEPENDENCY}
    known = {**_ATTRIBUTES, **dict.fromkeys(_NOT_IN_1, _OF_DEPENDENCY)}
    if number == 3:
        condition = frozenset({"condition"})
        known = {tag: names | condition if names is _OF_DEPENDENCY else names for tag, names in known.items()}
        known |= {"group_depend": condition, "member_of_group": condition, "license": frozenset({"file"})}
    return known


def _instead_of(element: _Element, number: int) -> str:
    tag = element.tag
    if "build_type" in element.children:
        return "write <export>"
    if tag == "run_depend":
        return "write <exec_depend>"
    if tag in _known(3):
        return _FORMAT_3
    if tag == "build_type":
        return "move it into <export>"
    return "remove it" if number == 3 else "remove it, or take a later format"


def _of_dependencies(number: int, elements: Sequence[_Element]) -> Iterator[Refusal]:
    name = next((element.text.strip() for element in _with(elements, "name")), "")
    tags = [tag for tag in _known(number) if tag.endswith("_depend") or tag == "depend"]
    for element in _with(elements, *tags):
        if element.text.strip() == name and element.tag != "group_depend":
            yield Refusal(element.line, f"'{name}' depends on itself", "remove the line")
    seen: set[tuple[str, frozenset[tuple[str, str]]]] = set()
    for element in _with(elements, "depend") if number > 1 else ():
        if _same(element) in seen:  # it is held against what the first one stands for
            yield Refusal(element.line, f"'{element.text.strip()}' has two <depend>s", "remove one of them")
        seen.add(_same(element))
    pairs = {"depend": _COVERED} if number > 1 else {"test_depend": ("build_depend", "run_depend")}
    for tag, others in pairs.items():
        rows = {_same(element): element for element in reversed(_with(elements, *others))}
        for element in _with(elements, tag):
            twice = rows.get(_same(element))
            if twice is not None:
                what = f"'{element.text.strip()}' has a <{tag}> and a <{twice.tag}>"
                yield Refusal(twice.line, what, f"keep one: <{tag if number > 1 else twice.tag}> covers both")


def _of_groups(_: int, elements: Sequence[_Element]) -> Iterator[Refusal]:
    groups = {element.text.strip() for element in _with(elements, "member_of_group")}
    for element in _with(elements, "group_depend"):
        name = element.text.strip()
        if name in groups:
            yield Refusal(element.line, f"'{name}' is a group of the package, which depends on that", "remove the line")


def _of_conditions(number: int, elements: Sequence[_Element]) -> Iterator[Refusal]:
    """Conditions that cannot be read; where the format has none, that is what is told."""
    conditional = [tag for tag, names in _known(number).items() if "condition" in names]
    inner = [child for element in _with(elements, "export") for child in element.inner]
    for element in [*_with(elements, *conditional), *inner]:
        condition = element.attributes.get("condition")
        if condition is not None and not is_condition(condition):
            what = f"'{condition.strip()}' is no condition"
            yield Refusal(element.line, what, "write one like $ROS_VERSION == 2")


def _of_types(_: int, elements: Sequence[_Element]) -> Iterator[Refusal]:
    """Several build types that hold wherever the package is built."""
    inner = [child for element in _with(elements, "export") for child in element.inner]
    types = [child for child in inner if child.tag == "build_type" and "condition" not in child.attributes]
    if len(types) > 1:
        yield Refusal(types[1].line, f"there are {len(types)} <build_type>s", "keep one of them")


def _same(element: _Element) -> tuple[str, frozenset[tuple[str, str]]]:
    """By what two dependencies are one."""
    return element.text.strip(), frozenset(element.attributes.items())


__all__ = ["Refusal", "refusals"]
