"""From a place back to the code that is written there."""

from __future__ import annotations

import textwrap

import pytest

from archlint import model
from archlint.analysis.source_code import SourceCode
from archlint.finding import Place
from archlint.model import ApiCall, Callback, FunctionRef, Role
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.python.lowering import lower

FILE = "robot/node.py"
TEXT = """
    import rclpy

    class Robot(Node):
        limit = in_class()

        @in_decorator()
        async def run(self, after=in_default()):
            for name in ('a', 'b'):
                while True:
                    if in_test(name):
                        in_loop(lambda: in_lambda(name))
            else:
                in_else()
            answer = await in_await(f"{in_text()}")

            def inner():
                in_inner()

    if __name__ == '__main__':
        in_guard()
    else:
        beside_guard()
"""
FOUND = lower(textwrap.dedent(TEXT))
CODE = SourceCode(lambda file: FOUND if file == FILE else None)


def facts_of(kind: type[facts.Base]) -> list[facts.Base]:
    return [item for item in everything_in(FOUND.body) if isinstance(item, kind)]


def place(fact: facts.Base) -> Place:
    return Place.of(FILE, fact.span)


def call(name: str, *loops: Place) -> ApiCall:
    [found] = [one for one in facts_of(facts.Call) if one.func.last_name == name]
    return ApiCall("an.api", place(found), context(None), (), {}, {}, loops=loops)


def context(function: FunctionRef | None) -> Callback:
    return Callback(Role.MAIN, "main", Place(FILE, 1, 1, 1, 1), function)


HOLDERS = {
    "in_class": "Robot",
    "in_decorator": "Robot",
    "in_default": "Robot",  # it is evaluated where the function is defined
    "in_test": "run",
    "in_else": "run",
    "in_text": "run",
    "in_inner": "inner",
    "beside_guard": "module",
}


@pytest.mark.parametrize(("name", "holder"), HOLDERS.items())
def test_the_body_of_the_function_that_holds_a_call(name: str, holder: str):
    bodies = {one.name: one.body for one in (*facts_of(facts.Function), *facts_of(facts.Class))}
    bodies["module"] = FOUND.body
    assert CODE.body(call(name)) is bodies[holder]


def test_a_main_guard_runs_as_one():
    [guard] = [one for one in FOUND.body if isinstance(one, facts.If)]
    assert CODE.body(call("in_guard")) is guard.body


def test_a_lambda_has_no_statements():
    inside = call("in_lambda")
    assert CODE.expression(inside) is not None
    assert CODE.statement(inside) is None
    assert not CODE.body(inside)


def test_the_innermost_statement_and_the_call_itself():
    asked = call("in_test")
    assert isinstance(CODE.statement(asked), facts.If)
    assert [given.value.variable for given in CODE.arguments(asked)] == ["name"]
    expression = CODE.expression(asked)
    assert expression is not None and expression.func.last_name == "in_test"


def test_an_await_is_a_call_without_arguments():
    [awaited] = facts_of(facts.Await)
    wait = ApiCall("an.api.await", place(awaited), context(None), (), {}, {})
    expression = CODE.expression(wait)
    assert expression is not None and expression.func is awaited.value and expression.args == []


def test_only_the_loops_that_come_round_to_a_call():
    [outer], [inner] = facts_of(facts.For), facts_of(facts.While)
    assert CODE.loops(call("in_loop", place(outer), place(inner))) == (outer, inner)
    assert CODE.loop(call("in_loop", place(outer))) is outer
    assert CODE.loop(call("in_else")) is None
    assert CODE.loop_at(place(inner)) is inner


def test_the_function_of_a_callback():
    [run] = [one for one in facts_of(facts.Function) if one.name == "run"]
    [anonymous] = facts_of(facts.Lambda)
    assert CODE.function(context(FunctionRef("Robot.run", Place.of(FILE, run.name_span)))) is run
    assert CODE.function(context(FunctionRef("<lambda>", place(anonymous), is_lambda=True))) is anonymous
    assert CODE.function(context(None)) is None


def test_conditions_that_were_proven_on_the_way():
    [asked] = [one for one in facts_of(facts.If) if one.test.last_name == "" and isinstance(one.test, facts.Call)]
    text = model.Text("scan", "exact")
    node = model.Blueprint("Robot", text, text, place(asked), "robot")
    made = model.Creation(model.EntityKind.PUBLISHER, "an.api", node, place(asked), text, None)
    made.proven = ((place(asked), False),)
    assert CODE.proven(made) == ((asked.test, False),)


def test_a_file_that_was_not_read_says_nothing():
    elsewhere = ApiCall("an.api", Place("other.py", 1, 1, 1, 9), context(None), (), {}, {})
    assert CODE.expression(elsewhere) is CODE.statement(elsewhere) is None
    assert CODE.arguments(elsewhere) == CODE.body(elsewhere) == ()
