"""What code reads of objects of the workspace's own classes, and they do not have."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint import model
from archlint.finding import Place
from archlint.interpreter.values import Instance, Unknown, Value, alternatives
from archlint.libraries.rclpy.agreement import note_if_same
from archlint.libraries.rclpy.message_uses import is_certain

if TYPE_CHECKING:
    from archlint.libraries.run import Run
    from archlint.syntax.facts import Span


def note_read(run: Run, value: Value, name: str, span: Span, result: Value) -> None:
    """Note whether an object has an attribute that code reads; what one of several has, or another run finds, is not
    missing each time.  What a method reads of its own object is left to those who look at the text."""
    if not run.activations or value is run.activation.self_value or run.activation.module.file.kind == "cpp":
        return
    place = run.place(span)
    if note_if_same(run.noted.absent_reads, (place, name), _missing(run, value, name, place, result)):
        run.program.absent_reads[:] = [each for each in run.noted.absent_reads.values() if each is not None]


def _missing(run: Run, value: Value, name: str, place: Place, result: Value) -> model.AbsentRead | None:
    options = [option for option in alternatives(value) if not option.is_none]
    results = [option for option in alternatives(result) if isinstance(option, Unknown) and option.missing == name]
    if not options or not all(isinstance(option, Instance) for option in options) or not is_certain(run):
        return None
    classes = {id(cls.ir): cls for option in options if (cls := option.own_class) is not None}
    if len(classes) != 1 or len(results) != len(alternatives(result)):
        return None
    [cls] = classes.values()
    return model.AbsentRead(place, name, Place(cls.scope.module.path, *cls.ir.name_span))


__all__ = ["note_read"]
