"""API001: calls that rclpy refuses, and calls that look like them and work."""

from __future__ import annotations

import csv
from pathlib import Path

import pytest

from checks.judging import Judge

RAISED = Path(__file__).parents[2] / "tests_ros" / "wrong_calls.tsv"

NODE = """
from threading import Thread

import message_filters
import rclpy
from action_msgs.srv import CancelGoal
from example_interfaces.action import Fibonacci
from example_interfaces.action._fibonacci import Fibonacci_FeedbackMessage, Fibonacci_SendGoal
from rclpy.action import ActionClient, ActionServer
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.qos import QoSProfile, qos_profile_sensor_data
from std_msgs.msg import String
from std_srvs.srv import Trigger, Trigger_Event


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        {call}

    def tick(self):
        pass

    def listen(self, message):
        pass


def main():
    rclpy.init()
    rclpy.spin(Robot())
"""


@pytest.mark.parametrize(
    ("call", "wrong"),
    [
        ("self.create_publisher(String, 'a')", "'qos_profile' is missing"),
        ("self.create_publisher('a', String, 10)", "'msg_type' and 'topic' are swapped"),
        ("self.create_publisher('std_msgs/msg/String', 'a', 10)", "not the text 'std_msgs/msg/String'"),
        ("self.create_publisher(Robot, 'a', 10)", "'msg_type' takes a message class, not the class Robot"),
        ("self.create_publisher(Trigger, 'a', 10)", "'msg_type' takes a message class, not the class Trigger"),
        ("self.create_publisher(int, 'a', 10)", "'msg_type' takes a message class, not Python's int"),
        ("self.create_client(dict, 'a')", "'srv_type' takes a service class, not Python's dict"),
        ("self.create_publisher(QoSProfile, 'a', 10)", "'msg_type' takes a message class, not the class QoSProfile"),
        ("self.create_publisher(QoSProfile(depth=1), 'a', 10)", "'msg_type' takes a message class, not a QoSProfile"),
        ("self.create_publisher(QoSProfile(depth=1), 'a', String)", "'msg_type' and 'qos_profile' are swapped"),
        ("self.create_publisher(String, 'a', None)", "'qos_profile' takes a QoSProfile or a queue depth, not None"),
        ("self.create_publisher(String, 'a', -1)", "not the number -1"),
        ("self.create_publisher(String, 'a', 10, latch=True)", "it has no parameter 'latch'"),
        ("self.create_subscription(String, 'a', 10)", "'qos_profile' is missing"),
        ("self.create_subscription(String, 'a', 10, self.listen)", "'callback' and 'qos_profile' are swapped"),
        ("self.create_subscription(String, 'a', self.listen(1), 10)", "not what listen() returns: None"),
        ("self.create_timer(self.tick, 1.0)", "'timer_period_sec' and 'callback' are swapped"),
        ("self.create_timer(1.0, self.tick())", "not what tick() returns: None"),
        (
            "self.create_client(Fibonacci_FeedbackMessage, 'a')",
            "'srv_type' takes a service class, not the class Fibonacci_FeedbackMessage",
        ),
        ("self.create_client(Fibonacci, 'a')", "'srv_type' takes a service class, not the action Fibonacci"),
        ("self.create_service(String, 'a', self.listen)", "'srv_type' takes a service class, not the class String"),
        ("self.create_client('a', Trigger)", "'srv_type' and 'srv_name' are swapped"),
        ("self.create_client(Trigger, 'a').call_async()", "'request' is missing"),
        ("ActionClient(Fibonacci, 'a')", "'action_name' is missing"),
        ("ActionClient(self, 'a', Fibonacci)", "'action_type' and 'action_name' are swapped"),
        ("ActionServer(self, Fibonacci, 'a')", "'execute_callback' is missing"),
        ("QoSProfile(depth=1, reliable=True)", "it has no parameter 'reliable'"),
        ("message_filters.Subscriber(self, String)", "'topic' is missing"),
        ("message_filters.Subscriber(self, 'a', String)", "'msg_type' and 'topic' are swapped"),
        ("rclpy.spin(Robot)", "'node' takes a node, not the class Robot"),
        ("rclpy.spin_until_future_complete(rclpy.task.Future(), timeout_sec=1.0)", "'future' is missing"),
        ("self.declare_parameter()", "'name' is missing"),
        ("Parameter('gain', 2.0)", "'type_' takes a Parameter.Type, not the number 2.0"),
        ("self.set_parameters([Parameter('frame', 'map')])", "'type_' takes a Parameter.Type, not the text 'map'"),
        ("Parameter('names', ['a', 'b'])", "'type_' takes a Parameter.Type, not a list"),
        ("self.destroy_timer(self.tick)", "'entity' takes a timer, not the method tick"),
        ("self.destroy_publisher(self.create_client(Trigger, 'a'))", "'entity' takes a publisher, not a client"),
        ("self.destroy_subscription('a')", "'entity' takes a subscription, not the text 'a'"),
        ("SingleThreadedExecutor().add_node(Robot)", "'node' takes a node, not the class Robot"),
        (
            "Thread(target=print, args=(self.create_client(Trigger, 'a')))",
            "'args' takes a tuple of arguments, not a client",
        ),
        ("Thread(target=print, args=(1.5))", "'args' takes a tuple of arguments, not the number 1.5"),
        ("message_filters.TimeSynchronizer([])", "TimeSynchronizer() fails: 'queue_size' is missing"),
        ("message_filters.ApproximateTimeSynchronizer([], 10)", "'slop' is missing"),
        ("self.get_parameter('a', 1)", "it takes at most 1 argument by position"),
        (
            "self.create_timer(self.declare_parameter('period', 1.0), self.tick)",
            "create_timer() fails: 'timer_period_sec' takes a number of seconds, not a Parameter without .value",
        ),
        (
            "self.declare_parameter('name', 'a'); self.create_publisher(String, self.get_parameter('name'), 10)",
            "'topic' takes a text, not a Parameter without .value",
        ),
        (
            "self.declare_parameter('depth', 10); self.create_publisher(String, 'a', self.get_parameter('depth'))",
            "'qos_profile' takes a QoSProfile or a queue depth, not a Parameter without .value",
        ),
        ("self.create_publisher(String, 'a', 10)(String())", "calling a publisher fails: it is no function"),
        ("self.create_client(Trigger, 'a')(Trigger.Request())", "calling a client fails: it is no function"),
    ],
)
def test_a_call_that_is_refused(judge: Judge, call: str, wrong: str):
    [finding] = judge("API001", NODE.format(call=f"{call}  # here"))
    assert wrong in finding.message


