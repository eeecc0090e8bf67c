"""From the values of a run to plain data."""

from __future__ import annotations

import pytest

from archlint import model
from archlint.finding import Place
from archlint.interpreter.values import (
    DictValue,
    EachValue,
    External,
    Holed,
    Instance,
    Known,
    ListValue,
    OneOf,
    Unknown,
    Value,
)
from archlint.libraries.givens import given_by
from archlint.libraries.values import EntityValue, ExecutorValue, FutureValue, MessageValue, NodeValue
from archlint.model import given

PLACE = Place("robot/node.py", 3, 5, 3, 9)
NAME = model.Text("scan", "exact")
NODE = model.Blueprint("Robot", NAME, NAME, PLACE, "robot")
CLIENT = model.Creation(model.EntityKind.CLIENT, "an.api", NODE, PLACE, NAME, None)
PROCESS = given.Process()
SPUN = model.ExecutorUse(model.ExecutorKind.SINGLE_THREADED, 1, [], None)


def duration(**parts: Value) -> Instance:
    return Instance(External("rclpy.duration.Duration"), 1, None, parts)


def handle(goal: Value) -> Instance:
    return Instance(External("rclpy.action.server.ServerGoalHandle"), 1, None, {"request": goal})


@pytest.mark.parametrize(
    ("value", "said"),
    [
        (Known(2, frozenset({"rate"}), PLACE, "literal"), given.Constant(2, frozenset({"rate"}), PLACE, "literal")),
        (OneOf((Known(None), Unknown("no"))), given.OneOf((given.Constant(None), given.UNKNOWN))),
        (EntityValue((CLIENT,), "rclpy.client.Client", 1), given.Entity((CLIENT,))),
        (FutureValue((CLIENT,), "call_async"), given.Future((CLIENT,), "call_async")),
        (NodeValue(NODE, 1), given.Node(NODE)),
        (ExecutorValue(SPUN, "rclpy.executors.SingleThreadedExecutor", 1), given.Executor(SPUN)),
        (MessageValue("std_srvs/srv/Trigger", "Request"), given.Message("std_srvs/srv/Trigger", "Request")),
        (Instance(External("threading.Event"), 7, PLACE), given.Object(7, "threading.Event", PLACE, PROCESS)),
        (External("std_msgs.msg.String"), given.ForeignClass("std_msgs.msg.String")),
        (ListValue(1, "tuple"), given.Collection("tuple")),
        (EachValue(Known(1)), given.Collection("list")),
        (DictValue(1), given.Collection("dict")),
        (Holed(("a", None), "data"), given.UNKNOWN),
        (duration(seconds=Known(1), nanoseconds=Known(500_000_000)), given.Duration(1.5)),
        (duration(seconds=Unknown("data")), given.Duration(None)),
        (handle(MessageValue("a/action/Go", "Goal")), given.GoalHandle("a/action/Go")),
        (handle(Unknown("a message of unknown type")), given.GoalHandle(None)),
    ],
)
def test_what_a_program_says_of_a_value(value: Value, said: given.Given):
    assert given_by(value, PROCESS) == said


def test_objects_of_two_processes_are_never_one():
    event = Instance(External("threading.Event"), 7, PLACE)
    here, again, elsewhere = (given_by(event, process) for process in (PROCESS, PROCESS, given.Process()))
    assert isinstance(here, given.Object) and isinstance(again, given.Object) and isinstance(elsewhere, given.Object)
    assert here.identity == again.identity != elsewhere.identity


def test_each_kind_answers_for_itself():
    several = given.OneOf((given.Entity((CLIENT,)), given.Future((CLIENT,)), given.UNKNOWN))
    assert several.creations == (CLIENT, CLIENT)
    assert [one.seconds for one in (given.Constant(2), given.Duration(0.5), given.Constant("2"))] == [2.0, 0.5, None]
    assert given.Executor(SPUN).executor is SPUN
    assert given.UNKNOWN.creations == () and given.UNKNOWN.seconds is given.UNKNOWN.executor is None
