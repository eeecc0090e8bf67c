"""Pages that are made of the program: commands, configuration, Python API."""

from __future__ import annotations

import argparse
import importlib
import inspect
import re
from collections.abc import Iterator
from typing import Any

from archlint import api
from archlint.checks.registry import registered
from archlint.cli import COMMANDS
from archlint.config.json_schema import json_schema
from archlint.rulebook import rules


def commands() -> str:
    """Every command with its options, from the parsers."""
    said = "`archlint COMMAND --help` prints the same. `archlint PATH` means `archlint check PATH`."
    lines = ["# Commands", "", said, ""]
    for name in COMMANDS:
        parser = importlib.import_module(f"archlint.cli.{name}").parser()
        lines += [f"## archlint {name}", "", _cell(str(parser.description)), ""]
        lines += [line for group in parser._action_groups for line in _group(group)]
    return "\n".join(lines) + "\n"


def _group(group: Any) -> Iterator[str]:
    actions = [action for action in group._group_actions if "--help" not in action.option_strings]
    if not actions:
        return
    title = {"options": "", "positional arguments": ""}.get(group.title, group.title)
    if title:
        yield f"**{title.capitalize()}**" + (f": {_cell(group.description)}" if group.description else "")
        yield ""
    yield "| argument | |" if not actions[0].option_strings else "| option | |"
    yield "|---|---|"
    for action in actions:
        yield f"| `{_names(action)}` | {_cell(_help(action))} |"
    yield ""


def _names(action: argparse.Action) -> str:
    value = action.metavar if action.nargs != 0 else None
    words = " ".join(value) if isinstance(value, tuple) else value or ""
    names = ", ".join(action.option_strings) or words
    return f"{names} {words}".strip() if action.option_strings else names


def _help(action: argparse.Action) -> str:
    text = (action.help or "") % {"default": action.default}
    return text + ("; may be repeated" if action.nargs == "append" else "")


def _cell(text: str) -> str:
    """A text as a cell of a table."""
    return re.sub(r"(?<![`\w])(--[a-z-]+|ARCHLINT_\w+)", r"`\1`", text).replace("|", "\\|").replace("\n", " ")


_TABLES = {"ContractTable": "contracts", "ExternalNodeTable": "external-nodes"}
"""The keys that hold tables of their own, by what the schema calls these."""


def configuration() -> str:
    """Every key and every option of a rule, from the JSON Schema that ``archlint config --schema`` prints."""
    schema = json_schema()
    lines = ["## All keys", "", "`archlint config --schema` prints them as a JSON Schema.", ""]
    lines += ["| key | holds | |", "|---|---|---|"]
    for key, part in sorted(schema["properties"].items()):
        lines.append(f"| `{key}` | {_holds(part)} | {_cell(part['description'])} |")
    for name, table in sorted(schema["definitions"].items()):
        title = f"Keys of `[[{_TABLES[name]}]]`"
        required = set(table["required"])
        lines += ["", f"## {title}", "", "| key | holds | |", "|---|---|---|"]
        lines += [
            f"| `{key}` | {_holds(part)} | {'always' if key in required else ''} |"
            for key, part in table["properties"].items()
        ]
    lines += ["", "## Options of rules", "", "They stand under `[rules.<code or name>]`.", ""]
    lines += ["| rule | option | default |", "|---|---|---|"]
    for code, check in registered().items():
        rule = rules()[code]
        for option, default in check.defaults.items():
            shown = f"[{rule.title}](rules/{rule.code}-{rule.name}.md#options)"
            lines.append(f"| {shown} | `{option}` | `{_toml(default)}` |")
    return "\n".join(lines) + "\n"


def _toml(value: object) -> str:
    words = {True: "true", False: "false"}
    if isinstance(value, bool):
        return words[value]
    return str(list(value)).replace("'", '"') if isinstance(value, tuple) else repr(value).replace("'", '"')


def _holds(part: dict[str, Any]) -> str:
    """What a value has to be, in words."""
    if "$ref" in part:
        return "a table"
    if "enum" in part:
        return " \\| ".join(f"`{value}`" for value in part["enum"])
    if "anyOf" in part:
        return " or ".join(dict.fromkeys(map(_holds, part["anyOf"])))
    words = {"string": "text", "boolean": "`true` or `false`", "integer": "a number", "number": "a number"}
    if part.get("type") == "array":
        return f"a list of {_holds(part['items']).removeprefix('a ')}s".replace("texts", "text")
    return words.get(part.get("type", ""), "a table")


def python_api() -> str:
    """Every public name with its signature and what its docstring says."""
    lines = ["## Reference", "", "All of it is in `archlint.api`.", ""]
    for name in api.__all__:
        lines += [*_described(name, getattr(api, name), "###"), ""]
    return "\n".join(lines) + "\n"


def _described(name: str, value: Any, marks: str) -> Iterator[str]:
    yield f"{marks} {name}"
    yield ""
    if inspect.isfunction(value):
        yield from ("```python", _signature(name, value), "```", "")
    yield _prose(inspect.getdoc(value) or "")
    if not inspect.isclass(value):
        return
    fields = {key: kind for key, kind in vars(value).get("__annotations__", {}).items() if not key.startswith("_")}
    if fields:
        yield from ("", "| field | type |", "|---|---|")
        yield from (f"| `{key}` | `{kind}` |" for key, kind in fields.items())
    for key, method in vars(value).items():
        if inspect.isfunction(method) and not key.startswith("_") and method.__doc__:
            yield from ("", "```python", _signature(key, method), "```", "", _prose(inspect.getdoc(method) or ""))


def _signature(name: str, function: Any) -> str:
    text = re.sub(r"<(\w+\.\w+): [^>]+>", r"\1", f"{name}{inspect.signature(function)}".replace("'", ""))
    if len(text) <= 100:
        return text
    head, _, rest = text.partition("(")
    arguments, _, result = rest.rpartition(")")
    parts = re.split(r", (?![^\[]*\])", arguments)
    return f"{head}(\n" + "".join(f"    {part},\n" for part in parts) + f"){result}"


def _prose(docstring: str) -> str:
    """A docstring in reStructuredText as Markdown."""
    text = re.sub(r":(?:class|func|meth|attr|data|mod):`~?\.?([^`]+)`", r"`\1`", docstring)
    text = re.sub(r"``([^`]+)``", r"`\1`", text)
    return re.sub(r"::\n\n((?:    .*\n?|\n)+)", _block, text)


def _block(match: re.Match[str]) -> str:
    code = "\n".join(line.removeprefix("    ") for line in match[1].rstrip().splitlines())
    return f":\n\n```python\n{code}\n```\n"
