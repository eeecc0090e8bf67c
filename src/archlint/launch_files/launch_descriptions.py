"""What the code of a launch file gives launch that is no launch description, no list, or never gets there.

Source: ``LaunchDescription``, ``get_launch_description_from_python_launch_file`` of launch, ``Node``,
``normalize_parameters`` and ``normalize_remap_rule`` of launch_ros.
"""

from __future__ import annotations

import posixpath
import re
from collections import Counter
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.launch.files import GENERATE
from archlint.launch_files.launch_code import listed_in, names_from_launch
from archlint.launch_files.opaque_functions import wrong_functions
from archlint.launch_files.overwritten_actions import overwritten_actions
from archlint.launch_files.unread_arguments import first_text, may_be_read
from archlint.launch_files.wrong_launch_descriptions import Wrong, WrongDescription
from archlint.syntax import facts
from archlint.syntax.parts import everything_in, parts_of
from archlint.syntax.walk import is_none

if TYPE_CHECKING:
    from archlint.launch.model import Launched
    from archlint.systems.model import System, WorkspaceIndex


def wrong_descriptions(system: System) -> Iterator[tuple[str, WrongDescription]]:
    """Every such place in the launch files in Python of a launched system, with its file."""
    workspace, launched = system.workspace, system.launched
    if launched is None or workspace is None:
        return
    for file in launched.sources:
        rows = (_of_file(workspace, file) if file.endswith(".py") else None) or []
        if any(wrong.kind == Wrong.NOTHING for wrong in rows):
            if _is_sample(workspace, file):
                continue
            # Whoever makes a launch description of it adds the actions.
            rows = [wrong for wrong in rows if wrong.kind != Wrong.NOT_ADDED]
        aside = {wrong.of for wrong in rows if _is_put_aside(workspace, file, wrong)}
        for wrong in rows:
            left = wrong.kind == Wrong.NOT_ADDED and (
                wrong.of in aside or _is_idle(workspace, launched, wrong) or _is_another_choice(launched, wrong)
            )
            if not left:
                yield file, wrong


_SAMPLE = re.compile(r"your_\w+|<[\w -]+>")
"""Names that stand for those of whoever takes a file over."""


