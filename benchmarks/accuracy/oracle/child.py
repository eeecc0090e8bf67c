"""One run of the oracle: execute one program, or construct the classes of one module, and write down
what it creates.

Started as `python -m benchmarks.accuracy.oracle.child JOB.json` in a folder of its own.
"""

from __future__ import annotations

import importlib
import inspect
import json
import os
import pkgutil
import random
import re
import sys
import traceback
import types
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from . import finder, interfaces, real, resume, sandbox, unknown
from .record import recorder
from .sandbox import TimeUp, limited
from .unknown import Unknown, make, unpacked_by

_REAL_EXIT = os._exit
_STANDINS = Path(__file__).parent / "standins"
_SECONDS_FOR_MAIN = 5.0
_SECONDS_FOR_LATER = 4.0
_SECONDS_FOR_ONE = 1.0
_MOST_TASKS = 300


def main() -> None:
    """Run the job that the command line names."""
    execute(Path(sys.argv[1]))


def execute(path: Path) -> None:
    """Run one job, and end the process."""
    job = json.loads(path.read_text(encoding="utf-8"))
    out = Path(job["out"]).open("a", encoding="utf-8")  # noqa: SIM115 - open until the process ends
    recorder.open(job["root"], out)
    load_standins(real_rclpy=bool(job.get("real")))
    sys.modules["ament_index_python.packages"].folders.update(job["packages"])
    interfaces.register_sources(job["interfaces"])
    if job["kind"] == "setup":
        importlib.import_module("setuptools")  # as long as its bytecode is read
    _prepare(job)
    runs: dict[str, Callable[[dict[str, Any]], None]] = {
        "setup": _run_setup,
        "entry": _run_entry,
        "script": _run_script,
        "classes": _run_classes,
        "forced": _run_forced,
    }
    try:
        runs[job["kind"]](job)
    except BaseException:
        recorder.write("failed", step="oracle", reason=traceback.format_exc()[-600:], where=None)
    finally:
        out.flush()
        _REAL_EXIT(0)


def load_standins(*, real_rclpy: bool) -> None:
    """Import each stand-in that is not yet there, while this project is on the path, and make unknown what it lacks."""
    sys.path.insert(0, str(_STANDINS))
    if real_rclpy:  # it has imported the real ones
        for name in [each for each in sys.modules if each.partition(".")[0] in real.WITHOUT_WHEEL]:
            del sys.modules[name]
    for module in pkgutil.walk_packages([str(_STANDINS)]):
        if real_rclpy and module.name.partition(".")[0] not in real.WITHOUT_WHEEL:
            continue
        loaded = importlib.import_module(module.name)
        loaded.__getattr__ = _fallback(module.name)  # type: ignore[method-assign]
    sys.path.remove(str(_STANDINS))


