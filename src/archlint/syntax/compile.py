"""Source to facts: in this process or in workers, and whatever the source does, an answer comes back."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Literal, NamedTuple

from msgspec import structs

from archlint.syntax import workers
from archlint.syntax.facts import FACTS_VERSION, Facts, FileProblem, decode, encode
from archlint.syntax.memory import MOST_BYTES, default_processes
from archlint.syntax.pools import OneProcess, Processes, paused_collection
from archlint.syntax.python import gate
from archlint.syntax.python.deep_stack import DEEP_LIMIT, STOCK_LIMIT, call_with_deep_stack, recursion_limit

if TYPE_CHECKING:
    from archlint.syntax.pools import Pool
    from archlint.syntax.workers import Answer, Job, OnDone

Language = Literal["python", "cpp", "parameter_library"]

CRASHED = "crashes the parser"
"""The message for a file that kills the process that parses it."""

PARALLEL_BYTES = 150_000
"""From this much source on, a second process is worth the time it takes to start."""

DEADLINE = 30.0
"""Seconds that one file may take.  The slowest that the gate lets through needs a few."""

MOST_ANGLES = 20_000
"""The most angle brackets of a C++ file: each may open a list of types, and tree-sitter needs 7 kB for each."""

_LASTING, _PASSING = b"+", b"-"


def compile_python(text: str) -> Facts:
    """The facts of one text, made in this process.  Never raises for what is in the text."""
    with paused_collection():
        return call_with_deep_stack(lambda: _compile_text(text))


class Compiled(NamedTuple):
    """Encoded facts.  They are ``lasting`` where they depend on nothing but the source, and may be cached."""

    payload: bytes
    lasting: bool = True


def compile_sources(
    sources: Sequence[bytes],
    jobs: int | None = None,
    deadline: float = DEADLINE,
    on_done: OnDone = workers.ignore_done,
    pool: Pool | None = None,
    language: Language = "python",
) -> list[Compiled]:
    """The facts of many files, in their order, the same for any number of ``jobs``.

    ``jobs`` is the most processes that work at the same time; None leaves the number to us.  Where the system
    allows it the work is done in other processes, even for one job: no file takes this one down.  ``on_done`` is
    called with each source that is done.  ``pool`` does the work instead, where it is given.
    """
    if not sources:
        return []
    job, elsewhere = _prepared(language), True
    if pool is None or sum(map(len, sources)) < PARALLEL_BYTES:  # nobody elsewhere starts as fast as this takes
        elsewhere = False
        pool = Processes(_worker_count(sources, jobs), MOST_BYTES) if workers.can_fork() else OneProcess()
    try:
        answers = pool.map(job, sources, deadline, on_done)
    except OSError:  # no process to be had: this one does it all
        answers = OneProcess().map(job, sources, deadline, on_done)
    answers = [workers.Lost() if elsewhere and _is_odd(answer) else answer for answer in answers]
    lost = [number for number, answer in enumerate(answers) if isinstance(answer, workers.Lost)]
    if lost:  # whoever had them is gone, or says nothing that can be read
        here = compile_sources([sources[number] for number in lost], jobs, deadline, language=language)
        return _with(here, lost, [_compiled(answer, deadline) for answer in answers])
    return [_compiled(answer, deadline) for answer in answers]


def _prepared(language: Language) -> Job:
    """What compiles a file of a language; its parser is imported once, before the processes part."""
    if language == "cpp":
        import archlint.syntax.cpp.lowering

        return encoded_cpp
    if language == "parameter_library":
        return encoded_parameter_library
    import archlint.syntax.python.lowering  # noqa: F401

    return encoded


def _with(rows: Sequence[Compiled], numbers: Sequence[int], all_rows: list[Compiled]) -> list[Compiled]:
    for number, row in zip(numbers, rows, strict=True):
        all_rows[number] = row
    return all_rows


def _worker_count(sources: Sequence[bytes], jobs: int | None) -> int:
    if sum(map(len, sources)) < PARALLEL_BYTES:
        return 1
    return max(1, min(jobs or default_processes(), len(sources)))


def _compiled(answer: Answer, deadline: float) -> Compiled:
    if isinstance(answer, bytes):
        return _marked(answer)
    if isinstance(answer, workers.TimedOut):
        return Compiled(encode(_failed(f"takes longer than {deadline:g} s to parse")), False)
    return Compiled(encode(_failed(CRASHED)), False)


def _is_odd(answer: Answer) -> bool:
    """Whether an answer of another machine is no facts."""
    return isinstance(answer, bytes) and (answer[:1] not in (_LASTING, _PASSING) or decode(answer[1:]) is None)


def _marked(answer: bytes) -> Compiled:
    return Compiled(answer[1:], answer[:1] == _LASTING)


def encoded(data: bytes) -> bytes:
    """What a worker does with one file: a mark, and the encoded facts."""
    text = gate.decode(data)
    facts = _refused(text) if isinstance(text, gate.Refusal) else _compile_text(text)
    mark = _PASSING if any(p.internal for p in facts.problems) else _LASTING
    try:
        return mark + encode(facts)
    except (ValueError, RecursionError) as error:
        return _PASSING + encode(_broken(f"facts that cannot be stored: {error}"))


def encoded_cpp(data: bytes) -> bytes:
    """As :func:`encoded`, of a file of C++."""
    from archlint.syntax.cpp.lowering import lower

    if data.count(b"<") - 2 * data.count(b"<<") > MOST_ANGLES:
        return _LASTING + encode(_failed(f"too many '<' to analyse (more than {MOST_ANGLES:,})"))
    try:
        with recursion_limit(DEEP_LIMIT):
            return _LASTING + encode(lower(data))
    except (RecursionError, MemoryError):
        return _LASTING + encode(_failed("nested too deeply to analyse"))
    except Exception as error:
        return _PASSING + encode(_broken(f"{type(error).__name__}: {error}"))


def encoded_parameter_library(data: bytes) -> bytes:
    """As :func:`encoded`, of the parameters that code is generated from."""
    from archlint.syntax.parameter_library import lower

    text = gate.decode(data)
    facts = _refused(text) if isinstance(text, gate.Refusal) else lower(text)
    return _LASTING + encode(facts)


def _compile_text(text: str) -> Facts:
    """The facts of one text; the stack must be deep."""
    from libcst import ParserSyntaxError

    from archlint.syntax.python.lowering import lower
    from archlint.syntax.python.syntax_errors import explain_syntax_error, python_refusal

    try:
        with recursion_limit(STOCK_LIMIT):
            refusal = gate.inspect(text)
        if refusal is not None:
            return _refused(refusal)
        with recursion_limit(DEEP_LIMIT):
            facts = lower(text)
        with recursion_limit(STOCK_LIMIT):
            return _with_problem(facts, gate.compile_refusal(text))
    except ParserSyntaxError as error:
        return _facts_of(explain_syntax_error(text, error.message))
    except (RecursionError, MemoryError):
        return _failed("nested too deeply to analyse")
    except (KeyboardInterrupt, SystemExit):
        raise
    except BaseException as error:  # a panic of libcst's native part is not even an Exception
        # libcst finds some syntax errors only while it builds the tree, and raises whatever comes to hand.
        problem = python_refusal(text)
        if problem is not None:
            return _facts_of(problem)
        return _broken(f"{type(error).__name__}: {error}")


def _with_problem(facts: Facts, refusal: gate.Refusal | None) -> Facts:
    if refusal is None:
        return facts
    problem = FileProblem(refusal.line, refusal.column, refusal.message)
    return structs.replace(facts, problems=[*facts.problems, problem])


def _refused(refusal: gate.Refusal) -> Facts:
    return _facts_of(FileProblem(refusal.line, refusal.column, refusal.message))


def _failed(message: str) -> Facts:
    return _facts_of(FileProblem(1, 1, message))


def _broken(error: str) -> Facts:
    return _facts_of(FileProblem(1, 1, error, internal=True))


def _facts_of(problem: FileProblem) -> Facts:
    return Facts(FACTS_VERSION, problems=[problem])
