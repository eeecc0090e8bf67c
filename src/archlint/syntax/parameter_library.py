"""The parameters of ``generate_parameter_library``, as the code that is generated from them.

What the header or the module says is lowered here in few words: a class ``ParamListener`` that declares the parameters
on the node that it is given and puts their values into an object of the class ``Params``.  A header has both in the
namespace that the file begins with, a module in a class of that name.

Source: ``parse_yaml.py`` (``GenerateCode.parse_dict``: a map whose first value is a map is a struct, any other is a
parameter; ``__map_x`` stands for each text of the parameter ``x``) and the templates ``parameter_library_header``,
``declare_parameter`` and ``declare_runtime_parameter`` of generate_parameter_library_py, 1f74d68.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import field
from typing import TYPE_CHECKING, Any

from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.facts import FACTS_VERSION, Argument, Facts, FileProblem
from archlint.syntax.parts import names_in
from archlint.syntax.safe_yaml import YamlError, YamlReader, in_python, span_of

if TYPE_CHECKING:
    import yaml

    from archlint.syntax.facts import Expr, Span, Stmt

LIBRARY = "generate_parameter_library"
"""The module, of nobody's, whose functions stand for what the generated code does."""
_MAP = "__map_"
_KINDS = {"bool": "bool", "double": "double", "int": "integer", "string": "string"}
_KINDS |= {f"{name}_array": f"{kind}_array" for name, kind in _KINDS.items()}
_METHODS_OF_ALL = ("is_old", "refresh_dynamic_parameters", "update", "declare_params", "update_internal_params")
_METHODS = (
    *("try_get_params", "try_update_params", "get_stack_params", "setUserCallback", "clearUserCallback"),
    *("set_user_callback", "clear_user_callback", "set_params_from_dict", "unpack_parameter_dict"),
)
_WHY = "a parameter of a generated library"


@dataclass(frozen=True)
class _Row:
    """One parameter: the names of the structs around it and its own, and where that is written."""

    path: tuple[str, ...]
    kind: str
    span: Span
    default: Any = None
    has_default: bool = False
    read_only: bool = False
    description: str = ""

    @property
    def is_of_map(self) -> bool:
        return any(_MAP in part for part in self.path)


@dataclass
class _Tree:
    namespace: str
    span: Span
    rows: list[_Row] = field(default_factory=list)
    structs: list[tuple[str, ...]] = field(default_factory=list)


class _Refused(Exception):
    """The generator makes nothing of the file."""


def lower(text: str) -> Facts:
    """The facts of what is generated; none of a file that the generator refuses."""
    try:
        tree = _read(YamlReader(text, several=True))
    except YamlError as error:
        return Facts(FACTS_VERSION, problems=[FileProblem(error.line, error.column, error.message)])
    except _Refused as error:
        return Facts(FACTS_VERSION, problems=[FileProblem(1, 1, str(error))])
    body = list(_module(tree))
    return Facts(FACTS_VERSION, body=body, names=sorted(names_in(body)))


# ------------------------------------------------------------------------------------------------ reading


def _read(reader: YamlReader) -> _Tree:
    pairs = [] if not reader.roots else list(reader.pairs(reader.roots[0], 0))
    if len(pairs) != 1:
        raise _Refused("the definition of parameters must have one root element")
    [(name, key, value)] = pairs
    tree = _Tree(name.rpartition("::")[2], span_of(key))
    _gather(reader, value, (), tree)
    return tree


def _gather(reader: YamlReader, node: yaml.Node, path: tuple[str, ...], tree: _Tree) -> None:
    import yaml

    pairs = list(reader.pairs(node, len(path)))
    if not pairs:
        raise _Refused(f"'{'.'.join(path)}' is no parameter")
    if not isinstance(pairs[0][2], yaml.MappingNode):
        raise _Refused("the root element holds no parameters")
    for name, key, value in pairs:
        if not isinstance(value, yaml.MappingNode):
            continue
        inside = list(reader.pairs(value, len(path) + 1))
        if inside and isinstance(inside[0][2], yaml.MappingNode):
            tree.structs.append((*path, name))
            _gather(reader, value, (*path, name), tree)
            continue
        row = _parameter((*path, name), span_of(key), {word: node for word, _, node in inside})
        if row is not None:
            tree.rows.append(row)