@pytest.mark.parametrize(
    ("call", "help"),
    [
        ("QoSProfile(depth=1, reliable=True)", "write reliability= instead of reliable="),
        ("QoSProfile(depth=1, durable=True)", "write durability= instead of durable="),
        ("QoSProfile(depth=1, latched=True)", "take out latched="),
        ("Parameter('gain', 2.0)", "give the value by name, value=…: the type comes before it"),
    ],
)
def test_a_keyword_that_has_the_stem_of_another(judge: Judge, call: str, help: str):
    [finding] = judge("API001", NODE.format(call=f"{call}  # here"))
    assert finding.help == help


@pytest.mark.parametrize(
    "call",
    [
        "self.create_publisher(String, 'a', 10)",
        "self.create_publisher(msg_type=String, topic='a', qos_profile=10)",
        "self.create_publisher(String, 'a', qos_profile_sensor_data, callback_group=None)",
        "self.create_subscription(String, 'a', self.listen, 10, raw=True)",
        "self.create_subscription(String, 'a', lambda message: None, 10)",
        "self.create_subscription(Trigger.Event, 'a/_service_event', self.listen, 10)",
        "self.create_subscription(Trigger_Event, 'a/_service_event', self.listen, 10)",
        "self.create_publisher(Trigger.Request, 'a', 10)",
        "self.create_subscription(Fibonacci_FeedbackMessage, 'a/_action/feedback', self.listen, 10)",
        "self.create_publisher(Fibonacci_FeedbackMessage, 'a/_action/feedback', 10)",
        "self.create_client(Fibonacci_SendGoal, 'a/_action/send_goal')",
        "self.create_timer('1.0', self.tick)",
        "self.destroy_timer(self.create_timer(1.0, self.tick))",
        "self.destroy_publisher(self.create_publisher(String, 'a', 10))",
        "self.destroy_subscription(self.kept)",
        "SingleThreadedExecutor().add_node(self)",
        "Thread(target=rclpy.spin, args=(self,))",
        "Thread(target=print, args=[1.5])",
        "Thread(target=print, args='a')",
        "message_filters.TimeSynchronizer([], 10)",
        "message_filters.ApproximateTimeSynchronizer([], 10, 0.1)",
        "message_filters.ApproximateTimeSynchronizer([], 10, 0.1, sync_arrival_time=True)",
        "self.create_publisher(String, 'a', 10).publish(String())",
        "send = self.create_publisher(String, 'a', 10).publish; send(String())",
        "send = self.tick if rclpy.ok() else self.create_client(Trigger, 'a'); send()",
        "self.create_timer(self.declare_parameter('period', 1.0).value, self.tick)",
        "self.create_timer(1, self.tick, None)",
        "self.create_service(Trigger, 'a', lambda request, response: response)",
        "self.create_client(Trigger, 'a').call_async(Trigger.Request())",
        "ActionClient(self, Fibonacci, 'a')",
        "ActionServer(self, Fibonacci, 'a', execute_callback=self.listen)",
        "QoSProfile(depth=1)",
        "message_filters.Subscriber(self, String, 'a')",
        "rclpy.spin_once(self, timeout_sec=0.1)",
        "options = {}; options['callback_group'] = None; self.create_timer(1.0, self.tick, **options)",
        "arguments = [String, 'a', 10]; self.create_publisher(*arguments)",
        "self.create_publisher(self.declare_parameter('type', 'a').value, 'a', 10)",
        "self.get_logger(); self.create_rate(1.0)",
        "Parameter('gain', Parameter.Type.DOUBLE, 2.0)",
        "Parameter('gain', value=2.0)",
        "Parameter('gain', None, 2.0)",
        "Parameter('gain', self.type_of_gain, 2.0)",
        "rclpy.get_global_executor().create_task(self.listen, 1)",
    ],
)
def test_a_call_that_works(judge: Judge, call: str):
    judge("API001", NODE.format(call=call))


