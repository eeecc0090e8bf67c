"""The file names that a CMake project gives its executables, where these are not the targets' own."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from archlint.workspace.cmake import Argument
from archlint.workspace.cmake_run import Step

_NAMES = ("RUNTIME_OUTPUT_NAME", "OUTPUT_NAME")
"""The first that is set decides."""
_WORDS = frozenset({*_NAMES, "PREFIX", "SUFFIX"})


class TargetNames:
    """The properties of targets that change what the executable is called."""

    def __init__(self, steps: Iterable[Step]) -> None:
        self._properties: dict[str, dict[str, list[Argument]]] = {}
        self._maybe: set[str] = set()
        """Targets with a property that is set under a condition."""
        for step in steps:
            for target, name, value in _properties(step):
                self._set(step, target, name, value)

    def _set(self, step: Step, target: str, name: str, value: Argument) -> None:
        values = self._properties.setdefault(target, {}).setdefault(name, [])
        if step.conditional:
            self._maybe.add(target)
        else:
            values.clear()
        values.append(value)

    def of(self, target: Argument) -> list[Argument] | None:
        """What the target's file may be called; None where that is not known."""
        given = self._properties.get(target.text)
        if given is None:
            return [target]
        values = next((given[name] for name in _NAMES if name in given), [target])
        around = [given.get(word, [])[-1:] for word in ("PREFIX", "SUFFIX")]
        if any(value.open for value in (*values, *around[0], *around[1])):
            return None
        before, after = ("".join(value.text for value in part) for part in around)
        names = [Argument(f"{before}{value.text}{after}", value.line, value.column, value.quoted) for value in values]
        return [*names, target] if target.text in self._maybe else names


def _properties(step: Step) -> Iterator[tuple[str, str, Argument]]:
    """Target, name and value of each property of a ``set_target_properties`` or ``set_property(TARGET …)``."""
    command, texts = step.command, step.command.texts
    if command.name == "set_target_properties" and "PROPERTIES" in texts:
        at = texts.index("PROPERTIES")
        yield from _pairs(texts[:at], command.arguments[at + 1 :])
    elif command.name == "set_property" and texts[:1] == ["TARGET"] and "PROPERTY" in texts:
        at = texts.index("PROPERTY")
        yield from _pairs(texts[1:at], command.arguments[at + 1 : at + 3])


def _pairs(targets: Sequence[str], words: Sequence[Argument]) -> Iterator[tuple[str, str, Argument]]:
    for name, value in zip(words[::2], words[1::2], strict=False):
        if name.text in _WORDS:
            yield from ((target, name.text, value) for target in targets)