def _fallback(module: str) -> Callable[[str], Any]:
    def missing(name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        if f"{module}.{name}" in sys.modules:
            return sys.modules[f"{module}.{name}"]
        return make(f"{module}.{name}")

    return missing


def _prepare(job: dict[str, Any]) -> None:
    here = Path(__file__).resolve().parents[3]
    own = [entry for entry in sys.path if entry and Path(entry).resolve() != here]
    sys.path[:] = [*job["path_first"], *own, *job["path_last"]]
    sys.dont_write_bytecode = True
    random.seed(0)
    sys.pycache_prefix = str(Path.cwd() / "pycache")
    sys.argv = [job.get("file", "program")]
    sys.modules.pop("benchmarks", None)
    finder.install()
    if job.get("resume"):
        resume.install()
    sandbox.patience = job.get("patience", 1.0)
    unknown.other_way = bool(job.get("other_way"))
    real.lenient = bool(job.get("resume")) or job["kind"] in ("classes", "forced")
    if job["kind"] != "setup":
        sandbox.close(Path.cwd())
    sys.stdout = sys.stderr = Path(os.devnull).open("w", encoding="utf-8")  # noqa: SIM115


# Programs ---------------------------------------------------------------------------------------
def _run_setup(job: dict[str, Any]) -> None:
    """Execute a setup.py and note the entry points that it declares."""
    import setuptools

    def setup(**settings: Any) -> None:
        points = settings.get("entry_points") or {}
        scripts = points.get("console_scripts", []) if isinstance(points, dict) else []
        recorder.write("setup", scripts=[str(each) for each in scripts], package=str(settings.get("name")))

    setuptools.setup = setup
    os.chdir(Path(job["file"]).parent)
    sandbox.close(Path(job["scratch"]))
    _guarded(
        "setup",
        lambda: exec(
            compile(Path(job["file"]).read_bytes(), job["file"], "exec"),
            {"__name__": "__main__", "__file__": job["file"]},
        ),
    )


def _run_entry(job: dict[str, Any]) -> None:
    def program() -> None:
        function: Any = importlib.import_module(job["module"])
        for part in job["function"].split("."):
            function = getattr(function, part)
        _finish(_call(function))

    _guarded("main", program)
    _run_later()


def _run_script(job: dict[str, Any]) -> None:
    module = types.ModuleType("__main__")
    module.__file__ = job["file"]
    module.__dict__["__builtins__"] = __builtins__
    sys.modules["__main__"] = module

    def program() -> None:
        source = Path(job["file"]).read_bytes()
        code = (
            resume.rewritten(source, job["file"])
            if job.get("resume")
            else compile(source, job["file"], "exec", dont_inherit=True)
        )
        exec(code, module.__dict__)

    _guarded("main", program)
    _run_later()


def _guarded(step: str, program: Callable[[], Any], seconds: float = _SECONDS_FOR_MAIN, **about: Any) -> bool:
    """Run a step; write whether it came to its end, or what stopped it."""
    try:
        with limited(seconds):
            program()
    except SystemExit as leaving:
        if leaving.code in (None, 0) and _left_from_main(leaving):
            recorder.write("ran", step=step, **about)
            return True
        recorder.write("failed", step=step, reason=f"SystemExit: {leaving.code}"[:300], where=_where(leaving), **about)
    except BaseException as error:
        recorder.write(
            "failed", step=step, reason=f"{type(error).__name__}: {error}"[:300], where=_where(error), **about
        )
    else:
        recorder.write("ran", step=step, **about)
        return True
    return False


def _where(error: BaseException) -> str | None:
    """The user's innermost line in a traceback."""
    own = [frame for frame in traceback.extract_tb(error.__traceback__) if frame.filename.startswith(recorder.root)]
    return f"{own[-1].filename[len(recorder.root) :]}:{own[-1].lineno}" if own else None


def _left_from_main(error: BaseException) -> bool:
    """Whether the program left where programs end: at module level, or in a function called main."""
    own = [frame for frame in traceback.extract_tb(error.__traceback__) if frame.filename.startswith(recorder.root)]
    return not own or own[-1].name in ("<module>", "main")


def _finish(result: Any) -> Any:
    """Run a coroutine to its end, as an executor would."""
    if inspect.iscoroutine(result):
        try:
            while True:
                result.send(None)
        except StopIteration as end:
            return end.value
    return result


# What happens after the program -----------------------------------------------------------------
def _run_later() -> None:
    """Run threads, transitions, callbacks and tasks once each, within a common time limit."""
    before = recorder.phase
    recorder.phase = "later" if before == "main" else before
    seen: set[int] = set()
    try:
        with limited(_SECONDS_FOR_LATER):
            for count, (function, arguments) in enumerate(_later(seen)):
                if count > _MOST_TASKS:
                    break
                _quietly(function, arguments)
    except TimeUp:
        recorder.write("cut", step="later")
    recorder.phase = before


def _later(seen: set[int]) -> Iterator[tuple[Any, tuple[Any, ...]]]:
    """What is left to run; new nodes, endpoints and tasks join while it runs."""
    while True:
        waiting: list[tuple[Any, Any]] = []
        for node in list(recorder.nodes):
            if id(node) not in seen:
                seen.add(id(node))
                waiting.extend((each, (_state(),)) for each in getattr(node, "_oracle_transitions", list)())
        waiting.extend(recorder.tasks)
        recorder.tasks.clear()
        for node in recorder.nodes:
            for callback, arguments in node._oracle_callbacks():
                key = hash((id(node), getattr(callback, "__func__", callback)))
                if key not in seen:
                    seen.add(key)
                    waiting.append((callback, arguments))
        if not waiting:
            return
        yield from waiting


def _state() -> Any:
    return sys.modules["rclpy.lifecycle"].LifecycleState("unconfigured", 1)


def _quietly(function: Any, arguments: Any) -> None:
    try:
        with limited(_SECONDS_FOR_ONE):
            if len(arguments) == 2 and isinstance(arguments[1], dict):
                _finish(function(*arguments[0], **arguments[1]))
            else:
                _finish(function(*arguments))
    except TimeUp as late:
        recorder.write("cut", step=getattr(function, "__qualname__", "?"), where=_where(late))
    except BaseException as error:
        recorder.write(
            "broke",
            step=getattr(function, "__qualname__", "?"),
            reason=f"{type(error).__name__}: {error}"[:200],
            where=_where(error),
        )


# Classes ----------------------------------------------------------------------------------------
def _run_classes(job: dict[str, Any]) -> None:
    """Construct each node class of a module that no program constructed, each in a process of its own."""
    recorder.phase = "class"
    module = _import(job)
    if module is None:
        return
    done = set(job["done"])
    for cls in _classes_of(module):
        place = f"{job['relative']}:{cls.__qualname__}"
        if place in done or not issubclass(cls, _node_class()):
            continue
        _in_fork(lambda cls=cls, place=place: _construct_and_go_on(cls, place))


def _construct_and_go_on(cls: type, place: str) -> None:
    _guarded("construct", lambda: _call(cls), _SECONDS_FOR_MAIN, target=place)
    _run_later()


def _import(job: dict[str, Any]) -> types.ModuleType | None:
    found: list[types.ModuleType] = []
    ok = _guarded("import", lambda: found.append(importlib.import_module(job["module"])), target=job["relative"])
    return found[0] if ok else sys.modules.get(job["module"])


def _classes_of(module: types.ModuleType) -> list[type]:
    own = [value for value in vars(module).values() if isinstance(value, type) and value.__module__ == module.__name__]
    return list(dict.fromkeys(own))


def _node_class() -> type:
    cls: type = sys.modules["rclpy.node"].Node
    return cls


def _in_fork(action: Callable[[], None]) -> None:
    child = os.fork()
    if child == 0:
        try:
            action()
        finally:
            _REAL_EXIT(0)
    os.waitpid(child, 0)


def _call(function: Any) -> Any:
    """Call with an unknown value, or a node, for each parameter that must be given."""
    try:
        parameters = list(inspect.signature(function).parameters.values())
    except (TypeError, ValueError):
        return function()
    positional: list[Any] = []
    named: dict[str, Any] = {}
    for parameter in parameters:
        if parameter.kind is parameter.VAR_KEYWORD and _takes_node_from_keywords(function):
            named["node"] = _node_class()(Unknown("argument node"))
        if parameter.kind in (parameter.VAR_POSITIONAL, parameter.VAR_KEYWORD):
            continue
        if parameter.default is not parameter.empty and not _wants_node(parameter):
            continue
        value = _argument(parameter)
        if parameter.kind is parameter.KEYWORD_ONLY:
            named[parameter.name] = value
        elif len(positional) == parameters.index(parameter):
            positional.append(value)
        else:
            named[parameter.name] = value
    return function(*positional, **named)


_node_words = (
    "node",
    "parent_node",
    "ros_node",
    "ros2_node",
    "parent",
    "nh",
    "node_handle",
    "rclpy_node",
    "_node",
)


def _wants_node(parameter: inspect.Parameter) -> bool:
    """Whether a parameter is for a node, by its annotation or its name; a default of None may be replaced."""
    if parameter.default is not parameter.empty and parameter.default is not None:
        return False
    annotation = parameter.annotation
    word = annotation if isinstance(annotation, str) else getattr(annotation, "__name__", "") or str(annotation)
    is_node = isinstance(annotation, type) and issubclass(annotation, _node_class())
    named = re.fullmatch(r"(?:Optional\[)?(?:\w+\.)*\w*Node\]?(?: \| None)?", word.replace("typing.", ""))
    return is_node or parameter.name in _node_words or named is not None


def _argument(parameter: inspect.Parameter) -> Any:
    if _wants_node(parameter):
        return _node_class()(Unknown(f"argument {parameter.name}"))
    return _Holder(f"argument {parameter.name}")


def _takes_node_from_keywords(function: Any) -> bool:
    """Whether a function with `**kwargs` looks for one that is called node."""
    code = getattr(inspect.unwrap(getattr(function, "__func__", function)), "__code__", None)
    return code is not None and "node" in code.co_consts


class _Holder(Unknown):
    """An argument that nobody gave.

    What it calls its node is one, as with a plugin's context; as a collection it holds one thing, so that
    what is done for each of its members is done once.
    """

    def __getattr__(self, name: str) -> Any:
        known = object.__getattribute__(self, "_known")
        if name not in known and not name.startswith("__"):
            path = f"{self._path}.{name}"
            is_node = name in ("node", "_node", "ros_node")
            known[name] = _node_class()(Unknown(path)) if is_node else _Holder(path)
        return super().__getattr__(name)

    def __call__(self, *args: Any, **kwargs: Any) -> Any:
        result = super().__call__(*args, **kwargs)
        return _Holder(result._path) if type(result) is Unknown else result

    def __getitem__(self, item: Any) -> Any:
        return _Holder(f"{self._path}[]")

    def __iter__(self) -> Iterator[Any]:
        count = unpacked_by(sys._getframe(1))
        return iter([_Holder(f"{self._path}[{index}]") for index in range(1 if count is None else count)])


# Code that nothing reached ----------------------------------------------------------------------
def _run_forced(job: dict[str, Any]) -> None:
    """Call the functions and methods that hold create calls which no other run came to."""
    recorder.phase = "forced"
    module = _import(job)
    if module is None:
        return
    for qualname in job["functions"]:
        _in_fork(lambda qualname=qualname: _force(module, qualname, job["relative"]))


def _force(module: types.ModuleType, qualname: str, relative: str) -> None:
    def go() -> None:
        owner: Any = module
        *classes, last = qualname.split(".")
        for part in classes:
            owner = getattr(owner, part)
        if classes and isinstance(owner, type):
            kind = inspect.getattr_static(owner, last, None)
            if last == "__init__":
                _call(owner)
                return
            instance = owner if isinstance(kind, (staticmethod, classmethod)) else _call(owner)
            target = getattr(instance, last)
            _finish(_call(target) if callable(target) else target)
        else:
            _finish(_call(getattr(owner, last)))

    _guarded("forced", go, _SECONDS_FOR_MAIN, target=f"{relative}:{qualname}")
    _run_later()


if __name__ == "__main__":
    main()
