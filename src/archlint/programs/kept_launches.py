"""Launches that an earlier run has followed; see :mod:`archlint.programs.kept`."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from archlint.interpreter.reads import Reads
from archlint.launch.encoding import LAUNCHES
from archlint.launch.files import Problem, ReadFiles
from archlint.launch.model import Launched
from archlint.programs.earlier_imports import EarlierImports
from archlint.programs.kept import KeptResults
from archlint.programs.keys import LaunchKey
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.interpreter.modules import ModuleIndex
    from archlint.launch.launches import Launches
    from archlint.programs.earlier_imports import ImportNow
    from archlint.workspace.tree import SourceTree


@dataclass(frozen=True)
class FollowedLaunch:
    """What a launch yields, and the files that were read for it."""

    launched: Launched
    files: ReadFiles


class KeptLaunches(KeptResults[FollowedLaunch]):
    """What became of launches."""

    language = LAUNCHES

    def parts_of(self, result: FollowedLaunch) -> list[object]:
        files = result.files
        return [result.launched, list(files.frontends), list(files.parameters), list(map(tuple, files.endless))]

    def made_of(self, parts: Sequence[Any]) -> FollowedLaunch:
        launched, frontends, parameters, endless = parts
        problems = dict.fromkeys(Problem(*row) for row in endless)
        return FollowedLaunch(launched, ReadFiles(dict.fromkeys(frontends), dict.fromkeys(parameters), problems))


def keep_launches(
    launches: Launches, tree: SourceTree, open_kept: Callable[[ModuleIndex, ImportNow], KeptLaunches]
) -> None:
    """Have launches that are known not run again."""
    index = launches.index
    earlier = EarlierImports(index, launches.import_module)
    kept = open_kept(index, earlier.now)
    earlier.of(kept)

    def follow(path: str, arguments: Mapping[str, str], act: Callable[[], Launched]) -> Launched:
        key = LaunchKey(path, tuple(arguments.items()))
        known = kept.get(key, late=False)
        if known is not None:
            launches.files.read_for(known.files)
            return known.launched
        faults = launches.faults.count
        with (
            index.reading(Reads()) as reads,
            tree.telling(index.note_answer),
            launches.files.reading() as files,
        ):
            launched = act()
        if launches.faults.count == faults and _stands_alone(launches, launched):
            kept.put(key, False, FollowedLaunch(launched, files), index.all_read(reads))
        return launched

    launches.follow = follow


def _stands_alone(launches: Launches, launched: Launched) -> bool:
    """Whether what the launch imported is as any other would have imported it: modules know where they are by their
    kind, and not by who came to them first."""
    files = map(launches.files.source_file, launched.sources)
    return launched.stands_alone and not any(file is not None and file.kind == "python" for file in files)


__all__ = ["FollowedLaunch", "KeptLaunches", "keep_launches"]
