"""What a rule of a plugin may not do to a run."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.finding import Finding

if TYPE_CHECKING:
    from archlint.checks.registry import Options, RuleFunction
    from archlint.systems.model import System


def guarded(code: str, function: RuleFunction) -> RuleFunction:
    """The function of a rule that raises where it would end the process, or yields what is no finding of its own."""

    def guarded_rule(system: System, options: Options) -> Iterator[Finding]:
        try:
            findings = list(function(system, options))
        except Exception as error:
            _end_in(function.__code__.co_filename, error)
            raise
        except SystemExit as error:
            raise RuntimeError(f"it ends the process: sys.exit({error.code})") from None
        for finding in findings:
            if not isinstance(finding, Finding) or finding.code != code:
                raise TypeError(f"it yields {finding!r:.80}, which is no finding of {code}")
        return iter(findings)

    return guarded_rule


def _end_in(file: str, error: Exception) -> None:
    """Cut off what the plugin has called from the way to an error: the last line is one of the plugin."""
    last, frame = None, error.__traceback__
    while frame is not None:
        last, frame = (frame if frame.tb_frame.f_code.co_filename == file else last), frame.tb_next
    if last is not None:
        last.tb_next = None
