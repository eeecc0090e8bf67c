"""Topics, services and actions that are named in their nodes, where a picture has too many lines for all."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.counted import counted
from archlint.render.diagram.gathering import enough, is_plain, is_plain_line, lines_at
from archlint.render.wrapping import SMALL
from archlint.systems.graph import NODE

if TYPE_CHECKING:
    from collections.abc import Collection, Iterator, Mapping, Sequence, Sized

    from archlint.architecture import ConnectionKind
    from archlint.render.diagram.model import Diagram, Key, Line, Shape

MANY_NODES = 8
"""Nodes up to which lines lead to a topic, service or action in a crowded picture."""
SEVERAL_NODES = 3
"""The same where a picture is still crowded when all else has given way."""
_NOBODY: Mapping[ConnectionKind, tuple[str, str]] = {
    "topic": ("subscriber", "publisher"),
    "service": ("server", "client"),
    "action": ("action server", "action client"),
}
"""Who is missing at the other end of a node that sends, and of one that takes."""


def busy_named(diagram: Diagram, most: int, many: int = MANY_NODES) -> Diagram:
    """The diagram with ``most`` lines less, or as many as what more than ``many`` nodes use can save: its name is said
    in each of them."""
    at = lines_at(diagram)
    busy: dict[Key, list[Line]] = {}
    for key, own in at.items():
        if diagram.shapes[key].kind in ("topic", "service", "action") and len(_nodes(key, own)) > many:
            busy[key] = [line for line in own if is_plain_line(line)]
    shapes, lines = dict(diagram.shapes), dict.fromkeys(diagram.lines)
    named: dict[Key, dict[str, list[Line]]] = {}
    for key in sorted(enough({key: len(plain) for key, plain in busy.items()}, most)):
        shape = shapes[key]
        shapes[key] = replace(shape, lines=(*shape.lines, _ends_in_words(key, at[key])))
        for line in busy[key]:
            del lines[line]
            named.setdefault(_other(line, key), {}).setdefault(shape.title, []).append(line)
    for key, names in named.items():
        rows = tuple(_tie_in_words(key, *name) for name in names.items())
        shapes[key] = replace(shapes[key], named=(*shapes[key].named, *rows))
    return replace(diagram, shapes=shapes, lines=tuple(lines))


def loose_named(diagram: Diagram, most: int) -> Diagram:
    """The diagram with ``most`` lines less, or as many as what has nothing at its other end can save: its name is said
    in the nodes that have it."""
    at = lines_at(diagram)
    loose = {key: len(at[key]) for key, shape in diagram.shapes.items() if _is_loose(shape, at.get(key, ()))}
    chosen = sorted(enough(loose, most))
    shapes, lines = dict(diagram.shapes), dict.fromkeys(diagram.lines)
    named: dict[Key, dict[tuple[str, bool], list[str]]] = {}
    in_nodes = Counter(diagram.in_nodes)
    for key in chosen:
        shape = shapes.pop(key)
        in_nodes.update(shape.holds or {shape.kind: 1})
        names = shape.lines if shape.kind == "ends" else (shape.title,)
        for line in at[key]:
            del lines[line]
            how = (_nobody(line, key), line.stroke == "dotted")
            named.setdefault(_other(line, key), {}).setdefault(how, []).extend(names)
    for key, ends in named.items():
        rows = [row for how, names in sorted(ends.items()) for row in _rows(*how, names)]
        shapes[key] = replace(shapes[key], named=(*shapes[key].named, *rows))
    groups = {key: title for key, title in diagram.groups.items() if key in shapes}
    return replace(diagram, shapes=shapes, lines=tuple(lines), groups=groups, in_nodes=in_nodes)


def _is_loose(shape: Shape, lines: Sequence[Line]) -> bool:
    """Whether there is nobody at the other end, and nothing else to be said of it."""
    return not shape.matched and bool(lines) and (shape.kind == "ends" or is_plain(shape, lines))


def _other(line: Line, key: Key) -> Key:
    return line.tail if line.head == key else line.head


def _nodes(key: Key, lines: Sequence[Line]) -> set[Key]:
    return {_other(line, key) for line in lines}


def _ends_in_words(key: Key, lines: Sequence[Line]) -> str:
    """``from 2 nodes, to 9 nodes``."""
    senders = {line.tail for line in lines if line.head == key}
    takers = {line.head for line in lines if line.tail == key}
    sides: tuple[tuple[str, Sized], ...] = (("from", senders), ("to", takers))
    return ", ".join(f"{word} {counted(len(nodes), NODE)}" for word, nodes in sides if nodes)


def _tie_in_words(node: Key, title: str, lines: Collection[Line]) -> str:
    """``→ /tf`` for a node that sends to it, ``← /tf`` for one that takes from it."""
    ways = {line.tail == node for line in lines}
    arrow = "↔" if len(ways) == 2 else "→" if True in ways else "←"
    condition = ", under a condition" if all(line.stroke == "dotted" for line in lines) else ""
    return f"{arrow} {title}{condition}"


def _nobody(line: Line, key: Key) -> str:
    """``→ no subscriber`` of a topic that its node publishes."""
    sends, takes = _NOBODY[line.kind]
    return f"→ no {sends}" if line.head == key else f"← no {takes}"


def _rows(words: str, conditional: bool, names: Sequence[str]) -> Iterator[str]:
    """``→ no subscriber: /a, /b/{c, d}``, in rows of a readable length."""
    row = f"{words}{', under a condition' if conditional else ''}:"
    short = _short(names)
    for number, word in enumerate(short, 1):
        if row and len(row) + len(word) + 2 > SMALL:
            yield row
            row = ""
        row += f"{' ' if row else ''}{word}{',' if number < len(short) else ''}"
    yield row


def _short(names: Sequence[str]) -> list[str]:
    """What is between the commas where a namespace that several have is said once: ``/a``, ``/b/{c``, ``d}``."""
    inside: dict[tuple[str, str], list[str]] = {}
    for name in names:
        namespace, _, own = name.rpartition("/")
        inside.setdefault((namespace, "" if namespace else name), []).append(own)
    words: list[str] = []
    for (namespace, alone), own_names in inside.items():
        if alone:
            words += [alone] * len(own_names)
        elif len(own_names) == 1:
            words.append(f"{namespace}/{own_names[0]}")
        else:
            first, *middle, last = own_names
            words += [f"{namespace}/{{{first}", *middle, f"{last}}}"]
    return words


__all__ = ["MANY_NODES", "SEVERAL_NODES", "busy_named", "loose_named"]
