"""API002: properties of a node that are assigned, and attributes that no path assigns."""

from __future__ import annotations

import pytest

from archlint.finding import Severity
from checks.judging import Judge

# ------------------------------------------------------------------------------------------ properties of a node


@pytest.mark.parametrize(
    "name", ["clients", "context", "default_callback_group", "guards", "handle", "publishers", "timers", "waitables"]
)
def test_a_property_that_cannot_be_assigned(judge: Judge, name: str):
    (finding,) = judge(
        "API002",
        f"""
        from rclpy.node import Node

        class Robot(Node):
            def __init__(self):
                super().__init__('robot')
                self.{name} = []  # here
        """,
    )
    assert finding.message == (
        f"'{name}' is a property of Node that cannot be assigned: this line fails with an AttributeError"
    )
    assert finding.help == f"give the attribute another name, such as self.my_{name}"


def test_a_property_that_several_lines_assign_is_one_finding(judge: Judge):
    (finding,) = judge(
        "API002",
        """
        import rclpy.node

        class Base(rclpy.node.Node):
            pass

        class Robot(Base):
            def __init__(self):
                super().__init__('robot')
                self.services, self.count = {}, 0  # here

            def reset(self):
                self.services = {}
        """,
    )
    assert finding.message.endswith("; another line of the class does the same")


def test_what_is_a_property_of_something_else(judge: Judge):
    judge(
        "API002",
        """
        from somewhere import Mixin
        from rclpy.node import Node

        class Manager:
            def __init__(self):
                self.publishers = []

        class Mixed(Mixin, Node):
            def __init__(self):
                self.publishers = []

        class Shadowed(Node):
            publishers = ()

            def __init__(self):
                super().__init__('shadowed')
                self.publishers = []
                self.executor = None
                self.publishers_ = []
                self.clients.append(1)

        class Careful(Node):
            def __init__(self):
                super().__init__('careful')
                try:
                    self.timers = []
                except AttributeError:
                    self.own_timers = []

        class Free(Node):
            def __setattr__(self, name, value):
                object.__setattr__(self, 'own_' + name, value)

            def start(self):
                self.timers = []
        """,
    )


# ------------------------------------------------------------------------------------- attributes that nothing assigns


def test_a_read_of_a_name_that_is_almost_assigned(judge: Judge):
    (finding,) = judge(
        "API002",
        """
        from rclpy.node import Node
        from std_msgs.msg import String

        class Talker(Node):
            def __init__(self):
                super().__init__('talker')
                self.publisher = self.create_publisher(String, 'chatter', 10)

            def nobody_calls_this(self):
                self.publsher.publish(String())  # here
        """,
    )
    assert finding.message == (
        "nothing assigns 'publsher' of class Talker: this line fails with an AttributeError; did you mean 'publisher'?"
    )
    assert finding.help == "write self.publisher"
    assert [row.place.line for row in finding.related] == [7]


def test_a_near_name_that_was_hardly_meant(judge: Judge):
    (finding,) = judge(
        "API002",
        """
        from rclpy.node import Node

        class Planner(Node):
            def start(self):
                self.obstacle_threshold = 1.0

            def plan(self, speed):
                return speed < self.obstacle_velocity_threshold  # here
        """,
    )
    assert finding.message.endswith("this line fails with an AttributeError")
    assert finding.help == "assign self.obstacle_velocity_threshold in __init__(), or define it"


def test_a_node_that_looks_for_its_node(judge: Judge):
    (finding,) = judge(
        "API002",
        """
        import rclpy
        from rclpy.node import Node

        class Trainer(Node):
            def __init__(self):
                super().__init__('trainer')
                self.create_timer(1.0, self.step)

            def step(self):
                self.node.get_logger().info('not there yet')  # here

        rclpy.init()
        rclpy.spin(Trainer())
        """,
    )
    assert finding.message == "nothing assigns 'node' of class Trainer: this line fails with an AttributeError"
    assert finding.help == "write self instead of self.node: the object is the node itself"


