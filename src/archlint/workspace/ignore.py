"""What git ignores: ``.gitignore`` files, each for its folder, and ``.git/info/exclude``; nothing that git tracks.

The ``info/exclude`` of a linked worktree lies in another repository, outside of what is checked, and is not read.
pathspec does the matching, and is imported only where there is a pattern.
"""

from __future__ import annotations

import os
import re
import warnings
from collections.abc import Callable, Set
from dataclasses import replace

from archlint.records import dataclass
from archlint.workspace.pruning import COLCON_FOLDERS
from archlint.workspace.starred import StarredPattern, has_many_stars
from archlint.workspace.tracked import Tracked

GITIGNORE = ".gitignore"
_MAX_CHARACTERS = 1_000_000
_LONGEST = 4096
"""Characters of a pattern: no path is longer, and an expression for more takes long to be made."""

_ALL_BELOW = re.compile(r"(?:/\*\*)+(/?)\s*$")
"""``a/**`` is for what is in ``a``; pathspec takes it for ``a``, too."""


class Rule:
    """One line of a pattern file: ``speaks_of`` says whether it is about a very path, and not just about a folder that
    the path is in.  The path of a folder ends in ``/``; of a rule for names it is the name alone."""

    def __init__(self, line: str) -> None:
        """Raises ``ValueError`` or ``re.error`` for what git would not take."""
        self.is_for_names = "/" not in line.rstrip().rstrip("/")
        all_below = _ALL_BELOW.sub(r"/**/*\1", line)
        self.ignores, self.speaks_of = (_of_many_stars if has_many_stars(all_below) else _of_library)(all_below)


def _of_many_stars(line: str) -> tuple[bool, Callable[[str], bool]]:
    pattern = StarredPattern(line)
    return pattern.ignores, pattern.speaks_of


def _of_library(line: str) -> tuple[bool, Callable[[str], bool]]:
    """Whether a pattern ignores, and whether it speaks of a path."""
    from pathspec import GitIgnoreSpec

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of the re module, about what a pattern becomes
        [pattern] = GitIgnoreSpec.from_lines([line]).patterns
    if pattern.include is None:
        raise ValueError(f"{line!r} is no pattern")
    match_file = pattern.match_file

    def speaks_of(path: str) -> bool:
        result = match_file(path)
        if result is None:
            return False
        # A group of the expression holds the slash that ends the folder that was matched.
        match = result.match
        return all(end in (-1, len(path)) for end in map(match.end, match.re.groupindex))

    return pattern.include, speaks_of


class Patterns:
    """The rules of one file, for paths below ``folder``.  The last one that speaks of a path decides.

    Folders are asked about before what is in them, as git does, so each rule is held against single names or
    whole paths, and never has to look at the folders around.
    """

    def __init__(self, folder: str, rules: list[Rule]) -> None:
        self._base = folder.rstrip(os.sep) + os.sep
        self._for_names = [entry for entry in enumerate(rules) if entry[1].is_for_names][::-1]
        self._for_paths = [entry for entry in enumerate(rules) if not entry[1].is_for_names][::-1]
        self._known: dict[str, tuple[int, bool | None]] = {}

    def verdict(self, path: str, is_folder: bool) -> bool | None:
        """Whether a path is ignored; None where no rule speaks of it."""
        end = "/" if is_folder else ""
        below = path[len(self._base) :].replace(os.sep, "/") + end
        name = below.rstrip("/").rpartition("/")[2] + end
        if name not in self._known:
            self._known[name] = _last(self._for_names, name, -1)
        number, verdict = self._known[name]
        later, by_path = _last(self._for_paths, below, number)
        return by_path if later > number else verdict


def _last(rules: list[tuple[int, Rule]], path: str, after: int) -> tuple[int, bool | None]:
    """Number and verdict of the last rule behind number ``after`` that speaks of a path; -1 and None if none."""
    for number, rule in rules:
        if number <= after:
            break
        if rule.speaks_of(path):
            return number, rule.ignores
    return -1, None


