"""Functions, classes and objects, held against Python itself."""

from __future__ import annotations

import pytest

from archlint.interpreter.limits import CLASSES
from archlint.interpreter.values import ClassValue
from interpreting import OUTSIDE, assert_like_python, interpret


def test_methods_of_all_kinds():
    assert_like_python(
        """
        class Base:
            kind = 'base'

            def __init__(self, x=1):
                self.x = x

            @property
            def double(self):
                return self.x * 2

            @staticmethod
            def plus(value):
                return value + 1

            @classmethod
            def make(cls, x):
                return cls(x)

            def __call__(self, other):
                return self.x + other

            def __getitem__(self, key):
                return key

            def __str__(self):
                return 'Base ' + str(self.x)

        class Derived(Base):
            kind = 'derived'

            def __init__(self):
                super().__init__(5)

            @property
            def double(self):
                return super().double + 1

        doubled = Base(3).double
        of_super = Derived().double
        of_class = Base.plus(1)
        of_object = Base(1).plus(2)
        by_class_method = Base.make(7).x
        by_object = Base.make(1).make(2).x
        kinds = Derived().kind + Base.kind
        called = Base(1)(2)
        item = Base(1)['k']
        shown = str(Base(4)), f"{Base(4)}", "%s" % Base(4), "{}".format(Base(4))
        through_the_class = Base.__call__(Base(2), 3)
        """
    )


def test_a_property_with_a_setter():
    assert_like_python(
        """
        class Motor:
            def __init__(self):
                self._speed = 1

            @property
            def speed(self):
                return self._speed

            @speed.setter
            def speed(self, value):
                self._speed = value * 10

        class Fast(Motor):
            pass

        motor, fast = Motor(), Fast()
        before = motor.speed
        motor.speed = 4
        fast.speed = 5
        after = motor.speed, fast.speed
        """
    )


def test_what_a_class_has_all_of_its_objects_share():
    assert_like_python(
        """
        class Counted:
            count = 0
            items = []

            def __init__(self):
                Counted.count += 1
                self.number = Counted.count
                self.items.append(self.number)

        numbers = [Counted().number, Counted().number]
        count = Counted.count
        items = Counted().items
        """
    )


def test_private_names_are_those_of_their_class():
    assert_like_python(
        """
        class Base:
            def __init__(self):
                self.__name = 'base'

            def name(self):
                return self.__name

        class Derived(Base):
            def __init__(self):
                super().__init__()
                self.__name = 'derived'

        name = Derived().name()
        """
    )


def test_closures():
    assert_like_python(
        """
        def counter():
            number = 1

            def up():
                nonlocal number
                number += 1
                return number

            up()
            return up()

        number = counter()
        late = [function() for function in [lambda: each for each in range(3)]]
        early = [function() for function in [lambda each=each: each for each in range(3)]]
        level = 'module'

        def set_level():
            global level
            level = 'set'

        set_level()
        """
    )


def test_defaults_are_made_once():
    assert_like_python(
        """
        start = 1

        def first(value=start, seen=[]):
            seen.append(value)
            return value

        start = 2
        values = first(), first(3)

        def length(seen=[]):
            seen.append(1)
            return len(seen)

        lengths = [length(), length()]
        """
    )


def test_decorators_of_the_workspace_are_called():
    assert_like_python(
        """
        def twice(function):
            def wrapper(value):
                return function(value) * 2
            return wrapper

        def times(number):
            def decorate(function):
                return lambda value: function(value) * number
            return decorate

        @twice
        def plus_one(value):
            return value + 1

        @twice
        @times(5)
        def same(value):
            return value

        results = plus_one(2), same(3)
        """
    )


def test_a_decorator_of_another_package_leaves_the_function():
    found = interpret("import outside\n@outside.traced\ndef name():\n    return 'a'\nit = name()")
    assert found.constant("it") == "a"


@pytest.mark.parametrize(
    ("base", "values"),
    [
        ("Enum", "A = 'a'\n    B = 'b'"),
        ("IntEnum", "A = 0\n    B = 1"),
    ],
)
def test_members_of_enums(base: str, values: str):
    assert_like_python(
        f"""
        from enum import Enum, IntEnum

        class It({base}):
            {values.replace(chr(10), chr(10) + "        ")}

        held = [It.A.value, It.B.value]
        names = It.A.name, It['B'].name
        again = It(It.B.value) is It.B
        count = len(list(It))
        true = bool(It.A), bool(It.B)
        """
    )


def test_a_second_name_of_a_member():
    assert_like_python(
        """
        from enum import Enum

        class Mode(Enum):
            IDLE = 1
            REST = 1
            BUSY = 2

        same = Mode.REST is Mode.IDLE
        name = Mode.REST.name
        names = [mode.name for mode in Mode]
        """
    )


def test_a_member_is_the_text_it_holds_where_its_class_is_a_text():
    assert_like_python(
        """
        from enum import Enum

        class Topic(str, Enum):
            SCAN = 'scan'

        joined = '/robot/' + Topic.SCAN
        value = Topic.SCAN.value
        """
    )


def test_where_pythons_differ_the_next_number_is_unknown():
    found = interpret(
        "from enum import Enum, auto\nclass It(Enum):\n    A = 5\n    B = 1\n    C = auto()\nit = It.C.value"
    )
    assert not found.is_known("it")


def test_which_member_it_is_is_one_of_them():
    found = interpret(
        f"{OUTSIDE}from enum import Enum\nclass It(Enum):\n    A = 1\n    B = 2\nit = It(outside.value()).value"
    )
    assert found.options("it") == {1, 2}


