"""``setup(…)`` as a setup.py calls it: what it is given is kept, and nothing is installed."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from fnmatch import translate
from glob import has_magic
from typing import TYPE_CHECKING

from archlint.interpreter import containers
from archlint.interpreter.values import Known, Unknown, Value
from archlint.libraries.run import Run
from archlint.libraries.setuptools import manifest
from archlint.libraries.setuptools.packages import Listing, found_packages
from archlint.name_paths import NamePattern, matches_names
from archlint.syntax.tree import span_of

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.interpreter.call_site import CallSite
    from archlint.libraries.api_use import Plain


NESTED_FOLDERS = 40
"""How many calls of one function run at a time: a helper goes through a folder, and the folders in it."""


class SetupRun(Run):
    """The symbolic run of a setup.py: what it calls ``setup`` with, and where."""

    allowed_nesting = NESTED_FOLDERS
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
    """``glob(pattern)`` in a setup.py: a pattern for the files of one folder stands for them, and one for several
    folders is looked up."""
    unknown = Unknown("the files that a pattern matches")
    recursive = site.keywords.get("recursive", Known(False))
    if not isinstance(run, SetupRun) or not site.args or "root_dir" in site.keywords:
        return unknown
    given = site.args[0]
    if not isinstance(given, Known) or given.text is None or not isinstance(recursive, Known):
        return unknown
    pattern = _with_single_stars(given.text, recursive=bool(recursive.value))
    if pattern.endswith("/"):
        if run.tree is None or pattern.startswith(("/", "../")):
            return unknown
        folders = _matching_folders(run.tree, run.folder, pattern)
        return containers.new_list(run, [replace(given, value=f"{path}/") for path in folders])
    folder, _, name = pattern.rpartition("/")
    if not has_magic(pattern) and run.tree is not None and _is_absent(run.tree, run.folder, pattern):
        return containers.new_list(run, [])  # of a name that is not there, glob() says nothing and the build goes on
    if not has_magic(folder) and name != "**":
        return containers.new_list(run, [replace(given, value=pattern)])
    if run.tree is None or pattern.startswith(("/", "../")):
        return unknown
    files = _matching(run.tree, run.folder, pattern)
    return containers.new_list(run, [replace(given, value=path) for path in files])


def _is_absent(tree: Listing, folder: str, path: str) -> bool:
    """Whether there is certainly no file or folder of a name below the folder of the setup.py."""
    parts = posixpath.normpath(path).split("/")
    if parts[0] in ("", ".."):
        return False
    return not any(
        posixpath.relpath(file, folder).split("/")[: len(parts)] == parts for file in tree.files_below(folder)
    )


def _with_single_stars(pattern: str, *, recursive: bool) -> str:
    """The same pattern with ``**`` only where that means any number of folders; everywhere else it means ``*``."""
    parts = pattern.split("/")
    return "/".join(part if recursive and part == "**" else re.sub(r"\*+", "*", part) for part in parts)


def _matching(tree: Listing, folder: str, pattern: str) -> list[str]:
    """The files that a pattern matches, by their paths below the folder of the setup.py."""
    names = _name_patterns(pattern)
    return sorted(path for path in _files_below(tree, folder) if matches_names(names, path.split("/")))


def _matching_folders(tree: Listing, folder: str, pattern: str) -> list[str]:
    """The folders that a pattern with a slash at its end matches, of those with any file in them."""
    names = _name_patterns(pattern)
    parts = [path.split("/") for path in _files_below(tree, folder)]
    folders = {tuple(each[:end]) for each in parts for end in range(1, len(each))}
    return sorted("/".join(each) for each in folders if matches_names(names, list(each)))


def _files_below(tree: Listing, folder: str) -> Iterator[str]:
    return (posixpath.relpath(path, folder) for path in tree.files_below(folder))


def _name_patterns(pattern: str) -> list[NamePattern | None]:
    """The patterns of a path, name by name; None for any number of folders."""
    return [None if part == "**" else _name_pattern(part) for part in posixpath.normpath(pattern).split("/")]


def _name_pattern(part: str) -> NamePattern:
    """A pattern for one name, whose wildcards do not stand for the dot of a hidden file."""
    visible = "" if part.startswith(".") else r"(?!\.)"
    return re.compile(visible + translate(part)).match


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
