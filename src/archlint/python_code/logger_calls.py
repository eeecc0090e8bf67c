"""Calls of a ROS logger that it refuses: it takes one text, and no ``%s`` arguments as Python's own logging does.

Source: ``RcutilsLogger.log`` and ``get_filters_from_kwargs`` in rclpy/impl/rcutils_logger.py, and
``rclpy_logging_rcutils_log``, which takes a text; tried with rclpy of jazzy and kilted.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from functools import partial
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.libraries.api_signatures import distros
from archlint.model import Misuse, RefusedCall
from archlint.place import Place
from archlint.python_code.class_chains import classes_of, files_with, methods_of
from archlint.python_code.tried_code import tried_for
from archlint.records import dataclass
from archlint.suggestions import nearest
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in, parts_of, targets_in

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

LOGGER = "rclpy.logging.RcutilsLogger"
GET_LOGGER = "rclpy.node.Node.get_logger"
LEVELS = frozenset({"info", "warn", "warning", "error", "fatal"})
"""Not ``debug``: nobody sees it by default, and what is not logged is not looked at."""
_KEYWORDS = frozenset({"message", "name", "once", "skip_first", "throttle_duration_sec", "throttle_time_source_type"})

_REFUSALS = frozenset({"AttributeError", "TypeError"})
"""What an ``except`` names that is there for a call that is refused."""


def has_own_loggers(workspace: WorkspaceIndex) -> bool:
    """Whether a class of the workspace has a method ``get_logger`` of its own."""
    return any(_has_own_loggers(workspace, path) is not False for path in files_with(workspace, "get_logger"))


def refused_logger_calls(workspace: WorkspaceIndex) -> Iterator[RefusedCall]:
    """Every such call in the files that use rclpy; none where the workspace has loggers of its own."""
    if has_own_loggers(workspace):
        return
    for file, _ in workspace.code.judged():
        if not workspace.roles.is_test(file.relative) and workspace.code.mentions(file.relative, "get_logger"):
            for span in _given_to_node(workspace, file.relative) or ():
                place = Place(file.relative, *span)
                yield RefusedCall(place, GET_LOGGER, Misuse.TOO_MANY, distros=distros())
            for refusal in _refused(workspace, file.relative) or ():
                yield RefusedCall(
                    Place(file.relative, *refusal.span),
                    f"{LOGGER}.{refusal.method}",
                    refusal.misuse,
                    refusal.parameters,
                    takes=1,
                    given=refusal.given,
                    wanted="a text",
                    signature=(refusal.instead,),
                    distros=distros(),
                )


@kept_for_each_file
def _has_own_loggers(file_facts: facts.Facts) -> bool:
    """Whether a class has a method ``get_logger`` of its own."""
    methods = (function for cls in classes_of(file_facts) for function in methods_of(cls))
    return any(method.name == "get_logger" for method in methods)


@dataclass(frozen=True)
class AbsentOfLogger:
    """``self.get_logger().warm(…)``; ``near`` is the method that was probably meant, ``option`` what it takes for
    that."""

    place: Place
    name: str
    near: str
    option: str = ""


_OF_LOGGERS = frozenset(
    {"contexts", "debug", "error", "fatal", "get_child", "get_effective_level", "info", "is_enabled_for", "log", "name"}
    | {"set_level", "warn", "warning"}
)
_OF_OTHERS = {
    "critical": "fatal",
    "err": "error",
    "warm": "warning",
    "exception": "error",
    **dict.fromkeys(("Debug", "logdebug", "dbg"), "debug"),
    **dict.fromkeys(("Info", "loginfo", "INFO", "print", "information"), "info"),
    **dict.fromkeys(("Warn", "logwarn", "WARN", "warnning", "warnings"), "warning"),
    **dict.fromkeys(("Error", "logerr", "ERROR", "errors"), "error"),
}
"""What loggers elsewhere have, and people write, for the levels of this one."""
_OPTIONS = {"throttle": "throttle_duration_sec=…", "once": "once=True", "skip_first": "skip_first=True"}
"""What the macros of C++ have in their names, ``RCLCPP_WARN_THROTTLE``, and rclpy takes as an argument."""


def absent_of_loggers(workspace: WorkspaceIndex) -> Iterator[AbsentOfLogger]:
    """What code calls loggers for that they do not have; nothing where the workspace has loggers of its own."""
    if has_own_loggers(workspace):
        return
    for path in workspace.python_files(mentioning="get_logger"):
        for name, span in _absent(workspace, path) or ():
            level, _, how = name.partition("_")
            if how in _OPTIONS and level in LEVELS | {"debug"}:
                method = "warning" if level == "warn" else level
                yield AbsentOfLogger(Place(path, *span), name, method, _OPTIONS[how])
                continue
            near = _OF_OTHERS.get(name) or nearest(name, sorted(_OF_LOGGERS - {"warn"})) or ""
            yield AbsentOfLogger(Place(path, *span), name, near)


@kept_for_each_file
def _absent(file_facts: facts.Facts) -> list[tuple[str, facts.Span]]:
    code = Loggers(file_facts)
    calls = [*everything_in(file_facts.body, facts.Call)] if code.uses_rclpy else []
    nodes = _variables_of_nodes(file_facts) if calls else set()
    if not all(_is_of_node(call.func, nodes) for call in calls):
        return []  # other libraries have loggers, too
    rows = []
    for call in calls:
        match call.func:
            case facts.Attribute(attr=name, span=span) if name not in _OF_LOGGERS and not name.startswith("_"):
                if code.is_of_logger(call.func) and not code.is_tried(call):
                    rows.append((name, span))
    return rows


def _variables_of_nodes(code: facts.Facts) -> set[str]:
    """The variables to which a file assigns an object of a class of its own that derives from Node."""
    nodes = {cls.name for cls in classes_of(code) if any(base.value.last_name.endswith("Node") for base in cls.bases)}
    return {
        target.variable
        for assign in everything_in(code.body, facts.Assign)
        if isinstance(assign.value, facts.Call) and assign.value.func.variable in nodes
        for target in assign.targets
        if target.variable
    }


def _is_of_node(function: facts.Expr, nodes: Collection[str]) -> bool:
    """Whether a function, if it is a ``get_logger()``, is that of a node or of rclpy; ``nodes`` are
    variables of nodes."""
    match function:
        case facts.Attribute(value=owner, attr="get_logger"):
            name = owner.last_name.lower()
            return owner.dotted in {"self", "rclpy.logging", *nodes} or name.endswith("node")
    return True


@dataclass(frozen=True)
class _Refusal:
    span: facts.Span
    method: str
    misuse: Misuse
    parameters: tuple[str, ...] = ()
    given: str = ""
    instead: str = "message"
    """What to pass."""


@kept_for_each_file
def _refused(file_facts: facts.Facts) -> list[_Refusal]:
    code = Loggers(file_facts)
    calls = everything_in(file_facts.body, facts.Call) if code.uses_rclpy else ()
    refusals = (code.refusal(call) for call in calls if call.func.attribute in LEVELS)
    return [refusal for refusal in refusals if refusal is not None]


@kept_for_each_file
def _given_to_node(file_facts: facts.Facts) -> list[facts.Span]:
    """The calls ``self.get_logger('failed')`` in classes of nodes: the method takes nothing."""
    code = Loggers(file_facts)
    nodes = [
        cls
        for cls in (classes_of(file_facts) if code.uses_rclpy else ())
        if any(base.value.last_name in ("Node", "LifecycleNode") for base in cls.bases)
    ]
    calls = (call for cls in nodes for call in everything_in(cls.body, facts.Call) if not code.is_tried(call))
    return [call.span for call in calls if call.func.dotted == "self.get_logger" and call.args]


class Loggers:
    """What one file says of its names: those of modules, of loggers, and of exceptions in the handlers of these."""

    def __init__(self, file_facts: facts.Facts) -> None:
        body = file_facts.body
        imports = [*everything_in(body, facts.Import)]
        froms = [*everything_in(body, facts.ImportFrom)]
        modules = [*(row.module for row in imports), *(row.module for row in froms)]
        self.uses_rclpy = any(module.partition(".")[0] == "rclpy" for module in modules)
        self._imported = {row.alias or row.module.partition(".")[0] for row in imports}
        self._imported |= {bound for row in froms for _, bound in row.names}
        self._functions = {
            bound for row in froms if row.module == "rclpy.logging" for name, bound in row.names if name == "get_logger"
        }
        self._assigned: dict[str, list[facts.Expr | None]] = {}
        for part in everything_in(body):
            self._note(part)
        self._exceptions = {
            Itself(call): handler.name
            for handler in everything_in(body, facts.Handler)
            for call in parts_of(handler.body, facts.Call)
        }

        self._tried = tried_for(body, _REFUSALS)

    def _note(self, part: facts.Base) -> None:
        """Note what a name or an attribute is given; None where that is not written."""
        match part:
            case facts.Assign(targets=targets, value=value):
                for target in targets:
                    for single in targets_in(target):
                        self._assigned.setdefault(single.last_name, []).append(value if single is target else None)
            case facts.Annotated(target=target, value=value):
                self._assigned.setdefault(target.last_name, []).append(value)
            case facts.Param(name=name) | facts.Handler(name=str(name)):
                self._assigned.setdefault(name, []).append(None)
            case facts.Import() | facts.Function() | facts.Class() | facts.Augmented():
                return
            case facts.ImportFrom(names=names):
                for _, bound in names:
                    self._assigned.setdefault(bound, []).append(None)
            case _:
                for other in (other for target in part.assigned for other in targets_in(target)):
                    self._assigned.setdefault(other.last_name, []).append(None)

    def is_tried(self, call: facts.Call) -> bool:
        return Itself[facts.Base](call) in self._tried

    def refusal(self, call: facts.Call) -> _Refusal | None:
        starred = any(argument.star for argument in call.args)
        if starred or self.is_tried(call) or not self.is_of_logger(call.func):
            return None
        given = [argument.value for argument in call.args if argument.keyword is None]
        keywords = [argument.keyword for argument in call.args if argument.keyword is not None]
        unknown = tuple(keyword for keyword in keywords if keyword not in _KEYWORDS)
        refusal = partial(_Refusal, call.span, call.func.attribute)
        if len(given) > 1:
            return refusal(Misuse.TOO_MANY, given=given[0].dotted)
        if unknown:
            return refusal(Misuse.UNKNOWN_KEYWORD, unknown)
        if not given:
            return None if "message" in keywords else refusal(Misuse.MISSING, ("message",))
        kind, instead = self._kind(call, given[0]), f"str({given[0].variable or '…'})"
        return refusal(Misuse.KIND, ("message",), kind, instead) if kind else None

    def is_of_logger(self, function: facts.Expr) -> bool:
        """Whether what is called is certainly a method of a logger of ROS."""
        match function:
            case facts.Attribute(value=owner):
                return self._is_logger(owner)
        return False

    def _is_logger(self, value: facts.Expr | None) -> bool:
        """Whether an expression is certainly a logger of ROS: ``self.get_logger()``, or what is only given such."""
        match value:
            case facts.Call(func=facts.Name(id=name)):
                return name in self._functions
            case facts.Call(func=facts.Attribute(value=owner, attr="get_logger"), args=given):
                return owner.dotted == "rclpy.logging" or (not given and owner.dotted not in self._imported)
            case facts.Name(id=name) | facts.Attribute(attr=name):
                rows = self._assigned.get(name, [])
                return bool(rows) and all(_is_call(row) and self._is_logger(row) for row in rows)
        return False

    def _kind(self, call: facts.Call, value: facts.Expr) -> str:
        """What is logged and is no text, in words; empty where it may be one."""
        match value:
            case facts.Name(id=name) if name == self._exceptions.get(Itself(call)):
                return "an exception" if self._assigned[name] == [None] * len(self._assigned[name]) else ""
            case facts.Literal(value=bool() as constant):
                return str(constant)
            case facts.Literal(value=int() | float() as number):
                return f"the number {number}"
            case facts.Sequence(kind=kind):
                return f"a {kind}"
            case facts.Mapping():
                return "a dict"
        return ""


def _is_call(value: facts.Expr | None) -> bool:
    match value:
        case facts.Call():
            return True
    return False


__all__ = [
    "GET_LOGGER",
    "LEVELS",
    "LOGGER",
    "AbsentOfLogger",
    "Loggers",
    "absent_of_loggers",
    "has_own_loggers",
    "refused_logger_calls",
]