def test_a_call_that_supports_several_distributions(judge: Judge):
    judge(
        "API001",
        NODE.format(
            call="""try:
            self.create_timer(1.0, self.tick, autostart=False, of_the_next=True)
        except TypeError:
            self.create_timer(1.0, self.tick)
"""
        ),
    )


def test_what_is_true_of_one_value_of_several_is_no_finding(judge: Judge):
    judge("API001", NODE.format(call="self.create_publisher(String, 'a', 10 if rclpy.ok() else '10')"))


def test_a_class_with_a_create_method_of_its_own(judge: Judge):
    judge(
        "API001",
        """
        from rclpy.node import Node


        class Robot(Node):
            def __init__(self):
                super().__init__('robot')
                self.create_timer(1.0)

            def create_timer(self, period):
                return super().create_timer(period, lambda: None)
        """,
    )


def test_a_base_of_another_package_may_have_its_own(judge: Judge):
    judge(
        "API001",
        """
        from somewhere import RobotNode


        class Robot(RobotNode):
            def __init__(self):
                super().__init__('robot')
                self.create_timer(1.0)
        """,
    )


def test_what_one_distribution_refuses_is_said_where_that_is_the_one(judge: Judge):
    call = "self.create_timer(1.0, self.tick, autostart=False)"
    judge("API001", NODE.format(call=call))
    judge("API001", NODE.format(call=call), config='distro = "jazzy"')
    [finding] = judge("API001", NODE.format(call=f"{call}  # here"), config='distro = "humble"')
    assert finding.message == "create_timer() fails: it has no parameter 'autostart'"


