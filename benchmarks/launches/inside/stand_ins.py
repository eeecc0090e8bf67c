"""What stands in for what is not installed: packages without files, and modules that the wheels do not have."""

from __future__ import annotations

import os
import re
import sys
import types
from pathlib import Path
from typing import Any, ClassVar

from .guard import OUTPUT

absent: set[str] = set()
"""The packages that were asked for and are not in the sandbox."""


class Places:
    """Where packages are: those of the checkout, those of launch itself, and an empty folder for each other one."""

    def __init__(self, install: str, work: str, launch: str, libraries: list[str]) -> None:
        self.install, self.launch, self.libraries = install, launch, libraries
        self.absent = os.path.join(work, "absent")
        roots = "|".join(re.escape(root) for root in (install, self.absent))
        self._share = re.compile(rf"(?:{roots})/([\w.-]+)/share/\1")
        self._prefix = re.compile(rf"(?:{roots})/([\w.-]+)")

    def prefix(self, package: str, *_: object) -> str:
        if package == "launch":
            return os.path.join(self.launch, "launch")
        if not re.fullmatch(r"[\w.-]+", package):
            raise ValueError(f"'{package}' is no package name")
        found = os.path.join(self.install, package)
        for library in self.libraries:
            if not os.path.isdir(found) and os.path.isdir(os.path.join(library, "share", package)):
                return library
        if not os.path.isdir(found):
            absent.add(package)
            found = os.path.join(self.absent, package)
            os.makedirs(os.path.join(found, "share", package), exist_ok=True)
        return found

    def share(self, package: str, *_: object) -> str:
        return os.path.join(self.prefix(package), "share", package)

    def is_absent(self, path: str) -> bool:
        return os.path.normpath(path).startswith(self.absent + "/")

    def shown(self, value: Any) -> Any:
        """A value with the folders of the sandbox put as launch files put them."""
        if isinstance(value, str):
            value = self._share.sub(r"$(find-pkg-share \1)", value)
            return self._prefix.sub(r"$(find-pkg-prefix \1)", value)
        if isinstance(value, (list, tuple)):
            return [self.shown(item) for item in value]
        return value


def packages(places: Places) -> None:
    """ament's index knows the sandbox only."""
    import ament_index_python
    import ament_index_python.packages as index

    for module in (ament_index_python, index):
        module.get_package_prefix = places.prefix
        module.get_package_share_directory = places.share
        module.get_package_share_path = lambda package, *_: Path(places.share(package))  # type: ignore[attr-defined]
    known = ament_index_python.has_resource
    for name in ("ament_index_python", "ament_index_python.resources"):
        # A package that is not in the sandbox is one without files.
        sys.modules[name].has_resource = lambda kind, one: (
            known(kind, one) or (kind == "packages" and places.prefix(one))
        )  # type: ignore[attr-defined]


def modules() -> None:
    """The service that loads components, and xacro, whose output is a command's."""

    class Request:
        def __init__(self) -> None:
            self.package_name = self.plugin_name = self.node_name = self.node_namespace = ""
            self.log_level = 0
            self.remap_rules: list[str] = []
            self.parameters: list[Any] = []
            self.extra_arguments: list[Any] = []

    class LoadNode:
        pass

    LoadNode.Request = Request  # type: ignore[attr-defined]
    _module("composition_interfaces")
    _module("composition_interfaces.srv", LoadNode=LoadNode)

    class Document(str):
        def toxml(self, *_: object, **__: object) -> str:
            return str(self)

        toprettyxml = toxml

        def __getattr__(self, name: str) -> Any:
            return document

    def document(*args: object, **__: object) -> Document:
        """An SRDF without words of xacro stays as it is; of what else xacro is given, the output is a command's."""
        path = Path(str(args[0])) if args and str(args[0]).endswith(".srdf") else None
        text = path.read_text("utf-8") if path is not None and path.is_file() else "$"
        return Document(OUTPUT if "xacro" in text or "$" in text else text)

    _module("xacro", __getattr__=lambda name: document)


def descriptions(places: Places) -> None:
    """A robot's description in a package that is not here is one that xacro makes, too: MoveIt's builder asks whether
    it is there."""
    try:
        from launch_param_builder import utils
    except ImportError:
        return
    kept = utils.raise_if_file_not_found

    def ask(path: Any) -> None:
        if not (places.is_absent(str(path)) and ".xacro" in str(path)):
            kept(path)

    utils.raise_if_file_not_found = ask


def sort_folders() -> None:
    """Folders list their files in the order of the alphabet, which otherwise the file system decides."""
    listdir, scandir = os.listdir, os.scandir

    class Sorted:
        def __init__(self, *args: Any) -> None:
            with scandir(*args) as entries:
                self._entries = iter(sorted(entries, key=lambda entry: entry.name))

        def __iter__(self) -> Any:
            return self._entries

        def __next__(self) -> Any:
            return next(self._entries)

        def __enter__(self) -> Any:
            return self

        def __exit__(self, *_: object) -> None:
            pass

        def close(self) -> None:
            pass

    os.listdir = lambda *args: sorted(listdir(*args))  # type: ignore[assignment]
    os.scandir = Sorted  # type: ignore[assignment, misc]


class Environment:
    """Notes which variables are asked for that are not set, or different on each machine."""

    missing: ClassVar[set[str]] = set()

    @classmethod
    def follow(cls) -> None:
        def read(self: Any, key: Any, kept: Any = os._Environ.__getitem__) -> Any:
            copying = sys._getframe(1).f_code.co_name == "copy"  # as launch does for each scope
            if key in _DIFFERENT and not copying:
                cls.missing.add(key)
            try:
                return kept(self, key)
            except KeyError:
                if isinstance(key, str) and not key.startswith(_OF_LAUNCH):
                    cls.missing.add(key)
                raise

        os._Environ.__getitem__ = read  # type: ignore[method-assign]


_DIFFERENT = ("ROS_DISTRO", "USER", "ROS_DOMAIN_ID", "AMENT_PREFIX_PATH")
_OF_LAUNCH = ("LAUNCH_", "OVERRIDE_LAUNCH_", "RCUTILS_", "PYTHON", "ROS_LOG", "COLORTERM", "TERM", "LC_", "TMP", "TEMP")


def _module(name: str, **members: object) -> None:
    made = types.ModuleType(name)
    made.__dict__.update(members)
    made.__path__ = []  # type: ignore[attr-defined]
    sys.modules[name] = made
    parent, _, child = name.rpartition(".")
    if parent:
        setattr(sys.modules[parent], child, made)