def test_private_names_and_methods(judge: Judge):
    first, second = judge(
        "API002",
        """
        from rclpy.node import Node

        class Counter(Node):
            def __init__(self):
                super().__init__('counter')
                self.__count = 0

            def step(self):
                self.__cuont += 1  # here
                self.publish_stat()  # here

            def publish_state(self):
                return self.__count
        """,
    )
    assert first.message.startswith("nothing assigns '__cuont' of class Counter")
    assert first.message.endswith("; did you mean '__count'?")
    assert second.help == "write self.publish_state"


@pytest.mark.parametrize(
    "more",
    [
        "def attach(talker):\n    talker.publsher = None\n",
        "class Loud(Talker):\n    publsher = None\n",
        "class Loud(Talker):\n    def __init__(self):\n        super().__init__()\n        self.publsher = None\n",
        "class Mixin:\n    def make(self):\n        self.publsher = None\n\nclass Loud(Mixin, Talker):\n    pass\n",
        "from somewhere import Mixin\n\nclass Loud(Mixin, Talker):\n    pass\n",
        "def attach(talker):\n    setattr(talker, 'publsher', None)\n",
    ],
)
def test_an_attribute_that_comes_from_elsewhere(judge: Judge, more: str):
    talker = """\
from rclpy.node import Node

class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.publisher = None

    def talk(self):
        return self.publsher
"""
    judge("API002", f"{talker}\n{more}")


@pytest.mark.parametrize(
    ("bases", "body"),
    [
        ("Node", "def __getattr__(self, name):\n        return None"),
        ("Node", "def fill(self, rows):\n        self.__dict__.update(rows)"),
        ("Node", "def fill(self, rows):\n        for row in rows:\n            setattr(self, row, rows[row])"),
        ("Node", "publsher = None"),
        ("Node", "publsher: str"),
        ("Node", "def publsher(self):\n        pass"),
        ("Node", "def fill(self, rows):\n        for self.publsher in rows:\n            pass"),
        ("Node", "def fill(self, rows):\n        with rows as self.publsher:\n            pass"),
        ("Base, Node", "pass"),
        ("Node, metaclass=Base", "pass"),
    ],
)
def test_a_class_that_may_have_the_attribute(judge: Judge, bases: str, body: str):
    judge(
        "API002",
        f"""
from rclpy.node import Node
from somewhere import Base

class Talker({bases}):
    {body}

    def start(self):
        self.publisher = None

    def talk(self):
        return self.publsher
""",
    )


@pytest.mark.parametrize(
    ("base", "reads"),
    [
        ("enum.IntEnum", "self.value, self.name, self._value_, self._name_, self.numerator, self.real"),
        ("enum.Enum", "self.value, self.name"),
        ("enum.Flag", "self.value, self.name"),
        ("typing.NamedTuple", "self.count(1), self.index(1), self._asdict(), self._replace(), self._fields"),
    ],
)
@pytest.mark.parametrize("more", ["", ", self.vlue"])
def test_what_a_base_of_python_brings(judge: Judge, base: str, reads: str, more: str):
    mark = "  # here" if more else ""
    found = judge(
        "API002",
        f"""
        import enum
        import typing
        import rclpy

        class Side({base}):
            left: int = 0

            def other(self):
                return {reads}{more}{mark}

        print(Side(0).other())
        """,
    )
    assert all("'vlue'" in finding.message for finding in found)


@pytest.mark.parametrize("bases", ["int", "str, enum.Enum", "dict", "Exception"])
def test_what_a_class_that_is_built_in_brings(judge: Judge, bases: str):
    judge(
        "API002",
        f"""
        import enum
        import rclpy

        class Own({bases}):
            left = 1

            def show(self):
                return self.real, self.args, self.upper(), self.items(), self.value

        print(Own(1).show())
        """,
    )