def _parameter(path: tuple[str, ...], span: Span, nodes: dict[str, yaml.Node]) -> _Row | None:
    """One parameter; None for one of the type ``none``, of which no code is made."""
    given = {name: in_python(node) for name, node in nodes.items() if name != "validation"}
    base, _, size = str(given.get("type", "")).partition("_fixed")
    if base == "none":
        return None
    kind = _KINDS.get(base)
    if kind is None or (size and not size.removeprefix("_").isdigit()):
        raise _Refused(f"'{'.'.join(path)}' has no type that there is")
    default, read_only = given.get("default_value"), bool(given.get("read_only", False))
    return _Row(path, kind, span, default, default is not None, read_only, str(given.get("description", "")))


# ------------------------------------------------------------------------------------------------ writing


def _module(tree: _Tree) -> Iterator[Stmt]:
    span = tree.span
    yield facts.Import(LIBRARY, None, span)
    yield facts.Class("_Part", [], [_entries(span)], [], span, span)
    yield facts.Class("_Params", [], [_params(tree), _entries(span)], [], span, span)
    yield _listener(tree, "_ListenerOfCpp", of_cpp=True)
    yield _listener(tree, "_Listener", of_cpp=False)
    for name, twin in (("ParamListener", "_ListenerOfCpp"), ("Params", "_Params"), ("StackParams", "_Params")):
        targets: list[Expr] = [_name(f"{tree.namespace}::{name}", span), _name(name, span)]
        yield facts.Assign(targets, _name(twin, span), span)
    inside: list[Stmt] = [
        facts.Assign([_name("Params", span)], _name("_Params", span), span),
        facts.Assign([_name("ParamListener", span)], _name("_Listener", span), span),
    ]
    yield facts.Class(tree.namespace, [], inside, [], span, span)


def _entries(span: Span) -> Stmt:
    """What stands for the entries of a map."""
    return _function("get_entry", [], [facts.Return(facts.Opaque(_WHY, span), span)], span)


def _params(tree: _Tree) -> Stmt:
    """The constructor of the values: of each is known that there is one."""
    span = tree.span
    body: list[Stmt] = []
    for path in tree.structs:
        if not any(_MAP in part for part in path):
            part = facts.Call(_name("_Part", span), [], span)
            body.append(facts.Assign([_attributes(_name("self", span), path, span)], part, span))
    for row in tree.rows:
        if not row.is_of_map:
            target = _attributes(_name("self", span), row.path, row.span)
            body.append(facts.Assign([target], facts.Opaque(_WHY, row.span), row.span))
    for path in tree.structs:
        before, last = path[:-1], path[-1]
        if _MAP in last and not any(_MAP in part for part in before):
            for name in (f"{last.replace(_MAP, '')}_map", last):
                target = _attributes(_name("self", span), (*before, name), span)
                body.append(facts.Assign([target], facts.Opaque(_WHY, span), span))
    for name in ("stamp_", "__stamp"):
        body.append(facts.Assign([_attributes(_name("self", span), (name,), span)], facts.Opaque(_WHY, span), span))
    return _function("__init__", [], body, span)


def _listener(tree: _Tree, name: str, of_cpp: bool) -> Stmt:
    span = tree.span
    params = _attributes(_name("self", span), ("params_",), span)
    body: list[Stmt] = [facts.Assign([params], facts.Call(_name("_Params", span), [], span), span)]
    if of_cpp:
        given = [_name("prefix", span), _name("last", span)]
        body.append(facts.Assign([_name("prefix", span)], _library("prefix", given, span), span))
    for row in tree.rows:
        if not row.is_of_map:
            value = _declared(row, [".".join(row.path)], of_cpp)
            body.append(facts.Assign([_attributes(params, row.path, row.span)], value, row.span))
    names = {row.path: row for row in tree.rows if not row.is_of_map}
    body += [_declared_for_each(row, names, params, of_cpp) for row in tree.rows if row.is_of_map]
    listed = [facts.Param("prefix", "normal", facts.Literal("", span)), facts.Param("last", "normal", _nothing(span))]
    methods: list[Stmt] = [_function("__init__", [facts.Param("node", "normal"), *listed], body, span)]
    methods.append(_function("get_params", [], [facts.Return(params, span)], span))
    for method in (*_METHODS_OF_ALL, *_METHODS):
        methods.append(_unknown_method(method, span))
    return facts.Class(name, [], methods, [], span, span)


