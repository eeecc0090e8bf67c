"""What a hover says of what is on the disk: executables, packages, interfaces, files."""

from __future__ import annotations

from collections.abc import Iterator

from archlint.lookup.index import Index
from archlint.lookup.mentions import Mention
from archlint.lookup.words import code, node_words


def node_lines(index: Index, mention: Mention) -> Iterator[str]:
    if mention.node is not None:
        yield from node_words(mention.node)


def executable_lines(index: Index, mention: Mention) -> Iterator[str]:
    subject = mention.subject
    yield f"executable {code(subject.name)} of package {code(subject.owner)}"
    if mention.node is not None:
        yield from node_words(mention.node)


def package_lines(index: Index, mention: Mention) -> Iterator[str]:
    name = mention.subject.name
    package = index.workspace.packages.get(name)
    if package is None:
        yield f"package {code(name)}, not in this workspace"
        return
    yield f"package {code(name)}, in {code(package.relative)}"
    installs = index.workspace.installs.get(name)
    if installs is not None and installs.executables:
        yield "Executables: " + ", ".join(map(code, sorted(installs.executables)))


def interface_lines(index: Index, mention: Mention) -> Iterator[str]:
    text = index.definition_text(mention.subject.name)
    if text is not None:
        yield f"{code(mention.subject.name)}"
        yield f"```\n{text.strip()}\n```"


def file_lines(index: Index, mention: Mention) -> Iterator[str]:
    """The path, and of a launch file the arguments that it declares."""
    name = mention.subject.name
    yield f"file {code(name)}"
    launch = next((launched for launched in index.workspace.launched if launched.file == name), None)
    arguments = [argument for argument in launch.declared if argument.file == name] if launch is not None else []
    declared = {argument.name: argument.default.text if argument.default else None for argument in arguments}
    rows = [
        f"- {code(argument)}" + (f", by default {code(default)}" if default else "")
        for argument, default in declared.items()
    ]
    if rows:
        yield "Launch arguments:\n" + "\n".join(rows)


__all__ = ["executable_lines", "file_lines", "interface_lines", "node_lines", "package_lines"]
