"""Statements: held against Python itself where everything is known, and both ways where it is not."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from archlint.interpreter.limits import FLAG_ROUNDS, UNROLL
from interpreting import OUTSIDE, assert_like_python, in_python, interpret


def test_assignments():
    assert_like_python(
        """
        first, *rest = [1, 2, 3]
        *start, last = (1, 2, 3)
        one, *middle, three = 'abc'
        (left, right), other = (1, 2), 3
        [top, bottom] = {'a': 1, 'b': 2}
        same = also = [1]
        also.append(2)
        swapped, back = last, first
        swapped, back = back, swapped
        number: int = 5
        table = {}
        table['a'] = table['b'] = 1
        rows = [0, 0, 0]
        rows[1] = 2
        rows[-1] = 3
        """
    )


def test_assignments_that_change_what_is_there():
    assert_like_python(
        """
        number = 1
        number += 2
        number *= 3
        number -= 1
        number //= 2
        text = 'a'
        text += 'b'
        items = [1]
        alias = items
        items += [2]
        items += (3,)
        table = {'a': 1}
        other = table
        table |= {'b': 2}
        names = {1}
        names |= {2}
        names.add(1)
        pair = (1,)
        pair += (2,)
        """
    )


def test_loops():
    assert_like_python(
        """
        total = 0
        for number in range(5):
            if number == 3:
                break
            if number == 1:
                continue
            total += number
        else:
            total = -1

        for number in []:
            pass
        else:
            ended = 'empty'

        count = 0
        while count < 5:
            count += 2
        else:
            count += 100

        rows = []
        for key, (one, two) in {'a': (1, 2)}.items():
            rows.append(key * one * two)

        seen = []
        for outer in 'ab':
            for inner in range(3):
                if inner == 2:
                    break
                seen.append(outer * inner)
        """
    )


def test_functions_return_what_python_returns():
    assert_like_python(
        """
        def first(items):
            for item in items:
                if item > 1:
                    return item
            return None

        def nothing():
            pass

        def recursive(number):
            return 1 if number < 2 else number * recursive(number - 1)

        found = first([0, 2, 3])
        missing = first([])
        none = nothing()
        two = recursive(2)
        """
    )


def test_what_is_deep_is_cut():
    found = interpret("def down(number):\n    return 'end' if number == 0 else down(number - 1)\nit = down(30)")
    assert found.reason("it") == "'down' calls itself"


def test_handlers_that_never_run_change_nothing():
    assert_like_python(
        """
        try:
            name = 'tried'
        except ValueError:
            name = 'handled'
        else:
            other = 'else'
        finally:
            last = 'finally'
        """
    )


def test_what_a_handler_does_may_be():
    found = interpret(f"{OUTSIDE}try:\n    name = outside.load('a')\nexcept OSError:\n    name = 'b'\nafter = 1")
    assert found.options("name") == {..., "b"}
    assert found.constant("after") == 1


def test_a_handler_that_returns_leaves_the_rest_to_the_other_way():
    found = interpret(
        f"{OUTSIDE}def name():\n    try:\n        outside.load()\n    except OSError:\n        return 'failed'\n"
        "    return 'loaded'\nit = name()"
    )
    assert found.options("it") == {"failed", "loaded"}


def test_an_error_is_unknown_and_what_raises_it_again_leaves_no_other_way():
    found = interpret(
        f"{OUTSIDE}def name():\n    try:\n        outside.load()\n    except OSError as error:\n"
        "        seen.append(error)\n        raise\n    return 'loaded'\nseen = []\nit = name()"
    )
    assert found.constant("it") == "loaded"


def test_imports_by_another_name_and_of_what_lies_beside():
    found = interpret(
        "import robot.names as n\nfrom . import other\nfrom robot import names\n"
        "a, b, c = n.TOPIC, other.TOPIC, names.TOPIC",
        robot__names="TOPIC = 'scan'",
        other="TOPIC = 'map'",
    )
    assert [found.constant(name) for name in "abc"] == ["scan", "map", "scan"]


def test_an_import_that_fails_is_no_other_way_where_it_works():
    found = interpret("try:\n    import names\n    it = names.X\nexcept ImportError:\n    it = 'none'", names="X = 'x'")
    assert found.constant("it") == "x"


@pytest.mark.parametrize("end", ["raise RuntimeError()", "sys.exit(1)", "exit()", "os._exit(2)"])
def test_what_never_comes_back(end: str):
    found = interpret(f"{OUTSIDE}import os, sys\nname = 'a'\nif outside.value():\n    name = 'b'\n    {end}\nit = name")
    assert found.constant("it") == "a"


def test_with_gives_what_enter_returns():
    assert_like_python(
        """
        from contextlib import contextmanager

        class Opened:
            def __enter__(self):
                return 'opened'

            def __exit__(self, *error):
                pass

        with Opened() as it:
            inside = it + '!'
        """
    )
    found = interpret(
        "from contextlib import contextmanager\n@contextmanager\ndef opened():\n    yield 'a'\n"
        "with opened() as it:\n    pass"
    )
    assert found.constant("it") == "a"


PATTERNS = """
def which(subject):
    match subject:
        case 1 | 2:
            return 'small'
        case 'a' as name:
            return name + '!'
        case [first, second]:
            return second
        case (1, {'key': inner}, 3):
            return inner
        case {'a': 1}:
            return 'one'
        case {'a': value, 'b': [x]}:
            return x
        case None:
            return 'none'
        case str() if subject == 'long':
            return 'long'
        case _:
            return 'other'