@dataclass(frozen=True, slots=True)
class Ignores:
    """The patterns that hold in a folder, those of the outermost folder first."""

    patterns: tuple[Patterns, ...] = ()
    tracked: Tracked | None = None
    """What the repository around the folder tracks; None outside of one."""
    everything: bool = False
    """Whether the folder itself is ignored, so that in it only tracked files count."""

    def entering(self, folder: str, names: Set[str]) -> Ignores:
        """The patterns inside ``folder``, which has entries called ``names``.

        A repository inside another is its own master: what holds outside does not count in it.
        """
        if ".git" not in names and GITIGNORE not in names:
            return self
        ignores = self
        if ".git" in names:
            ignores = Ignores(_read(folder, os.path.join(folder, ".git", "info", "exclude")), Tracked(folder))
        if GITIGNORE in names:
            ignores = replace(ignores, patterns=ignores.patterns + _read(folder, os.path.join(folder, GITIGNORE)))
        return ignores

    def ignored(self, path: str, is_folder: bool = False) -> bool:
        """Whether a path is ignored; the folders around it are known not to be, or to have tracked files."""
        return (self.everything or self.matched(path, is_folder)) and not self._is_tracked(path, is_folder)

    def inside(self, folder: str) -> Ignores | None:
        """What holds in a folder below; None if it is ignored, and nothing in it is tracked."""
        if not self.everything and not self.matched(folder, is_folder=True):
            return self
        return replace(self, everything=True) if self._is_tracked(folder, is_folder=True) else None

    def matched(self, path: str, is_folder: bool = False) -> bool:
        """Whether the patterns ignore a path, tracked or not.  The nearest file decides."""
        for patterns in reversed(self.patterns):
            verdict = patterns.verdict(path, is_folder)
            if verdict is not None:
                return verdict
        return False

    def _is_tracked(self, path: str, is_folder: bool) -> bool:
        """Whether git tracks a file, or something in a folder.  Of what builds leave behind it is not asked."""
        if self.tracked is None or (is_folder and os.path.basename(path) in COLCON_FOLDERS):
            return False
        return self.tracked.has(path, is_folder)


def ignores_above(folder: str) -> Ignores:
    """The patterns that hold in ``folder`` from the folders above it, up to the root of its repository.

    None hold where they would ignore ``folder`` itself: whoever names it wants to see it.
    """
    chain = [folder]
    while not _is_repository(chain[-1]):
        parent = os.path.dirname(chain[-1])
        if parent == chain[-1]:
            return Ignores()
        chain.append(parent)
    ignores = Ignores()
    for above, below in zip(chain[:0:-1], chain[-2::-1], strict=True):
        names = {name for name in (".git", GITIGNORE) if os.path.lexists(os.path.join(above, name))}
        ignores = ignores.entering(above, names)
        if ignores.matched(below, is_folder=True):
            return Ignores()
    return ignores


def pattern_files(folder: str, names: Set[str]) -> list[str]:
    """The files with patterns that a folder with entries called ``names`` may have, and the folder of git's own."""
    info = os.path.join(folder, ".git", "info")
    of_git = [info, os.path.join(info, "exclude")] if ".git" in names else []
    return [*of_git, os.path.join(folder, GITIGNORE)] if GITIGNORE in names else of_git


def clones_in(folder: str, depth: int, looked_at: list[str]) -> tuple[list[str], list[str]]:
    """The repositories in an ignored folder, itself among them, as paths; at most ``depth`` folders down.  And the
    packages there that are in none of these.

    Repositories of workspaces list what to clone and ignore ``src/``; what is cloned there is to be checked.
    The folders that decide it are added to ``looked_at``.
    """
    looked_at.append(folder)
    if _is_repository(folder):
        return [folder], []
    packages = [folder] if os.path.isfile(os.path.join(folder, "package.xml")) else []
    if not depth:
        return [], packages
    try:
        with os.scandir(folder) as entries:
            inner = sorted(entry.path for entry in entries if entry.is_dir(follow_symlinks=False))
    except OSError:
        return [], packages
    clones = []
    for path in inner:
        more, unread = clones_in(path, depth - 1, looked_at)
        clones += more
        packages += unread
    return clones, packages


def _is_repository(folder: str) -> bool:
    return os.path.lexists(os.path.join(folder, ".git"))


def patterns_of(folder: str, text: str) -> tuple[Patterns, ...]:
    """The patterns of a ``.gitignore`` in a folder; none where it has none."""
    return _patterns(folder, _lines_of(text))


def _read(folder: str, path: str) -> tuple[Patterns, ...]:
    """The patterns of a file; none where it cannot be read."""
    return _patterns(folder, _lines(path))


def _patterns(folder: str, lines: list[str]) -> tuple[Patterns, ...]:
    """What git would not take as a pattern is left out."""
    rules = []
    for line in lines:
        if len(line) > _LONGEST:
            continue
        try:
            rules.append(Rule(line))
        except (ValueError, re.error):
            continue
    return (Patterns(folder, rules),) if rules else ()


def _lines(path: str) -> list[str]:
    try:
        if not os.path.isfile(path):
            return []
        with open(path, encoding="utf-8", errors="surrogateescape") as stream:
            text = stream.read(_MAX_CHARACTERS)
    except OSError:
        return []
    return _lines_of(text)


def _lines_of(text: str) -> list[str]:
    lines = (line.removesuffix("\r") for line in text.split("\n"))
    return [line for line in lines if line.strip() and not line.startswith("#")]
