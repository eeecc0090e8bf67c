"""A workspace as an editor has it: a position is a text of a file, with ``^`` in front of the character."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from archlint.config.settings import load
from archlint.engine.compiling import compiled
from archlint.engine.inputs import Inputs, find_files, tree_of
from archlint.engine.loading import systems_of
from archlint.engine.pipeline import Request, store_of
from archlint.lookup.answers import Completion, Edit, Refused
from archlint.lookup.completion import complete
from archlint.lookup.hovers import hover
from archlint.lookup.index import Index
from archlint.lookup.renaming import rename
from archlint.lookup.targets import definition, references
from archlint.lookup.texts import Texts
from archlint.place import Place
from archlint.syntax.python.deep_stack import call_with_deep_stack


class Editor:
    """What is asked in the workspace of the working directory; ``texts`` are the buffers that are not saved."""

    def __init__(self) -> None:
        request = Request((".",), load(Path()), cached=False, jobs=1)
        self.workspace = find_files(request)
        inputs = Inputs(request, self.workspace, tree_of(request, self.workspace), store_of(request))
        facts = compiled(request, self.workspace, inputs.store)
        self.systems = call_with_deep_stack(lambda: systems_of(replace(inputs, workspace=self.workspace), facts))
        self.buffers: dict[str, str] = {}
        self.index = Index(self.systems, self.text_of)

    def text_of(self, file: str) -> str | None:
        path = Path(file)
        return self.buffers.get(file) or (path.read_text(encoding="utf-8") if path.is_file() else None)

    def path(self, name: str) -> str:
        """The shown path of the one file that ends so."""
        [path] = sorted(p.as_posix() for p in Path().rglob("*") if p.as_posix().endswith(name) and p.is_file())
        return path

    def position(self, name: str, at: str) -> tuple[str, int, int]:
        """``at`` is a part of a line with a ``^`` before the character."""
        file = self.path(name)
        before, _, behind = at.partition("^")
        rows = [
            (number, line.index(before + behind) + len(before) + 1)
            for number, line in enumerate((self.text_of(file) or "").split("\n"), start=1)
            if before + behind in line
        ]
        assert len(rows) == 1, f"{at} is in {len(rows)} lines of {file}"
        return file, *rows[0]

    def hover(self, name: str, at: str) -> str | None:
        answer = hover(self.index, Texts(self.text_of), *self.position(name, at))
        return None if answer is None else answer.text

    def definition(self, name: str, at: str) -> list[str]:
        return self.shown(definition(self.index, Texts(self.text_of), *self.position(name, at)))

    def complete(self, name: str, old: str, typed: str) -> list[str]:
        """What is offered where ``typed`` stands in the place of ``old``, and ``^`` in it is the position."""
        return [answer.text for answer in self.completions(name, old, typed)]

    def completions(self, name: str, old: str, typed: str) -> list[Completion]:
        file = self.path(name)
        text = self.text_of(file) or ""
        assert text.count(old) == 1, f"{old} is in {file} {text.count(old)} times"
        before = text[: text.index(old)] + typed.partition("^")[0]
        self.buffers[file] = text.replace(old, typed.replace("^", ""))
        try:
            line, column = before.count("\n") + 1, len(before) - before.rfind("\n")
            return complete(self.index, Texts(self.text_of), file, line, column)
        finally:
            del self.buffers[file]

    def rename(self, name: str, at: str, new: str) -> list[str] | str:
        """The edits, each with the line as it is then, or why there are none."""
        answer = rename(self.index, Texts(self.text_of), *self.position(name, at), new)
        if isinstance(answer, Refused):
            return answer.reason
        return [f"{Path(edit.place.file).name}:{edit.place.line} {self.edited(edit).strip()}" for edit in answer.edits]

    def edited(self, edit: Edit) -> str:
        line, place = Texts(self.text_of).line(edit.place.file, edit.place.line), edit.place
        assert place.line == place.end_line
        return line[: place.column - 1] + edit.text + line[place.end_column - 1 :]

    def references(self, name: str, at: str) -> list[str]:
        return self.shown(references(self.index, Texts(self.text_of), *self.position(name, at)))

    def shown(self, places: list[Place]) -> list[str]:
        """The name of the file, the line, and what stands at each place."""
        texts = Texts(self.text_of)
        return [f"{Path(place.file).name}:{place.line} {texts.at(place)}".rstrip() for place in places]