it = which(%s)
"""


@pytest.mark.parametrize(
    "subject", ["1", "2", "'a'", "[1, 5]", "[1, 2, 3]", "(1, {'key': 7}, 3)", "{'a': 1}", "None", "3.5"]
)
def test_a_match_takes_the_case_that_python_takes(subject: str):
    source = PATTERNS % subject
    assert in_python(source)["it"] in interpret(source).options("it")


@pytest.mark.parametrize("subject", ["1", "2", "'a'"])
def test_a_match_that_is_decided_has_one_answer(subject: str):
    source = PATTERNS % subject
    assert interpret(source).constant("it") == in_python(source)["it"]


def test_a_match_on_what_is_not_known_may_take_any_case():
    found = interpret(
        f"{OUTSIDE}match outside.value():\n    case 1:\n        it = 'one'\n    case [a, *rest]:\n        it = 'list'\n"
        "    case {'k': v, **others}:\n        it = 'dict'\n    case outside.Kind(x=1, y=z):\n        it = 'kind'\n"
        "    case _:\n        it = 'other'"
    )
    assert found.options("it") == {"one", "list", "dict", "kind", "other"}
    assert not found.is_known("rest")


def test_where_no_case_may_match_what_was_before_stays_possible():
    found = interpret(f"{OUTSIDE}it = 'before'\nmatch outside.value():\n    case 1:\n        it = 'one'")
    assert found.options("it") == {"before", "one"}


def test_a_guard_that_fails_leaves_the_case():
    assert_like_python(
        """
        match 5:
            case number if number > 9:
                it = 'large'
            case number if number > 3:
                it = 'middle'
            case _:
                it = 'small'
        """
    )


def test_both_arms_of_an_open_branch_are_kept():
    found = interpret(
        f"{OUTSIDE}items = [1]\ntable = {{'a': 1}}\nif outside.value():\n    name = 'a'\n    items.append(2)\n"
        "    table['b'] = 2\nelif outside.other():\n    name = 'b'\nelse:\n    name = 'c'\n    table['a'] = 5\n"
        "it = table['a']\nb = table.get('b', 0)"
    )
    assert found.options("name") == {"a", "b", "c"}
    assert found.options("it") == {1, 5}
    assert not found.is_known("items")
    assert found.options("b") == {2} or ... in found.options("b")


def test_what_only_one_arm_sets_is_what_it_sets():
    found = interpret(f"{OUTSIDE}if outside.value():\n    name = 'a'\nit = name")
    assert found.options("it") == {"a"}


@pytest.mark.parametrize(
    ("body", "options"),
    [
        ("name = 'b'", {"a", "b"}),
        ("name = 'b'\n    break", {"a", "b"}),
        ("name = 'b'\n    continue", {"a", "b"}),
        ("name += 'b'", {"a", ...}),
        ("name = 'b'\n    raise ValueError()", {"a"}),
    ],
)
@pytest.mark.parametrize("loop", ["for _ in outside.items():", "while outside.value():"])
def test_a_loop_that_may_run(loop: str, body: str, options: set):
    assert interpret(f"{OUTSIDE}name = 'a'\n{loop}\n    {body}").options("name") == options


def test_a_loop_of_which_each_round_is_known_can_return():
    assert_like_python(
        """
        def first_power_over(limit):
            number = 1
            while number < 1000:
                number *= 2
                if number > limit:
                    return number
            return None

        found, none = first_power_over(100), first_power_over(5000)
        """
    )


def test_a_loop_without_end_runs_once():
    found = interpret("names = []\nwhile True:\n    names.append('a')\n    number = len(names)\nafter = 'never'")
    assert found.constant("names") == ["a"]


def test_a_loop_over_more_than_is_followed_is_run_once_with_an_unknown_item():
    found = interpret(f"last = 'none'\nfor number in range({UNROLL + 1}):\n    last = number")
    assert not found.is_known("last")
    assert interpret(f"for number in range({UNROLL}):\n    last = number").constant("last") == UNROLL - 1


def test_after_more_rounds_than_are_followed_what_was_counted_is_not_known():
    interpreted = interpret(f"number = 0\nwhile number < {2 * UNROLL}:\n    number += 1\nafter = 'reached'")
    assert not interpreted.is_known("number")
    assert interpreted.constant("after") == "reached"
    rounds = f"number = 0\nwhile number < {UNROLL - 1}:\n    number += 1"
    assert interpret(rounds).constant("number") == UNROLL - 1


def test_a_loop_over_all_pixels_leaves_something_for_what_follows_it():
    found = interpret(
        f"""
        total = 0
        for row in range({UNROLL}):
            for column in range({UNROLL}):
                total += row * column
        after = 'reached'
        """
    )
    assert found.constant("after") == "reached"
    assert not found.is_known("total")


def test_a_loop_until_somebody_else_clears_a_flag_is_followed_for_a_few_rounds():
    source = """
        class Talker:
            def __init__(self):
                self.running, self.paused = True, False
            def talk(self):
                sent = 0
                while self.running and not self.paused:
                    sent += 1
                return sent
        sent = Talker().talk()
        """
    found = interpret(source)
    assert not found.is_known("sent")
    assert found.run.steps < 2 * FLAG_ROUNDS


def test_a_flag_that_the_loop_itself_clears_ends_it():
    source = f"""
        names = []
        running = True
        while running:
            names.append('a')
            running = len(names) < {FLAG_ROUNDS}
        """
    assert interpret(source).constant("names") == ["a"] * FLAG_ROUNDS


def test_a_break_that_may_have_left_a_loop():
    found = interpret(
        f"{OUTSIDE}for number in [1, 2]:\n    if outside.value():\n        break\n"
        "else:\n    number = 'all'\nit = number"
    )
    assert {1, 2, "all"} >= found.options("it") or ... in found.options("it")
    assert "all" in found.options("it")


def test_items_of_an_open_list_are_gone_through():
    found = interpret(
        f"{OUTSIDE}items = ['a']\nif outside.value():\n    items.append('b')\n"
        "seen = 'none'\nfor item in items:\n    seen = item"
    )
    assert {"a", "b"} <= found.options("seen")


def test_what_is_unpacked_of_what_is_not_known():
    found = interpret(f"{OUTSIDE}first, *rest = outside.value()\na, b = [1, 2, 3]\n(c, d), e = [1, 2], 3")
    assert not any(map(found.is_known, ["first", "rest", "a", "b"]))
    assert found.constant("c") == 1


def test_what_is_unpacked_of_one_of_several():
    found = interpret(f"{OUTSIDE}pair = (1, 2)\nif outside.value():\n    pair = (3, 4)\none, two = pair")
    assert found.options("one") == {1, 3}
    assert found.options("two") == {2, 4}


def test_deletion():
    assert_like_python("table = {'a': 1, 'b': 2}\nother = 1\ndel table['a'], other\nname = 'x'")
    assert not interpret("items = [1, 2]\ndel items[0]").is_known("items")


@given(st.lists(st.sampled_from(["a += 1", "b = a", "a, b = b, a", "a = a * 2", "c.append(a)", "b -= 1"]), max_size=8))
def test_straight_code_gives_what_python_gives(lines: list[str]):
    assert_like_python("\n".join(["a, b, c = 1, 2, []", *lines]))


CONDITIONS = ["a > b", "a == 2", "b in c", "not c", "a and b > 1", "a or c", "len(c) > 1"]
ACTIONS = ["a += 1", "b = a", "c.append(a)", "a, b = b, a", "pass"]


@given(st.lists(st.tuples(st.sampled_from(CONDITIONS), st.sampled_from(ACTIONS), st.sampled_from(ACTIONS)), max_size=6))
def test_decided_branches_give_what_python_gives(rows: list[tuple[str, str, str]]):
    lines = [f"if {test}:\n    {one}\nelse:\n    {other}" for test, one, other in rows]
    assert_like_python("\n".join(["a, b, c = 1, 2, []", *lines]))


@given(
    st.lists(st.tuples(st.sampled_from(ACTIONS), st.sampled_from(ACTIONS)), min_size=1, max_size=3),
    st.lists(st.booleans(), min_size=3, max_size=3),
)
def test_what_an_open_branch_comes_to_is_among_the_options(rows: list[tuple[str, str]], ways: list[bool]):
    lines = [f"if ways[{n}]:\n    {one}\nelse:\n    {other}" for n, (one, other) in enumerate(rows)]
    body = "\n".join(["a, b, c = 1, 2, []", *lines])
    found = interpret(f"from outside import ways\n{body}")
    really = in_python(body, ways=ways)
    for name in ("a", "b"):
        assert really[name] in found.options(name) or ... in found.options(name)


def test_a_conversion_that_fails_leads_to_its_handler():
    assert_like_python(
        """
        try:
            number = int('eight')
        except KeyError:
            number = 1
        except (TypeError, ValueError) as error:
            number = 2
        else:
            number = 3
        finally:
            done = True
        try:
            try:
                inner = float(None)
            except KeyError:
                inner = 1
        except Exception:
            inner = 2
        words = []
        for text in ['x', 'y']:
            try:
                words.append(int(text))
            except ValueError:
                words.append(text)
                continue
            words.append('never')
        """
    )


@pytest.mark.parametrize(
    "block",
    [
        "try:\n    value = int('a')\nexcept errors.Wrong:\n    value = 1",
        "try:\n    value = int('a') if OUTSIDE else 1\nexcept ValueError:\n    value = 2",
        "value = 1\nif OUTSIDE:\n    try:\n        int('a')\n    except ValueError:\n        value = 2",
    ],
)
def test_a_conversion_that_may_not_come_to_that_leads_nowhere(block: str):
    assert not interpret(f"{OUTSIDE}\n{block}\n").is_known("value")
