"""Which folders a CMakeLists.txt installs as Python packages (``ament_python_install_package``)."""

from __future__ import annotations

import re

_INSTALL = re.compile(r"\bament_python_install_package\s*\(([^()]*)\)", re.IGNORECASE)
_PROJECT = re.compile(r"\bproject\s*\(\s*\"?([\w-]+)", re.IGNORECASE)
_COMMENT = re.compile(r"#\[(=*)\[.*?\]\1\]|#[^\n]*", re.DOTALL)
_WORD = re.compile(r'"([^"]*)"|([^\s"]+)')
_HERE = re.compile(r"\$\{(?:CMAKE_CURRENT_SOURCE_DIR|PROJECT_SOURCE_DIR|CMAKE_SOURCE_DIR)\}/?")


def installed_modules(text: str, package: str) -> dict[str, str]:
    """Folder, relative to that of the CMakeLists.txt, to the name under which it is imported.

    ``package`` stands in for ``${PROJECT_NAME}`` in a file that does not say ``project``.  What takes other
    variables is left out.
    """
    if "ament_python_install_package" not in text:
        return {}
    text = _COMMENT.sub("", text)
    project = _PROJECT.search(text)
    project_name = project[1] if project else package
    found = {}
    for call in _INSTALL.finditer(text):
        words = [
            _HERE.sub("", quoted or plain).replace("${PROJECT_NAME}", project_name)
            for quoted, plain in _WORD.findall(call[1])
        ]
        if not words:
            continue
        folder = words[0]
        if "PACKAGE_DIR" in words[:-1]:
            folder = words[words.index("PACKAGE_DIR") + 1]
        if words[0].isidentifier() and "$" not in folder:
            found[folder.strip("/")] = words[0]
    return found