def _unknown_method(name: str, span: Span) -> Stmt:
    """A method whose result is not known; a function that it is given is called some time."""
    call = facts.Call(facts.Opaque(_WHY, span), [Argument(_name("given", span), None, "*")], span)
    return _function(name, [facts.Param("given", "star")], [facts.Return(call, span)], span)


def _declared_for_each(row: _Row, names: dict[tuple[str, ...], _Row], params: Expr, of_cpp: bool) -> Stmt:
    """``for value_1 in params.joints: declare(…)``, a loop for each map around it."""
    span = row.span
    maps = [at for at, part in enumerate(row.path) if _MAP in part]
    before, after = row.path[: maps[0]], row.path[maps[-1] + 1 :]
    variables = [f"value_{number}" for number in range(1, len(maps) + 1)]
    words: list[str | facts.Field] = [f"{'.'.join(before)}." if before else ""]
    for number, variable in enumerate(variables):
        words += ["." if number else "", facts.Field(_name(variable, span))]
    words.append("." + ".".join(after))
    statement: Stmt = facts.Expression(_declared(row, [word for word in words if word], of_cpp), span)
    for at, variable in reversed(list(zip(maps, variables, strict=True))):
        values = _values_of(row.path[at].replace(_MAP, ""), before, names, params, span)
        statement = facts.For(_name(variable, span), values, [statement], [], False, span)
    return statement


def _values_of(key: str, around: tuple[str, ...], names: dict[tuple[str, ...], _Row], params: Expr, span: Span) -> Expr:
    """The parameter that lists the entries of a map: of the struct that it is in, or of one around."""
    for end in range(len(around), -1, -1):
        if (*around[:end], key) in names:
            return _attributes(params, (*around[:end], key), span)
    return facts.Opaque(_WHY, span)


def _declared(row: _Row, words: Sequence[str | facts.Field], of_cpp: bool) -> Expr:
    """The call that declares a parameter, and gives its value."""
    span = row.span
    parts: list[str | facts.Field] = [facts.Field(_name("prefix", span)), *words]
    # Empty lists have a type in C++ alone.
    has_kind = of_cpp or row.default != []
    given = [
        _name("node", span),
        facts.FormatString(parts, span),
        _value(row.default, row.kind, span) if row.has_default else _nothing(span),
        facts.Literal(row.kind if has_kind else "", span),
        facts.Literal(row.read_only, span),
        facts.Literal(row.description, span),
    ]
    return _library("declare", given, span)


def _value(value: Any, kind: str, span: Span) -> Expr:
    if isinstance(value, list):
        items = [_value(item, kind.removesuffix("_array"), span) for item in value]
        return facts.Sequence("list", items, span)
    if isinstance(value, int) and not isinstance(value, bool) and kind == "double":
        value = float(value)
    return facts.Literal(value, span) if isinstance(value, (str, int, float)) else facts.Opaque(_WHY, span)


def _function(name: str, params: list[facts.Param], body: list[Stmt], span: Span) -> Stmt:
    return facts.Function(name, [facts.Param("self", "normal"), *params], body, [], None, False, False, span, span)


def _library(name: str, given: Sequence[Expr], span: Span) -> Expr:
    function = facts.Attribute(_name(LIBRARY, span), name, span)
    return facts.Call(function, [Argument(value) for value in given], span)


def _name(name: str, span: Span) -> Expr:
    return facts.Name(name, span)


def _nothing(span: Span) -> Expr:
    return facts.Literal(None, span)


def _attributes(owner: Expr, path: Sequence[str], span: Span) -> Expr:
    for name in path:
        owner = facts.Attribute(owner, name, span)
    return owner


__all__ = ["LIBRARY", "lower"]