def test_each_call_that_the_real_rclpy_was_seen_to_refuse():
    """What the table of tests_ros has: the words of the page are those of the real rclpy."""
    with RAISED.open(encoding="utf-8", newline="") as file:
        raised = {row["what is wrong"]: (row["jazzy"], row["kilted"]) for row in csv.DictReader(file, delimiter="\t")}
    assert raised["publisher without QoS"] == ("TypeError", "TypeError")
    assert raised["publisher, type and name swapped"] == ("TypeError", "TypeError")
    assert raised["publisher, service as type"] == ("RuntimeError", "RuntimeError")
    assert raised["subscription, callback called"] == ("RuntimeError", "RuntimeError")
    assert raised["timer, arguments swapped"] == ("TypeError", "TypeError")
    assert raised["action client without node"] == ("TypeError", "TypeError")
    assert raised["profile, unknown keyword"] == ("AssertionError", "TypeError")


def test_calls_of_a_file_that_are_wrong_in_the_same_way_are_one_finding(judge: Judge):
    calls = "self.create_publisher(String, 'a')  # here\n        self.create_publisher(String, 'b')"
    [finding] = judge("API001", NODE.format(call=calls))
    assert finding.message == (
        "create_publisher() fails: 'qos_profile' is missing; another call in this file fails in the same way"
    )
    assert finding.help == "write create_publisher(msg_type, topic, qos_profile)"
    assert [related.place.line for related in finding.related] == [21]


MIXED = """
    import rclpy
    from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
    from rclpy.lifecycle import LifecycleNodeMixin
    from rclpy.node import Node


    class Drone({bases}):
        def __init__(self):
            {first}
            {second}


    def main():
        rclpy.init()
        rclpy.spin(Drone())
"""


@pytest.mark.parametrize(
    ("bases", "first", "second"),
    [
        (
            "Node, LifecycleNodeMixin",
            "Node.__init__(self, 'drone')",
            "LifecycleNodeMixin.__init__(self, callback_group=MutuallyExclusiveCallbackGroup())",
        ),
        ("Node, LifecycleNodeMixin", "super().__init__('drone')", "LifecycleNodeMixin.__init__(self)"),
        (
            "Node, LifecycleNodeMixin",
            "Node.__init__(self, 'drone')",
            "LifecycleNodeMixin.__init__(self, 'drone')  # here",
        ),
        # Python asks the first base, which takes no name; tried with the rclpy of Jazzy.
        ("LifecycleNodeMixin, Node", "super().__init__('drone')  # here", "pass"),
    ],
)
def test_the_mixin_of_lifecycle_nodes_takes_no_name(judge: Judge, bases: str, first: str, second: str):
    judge("API001", MIXED.format(bases=bases, first=first, second=second))


@pytest.mark.parametrize(
    ("method", "wrong", "help"),
    [
        ("_init_", "'node_name' is missing, as _init_() is no constructor", "rename _init_() to __init__()"),
        ("__int__", "'node_name' is missing, as __int__() is no constructor", "rename __int__() to __init__()"),
        ("setup", "'node_name' is missing", "give Robot an __init__() that calls super().__init__(node_name)"),
    ],
)
def test_a_node_without_a_constructor(judge: Judge, method: str, wrong: str, help: str):
    [finding] = judge(
        "API001",
        f"""
        import rclpy
        from rclpy.node import Node


        class Robot(Node):
            def {method}(self):
                super().__init__('robot')


        def main():
            rclpy.init()
            rclpy.spin(Robot())  # here
        """,
    )
    assert (finding.message, finding.help) == (f"Robot() fails: {wrong}", help)


