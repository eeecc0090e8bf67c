"""Which rules run: the defaults of the rule book, changed by each layer of configuration in turn.

A layer that says ``select`` starts afresh; ``extend-select`` adds and ``ignore`` takes away.  Inside a layer
the more specific selector wins, so ``select = ["SRV003"]`` with ``ignore = ["SRV"]`` keeps SRV003.
"""

from __future__ import annotations

from collections.abc import Iterable

from archlint.records import dataclass
from archlint.rulebook import CLOSED_WORLD, ON, codes_of, rules

ABOUT_THE_RUN = ("LNT002", "LNT003")
"""Rules about what archlint itself could not do: a ``select`` of other rules does not silence them, for
exit status 0 says that everything was analysed."""

NEVER_OFF = "LNT003"


@dataclass(frozen=True)
class Layer:
    """What one configuration file, or the command line, says about which rules run."""

    select: tuple[str, ...] | None = None
    extend_select: tuple[str, ...] = ()
    ignore: tuple[str, ...] = ()


@dataclass(frozen=True)
class Selection:
    """``closed_only`` are the codes that run only where a system is closed; ``always`` all the others."""

    always: frozenset[str]
    closed_only: frozenset[str]

    def runs(self, code: str, closed: bool) -> bool:
        return code in self.always or (closed and code in self.closed_only)

    @property
    def codes(self) -> list[str]:
        return sorted(self.always | self.closed_only)


def resolve(layers: Iterable[Layer]) -> Selection:
    """The rules that run after all layers, the farthest first and the command line last."""
    always = {rule.code for rule in rules().values() if rule.default == ON}
    closed_only = {rule.code for rule in rules().values() if rule.default == CLOSED_WORLD}
    for layer in layers:
        if layer.select is not None:
            always &= set(ABOUT_THE_RUN)
            closed_only.clear()
        for selector, chosen in _by_specificity(layer):
            codes = codes_of(selector)
            closed_only.difference_update(codes)
            (always.update if chosen else always.difference_update)(codes)
    return Selection(frozenset(always | ({NEVER_OFF} & rules().keys())), frozenset(closed_only))


def _by_specificity(layer: Layer) -> list[tuple[str, bool]]:
    """Selectors with whether they choose, from the least specific; what ignores comes after what chooses."""
    chosen = [(selector, True) for selector in (*(layer.select or ()), *layer.extend_select)]
    ignored = [(selector, False) for selector in layer.ignore]
    return sorted(chosen + ignored, key=lambda entry: (_specificity(entry[0]), not entry[1]))


def _specificity(selector: str) -> int:
    if selector == "ALL":
        return 0
    codes = codes_of(selector)
    return 7 if len(codes) == 1 and selector.upper() not in (code[:-1] for code in codes) else len(selector)
