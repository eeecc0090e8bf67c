"""Loads a plugin: runs its code, and reads the page of each of its rules."""

from __future__ import annotations

import hashlib
import os
import sys
import traceback
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from types import ModuleType

from archlint.checks.registry import Check
from archlint.disk import read_regular
from archlint.plugins.guarding import guarded
from archlint.plugins.model import Plugin, PluginError
from archlint.rulebook import CODE, PAGE_NAME, Rule, RuleBookError, page_of

MAX_BYTES = 1_000_000
"""A larger file is no plugin, and no page."""


def load_file(path: Path, name: str) -> Plugin:
    """The plugin in a file, which is run; ``name`` is what the configuration calls it.  Raises :class:`PluginError`."""
    source = _read(path, name)
    module = ModuleType(f"archlint_plugin_{hashlib.sha256(source).hexdigest()[:16]}")
    module.__file__ = str(path)
    sys.modules[module.__name__] = module  # dataclasses look for the module of a class there
    try:
        exec(compile(source, str(path), "exec"), vars(module))
    except (Exception, SystemExit) as error:
        raise PluginError(f"{name}: {_where(error, path)}{type(error).__name__}: {error}") from None
    finally:
        del sys.modules[module.__name__]
    return plugin_of(module, name, path.parent, {path.name: source})


def plugin_of(module: ModuleType, name: str, folder: Path, files: Mapping[str, bytes]) -> Plugin:
    """The plugin that a module is, with the pages in its folder; ``files`` are those that it consists of.

    Raises :class:`PluginError`.
    """
    checks = {check.code: check for check in vars(module).values() if isinstance(check, Check)}
    if not checks:
        raise PluginError(f"{name}: no rule in it: `from archlint.api import rule` has the decorator that makes one")
    pages = {file.name[:6]: file for file in sorted(folder.iterdir()) if PAGE_NAME.fullmatch(file.name)}
    rules: dict[str, Rule] = {}
    parts = dict(files)
    for code in sorted(checks):
        if not CODE.fullmatch(code):
            raise PluginError(f"{name}: {code!r} is no code of a rule: three capital letters and three digits are")
        if code not in pages:
            raise PluginError(f"{name}: {code} has no page: {code}-<its name>.md beside the plugin says what it is")
        parts[pages[code].name] = _read(pages[code], name)
        rules[code] = _rule(pages[code].name, parts[pages[code].name], name)
    return Plugin(
        name,
        _digest(parts),
        {code: replace(check, function=guarded(code, check.function)) for code, check in sorted(checks.items())},
        rules,
        tuple(str(folder / part) for part in sorted(parts)),
    )


def _rule(page: str, text: bytes, name: str) -> Rule:
    try:
        rule = page_of(page, text.decode())
    except (RuleBookError, UnicodeDecodeError) as error:
        raise PluginError(f"{name}: {error}") from None
    if rule.fix:
        raise PluginError(f"{name}: {page}: fix: {rule.fix}: the rules of plugins have no fixes: write none")
    return replace(rule, plugin=name)


def _read(path: Path, name: str) -> bytes:
    try:
        return read_regular(path, MAX_BYTES)
    except OSError as error:
        raise PluginError(f"{name}: {path.name} cannot be read: {error.strerror}") from None


def _digest(files: Mapping[str, bytes]) -> str:
    digest = hashlib.sha256()
    for name in sorted(files):
        digest.update(f"{len(os.fsencode(name))} {len(files[name])} ".encode() + os.fsencode(name) + files[name])
    return digest.hexdigest()


def _where(error: BaseException, path: Path) -> str:
    """The last line of the plugin that was on the way to an error."""
    if isinstance(error, SyntaxError):
        return f"line {error.lineno}: "
    lines = [frame.lineno for frame in traceback.extract_tb(error.__traceback__) if frame.filename == str(path)]
    return f"line {lines[-1]}: " if lines else ""
