"""Texts to facts: in this process or in workers, and whatever the text does, an answer comes back."""

from __future__ import annotations

import os
from collections.abc import Sequence

from archlint.facts.deep_stack import call_with_deep_stack, raised_recursion_limit
from archlint.facts.model import FACTS_VERSION, Facts, FileProblem, decode, encode

INTERNAL_ERROR = "internal error"
"""How the message of a problem begins that is archlint's own fault."""

PARALLEL_BYTES = 150_000
"""From this much source on, a second process is worth the time it takes to start."""

DEADLINE = 30.0
"""Seconds that one file may take.  The slowest that the gate lets through need a few."""


def compile_python(text: str) -> Facts:
    """The facts of one file.  Never raises for what is in the text."""
    return call_with_deep_stack(lambda: _compile(text))


def compile_texts(texts: Sequence[str], jobs: int | None = None, deadline: float = DEADLINE) -> list[bytes]:
    """The encoded facts of many files, in their order, the same for any number of ``jobs``.

    ``jobs`` is the most processes that work at the same time; None leaves the number to us.
    """
    from archlint.facts import workers

    if not texts:
        return []
    if workers.can_fork():
        count = _worker_count(texts, jobs)
        if count > 1:
            import archlint.facts.python  # noqa: F401  libcst once, before the processes part

        try:
            answers = workers.run_in_workers(_compile_encoded, texts, count, deadline)
        except OSError:
            pass  # no process to be had: this one does it all
        else:
            return [_payload(answer, deadline) for answer in answers]
    return call_with_deep_stack(lambda: [_compile_encoded(text) for text in texts])


def _worker_count(texts: Sequence[str], jobs: int | None) -> int:
    if sum(map(len, texts)) < PARALLEL_BYTES:
        return 1
    return max(1, min(jobs or os.cpu_count() or 1, len(texts)))


def _payload(answer: object, deadline: float) -> bytes:
    from archlint.facts.workers import TimedOut

    if isinstance(answer, bytes):
        return answer
    if isinstance(answer, TimedOut):
        return encode(_failed(1, 1, f"takes longer than {deadline:g} s to parse"))
    return encode(_failed(1, 1, "crashes the parser"))


def _compile_encoded(text: str) -> bytes:
    facts = _compile(text)
    try:
        with raised_recursion_limit():
            return encode(facts)
    except (ValueError, RecursionError) as error:
        return encode(_failed(1, 1, f"{INTERNAL_ERROR}: facts cannot be stored: {error}"))


def _compile(text: str) -> Facts:
    """The facts of one file; the stack must be deep."""
    from libcst import ParserSyntaxError

    from archlint.facts.python import lower

    try:
        with raised_recursion_limit():
            return lower(text)
    except ParserSyntaxError as error:
        return _failed(error.raw_line, error.raw_column + 1, "syntax error: " + error.message)
    except RecursionError:
        return _failed(1, 1, "nested too deeply to analyse")
    except MemoryError:
        return _failed(1, 1, "needs more memory to parse than there is")
    except (KeyboardInterrupt, SystemExit):
        raise
    except BaseException as error:  # a panic of libcst's native part is not even an Exception
        return _failed(1, 1, f"{INTERNAL_ERROR}: {type(error).__name__}: {error}")


def _failed(line: int, column: int, message: str) -> Facts:
    return Facts(FACTS_VERSION, problems=[FileProblem(line, column, message)])
