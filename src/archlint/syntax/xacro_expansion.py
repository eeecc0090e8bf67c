"""What xacro makes of a description of a robot: its elements, once includes, macros and conditions are followed.

Source: ``xacro/__init__.py``, branches ros2.  The arguments of a description (``$(arg name)``) are anything, so that
what stands in a condition on them is there ``perhaps``.  What is not followed makes the result ``open``.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import field, replace

from archlint.records import dataclass
from archlint.syntax.xacro_expressions import Value, evaluated, truth
from archlint.syntax.xml_elements import Element, read_elements

_XACRO = "xacro:"
_OTHERS = frozenset({"attribute", "call", "element"})
"""What xacro has besides macros and is not followed here."""
BUILT_IN = frozenset({"arg", "if", "include", "insert_block", "macro", "property", "unless", *_OTHERS})
_MOST = 30_000
"""How many elements are looked at."""
_DEEPEST = 60
_PARAMETER = re.compile(
    r"\s*([^\s:=]+)\s*:?=\s*(\^\|?)?(\$\{[^}]*\}|\$\([^)]*\)|(?:'[^']*'|\"[^\"]*\"|[^\s'\"])*)(?:\s+|$)"
)
_WITHOUT_DEFAULT = re.compile(r"\s*([^\s:=]+)(?:\s+|$)")

Reader = Callable[[str, str], "tuple[str, str] | None"]
"""What finds a file by the text of an include and the file that it stands in: its path and its text."""


@dataclass(frozen=True)
class Made:
    """An element of the result; an attribute of which the value is not known is not in it."""

    tag: str
    attributes: dict[str, str]
    file: str
    line: int
    column: int
    perhaps: bool
    children: list[Made] = field(default_factory=list)


@dataclass(frozen=True)
class Stop:
    """A call at which xacro stops: of no ``macro``, or of one that has no ``parameter``, or that is not given it."""

    file: str
    line: int
    column: int
    macro: str
    parameter: str = ""
    is_given: bool = False
    known: tuple[str, ...] = ()
    """The names that there are: of macros, or of the parameters that are not given."""


@dataclass(frozen=True)
class Expansion:
    """What is below the outermost element, and whether there may be more; ``files`` are all that were read, and
    ``stop`` is where xacro stops."""

    children: list[Made]
    open: bool
    files: frozenset[str]
    stop: Stop | None = None


@dataclass(frozen=True)
class _Macro:
    parameters: tuple[tuple[str, str | None, bool], ...]
    """Each with its default, and whether it is that of the caller's where that has one of the name."""
    blocks: tuple[str, ...]
    element: Element
    file: str


@dataclass(frozen=True)
class _Block:
    """Elements that are put in wherever they are asked for, and how many they are with all below them."""

    rows: Sequence[Made]
    size: int


@dataclass
class _Symbols:
    """The properties, parameters and blocks that are known at a place."""

    outer: _Symbols | None = None
    values: dict[str, Value] = field(default_factory=dict)
    blocks: dict[str, _Block | None] = field(default_factory=dict)
    asked: list[str] = field(default_factory=list)
    settled: set[str] = field(default_factory=set)
    """The properties whose text has been worked out: xacro does that where one is asked for first, and keeps it."""

    def value_of(self, name: str) -> Value:
        here: _Symbols | None = self
        while here is not None and name not in here.values:
            here = here.outer
        if here is None or name in here.asked:
            return None
        value = here.values[name]
        if not isinstance(value, str) or name in here.settled:
            return value
        here.asked.append(name)
        try:
            value = here.values[name] = _literal(evaluated(value, here))
            here.settled.add(name)
        finally:
            here.asked.pop()
        return value

    def block_of(self, name: str) -> _Block | None:
        here: _Symbols | None = self
        while here is not None and name not in here.blocks:
            here = here.outer
        return None if here is None else here.blocks[name]

    @property
    def top(self) -> _Symbols:
        return self if self.outer is None else self.outer.top


