"""What a helper gives is never that of another call: with other arguments, another state or another closure."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from textwrap import dedent, indent
from typing import Any

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check, graph
from archlint.render.json import document

NODE = """\
from functools import partial
from threading import Thread

import rclpy
from rclpy.node import Node
from rclpy.qos import QoSProfile
from std_msgs.msg import Bool, Int32, String
from std_srvs.srv import SetBool, Trigger


{outside}


class Driver(Node):
    def __init__(self):
        super().__init__("driver")
{init}

{methods}


def main():
    rclpy.init()
    rclpy.spin(Driver())


if __name__ == "__main__":
    main()
"""

Entry = dict[str, Any]
Drive = Callable[..., Entry]


def written(init: str, methods: str = "", outside: str = "") -> str:
    inside = [indent(dedent(text), " " * width) for text, width in ((init, 8), (methods, 4), (outside, 0))]
    return NODE.format(init=inside[0], methods=inside[1], outside=inside[2])


@pytest.fixture
def driver(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Drive:
    """The node of a program, as ``graph`` gives it."""
    monkeypatch.chdir(tmp_path)

    def run(init: str, methods: str = "", outside: str = "") -> Entry:
        (tmp_path / "node.py").write_text(written(init, methods, outside), encoding="utf-8")
        [entry] = document(graph(Request((".",), load(tmp_path), cached=False, jobs=1)))["nodes"]
        return dict(entry)

    return run


def names(entry: Entry, what: str = "publishers") -> list[str | None]:
    return [one["name"] for one in entry[what]]


FIVE = ["/one", "/two", "/three", "/four", "/five"]


# ------------------------------------------------------------------------------------------ other arguments


def test_each_name_is_that_of_its_own_call(driver):
    entry = driver(
        "".join(f"self.create_publisher(String, self.named('{name[1:]}'), 10)\n" for name in FIVE),
        """
        def named(self, name):
            return name
        """,
    )
    assert names(entry) == sorted(FIVE)


def test_texts_with_holes_are_told_apart(driver):
    entry = driver(
        """
        robot = self.declare_parameter("robot").value
        for name in ("one", "two", "three", "four", "five"):
            self.create_publisher(String, self.checked(f"{robot}/{name}"), 10)
        """,
        """
        def checked(self, name):
            return name
        """,
    )
    assert names(entry) == sorted(f"/*{name}" for name in FIVE)


def test_types_that_partials_carry_are_told_apart(driver):
    entry = driver(
        """
        for number, kind in enumerate((String, Bool, Int32, String, Bool)):
            self.create_publisher(self.asked(partial(self.kind, kind)), f"out{number}", 10)
        """,
        """
        def kind(self, kind):
            return kind

        def asked(self, question):
            return question()
        """,
    )
    assert [one["type"].rpartition("/")[2] for one in entry["publishers"]] == [
        "String", "Bool", "Int32", "String", "Bool",
    ]  # fmt: skip


def test_methods_of_rclpy_are_told_apart(driver):
    entry = driver(
        """
        self.added(self.create_publisher, String, "one", 10)
        self.added(self.create_publisher, String, "two", 10)
        self.added(self.create_publisher, String, "three", 10)
        self.added(self.create_publisher, String, "four", 10)
        self.added(self.create_client, Trigger, "ask")
        """,
        """
        def added(self, create, *arguments):
            return create(*arguments)
        """,
    )
    assert names(entry) == ["/four", "/one", "/three", "/two"]
    assert names(entry, "clients") == ["/ask"]


def test_profiles_are_told_apart(driver):
    entry = driver(
        "".join(f"self.create_publisher(String, '{name[1:]}', self.kept({n}))\n" for n, name in enumerate(FIVE, 1)),
        """
        def kept(self, depth):
            return QoSProfile(depth=depth)
        """,
    )
    assert {one["name"]: one["qos"]["depth"] for one in entry["publishers"]} == {
        "/one": 1, "/two": 2, "/three": 3, "/four": 4, "/five": 5,
    }  # fmt: skip


def test_parameters_are_told_apart(driver):
    entry = driver(
        "".join(f"self.create_publisher(String, self.setting('topic_{name[1:]}', '{name}'), 10)\n" for name in FIVE),
        """
        def setting(self, name, default):
            self.declare_parameter(name, default)
            return self.get_parameter(name).value
        """,
    )
    assert names(entry) == sorted(FIVE)
    assert sorted(one["name"] for one in entry["parameters"]) == sorted(f"topic_{name[1:]}" for name in FIVE)


def test_the_place_of_a_name_is_that_of_its_own_literal(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "archlint.toml").write_text(
        'select = ["NME001"]\n[rules.NME001]\neverywhere = true\n', encoding="utf-8"
    )
    init = "self.a = self.named('/a')\n" * 4 + "self.create_publisher(String, self.named('/a'), 10)\n"
    source = written(init, "def named(self, name):\n    return name\n")
    (tmp_path / "node.py").write_text(source, encoding="utf-8")
    [found] = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    lines = source.splitlines()
    assert "create_publisher" in lines[found.place.line - 1]


# ----------------------------------------------------------------------------------------------- other state


def test_what_a_function_closes_over_tells_it_from_others(driver):
    entry = driver(
        """
        for name in ("one", "two", "three", "four", "five"):
            made = maker(name)
            self.create_publisher(String, made(), 10)
        """,
        outside="""
        def maker(name):
            def made():
                return name
            return made
        """,
    )
    assert names(entry) == sorted(FIVE)


def test_defaults_tell_lambdas_from_each_other(driver):
    entry = driver(
        """
        for make in [lambda n=n: n for n in ("one", "two", "three", "four", "five")]:
            self.create_publisher(String, make(), 10)
        """,
    )
    assert names(entry) == sorted(FIVE)


def test_a_counter_counts_on(driver):
    entry = driver(
        """
        self.number = 0
        for _ in range(6):
            self.create_publisher(String, self.next_name(), 10)
        """,
        """
        def next_name(self):
            self.number += 1
            return f"camera{self.number}"
        """,
    )
    assert names(entry) == [f"/camera{n}" for n in range(1, 7)]


def test_a_helper_reads_the_attribute_as_it_is_now(driver):
    entry = driver(
        """
        self.prefix = "front"
        self.out = [self.add("a"), self.add("a"), self.add("a")]
        self.prefix = "rear"
        self.add("a")
        """,
        """
        def add(self, name):
            return self.create_publisher(String, f"{self.prefix}/{name}", 10)
        """,
    )
    assert names(entry) == ["/front/a", "/rear/a"]


def test_a_helper_sets_the_attribute_each_time(driver):
    entry = driver(
        """
        for _ in range(4):
            self.to_front()
            self.prefix = "rear"
        self.to_front()
        self.create_publisher(String, f"{self.prefix}/scan", 10)
        """,
        """
        def to_front(self):
            self.prefix = "front"
        """,
    )
    assert names(entry) == ["/front/scan"]


def test_objects_that_a_helper_makes_are_not_one_object(driver):
    entry = driver(
        """
        made = [self.robot() for _ in range(5)]
        for robot, name in zip(made, ("one", "two", "three", "four", "five")):
            robot.topic = name
        for robot in made:
            self.create_publisher(String, robot.topic, 10)
        """,
        """
        def robot(self):
            return Robot()
        """,
        outside="""
        class Robot:
            pass
        """,
    )
    assert names(entry) == sorted(FIVE)


def test_beyond_the_bound_a_name_is_unknown(driver):
    entry = driver(
        """
        self.number = 0
        for _ in range(100):
            self.create_publisher(String, self.next_name(), 10)
        """,
        """
        def next_name(self):
            self.number += 1
            return f"camera{self.number}"
        """,
    )
    found = names(entry)
    assert None in found  # more of them than are followed
    assert {name for name in found if name} <= {f"/camera{n}" for n in range(1, 101)}


# ------------------------------------------------------------------------------------------------- callbacks


def test_timers_of_a_helper_have_their_own_callbacks(driver):
    entry = driver(
        """
        self.every_second(partial(self.add, "one"))
        self.every_second(partial(self.add, "two"))
        self.every_second(lambda: self.add("three"))
        for name in ("four", "five"):
            self.every_second(lambda name=name: self.add(name))
        """,
        """
        def every_second(self, callback):
            return self.create_timer(1.0, callback)

        def add(self, name):
            self.create_publisher(String, name, 10)
        """,
    )
    assert names(entry) == sorted(FIVE)


def test_a_subscription_of_a_helper_for_each_callback(driver):
    entry = driver(
        """
        self.hear(self.declare_parameter("in").value, self.look)
        self.hear(self.declare_parameter("more").value, self.tell)
        """,
        """
        def hear(self, name, callback):
            self.create_subscription(String, name, callback, 10)

        def look(self, message):
            pass

        def tell(self, message):
            pass
        """,
    )
    assert [one["callback"].rpartition(".")[2] for one in entry["subscribers"]] == ["look", "tell"]


def test_a_callback_that_starts_itself_again_ends(driver):
    entry = driver(
        "self.work(0)",
        """
        def work(self, number):
            self.create_publisher(String, "out", 10)
            Thread(target=self.work, args=(number + 1,)).start()
        """,
    )
    assert names(entry) == ["/out"]


def test_a_thread_for_each_name_runs_each_time(driver):
    entry = driver(
        """
        for name in ("one", "two"):
            Thread(target=self.work, args=(name,)).start()
        """,
        """
        def work(self, name):
            self.create_publisher(String, name, 10)
        """,
    )
    assert names(entry) == ["/one", "/two"]