def test_feedback_is_not_asked_of_a_goal_handle(judge: Judge):
    """Without the call, what takes the feedback would never get any."""
    sent = "ActionClient(self, Fibonacci, 'go').send_goal_async(Fibonacci.Goal())"
    (finding,) = judge("API002", NODE.format(call=f"{sent}.result().get_feedback_async()  # here"))
    assert finding.help == "pass what takes the feedback to send_goal_async(goal, feedback_callback=…) instead"


def test_the_result_of_a_future_has_no_time_limit(judge: Judge):
    call = "self.create_client(Trigger, 'a').call_async(Trigger.Request()).result(timeout=2.0)  # here"
    (finding,) = judge("API001", NODE.format(call=call))
    assert finding.help == "result() never waits: continue in a done callback, where the future has its result"


@pytest.mark.parametrize("base", ["Node", "LifecycleNode"])
@pytest.mark.parametrize("method", ["tick", "on_configure"])
def test_a_call_in_a_callback_that_ends_there(judge: Judge, base: str, method: str):
    source = f"""
        import rclpy
        from rclpy.lifecycle import LifecycleNode
        from rclpy.node import Node
        from std_msgs.msg import String


        class Robot({base}):
            def __init__(self):
                super().__init__('robot')
                self.create_timer(1.0, self.tick)

            def tick(self):
                pass

            def {method}(self, *state):
                self.publisher = self.create_publisher(String, 'a')  # here


        def main():
            rclpy.init()
            rclpy.spin(Robot())
    """
    [finding] = judge("API001", source)
    assert finding.message == "create_publisher() fails: 'qos_profile' is missing"


def test_a_timer_that_is_to_run_once(judge: Judge):
    [finding] = judge(
        "API001",
        """
        import rclpy

        rclpy.init()
        node = rclpy.create_node('robot')
        node.create_timer(1.0, print, one_shot=True)  # here
        """,
    )
    assert (finding.help or "").endswith("and end the callback with the timer's cancel()")


THREAD = """
    import threading

    import rclpy
    from rclpy.node import Node
    from std_msgs.msg import Float32


    class Robot(Node):
        def __init__(self):
            super().__init__('robot')
            self.create_subscription(Float32, 'speed', self.listen, 10)

        def listen(self, message):
            self.start({given})

        def start(self, speed):
            thread = threading.Thread(target=self.drive, args={args}, daemon=True)  {mark}
            thread.start()

        def drive(self, {parameters}):
            if {test}:
                print('forwards')


    def main():
        rclpy.init()
        rclpy.spin(Robot())


    main()
"""


@pytest.mark.parametrize("given", ["self.read()", "max(0.0, read())", "float(message.data)"])
def test_a_number_for_the_arguments_of_a_thread(judge: Judge, given: str):
    """`args=(speed)` is the number itself; the function compares it with one."""
    source = THREAD.format(given=given, args="(speed)", parameters="speed", test="speed > 0.0", mark="# here")
    (told,) = judge("API001", source)
    assert "'args' takes a tuple of arguments, not " in told.message and "number" in told.message
    assert told.help == "put a comma behind it, which makes the tuple: args=(…,)"


@pytest.mark.parametrize(
    ("args", "parameters", "test"),
    [
        ("(speed,)", "speed", "speed > 0.0"),
        ("(speed)", "speed", "speed == 0.0"),
        ("(speed)", "speed", "len(speed) > 0"),
        ("(speed)", "limit", "limit > 0.0"),
        ("(speed)", "speed, limit", "speed > 0.0"),
        ("(speed)", "*speed", "speed > 0.0"),
        ("[speed]", "speed", "speed > 0.0"),
    ],
)
def test_what_may_be_the_arguments_of_a_thread(judge: Judge, args: str, parameters: str, test: str):
    judge("API001", THREAD.format(given="self.read()", args=args, parameters=parameters, test=test, mark=""))


