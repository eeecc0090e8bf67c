"""NME001: take a name from a parameter whose default is the name as it was."""

from __future__ import annotations

import ast
import re
from typing import TYPE_CHECKING

from archlint.finding import Edit, Fix
from archlint.fixes import scopes
from archlint.libraries import tables
from archlint.model import NAMED

if TYPE_CHECKING:
    from archlint.finding import Finding, Place
    from archlint.fixes.source import Source
    from archlint.fixes.surroundings import Surroundings

_OWNERS = ("rclpy.node.Node", "rclpy.lifecycle.node.LifecycleNode", "rclpy.action.client", "rclpy.action.server")
_KIND = {
    name: NAMED[row.kind]
    for row in tables.ROWS
    for owner, _, name in [row.path.rpartition(".")]
    if row.creates and row.name is not None and owner in _OWNERS
}
"""What the name that a call takes is a name of."""


def declare_parameter(finding: Finding, around: Surroundings) -> Fix | None:
    """Declare a parameter in front of the create call and read the name from it.

    Other calls with the same name in reach of the new variable take it too: their fix is that of the first.
    """
    site = _site_of(finding, around)
    if site is None or "fixed" not in finding.group:
        return None  # a name that is absolute for a reason stays
    source = site.source
    likes = around.findings_like(finding, source.file)
    others = [(one, other) for one in likes if (other := _site_of(one, around)) and other.source is source]
    if any(other.expression is site.expression and _written(one) != _written(finding) for one, other in others):
        return None  # several names meet at this call
    mine = [other for _, other in others if site.shares_with(other)]
    if any(other.reaches(site) for other in mine if other.start < site.start):
        return None  # the first one's fix is also this one's
    # Whoever else declares parameters on a node that is handed over is perhaps in another file.
    elsewhere = around.elsewhere(source) if site.handed_over else ""
    name = _free_name(source, _written(finding), site.kind, elsewhere + "\n".join(around.handed_over))
    if site.handed_over:
        around.handed_over.add(name)
    at = source.starts[site.statement.lineno - 1]
    edits = [Edit(source.place(at, at), _lines(site, source, name))]
    for one in sorted((site, *(other for other in mine if site.reaches(other))), key=lambda other: other.start):
        edits.append(Edit(source.place(*source.span(one.expression)), name))
    return Fix("unsafe", tuple(edits), f"take the name from the parameter '{name}'")


def _lines(site: _Site, source: Source, name: str) -> str:
    """The lines that declare and read the parameter; a node that may have it already is asked first."""
    line = source.line(site.statement.lineno)
    indent = line[: len(line) - len(line.lstrip())]
    node = ast.unparse(site.node)
    declare = f"{node}.declare_parameter('{name}', {source.text[slice(*source.span(site.expression))]})"
    lines = [declare, f"{name} = {node}.get_parameter('{name}').value"]
    if not site.once:
        step = "\t" if indent.startswith("\t") else "    "
        lines[:1] = [f"if not {node}.has_parameter('{name}'):", step + declare]
    return "".join(f"{indent}{one}{source.newline}" for one in lines)


class _Site:
    """A create call whose name can become a parameter: the name's ``expression``, the ``statement`` in front of
    which the parameter can be declared, and the ``node`` to declare it on."""

    def __init__(self, source: Source, expression: ast.expr, node: ast.expr, kind: str, statement: ast.stmt) -> None:
        self.source, self.expression, self.node, self.kind, self.statement = source, expression, node, kind, statement
        self.start = source.span(expression)[0]
        self.function = scopes.enclosing_function(source, statement)
        own = scopes.own_node(source, node, statement)
        self.once = own and scopes.runs_once(source, self.function)
        self.handed_over = not own or scopes.has_base_elsewhere(source, node, statement)
        """True where other files may declare parameters on the same node."""

    def shares_with(self, other: _Site) -> bool:
        return (
            self.function is other.function
            and self.kind == other.kind
            and ast.dump(self.node) == ast.dump(other.node)
            and ast.dump(self.expression) == ast.dump(other.expression)
        )

    def reaches(self, other: _Site) -> bool:
        """Whether the other call always runs after this one's statement has begun."""
        if other.start <= self.start:
            return False
        block = scopes.block_of(self.source, self.statement)
        around: ast.AST | None = other.statement
        while around is not None and around not in block:
            around = self.source.parents.get(around)
        return around is not None


