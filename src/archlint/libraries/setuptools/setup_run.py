"""``setup(…)`` as a setup.py calls it: what it is given is kept, and nothing is installed."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from archlint.interpreter import containers
from archlint.interpreter.values import Known, Unknown, Value
from archlint.libraries.run import Run
from archlint.libraries.setuptools import manifest

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.syntax import facts

Plain = Callable[[Run, list[Value], dict[str, Value], "facts.Call | None"], Value]


class SetupRun(Run):
    """The symbolic run of a setup.py: what it calls ``setup`` with, and where."""

    keywords: dict[str, Value] | None = None
    open = False
    called_at: Place | None = None


def record_setup(run: Run, args: list[Value], keywords: dict[str, Value], e: facts.Call | None) -> Value:
    """A call of ``setup(…)``; what it is given is kept where a setup.py is read."""
    if isinstance(run, SetupRun) and (run.keywords is None or "entry_points" in keywords):
        # Of two calls (one for ROS 1, one for ROS 2) the one with entry points is that of ROS 2.
        run.keywords = dict(keywords)
        starred = e is not None and any(argument.star for argument in e.args)
        run.open = starred and "entry_points" not in keywords
        run.called_at = None if e is None else run.place(e.span)
    return Unknown("the result of setup()")


def glob_pattern(run: Run, args: list[Value], keywords: dict[str, Value], e: facts.Call | None) -> Value:
    """``glob(pattern)`` in a setup.py: the pattern stands for the files."""
    if isinstance(run, SetupRun) and args and isinstance(args[0], Known):
        return containers.new_list(run, [args[0]])
    return Unknown("the files that a pattern finds")


def _in_setup(function: Plain) -> Plain:
    """What only means something while a setup.py is read."""

    def handler(run: Run, args: list[Value], keywords: dict[str, Value], e: facts.Call | None) -> Value:
        if not isinstance(run, SetupRun):
            return Unknown("what only a setup.py asks for")
        return function(run, args, keywords, e)

    return handler


PLAIN: dict[str, Plain] = {
    "setuptools.setup": _in_setup(record_setup),
    "distutils.core.setup": _in_setup(record_setup),
    "glob.glob": _in_setup(glob_pattern),
    "glob.iglob": _in_setup(glob_pattern),
    "xml.etree.ElementTree.parse": _in_setup(manifest.element_tree),
    "defusedxml.ElementTree.parse": _in_setup(manifest.element_tree),
    "lxml.etree.parse": _in_setup(manifest.element_tree),
    "xml.dom.minidom.parse": _in_setup(manifest.document),
    "catkin_pkg.package.parse_package": _in_setup(manifest.package),
}
"""What is called, by its dotted name, and what that does."""
