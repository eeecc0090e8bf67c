"""What a launch file computes with Python's ``math``, and the constants of ``numpy``, which are the same numbers."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

from archlint.interpreter.values import Known, Unknown, Value, constant, constants_of, reason, via

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.launch.run import LaunchRun

CONSTANTS = {
    **{f"math.{name}": Known(getattr(math, name)) for name in ("pi", "tau", "e", "inf", "nan")},
    **{f"numpy.{name}": Known(getattr(math, name)) for name in ("pi", "e", "inf", "nan")},
}
_FUNCTIONS: tuple[Callable[..., float], ...] = (
    *(math.radians, math.degrees, math.sin, math.cos, math.tan, math.asin, math.acos, math.atan, math.atan2),
    *(math.sqrt, math.hypot, math.exp, math.log, math.log2, math.log10, math.pow, math.fabs, math.fmod),
    *(math.floor, math.ceil, math.trunc, math.isclose, math.isfinite, math.isinf, math.isnan, math.copysign),
)


def _computed(function: Callable[..., float]) -> Callable[[LaunchRun, CallSite], Value]:
    def compute(run: LaunchRun, site: CallSite) -> Value:
        constants = constants_of(site.args)
        if constants is None or site.keywords or site.open:
            return Unknown(reason(*site.args))
        try:
            return constant(function(*constants), via(*site.args))
        except (TypeError, ValueError, OverflowError):
            return Unknown("an operation that fails")

    return compute


PLAIN = {f"math.{function.__name__}": _computed(function) for function in _FUNCTIONS}

__all__ = ["CONSTANTS", "PLAIN"]