def test_what_asks_first_whether_it_is_there(judge: Judge):
    judge(
        "API002",
        """
        from rclpy.node import Node

        class Talker(Node):
            def start(self):
                self.publisher = None

            def talk(self):
                try:
                    return self.publsher
                except AttributeError:
                    return None

            def write(self):
                return self.publishr if hasattr(self, 'publishr') else None

            @staticmethod
            def read(self):
                return self.publishe

            def nested(self):
                class Inner:
                    def read(self):
                        return self.publishes
                return Inner
        """,
    )


def test_names_that_are_only_alike_in_part(judge: Judge):
    judge(
        "API002",
        """
        from rclpy.node import Node

        class Motors(Node):
            def start(self):
                self.motor_1 = 1
                self.left_speed = 0.0

            def read(self):
                return self.motor_2 + self.right_speed

            def odom_cb(self):
                self.odom_pub.publish(None)  # a method is no publisher
        """,
    )


# ------------------------------------------------------------------------------------- names that nothing is like


def test_an_attribute_that_nothing_assigns(judge: Judge):
    (finding,) = judge(
        "API002",
        """
        from rclpy.node import Node

        class Robot(Node):
            def __init__(self):
                super().__init__('robot')
                self.speed = 1.0

            def stop(self):
                self.brake.close()  # here

        Robot()
        """,
    )
    assert finding.message == "nothing assigns 'brake' of class Robot: this line fails with an AttributeError"
    assert finding.help == "assign self.brake in __init__(), or define it"


ARM = """
from rclpy.node import Node

class Arm(Node):
    def __init__(self):
        super().__init__('arm')

    def start(self):
        brake = open('brake')
        brake.close()

    def again(self):
        {again}

    def stop(self):
        self.brake.close()  # here

Arm()
"""


@pytest.mark.parametrize(
    ("again", "help"),
    [
        ("pass", "write self.brake instead of brake in start(), where it is a variable of that method"),
        ("brake = None", "assign self.brake in __init__(), or define it"),  # either may be meant
    ],
)
def test_a_variable_of_another_method_was_to_be_the_attribute(judge: Judge, again: str, help: str):
    (finding,) = judge("API002", ARM.replace("{again}", again))
    assert finding.help == help
    assert [row.place.line for row in finding.related] == ([8] if again == "pass" else [])


def test_a_variable_of_the_method_was_meant(judge: Judge):
    (finding,) = judge(
        "API002",
        """
        from rclpy.lifecycle import Node

        class Robot(Node):
            def limit(self, speed):
                highest = 3.0
                return min(speed, self.highest)  # here

        Robot('robot')
        """,
    )
    assert finding.message.endswith("; did you mean the variable 'highest'?")
    assert finding.help == "write highest"


def test_a_class_that_should_be_a_node(judge: Judge):
    (finding,) = judge(
        "API002",
        """
        import rclpy

        class Robot(object):
            def __init__(self):
                self.declare_parameter('speed', 1.0)  # here
                self.get_logger().info('ready')

        rclpy.init()
        Robot()
        """,
    )
    assert finding.message == (
        "class Robot has no 'declare_parameter', which only a node has: this line fails with an AttributeError; "
        "another attribute of the class is like that"
    )
    assert finding.help == "derive the class from Node, or call declare_parameter() of a node"


@pytest.mark.parametrize(
    "rest",
    [
        "",  # nobody makes one here: it may be a base
        "class Arm(Robot):\n    brake = None\n\nRobot()",
        "Robot().brake = None",
        "robot = Robot()\nrobot.brake = None",
        "Robot.brake = None\nRobot()",
        "def equip(robot):\n    robot.brake = None\n\nequip(Robot())",
        "def equip(robot, name='brake'):\n    robot.__setattr__(name, None)\n\nequip(Robot())",
        "Robot = wrapped(Robot)\nRobot()",
    ],
)
def test_what_other_code_may_assign(judge: Judge, rest: str):
    judge(
        "API002",
        f"""
from rclpy.node import Node

class Robot(Node):
    def stop(self):
        self.brake.close()

{rest}
""",
    )


ROBOT = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32

