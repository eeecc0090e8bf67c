"""Which files are test code, try something out or are put aside: by the names of their folders and their own."""

from __future__ import annotations

import posixpath
import re
import unicodedata
from collections.abc import Iterable, Sequence
from functools import lru_cache

from archlint.records import dataclass

_TRIES_OUT = frozenset({"test", "tests", "testing", "mock", "mocks", "mocked", "dummy", "dummies"}) | {
    *("fake", "fakes", "stub", "stubs", "fixture", "fixtures"),
}
_PUT_ASIDE = frozenset({"archive", "archived", "archives", "attic", "backups", "deprecated", "legacy", "obsolete"}) | {
    *("archieve", "archieved", "old", "outdated", "unused"),
}
"""Among them a spelling that one meets as often as the right one."""
_IN_OTHER_LANGUAGES = (
    r"obsolet[oa]s?|viej[oa]s?|antigu[oa]s?|vecchi[oa]?|veraltet|ungenutzt|inutilisee?s?|anciens?"
    r"|n(?:o|ao)[ _-]?usad[oa]s?|sin[ _-]usar|sem[ _-]uso|non[ _-]usat[oiae]|nicht[ _-]benutzt"
)
"""In small letters, without accents."""
_NOT_TO_USE = rf"not[ _-]?used|(?:do[ _-]?not|don'?t)[ _-]?use|{_IN_OTHER_LANGUAGES}"
_NAMED_OLD = re.compile(
    r"(?:old|archived|deprecated)_.+|.+_(?:old|archived?|deprecated|back_?up|bak|bkp|bkup|unused)|_old"
    rf"|(?:.+[ _-])?not[ _-]?used|{_NOT_TO_USE}"
)
_MARKED = re.compile(rf"[(\[](?:archived?|backup|deprecated|obsolete|old|unused|{_NOT_TO_USE})[)\]]")
_COPY = re.compile(
    r"\(copy|[ _.-]copy\d*\W|^copy[ _-](?:\d+[ _-])?of[ _-]|sync-conflict-|\(\d+\)"
    r"|[ _.-](?:bak|backup|bk|bkp|bkup|old|orig|unused)\.|[ _.-](?:archived?|deprecated|obsolete)\.py$"
)
_RETIRED = re.compile(r"(?:old|archived|deprecated|unused)_(?=.*\.py$)(?!.*\.launch\.py$)", re.IGNORECASE)


@dataclass(frozen=True)
class FileRoles:
    """What the files of one workspace are for.

    ``below`` is where the workspace lies, as its files' paths begin, or empty: a folder called ``tests`` above it makes
    nothing a test.
    """

    below: str = ""
    programs: frozenset[str] = frozenset()
    """The files that packages install as programs: one in no folder of tests is a node, whatever its name."""

    @classmethod
    def of(cls, paths: Iterable[str]) -> FileRoles:
        """The roles of these files, below the folder that all of them lie in."""
        return cls(common_folder(list(paths)))

    def is_test(self, path: str) -> bool:
        """Whether a file is test code: in a folder ``test`` or ``tests`` of the workspace, or named like a test and not
        installed as a program."""
        below = self._below_workspace(path)
        return _is_test(below) and (path not in self.programs or _is_in_folder_of_tests(below))

    def is_trial(self, path: str) -> bool:
        """Whether a file is test code, or replaces something (a mock), or tries it out, by a word in its own name or in
        that of a folder of the workspace: ``mock_robot.py``, ``quick_tests/``, ``test2.py``."""
        return self.is_test(path) or _tries_out(self._below_workspace(path))

    def is_put_aside(self, path: str) -> bool:
        """Whether a file is kept, and no longer worked on: by the name of a folder of the workspace, by words in
        brackets (``(unused)robot/``, ``robot (no usado)/``), or because it is a copy that nothing can import, such as
        ``driver (copy).py`` or ``driver.sync-conflict-20260323.py``."""
        return _is_put_aside(self._below_workspace(path))

    @staticmethod
    def successor_of(path: str) -> str | None:
        """The file that has taken the place of another if it is there, by the name of that one: ``driver.py`` of
        ``old_driver.py``; None for a name of another kind.  A launch file may be started by hand."""
        folder, name = posixpath.split(path)
        word = _RETIRED.match(name)
        return None if word is None else posixpath.join(folder, name[word.end() :])

    def _below_workspace(self, path: str) -> str:
        return path.removeprefix(self.below.rstrip("/") + "/" if self.below not in ("", ".") else "")


@lru_cache(maxsize=50_000)  # asked of each call that programs make
def _is_test(path: str) -> bool:
    stem = path.rpartition("/")[2].removesuffix(".py")
    named = stem.startswith("test_") or stem.endswith("_test") or stem == "conftest"
    return named or _is_in_folder_of_tests(path)


@lru_cache(maxsize=50_000)
def _tries_out(path: str) -> bool:
    words = (re.split(r"\d*[\W_]+|\d*$", part) for part in path.removesuffix(".py").lower().split("/"))
    return any(not _TRIES_OUT.isdisjoint(each) for each in words)


@lru_cache(maxsize=50_000)
def _is_put_aside(path: str) -> bool:
    *folders, name = [_plain(part).lstrip("_.") for part in path.split("/")]
    old = any(folder in _PUT_ASIDE or _NAMED_OLD.fullmatch(folder) for folder in folders)
    marked = any(_MARKED.search(part) for part in (*folders, name))
    return old or marked or _COPY.search(name) is not None


def _plain(name: str) -> str:
    """A name in small letters without accents."""
    letters = name.lower()
    if letters.isascii():
        return letters
    return "".join(each for each in unicodedata.normalize("NFKD", letters) if not unicodedata.combining(each))


def _is_in_folder_of_tests(path: str) -> bool:
    return any(folder in ("test", "tests") for folder in path.split("/")[:-1])


def common_folder(paths: Sequence[str]) -> str:
    """The folder that all paths lie in."""
    folders = [path.split("/")[:-1] for path in paths]
    if not folders:
        return ""
    first, last = min(folders), max(folders)
    shared = 0
    while shared < min(len(first), len(last)) and first[shared] == last[shared]:
        shared += 1
    return "/".join(first[:shared])
