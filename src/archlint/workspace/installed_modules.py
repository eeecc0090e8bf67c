"""Which folders a CMakeLists.txt installs as Python packages (``ament_python_install_package``)."""

from __future__ import annotations

import re
from collections.abc import Sequence

from archlint.workspace.cmake import Command, parse_cmake

_INSTALL = "ament_python_install_package"
_NAME = re.compile(r"[\w-]+")
_HERE = re.compile(r"\$\{(?:CMAKE_CURRENT_SOURCE_DIR|PROJECT_SOURCE_DIR|CMAKE_SOURCE_DIR)\}/?")


def installed_modules(text: str, package: str) -> dict[str, str]:
    """Folder, relative to that of the CMakeLists.txt, to the name under which it is imported.

    ``package`` stands in for ``${PROJECT_NAME}`` in a file that does not say ``project``.  What takes other
    variables is left out.
    """
    if _INSTALL not in text:
        return {}
    commands = parse_cmake(text)
    project = _project(commands) or package
    modules = {}
    for command in commands:
        words = [_HERE.sub("", word).replace("${PROJECT_NAME}", project) for word in command.texts]
        if command.name != _INSTALL or not words:
            continue
        folder = words[0]
        if "PACKAGE_DIR" in words[:-1]:
            folder = words[words.index("PACKAGE_DIR") + 1]
        if words[0].isidentifier() and "$" not in folder:
            modules[folder.strip("/")] = words[0]
    return modules


def _project(commands: Sequence[Command]) -> str | None:
    """The name that the file gives its project, where it is written out."""
    named = (command.texts[0] for command in commands if command.name == "project" and command.texts)
    return next((name for name in named if _NAME.fullmatch(name)), None)
