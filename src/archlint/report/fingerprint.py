"""What stays the same about a finding while the code around it moves."""

from __future__ import annotations

import hashlib
from collections import Counter
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from archlint.finding import Finding


def with_fingerprints(findings: Iterable[Finding]) -> Iterator[tuple[Finding, str]]:
    """Each finding with a hash of its rule, file and identity, without line numbers.

    Findings that share all of these are distinguished by their order.
    """
    seen: Counter[tuple[str, ...]] = Counter()
    for finding in findings:
        identity = finding.identity or (finding.node or "", finding.message)
        key = (finding.code, finding.place.file, finding.system or "", *identity)
        parts = "\0".join((*key, str(seen[key])))
        seen[key] += 1
        yield finding, hashlib.sha256(parts.encode("utf-8", "surrogatepass")).hexdigest()[:32]
