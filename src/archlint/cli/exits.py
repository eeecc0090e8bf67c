"""Exit statuses, and the error that ends in one."""

from __future__ import annotations

CLEAN = 0
"""Everything was analysed and nothing is at or above the failing severity."""
FINDINGS = 1
FAILED = 2
"""The job could not be done: a wrong option or configuration, no input, or an error of ours."""
INTERRUPTED = 130
"""Ctrl-C, as a shell reports it."""
READER_GONE = 141
"""The reader of a pipe went away, as a shell reports it."""


class UsageError(Exception):
    """Something that the user can mend; ``str()`` says what.  Ends in :data:`FAILED`."""
