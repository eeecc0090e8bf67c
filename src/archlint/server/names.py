"""What an editor asks about ROS names, answered from the last analysis and the texts of now."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, TypeVar

from lsprotocol import types as lsp

from archlint.lookup.answers import Edit, Refused, Renamable
from archlint.lookup.completion import complete
from archlint.lookup.hovers import hover
from archlint.lookup.index import Index
from archlint.lookup.links import links
from archlint.lookup.renamable import prepare_rename
from archlint.lookup.renaming import rename
from archlint.lookup.targets import definition, references
from archlint.lookup.texts import Texts
from archlint.records import dataclass
from archlint.server.actions import edit_of_files
from archlint.visible import visible

if TYPE_CHECKING:
    from archlint.lookup.answers import Completion, CompletionKind
    from archlint.place import Place
    from archlint.server.diagnostics import Shown

Answer = TypeVar("Answer")

_KINDS: dict[CompletionKind, lsp.CompletionItemKind] = {
    "topic": lsp.CompletionItemKind.Event,
    "service": lsp.CompletionItemKind.Function,
    "action": lsp.CompletionItemKind.Function,
    "type": lsp.CompletionItemKind.Class,
    "parameter": lsp.CompletionItemKind.Property,
    "package": lsp.CompletionItemKind.Module,
    "executable": lsp.CompletionItemKind.File,
    "node": lsp.CompletionItemKind.Module,
}
TRIGGERS = ("'", '"', "/", ".")
"""What a name begins with, or a part of one."""


class CannotRename(Exception):
    """``str()`` says why."""


@dataclass(frozen=True)
class Names:
    """The answers for one state of the editor.  ``indexes`` has what each of the workspaces side by side mentions."""

    shown: Shown
    indexes: Sequence[Index]
    versioned: bool = True

    def hover(self, path: str, position: lsp.Position) -> lsp.Hover | None:
        answer = self._first(hover, path, position)
        if answer is None:
            return None
        return lsp.Hover(lsp.MarkupContent(lsp.MarkupKind.Markdown, answer.text), self._range(answer.place))

    def definition(self, path: str, position: lsp.Position) -> list[lsp.Location]:
        return self._locations(self._first(definition, path, position))

    def references(self, path: str, position: lsp.Position) -> list[lsp.Location]:
        return self._locations(self._first(references, path, position))

    def completions(self, path: str, position: lsp.Position) -> list[lsp.CompletionItem]:
        rows = self._first(complete, path, position) or []
        return [self._completion(number, row) for number, row in enumerate(sorted(rows, key=lambda row: row.rank))]

    def links(self, path: str) -> list[lsp.DocumentLink]:
        file = self._file(path)
        rows = [link for index in self.indexes for link in links(index, self._texts(), file)]
        return [lsp.DocumentLink(self._range(row.place), target=self.shown.address(row.target.file)) for row in rows]

    def prepare_rename(self, path: str, position: lsp.Position) -> lsp.PrepareRenamePlaceholder | None:
        """Raises :class:`CannotRename`."""
        answer = self._first(prepare_rename, path, position)
        match answer:
            case Refused(reason=reason):
                raise CannotRename(visible(reason))
            case Renamable(place=place, text=text):
                return lsp.PrepareRenamePlaceholder(self._range(place), text)
        return None

    def rename(self, path: str, position: lsp.Position, new: str) -> lsp.WorkspaceEdit:
        """Raises :class:`CannotRename`."""
        line, column = self._column(path, position)
        file, why = self._file(path), "there is no name of a topic, service, action or parameter here"
        for index in self.indexes:
            answer = rename(index, self._texts(), file, line, column, new)
            match answer:
                case Refused(reason=reason):
                    why = reason
                case _:
                    return self._edit(answer.edits)
        raise CannotRename(visible(why))

    # ------------------------------------------------------------------------------------------------------ inside

    def _first(
        self,
        question: Callable[[Index, Texts, str, int, int], Answer],
        path: str,
        position: lsp.Position,
    ) -> Answer | None:
        """The answer of the first workspace that has one."""
        line, column = self._column(path, position)
        file, texts = self._file(path), self._texts()
        answers = (question(index, texts, file, line, column) for index in self.indexes)
        return next((answer for answer in answers if answer), None)

    def _column(self, path: str, position: lsp.Position) -> tuple[int, int]:
        return self.shown.positions(self._file(path)).column(position)

    def _file(self, path: str) -> str:
        return os.path.relpath(path, self.shown.snapshot.root).replace(os.sep, "/")

    def _texts(self) -> Texts:
        return Texts(self.shown.snapshot.text)

    def _range(self, place: Place) -> lsp.Range:
        return self.shown.positions(place.file).range(place)

    def _locations(self, places: Iterable[Place] | None) -> list[lsp.Location]:
        rows = dict.fromkeys(places or ())
        return [lsp.Location(self.shown.address(place.file), self._range(place)) for place in rows]

    def _completion(self, number: int, row: Completion) -> lsp.CompletionItem:
        return lsp.CompletionItem(
            label=row.text,
            kind=_KINDS[row.kind],
            detail=visible(row.detail),
            sort_text=f"{number:05}",
            filter_text=row.text,
            text_edit=lsp.TextEdit(self._range(row.replaces), row.text),
            additional_text_edits=[lsp.TextEdit(self._range(edit.place), edit.text) for edit in row.also] or None,
        )

    def _edit(self, edits: Iterable[Edit]) -> lsp.WorkspaceEdit:
        by_file: dict[str, list[lsp.TextEdit]] = {}
        for edit in edits:
            by_file.setdefault(edit.place.file, []).append(lsp.TextEdit(self._range(edit.place), edit.text))
        return edit_of_files(self.shown, by_file, self.versioned)


__all__ = ["TRIGGERS", "CannotRename", "Names"]