@pytest.mark.parametrize(
    ("call", "help"),
    [
        ("self.create_client(Fibonacci, 'a')", "use ActionClient of rclpy.action"),
        ("self.create_service(Fibonacci, 'a', self.listen)", "use ActionServer of rclpy.action"),
        ("self.create_client(String, 'a')", "pass a service class"),
    ],
)
def test_an_action_in_place_of_a_service(judge: Judge, call: str, help: str):
    [finding] = judge("API001", NODE.format(call=f"{call}  # here"))
    assert finding.help == help


CALLED_FOR_A_THREAD = """
    import threading

    import rclpy
    from rclpy.executors import SingleThreadedExecutor
    from rclpy.node import Node


    class Robot(Node):
        def drive(self):
            print('forwards')

        def maker(self):
            return self.drive


    def main():
        rclpy.init()
        robot = Robot('robot')
        executor = SingleThreadedExecutor()
        executor.add_node(robot)
        threading.{thread}.start()  {mark}


    main()
"""


@pytest.mark.parametrize(
    ("thread", "what"),
    [
        ("Thread(target=rclpy.spin(robot))", "Thread() starts nothing: 'target' takes a function, not what spin()"),
        ("Thread(target=executor.spin())", "Thread() starts nothing: 'target' takes a function, not what spin()"),
        ("Thread(target=robot.drive(), daemon=True)", "Thread() starts nothing: 'target' takes a function, not what"),
        ("Timer(1.0, robot.drive())", "Timer() starts nothing: 'function' takes a function, not what drive() returns"),
    ],
)
def test_a_thread_whose_function_is_called_at_once(judge: Judge, thread: str, what: str):
    (finding,) = judge("API001", CALLED_FOR_A_THREAD.format(thread=thread, mark="# here"))
    assert finding.message.startswith(what)
    assert finding.help == "pass the function itself, without parentheses"


@pytest.mark.parametrize(
    "thread",
    [
        "Thread(target=rclpy.spin, args=(robot,))",
        "Thread(target=executor.spin)",
        "Thread(target=robot.maker())",
        "Thread(target=lambda: rclpy.spin(robot))",
        "Thread(target=None)",
        "Timer(1.0, robot.drive)",
    ],
)
def test_a_thread_that_gets_its_function(judge: Judge, thread: str):
    judge("API001", CALLED_FOR_A_THREAD.format(thread=thread, mark=""))


@pytest.mark.parametrize(
    ("call", "help"),
    [
        ("Duration(5)", "give it by name: Duration(seconds=…)"),
        ("Time(0)", "give it by name: Time(seconds=…)"),
        ("rclpy.init(None)", "give it by name: init(args=…)"),
    ],
)
def test_what_goes_by_name_alone(judge: Judge, call: str, help: str):
    source = NODE.replace(
        "import rclpy\n", "import rclpy\nfrom rclpy.duration import Duration\nfrom rclpy.time import Time\n"
    )
    [finding] = judge("API001", source.format(call=f"{call}  # here"))
    assert finding.message.endswith("fails: it takes no argument by position")
    assert finding.help == help


@pytest.mark.parametrize(
    ("given", "help"),
    [
        ("10", "write timeout_sec= instead of timeout="),
        ("Duration(seconds=10)", "write timeout_sec=10.0 instead of timeout=Duration(…): it takes a number of seconds"),
        ("Duration(seconds=self.limit)", "write timeout_sec=self.limit instead of timeout=Duration(…): it takes a "),
        (
            "Duration(nanoseconds=10)",
            "write timeout_sec=… instead of timeout=Duration(…): it takes a number of seconds",
        ),
    ],
)
def test_a_duration_where_a_number_of_seconds_is_wanted(judge: Judge, given: str, help: str):
    source = NODE.replace(
        "import rclpy\n", "import rclpy\nfrom rclpy.duration import Duration\nfrom std_srvs.srv import Empty\n"
    )
    call = f"self.create_client(Empty, 'go').wait_for_service(timeout={given})  # here"
    [finding] = judge("API001", source.format(call=call))
    assert finding.message == "wait_for_service() fails: it has no parameter 'timeout'"
    assert (finding.help or "").startswith(help)
