"""What there is to run in a checked-out repository: Python roots, programs, modules, interface
definitions."""

from __future__ import annotations

import ast
import configparser
import os
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

_SKIPPED = frozenset({"build", "install", "log", "node_modules", "__pycache__", "site-packages", "venv", ".venv"})
_CREATORS = frozenset(
    {
    "create_publisher", "create_subscription", "create_service", "create_client", "create_timer",
    "create_lifecycle_publisher", "ActionServer", "ActionClient", "Subscriber", "TransformListener",
    "TransformBroadcaster", "StaticTransformBroadcaster", "Buffer", "BufferClient",
    "AsyncParameterClient", "ParameterEventHandler", "wait_for_message",
    }
)  # fmt: skip
_ENTRY = re.compile(r"^\s*([\w.-]+)\s*=\s*([\w.]+)\s*:\s*([\w.]+)\s*(\[.*\])?\s*$")
_NODE_WORDS = ("rclpy", "Node", *(_CREATORS - {"Buffer", "Subscriber"}))


def is_test(relative: str) -> bool:
    """Whether a file is test code: under test/ or tests/, or named like a test."""
    parts = relative.split("/")
    name = parts[-1]
    return (
        any(part in ("test", "tests") for part in parts[:-1])
        or name.startswith("test_")
        or name.endswith("_test.py")
        or name == "conftest.py"
    )


@dataclass(frozen=True)
class Source:
    """One Python file of the repository."""

    path: Path
    relative: str
    text: str

    @cached_property
    def tree(self) -> ast.Module | None:
        """Its syntax tree, if it is Python 3."""
        try:
            return ast.parse(self.text)
        except (SyntaxError, ValueError, RecursionError):
            return None

    @property
    def mentions_ros(self) -> bool:
        """Whether it may have to do with nodes at all."""
        return any(word in self.text for word in _NODE_WORDS)

    def create_sites(self) -> list[tuple[int, str]]:
        """(first line, enclosing function) of each call that is written like a create call."""
        return list(_sites(self.tree, [])) if self.tree else []

    def is_program(self) -> bool:
        """Whether executing it does something: a `__main__` guard, or calls at module level in a script."""
        if self.tree is None:
            return False
        if any(_is_main_guard(node) for node in self.tree.body):
            return True
        calls = any(isinstance(node, ast.Expr) and isinstance(node.value, ast.Call) for node in self.tree.body)
        return calls and self.text.startswith("#!")

    def guard_calls(self) -> str | None:
        """The function that the `__main__` guard calls, when it does nothing else."""
        for node in self.tree.body if self.tree else ():
            if _is_main_guard(node) and isinstance(node, ast.If) and len(node.body) == 1:
                match node.body[0]:
                    case ast.Expr(value=ast.Call(func=ast.Name(id=name))):
                        return name
                    case ast.Expr(
                        value=ast.Call(func=ast.Attribute(attr="exit"), args=[ast.Call(func=ast.Name(id=name))])
                    ):
                        return name
        return None


def _is_main_guard(node: ast.stmt) -> bool:
    return isinstance(node, ast.If) and "__main__" in ast.dump(node.test) and "__name__" in ast.dump(node.test)


