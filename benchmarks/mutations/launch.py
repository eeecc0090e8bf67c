"""Defects in launch files, Python's and XML ones, and in the parameter files that they load."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator

from .defect import Defect, Sites, plants
from .python_source import Edit, Lines, PythonSource, argument, called, literal, misspelt, misspelt_literal

_NODES = ("Node", "LifecycleNode")


def _nodes(sites: Sites, ours: bool = True) -> Iterator[tuple[PythonSource, ast.Call]]:
    """Node actions that start an executable of a package that stands in the workspace."""
    for source in sites.home.launch_python:
        for call in source.calls:
            package = literal(argument(call, 99, "package"))
            if called(call) in _NODES and (not ours or package in sites.beside):
                yield source, call


def _written_in_python(sites: Sites, call: ast.Call) -> bool:
    """Whether the package of a node action has the executable's Python, as far as names tell."""
    package = sites.beside.get(literal(argument(call, 99, "package")) or "")
    name = literal(argument(call, 99, "executable")) or ""
    if package is None or not name:
        return False
    setup = [f for f in package.files if f.endswith(("setup.py", "setup.cfg"))]
    entries = b"".join(package.text(file) for file in setup)
    pattern = re.compile(rb"[\"'\s]" + re.escape(name.encode()) + rb"\s*=")
    return pattern.search(entries) is not None or any(
        f.endswith(f"/{name}") and name.endswith(".py") for f in package.files
    )


@plants("an executable misspelt")
def executable(sites: Sites) -> Iterator[Defect]:
    for source, call in _nodes(sites):
        given = argument(call, 99, "executable")
        edit = misspelt_literal(source, given) if given is not None else None
        if edit is not None and given is not None:
            yield Defect((edit,), ("LCH001",), (source.lines(given), source.lines(call)), also=("PRM005", "GRF002"))
    for file, text, match in _xml(sites, r'<node\b[^>]*?\bexec="([\w.-]+)"'):
        package = re.search(r'\bpkg="([\w-]+)"', text[match.start() : text.find(">", match.start())])
        if package is not None and package.group(1) in sites.beside:
            yield _xml_defect(file, text, match, "LCH001", ("PRM005", "GRF002"))


@plants("the source of a remapping misspelt")
def remapping(sites: Sites) -> Iterator[Defect]:
    for source, call in _nodes(sites):
        given = argument(call, 99, "remappings")
        if not isinstance(given, (ast.List, ast.Tuple)) or not _written_in_python(sites, call):
            continue
        for pair in given.elts:
            if isinstance(pair, ast.Tuple) and len(pair.elts) == 2:
                edit = misspelt_literal(source, pair.elts[0])
                if edit is not None:
                    # The name is what the code wrote again: it may now clash, or miss its partner.
                    yield Defect((edit,), ("LCH002",), (source.lines(pair),), also=("TOP004", "TOP001", "OWN001"))


@plants("a LaunchConfiguration misspelt")
def configuration(sites: Sites) -> Iterator[Defect]:
    for source in sites.home.launch_python:
        for call in source.calls:
            plain = called(call) == "LaunchConfiguration" and len(call.args) == 1 and not call.keywords
            edit = misspelt_literal(source, call.args[0]) if plain else None
            if edit is not None:
                yield Defect((edit,), ("LCH003",), (source.lines(call),), also=("LCH004",))
    for file, text, match in _xml(sites, r"\$\(var (\w+)\)"):
        yield _xml_defect(file, text, match, "LCH003", ("LCH004",))


@plants("an included, parameter or RViz file misspelt")
def included(sites: Sites) -> Iterator[Defect]:
    there = {file.rpartition("/")[2] for package in sites.beside.values() for file in package.files}
    for source in sites.home.launch_python:
        for node in ast.walk(source.tree):
            text = literal(node) if isinstance(node, ast.Constant) else None
            if text is None or not isinstance(node, ast.Constant) or text.rpartition("/")[2] not in there:
                continue
            if text.endswith((".launch.py", ".launch.xml", "_launch.py", ".rviz", ".yaml")):
                head, slash, name = text.rpartition("/")
                stem, dot, rest = name.partition(".")
                written = source.text(node).decode()
                wrong = misspelt(stem)
                if wrong is not None and text in written:
                    edit = source.replaced(node, written.replace(text, head + slash + wrong + dot + rest))
                    yield Defect((edit,), ("LCH004",), (_statement(source, node),), also=("PRM005",))
    for file, text, match in _xml(sites, r'<include\b[^>]*?\bfile="[^"]*?/([\w-]+)\.launch(?:\.py|\.xml)?"'):
        yield _xml_defect(file, text, match, "LCH004", ())


def _statement(source: PythonSource, node: ast.expr) -> Lines:
    """The whole file: a path is often made up far from the action that uses it."""
    return Lines(source.file, 1, len(source.starts))


