"""Where archlint lives: the one place that knows its address, or that it has none yet.

``pyproject.toml``, the README and the other documents repeat :data:`REPOSITORY`; a test holds them to it, so that a
new address here says where else it belongs.
"""

from __future__ import annotations

REPOSITORY = "https://archlint.invalid"
"""A placeholder until archlint is published: no real host may end in ``.invalid`` (RFC 6761)."""


def is_placeholder(address: str) -> bool:
    """Whether an address is known to lead nowhere."""
    host = address.partition("://")[2].partition("/")[0]
    return host.endswith(".invalid")


def issue_tracker(repository: str = REPOSITORY) -> str:
    """Where a fault of archlint is reported, as a message words it: an address only if it leads somewhere."""
    return "archlint's issue tracker" if is_placeholder(repository) else f"{repository}/issues"
