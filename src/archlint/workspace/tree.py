"""Reads files of the workspace by the paths that findings show, and nothing outside of it."""

from __future__ import annotations

import errno
import hashlib
import os
import posixpath
import re
import stat
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Protocol

from archlint.disk import read_regular, walk
from archlint.workspace.around import is_below
from archlint.workspace.text_questions import about_lines, about_pattern, digest_of_part, is_about_part, part_of
from archlint.workspace.tracked import Tracked, never_checked_out, repository_around
from archlint.workspace.words import Words

if TYPE_CHECKING:
    from archlint.workspace.model import SourceFile

TEXT_LIMIT = 8_000_000
"""Bytes; a launch or parameter file that is larger is not read."""
_REMEMBERED = 32_000_000
"""Bytes of files that are remembered, so that who asks again need not read them again."""
ENTRIES = 20_000
"""How many files one folder listing may name."""


Question = tuple[str, str]
"""What is asked of a path, and the path."""


class Tree(Protocol):
    """The files of a workspace by shown paths."""

    @property
    def words(self) -> Words: ...

    @cached_property
    def top(self) -> str: ...

    def text(self, path: str) -> str | None: ...

    def lines(self, path: str, first: int, last: int) -> list[str]: ...

    def lines_with(self, path: str, pattern: str) -> list[tuple[int, str]]: ...

    def unreadable(self, path: str) -> str | None: ...

    def is_file(self, path: str) -> bool: ...

    def is_folder(self, path: str) -> bool: ...

    def is_only_in_git(self, path: str) -> bool: ...

    def files_below(self, folder: str) -> Sequence[str]: ...

    def read_again(self, path: str) -> None: ...

    def same_file(self, path: str, files: Iterable[SourceFile]) -> SourceFile | None: ...


class _NoFiles:
    """A tree without files."""

    @property
    def words(self) -> Words:
        return Words(lambda path: None)

    @cached_property
    def top(self) -> str:
        return "."

    def text(self, path: str) -> str | None:
        return None

    def lines(self, path: str, first: int, last: int) -> list[str]:
        return []

    def lines_with(self, path: str, pattern: str) -> list[tuple[int, str]]:
        return []

    def unreadable(self, path: str) -> str | None:
        return None

    def is_file(self, path: str) -> bool:
        return False

    def is_folder(self, path: str) -> bool:
        return False

    def is_only_in_git(self, path: str) -> bool:
        return False

    def files_below(self, folder: str) -> Sequence[str]:
        return ()

    def read_again(self, path: str) -> None:
        return None

    def same_file(self, path: str, files: Iterable[SourceFile]) -> SourceFile | None:
        return None


NO_FILES: Tree = _NoFiles()


_Stamp = tuple[int, int, int, int]
"""Where a file lies on the disk, when it was changed, and its size."""


def _stamp(path: str) -> _Stamp | None:
    try:
        status = os.stat(path)
    except (OSError, ValueError):
        return None
    return status.st_dev, status.st_ino, status.st_mtime_ns, status.st_size


class _Remembered:
    """What was read of files that are as they were then."""

    def __init__(self) -> None:
        self._rows: dict[str, tuple[_Stamp, bytes]] = {}
        self._size = 0

    def get(self, path: str, stamp: _Stamp | None) -> bytes | None:
        known = self._rows.get(path)
        return known[1] if known is not None and known[0] == stamp else None

    def keep(self, path: str, stamp: _Stamp | None, data: bytes) -> bool:
        """Remember a file that had this stamp before it was read; True where all others are forgotten for it."""
        if stamp is None:
            return False
        self._size += len(data)
        is_full = self._size > _REMEMBERED
        if is_full:
            self._rows.clear()
            self._size = len(data)
        self._rows[path] = stamp, data
        return is_full


def _digest_of(paths: Iterable[bytes]) -> str:
    """Of what a checkout never had, and not of its index: git writes that anew for other reasons, too."""
    return hashlib.sha256(b"\0".join(paths)).hexdigest()


_OF_CACHES = "CACHEDIR.TAG"
"""The file by which programs know the folder of a cache.  Source: https://bford.info/cachedir/"""


