"""Imports that cannot be satisfied give stand-ins: interface modules, or modules whose every attribute
is unknown."""

from __future__ import annotations

import importlib.abc
import importlib.machinery
import re
import sys
import types
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from .interfaces import KINDS, InterfaceModule
from .record import recorder
from .unknown import make

# Not to be had in a ROS 2 workspace under Python 3: code asks for them to learn where it runs.
_ABSENT = frozenset(
    {
    "rospy", "roslib", "rosnode", "rostopic", "rosservice", "rosmaster", "roscpp", "actionlib",
    "dynamic_reconfigure", "roslaunch", "rosmsg", "rosbag", "StringIO", "cStringIO", "Queue",
    "ConfigParser", "urllib2", "urlparse", "Tkinter", "tkMessageBox", "cPickle", "__builtin__",
    "commands", "thread", "httplib", "exceptions", "sitecustomize", "usercustomize", "org",
    "readline_fake",
    }
)  # fmt: skip
_HERE = str(Path(__file__).parent)
_INTERFACE = re.compile(rf"^(?P<package>\w+)\.(?P<kind>{'|'.join(KINDS)})(\._\w+)?$")


class UnknownModule(types.ModuleType):
    """A module that is not installed here; each attribute is made when it is asked for."""

    def __init__(self, name: str) -> None:
        super().__init__(name)
        self.__path__: list[str] = []

    def __getattr__(self, name: str) -> Any:
        if name in KINDS and "." not in self.__name__:
            return importlib.import_module(f"{self.__name__}.{name}")
        if name.startswith("__") and name.endswith("__"):
            if name == "__version__":
                return "999.999.999"
            if name == "__all__":
                return []
            raise AttributeError(name)
        value = make(f"{self.__name__}.{name}")
        setattr(self, name, value)
        return value


class StandInFinder(importlib.abc.MetaPathFinder, importlib.abc.Loader):
    """The last finder on `sys.meta_path`; `missing` lists the modules it stood in for."""

    def __init__(self) -> None:
        self.missing: list[str] = []

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: types.ModuleType | None = None
    ) -> importlib.machinery.ModuleSpec | None:
        asker = _asked_by_user()
        if fullname.partition(".")[0] in _ABSENT or asker is None:
            return None
        beside = _beside(asker, fullname)
        if beside is not None:
            return beside
        parent = sys.modules.get(fullname.rpartition(".")[0])
        # A real, complete package says itself what it holds; only generated parts may be missing from one.
        if parent is not None and _is_installed(parent) and not _INTERFACE.match(fullname):
            return None
        return importlib.machinery.ModuleSpec(fullname, self, is_package=True)

    def create_module(self, spec: importlib.machinery.ModuleSpec) -> types.ModuleType:
        if found := _INTERFACE.match(spec.name):
            return InterfaceModule(spec.name, found["package"], found["kind"])
        self.missing.append(spec.name)
        return UnknownModule(spec.name)

    def exec_module(self, module: types.ModuleType) -> None:
        return None


def _asked_by_user() -> str | None:
    """The file of the user's import; libraries probe for optional modules and must be told the truth."""
    frame: types.FrameType | None = sys._getframe(2)
    while frame is not None:
        filename = frame.f_code.co_filename
        if "importlib" not in filename:
            return filename if filename.startswith((recorder.root, _HERE)) else None
        frame = frame.f_back
    return None


def _beside(asker: str, name: str) -> importlib.machinery.ModuleSpec | None:
    """A module in the folder of the file that imports it: installed beside it, as scripts are."""
    if "." in name or not asker.startswith(recorder.root):
        return None
    return importlib.machinery.PathFinder.find_spec(name, [str(Path(asker).parent)])


def _is_installed(module: types.ModuleType) -> bool:
    """Whether a module comes from the interpreter's own library or from an installed distribution."""
    origin = getattr(module, "__file__", None) or ""
    return "site-packages" in origin or module.__name__.partition(".")[0] in sys.stdlib_module_names


class _NoAccidentalPackages(importlib.abc.MetaPathFinder):
    """To Python a folder without modules is a package too, as those of an interface package are.

    The folders of a repository are on the path here, those of an installed workspace would not be.
    """

    def __init__(self, standins: StandInFinder) -> None:
        self._standins = standins

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: types.ModuleType | None = None
    ) -> importlib.machinery.ModuleSpec | None:
        interface = _INTERFACE.match(fullname)
        if not interface and "." in fullname:
            return None
        if fullname.partition(".")[0] in sys.stdlib_module_names:
            return None
        spec = importlib.machinery.PathFinder.find_spec(fullname, path)
        if spec is None or spec.origin is not None or not spec.submodule_search_locations:
            return None
        if any(_holds_python(Path(place), interface is not None) for place in spec.submodule_search_locations):
            return None
        return self._standins.find_spec(fullname, None)


def _holds_python(folder: Path, interface: bool) -> bool:
    """Whether a folder can be meant as a Python package: it holds modules, and is no ROS package."""
    if any((folder / name).exists() for name in ("package.xml", "setup.py", "CMakeLists.txt")):
        return False
    return any(folder.glob("*.py")) or (not interface and any(folder.glob("*/*.py")))


class _OldNumpyNames(importlib.abc.MetaPathFinder):
    """numpy gave up its names for Python's own types; nodes that were written before still use them."""

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: types.ModuleType | None = None
    ) -> importlib.machinery.ModuleSpec | None:
        if fullname != "numpy":
            return None
        spec = importlib.machinery.PathFinder.find_spec(fullname, path)
        if spec is not None and spec.loader is not None:
            run = spec.loader.exec_module

            def exec_module(module: types.ModuleType) -> None:
                run(module)
                old = {
                    "int": int,
                    "float": float,
                    "object": object,
                    "str": str,
                    "complex": complex,
                    "bool": bool,
                }
                vars(module).update({name: value for name, value in old.items() if name not in vars(module)})
                for name, value in (
                    ("float_", float),
                    ("Inf", float("inf")),
                    ("NaN", float("nan")),
                    ("infty", float("inf")),
                ):
                    vars(module).setdefault(name, value)

            spec.loader.exec_module = exec_module  # type: ignore[method-assign]
        return spec


def install() -> StandInFinder:
    """Put the finder in place and give it back."""
    finder = StandInFinder()
    sys.meta_path[:0] = [_OldNumpyNames(), _NoAccidentalPackages(finder)]
    sys.meta_path.append(finder)
    return finder
