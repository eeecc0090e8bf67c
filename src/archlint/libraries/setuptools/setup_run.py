"""``setup(…)`` as a setup.py calls it: what it is given is kept, and nothing is installed."""

from __future__ import annotations

import posixpath
from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.interpreter import containers
from archlint.interpreter.values import Known, Unknown, Value
from archlint.libraries.run import Run
from archlint.libraries.setuptools import manifest
from archlint.libraries.setuptools.packages import Listing, found_packages
from archlint.syntax.tree import span_of

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.interpreter.call_site import CallSite
    from archlint.libraries.api_use import Plain


class SetupRun(Run):
    """The symbolic run of a setup.py: what it calls ``setup`` with, and where."""

    keywords: dict[str, Value] | None = None
    open = False
    called_at: Place | None = None
    tree: Listing | None = None
    """The files of the workspace, for ``find_packages()``."""
    folder = "."
    """The shown path of the folder that the setup.py lies in."""
    packages_at: Place | None = None
    """Where ``packages=`` is written."""
    data_files_at: Place | None = None
    """Where ``data_files=`` is written."""
    package_dir_at: Place | None = None
    """Where ``package_dir=`` is written."""
    searches = False
    """Whether the code calls ``find_packages()``."""


def record_setup(run: Run, site: CallSite) -> Value:
    """A call of ``setup(…)``; what it is given is kept where a setup.py is read."""
    if isinstance(run, SetupRun) and (run.keywords is None or "entry_points" in site.keywords):
        # Of two calls (one for ROS 1, one for ROS 2) the one with entry points is that of ROS 2.
        run.keywords = dict(site.keywords)
        run.open = site.is_starred and "entry_points" not in site.keywords
        run.called_at = None if site.expression is None else run.place(site.expression.span)
        run.packages_at = _written_at(run, site, "packages")
        run.data_files_at = _written_at(run, site, "data_files")
        run.package_dir_at = _written_at(run, site, "package_dir")
    return Unknown("the result of setup()")


def _written_at(run: Run, site: CallSite, keyword: str) -> Place | None:
    """Where the value of a keyword is written."""
    arguments = [] if site.expression is None else site.expression.args
    return next((run.place(span_of(argument.value)) for argument in arguments if argument.keyword == keyword), None)


def glob_pattern(run: Run, site: CallSite) -> Value:
    """``glob(pattern)`` in a setup.py: the pattern stands for the files."""
    if isinstance(run, SetupRun) and site.args and isinstance(site.args[0], Known):
        return containers.new_list(run, [site.args[0]])
    return Unknown("the files that a pattern matches")


def find_packages(run: Run, site: CallSite) -> Value:
    """``find_packages(where, exclude, include)``."""
    return _packages(run, site, namespaces=False)


def find_namespace_packages(run: Run, site: CallSite) -> Value:
    """``find_namespace_packages(where, exclude, include)``."""
    return _packages(run, site, namespaces=True)


def _packages(run: Run, site: CallSite, *, namespaces: bool) -> Value:
    unknown = Unknown("the packages that find_packages() finds")
    if not isinstance(run, SetupRun):
        return unknown
    run.searches = True
    given = dict(zip(("where", "exclude", "include"), site.args, strict=False)) | site.keywords
    where = given.get("where", Known(".")).text
    include, exclude = _texts(run, given.get("include"), ("*",)), _texts(run, given.get("exclude"), ())
    if run.tree is None or site.open or where is None or include is None or exclude is None:
        return unknown
    start = posixpath.normpath(posixpath.join(run.folder, where))
    names = found_packages(run.tree, start, include, exclude, namespaces=namespaces)
    return containers.new_list(run, [Known(name) for name in names])


def _texts(run: Run, value: Value | None, default: Sequence[str]) -> Sequence[str] | None:
    """The patterns of an argument; None where one is not known."""
    if value is None:
        return default
    items = value.items(run)
    if items is None or items.open:
        return None
    texts = [item.text for item in items.values if item.text is not None]
    return texts if len(texts) == len(items.values) else None


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
    "setuptools.find_packages": _in_setup(find_packages),
    "setuptools.find_namespace_packages": _in_setup(find_namespace_packages),
    "glob.glob": _in_setup(glob_pattern),
    "glob.iglob": _in_setup(glob_pattern),
    "xml.etree.ElementTree.parse": _in_setup(manifest.element_tree),
    "defusedxml.ElementTree.parse": _in_setup(manifest.element_tree),
    "lxml.etree.parse": _in_setup(manifest.element_tree),
    "xml.dom.minidom.parse": _in_setup(manifest.document),
    "catkin_pkg.package.parse_package": _in_setup(manifest.package),
}
"""What is called, by its dotted name, and what that does."""
