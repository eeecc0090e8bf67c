"""The page as one file: style, libraries, scripts and data, under a policy that admits these and nothing else.

The page asks the network for nothing.  Its policy names each script and the style by their hashes; the data are in a
JSON block in which no ``<`` can end it, and scripts make elements of them without ever reading them as markup.
"""

from __future__ import annotations

import base64
import hashlib
import html
import re
from importlib.resources import files
from typing import TYPE_CHECKING

from archlint.json_text import json_text
from archlint.render.page.contents import page_data

if TYPE_CHECKING:
    from collections.abc import Sequence

    from archlint.render.page.model import PageContents

SCRIPTS = (
    "elements",
    "model",
    "state",
    "arrange",
    "scene",
    "paint",
    "snapshot",
    "svg",
    "details",
    "sidebar",
    "marks",
    "page",
)
"""In the order in which they need each other.  Each is a module; in the page they are one."""
LIBRARIES = (
    *("d3-dispatch", "d3-selection", "d3-drag", "d3-color", "d3-interpolate"),
    *("d3-timer", "d3-ease", "d3-transition", "d3-zoom", "dagre"),
)
"""As :data:`SCRIPTS`; ``vendor/VERSIONS`` says which they are."""

_MODULE_WORDS = re.compile(r'^(?:import .*?;\n|"use strict";\n|export (?=function |const |class ))', re.MULTILINE)


def page_text(contents: PageContents) -> str:
    """The whole page."""
    data = page_data(contents)
    libraries, script, style = library_text(), script_text(), style_text()
    title = contents.systems[0].system.name or "ROS 2 communication graph"
    values = {
        "policy": html.escape(policy([libraries, script], style)),
        "title": html.escape(title),
        "style": style,
        "libraries": libraries,
        "script": script,
        "data": embedded(data),
    }
    template = _asset("page.html")
    return re.sub(r"\{\{(\w+)\}\}", lambda match: values[match[1]], template)


def library_text() -> str:
    """The libraries one after another, with the licence that each of them asks to be kept."""
    scripts = [_read("vendor", f"{name}.js") for name in LIBRARIES]
    return "".join([f"/*\n{_read('vendor', 'LICENSE')}*/\n", *scripts])


def script_text() -> str:
    """The page's own modules as one script: what they import of each other is there, in one function."""
    modules = [_asset(f"{name}.js") for name in SCRIPTS]
    return '"use strict";\n(() => {\n' + "".join(_MODULE_WORDS.sub("", module) for module in modules) + "})();\n"


def style_text() -> str:
    return _asset("page.css")


def _asset(name: str) -> str:
    return _read("assets", name)


def _read(folder: str, name: str) -> str:
    return files("archlint.render.page").joinpath(folder).joinpath(name).read_text("utf-8")


def embedded(data: object) -> str:
    """JSON for the inside of a script element."""
    text = json_text(data, separators=(",", ":"))
    return text.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026")


def policy(scripts: Sequence[str], style: str) -> str:
    """What the page may do: run these scripts and use this style."""
    nothing = "default-src 'none'; base-uri 'none'; form-action 'none'"
    allowed = " ".join(f"'{_hash(script)}'" for script in scripts)
    return f"{nothing}; script-src {allowed}; style-src '{_hash(style)}'"


def _hash(text: str) -> str:
    return "sha256-" + base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()


__all__ = ["embedded", "library_text", "page_text", "policy", "script_text", "style_text"]
