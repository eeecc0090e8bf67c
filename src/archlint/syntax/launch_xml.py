"""XML launch files.  No entity is expanded, no external thing is loaded, and size and depth are bounded."""

from __future__ import annotations

import re
from bisect import bisect_left, bisect_right
from itertools import accumulate
from xml.parsers import expat

from archlint.syntax.comment_words import SUPPRESSION, codes_in, gives_reason, listed_at, lookalike
from archlint.syntax.facts import Span, Suppression
from archlint.syntax.launch_elements import DEPTH, ELEMENTS, Attribute, Element, LaunchFacts, TooLarge, failed

_ATTRIBUTE = re.compile(rb"""\s+([^\s=/>"']+)\s*=\s*("[^"]*"|'[^']*')""")
_SUPPRESSION = re.compile(rf"<!--\s*{SUPPRESSION}")


class _Entity(Exception):
    """An entity declaration: never needed in a launch file, and a way to blow one up."""


class _Open:
    """An element that is not closed yet."""

    def __init__(self, tag: str, attributes: dict[str, Attribute], span: Span) -> None:
        self.tag, self.attributes, self.span = tag, attributes, span
        self.children: list[Element] = []


class _Reader:
    def __init__(self, data: bytes) -> None:
        self.data = data
        self.parser = expat.ParserCreate("utf-8")
        self.parser.StartElementHandler = self.start
        self.parser.EndElementHandler = self.end
        self.parser.EntityDeclHandler = self.entity
        self.stack: list[_Open] = []
        self.root: Element | None = None
        self.count = 0
        self.counted = (0, 0, 0)
        self.line_starts = [0, *(match.end() for match in re.finditer(rb"\n", data))]

    def entity(self, *_: object) -> None:
        raise _Entity

    def place(self, offset: int) -> tuple[int, int]:
        line = bisect_right(self.line_starts, offset)
        start = self.line_starts[line - 1]
        # A generated file may be one line of megabytes: count on from where the last place was.
        of_line, counted, characters = self.counted
        if of_line != start or counted > offset:
            counted, characters = start, 0
        characters += len(self.data[counted:offset].decode("utf-8", "replace"))
        self.counted = (start, offset, characters)
        return line, characters + 1

    def start(self, tag: str, values: dict[str, str]) -> None:
        self.count += 1
        if self.count > ELEMENTS or len(self.stack) >= DEPTH:
            raise TooLarge
        at = self.parser.CurrentByteIndex
        opened = self.place(at)
        attributes: dict[str, Attribute] = {}
        end = at + 1 + len(tag.encode())
        match = _ATTRIBUTE.match(self.data, end)
        while match is not None:
            name = match[1].decode("utf-8", "replace")
            span = (*self.place(match.start(1)), *self.place(match.end(2)))
            end = match.end()
            if name in values:
                attributes[name] = Attribute(values[name], span)
            match = _ATTRIBUTE.match(self.data, end)
        close = self.data.find(b">", end)
        span = (*opened, *self.place(close + 1 if close >= 0 else end))
        for name, value in values.items():
            attributes.setdefault(name, Attribute(value, span))
        self.stack.append(_Open(tag, attributes, span))

    def end(self, tag: str) -> None:
        opened = self.stack.pop()
        element = Element(opened.tag, opened.attributes, tuple(opened.children), opened.span)
        if self.stack:
            self.stack[-1].children.append(element)
        else:
            self.root = element


def read_launch_xml(text: str) -> LaunchFacts:
    """The facts of an XML launch file; never raises for what is in the text."""
    reader = _Reader(text.encode("utf-8", "replace"))

    def line() -> int:
        return max(1, reader.parser.CurrentLineNumber)

    try:
        reader.parser.Parse(reader.data, True)
    except expat.ExpatError as error:
        words = expat.errors.messages.get(error.code, str(error))
        return failed(error.lineno, error.offset + 1, f"malformed XML: {words}")
    except _Entity:
        return failed(line(), 1, "entity declarations are not allowed in a launch file")
    except TooLarge:
        return failed(line(), 1, "more elements than a launch file has")
    except (ValueError, LookupError) as error:
        return failed(line(), 1, f"malformed XML: {error}")
    root = reader.root
    if root is None or root.tag != "launch" or _is_foreign(root):
        return LaunchFacts()
    return LaunchFacts(root, *is_ros1(root), suppressions=tuple(_suppressions(text, root)))


_ROS_TAGS = frozenset(
    {"arg", "composable_node", "env", "executable", "group", "include", "let", "load_composable_node", "node_container"}
    | {"param", "push_ros_namespace", "push-ros-namespace", "remap", "set_env", "set_parameter", "set_remap", "timer"}
    | {"machine", "master", "nodelet", "rosparam", "test"}
)
_ROS_ATTRIBUTES = frozenset({"pkg", "package", "exec", "executable", "type", "plugin", "if", "unless"})
"""What an element of ROS has, or has by mistake: ``package`` is meant as ``pkg``."""


def _is_foreign(root: Element) -> bool:
    """Whether a file has elements and nothing of ROS in any of them: other tools have a ``<launch>`` as well."""
    elements = list(root.children)
    for element in elements:  # it grows on the way
        elements.extend(element.children)
    return bool(elements) and not any(
        element.tag in _ROS_TAGS
        or _ROS_ATTRIBUTES & element.attributes.keys()
        or any("$(" in str(attribute.value) for attribute in element.attributes.values())
        for element in elements
    )


