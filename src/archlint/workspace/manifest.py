"""package.xml: name, build type, dependencies.  REP 149 and ``catkin_pkg`` say what it may hold."""

from __future__ import annotations

import operator
import re
from collections.abc import Callable
from xml.parsers import expat

from archlint.workspace.model import BuildType, Dependency, DependencyKind, Package, Problem, SourceFile

_BUILD_TYPES: dict[str, BuildType] = {
    "": "catkin",
    "ament_cmake": "ament_cmake",
    "ament_python": "ament_python",
    "catkin": "catkin",
    "cmake": "cmake",
}

_DEPENDENCIES: dict[str, DependencyKind] = {
    "depend": "depend",
    "build_depend": "build",
    "build_export_depend": "build_export",
    "buildtool_depend": "buildtool",
    "buildtool_export_depend": "buildtool_export",
    "exec_depend": "exec",
    "run_depend": "run",
    "test_depend": "test",
    "doc_depend": "doc",
}


class _Reader:
    """Collects what matters while expat reads; no entity is ever expanded."""

    def __init__(self) -> None:
        self.parser = expat.ParserCreate()
        self.parser.StartElementHandler = self.start
        self.parser.EndElementHandler = self.end
        self.parser.CharacterDataHandler = self.data
        self.parser.StartDoctypeDeclHandler = self.doctype
        self.stack: list[str] = []
        self.text: list[str] = []
        self.attributes: dict[str, str] = {}
        self.line = 1
        self.name = ""
        self.name_line = 1
        self.build_type = ""
        self.format = 1
        self.groups: list[str] = []
        self.dependencies: list[Dependency] = []
        self.in_export: dict[str, int] = {}
        self.people: set[str] = set()
        self.addresses: list[str] = []
        self.version = ""

    def doctype(self, *_: object) -> None:
        raise ManifestError("a document type is not allowed here", self.parser.CurrentLineNumber)

    def start(self, tag: str, attributes: dict[str, str]) -> None:
        if not self.stack and tag != "package":
            raise ManifestError(f"the root element is <{tag}>, not <package>", self.parser.CurrentLineNumber)
        if not self.stack and attributes.get("format", "").strip() in ("2", "3"):
            self.format = int(attributes["format"])
        self.stack.append(tag)
        self.text = []
        self.attributes = attributes
        self.line = self.parser.CurrentLineNumber

    def data(self, text: str) -> None:
        self.text.append(text)

    def end(self, tag: str) -> None:
        text = "".join(self.text).strip()
        depth = len(self.stack)
        if depth == 2 and tag == "name" and not self.name:
            self.name, self.name_line = text, self.line
        elif depth == 2 and tag == "version":
            self.version = self.version or text
        elif depth == 2 and tag in _DEPENDENCIES and text:
            condition = self.attributes.get("condition")
            self.dependencies.append(Dependency(text, _DEPENDENCIES[tag], condition, self.line))
        elif depth == 2 and tag in ("maintainer", "author"):
            self.people.update(
                said for said in (text.lower(), self.attributes.get("email", "").strip().lower()) if said
            )
        elif depth == 2 and tag == "url" and text:
            self.addresses.append(text)
        elif depth == 2 and tag == "member_of_group" and self.holds():
            self.groups.append(text)
        elif depth == 3 and tag in _DEPENDENCIES and self.stack[1] == "export":
            self.in_export.setdefault(text, self.line)
        elif depth == 3 and tag == "build_type" and self.stack[1] == "export" and self.holds():
            self.build_type = self.build_type or text
        self.stack.pop()
        self.text = []

    def needs(self, name: str) -> bool:
        return any(
            dependency.name == name and condition_holds(dependency.condition) for dependency in self.dependencies
        )

    def holds(self) -> bool:
        return condition_holds(self.attributes.get("condition"))


class ManifestError(Exception):
    """Why a package.xml cannot be used, and the line."""

    def __init__(self, message: str, line: int, column: int = 1) -> None:
        super().__init__(message)
        self.message, self.line, self.column = message, line, column