def _site_of(finding: Finding, around: Surroundings) -> _Site | None:
    """The create call that the finding is about: it stands where the name is written, or is related."""
    place = next((one.place for one in finding.related), finding.place)
    source = around.source(place.file)
    if source is None:
        return None
    if place not in source.sites:
        source.sites[place] = _made_site(place, source, lambda: around.elsewhere(source))
    found = source.sites[place]
    return found if isinstance(found, _Site) else None


def _made_site(place: Place, source: Source, elsewhere: scopes.Elsewhere) -> _Site | None:
    expression = source.node_at(place, ast.expr)
    call = None if expression is None else source.parents.get(expression)
    if isinstance(call, ast.keyword):
        call = source.parents.get(call)
    if expression is None or not isinstance(call, ast.Call):
        return None
    node, kind = _node_and_kind(call)
    statement = scopes.statement_before(source, call)
    if node is None or statement is None or not scopes.is_plain(expression):
        return None
    indent = source.line(statement.lineno)
    if indent[: source.span(statement)[0] - source.starts[statement.lineno - 1]].strip():
        return None  # something else stands in front of it
    if not scopes.is_node(source, node, statement, elsewhere) or _is_given(source, expression):
        return None
    site = _Site(source, expression, node, kind, statement)
    again = not site.once or scopes.is_other_method(source, site.function)
    return site if not again or scopes.is_constant(source, expression, statement) else None


def _is_given(source: Source, expression: ast.expr) -> bool:
    """Whether the caller gives (a part of) a name: another call may give another one."""
    function = scopes.enclosing_function(source, expression)
    if function is None or function.name == "__init__":
        return False
    own = function.args
    given = {one.arg for one in (*own.posonlyargs, *own.args, *own.kwonlyargs)} - {"self"}
    return any(isinstance(one, ast.Name) and one.id in given for one in ast.walk(expression))


def _written(finding: Finding) -> str:
    return finding.identity[-1]


def _node_and_kind(call: ast.Call) -> tuple[ast.expr | None, str]:
    """The node that a create call is made on, where it is a plain name such as ``self`` or ``self.node``."""
    function = call.func
    name = function.attr if isinstance(function, ast.Attribute) else getattr(function, "id", "")
    if name not in _KIND:
        return None, ""
    node: ast.expr | None = None
    if _KIND[name] == "action":
        node = call.args[0] if call.args else None
    elif isinstance(function, ast.Attribute):
        node = function.value
    plain = isinstance(node, ast.Name) or (isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name))
    return (node if plain else None), _KIND[name]


def _free_name(source: Source, topic: str, kind: str, elsewhere: str) -> str:
    """A name for the parameter and the variable that is not in use yet: of the last part of the topic, else of the
    last two, and so on."""
    parts = [re.sub(r"\W+", "_", part).strip("_").lower() for part in topic.split("/")]
    parts = [part for part in parts if part] or [kind]
    names = [_base("_".join(parts[-count:]), kind) for count in range(1, len(parts) + 1)]
    names += [f"{names[0]}_{number}" for number in range(2, 1_000)]
    name = next(one for one in names if one not in source.taken and not _used(one, source.text + elsewhere))
    source.taken.add(name)
    return name


def _base(words: str, kind: str) -> str:
    base = words if words.endswith(kind) else f"{words}_{kind}"
    return base if base[0].isalpha() else f"{kind}_{words}"


def _used(name: str, text: str) -> bool:
    """Whether a text uses a name as a variable or in a string; attributes are in nobody's way."""
    return re.search(rf"(?<![\w.]){name}\b", text) is not None
