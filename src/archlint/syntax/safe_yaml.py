"""YAML as ROS reads it: positions kept, no tags, and aliases counted each time they are used."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from archlint.syntax.facts import Span
from archlint.syntax.launch_elements import Scalar

if TYPE_CHECKING:
    import yaml

NODES = 200_000
"""How many values a file may hold, aliases counted each time."""
DEPTH = 60
_LIBYAML_TOO_DEEP = "exceeded maximum nesting depth"
"""What libyaml says at 1,000 brackets, since the one in PyYAML 6.0.4; the error has no type of its own."""


class YamlError(Exception):
    """Why a YAML text cannot be used; lines and columns start at 1."""

    def __init__(self, message: str, line: int = 1, column: int = 1) -> None:
        super().__init__(message)
        self.message, self.line, self.column = message, line, column


class YamlReader:
    """A document, composed but never constructed: no tag makes an object.

    A second document is an error, as it is to launch, unless there may be ``several``; they are ``roots`` then.
    What ``rcl`` reads, it reads with another scanner than launch.
    """

    def __init__(self, text: str, several: bool = False, rcl: bool = False) -> None:
        self.left = NODES
        self._rcl = rcl
        self.roots = _compose(text, several, rcl)
        self.root = self.roots[0] if self.roots else None

    def spend(self, node: yaml.Node, depth: int) -> None:
        _refuse_tag(node)
        self.left -= 1
        if self.left < 0 or depth > DEPTH:
            mark = node.start_mark
            raise YamlError("too many values for a ROS file, or nested too deeply", mark.line + 1, mark.column + 1)

    def pairs(self, node: yaml.Node, depth: int) -> Iterator[tuple[str, yaml.Node, yaml.Node]]:
        """Keys as text with the nodes of key and value; ``<<`` merges are resolved."""
        import yaml

        if not isinstance(node, yaml.MappingNode):
            return
        for key, value in node.value:
            self.spend(key, depth)
            self.spend(value, depth)
            match key:
                case yaml.ScalarNode(tag="tag:yaml.org,2002:merge"):
                    yield from self.pairs(value, depth + 1)
                case yaml.ScalarNode(value=text):
                    yield text, key, value

    def value(self, node: yaml.Node, depth: int = 0) -> Any:
        """Plain Python data: scalars, lists and dicts with text keys."""
        import yaml

        self.spend(node, depth)
        match node:
            case yaml.ScalarNode():
                return scalar(node, self._rcl)
            case yaml.SequenceNode(value=items):
                return [self.value(item, depth + 1) for item in items]
        return {key: self.value(value, depth + 1) for key, _, value in self.pairs(node, depth)}


def in_python(node: yaml.Node) -> Any:
    """What PyYAML makes of a value that has been read before: ``1e5`` and ``y`` are texts to it, ``0o17`` is, too, and
    ``1_000`` is a number.  A date is its text."""
    import yaml

    match node:
        case yaml.ScalarNode(value=text):
            try:
                constructed = yaml.constructor.SafeConstructor().construct_object(node)
            except (ValueError, yaml.YAMLError):  # 2024-13-01 looks like a date
                return text
            return constructed if constructed is None or isinstance(constructed, (bool, int, float, str)) else text
        case yaml.SequenceNode(value=items):
            return [in_python(item) for item in items]
    return {}


def _compose(text: str, several: bool, rcl: bool) -> list[yaml.Node]:
    import yaml

    from archlint.syntax.rcl_yaml import LaunchLoader, RclLoader

    loader = RclLoader if rcl else LaunchLoader
    try:
        if several:
            return list(yaml.compose_all(text, Loader=loader))
        root = yaml.compose(text, Loader=loader)
        return [] if root is None else [root]
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        line, column = (mark.line + 1, mark.column + 1) if mark is not None else (1, 1)
        if error.problem == _LIBYAML_TOO_DEEP:
            raise YamlError("nested too deeply", line, column) from None
        raise YamlError(f"malformed YAML: {error.problem or error.context}", line, column) from None
    except (yaml.YAMLError, ValueError) as error:
        raise YamlError(f"malformed YAML: {str(error).splitlines()[0]}") from None
    except RecursionError:
        raise YamlError("nested too deeply") from None


def span_of(node: yaml.Node) -> Span:
    start, end = node.start_mark, node.end_mark
    if end.line != start.line and end.column == 0:
        return (start.line + 1, start.column + 1, start.line + 1, start.column + 2)
    return (start.line + 1, start.column + 1, end.line + 1, end.column + 1)


_INTEGER = re.compile(r"[-+]?(?:0[xX][0-9a-fA-F]+|0[0-7]+|0|[1-9][0-9]*)")
_FLOAT = re.compile(r"[-+]?(?:[0-9]+\.[0-9]*|\.[0-9]+|[0-9]+)(?:[eE][-+]?[0-9]+)?")
_HEXADECIMAL = re.compile(r"[-+]?0[xX](?:[0-9a-fA-F]+\.?[0-9a-fA-F]*|\.[0-9a-fA-F]+)(?:[pP][-+]?[0-9]+)?")
_INFINITE = re.compile(r"[-+]?(?:\.(?:inf|Inf|INF)|(?i:inf|infinity))|\.(?:nan|NaN|NAN)|[-+]?(?i:nan)")
_INTEGERS = 2**63
_TRUE = frozenset({"y", "yes", "true", "on"})
_FALSE = frozenset({"n", "no", "false", "off"})


_STANDARD = "tag:yaml.org,2002:"


def _refuse_tag(node: yaml.Node) -> None:
    """YAML's own tags will do; what others stand for, ROS refuses to make."""
    if not node.tag.startswith(_STANDARD) or node.tag.startswith(f"{_STANDARD}python/"):
        mark, shown = node.start_mark, node.tag.replace(_STANDARD, "!!")
        raise YamlError(f"the tag {shown} has no meaning in ROS", mark.line + 1, mark.column + 1)