class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.pub = self.create_publisher(Float32, 'speed', 10)
        self.limit = self.declare_parameter('brake', 1.0).value
        self.create_timer(1.0, self.stop)

    def stop(self):
        self.pub.publish(Float32(data=self.brake)){mark}

class Wheel:
    def __init__(self):
        self.brake = None

class Motor:
    def equip(self, wheel):
        wheel.brake = 1.0

    def equipped(self, wheel):
        self.equip(wheel)
        return wheel

def main():
    rclpy.init()
    node = {make}
    {use}
    rclpy.spin(node)
    if node is not None:
        node.destroy_node()
"""


def test_what_other_code_gives_to_other_objects(judge: Judge):
    """Nobody but the program has the node: neither the text of a parameter nor another object's attribute is one of
    it."""
    (finding,) = judge("API002", ROBOT.format(mark="  # here", make="Robot()", use="node.get_logger().info('ready')"))
    assert finding.message == "nothing assigns 'brake' of class Robot: this line fails with an AttributeError"


@pytest.mark.parametrize(
    ("make", "use"),
    [
        ("Robot()", "Motor().equip(node)"),
        ("Robot()", "node.brake = 1.0"),
        ("Robot()", "Robot.brake = 1.0"),
        ("Robot()", "setattr(node, 'brake', 1.0)"),
        ("Robot()", "nodes = [node]"),
        ("Motor().equipped(Robot())", "pass"),
    ],
)
def test_a_node_that_others_have(judge: Judge, make: str, use: str):
    judge("API002", ROBOT.format(mark="", make=make, use=use))


@pytest.mark.parametrize(
    "other",
    [
        "from node import Robot\n\ndef run():\n    equip(Robot())\n\ndef equip(robot):\n    robot.brake = 1.0",
        "import node\n\ndef run():\n    equip(node.Robot())\n\ndef equip(robot):\n    robot.brake = 1.0",
        "from node import *\n\ndef run():\n    equip(Robot())\n\ndef equip(robot):\n    robot.brake = 1.0",
    ],
)
def test_a_node_that_another_file_makes(judge: Judge, other: str):
    judge("API002", ROBOT.format(mark="", make="Robot()", use="pass"), other)


@pytest.mark.parametrize(
    "given", ["wheel = Motor().equip(self)", "self.wheels = [self]", "getattr(self, 'brake')", "return self"]
)
def test_a_node_that_gives_itself_away(judge: Judge, given: str):
    robot = ROBOT.replace(
        "self.create_timer(1.0, self.stop)",
        f"self.create_timer(1.0, self.stop)\n\n    def give(self):\n        {given}",
    )
    judge("API002", robot.format(mark="", make="Robot()", use="pass"))


def test_a_text_makes_no_attribute_where_nothing_sets_one_by_its_name(judge: Judge):
    judge(
        "API002",
        """
        from rclpy.node import Node

        class Robot(Node):
            def __init__(self):
                super().__init__('robot')
                self.declare_parameter('brake', 1.0)

            def stop(self):
                return self.brake  # here

        def robots():
            return [Robot()]
        """,
    )


def test_what_is_called_is_no_data(judge: Judge):
    """``missing_parts`` is a list: what was called is another thing that is not there, as is the other handler."""
    (finding,) = judge(
        "API002",
        """
        import rclpy

        class Robot:
            def __init__(self):
                self.missing_parts = []

            def handle(self):
                self.handle_missing_part()  # here
                self.handle_command()

        Robot().handle()
        """,
    )
    assert "did you mean" not in finding.message
    assert finding.message.endswith("; another attribute of the class is like that")


@pytest.mark.parametrize(
    ("use", "help"),
    [
        ("self.get_logger().info('done')", "derive the class from Node, or call get_logger() of a node"),
        ("self.executor.shutdown()", "assign self.executor in __init__(), or define it"),
    ],
)
def test_methods_of_a_node_in_a_class_that_is_none(judge: Judge, use: str, help: str):
    (finding,) = judge(
        "API002",
        f"""
        import rclpy

        class Planner:
            def stop(self):
                {use}  # here

        Planner().stop()
        """,
    )
    assert finding.help == help


UNCALLED = """
    import rclpy
    from rclpy.node import Node
    from std_msgs.msg import Int32


    class Counter(Node):
        def __init__(self):
            super().__init__('counter')
            self.publisher = self.create_publisher(Int32, 'count', 10)
            {caller}

        def tick(self):
            message = Int32(data=self.total)
            self.publisher.publish(message)
            message.number = 1


    def main():
        rclpy.init()
        rclpy.spin(Counter())


    if __name__ == '__main__':
        main()
