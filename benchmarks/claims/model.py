"""What a rule's page says of a program, as programs: a claim is one of them, with what must be seen of it."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from textwrap import dedent, indent

from benchmarks.executors.cells import EXECUTORS, IMPORTS
from benchmarks.executors.running import Said

REPORTED = "reported"
SILENT = "silent"


@dataclass(frozen=True, order=True)
class Claim:
    """One program: the rule it is about, what it does (``form``), where (``handler``), and who spins it how."""

    rule: str
    form: str
    handler: str = ""
    executor: str = "spin"
    groups: str = "default"

    @property
    def name(self) -> str:
        return "-".join(word for word in (self.rule, self.form, self.handler, self.executor, self.groups) if word)


@dataclass(frozen=True)
class Judged:
    """What is tried for a rule.  ``harmful`` are the outcomes that the rule should report, in the words that
    ``outcome`` finds for what a program says; ``judges`` are the rules that may speak of it."""

    rule: str
    claims: Callable[[], Iterable[Claim]]
    source: Callable[[Claim], str]
    outcome: Callable[[Claim, Said], str]
    harmful: frozenset[str]
    needs: Callable[[Claim], list[str]] = lambda claim: []
    seconds: float = 2.5
    judges: tuple[str, ...] = ()
    left_alone: Callable[[Claim], bool] = lambda claim: False
    """The programs of which the rule's page says that they are not reported, whatever they do."""

    def bears_out(self, claim: Claim, said: str, seen: str) -> bool:
        """Whether what was seen is what archlint says: ``reported`` where it does harm, ``silent`` where not."""
        return (said == REPORTED) == (seen in self.harmful and not self.left_alone(claim))


def method(signature: str, body: str, *, coroutine: bool = False) -> str:
    return f"    {'async ' if coroutine else ''}def {signature}:\n{indent(dedent(body).rstrip(), ' ' * 8)}\n\n"


def program(constructor: str, methods: str, executor: str, more: str = "") -> str:
    """A node ``Asker`` and the ``main`` that spins it."""
    return (
        f"{IMPORTS}{more}\n\nclass Asker(Node):\n"
        + method("__init__(self)", f"super().__init__('asker')\n{constructor}")
        + methods
        + main(f"node = Asker()\n{EXECUTORS[executor]}")
    )


def main(body: str) -> str:
    return (
        f"\ndef main():\n    rclpy.init()\n{indent(dedent(body).rstrip(), '    ')}\n"
        "\n\nif __name__ == '__main__':\n    main()\n"
    )


def words(said: Said) -> list[str]:
    return [word.removeprefix("says ") for _, word in said]
