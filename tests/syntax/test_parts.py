"""What a walk over the facts of a file comes by."""

from __future__ import annotations

import pytest

from archlint.syntax import facts
from archlint.syntax.compile import compile_python
from archlint.syntax.parts import everything_in

SOURCE = """\
import os

@decorated(lambda: 1)
class Outer(Base):
    limit: int = 3

    def method(self, first=lambda: None):
        try:
            for item in first():
                if item:
                    from a import b
                    continue
                else:
                    x = [one for one in item]
            while x:
                break
        except ValueError as error:
            raise error
        else:
            with open(x) as stream, lock:
                assert stream
        finally:
            del x
        match x:
            case [1, *rest] if rest:
                global limit
                limit += 1
            case _:
                print(x)

                def inner():
                    return (yield x)
"""


def _kinds() -> list[type[facts.Statement]]:
    return [facts.Statement, *facts.Statement.__subclasses__()]


@pytest.mark.parametrize("kind", _kinds(), ids=lambda kind: kind.__name__)
def test_statements_are_found_wherever_they_stand(kind: type[facts.Statement]) -> None:
    """A walk for statements does not look into expressions; it comes by the same ones in the same order."""
    file = compile_python(SOURCE)
    for whole in (file, file.body):
        of_all = [fact for fact in everything_in(whole) if isinstance(fact, kind)]
        assert of_all
        assert [id(fact) for fact in everything_in(whole, kind)] == [id(fact) for fact in of_all]


def test_whatever_holds_a_body_knows_its_statements() -> None:
    """A new kind of fact with statements in it must say so, or walks for statements pass it by."""
    holders = [fact for fact in everything_in(compile_python(SOURCE)) if getattr(fact, "body", None)]
    assert {type(fact) for fact in holders} >= {facts.Facts, facts.Class, facts.Function, facts.Handler, facts.Case}
    for fact in holders:
        if not isinstance(fact, facts.Lambda):
            assert all(any(one is each for each in fact.statements) for one in fact.body)
