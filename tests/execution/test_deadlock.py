from __future__ import annotations

import pytest

from archlint.execution.deadlock import (
    ANY,
    NOBODY,
    ONE,
    OTHER,
    REENTRANT,
    SAME,
    SEVERAL,
    UNCLEAR,
    group_relation,
    threads_of,
)
from archlint.finding import Place
from archlint.model import ExecutorUse, Group, Program
from systems.builders import blueprint

HERE = Place("node.py", 1, 1, 1, 2)


class TestGroups:
    def test_the_default_group_of_a_node_is_one_group(self):
        assert group_relation(Group("default"), Group("default")) == SAME

    def test_one_exclusive_group_object(self):
        assert group_relation(Group("mutually_exclusive", "7"), Group("mutually_exclusive", "7")) == SAME

    def test_two_exclusive_group_objects(self):
        assert group_relation(Group("mutually_exclusive", "7"), Group("mutually_exclusive", "8")) == OTHER

    def test_an_exclusive_group_that_may_be_the_same(self):
        assert group_relation(Group("mutually_exclusive"), Group("mutually_exclusive", "8")) == UNCLEAR

    def test_a_shared_reentrant_group(self):
        assert group_relation(Group("reentrant", "7"), Group("reentrant", "7")) == REENTRANT

    def test_the_default_group_and_another(self):
        assert group_relation(Group("default"), Group("reentrant", "7")) == OTHER

    def test_a_group_that_is_not_known(self):
        assert group_relation(Group("default"), Group("unknown")) == UNCLEAR

    def test_what_runs_in_no_group_holds_none(self):
        assert group_relation(None, Group("default")) == OTHER


class TestThreads:
    @pytest.mark.parametrize(
        ("executor", "threads"),
        [("single_threaded", ONE), ("multi_threaded", SEVERAL), ("none", NOBODY), ("unknown", ANY)],
    )
    def test_of_each_kind_of_executor(self, executor: str, threads: str):
        node = blueprint("arm", executor=executor)

        assert threads_of(node, Program("arm", None, "arm.py", [node])) == threads

    @pytest.mark.parametrize(("number", "threads"), [(1, ONE), (2, SEVERAL), (None, SEVERAL)])
    def test_a_multi_threaded_executor_has_as_many_as_it_is_given(self, number: int | None, threads: str):
        node = blueprint("arm", executor="multi_threaded")
        program = Program("arm", None, "arm.py", [node])
        program.executors.append(ExecutorUse("multi_threaded", number, [node], HERE, spun=True))

        assert threads_of(node, program) == threads