def _is_sample(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether a launch file in no package starts a program of a package that has yet to be named: it is to be copied,
    not launched."""
    code = workspace.facts_at(file)
    if code is None or workspace.package_of(file) is not None:
        return False
    arguments = (a for call in everything_in(code.body, facts.Call) for a in call.args if a.keyword == "package")
    return any(_SAMPLE.fullmatch(argument.value.text or "") for argument in arguments)


def misnamed_functions(workspace: WorkspaceIndex) -> Iterator[tuple[str, WrongDescription]]:
    """Launch files by their names in which one function makes a launch description, under another name than launch asks
    for, and nothing else calls it."""
    for file, _ in workspace.code.asked_for():
        path = file.relative
        named = file.kind == "launch_python" and path.endswith("launch.py") and not workspace.roles.is_test(path)
        wrong = _misnamed(workspace, path) if named and not workspace.launch_files.can_be_launched(path) else None
        if wrong is not None and not _is_mentioned(workspace, path, wrong.given):
            yield path, wrong


def _is_mentioned(workspace: WorkspaceIndex, path: str, name: str) -> bool:
    """Whether another file names both a launch file and a function: it may call that one."""
    files = {*workspace.code.files_that_mention(name), *(file.relative for file, _ in workspace.code.asked_for())}
    own = posixpath.basename(path).removesuffix(".py")
    others = (other for other in sorted(files - {path}) if workspace.code.mentions(other, name))
    return any(own in (workspace.tree.text(other) or "") for other in others)


@kept_for_each_file
def _misnamed(file_facts: facts.Facts) -> WrongDescription | None:
    code = _Code(file_facts.body)
    if any(GENERATE in _words(part) for part in everything_in(file_facts.body)):
        return None
    functions = [function for function in _functions(file_facts.body) if code.describes(function)]
    names = Counter(name.id for name in everything_in(file_facts.body, facts.Name))
    match functions:
        case [facts.Function(name=name, decorators=[], is_generator=False) as function] if not names[name]:
            return WrongDescription(Wrong.MISNAMED, function.name_span, name)
    return None


def _words(part: facts.Base) -> tuple[str, ...]:
    """The names by which a file may have a function that it does not define, and the texts in it."""
    match part:
        case facts.ImportFrom(names=names):
            return tuple(GENERATE if bound == "*" else bound for _, bound in names)
        case facts.Literal(value=str(text)):
            return (text,)
    return (part.last_name, GENERATE if part.last_name == "globals" else "")


def _functions(body: Sequence[facts.Stmt]) -> Iterator[facts.Function]:
    """The functions of a module that can be called without an argument."""
    for statement in body:
        match statement:
            case facts.Function() if not _wanted(statement):
                yield statement


def _wanted(function: facts.Function) -> list[str]:
    """The parameters that a call has to give."""
    return [p.name for p in function.params if p.default is None and p.kind not in ("star", "double_star")]


def _is_idle(workspace: WorkspaceIndex, launched: Launched, wrong: WrongDescription) -> bool:
    """Whether a declaration is of an argument that nothing would read if it were added."""
    return (
        bool(wrong.argument)
        and wrong.argument not in launched.read
        and not may_be_read(workspace, launched, wrong.argument)
    )


_LOCALISATION = frozenset({"amcl"})
_MAPPING = frozenset({"async_slam_toolbox_node", "cartographer_node", "localization_slam_toolbox_node"}) | {
    "sync_slam_toolbox_node"
}
_CHOICES = (
    (re.compile(r"slam|cartographer|mapping"), _LOCALISATION),
    (re.compile(r"amcl|locali[sz]ation|map_server"), _MAPPING),
    (re.compile(r"joint_state_publisher(?!_?gui)"), frozenset({"joint_state_publisher_gui"})),
    (re.compile(r"joint_state_publisher_?gui"), frozenset({"joint_state_publisher"})),
)
"""Names of what one of some programs takes the place of: where that runs, somebody has chosen it."""


def _is_another_choice(launched: Launched, wrong: WrongDescription) -> bool:
    """Whether an action that nothing adds is for what the launch file has another program for, as AMCL with a map takes
    the place of SLAM: both would send the same transform."""
    name = wrong.given.lower()
    instead = [programs for word, programs in _CHOICES if word.search(name)]
    return any(started.executable.text in programs for programs in instead for started in launched.started)


def _is_put_aside(workspace: WorkspaceIndex, file: str, wrong: WrongDescription) -> bool:
    """Whether a comment of a file names an action that nothing adds, or a string that stands there as one: somebody has
    taken it out of the list, or offers it there.  Others of its kind are left out with it."""
    if wrong.kind != Wrong.NOT_ADDED:
        return False
    first = re.escape(wrong.given.partition("_")[0])
    word = re.compile(
        rf"(?<!\w){re.escape(wrong.given)}(?!\w)|\badd_action\(\s*{first}_\w+\)", re.IGNORECASE
    )  # gps_cmd may have been gps_node where its line was taken out
    text = workspace.tree.text(file) or ""
    comments = [line[line.find("#") :] for line in text.split("\n") if "#" in line]
    return any(word.search(comment) for comment in (*comments, *(block[2] for block in _TEXT_BLOCK.finditer(text))))


_TEXT_BLOCK = re.compile(r"^[ \t]*(\"{3}|'{3})(.*?)\1", re.DOTALL | re.MULTILINE)


ACTIONS = frozenset(
    {"Node", "LifecycleNode", "ComposableNodeContainer", "LoadComposableNodes", "ExecuteProcess", "TimerAction"}
    | {"IncludeLaunchDescription", "GroupAction", "OpaqueFunction", "RegisterEventHandler", "LogInfo"}
    | {"DeclareLaunchArgument", "SetEnvironmentVariable", "SetParameter", "PushRosNamespace"}
)
_STARTS = ACTIONS - {"DeclareLaunchArgument", "LogInfo", "SetEnvironmentVariable", "SetParameter", "PushRosNamespace"}
"""The actions whose absence leaves something out."""
_SETS = frozenset(
    {
        "AppendEnvironmentVariable",
        "PushRosNamespace",
        "SetEnvironmentVariable",
        "SetLaunchConfiguration",
        "SetParameter",
    }
    | {"SetParametersFromFile", "SetRemap", "SetUseSimTime", "UnsetEnvironmentVariable", "UnsetLaunchConfiguration"}
)
"""The actions that say something of those behind them."""
_DECLARATION = "DeclareLaunchArgument"
_ADDED = _STARTS | _SETS | {_DECLARATION}
_NODES = frozenset({"Node", "LifecycleNode", "ComposableNodeContainer"})


@kept_for_each_file
def _of_file(file_facts: facts.Facts) -> list[WrongDescription]:
    code = _Code(file_facts.body)
    return sorted(code.wrong(), key=lambda wrong: wrong.span) if code.classes else []


class _Code:
    def __init__(self, body: Sequence[facts.Stmt]) -> None:
        self.body = body
        self.classes = names_from_launch(body)

    def made(self, e: facts.Expr) -> str:
        """The class of launch that a call makes an object of."""
        match e:
            case facts.Call(func=facts.Name(id=name)):
                return self.classes.get(name, "")
        return ""

    def wrong(self) -> Iterator[WrongDescription]:
        functions = [part for part in self.body if isinstance(part, facts.Function) and part.name == GENERATE]
        for function in functions[-1:]:  # an earlier one of the name is gone once the file has been read
            if not function.decorators and not function.is_generator:
                yield from self._returned(function)
                for parameter in _wanted(function)[:1]:
                    yield WrongDescription(Wrong.PARAMETER, function.name_span, parameter)
        for call in everything_in(self.body, facts.Call):
            kind = self.made(call)
            if kind in _NODES:
                package = next((a.value.text for a in call.args if a.keyword == "package"), None) or ""
                for a in call.args:
                    if a.keyword:
                        yield from _argument_of_node(kind, a.keyword, a.value, package)
            elif kind == "LaunchDescription" and call.args and not call.args[0].star:
                yield from self._entities(call.args[0].value)
            match call.func:
                case facts.Call(span=span) as called if self.made(called) in ACTIONS:
                    yield WrongDescription(Wrong.COMMA, span, self.made(called))
        yield from self._not_added()
        for function in everything_in(self.body, facts.Function):
            yield from overwritten_actions(function.body, self.made, _ADDED)
        yield from wrong_functions(self.body, self.made)

    def describes(self, function: facts.Function) -> bool:
        """Whether a function returns a launch description that it makes."""
        variables = {
            target.variable
            for assign in parts_of(function, facts.Assign)
            for target in assign.targets
            if self.made(assign.value) == "LaunchDescription"
        }
        values = [r.value for s in function.body if not s.is_scope for r in parts_of(s, facts.Return)]
        return any(
            self.made(value) == "LaunchDescription" or (value.variable and value.variable in variables)
            for value in values
            if value is not None
        )

    def _returned(self, function: facts.Function) -> Iterator[WrongDescription]:
        """What a launch file returns that is no launch description."""
        returns = [r for s in function.body if not s.is_scope for r in parts_of(s, facts.Return)]
        values = [r.value for r in returns if r.value is not None and not is_none(r.value)]
        raises = any(parts_of(function.body, facts.Raise)) or any(parts_of(function.body, facts.Opaque))
        if not values and not raises:
            yield WrongDescription(Wrong.NOTHING, function.name_span, "")
        for value in values:
            what = _display(value) or (f"a single {self.made(value)}" if self.made(value) in ACTIONS else "")
            match value:
                case facts.Sequence() | facts.Call() | facts.Mapping() if what:
                    yield WrongDescription(Wrong.LIST, value.span, what)

    def _entities(self, value: facts.Expr) -> Iterator[WrongDescription]:
        match value:
            case facts.Call() if self.made(value) in ACTIONS:
                yield WrongDescription(
                    Wrong.NO_LIST, value.span, f"a single {self.made(value)}", "LaunchDescription()", "a list"
                )
            case facts.Sequence(elements=elements):
                for element in elements:
                    what = _display(element)
                    match element:
                        case facts.Sequence() | facts.Mapping() | facts.Literal() if what:
                            of = "the list of LaunchDescription()"
                            yield WrongDescription(Wrong.IN_LIST, element.span, what, of, "actions")
                        case facts.Name(id=name, span=span) if action := self._action_in_tuple(name):
                            yield WrongDescription(Wrong.TUPLE, span, name, action)

    def _action_in_tuple(self, name: str) -> str:
        """The class of the action that is all there is in a tuple, where a variable is that and nothing else."""
        values = [
            assign.value
            for assign in everything_in(self.body, facts.Assign)
            if any(target.variable == name for target in assign.targets)
        ]
        match values:
            case [facts.Sequence(kind="tuple", elements=[facts.Call() as only])]:
                return self.made(only) if self.made(only) in ACTIONS else ""
        return ""

    def _not_added(self) -> Iterator[WrongDescription]:
        """The actions that a function assigns to a variable which nothing reads."""
        names = Counter(name.id for name in everything_in(self.body, facts.Name))
        if any(names[maker] for maker in ("locals", "globals", "vars", "eval", "exec")):
            return
        for function in everything_in(self.body, facts.Function):
            rows = [a for a in parts_of(function, facts.Assign) if self.made(a.value) in _ADDED]
            rows = [] if self._has_switches(function) else rows
            for assign in rows:
                match assign.targets:
                    case [facts.Name(id=name, span=span)] if names[name] == 1 and not name.startswith("_"):
                        declared = _declared(assign.value) if self.made(assign.value) == _DECLARATION else ""
                        twice = min(self._described(function) & listed_in(assign.value), default="")
                        action = self.made(assign.value)
                        yield WrongDescription(Wrong.NOT_ADDED, span, name, action, wanted=twice, argument=declared)

    def _described(self, function: facts.Function) -> set[str]:
        """The variables in the list of a launch description that a function makes."""
        calls = (call for call in parts_of(function, facts.Call) if self.made(call) == "LaunchDescription")
        return {name for call in calls for given in call.args for name in listed_in(given.value)}

    def _has_switches(self, function: facts.Function) -> bool:
        """Whether a function adds actions where variables say so that somebody sets by hand: ``if with_camera:``.  What
        such a board does not add at all is left out like the rest."""
        constants = (assign for assign in everything_in(self.body, facts.Assign) if _is_switch(assign.value))
        set_by_hand = {target.variable for assign in constants for target in assign.targets} - {None}
        choices = (choice for choice in parts_of(function, facts.If) if choice.test.variable in set_by_hand)
        return sum(any(map(_adds, everything_in(choice.body, facts.Call))) for choice in choices) >= _SWITCHES


_SWITCHES = 2
"""With as many switches a launch file is a board of them."""


def _is_switch(value: facts.Expr) -> bool:
    return isinstance(value, facts.Literal) and isinstance(value.value, bool)


def _adds(call: facts.Call) -> bool:
    return call.func.last_name in ("add_action", "append", "extend")


def _declared(call: facts.Expr) -> str:
    """The argument that a declaration declares; empty where its name is not written there."""
    return next(iter(first_text(call)), "") if isinstance(call, facts.Call) else ""


def _display(value: facts.Expr) -> str:
    """What a display of a list, set or dict, or a constant, is called."""
    match value:
        case facts.Sequence(kind=kind):
            return f"a {kind}"
        case facts.Mapping():
            return "a dict"
        case facts.Literal(value=None):
            return "None"
        case facts.Literal(value=str()):
            return "a string"
    return ""


def _may_be_a_path(items: Sequence[facts.Expr]) -> bool:
    """Whether launch_ros takes a set as a parameter file: it joins the texts and substitutions of any iterable to one
    path.  Those of a set of several come in any order."""
    match items:
        case [facts.Literal(value=value)]:
            return isinstance(value, str)
        case [facts.Sequence() | facts.Mapping()]:
            return False
    return len(items) == 1 or any(isinstance(item, facts.Starred) for item in items)


def _instead_of_set(items: Sequence[facts.Expr]) -> str:
    """What is meant: files where one of the items is the name of one, otherwise a parameter and its value."""
    texts = (item.value for item in items if isinstance(item, facts.Literal) and isinstance(item.value, str))
    return "each file by itself" if any(text.endswith((".yaml", ".yml")) for text in texts) else "{'name': value}"


def _argument_of_node(class_name: str, keyword: str, value: facts.Expr, package: str) -> Iterator[WrongDescription]:
    """What a node is given as a list of parameters, remappings or arguments that is none."""
    what, of = _display(value), f"{keyword}= of {class_name}"
    match keyword, value:
        case "parameters", facts.Sequence(kind="list", elements=elements):
            for element in elements:
                match element:
                    case facts.Sequence(kind="set", elements=items) if not _may_be_a_path(items):
                        yield WrongDescription(Wrong.IN_LIST, element.span, "a set", of, _instead_of_set(items))
        case "parameters", facts.Sequence() | facts.Mapping() | facts.Literal(value=str()):
            yield WrongDescription(Wrong.NO_LIST, value.span, what, of, "a list")
        case "remappings", facts.Sequence(elements=elements):
            for element in elements:
                match element:
                    case facts.Sequence(kind="list" | "set") | facts.Mapping() | facts.Literal(value=str()):
                        yield WrongDescription(Wrong.IN_LIST, element.span, _display(element), of, "('from', 'to')")
                        return
        case "remappings", facts.Mapping() | facts.Literal(value=str()):
            yield WrongDescription(Wrong.NO_LIST, value.span, what, of, "a list")
        case "arguments" | "ros_arguments", facts.Literal(value=str()):
            yield WrongDescription(Wrong.NO_LIST, value.span, what, of, "a list")
        case "arguments", facts.Sequence(elements=elements):
            dicts = (element for element in elements if isinstance(element, facts.Mapping))
            wanted = "texts alone" if package.startswith(_WITHOUT_PARAMETERS) else "a text"
            yield from (WrongDescription(Wrong.IN_LIST, each.span, "a dict", of, wanted) for each in dicts)


_WITHOUT_PARAMETERS = ("rqt", "rviz")
"""How the packages of programs begin that take nothing but their command line: they declare no parameters."""


__all__ = ["ACTIONS", "misnamed_functions", "wrong_descriptions"]
