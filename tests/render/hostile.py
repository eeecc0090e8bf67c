"""Names that try to become something else than names."""

from __future__ import annotations

from archlint.systems.model import System
from systems.builders import node, partial, publisher, subscriber, system

NAMES = [
    '"];evil[label="',
    "a\\N\\G\\l",
    "trailing\\",
    "<b>bold</b>",
    "<script>alert(1)</script>",
    "&lt;tag&gt; &#65; &quot;",
    "port:w",
    "end",
    "line\nbreak\rreturn",
    "\x1b[31mred\x1b]8;;http://x\x07",
    "left\u202eright\u200b",
    "%% comment #quot; `code`",
    "--> n0",
    "]]>",
    "\ud83d lone",
    "größe/日本",
]


def hostile() -> System:
    """Each name as a topic, a type and a package; rcl would refuse them, a picture must survive them."""
    return system(
        *(
            node(
                f"/n{number}",
                publisher(name, name),
                subscriber(partial(name)),
                package=name,
                file=f"{name}.py",
            )
            for number, name in enumerate(NAMES)
        )
    )