"""


@pytest.mark.parametrize(
    ("caller", "told"),
    [
        ("self.create_timer(1.0, self.tick)", True),
        ("self.ready = True", False),
        ("self.ready = True\n\n        def again(self):\n            self.tick()", False),
        ("self.again()\n\n        def again(self):\n            self.tick()", True),
    ],
    ids=["a timer", "nothing", "a method that nothing calls", "a method that is called"],
)
@pytest.mark.parametrize(
    ("code", "line"), [("API002", "message = Int32(data=self.total)"), ("MSG001", "message.number = 1")]
)
def test_a_method_that_nothing_calls_fails_for_nobody(judge: Judge, caller: str, told: bool, code: str, line: str):
    source = UNCALLED.replace("{caller}", caller)
    judge(code, source.replace(line, f"{line}  # here") if told else source)


OTHERS = "import rclpy\nfrom rclpy.node import Node\n" + "".join(
    f"\n\nclass Idle{number}(Node):\n    def __init__(self):\n        super().__init__('idle{number}')\n"
    for number in range(5)
)


@pytest.mark.parametrize("code", ["API002", "MSG001"])
def test_a_method_that_nothing_calls_in_a_large_workspace(judge: Judge, code: str):
    """Whoever learns is told of it; elsewhere it is a leftover."""
    text = UNCALLED.replace("{caller}", "self.ready = True").replace("message = Int32(", "message = Int32(other=1, ")
    judge(code, text, OTHERS)
    called = text.replace("self.ready = True", "self.create_timer(1.0, self.tick)")
    line = "message = Int32(other=1, data=self.total)"
    assert len(judge(code, called.replace(line, f"{line}  # here"), OTHERS)) == 1


SWITCHED = """
    import rclpy
    from rclpy.node import Node


    class Swarm(Node):
        def __init__(self):
            super().__init__('swarm')
            self.rotating = False
            self.create_timer(1.0, self.tick)

        def tick(self):
            if {test}:
                print(self.axis){here}
                self.rotating = False
            {more}


    def main():
        rclpy.init()
        rclpy.spin(Swarm())


    if __name__ == '__main__':
        main()
"""


@pytest.mark.parametrize(
    ("test", "more", "here"),
    [
        ("self.rotating", "", ""),
        ("self.rotating == True", "", ""),
        ("self.rotating is True and rclpy.ok()", "", ""),
        ("self.rotating or rclpy.ok()", "", "  # here"),
        ("not self.rotating", "", "  # here"),
        ("self.rotating", "self.rotating = rclpy.ok()", "  # here"),
        ("self.rotating", "self.rotating |= rclpy.ok()", "  # here"),
    ],
)
def test_code_behind_a_flag_that_stays_false(judge: Judge, test: str, more: str, here: str):
    source = SWITCHED.replace("{test}", test).replace("{more}", more).replace("{here}", here)
    judge("API002", source, OTHERS)


def test_another_file_may_switch_it_on(judge: Judge):
    source = SWITCHED.replace("{test}", "self.rotating").replace("{more}", "").replace("{here}", "  # here")
    judge("API002", source, OTHERS + "\n\ndef turn(swarm):\n    swarm.rotating = True\n")


SUBSCRIBES = "self.create_subscription = self.create_subscription(String, topic, self.listen, 10)"
REPLACES = "self.create_publisher = self.create_publisher(String, 'a', 10)"
PUBLISHES = "self.pub = self.create_publisher(String, 'b', 10)"
OVERWRITING = """
from rclpy.node import Node
from std_msgs.msg import String


