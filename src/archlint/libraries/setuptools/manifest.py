"""A setup.py that reads its package's name from package.xml, by the libraries that are used for it."""

from __future__ import annotations

import posixpath
from collections.abc import Callable
from typing import TYPE_CHECKING

from archlint.interpreter import containers
from archlint.interpreter.values import External, Holed, Instance, Known, PythonValue, Unknown, Value

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.libraries.run import Run

MANIFEST = "package.xml"


def element_tree(run: Run, site: CallSite) -> Value:
    """``xml.etree.ElementTree.parse('package.xml')``: of the manifest its name is known."""
    if not _is_manifest(site.args):
        return Unknown("an XML file")
    name = _object(run, text=_name(run))

    def find(*values: Value, **_: Value) -> Value:
        return name if _asks_for_name(values) else Unknown("an element of package.xml")

    def findtext(*values: Value, **_: Value) -> Value:
        return _name(run) if _asks_for_name(values) else Unknown("a string of package.xml")

    root = _object(run, find=_function("find", find), findtext=_function("findtext", findtext))
    return _object(
        run,
        getroot=_function("getroot", lambda *_, **__: root),
        find=_function("find", find),
        findtext=_function("findtext", findtext),
    )


def document(run: Run, site: CallSite) -> Value:
    """``xml.dom.minidom.parse('package.xml')``."""
    if not _is_manifest(site.args):
        return Unknown("an XML file")
    text = _object(run, data=_name(run), nodeValue=_name(run))
    element = _object(run, firstChild=text, childNodes=containers.new_list(run, [text]))

    def elements(*values: Value, **_: Value) -> Value:
        value = containers.new_list(run, [element])
        return value if _asks_for_name(values) else Unknown("elements of package.xml")

    return _object(run, getElementsByTagName=_function("getElementsByTagName", elements))


def package(run: Run, site: CallSite) -> Value:
    """``catkin_pkg.package.parse_package('package.xml')``, which takes the folder as well."""
    return _object(run, name=_name(run))


def _name(run: Run) -> Value:
    name = run.program.package
    return Unknown("the name in package.xml") if name is None else Known(name)


def _is_manifest(args: list[Value]) -> bool:
    """Whether a path is that of the manifest; one that is not known is, for a setup.py reads no other XML file."""
    path = args[0] if args else None
    match path:
        case Holed(parts=parts):
            return (parts[-1] or "").endswith(MANIFEST)
        case Known(value=text):
            return posixpath.basename(str(text)) == MANIFEST
    return True


def _asks_for_name(values: tuple[Value, ...]) -> bool:
    return bool(values) and values[0].text in ("name", "./name", ".//name")


def _object(run: Run, **attributes: Value) -> Value:
    instance = Instance(External("xml.package"), run.store.new_key())
    for name, value in attributes.items():
        run.store.set(instance.key, name, value)
    return instance


def _function(name: str, function: Callable[..., Value]) -> Value:
    return PythonValue(name, function)
