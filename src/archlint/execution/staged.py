"""What a callback plays out: words that are spoken, and moves with pauses between them."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import called_name, calls_in

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.model import ApiCall

_SPEAKS = frozenset({"play_audio", "play_sound", "playsound", "runAndWait", "say", "speak", "text_to_speech"})
"""Functions that return when something has been said."""
_PLAYED = frozenset({"sd.wait", "sounddevice.wait"})
"""Functions of sounddevice that wait until a sound has been played."""


def speaks_beside(code: SourceCode, call: ApiCall) -> bool:
    """Whether the function that holds a call, or its callback, also speaks: the words take longer than the pause after
    them, and both are what the callback is for."""
    bodies = [code.body(call)]
    callback = code.definition(call.context)
    if callback is not None:
        bodies.append(callback.body)
    spoken = [other for body in bodies for other in calls_in(list(body))]
    passed_on = _telling_methods(code.facts_at(call.file))
    return any(
        (called_name(other) in _SPEAKS and other.func.dotted not in passed_on) or other.func.dotted in _PLAYED
        for other in spoken
    )


def _telling_methods(file: facts.Facts | None) -> frozenset[str]:
    """The methods of a file by which another node is told what to say: they publish it, and return at once."""
    functions = everything_in(file.body, facts.Function) if file is not None else ()
    return frozenset(
        f"self.{function.name}"
        for function in functions
        if function.name in _SPEAKS and any(called_name(inner) == "publish" for inner in calls_in(function.body))
    )


def is_between_moves(code: SourceCode, call: ApiCall) -> bool:
    """Whether the function that holds a call publishes several messages with one publisher: what is moved has to be
    there before the next one."""
    told = Counter(other.func.dotted for other in calls_in(list(code.body(call))) if called_name(other) == "publish")
    return any(times > 1 for receiver, times in told.items() if receiver)


__all__ = ["is_between_moves", "speaks_beside"]
