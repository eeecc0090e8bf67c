"""What commands have said, kept with the state of all that it came from, to say it again while that is the same.

Each start comes through here, so nothing is imported that Python has not loaded by itself.  An answer is found by the
words of the command and by where it was given, and counts only if everything that the run looked at is as it was:
files and folders by their stamps, what lies above them by its kind.  :mod:`archlint.engine.keeper` says what that is.
"""

from __future__ import annotations

import os
import stat
import sys
import time
from _blake2 import blake2b

from archlint import __version__
from archlint.syntax.secret import known_key
from archlint.syntax.signed import CACHE_FOLDER, read_signed, version_folder

TYPE_CHECKING = False
if TYPE_CHECKING:  # typing takes as long to import as all that is done here
    from collections.abc import Callable, Iterable, Iterator, Sequence

ANSWERED = ("check", "graph", "show", "trace", "impact")
"""Those whose answers are kept."""
_FORM = "1"
"""Of the file of an answer; it changes with the fields."""
_DAY_NS = 24 * 3600 * 10**9


class Answer:
    """What a command says: ``text`` on standard output, ``warnings`` and then ``notes`` on standard error."""

    __slots__ = ("notes", "status", "text", "warnings")

    def __init__(self, text: str, warnings: str, notes: str, status: int) -> None:
        self.text, self.warnings, self.notes, self.status = text, warnings, notes, status

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Answer) and self._fields() == other._fields()

    def __hash__(self) -> int:
        return hash(self._fields())

    def _fields(self) -> tuple[str, str, str, int]:
        return self.text, self.warnings, self.notes, self.status


class State:
    """How some places of the disk are: ``stamped`` with their content, ``placed`` only as far as they are there,
    ``folder`` with the names in it but for one."""

    __slots__ = ("fields",)

    def __init__(self, stamped: Sequence[str], stamps: str, placed: Sequence[str], kinds: str, names: Names) -> None:
        self.fields = ["\0".join(stamped), stamps, "\0".join(placed), kinds, *names.fields]

    @staticmethod
    def holds(fields: Sequence[str]) -> bool:
        """Whether a state that was kept is that of the disk now."""
        stamped, stamps, placed, kinds, folder, without, names = fields
        return (
            names_in(folder, without) == names
            and kinds_of(placed.split("\0")) == kinds
            and stamps_of(stamped.split("\0")) == stamps
        )


class Names:
    """The names in a folder, but for that of the cache, which comes and goes."""

    __slots__ = ("fields",)

    def __init__(self, folder: str = "", without: str = "") -> None:
        self.fields = [folder, without, names_in(folder, without)]

    @property
    def folder(self) -> str:
        return self.fields[0]

    def again(self) -> Names:
        return Names(*self.fields[:2])


def known_answer(words: Sequence[str], terminal: Sequence[str]) -> Answer | None:
    """What a command said when all was as it is now; None where that is not known."""
    if not can_be_kept(words):
        return None
    paths = _paths_in(words)
    key = known_key(paths)
    if key is None:
        return None
    name = name_of(words, terminal)
    for root in roots(words, paths):
        payload = _read(root, name, key)
        fields = None if payload is None else _unpacked(payload)
        if fields is not None:
            text, warnings, notes, status, day, *state = fields
            return Answer(text, warnings, notes, int(status)) if day == _today() and State.holds(state) else None
    return None


def payload_of(answer: Answer, state: State) -> bytes:
    """What is kept of an answer.  It counts for a day: after that the entries of its files are asked for again."""
    fields = [answer.text, answer.warnings, answer.notes, str(answer.status), _today(), *state.fields]
    encoded = [field.encode("utf-8", "surrogatepass") for field in fields]
    return " ".join(str(len(field)) for field in encoded).encode() + b"\n" + b"".join(encoded)


def can_be_kept(words: Sequence[str]) -> bool:
    """Whether an answer to a command may count at all: on Windows the time of a status change is none."""
    return os.name == "posix" and "--" not in words


