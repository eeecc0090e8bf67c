"""Which findings ``--fix`` mends, for people: a mark at each of them, and a sentence for all."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from archlint.finding import Finding

MARK = "[*] "


def is_fixable(finding: Finding) -> bool:
    """Whether ``--fix`` alone mends it."""
    return finding.fix is not None and finding.fix.safety == "safe"


def mark(finding: Finding) -> str:
    """What stands before the message of a finding."""
    return MARK if is_fixable(finding) else ""


def fix_line(findings: Iterable[Finding]) -> str:
    """How many findings have a fix; empty where none has."""
    count = Counter(finding.fix.safety for finding in findings if finding.fix is not None)
    safe, unsafe = count["safe"], count["unsafe"]
    if safe:
        more = f" ({unsafe} more with `--fix --unsafe-fixes`)" if unsafe else ""
        return f"{MARK}{safe} fixable with `--fix`{more}."
    return f"No safe fixes; {unsafe} fixable with `--fix --unsafe-fixes`." if unsafe else ""
