"""What an editor offers to do about a finding: its fix, or a suppression."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from lsprotocol.types import (
    CodeAction,
    CodeActionKind,
    OptionalVersionedTextDocumentIdentifier,
    Range,
    TextDocumentEdit,
    TextEdit,
    WorkspaceEdit,
)

from archlint.engine.suppressions import NEVER_SUPPRESSED
from archlint.fixes.apply import apply, fixable
from archlint.fixes.ignores import with_ignores
from archlint.records import dataclass
from archlint.visible import visible

if TYPE_CHECKING:
    from archlint.finding import Finding
    from archlint.fixes.apply import Outcome
    from archlint.server.diagnostics import Shown

FIX_ALL = f"{CodeActionKind.SourceFixAll.value}.archlint"


@dataclass(frozen=True)
class Actions:
    """The actions in one file, by its shown path.  ``versioned`` says whether the editor takes edits of a version of a
    document, so that it refuses those of a text that has changed since."""

    shown: Shown
    file: str
    versioned: bool = True

    def at(self, where: Range, only: Sequence[str] | None) -> list[CodeAction]:
        """What can be done in a range of lines; ``only`` are the kinds that are asked for, None for all."""
        findings = self.shown.snapshot.mended(self.file)
        actions: list[CodeAction] = []
        if _is_wanted(CodeActionKind.QuickFix.value, only):
            there = [finding for finding in findings if self._touches(finding, where)]
            actions += [action for finding in there for action in self._of(finding)]
        if _is_wanted(FIX_ALL, only):
            actions += self._all(findings)
        return actions

    def _touches(self, finding: Finding, where: Range) -> bool:
        own = self.shown.positions(self.file).range(finding.place)
        return own.start.line <= where.end.line and where.start.line <= own.end.line

    def _of(self, finding: Finding) -> Iterator[CodeAction]:
        yield from self._fix(finding)
        yield from self._ignore(finding)

    def _fix(self, finding: Finding) -> Iterator[CodeAction]:
        fix = finding.fix
        if fix is None:
            return
        outcome = apply([finding], self.shown.snapshot.tree.content)
        if not outcome.fixed:
            return
        title = visible(fix.title) or f"Fix {finding.code}"
        safe = fix.safety == "safe"
        yield CodeAction(
            title=title if safe else f"{title} (unsafe fix: look at what it changes)",
            kind=CodeActionKind.QuickFix,
            diagnostics=[self.shown.diagnostic(finding)],
            is_preferred=safe,
            edit=self._edit(outcome),
        )

    def _ignore(self, finding: Finding) -> Iterator[CodeAction]:
        if finding.code == NEVER_SUPPRESSED:
            return
        wanted = {self.file: {finding.place.line: [finding.code]}}
        outcome = with_ignores(wanted, "", self.shown.snapshot.tree.content)
        if outcome.texts:
            yield CodeAction(
                title=f"Ignore {finding.code} ({finding.name}) here",
                kind=CodeActionKind.QuickFix,
                diagnostics=[self.shown.diagnostic(finding)],
                edit=self._edit(outcome),
            )

    def _all(self, findings: Sequence[Finding]) -> Iterator[CodeAction]:
        """All safe fixes of the file at once."""
        outcome = apply(fixable(findings, unsafe=False), self.shown.snapshot.tree.content)
        if outcome.fixed:
            yield CodeAction(
                title=f"Fix all safe archlint findings ({len(outcome.fixed)})",
                kind=FIX_ALL,
                edit=self._edit(outcome),
            )

    def _edit(self, outcome: Outcome) -> WorkspaceEdit:
        edits = {file: self._edits(file, outcome.sources[file].text, outcome.texts[file]) for file in outcome.texts}
        return edit_of_files(self.shown, edits, self.versioned)

    def _edits(self, file: str, before: str, after: str) -> list[TextEdit]:
        """The lines that differ, each stretch of them one edit."""
        from difflib import SequenceMatcher  # seldom asked for

        old, new = before.splitlines(keepends=True), after.splitlines(keepends=True)
        positions = self.shown.positions(file)
        rows = SequenceMatcher(None, old, new, autojunk=False).get_opcodes()
        return [
            TextEdit(Range(positions.position(start + 1, 1), positions.position(end + 1, 1)), "".join(new[first:last]))
            for tag, start, end, first, last in rows
            if tag != "equal"
        ]


def edit_of_files(shown: Shown, edits: Mapping[str, Sequence[TextEdit]], versioned: bool) -> WorkspaceEdit:
    """Edits of files, by their shown paths; of open documents for the version that they have in the snapshot."""
    if versioned:
        return WorkspaceEdit(document_changes=[_of_document(shown, file, rows) for file, rows in edits.items()])
    return WorkspaceEdit(changes={shown.address(file): list(rows) for file, rows in edits.items()})


def _of_document(shown: Shown, file: str, edits: Sequence[TextEdit]) -> TextDocumentEdit:
    buffer = shown.snapshot.buffers.get(shown.snapshot.path(file))
    version = None if buffer is None else buffer.version
    return TextDocumentEdit(OptionalVersionedTextDocumentIdentifier(shown.address(file), version), list(edits))


def _is_wanted(kind: str, only: Sequence[str] | None) -> bool:
    """Kinds are hierarchical: who asks for ``source`` gets ``source.fixAll``."""
    return only is None or any(kind == asked or kind.startswith(f"{asked}.") for asked in only)


__all__ = ["FIX_ALL", "Actions", "edit_of_files"]
