"""The shape of an expression of launch: when two are one test, and which tests of one argument can be decided."""

from __future__ import annotations

import pytest

from archlint.launch.shape import Argument, ClassFile, Equality, Part, SameObject, Shape

MODE, SIM = Argument("mode"), Argument("sim")


def test_texts_side_by_side_are_one():
    assert Shape.of(["a", "", "b", MODE, "", "c"]) == Shape(("ab", MODE, "c"))


@pytest.mark.parametrize(
    ("parts", "asked"),
    [
        ([SIM], ("sim", True)),
        ([" ", SIM, " "], ("sim", True)),
        (["not ", SIM], ("sim", False)),
        ([" not  ", SIM, " "], ("sim", False)),
        (["nothing ", SIM], None),
        ([SIM, " and ", MODE], None),
        ([SIM, SameObject(1)], None),
    ],
)
def test_what_asks_for_the_truth_of_one_argument(parts: list[Part], asked: tuple[str, bool] | None):
    assert Shape.of(parts).truth == asked


@pytest.mark.parametrize(
    ("parts", "compared"),
    [
        ([MODE, " == 'slow'"], Equality("mode", "slow", True)),
        (["'", MODE, '\' != "slow" '], Equality("mode", "slow", False)),
        (["x ", MODE, " == 'slow'"], None),
        ([MODE, " == 'slow' or 1"], None),
        # The value of another argument is no text that anybody could set this one to.
        (["'", MODE, "' == '", SIM, "'"], None),
        ([MODE, " == '", SameObject(1), "'"], None),
    ],
)
def test_what_compares_one_argument_with_a_text(parts: list[Part], compared: Equality | None):
    assert Shape.of(parts).equality == compared


def test_what_is_about_truth_values_alone():
    assert Shape.of(["not (", SIM, " or ", MODE, ")"]).is_about_truth
    assert not Shape.of([SIM, " == ", MODE]).is_about_truth
    assert not Shape.of([SIM, " and ", SameObject(1)]).is_about_truth


def test_people_see_no_file_of_a_class_and_each_class_has_its_own_key():
    one, other = (Shape.of(["Test", ClassFile(path), "(", SIM, ")"]) for path in ("a.py", "b.py"))
    assert one.written(lambda name: f"{name}:=…") == other.written(lambda name: f"{name}:=…") == "Test(sim:=…)"
    assert one.key != other.key


def test_an_object_that_is_not_known_cannot_be_written_down():
    assert Shape.of([SIM]).is_known and not Shape.of([SIM, SameObject(1)]).is_known
