"""The jobs that other machines may be asked to do, by their names, and the process that does them."""

from __future__ import annotations

import sys

import msgspec

from archlint.engine.link_part import link_part
from archlint.engine.remote import Done, Row, Task, identity
from archlint.syntax import compile as compiler
from archlint.syntax import workers
from archlint.syntax.pools import OneProcess, Processes
from archlint.syntax.workers import Answer, TimedOut

_JOBS = {f"{job.__module__}.{job.__qualname__}": job for job in (compiler.encoded, compiler.encoded_cpp, link_part)}


def rows_of(task: Task) -> list[Row]:
    """Raises ``LookupError`` for a job that there is not."""
    import archlint.syntax.python.lowering  # noqa: F401  libcst once, before the processes part

    job, seconds = _JOBS[task.job], [0.0] * len(task.sources)

    def on_done(number: int, took: float) -> None:
        seconds[number] = took

    pool = Processes(1) if workers.can_fork() else OneProcess()
    answers = pool.map(job, task.sources, task.deadline, on_done)
    return [_row(answer, took) for answer, took in zip(answers, seconds, strict=True)]


def _row(answer: Answer, seconds: float) -> Row:
    match answer:
        case bytes():
            return Row("answer", answer, seconds)
        case TimedOut():
            return Row("timed out", b"", seconds)
        case _:
            return Row("crashed", b"", seconds)


def main() -> None:
    """Read a task from standard input, and write what it comes to to standard output."""
    task = msgspec.msgpack.decode(sys.stdin.buffer.read(), type=Task)
    sys.stdout.buffer.write(msgspec.msgpack.encode(Done(identity(), rows_of(task))))


if __name__ == "__main__":
    main()

__all__ = ["rows_of"]
