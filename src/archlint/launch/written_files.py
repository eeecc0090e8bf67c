"""Files that code of a launch file writes: what is in them is known where it is known what is written."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter import containers
from archlint.interpreter.values import NONE, External, Instance, Known, Unknown, Value, reason
from archlint.launch import file_texts
from archlint.launch.named_files import path_made_by_launch
from archlint.launch.objects import argument, known_text

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.launch.run import LaunchRun

WRITTEN_FILE = "tempfile.NamedTemporaryFile"
"""The class of an open file that is written, whatever opened it."""
_TEXT = "#text"
"""Where the store has what has been written."""


def written_file(run: LaunchRun, path: str) -> Instance:
    """A new file that is open for writing."""
    file = Instance(External(WRITTEN_FILE), run.store.new_key(), None, {"path": Known(path)})
    run.store.set(file.key, _TEXT, Known(""))
    run.written_files[path] = file
    return file


def _temporary(run: LaunchRun, site: CallSite) -> Instance:
    """``tempfile.NamedTemporaryFile('w', …)``: a file whose name is made up."""
    return written_file(run, path_made_by_launch(len(run.written_files) + len(run.made_files) + 1))


def _opened_output(run: LaunchRun, site: CallSite) -> Value:
    """``xacro.open_output(path)``: the file, open for writing."""
    path = known_text(site.args[0]) if site.args else None
    return Unknown("a file") if path is None else written_file(run, path)


def _folder(run: LaunchRun, site: CallSite) -> Value:
    """``tempfile.gettempdir()``: which folder it is, the machine says; what is written there is known."""
    return Known(path_made_by_launch())


def _descriptor_and_path(run: LaunchRun, site: CallSite) -> Value:
    """``tempfile.mkstemp()``."""
    file = _temporary(run, site)
    return containers.new_list(run, [file, name_of(file)], "tuple")


def _opened_descriptor(run: LaunchRun, site: CallSite) -> Value:
    """``os.fdopen(descriptor, 'w')``."""
    return site.args[0] if site.args and is_written_file(site.args[0]) else Unknown("a file")


def is_written_file(value: Value | None) -> bool:
    return isinstance(value, Instance) and isinstance(value.cls, External) and value.cls.path == WRITTEN_FILE


def name_of(file: Instance) -> Value:
    """``file.name``."""
    return argument(file, "path") or Unknown("the name of a file")


def write(run: LaunchRun, file: Value, text: Value) -> None:
    """Add a text at the end of a file that is written."""
    if not isinstance(file, Instance):
        return
    before, more = run.store.get(file.key, _TEXT), known_text(text)
    known = before.text if isinstance(before, Value) else None
    known_more = known is not None and more is not None
    run.store.set(file.key, _TEXT, Known(f"{known}{more}") if known_more else Unknown(reason(text)))


def _write(run: LaunchRun, receiver: Value, site: CallSite) -> Value:
    text = file_texts.text_in(run, site.args[0]) if site.args else Unknown("what is written to a file")
    write(run, receiver, Known(text) if isinstance(text, str) else text)
    return Unknown("how much is written")


def _nothing(run: LaunchRun, receiver: Value, site: CallSite) -> Value:
    return NONE


def content(run: LaunchRun, path: str) -> Value | None:
    """The text of a file that the launch writes; None of any other file."""
    file = run.written_files.get(path)
    text = None if file is None else run.store.get(file.key, _TEXT)
    return text if isinstance(text, Value) else None


PLAIN = {
    "tempfile.gettempdir": _folder,
    "tempfile.NamedTemporaryFile": _temporary,
    "tempfile.mkstemp": _descriptor_and_path,
    "os.fdopen": _opened_descriptor,
    "xacro.open_output": _opened_output,
}
METHODS = {
    f"{WRITTEN_FILE}.write": _write,
    **dict.fromkeys((f"{WRITTEN_FILE}.{name}" for name in ("close", "flush")), _nothing),
}

__all__ = ["METHODS", "PLAIN", "content", "is_written_file", "name_of", "write", "written_file"]