class Listener(Node):
    def __init__(self):
        super().__init__('listener')
{lines}

    def listen(self, msg):
        self.get_logger().info(msg.data)
"""


@pytest.mark.parametrize(
    "lines",
    [
        [
            "for topic in ('a', 'b'):",
            f"    {SUBSCRIBES}  # here",
        ],
        ["self.get_logger = self.get_logger()  # here"],
        [
            f"{REPLACES}  # here",
            PUBLISHES,
        ],
    ],
)
def test_a_method_of_the_node_that_its_result_replaces(judge: Judge, lines: list[str]):
    (finding,) = judge("API002", OVERWRITING.format(lines="\n".join(f"        {line}" for line in lines)))
    assert finding.message.endswith("is no method of the node: calling it fails with a TypeError")
    assert finding.help is not None
    assert finding.help.startswith("give the attribute another name")


@pytest.mark.parametrize(
    "lines",
    [
        [REPLACES],
        [
            PUBLISHES,
            REPLACES,
        ],
        ["self.get_logger = lambda: self.log", "self.log = print"],
    ],
)
def test_a_method_of_the_node_that_nothing_calls_again(judge: Judge, lines: list[str]):
    judge("API002", OVERWRITING.format(lines="\n".join(f"        {line}" for line in lines)))


ASKS_PORT = "if hasattr(self, 'port'):"
ASKING = """
import rclpy
from rclpy.node import Node


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.ser = open('/dev/ttyUSB0')
        self.timer = self.create_timer(1.0, self.stop)

    def stop(self):
        {line}
            self.ser.close()


def main():
    rclpy.init()
    rclpy.spin(Driver())


main()
"""


def test_hasattr_of_what_nothing_assigns(judge: Judge):
    (finding,) = judge("API002", ASKING.format(line="if hasattr(self, 'Ser'):  # here"))
    assert finding.message == ("nothing assigns 'Ser' of class Driver: hasattr() is always False; did you mean 'ser'?")
    assert finding.severity is Severity.WARNING


@pytest.mark.parametrize(
    "source",
    [
        ASKING.format(line="if hasattr(self, 'ser'):"),
        ASKING.format(line="if hasattr(self, 'get_logger'):"),
        ASKING.format(line="self.serial = self.ser\n        if hasattr(self, 'serial'):"),
        ASKING.format(line="if hasattr(self.ser, 'fileno'):"),
        ASKING.format(line="if hasattr(self, 'port'):").replace(
            "rclpy.spin(Driver())", "driver = Driver(); driver.port = 1"
        ),
        ASKING.format(line=ASKS_PORT).replace("self.ser = ", "setattr(self, 'port', 1); self.ser = "),
    ],
)
def test_hasattr_of_what_may_be_there(judge: Judge, source: str):
    judge("API002", source)


OTHER_CLASS = """
    import rclpy
    from rclpy.node import Node

    class Machine:
        def toggle(self):
            pass

    class Robot(Node):
        def __init__(self):
            super().__init__('robot')
            self.machine = Machine()
            self.timer = self.create_timer(1.0, self.tick)
            {given}

        def tick(self):
            self.machine.toggle()
            self.toggle(){here}

    def main():
        rclpy.init()
        rclpy.spin(Robot())

    main()
"""


def test_a_method_that_only_another_class_has(judge: Judge):
    (finding,) = judge("API002", OTHER_CLASS.replace("{given}", "pass").replace("{here}", "  # here"))
    assert finding.message == "nothing assigns 'toggle' of class Robot: this line fails with an AttributeError"


@pytest.mark.parametrize("given", ["self.toggle = self.machine.toggle", "setattr(self, 'toggle', print)"])
def test_a_method_that_the_object_is_given(judge: Judge, given: str):
    judge("API002", OTHER_CLASS.replace("{given}", given).replace("{here}", ""))