def test_a_dataclass_that_is_given_more_than_is_known():
    found = interpret(
        f"{OUTSIDE}from dataclasses import dataclass\n@dataclass\nclass Point:\n    x: int = 1\n    y: int = 2\n"
        "point = Point(5, *outside.value())\nx, y = point.x, point.y"
    )
    assert found.constant("x") == 5
    assert not found.is_known("y")


def test_named_tuples():
    assert_like_python(
        """
        from typing import NamedTuple

        class Limits(NamedTuple):
            low: int
            high: int = 9

        limits = Limits(1)
        by_name = limits.low, limits.high
        by_number = limits[0], limits[1]
        low, high = limits
        count = len(limits)
        listed = [each for each in limits]
        """
    )


def test_a_class_that_makes_one_object_only():
    assert_like_python(
        """
        class Only:
            made = None

            def __new__(cls):
                if cls.made is None:
                    cls.made = object.__new__(cls)
                return cls.made

        same = Only() is Only()
        """
    )


def test_subclasses_register():
    assert_like_python(
        """
        registry = []

        class Plugin:
            def __init_subclass__(cls, kind='none'):
                registry.append(kind)

        class Camera(Plugin, kind='camera'):
            pass

        class Other(Plugin):
            pass

        def register(cls):
            registry.append(cls.__name__)
            return cls

        @register
        class Lidar:
            pass

        names = [each.__name__ for each in Plugin.__subclasses__()]
        """
    )


def test_truth_of_objects():
    found = interpret(
        "class Plain:\n    pass\nclass Empty:\n    def __len__(self):\n        return 0\n"
        "class No:\n    def __bool__(self):\n        return False\n"
        "plain, empty, no = bool(Plain()), bool(Empty()), bool(No())"
    )
    assert found.constant("plain") is True
    assert not found.is_known("empty")
    assert not found.is_known("no")


def test_a_class_in_a_function_and_a_class_in_a_class():
    assert_like_python(
        """
        def make(name):
            class Named:
                def title(self):
                    return name
            return Named

        class Outer:
            class Inner:
                value = 3

            def inner(self):
                return self.Inner().value

        titles = make('a')().title(), make('b')().title()
        inner = Outer().inner(), Outer.Inner.value
        """
    )


def test_the_body_of_a_class_has_names_of_its_own():
    assert_like_python(
        """
        size = 7

        class Grid:
            size = 2
            cells = [0 for _ in range(size)]
            outer = [size for _ in range(2)]
            if size > 1:
                def area(self):
                    return size
            else:
                def area(self):
                    return 0

        cells, outer, area = Grid.cells, Grid.outer, Grid().area()
        """
    )


def test_a_base_that_depends_on_an_import_is_the_first_that_is_there():
    found = interpret(
        "try:\n    from outside import Base\nexcept ImportError:\n    class Base:\n        name = 'ours'\n"
        "class Robot(Base):\n    own = 1\nit = Robot.own"
    )
    assert found.constant("it") == 1


def test_nobody_inherits_from_a_module():
    interpreted = interpret("import robot.base as base\nclass Robot(base):\n    pass", robot__base="class Robot: pass")
    assert interpreted.reason("Robot") == "no class can inherit from a module"


def test_bases_and_keywords_of_a_class_are_evaluated_and_may_be_no_classes():
    interpreted = interpret(
        f"{OUTSIDE}seen = []\ndef meta(x):\n    seen.append(x)\n    return x\n"
        "class Robot(*outside.bases(), metaclass=meta(outside.Meta)):\n    name = 'r'\n"
        "it, count = Robot.name, len(seen)"
    )
    assert interpreted.constant("it") == "r"
    assert interpreted.constant("count") == 1


def test_an_order_of_bases_that_python_refuses_is_still_followed():
    interpreted = interpret(
        "class A:\n    name = 'a'\nclass B(A):\n    pass\ntry:\n    class C(A, B):\n        pass\n"
        "except TypeError:\n    pass\nit = C.name"
    )
    assert interpreted.constant("it") == "a"


def test_methods_that_a_body_defines_in_a_try_know_their_class():
    assert_like_python(
        """
        class Base:
            def name(self):
                return 'base'

        class Robot(Base):
            try:
                def name(self):
                    return super().name() + '!'
            except ValueError:
                pass

        it = Robot().name()
        """
    )


def test_the_end_of_a_long_chain_of_classes_is_unknown():
    links = "".join(f"class C{number}(C{number - 1}): pass\n" for number in range(1, CLASSES + 50))
    interpreted = interpret(f"class C0: pass\n{links}")
    for number, known in ((CLASSES - 1, True), (CLASSES + 49, False)):
        cls = interpreted.value(f"C{number}")
        assert isinstance(cls, ClassValue)
        assert all(isinstance(base, ClassValue) for base in cls.mro) is known
        assert len(cls.mro) == (CLASSES if known else CLASSES + 1)


def test_so_is_that_of_classes_with_two_bases_each():
    row = "class L{0}(A{0}): pass\nclass R{0}(A{0}): pass\nclass A{1}(L{0}, R{0}): pass\n"
    rows = "".join(row.format(number, number + 1) for number in range(60))
    cls = interpret(f"class A0: pass\n{rows}").value("A60")
    assert isinstance(cls, ClassValue)
    assert len(cls.mro) == CLASSES + 1
