"""The files that ``generate_parameter_library`` makes a header or a module of, and what that is called.

Source: ``generate_parameter_library.cmake`` (``generate_parameter_library(target file.yaml [validation.hpp])`` makes
``<project>/<target>.hpp``, ``generate_parameter_module`` the module ``<project>.<target>``) and ``setup_helper.py``
(``generate_parameter_module("module", "file.yaml")`` of a setup.py makes ``<package>.<module>``), 1f74d68.
"""

from __future__ import annotations

import io
import re
import tokenize
from collections.abc import Iterator
from contextlib import suppress

from archlint.workspace.cmake_run import run_alone, without_source

_COMMANDS = ("generate_parameter_library", "generate_parameter_module")
_CALL = re.compile(
    r"""^generate_parameter_module\((?:module_name=)?(?P<a>["'])(?P<module>\w+)(?P=a),"""
    r"""(?:yaml_file=)?(?P<b>["'])(?P<file>[\w./-]+)(?P=b)[,)]"""
)
_VARIABLE = re.compile(r"""^(?P<name>\w+)\s*=\s*(?P<quote>["'])(?P<text>[\w./-]+)(?P=quote)\s*$""", re.MULTILINE)


def generated_by_cmake(text: str, package: str) -> Iterator[tuple[str, str]]:
    """Pairs of a file, relative to the CMakeLists.txt that this is the text of, and the name of what is generated of
    it, as Python writes it: ``package.target``."""
    if not any(command in text for command in _COMMANDS):
        return
    for command in (step.command for step in run_alone(text, package).steps):
        if command.name in _COMMANDS and len(command.arguments) > 1:
            target, file = command.texts[0], without_source(command.texts[1])
            if "$" not in target + file:
                yield file, f"{package}.{target}"


def generated_by_setup(text: str, package: str) -> Iterator[tuple[str, str]]:
    """The same of a setup.py, of calls that stand alone and of which both texts are written out, there or in a variable
    of the module."""
    if "generate_parameter_module" not in text:
        return
    for variable in _VARIABLE.finditer(text):
        name, quote, value = variable["name"], variable["quote"], variable["text"]
        text = re.sub(rf"(?<=[(,=\s]){name}(?=\s*[,)])", f"{quote}{value}{quote}", text)
    for line in _lines(text):
        if (call := _CALL.match(line)) is not None:
            yield call["file"], f"{package}.{call['module']}"


def _lines(text: str) -> Iterator[str]:
    """The logical lines of code, without blanks and comments, up to where it is none of Python's."""
    line: list[str] = []
    with suppress(tokenize.TokenError, SyntaxError):
        for token in tokenize.generate_tokens(io.StringIO(text).readline):
            if token.type == tokenize.NEWLINE:
                yield "".join(line)
                line = []
            elif token.type not in (tokenize.COMMENT, tokenize.NL, tokenize.INDENT, tokenize.DEDENT):
                line.append(token.string)


__all__ = ["generated_by_cmake", "generated_by_setup"]