def read_manifest(file: SourceFile, data: bytes, root: str, relative: str) -> Package | Problem:
    """The package that a manifest describes, or why it cannot be read."""
    reader = _Reader()
    try:
        reader.parser.Parse(data, True)
        if not reader.name:
            raise ManifestError("the package has no <name>", 1)
        if not re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9_-]*", reader.name):
            raise ManifestError(f"{reader.name!r} is not a valid package name", reader.name_line)
    except expat.ExpatError as error:
        words = expat.errors.messages[error.code] if error.code in expat.errors.messages else str(error)
        return Problem(file.relative, error.lineno, error.offset + 1, f"malformed package.xml: {words}")
    except ManifestError as error:
        return Problem(file.relative, error.line, error.column, f"malformed package.xml: {error.message}")
    except (ValueError, LookupError) as error:
        return Problem(file.relative, 1, 1, f"malformed package.xml: {error}")
    return Package(
        reader.name,
        root,
        relative,
        _BUILD_TYPES.get(reader.build_type, "other"),
        "rosidl_interface_packages" in reader.groups,
        tuple(reader.dependencies),
        file,
        reader.name_line,
        reader.format,
        reader.build_type in ("", "catkin") and reader.needs("catkin"),
        in_export=reader.in_export,
        people=frozenset(reader.people),
        addresses=tuple(reader.addresses),
        version=reader.version,
    )


MAX_CONDITION = 1_000
"""Characters of a condition that is evaluated; nobody writes longer ones."""

_TOKEN = re.compile(
    r"\s*(?:(?P<op>==|!=|<=|>=|<|>|\(|\)|\band\b|\bor\b)|(?P<text>\"[^\"]*\"|'[^']*'|\$?[A-Za-z0-9_.-]+))"
)


def condition_holds(condition: str | None, environment: dict[str, str] | None = None) -> bool:
    """Whether a ``condition`` attribute holds, or may hold, in a ROS 2 world."""
    return condition_verdict(condition, environment) is not False


def condition_verdict(condition: str | None, environment: dict[str, str] | None = None) -> bool | None:
    """What a ``condition`` attribute comes to in a ROS 2 world; None where a variable decides that only the machine
    which builds has.  One that cannot be read holds."""
    if not condition or len(condition) > MAX_CONDITION:
        return True
    values = {"ROS_VERSION": "2", "ROS_PYTHON_VERSION": "3"} | (environment or {})
    tokens: list[str] = []
    at = 0
    while at < len(condition.rstrip()):
        match = _TOKEN.match(condition, at)
        if match is None:
            return True
        tokens.append(match.group("op") or match.group("text"))
        at = match.end()
    try:
        verdict, rest = _either(tokens, values)
    except (IndexError, KeyError, RecursionError):
        return True
    return verdict if not rest else True


_OF_ROS = frozenset({"ROS_VERSION", "ROS_DISTRO", "ROS_PYTHON_VERSION"})
"""The variables that an installation of ROS sets."""
_VARIABLE = re.compile(r"\$(\w+)")


def is_up_to_the_machine(condition: str | None) -> bool:
    """Whether a variable decides a ``condition`` attribute that no installation of ROS sets, such as ``$RUN_MODE``."""
    variables = _VARIABLE.findall(condition or "")
    return condition_verdict(condition) is None and not _OF_ROS.issuperset(variables)


def _either(tokens: list[str], values: dict[str, str]) -> tuple[bool | None, list[str]]:
    verdict, tokens = _both(tokens, values)
    while tokens and tokens[0] == "or":
        other, tokens = _both(tokens[1:], values)
        verdict = True if True in (verdict, other) else None if None in (verdict, other) else False
    return verdict, tokens


def _both(tokens: list[str], values: dict[str, str]) -> tuple[bool | None, list[str]]:
    verdict, tokens = _term(tokens, values)
    while tokens and tokens[0] == "and":
        other, tokens = _term(tokens[1:], values)
        verdict = False if False in (verdict, other) else None if None in (verdict, other) else True
    return verdict, tokens


def _term(tokens: list[str], values: dict[str, str]) -> tuple[bool | None, list[str]]:
    if tokens[0] == "(":
        verdict, rest = _either(tokens[1:], values)
        return verdict, rest[1:]
    left, op, right = _word(tokens[0], values), tokens[1], _word(tokens[2], values)
    if op not in _COMPARE:
        raise KeyError(op)
    return (None if left is None or right is None else _COMPARE[op](left, right)), tokens[3:]


_COMPARE: dict[str, Callable[[str, str], bool]] = {
    "==": operator.eq,
    "!=": operator.ne,
    "<": operator.lt,
    "<=": operator.le,
    ">": operator.gt,
    ">=": operator.ge,
}


def _word(token: str, values: dict[str, str]) -> str | None:
    return values.get(token[1:]) if token.startswith("$") else token.strip("\"'")