def scalar(node: yaml.ScalarNode, rcl: bool = False) -> Scalar:
    """The value of a scalar, a text where ``rcl`` reads a ``null``.

    Raises :class:`YamlError` for a tag that makes an object.
    """
    _refuse_tag(node)
    text: str = node.value
    if node.style or node.tag == "tag:yaml.org,2002:binary":  # libyaml says "" of a plain one, PyYAML None
        return text
    if node.tag == "tag:yaml.org,2002:null":
        return text if rcl and text else None
    return plain_scalar(text)


def plain_scalar(text: str) -> Scalar:
    """What an unquoted scalar is to rcl's YAML parser: a bool, a number, or text.

    Source: ``get_value`` of rcl_yaml_param_parser, which leaves numbers to C's ``strtol`` and ``strtod``.
    """
    lower = text.lower()
    if lower in _TRUE or lower in _FALSE:
        same_case = text in (lower, lower.upper(), lower.capitalize())
        return lower in _TRUE if same_case else text
    if len(text) > 64:
        return text
    number = _integer(text) if _INTEGER.fullmatch(text) else _float(text)
    return text if number is None else number


def _integer(text: str) -> int | float:
    """An integer; one that does not fit is a float."""
    digits = text.lower().lstrip("+-")
    base = 16 if digits.startswith("0x") else 8 if digits.startswith("0") else 10
    number = int(digits, base) * (-1 if text.startswith("-") else 1)
    if -_INTEGERS <= number < _INTEGERS:
        return number
    return float(number) if base == 16 else float(text)


def _float(text: str) -> float | None:
    """A float; one that is too large, or too near to zero, stays a text."""
    if _INFINITE.fullmatch(text):
        return float(text.replace(".", ""))
    if _HEXADECIMAL.fullmatch(text):
        return float.fromhex(text)
    number = float(text) if _FLOAT.fullmatch(text) else None
    vanishes = number == 0 and re.search("[1-9]", re.split("[eE]", text)[0])
    return None if number in (math.inf, -math.inf) or vanishes else number


def written_and_read(text: str) -> Scalar:
    """What rcl reads of a text that PyYAML has written: PyYAML leaves the quotes out where it would read the text as
    one itself, and rcl takes ``1e5`` for a number and ``y`` for true."""
    import yaml

    read = plain_scalar(text)
    if isinstance(read, str):
        return text
    resolver: Any = yaml.resolver.Resolver()
    return read if resolver.resolve(yaml.ScalarNode, text, (True, False)) == f"{_STANDARD}str" else text
