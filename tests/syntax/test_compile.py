"""Compiling: whatever the source does, facts come back, and the same ones however many processes work."""

from __future__ import annotations

import gc
import os
import sys
import threading

import pytest

from archlint.syntax import compile as compiler
from archlint.syntax import workers
from archlint.syntax.compile import CRASHED, compile_python, compile_sources
from archlint.syntax.facts import Facts, decode
from archlint.syntax.python import gate, lowering

needs_fork = pytest.mark.skipif(not hasattr(os, "fork"), reason="needs fork")
SOURCES = [b"x = %d\nself.pub = create_publisher(String, 'topic_%d', 10)\n" % (i, i) for i in range(30)]


def only(facts: Facts | None) -> str:
    assert facts is not None
    (problem,) = facts.problems
    return problem.message


class TestOneText:
    def test_facts(self):
        facts = compile_python("x = 1\n")
        assert len(facts.body) == 1
        assert facts.problems == []

    def test_a_syntax_error_is_a_problem_at_its_place(self):
        facts = compile_python("import a\n\ndef f(:\n    pass\n")
        (problem,) = facts.problems
        assert (problem.line, facts.body) == (3, [])
        assert problem.message.startswith("syntax error: ")

    def test_what_python_refuses_to_compile_is_a_problem_and_its_facts_are_kept(self):
        facts = compile_python("x = 1\nreturn x\n")
        (problem,) = facts.problems
        assert problem.line == 2
        assert "outside function" in problem.message
        assert len(facts.body) == 2

    def test_what_the_gate_refuses_never_reaches_the_parser(self, monkeypatch):
        monkeypatch.setattr(lowering, "lower", lambda text: pytest.fail("parsed"))
        facts = compile_python("x = " + "(" * 500 + ")" * 500 + "\n")
        assert "nested 500 deep" in only(facts)

    def test_an_error_of_ours_is_called_one(self, monkeypatch):
        def broken(text: str) -> Facts:
            raise KeyError("lost")

        monkeypatch.setattr(lowering, "lower", broken)
        facts = compile_python("x = 1\n")
        assert only(facts) == "KeyError: 'lost'"
        assert facts.problems[0].internal

    def test_bytes_beside_text_are_the_users_error(self):
        assert only(compile_python("x = b'a' 'b'\n")).startswith("syntax error: cannot mix bytes")

    def test_deep_code_that_the_gate_allows(self):
        deep = "".join(" " * i + "if a:\n" for i in range(95)) + " " * 95 + "f(" + "(" * 150 + ")" * 150 + ")\n"
        assert compile_python(deep).problems == []

    @pytest.mark.parametrize(
        "source",
        [
            "x = " + " + ".join("a" * 800),
            "x = a" + ".b" * 800,
            "x = " + "'a' " * 800,
            "x = " + "[" * 190 + "]" * 190,
        ],
    )
    def test_long_code_that_the_gate_allows(self, source):
        facts = compile_python(source + "\n")
        assert len(facts.body) == 1 or only(facts) == "nested too deeply to analyse"

    def test_the_process_is_left_as_it_was(self):
        limit, stack, collects = sys.getrecursionlimit(), threading.stack_size(), gc.isenabled()
        compile_python("x = 1\n")
        assert (sys.getrecursionlimit(), threading.stack_size(), gc.isenabled()) == (limit, stack, collects)


class TestManySources:
    def test_nothing(self):
        assert compile_sources([]) == []

    @needs_fork
    @pytest.mark.parametrize("jobs", [1, 2, 5, None])
    def test_the_number_of_processes_changes_nothing(self, jobs, monkeypatch):
        monkeypatch.setattr(compiler, "PARALLEL_BYTES", 0)
        expected = [compile_python(source.decode()) for source in SOURCES]
        assert [decode(result.payload) for result in compile_sources(SOURCES, jobs)] == expected

    @pytest.mark.parametrize("can_fork", [True, False])
    def test_nor_does_a_system_without_fork(self, can_fork, monkeypatch):
        monkeypatch.setattr(workers, "can_fork", lambda: can_fork and hasattr(os, "fork"))
        texts = [b"x = 1\n", b"x = (\n", b"\xff\xfe", b"x = 2\n"]
        first, second, third, fourth = [decode(result.payload) for result in compile_sources(texts)]
        assert [len(first.body), len(fourth.body)] == [1, 1]
        assert only(second).startswith("syntax error: ")
        assert only(third)

    @needs_fork
    def test_no_process_to_be_had(self, monkeypatch):
        def refused() -> int:
            raise BlockingIOError("no more processes")

        monkeypatch.setattr(os, "fork", refused)
        (result,) = compile_sources([b"x = 1\n"])
        assert len(decode(result.payload).body) == 1

    @needs_fork
    def test_a_file_that_kills_the_parser_takes_nothing_with_it(self, monkeypatch):
        monkeypatch.setattr(gate, "inspect", lambda text: None)
        killer = b"x = " + b"(" * 50_000 + b")" * 50_000 + b"\n"
        before, killed, after = compile_sources([b"x = 1\n", killer, b"x = 2\n"])
        assert only(decode(killed.payload)) == CRASHED
        assert not killed.lasting
        assert [len(decode(result.payload).body) for result in (before, after)] == [1, 1]

    @needs_fork
    def test_a_file_that_takes_too_long_is_given_up(self, monkeypatch):
        real = gate.inspect

        def inspect(text):
            while "slow" in text:
                pass
            return real(text)

        monkeypatch.setattr(gate, "inspect", inspect)
        slow, quick = compile_sources([b"slow = 1\n", b"x = 1\n"], deadline=0.5)
        assert only(decode(slow.payload)) == "takes longer than 0.5 s to parse"
        assert not slow.lasting
        assert quick.lasting

    def test_an_error_of_ours_is_not_for_the_cache_and_one_of_the_users_is(self, monkeypatch):
        monkeypatch.setattr(workers, "can_fork", lambda: False)
        (syntax_error,) = compile_sources([b"x = (\n"])
        monkeypatch.setattr(lowering, "lower", lambda text: 1 // 0)
        (internal_error,) = compile_sources([b"x = 1\n"])
        assert (syntax_error.lasting, internal_error.lasting) == (True, False)

    def test_the_encoding_cookie_counts(self):
        (result,) = compile_sources(["# -*- coding: latin-1 -*-\nx = 'é'\n".encode("latin-1")])
        (assignment,) = decode(result.payload).body
        assert assignment.value.value == "é"

    @needs_fork
    def test_little_source_is_not_worth_two_processes(self, monkeypatch):
        counts = []
        real = workers.run_in_workers

        def counted(job, sources, count, *rest):
            counts.append(count)
            return real(job, sources, count, *rest)

        monkeypatch.setattr(workers, "run_in_workers", counted)
        compile_sources(SOURCES, jobs=4)
        compile_sources([b"x = 1\n#" + b"-" * 160_000, b"y = 1\n"], jobs=4)
        assert counts == [1, 2]
