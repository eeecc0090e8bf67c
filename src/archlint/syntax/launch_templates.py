"""Templates of launch files: a program puts names in for the placeholders before anything is launched."""

from __future__ import annotations

import re
from collections.abc import Iterator

from archlint.syntax.launch_elements import Element

_PLACEHOLDER = re.compile(
    r"(?<![\\$\w])\$(?:([A-Za-z_]\w*)|\{(?![\w-]+\s)([A-Za-z_]\w*))|@[A-Za-z_]\w*@|\{\{\s*[A-Za-z_][\w.]*\s*\}\}"
)
"""``$ROBOT`` or ``${robot}``, ``@ROBOT@`` as in CMake, ``{{ robot }}`` as in Jinja.  launch has substitutions in
parentheses only: to it these are letters.  ``${var robot}`` is one of those, with the wrong brackets."""

_COMMANDS = frozenset({"cmd", "args", "ros_args", "launch-prefix", "launch_prefix"})
"""Attributes that may go to a shell, which replaces them itself."""

_VARIABLES = frozenset({"env", "set_env"})
"""Elements whose values go to the processes as they are: rosconsole, for one, has ``${severity}`` in its formats."""

_ENVIRONMENT = frozenset({"HOME", "USER", "LOGNAME", "PWD", "PATH", "SHELL", "DISPLAY", "HOSTNAME"})
"""Whoever writes one of these takes the attribute for the text of a shell."""


def has_placeholders(root: Element) -> bool:
    """Whether an attribute has something that launch does not replace and that is no name of ROS either."""
    arguments = {name for arg in root.of("arg") if (name := arg.text("name")) is not None}
    stack = [root]
    while stack:
        element = stack.pop()
        stack.extend(element.children)
        # Of a template, `${robot}` may be what the argument of that name is by default.
        mistaken = arguments if element.tag != "arg" else set[str]()
        for text in _texts(element):
            if any(
                match[1] not in _ENVIRONMENT and match[2] not in _ENVIRONMENT | mistaken
                for match in _PLACEHOLDER.finditer(text)
            ):
                return True
    return False


def _texts(element: Element) -> Iterator[str]:
    """The attributes that launch takes for more than letters, or that name something: no substitution is in them."""
    if element.tag in _VARIABLES:
        return
    for name, attribute in element.attributes.items():
        values = attribute.value if isinstance(attribute.value, list) else [attribute.value]
        for value in values if name not in _COMMANDS else ():
            if isinstance(value, str) and "$(" not in value:
                yield value
