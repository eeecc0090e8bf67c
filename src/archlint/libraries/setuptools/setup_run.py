"""``setup(…)`` as a setup.py calls it: what it is given is kept, and nothing is installed."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter import containers
from archlint.interpreter.values import Known, Unknown, Value
from archlint.libraries.run import Run
from archlint.libraries.setuptools import manifest

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.interpreter.call_site import CallSite
    from archlint.libraries.api_use import Plain


class SetupRun(Run):
    """The symbolic run of a setup.py: what it calls ``setup`` with, and where."""

    keywords: dict[str, Value] | None = None
    open = False
    called_at: Place | None = None


def record_setup(run: Run, site: CallSite) -> Value:
    """A call of ``setup(…)``; what it is given is kept where a setup.py is read."""
    if isinstance(run, SetupRun) and (run.keywords is None or "entry_points" in site.keywords):
        # Of two calls (one for ROS 1, one for ROS 2) the one with entry points is that of ROS 2.
        run.keywords = dict(site.keywords)
        run.open = site.is_starred and "entry_points" not in site.keywords
        run.called_at = None if site.expression is None else run.place(site.expression.span)
    return Unknown("the result of setup()")


def glob_pattern(run: Run, site: CallSite) -> Value:
    """``glob(pattern)`` in a setup.py: the pattern stands for the files."""
    if isinstance(run, SetupRun) and site.args and isinstance(site.args[0], Known):
        return containers.new_list(run, [site.args[0]])
    return Unknown("the files that a pattern matches")


def _in_setup(function: Plain) -> Plain:
    """What only means something while a setup.py is read."""

    def handler(run: Run, site: CallSite) -> Value:
        if not isinstance(run, SetupRun):
            return Unknown("a value that only setup.py uses")
        return function(run, site)

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
