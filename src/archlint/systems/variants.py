"""The systems that one launch file makes under arguments that no default decides, or with other choices of some."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations, product
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from archlint.launch.model import Launched

Arguments = Mapping[str, str]
"""``name:=value`` of a launch, by name."""

MOST = 8
"""Into how many systems one launch file is split; conditions beyond that stay undecided."""


def undecided_arguments(launched: Launched) -> list[dict[str, str]]:
    """Each combination of values for the arguments that conditions ask for and that nothing decides.

    An argument counts where the values that matter are known: those of a truth test, those that it declares as
    its choices, or two and more that conditions compare it with.  Empty where there is no such argument.
    """
    choices = {argument.name: argument.choices for argument in launched.declared if argument.choices}
    values: dict[str, Sequence[str]] = {}
    systems = 1
    for name, tested in sorted(launched.undecided.items()):
        options = choices.get(name, tuple(tested))
        if len(options) > 1 and systems * len(options) <= MOST:
            values[name] = options
            systems *= len(options)
    if not values:
        return []
    return [dict(zip(values, chosen, strict=True)) for chosen in product(*values.values())]


def other_choices(launched: Launched) -> tuple[dict[str, str], list[dict[str, str]]]:
    """The defaults of the arguments that a launch file declares with ``choices=``, and the same with one other choice
    each.  What its code does for that one, after ``perform()``, a run with the defaults does not come to."""
    defaults: dict[str, str] = {}
    others: list[tuple[str, str]] = []
    for argument in launched.declared:
        default = None if argument.default is None else argument.default.text
        if argument.file != launched.file or argument.dormant or default not in argument.choices:
            continue
        if default is not None and argument.name in launched.read and argument.name not in launched.arguments:
            defaults[argument.name] = default
            others += [(argument.name, choice) for choice in argument.choices if choice != default]
    return defaults, [{**defaults, name: choice} for name, choice in others[: MOST - 1]]


def condition(holding: Sequence[Arguments], every: Sequence[Arguments]) -> str | None:
    """The fewest arguments that name only systems of ``holding``; None where all systems are in it.

    What holds under several such conditions is reported with the first.
    """
    if len(holding) == len(every):
        return None
    names = sorted(every[0])
    for size in range(1, len(names) + 1):
        for chosen in combinations(names, size):
            for arguments in holding:
                part = {name: arguments[name] for name in chosen}
                if all(other in holding for other in every if part.items() <= other.items()):
                    return " ".join(f"{name}:={value}" for name, value in part.items())
    raise AssertionError("a whole combination names itself")
