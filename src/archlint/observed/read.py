"""Reads a file that describes a running system, whichever of the known forms it has."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from typing import Any

from archlint.observed import forms
from archlint.observed.forms import NotOfThisForm, ObservedFile
from archlint.observed.model import Observed
from archlint.syntax.safe_yaml import YamlError, YamlReader

LARGEST = 64_000_000
"""Bytes; a graph of a thousand nodes has about five million."""

_KNOWN = (
    "expected a recording (`archlint observe --print-script`), the metadata.yaml of a bag or a Graph message of "
    "rosgraph_monitor_msgs or rosgraph_msgs"
)


class CannotRead(Exception):
    """The file is of no use; ``str()`` says why, with the file's name."""


def read(path: str) -> Observed:
    """What a file says; of a folder its ``metadata.yaml``.  Raises :class:`CannotRead`."""
    file = Path(path, "metadata.yaml") if Path(path).is_dir() else Path(path)
    content = _content(file)
    shown = file.as_posix()
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise CannotRead(f"{shown} is not text: {_KNOWN}") from None
    data = _data(shown, text)
    digest = hashlib.sha256(content).hexdigest()
    try:
        return forms.observed(data, ObservedFile(shown, text, digest))
    except NotOfThisForm:
        raise CannotRead(f"{shown} cannot be compared: {_KNOWN}") from None
    except forms.Malformed as error:
        raise CannotRead(f"{shown}: {error}") from None


def _content(file: Path) -> bytes:
    try:
        with file.open("rb") as stream:  # a pipe, too, as a shell makes one of `<(ros2 topic echo ...)`
            content = stream.read(LARGEST + 1)
    except OSError as error:
        raise CannotRead(f"cannot read {file.as_posix()}: {error.strerror}") from None
    if len(content) > LARGEST:
        raise CannotRead(f"{file.as_posix()} is too large to be a recording of a graph")
    return content


def _data(shown: str, text: str) -> Any:
    """The document, the last one of several: a topic that is echoed gives a message each time it changes."""
    if text.lstrip()[:1] in ("{", "["):
        return _json(shown, text)
    try:
        reader = YamlReader(text, several=True)
        values = [reader.value(root) for root in reader.roots]
    except YamlError as error:
        raise CannotRead(f"{shown}:{error.line}:{error.column}: {error.message}") from None
    return next((value for value in reversed(values) if value is not None), None)


def _json(shown: str, text: str) -> Any:
    try:
        decoder, at, value = json.JSONDecoder(), 0, None
        while rest := text[at:].lstrip():
            value, at = decoder.raw_decode(text, len(text) - len(rest))
        return value
    except json.JSONDecodeError as error:
        raise CannotRead(f"{shown}:{error.lineno}:{error.colno}: malformed JSON: {error.msg}") from None
    except RecursionError:
        raise CannotRead(f"{shown}: nested too deeply") from None
    except ValueError:
        raise CannotRead(f"{shown}: a number in it has too many digits") from None