class SourceTree:
    """The files below one folder.  Paths are relative to it, with ``/``; a path that leads out of ``within``
    does not exist as far as this class is concerned.

    Where ``within`` is only what folders far from each other have in common, such as a home folder, ``inside`` are
    these: what is beside them does not exist, either.
    """

    def __init__(self, base: Path, within: Path | None = None, inside: Iterable[str] = ()) -> None:
        self.base = base
        self._within = os.path.realpath(within or base)
        self._inside = tuple(dict.fromkeys(map(os.path.realpath, inside)))
        self._real_folders: dict[str, str] = {}
        """The paths of folders without symbolic links: each is asked for all folders around it."""
        self._listed: dict[str, list[str]] = {}
        self._read = _Remembered()
        self._repositories: dict[str, Tracked] = {}
        """By the index of each."""
        self._decoded: dict[str, tuple[bytes, str]] = {}
        """The text of what was read last, by path."""
        self.asked: dict[Question, str | None] = {}
        """Every answer that was given, by question and path, for whoever keeps what follows from them."""
        self.words = Words(lambda path: self._text(path, "words"))
        self._tell: Callable[[Question, str | None], None] | None = None

    @cached_property
    def top(self) -> str:
        """The folder of all the files: not the working directory where that is above it or below."""
        return os.path.relpath(self._within, os.path.realpath(self.base)).replace(os.sep, "/")

    def _real(self, path: str) -> Path | None:
        if "\0" in path:
            return None
        folder, name = os.path.split(os.path.join(self.base, path))
        if folder not in self._real_folders:
            self._real_folders[folder] = os.path.realpath(folder)
        real = os.path.join(self._real_folders[folder], name)
        if name in ("", os.curdir, os.pardir) or os.path.islink(real):
            real = os.path.realpath(real)
        return Path(real) if is_below(real, self._within) and self._leads_inside(real) else None

    def is_file(self, path: str) -> bool:
        return self._kind(path) == "file"

    def is_folder(self, path: str) -> bool:
        return self._kind(path) == "folder"

    def is_only_in_git(self, path: str) -> bool:
        """Whether git has a file, or files of a folder, that were never put into this checkout: a clone has them."""
        real = self._real(path)
        repository = None if real is None or real.exists() else repository_around(str(real))
        if repository is None:
            return False
        index = os.path.relpath(repository.index, os.path.realpath(self.base)).replace(os.sep, "/")
        repository = self._repositories.setdefault(index, repository)
        self._note(("index", index), _digest_of(repository.never_checked_out))
        return repository.has_elsewhere(str(real))

    def _kind(self, path: str) -> str | None:
        question = "kind", path
        kind = self.asked[question] if question in self.asked else self._kind_now(path)  # the first answer holds
        self._note(question, kind)
        return kind

    def _kind_now(self, path: str) -> str | None:
        real = self._real(path)
        try:
            mode = 0 if real is None else real.stat().st_mode
        except OSError:
            return None
        return "file" if stat.S_ISREG(mode) else "folder" if stat.S_ISDIR(mode) else None

    def _note(self, question: Question, answer: str | None) -> None:
        answer = self.asked.setdefault(question, answer)
        if self._tell is not None:
            self._tell(question, answer)

    @contextmanager
    def telling(self, tell: Callable[[Question, str | None], None]) -> Iterator[None]:
        """Report each question that is asked inside, with its first answer."""
        before, self._tell = self._tell, tell
        try:
            yield
        finally:
            self._tell = before

    def read_again(self, path: str) -> None:
        """Somebody goes by the text of a file that was read before."""
        if ("content", path) in self.asked:
            self._note(("content", path), None)

    def text(self, path: str) -> str | None:
        """A regular file's text; None where there is none, it is too large, or it cannot be decoded: XML by the
        encoding that it names, all else as UTF-8."""
        return self._text(path, "content")

    def lines(self, path: str, first: int, last: int) -> list[str]:
        """Some lines of a file's text, from 1, as far as there are any: who needs no others does not ask for all."""
        return [line for _, line in self._part(about_lines(first, last), path)]

    def lines_with(self, path: str, pattern: str) -> list[tuple[int, str]]:
        """The lines of a file's text that have something which a regular expression matches, with their numbers."""
        return self._part(about_pattern(pattern), path)

    def _part(self, question: str, path: str) -> list[tuple[int, str]]:
        text = self._text(path, None)
        part = None if text is None else part_of(question, text)
        self._note((question, path), digest_of_part(part))
        return part or []

    def _text(self, path: str, question: str | None) -> str | None:
        """The text, which is noted as the answer to a question if there is one."""
        try:
            data = self._content(path, question)
            if data is None:
                return None
            if path not in self._decoded or self._decoded[path][0] is not data:
                self._decoded[path] = data, decoded(data)
            return self._decoded[path][1]
        except (OSError, UnicodeDecodeError):
            return None

    def unreadable(self, path: str) -> str | None:
        """Why a file that is there has no :meth:`text`; None where it has one, or is not there."""
        try:
            data = self._content(path)
            if data is not None:
                decoded(data)
        except OSError as error:
            if error.errno == errno.EFBIG:
                return f"the file is too large to analyse: the limit is {TEXT_LIMIT // 1000} kB"
            return f"cannot read this file: {error.strerror or error}"
        except UnicodeDecodeError as error:
            return f"byte 0x{error.object[error.start]:02x} is not valid {error.encoding}: save the file as UTF-8"
        return None

    def _content(self, path: str, question: str | None = "content") -> bytes | None:
        """The bytes of a regular file; None where there is none.  Raises ``OSError``."""
        if question is None:
            return self._content_now(path)
        try:
            data = self._content_now(path)
        except OSError as error:
            self._note((question, path), f"error {error.errno}")
            raise
        is_new = data is not None and (question, path) not in self.asked  # the first answer holds
        self._note((question, path), hashlib.sha256(data or b"").hexdigest() if is_new else None)
        return data

    def _content_now(self, path: str) -> bytes | None:
        stamp = _stamp(os.path.join(self.base, path))
        data = self._read.get(path, stamp)
        if data is None:
            real = self._real(path)
            data = None if real is None or not real.is_file() else read_regular(real, TEXT_LIMIT)
            if data is not None and self._read.keep(path, stamp, data):
                self._decoded.clear()
        return data

    def given(self, path: str) -> bytes | None:
        """The bytes of a file of a tree that is not on the disk; None for one that is."""
        return None

    def answer(self, question: str, path: str) -> str | None:
        """What :attr:`asked` would hold if the question were asked now, for the first time."""
        return SourceTree(self.base, Path(self._within), self._inside).ask((question, path))

    def ask(self, question: Question) -> str | None:
        """The first answer to a question in this run."""
        kind, path = question
        if question in self.asked:
            pass
        elif kind in ("content", "words"):
            self._text(path, kind)
        elif is_about_part(kind):
            self._part(kind, path)
        elif kind == "listing":
            self.files_below(path)
        elif kind == "index":
            self._note(question, _digest_of(never_checked_out(os.path.join(os.path.realpath(self.base), path))))
        else:
            self.is_file(path)
        return self.asked.get(question)

    def same_file(self, path: str, files: Iterable[SourceFile]) -> SourceFile | None:
        """The file that a path leads to through symbolic links; None where that is none of ``files``."""
        real = self._real(path)
        if real is None:
            return None
        try:
            inode = real.stat().st_ino
        except OSError:
            return None
        candidates = (file for file in files if file.inode == inode)
        return next((file for file in candidates if os.path.realpath(file.path) == str(real)), None)

    def files_below(self, folder: str) -> list[str]:
        """All files below a folder, sorted; links to folders are not followed."""
        folder = posixpath.normpath(folder)
        if folder not in self._listed:
            files = self._listed[folder] = self._list(folder)
            listing = "\n".join(files).encode("utf-8", "surrogateescape")
            self.asked.setdefault(("listing", folder), hashlib.sha256(listing).hexdigest())
        self._note(("listing", folder), None)
        return self._listed[folder]

    def _list(self, folder: str) -> list[str]:
        real = self._real(folder)
        files: list[str] = []
        if real is None:
            return files
        for top, folders, names in walk(real):
            if _OF_CACHES in names:  # archlint's own may lie anywhere, and changes with each run
                folders.clear()
                continue
            folders[:] = sorted(name for name in folders if not name.startswith((".", "__pycache__")))
            if not self._is_inside(top):
                names = []
                folders[:] = [name for name in folders if self._leads_inside(os.path.join(top, name))]
            below = Path(top).relative_to(real).as_posix()
            for name in names:
                files.append(posixpath.normpath(posixpath.join(folder, below, name)))
            if len(files) > ENTRIES:
                break
        return sorted(files)

    def _is_inside(self, folder: str) -> bool:
        return not self._inside or any(is_below(folder, each) for each in self._inside)

    def _leads_inside(self, folder: str) -> bool:
        return self._is_inside(folder) or any(is_below(each, folder) for each in self._inside)


_XML_ENCODING = re.compile(
    rb"""\s*<\?xml[^>]*\sencoding\s*=\s*["'](iso-8859-1|iso-8859-15|windows-1252)["']""", re.IGNORECASE
)


def decoded(data: bytes) -> str:
    """Raises ``UnicodeDecodeError``."""
    named = _XML_ENCODING.match(data)
    return data.decode("utf-8-sig" if named is None else named[1].decode("ascii"))