def _literal(value: Value) -> Value:
    """A text as what it is a literal of."""
    if not isinstance(value, str):
        return value
    if len(value) >= 2 and value[0] == value[-1] == "'":
        return value[1:-1]
    if value.lower() in ("true", "false"):
        return value.lower() == "true"
    if re.fullmatch(r"-?\d{1,9}", value):
        return int(value)
    return float(value) if re.fullmatch(r"-?(?:\d+\.\d*|\.\d+|\d+(?=[eE]))(?:[eE][-+]?\d{1,2})?", value) else value


def expand(file: str, text: str, read: Reader) -> Expansion | None:
    """What xacro makes of the description in a file; None of what is none.  Never raises."""
    top = read_elements(text)
    if top is None or top.tag != "robot":
        return None
    work = _Expanding(read)
    work.files.add(file)
    children = work.below(top, file, _Symbols(), perhaps=False)
    return Expansion(children, work.open, frozenset(work.files), work.stop)


class _Expanding:
    """One run over a description."""

    def __init__(self, read: Reader) -> None:
        self.read = read
        self.open = False
        self.files: set[str] = set()
        self.macros: dict[str, _Macro | None] = {}
        self.stop: Stop | None = None
        self.left = _MOST
        self.depth = 0

    def below(self, element: Element, file: str, symbols: _Symbols, *, perhaps: bool) -> list[Made]:
        """What the children of an element become."""
        self.depth += 1
        try:
            rows: list[Made] = []
            for child in element.children:
                self.left -= 1
                if self.left < 0 or self.depth > _DEEPEST:
                    self.open = True
                    break
                rows += self._of_one(child, file, symbols, perhaps=perhaps)
            return rows
        finally:
            self.depth -= 1

    def _of_one(self, element: Element, file: str, symbols: _Symbols, *, perhaps: bool) -> Sequence[Made]:
        if not element.tag.startswith(_XACRO):
            known = ((name, evaluated(text, symbols)) for name, text in element.attributes.items())
            attributes = {name: str(value) for name, value in known if value is not None}
            copy = Made(element.tag, attributes, file, element.line, element.column, perhaps)
            copy.children.extend(self.below(element, file, symbols, perhaps=perhaps))
            return [copy]
        match name := element.tag.removeprefix(_XACRO):
            case "if" | "unless":
                holds = truth(evaluated(element.attributes.get("value", ""), symbols))
                if holds is (name == "unless"):
                    return ()
                return self.below(element, file, symbols, perhaps=perhaps or holds is None)
            case "include":
                return self._included(element, file, symbols, perhaps=perhaps)
            case "property":
                self._set(element, file, symbols, perhaps=perhaps)
            case "macro":
                self._define(element, file, perhaps=perhaps)
            case "insert_block":
                block = symbols.block_of(str(evaluated(element.attributes.get("name", ""), symbols)))
                self.left -= 0 if block is None else block.size
                if block is None or self.left < 0:
                    self.open = True
                    return ()
                return [replace(row, perhaps=row.perhaps or perhaps) for row in block.rows]
            case "arg":
                pass
            case _:
                return self._called(name, element, file, symbols, perhaps=perhaps)
        return ()

    def _included(self, element: Element, file: str, symbols: _Symbols, *, perhaps: bool) -> Sequence[Made]:
        path = evaluated(element.attributes.get("filename", ""), symbols)
        included = self.read(path, file) if isinstance(path, str) and "ns" not in element.attributes else None
        top = None if included is None else read_elements(included[1])
        if included is None or top is None:
            self.open = True
            return ()
        self.files.add(included[0])
        return self.below(top, included[0], symbols, perhaps=perhaps)

    def _set(self, element: Element, file: str, symbols: _Symbols, *, perhaps: bool) -> None:
        name, scope = element.attributes.get("name", ""), element.attributes.get("scope")
        target = symbols.top if scope == "global" else (symbols.outer or symbols) if scope == "parent" else symbols
        if "value" not in element.attributes and "default" not in element.attributes:
            before = self.left
            rows = None if perhaps else self.below(element, file, symbols, perhaps=perhaps)
            target.blocks[name] = None if rows is None else _Block(rows, before - self.left)
            return
        is_default = "value" not in element.attributes
        if is_default and name in target.values:
            return
        value: Value = element.attributes["default" if is_default else "value"]
        if scope is not None or element.attributes.get("lazy_eval") == "false":
            value = evaluated(str(value), symbols)
        target.values[name] = None if perhaps or "remove" in element.attributes else value
        target.settled.discard(name)

    def _define(self, element: Element, file: str, *, perhaps: bool) -> None:
        name = element.attributes.get("name", "").removeprefix(_XACRO)
        parameters, blocks, is_known = _parameters(element.attributes.get("params", ""))
        there = self.macros.get(name)
        is_other = name in self.macros and (there is None or there.element is not element)
        macro = _Macro(parameters, blocks, element, file)
        self.macros[name] = macro if is_known and not (perhaps and is_other) else None

    def _called(self, name: str, element: Element, file: str, symbols: _Symbols, *, perhaps: bool) -> Sequence[Made]:
        macro = self.macros.get(name)
        stop = None if perhaps or self.open else self._stop(name, macro, element, file)
        self.stop = self.stop or stop
        if macro is None or stop is not None:
            self.open = True
            return ()
        inner = _Symbols(symbols)
        for parameter, default, is_inherited in macro.parameters:
            if parameter in element.attributes:
                inner.values[parameter] = _literal(evaluated(element.attributes[parameter], symbols))
            elif is_inherited and (default is None or (inherited := symbols.value_of(parameter)) is not None):
                inner.values[parameter] = symbols.value_of(parameter) if default is None else inherited
            elif default is not None:
                inner.values[parameter] = _literal(evaluated(default, symbols))
            else:
                self.open = True  # xacro stops here
                return ()
        before = self.left
        given: Iterator[Made] = iter(self.below(element, file, symbols, perhaps=perhaps))
        size = before - self.left
        for block in macro.blocks:
            child = next(given, None)
            if child is None:
                self.open = True
                return ()
            inner.blocks[block.lstrip("*")] = _Block(child.children if block.startswith("**") else [child], size)
        return self.below(macro.element, macro.file, inner, perhaps=perhaps)

    def _stop(self, name: str, macro: _Macro | None, element: Element, file: str) -> Stop | None:
        """Where all macros are known."""
        at = file, element.line, element.column, name
        if macro is None:
            is_other = name in self.macros or name in _OTHERS or "." in name
            return None if is_other else Stop(*at, known=tuple(sorted(BUILT_IN | self.macros.keys())))
        given = [given for given in element.attributes if not given.startswith("xmlns")]
        there = [parameter for parameter, _, _ in macro.parameters]
        extra = next((parameter for parameter in given if parameter not in there), None)
        if extra is not None:
            return Stop(*at, extra, is_given=True, known=tuple(row for row in there if row not in given))
        needed = (row for row, default, is_inherited in macro.parameters if default is None and not is_inherited)
        missing = next((parameter for parameter in needed if parameter not in given), None)
        return None if missing is None else Stop(*at, missing)


def _parameters(text: str) -> tuple[tuple[tuple[str, str | None, bool], ...], tuple[str, ...], bool]:
    """The parameters of a macro, its blocks, and whether all of the text was understood."""
    rows: list[tuple[str, str | None, bool]] = []
    blocks: list[str] = []
    at = 0
    while at < len(text.rstrip()):
        match = _PARAMETER.match(text, at)
        alone = None if match is not None else _WITHOUT_DEFAULT.match(text, at)
        if match is not None:
            is_inherited = match[2] is not None
            has_default = not is_inherited or match[2] == "^|"
            rows.append((match[1], match[3] if has_default else None, is_inherited))
        elif alone is not None and alone[1].startswith("*"):
            blocks.append(alone[1])
        elif alone is not None:
            rows.append((alone[1], None, False))
        else:
            return (), (), False
        at = match.end() if match is not None else alone.end() if alone is not None else len(text)
    return tuple(rows), tuple(blocks), True


__all__ = ["BUILT_IN", "Expansion", "Made", "Reader", "Stop", "expand"]
