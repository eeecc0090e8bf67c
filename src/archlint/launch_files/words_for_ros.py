"""Words that a launch file puts behind ``--ros-args`` and that are no arguments of ROS.

Source: ``rcl_parse_arguments`` in ``arguments.c`` of rcl, branches humble to rolling; with what it does not know,
rclcpp and rclpy raise an UnknownROSArgsError, and the program ends.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.launch.kinds import StartedKind
from archlint.place import Place
from archlint.records import dataclass
from archlint.suggestions import nearest

if TYPE_CHECKING:
    from archlint.systems.model import System

_BEGIN, _END = "--ros-args", "--"
_WITH_VALUE = frozenset(
    {"-p", "--param", "-r", "--remap", "--params-file", "-e", "--enclave", "--log-level", "--log-config-file"}
    | {"--log-file-name"}
)
_LOGS = ("stdout-logs", "rosout-logs", "external-lib-logs")
_SWITCHES = frozenset(f"--{way}-{logs}" for way in ("enable", "disable") for logs in _LOGS)


@dataclass(frozen=True)
class WordForRos:
    """A word that is refused, or that has no effect since it is several; ``instead`` is what to write."""

    place: Place
    program: str
    word: str
    instead: str
    ignored: bool = False


def wrong_words(system: System) -> Iterator[WordForRos]:
    """Every such word of a node that a launch file starts, and whose words are all known by their number."""
    for started in system.launched.started if system.launched is not None else ():
        is_node = started.kind in (StartedKind.NODE, StartedKind.CONTAINER)
        if not is_node or not started.knows_all_arguments or started.dormant or not started.executable.text:
            continue
        for name, words, inside in (
            ("arguments", started.arguments, False),
            ("ros_arguments", started.ros_arguments, True),
        ):
            place = started.places.get(name, started.place)
            refused = next(_refused(words, inside), None)
            if refused is not None:
                yield WordForRos(place, started.executable.text, refused, _instead(refused))
            for several in (word for word in words if word is not None and word.startswith(f"{_BEGIN} ")):
                instead = ", ".join(f"'{part}'" for part in several.split())
                yield WordForRos(place, started.executable.text, several, instead, ignored=True)


def _refused(words: Sequence[str | None], inside: bool) -> Iterator[str]:
    after = False
    """Whether the word before may want a value."""
    for word in words:
        if word in (_BEGIN, _END):
            inside, after = word == _BEGIN, False
        elif after or not inside:
            after = False
        elif word is None or word in _WITH_VALUE:
            after = True
        elif word and word not in _SWITCHES and not word.startswith(f"{_BEGIN} "):
            yield word


def _instead(word: str) -> str:
    """What to write for a word; empty where that is not known."""
    flag, _, value = word.partition(" ")
    if flag in _WITH_VALUE and value:
        return f"'{flag}', '{value.strip()}'"
    if ":=" in word and not word.startswith("-"):
        return f"'-p', '{word}'"
    near = nearest(word, _WITH_VALUE | _SWITCHES) if word.startswith("--") else None
    return f"'{near}'" if near is not None else ""


__all__ = ["WordForRos", "wrong_words"]