def _sites(node: ast.AST, names: list[str]) -> Iterator[tuple[int, str]]:
    for child in ast.iter_child_nodes(node):
        if isinstance(child, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
            yield from _sites(child, [*names, ("." if isinstance(child, ast.ClassDef) else "()") + child.name])
            continue
        if isinstance(child, ast.Call):
            function = child.func
            name = function.attr if isinstance(function, ast.Attribute) else getattr(function, "id", "")
            with_node = len(child.args) > 1 or any(keyword.arg == "node" for keyword in child.keywords)
            if name in _CREATORS and (name != "Buffer" or with_node):
                yield child.lineno, _callable_name(names)
        yield from _sites(child, names)


def _callable_name(names: list[str]) -> str:
    """The outermost function around a place, with the classes around it; empty at module level."""
    kept: list[str] = []
    for name in names:
        kept.append(name.lstrip(".()"))
        if name.startswith("()"):
            return ".".join(kept)
    return ""


@dataclass
class Workspace:
    """A repository to run."""

    root: Path
    sources: list[Source] = field(default_factory=list)
    roots: list[Path] = field(default_factory=list)
    packages: dict[str, str] = field(default_factory=dict)
    interfaces: dict[str, str] = field(default_factory=dict)
    setups: list[Path] = field(default_factory=list)
    configured: list[tuple[str, Path]] = field(default_factory=list)  # entry points that are plain data

    def own_roots(self, file: Path) -> list[Path]:
        """The Python roots of a file, nearest first."""
        return sorted((root for root in self.roots if file.is_relative_to(root)), key=lambda root: -len(root.parts))

    def module_of(self, file: Path) -> tuple[str, Path]:
        """The dotted name under which a file is imported, and the folder that must be on the path."""
        top = file.parent
        while (top / "__init__.py").is_file() and top != self.root:
            top = top.parent
        parts = list(file.relative_to(top).with_suffix("").parts)
        if parts[-1] == "__init__":
            parts.pop()
        return ".".join(parts), top


def read(root: Path) -> Workspace:
    """Look through a repository once."""
    workspace = Workspace(root)
    tops: set[Path] = set()
    for folder, names, files in os.walk(root):
        names[:] = sorted(name for name in names if name not in _SKIPPED and not name.startswith("."))
        here = Path(folder)
        if "COLCON_IGNORE" in files and here != root and "package.xml" not in files:
            names.clear()
            continue
        for name in sorted(files):
            _take(workspace, here / name, tops)
    workspace.roots = sorted(tops)
    return workspace


def _take(workspace: Workspace, path: Path, tops: set[Path]) -> None:
    here, relative = path.parent, path.relative_to(workspace.root).as_posix()
    if path.name == "package.xml":
        found = re.search(r"<name>\s*([\w-]+)\s*</name>", path.read_text(encoding="utf-8", errors="replace"))
        if found:
            workspace.packages[found[1]] = str(here)
        tops.update(each for each in (here, here / "src") if each.is_dir())
    elif path.name == "setup.py":
        workspace.setups.append(path)
        tops.add(here)
    elif path.name in ("setup.cfg", "pyproject.toml"):
        workspace.configured.extend((script, here) for script in _configured(path))
        tops.add(here)
    elif path.suffix in (".msg", ".srv", ".action"):
        package = _package_above(path)
        if package and here.name == path.suffix[1:]:
            workspace.interfaces[f"{package}/{here.name}/{path.stem}"] = str(path)
    doubled = path.is_symlink() and path.resolve().is_relative_to(workspace.root.resolve())
    if not doubled and (path.suffix == ".py" or (not path.suffix and _has_python_shebang(path))):
        source = _source(path, relative)
        if source is not None:
            workspace.sources.append(source)
        if path.name == "__init__.py" and not (here.parent / "__init__.py").exists():
            tops.add(here.parent)


def _source(path: Path, relative: str) -> Source | None:
    try:
        return Source(path, relative, path.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError):
        return None


def _has_python_shebang(path: Path) -> bool:
    try:
        with path.open("rb") as file:
            first = file.readline(80)
    except OSError:
        return False
    return first.startswith(b"#!") and b"python" in first


def _package_above(path: Path) -> str | None:
    for folder in path.parents[:4]:
        manifest = folder / "package.xml"
        if manifest.is_file():
            found = re.search(r"<name>\s*([\w-]+)\s*</name>", manifest.read_text(encoding="utf-8", errors="replace"))
            return found[1] if found else None
    return None


def _configured(path: Path) -> list[str]:
    text = path.read_text(encoding="utf-8", errors="replace")
    if path.suffix == ".toml":
        section = re.search(r"(?ms)^\[project\.scripts\]\s*$(.*?)(^\[|\Z)", text)
        return (
            [line.replace('"', "").replace("'", "") for line in section[1].splitlines() if "=" in line]
            if section
            else []
        )
    parser = configparser.ConfigParser(interpolation=None)
    try:
        parser.read_string(text)
    except configparser.Error:
        return []
    scripts = parser.get("options.entry_points", "console_scripts", fallback="")
    return [line for line in scripts.splitlines() if "=" in line]


def entry_point(script: str) -> tuple[str, str, str] | None:
    """(executable, module, function) of one console_scripts line."""
    found = _ENTRY.match(script)
    return (found[1], found[2], found[3]) if found else None