_ROS1_TAGS = frozenset({"rosparam", "machine", "test", "master", "nodelet"})
_ROS2_TAGS = frozenset(
    {"let", "set_parameter", "push_ros_namespace", "push-ros-namespace", "node_container", "executable"}
)
_ROS1_ATTRIBUTES = frozenset({"pass_all_args", "clear_params"})
_ROS1_HABITS = frozenset({("arg", "doc"), ("include", "ns"), ("group", "ns"), ("node", "ns")})
"""Attributes of ROS 1 that people write for ROS 2, too, by mistake: they decide only where nothing else does."""
_ROS1_TEXT = re.compile(r"\$\((?:find|arg|optenv) ")
_ROS2_TEXT = re.compile(r"\$\((?:find-pkg-share|find-pkg-prefix|var|exec-in-pkg|command) ?")


def sounds_like_ros1(text: str) -> bool:
    """Whether a file that is not well-formed has words of ROS 1, and none that only ROS 2 has."""
    ros1 = _ROS1_TEXT.search(text) or _ROS1_NODE.search(text)
    return ros1 is not None and _ROS2_TEXT.search(text) is None and _ROS2_NODE.search(text) is None


_ROS1_NODE = re.compile(r"<node\b[^<>]*\btype\s*=|<(?:rosparam|nodelet|machine)\b")
_ROS2_NODE = re.compile(r"<node\b[^<>]*\bexec(?:utable)?\s*=|<(?:push[-_]ros[-_]namespace|let|executable)\b")


def is_ros1(root: Element) -> tuple[bool, bool]:
    """Whether a launch file is one of ROS 1, and whether that is decided: what both have says nothing, and what is
    said in both ways is ROS 2."""
    ros1 = ros2 = habits = 0
    stack = [root]
    while stack:
        element = stack.pop()
        stack.extend(element.children)
        names = element.attributes
        ros1 += element.tag in _ROS1_TAGS or bool(_ROS1_ATTRIBUTES & names.keys())
        ros2 += element.tag in _ROS2_TAGS
        habits += any((element.tag, name) in _ROS1_HABITS for name in names)
        if element.tag == "node":
            ros1 += "type" in names and not {"exec", "executable"} & set(names)
            ros2 += "exec" in names or "executable" in names
        for attribute in names.values():
            value = str(attribute.value)
            ros1 += bool(_ROS1_TEXT.search(value))
            ros2 += bool(_ROS2_TEXT.search(value))
    return ros1 > ros2 or (ros1 == ros2 == 0 and habits > 0), ros1 + ros2 > 0


def suppressions_of_xml(text: str) -> list[Suppression]:
    """The suppressions of an XML file of any kind, such as a ``package.xml``; none where it is not well-formed."""
    if "archlint:" not in text:
        return []
    reader = _Reader(text.encode("utf-8", "replace"))
    try:
        reader.parser.Parse(reader.data, True)
    except (expat.ExpatError, _Entity, TooLarge, ValueError, LookupError):
        return []
    return [] if reader.root is None else _suppressions(text, reader.root)


def _suppressions(text: str, root: Element) -> list[Suppression]:
    """``<!-- archlint: ignore[…] -->``: for the element on its line, else for the next one."""
    suppressions: list[Suppression] = []
    if "archlint:" not in text:
        return suppressions
    elements = _Elements(root)
    lines = text.splitlines()
    for number, line in enumerate(lines, start=1):
        if "<!--" in line and (other := lookalike(line)):
            span = (number, other.start() + 1, other.end() + 1, (number, number))
            suppressions.append(Suppression(*span, [], not_understood=other[0]))
        indent = len(line) - len(line.lstrip())
        for match in _SUPPRESSION.finditer(line, 0, max(0, line.rfind("-->"))):
            end = line.find("--", match.end())
            if not line.startswith("-->", end):
                continue  # no comment has "--" inside: this is data
            first, last = elements.covered(number, match.start() > indent)
            suppressions.append(
                Suppression(
                    number,
                    match.start() + 1,
                    end + len("-->") + 1,
                    (1, len(lines)) if match[1] else (first, last),
                    codes_in(match),
                    "file" if match[1] else "line",
                    listed=listed_at(match, match.start() + 1),
                    closed=True,
                    reason=gives_reason(line, match.end(), end),
                )
            )
    return suppressions


class _Elements:
    """The first and last lines of the start tags of a file."""

    def __init__(self, root: Element) -> None:
        self._lines = []
        stack = [root]
        while stack:
            element = stack.pop()
            self._lines.append((element.span[0], element.span[2]))
            stack.extend(element.children)
        self._lines.sort()
        self._starts = [first for first, _ in self._lines]
        self._ends = list(accumulate((last for _, last in self._lines), max))

    def covered(self, line: int, same_line: bool) -> tuple[int, int]:
        """The lines of the tag on a line, or of the first one behind it; the line itself where there is none."""
        at = bisect_left(self._ends, line) if same_line else bisect_right(self._starts, line)
        first, last = self._lines[at] if at < len(self._lines) else (line, line)
        return (line, line) if same_line and first > line else (first, last)
