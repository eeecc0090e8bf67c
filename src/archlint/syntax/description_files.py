"""The files that a description of a robot (URDF, xacro) names, wherever it is read: what it includes, and meshes.

xacro is not run: what stands in a macro or a condition may not be read, and a path with ``${…}`` is not known.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from archlint.records import dataclass
from archlint.syntax.facts import Span
from archlint.workspace.comments import blank_xml_comments

TAG = re.compile(
    r"<(/?)([A-Za-z][\w:.-]*)((?:\s+[\w:.-]+\s*=\s*(?:\"[^\"]*\"|'[^']*'))*)\s*(/?)>",
)
"""A tag of XML: whether it closes an element, its name, its attributes, whether the element is empty."""
_FILE = re.compile(r"(?<![\w:.-])filename\s*=\s*(?:\"([^\"]*)\"|'([^']*)')")
_OPTIONAL = re.compile(r"(?<![\w:.-])optional\s*=")
_MACRO = "xacro:macro"
_IF, _UNLESS = "xacro:if", "xacro:unless"
CONDITIONS = frozenset({_IF, _UNLESS})
_VALUE = re.compile(r"(?<![\w:.-])value\s*=\s*(?:\"([^\"]*)\"|'([^']*)')")
_NO = frozenset({"0", "false", "False", "${0}", "${False}"})
_YES = frozenset({"1", "true", "True", "${1}", "${True}"})
_INCLUDE = "xacro:include"
_MESH = "mesh"
_FIND = re.compile(r"\$\(find ([\w.-]+)\)(/.*)")
_PACKAGE_URL = re.compile(r"package://([\w.-]+)(/.*)")
_NOT_KNOWN = re.compile(r"[$*?\[{]")


@dataclass(frozen=True)
class NamedFile:
    """A file by its path in the share folder of a package, or (of no package) beside the description."""

    package: str | None
    path: str
    span: Span
    included: bool
    """Whether the description goes on in it; otherwise it is a mesh."""
    perhaps: bool
    """Whether it stands in a condition that may hold."""


def files_named(text: str) -> Iterator[NamedFile]:
    """The files that a description names for certain, or in a condition.  Never raises."""
    if _INCLUDE not in text and "package://" not in text:
        return
    inside: list[bool] = []  # of each condition and macro around, whether xacro may look into it
    text = blank_xml_comments(text)
    for match in TAG.finditer(text):
        closing, tag, attributes, is_empty = match.groups()
        if tag == _MACRO or tag in CONDITIONS:
            if closing and inside:
                inside.pop()
            elif not closing and not is_empty:
                inside.append(tag != _MACRO and not is_skipped(tag, attributes))
        elif all(inside) and not closing and tag in (_INCLUDE, _MESH):
            named = None if _OPTIONAL.search(attributes) else _FILE.search(text, match.start(), match.end())
            if named is not None:
                yield from _named(text, named, tag == _INCLUDE, bool(inside))


def is_skipped(tag: str, attributes: str) -> bool:
    """Whether a condition never holds, by a value that is written out."""
    match = _VALUE.search(attributes)
    value = "" if match is None else (match[1] or match[2] or "").strip()
    return (tag == _IF and value in _NO) or (tag == _UNLESS and value in _YES)


def _named(text: str, match: re.Match[str], included: bool, perhaps: bool) -> Iterator[NamedFile]:
    group = 1 if match[1] is not None else 2
    in_package = (_FIND if included else _PACKAGE_URL).fullmatch(match[group])
    path = match[group] if in_package is None else in_package[2]
    if _NOT_KNOWN.search(path) or not path or (in_package is None and (not included or path.startswith("/"))):
        return
    line = text.count("\n", 0, match.start()) + 1
    column = match.start() - text.rfind("\n", 0, match.start())
    span = (line, column, line, column + match.end() - match.start())
    yield NamedFile(None if in_package is None else in_package[1], path, span, included, perhaps)


__all__ = ["CONDITIONS", "TAG", "NamedFile", "files_named", "is_skipped"]
