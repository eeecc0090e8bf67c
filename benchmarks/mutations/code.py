"""Defects inside the code of a node: parameters, callbacks, waits, messages."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from archlint.ros.standard_interfaces import table

from .defect import Defect, Sites, plants
from .endpoints import ends
from .python_source import Function, PythonSource, argument, called, literal, misspelt, own_attribute

# ----------------------------------------------------------------------------------------------------- parameters


def _declarations(source: PythonSource) -> Iterator[tuple[ast.Call, ast.Expr, str]]:
    """Statements that declare one parameter by a literal name."""
    for call in source.calls:
        statement = source.parents.get(call)
        name = literal(argument(call, 0, "name"))
        if called(call) == "declare_parameter" and name and isinstance(statement, ast.Expr):
            yield call, statement, name


@plants("a declaration dropped")
def declaration_dropped(sites: Sites) -> Iterator[Defect]:
    for source in sites.home.code:
        for call, statement, name in _declarations(source):
            cls = source.class_of(call)
            reads = [
                source.lines(other)
                for other in source.calls
                if called(other) == "get_parameter"
                and literal(argument(other, 0, "name")) == name
                and source.class_of(other) is cls
            ]
            if reads and sum(one[2] == name for one in _declarations(source)) == 1:
                edit = source.replaced(statement.value, "None")
                yield Defect((edit,), ("PRM003",), tuple(reads), also=("PRM004", "PRM005"))


@plants("a parameter declared twice")
def declared_twice(sites: Sites) -> Iterator[Defect]:
    for source in sites.home.code:
        for call, statement, _ in _declarations(source):
            if call.lineno == call.end_lineno and source.class_of(call) is not None:
                text = source.text(call).decode()
                edit = source.replaced(statement.value, f"{text}; {text}")
                yield Defect((edit,), ("PRM008",), (source.lines(call),))


# ------------------------------------------------------------------------------------------------------ callbacks

_TAKES_CALLBACK = {
    "create_subscription": ("subscription", 2),
    "create_timer": ("timer", 1),
    "create_service": ("service", 2),
}


def _callbacks(source: PythonSource, *kinds: str) -> Iterator[tuple[ast.Call, ast.expr, Function]]:
    """Create calls with ``self.method`` for a callback, and that method of the same class."""
    for call in source.calls:
        kind, position = _TAKES_CALLBACK.get(called(call), ("", 0))
        given = argument(call, position, "callback") if kind in kinds else None
        method = source.method(source.class_of(call), own_attribute(given) or "")
        if given is not None and method is not None:
            yield call, given, method


@plants("a callback that does not exist")
def callback_renamed(sites: Sites) -> Iterator[Defect]:
    for source in sites.home.code:
        for call, given, method in _callbacks(source, "subscription", "timer", "service"):
            wrong = misspelt(method.name)
            if wrong is not None:
                edit = source.replaced(given, f"self.{wrong}")
                yield Defect((edit,), ("EXE006",), (source.lines(call),))


@plants("a handler without `return response`")
def response_dropped(sites: Sites) -> Iterator[Defect]:
    for source in sites.home.code:
        for _, _, method in _callbacks(source, "service"):
            last = method.body[-1]
            if isinstance(last, ast.Return) and isinstance(last.value, ast.Name):
                edit = source.replaced(last, "pass")
                yield Defect((edit,), ("SRV007",), (source.lines(method),), also=("PRM006",))


@plants("a goal without `succeed()`")
def outcome_dropped(sites: Sites) -> Iterator[Defect]:
    for source in sites.home.code:
        for call in source.calls:
            statement = source.parents.get(call)
            if called(call) == "succeed" and not call.args and isinstance(statement, ast.Expr):
                function = source.around(call, (ast.FunctionDef, ast.AsyncFunctionDef))
                if isinstance(function, (ast.FunctionDef, ast.AsyncFunctionDef)):
                    edit = source.replaced(statement.value, "None")
                    yield Defect((edit,), ("ACT003",), (source.lines(function),))


def _front(source: PythonSource, method: Function) -> int | None:
    """Where a statement can be put in front of a body without a new line."""
    first = method.body[0]
    simple = isinstance(first, (ast.Expr, ast.Assign, ast.AugAssign, ast.AnnAssign, ast.Return, ast.Pass))
    return source.offsets(first)[0] if simple and first.lineno > method.lineno else None


def _planted(sites: Sites, statement: str, *kinds: str) -> Iterator[tuple[PythonSource, ast.Call, Function, Defect]]:
    for source in sites.home.code:
        told: set[str] = set()
        for call, _, method in _callbacks(source, *kinds):
            at = _front(source, method)
            cls = source.class_of(call)
            if at is None or method.name in told or cls is None or not _is_node(cls):
                continue
            told.add(method.name)
            place = source.lines(method.body[0])
            yield source, call, method, Defect((source.inserted(at, statement),), (), (place,))


def _is_node(cls: ast.ClassDef) -> bool:
    return any("Node" in ast.unparse(base) for base in cls.bases)


@plants("a sleep of two seconds in a callback")
def sleep(sites: Sites) -> Iterator[Defect]:
    for _, _, _, made in _planted(sites, "import time; time.sleep(2.0); ", "subscription", "timer"):
        yield Defect(made.edits, ("EXE003",), made.places)


@plants("`Rate.sleep()` in a callback")
def rate_sleep(sites: Sites) -> Iterator[Defect]:
    for _, _, _, made in _planted(sites, "self.create_rate(2.0).sleep(); ", "subscription", "timer"):
        yield Defect(made.edits, ("EXE004",), made.places, also=("EXE005",))


@plants("`spin_once` in a callback")
def spin(sites: Sites) -> Iterator[Defect]:
    for _, _, _, made in _planted(sites, "import rclpy; rclpy.spin_once(self); ", "subscription", "timer", "service"):
        yield Defect(made.edits, ("EXE001",), made.places)


def _clients(source: PythonSource, cls: ast.ClassDef | None) -> list[tuple[str, str]]:
    """``self.x = ….create_client(Type, …)`` of a class: attribute and type as written."""
    found = []
    for call in source.calls:
        above = source.parents.get(call)
        type_ = argument(call, 0, "srv_type")
        if called(call) != "create_client" or type_ is None or not isinstance(above, ast.Assign):
            continue
        name = own_attribute(above.targets[0])
        if name is not None and source.class_of(call) is cls:
            found.append((name, source.text(type_).decode()))
    return found


def _calls(sites: Sites, rules: tuple[str, ...], *kinds: str) -> Iterator[Defect]:
    for source, call, method, _ in _planted(sites, "", *kinds):
        at = _front(source, method)
        for name, type_ in _clients(source, source.class_of(call))[:1]:
            edit = source.inserted(at or 0, f"self.{name}.call({type_}.Request()); ")
            yield Defect((edit,), rules, (source.lines(method.body[0]),), also=("TMO002", "SRV004", "SRV005"))


@plants("a waiting call in a subscription or timer")
def call_in_callback(sites: Sites) -> Iterator[Defect]:
    yield from _calls(sites, ("EXE002", "CBG001"), "subscription", "timer")


@plants("a waiting call in a service handler")
def call_in_handler(sites: Sites) -> Iterator[Defect]:
    yield from _calls(sites, ("SRV003", "CBG001"), "service")


@plants("a handler that calls its own service")
def cycle(sites: Sites) -> Iterator[Defect]:
    served = {id(end.call): end for end in ends(sites, "service")}
    for source, call, method, made in _planted(sites, "", "service"):
        end, at = served.get(id(call)), _front(source, method)
        if end is None or at is None:
            continue
        type_, name = source.text(end.type).decode(), source.text(end.name).decode()
        edit = source.inserted(at, f"planted = self.create_client({type_}, {name}); planted.call({type_}.Request()); ")
        also = ("SRV003", "EXE002", "EXE005", "TMO002", "CBG001", "NME001", "SRV004")
        yield Defect((edit,), ("SRV006",), made.places, also=also)


@plants("a TF lookup that waits, in a callback")
def tf_wait(sites: Sites) -> Iterator[Defect]:
    for source in sites.home.code:
        callbacks = {id(method) for _, _, method in _callbacks(source, "subscription", "timer", "service")}
        for call in source.calls:
            plain = called(call) == "lookup_transform" and len(call.args) == 3 and not call.keywords
            first = source.with_import("from rclpy.duration import Duration as PlantedDuration")
            if plain and first is not None and id(source.around(call, ast.FunctionDef)) in callbacks:
                end = source.offsets(call.args[-1])[1]
                edits = (first, source.inserted(end, ", timeout=PlantedDuration(seconds=1.0)"))
                yield Defect(edits, ("EXE007",), (source.lines(call),))


# ---------------------------------------------------------------------------------------------------------- waits


def _without_timeout(sites: Sites, rule: str, *names: str) -> Iterator[Defect]:
    for source in sites.home.code:
        for call in source.calls:
            for keyword in call.keywords:
                if called(call) in names and keyword.arg == "timeout_sec" and keyword.value.lineno == call.lineno:
                    start = source.offsets(keyword.value)[0] - len("timeout_sec=")
                    end = source.offsets(keyword.value)[1]
                    if source.data[start:end].startswith(b"timeout_sec="):
                        edit = source.replaced(keyword.value, "None")
                        # Without a limit the loop around it never turns, and its result says nothing.
                        also = ("TMO004", "TMO005", "EXE003", "EXE002", "SRV003")
                        yield Defect((edit,), (rule,), (source.lines(call),), also=also)


@plants("`timeout_sec` taken from a wait for a server")
def endless_wait(sites: Sites) -> Iterator[Defect]:
    yield from _without_timeout(sites, "TMO001", "wait_for_service", "wait_for_server")


@plants("`timeout_sec` taken from `spin_until_future_complete`")
def endless_spin(sites: Sites) -> Iterator[Defect]:
    yield from _without_timeout(sites, "TMO003", "spin_until_future_complete")


# ------------------------------------------------------------------------------------------------------- messages


def _defined(sites: Sites, module: str) -> bool:
    """Whether the interfaces of ``module`` (``std_msgs.msg``) are here or standard ones."""
    package, _, kind = module.partition(".")
    if kind not in ("msg", "srv", "action"):
        return False
    here = sites.beside.get(package)
    return package in table().packages if here is None else any(f.endswith(f".{kind}") for f in here.files)


@plants("a field of a message misspelt")
def field_misspelt(sites: Sites) -> Iterator[Defect]:
    """Of ``message = Type()``, of a subscription's message and of a handler's response."""
    for source in sites.home.code:
        for scope, name in _message_variables(sites, source):
            for node in ast.walk(scope):
                of_it = isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id == name
                if not of_it or not isinstance(node, ast.Attribute) or isinstance(source.parents[node], ast.Call):
                    continue
                wrong = misspelt(node.attr)
                if wrong is not None and node.value.lineno == node.end_lineno:
                    edit = source.replaced(node, f"{name}.{wrong}")
                    yield Defect((edit,), ("MSG001",), (source.lines(node),), also=("SRV007",))


def _message_variables(sites: Sites, source: PythonSource) -> Iterator[tuple[ast.AST, str]]:
    for node in ast.walk(source.tree):
        if not isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            continue
        assigned: dict[str, list[ast.expr]] = {}
        for item in ast.walk(node):
            if isinstance(item, ast.Assign) and len(item.targets) == 1 and isinstance(item.targets[0], ast.Name):
                assigned.setdefault(item.targets[0].id, []).append(item.value)
        for name, values in assigned.items():
            value = values[0]
            made = value.func if len(values) == 1 and isinstance(value, ast.Call) else None
            if isinstance(made, ast.Name) and _defined(sites, source.imported.get(made.id, ("", ""))[0]):
                yield node, name
    for call, _, method in _callbacks(source, "subscription", "service"):
        type_ = argument(call, 0, "msg_type", "srv_type")
        written = type_.id if isinstance(type_, ast.Name) else ""
        arguments = [one.arg for one in method.args.args]
        if len(arguments) > 1 and _defined(sites, source.imported.get(written, ("", ""))[0]):
            yield method, arguments[-1]


@plants("an imported interface misspelt")
def interface_misspelt(sites: Sites) -> Iterator[Defect]:
    for source in sites.home.code:
        for node in source.tree.body:
            if not isinstance(node, ast.ImportFrom) or node.level or not _defined(sites, node.module or ""):
                continue
            for alias in node.names:
                wrong = misspelt(alias.name)
                if wrong is not None and alias.asname is None and alias.lineno == alias.end_lineno:
                    start = source.starts[alias.lineno - 1] + alias.col_offset
                    edit = source.inserted(start, f"{wrong} as ")
                    # The other end, and the code that uses it, now speak of another type.
                    also = ("TOP001", "SRV002", "ACT002", "TOP005", "MSG001")
                    yield Defect((edit,), ("MSG002",), (source.lines(node),), also=also)
