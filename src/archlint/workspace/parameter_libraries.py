"""The files that ``generate_parameter_library`` makes a header or a module of, and what that is called.

Source: ``generate_parameter_library.cmake`` (``generate_parameter_library(target file.yaml [validation.hpp])`` makes
``<project>/<target>.hpp``, ``generate_parameter_module`` the module ``<project>.<target>``) and ``setup_helper.py``
(``generate_parameter_module("module", "file.yaml")`` of a setup.py makes ``<package>.<module>``), 1f74d68.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from archlint.workspace.cmake_run import run_alone, without_source

_COMMANDS = ("generate_parameter_library", "generate_parameter_module")
_CALL = re.compile(
    r"""^[ \t]*generate_parameter_module\(\s*
        (?:module_name\s*=\s*)?(?P<a>["'])(?P<module>\w+)(?P=a)\s*,\s*
        (?:yaml_file\s*=\s*)?(?P<b>["'])(?P<file>[\w./-]+)(?P=b)""",
    re.VERBOSE | re.MULTILINE,
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
    for call in _CALL.finditer(text):
        yield call["file"], f"{package}.{call['module']}"


__all__ = ["generated_by_cmake", "generated_by_setup"]