def name_of(words: Sequence[str], terminal: Sequence[str]) -> str:
    """The name of the answer to a command that is given here, by this user, to this Python."""
    places = [os.getcwd(), os.path.expanduser("~"), *map(os.path.realpath, _paths_in(words))]
    python = [sys.version, sys.prefix, sys.getfilesystemencoding()]
    decisive = [_FORM, list(words), places, python, list(terminal)]
    return blake2b(repr(decisive).encode("utf-8", "surrogatepass"), digest_size=32).hexdigest()


def roots(words: Sequence[str], paths: Iterable[str] | None = None) -> Iterator[str]:
    """Where the cache of a command may be: the folder of ``--cache-dir``, else one beside or above its paths."""
    for number, word in enumerate(words):
        name, equals, value = word.partition("=")
        if name == "--cache-dir":
            yield value if equals else "".join(words[number + 1 : number + 2])
            return
    for path in (".", *(_paths_in(words) if paths is None else paths)):
        folder = os.path.abspath(path)
        while True:
            yield os.path.join(folder, CACHE_FOLDER)
            if folder == os.path.dirname(folder):
                break
            folder = os.path.dirname(folder)


def stamps_of(paths: Iterable[str]) -> str:
    """What changes with the content of files, and with the names in folders; a line each."""
    return _rows(
        paths,
        lambda status: f"{status.st_mtime_ns} {status.st_ctime_ns} {status.st_size} {status.st_ino}",
        lambda path: "",
    )


def kinds_of(paths: Iterable[str]) -> str:
    """Whether something is at some paths, and what; a line each."""
    return _rows(
        paths,
        lambda status: f"{stat.S_IFMT(status.st_mode)} {status.st_ino}",
        lambda path: "@" * os.path.islink(path),
    )


def _rows(paths: Iterable[str], there: Callable[[os.stat_result], str], missing: Callable[[str], str]) -> str:
    """A line for each path: what is said of something that is there, or why not, and what is said of a path then."""
    rows = []
    for path in paths:
        try:
            rows.append(there(os.stat(path)))
        except OSError as error:
            rows.append(f"-{error.errno}{missing(path)}")
    return "\n".join(rows)


def names_in(folder: str, without: str) -> str:
    """The names in a folder with their kinds, but for one."""
    if not folder:
        return ""
    try:
        with os.scandir(folder) as entries:
            rows = [
                f"{entry.name}\0{entry.is_symlink():d}{entry.is_dir(follow_symlinks=False):d}"
                for entry in entries
                if entry.name != without
            ]
    except OSError as error:
        return f"-{error.errno}"
    return "\n".join(sorted(rows))


def _paths_in(words: Sequence[str]) -> list[str]:
    """What a command may mean as the paths that it is about, without knowing its options: rather too many."""
    paths, before, certain = [], "", False
    for word in words[1:] if words and words[0] in ANSWERED else words:
        if not word.startswith("-") and os.path.exists(word):
            paths.append(word)
            certain |= not before.startswith("-")  # else it may be the value of an option
        before = word
    return paths if certain else [*paths, "."]


def _read(root: str, name: str, key: bytes) -> bytes | None:
    folder = os.path.join(root, version_folder(__version__))
    payload = read_signed(folder, os.path.join("answers", name), key)
    is_linked = payload is not None and any(map(os.path.islink, (root, folder, os.path.join(folder, "answers"))))
    return None if is_linked else payload


def _unpacked(payload: bytes) -> list[str] | None:
    header, _, rest = payload.partition(b"\n")
    fields = []
    try:
        for length in map(int, header.split()):
            fields.append(rest[:length].decode("utf-8", "surrogatepass"))
            rest = rest[length:]
    except ValueError:
        return None
    return fields


def _today() -> str:
    return str(time.time_ns() // _DAY_NS)