@plants("a second node of the same name")
def second_node(sites: Sites) -> Iterator[Defect]:
    for source, call in _nodes(sites, ours=False):
        if literal(argument(call, 99, "name")) and isinstance(source.parents.get(call), ast.List):
            start, end = source.offsets(call)
            text = re.sub(rb"\s*\n\s*", b" ", source.data[start:end])
            if b"#" not in text:
                edit = Edit(source.file, end, end, b", " + text)
                also = ("OWN001", "OWN002", "PRM005")
                yield Defect((edit,), ("NME004",), (source.lines(call),), also=also)


# ------------------------------------------------------------------------------------------------------ parameters


def _settings(sites: Sites) -> Iterator[tuple[PythonSource, ast.Call, ast.expr, ast.expr]]:
    for source, call in _nodes(sites):
        given = argument(call, 99, "parameters")
        if isinstance(given, ast.List) and _written_in_python(sites, call):
            for one in given.elts:
                if isinstance(one, ast.Dict):
                    for key, value in zip(one.keys, one.values, strict=True):
                        if key is not None and literal(key):
                            yield source, call, key, value


@plants("a parameter misspelt in a launch file or YAML")
def setting(sites: Sites) -> Iterator[Defect]:
    for source, _, key, _ in _settings(sites):
        edit = misspelt_literal(source, key)
        if edit is not None:
            yield Defect((edit,), ("PRM004",), (source.lines(key),))
    for file, text, match in _yaml(sites, r"^ {4}(\w+): *[^\s#{]"):
        name = match.group(1)
        wrong = misspelt(name)
        before = re.findall(r"^/?(\w+):\s*\n\s+ros__parameters:", text[: match.start()], re.M)
        if wrong is not None and before and _is_python_node(sites, before[-1]):
            line = text.count("\n", 0, match.start()) + 1
            edit = _edit(file, text, match.start(1), name, wrong)
            yield Defect((edit,), ("PRM004",), (Lines(file, line, line),))


@plants("a number where a string is declared, and the reverse")
def setting_type(sites: Sites) -> Iterator[Defect]:
    for source, _, _, value in _settings(sites):
        if isinstance(value, ast.Constant) and value.value is not None and not isinstance(value.value, bool):
            wrong = "17" if isinstance(value.value, str) else "'seventeen'"
            edit = source.replaced(value, wrong)
            yield Defect((edit,), ("PRM002",), (source.lines(value),))


@plants("the node's key in a parameter file misspelt")
def section(sites: Sites) -> Iterator[Defect]:
    for file, text, match in _yaml(sites, r"^/?(\w+):\s*\n\s+ros__parameters:"):
        wrong = misspelt(match.group(1))
        if wrong is not None and _is_python_node(sites, match.group(1)):
            line = text.count("\n", 0, match.start()) + 1
            edit = _edit(file, text, match.start(1), match.group(1), wrong)
            yield Defect((edit,), ("PRM005",), (Lines(file, line, line),))


# ------------------------------------------------------------------------------------------------------- XML, YAML


def _xml(sites: Sites, pattern: str) -> Iterator[tuple[str, str, re.Match[str]]]:
    for file in sites.home.launch_xml:
        text = sites.home.text(file).decode("utf-8", "replace")
        plain = re.sub(r"<!--.*?-->", lambda found: re.sub(r"[^\n]", " ", found.group()), text, flags=re.S)
        yield from ((file, plain, match) for match in re.finditer(pattern, plain, re.S))


def _xml_defect(file: str, text: str, match: re.Match[str], rule: str, also: tuple[str, ...]) -> Defect:
    wrong = misspelt(match.group(1)) or ""
    first = text.count("\n", 0, match.start()) + 1
    last = text.count("\n", 0, match.end()) + 1
    edit = _edit(file, text, match.start(1), match.group(1), wrong)
    return Defect((edit,), (rule,), (Lines(file, first, last),), also=also)


def _yaml(sites: Sites, pattern: str) -> Iterator[tuple[str, str, re.Match[str]]]:
    """Parameter files that a launch file of the package speaks of."""
    spoken = b"".join(source.data for source in sites.home.launch_python)
    spoken += b"".join(sites.home.text(file) for file in sites.home.launch_xml)
    for file in sites.home.files:
        if file.endswith((".yaml", ".yml")) and file.rpartition("/")[2].encode() in spoken:
            text = sites.home.text(file).decode("utf-8", "replace")
            if "ros__parameters:" in text:
                yield from ((file, text, match) for match in re.finditer(pattern, text, re.M))


def _is_python_node(sites: Sites, name: str) -> bool:
    """Whether some Python code of the workspace names a node so."""
    pattern = re.compile(rb"(?:__init__|Node|create_node)\(\s*(?:node_name=)?[\"']" + name.encode() + rb"[\"']")
    return any(pattern.search(source.data) for package in sites.beside.values() for source in package.code)


def _edit(file: str, text: str, at: int, old: str, new: str) -> Edit:
    start = len(text[:at].encode())
    return Edit(file, start, start + len(old.encode()), new.encode())
