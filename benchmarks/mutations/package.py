"""Defects in what a package says of itself."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator

from .defect import Defect, Sites, plants
from .python_source import Edit, Lines, literal, misspelt


@plants("an entry point misspelt")
def entry_point(sites: Sites) -> Iterator[Defect]:
    for source in sites.home.python:
        if not source.file.endswith("setup.py"):
            continue
        for node in ast.walk(source.tree):
            text = literal(node) if isinstance(node, ast.Constant) else None
            match = re.fullmatch(r"\s*[\w.-]+\s*=\s*([\w.]+):(\w+)\s*", text or "")
            if match is None or not isinstance(node, ast.Constant):
                continue
            written = source.text(node).decode()
            start = written.find(match.group(1), written.find("="))
            module, function = match.group(1), match.group(2)
            head, dot, last = module.rpartition(".")
            wrong = (head + dot + (misspelt(last) or last), misspelt(function) or function)
            also = ("EXE008", "GRF002", "LCH001", "LCH002", "PRM004")
            for new in (f"{wrong[0]}:{function}", f"{module}:{wrong[1]}"):
                end = start + len(new)
                if start >= 0 and new != f"{module}:{function}":
                    edit = source.replaced(node, written[:start] + new + written[end:])
                    yield Defect((edit,), ("PKG002",), (source.lines(node),), also=also)


def _manifest(sites: Sites) -> str:
    return sites.home.text(sites.home.manifest).decode("utf-8", "replace")


@plants("a dependency dropped")
def dependency(sites: Sites) -> Iterator[Defect]:
    text = _manifest(sites)
    for name in sorted(set(re.findall(r"<(?:exec_|run_)?depend>\s*([\w-]+)\s*<", text))):
        places = [
            source.lines(node)
            for source in sites.home.code
            for node in source.tree.body
            if (isinstance(node, ast.ImportFrom) and not node.level and (node.module or "").split(".")[0] == name)
            or (isinstance(node, ast.Import) and any(alias.name.split(".")[0] == name for alias in node.names))
        ]
        tags = re.finditer(rf"<((?:\w+_)?depend)\b[^>]*>\s*{re.escape(name)}\s*</\1>", text)
        edits = tuple(
            Edit(sites.home.manifest, _at(text, tag.start()), _at(text, tag.end()), b"") for tag in tags if places
        )
        if edits:
            # What the dropped package brought is missing, too.
            yield Defect(edits, ("PKG001",), tuple(places), also=("PKG001",))


@plants("a dependency on a package that needs this one")
def circle(sites: Sites) -> Iterator[Defect]:
    for name in sorted(sites.home.needs - {sites.home.name}):
        other = sites.beside[name]
        text = other.text(other.manifest).decode("utf-8", "replace")
        at = text.rfind("</package>")
        if at >= 0:
            edit = Edit(other.manifest, _at(text, at), _at(text, at), f"<depend>{sites.home.name}</depend>".encode())
            # Each package on the way may be told of its own circle; packages that need each other run together.
            places = tuple(Lines(package.manifest, 1, 10_000) for package in sites.beside.values())
            yield Defect((edit,), ("PKG003",), places, also=("OWN001", "OWN002"))


def _at(text: str, index: int) -> int:
    return len(text[:index].encode())
