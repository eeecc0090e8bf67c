"""The stand-in for rclpy records what a node creates, at the user's line."""

from __future__ import annotations


def test_a_node_with_one_of_each(execute):
    record = execute(
        """
        import rclpy
        from rclpy.action import ActionClient, ActionServer
        from rclpy.node import Node
        from example_interfaces.action import Fibonacci
        from std_msgs.msg import String
        from std_srvs.srv import Trigger


        class Robot(Node):
            def __init__(self):
                super().__init__("robot", namespace="fleet")
                self.create_publisher(String, "status", 10)
                self.create_subscription(String, "/orders", self.on_order, 5)
                self.create_service(Trigger, "~/reset", self.on_reset)
                self.create_client(Trigger, "dock")
                ActionServer(self, Fibonacci, "count", self.on_count)
                ActionClient(self, Fibonacci, "/count")
                self.create_timer(0.5, self.tick)

            def on_order(self, message): ...
            def on_reset(self, request, response): return response
            def on_count(self, goal): ...
            def tick(self): ...


        def main():
            rclpy.init()
            rclpy.spin(Robot())


        if __name__ == "__main__":
            main()
        """
    )
    seen = [(each["line"], each["kind"], each["name"], each["type"]) for each in record["entities"]]
    assert seen == [
        (12, "publisher", "/fleet/status", "std_msgs/msg/String"),
        (13, "subscriber", "/orders", "std_msgs/msg/String"),
        (14, "service", "/fleet/robot/reset", "std_srvs/srv/Trigger"),
        (15, "client", "/fleet/dock", "std_srvs/srv/Trigger"),
        (16, "action_server", "/fleet/count", "example_interfaces/action/Fibonacci"),
        (17, "action_client", "/count", "example_interfaces/action/Fibonacci"),
        (18, "timer", None, None),
    ]
    assert {each["node"] for each in record["entities"]} == {"/fleet/robot"}
    assert {each["class"] for each in record["entities"]} == {"Robot"}
    assert record["entities"][1]["callback"] == "Robot.on_order"
    assert record["entities"][6]["period_s"] == 0.5


def test_the_line_is_where_the_call_begins(entities):
    assert entities(
        """
        import rclpy
        from std_msgs.msg import String

        node = rclpy.create_node("talker")
        publisher = (
            node
            .create_publisher(
                String,
                "a" +
                "b",
                10,
            )
        )
        rclpy.spin(node)
        if __name__ == "__main__":
            pass
        """
    ) == [(6, "publisher", "/ab")]


def test_helpers_of_tf_and_message_filters_are_noted_at_the_users_line(execute):
    record = execute(
        """
        import message_filters
        import tf2_ros
        from rclpy.node import Node
        from sensor_msgs.msg import Image


        class Vision(Node):
            def __init__(self):
                super().__init__("vision")
                self.buffer = tf2_ros.Buffer(node=self)
                self.listener = tf2_ros.TransformListener(self.buffer, self)
                self.broadcaster = tf2_ros.StaticTransformBroadcaster(self)
                self.images = message_filters.Subscriber(self, Image, "image")
        """
    )
    seen = [(each["line"], each["kind"], each["name"], each["qos"]["durability"]) for each in record["entities"]]
    assert seen == [
        (10, "service", "/tf2_frames", "volatile"),
        (11, "subscriber", "/tf", "volatile"),
        (11, "subscriber", "/tf_static", "transient_local"),
        (12, "publisher", "/tf_static", "transient_local"),
        (13, "subscriber", "/image", "volatile"),
    ]


def test_quality_of_service_in_all_its_forms(execute):
    record = execute(
        """
        from rclpy.node import Node
        from rclpy.qos import DurabilityPolicy, HistoryPolicy, ReliabilityPolicy
        from rclpy.qos import QoSPresetProfiles, QoSProfile, qos_profile_sensor_data
        from std_msgs.msg import String


        class Talker(Node):
            def __init__(self):
                super().__init__("talker")
                changed = QoSProfile(depth=1)
                changed.durability = DurabilityPolicy.TRANSIENT_LOCAL
                self.create_publisher(String, "a", 7)
                self.create_publisher(String, "b", changed)
                self.create_publisher(String, "c", qos_profile_sensor_data)
                self.create_publisher(String, "d", QoSPresetProfiles.SYSTEM_DEFAULT.value)
                unreliable = ReliabilityPolicy.BEST_EFFORT
                everything = QoSProfile(history=HistoryPolicy.KEEP_ALL, reliability=unreliable)
                self.create_publisher(String, "e", everything)
        """
    )
    profiles = {each["name"]: tuple(each["qos"].values()) for each in record["entities"]}
    assert profiles == {
        "/a": ("keep_last", 7, "reliable", "volatile"),
        "/b": ("keep_last", 1, "reliable", "transient_local"),
        "/c": ("keep_last", 5, "best_effort", "volatile"),
        "/d": ("system_default", 0, "system_default", "system_default"),
        "/e": ("keep_all", 10, "best_effort", "volatile"),
    }


def test_parameters_have_their_declared_defaults(entities):
    assert entities(
        """
        from rclpy.node import Node
        from rclpy.parameter import Parameter
        from std_msgs.msg import String


        class Talker(Node):
            def __init__(self):
                super().__init__("talker", parameter_overrides=[Parameter("second", value="overridden")])
                self.declare_parameter("first", "one")
                self.declare_parameters("group", [("inner", "three"), ("other", 4)])
                second = self.declare_parameter("second", "two")
                first = self.get_parameter("first").get_parameter_value().string_value
                inner = self.get_parameter("group.inner").value
                absent = self.get_parameter_or("absent", Parameter("absent", value="given")).value
                self.create_publisher(String, first, 10)
                self.create_publisher(String, second.value, 10)
                self.create_publisher(String, inner, 10)
                self.create_publisher(String, absent, 10)
        """
    ) == [
        (15, "publisher", "/one"),
        (16, "publisher", "/overridden"),
        (17, "publisher", "/three"),
        (18, "publisher", "/given"),
    ]


def test_a_name_that_rcl_refuses_is_no_entity(execute):
    record = execute(
        """
        from rclpy.node import Node
        from std_msgs.msg import String


        class Talker(Node):
            def __init__(self):
                super().__init__("talker")
                self.create_publisher(String, "my-topic", 10)
        """
    )
    assert record["entities"] == []
    assert {each["written"] for each in record["refused"]} == {"my-topic"}


def test_lifecycle_transitions_and_callbacks_run_once(entities):
    assert entities(
        """
        from rclpy.lifecycle import LifecycleNode, TransitionCallbackReturn
        from std_msgs.msg import String


        class Managed(LifecycleNode):
            def on_configure(self, state):
                self.publisher = self.create_lifecycle_publisher(String, "out", 10)
                self.timer = self.create_timer(1.0, self.tick)
                return TransitionCallbackReturn.SUCCESS

            def tick(self):
                self.create_subscription(String, "late", print, 10)


        def main():
            Managed("managed")


        if __name__ == "__main__":
            main()
        """
    ) == [(7, "publisher", "/out"), (8, "timer", None), (12, "subscriber", "/late")]


def test_a_nodes_own_arguments_rename_it_and_its_topics(execute):
    record = execute(
        """
        from rclpy.node import Node
        from std_msgs.msg import String


        class Talker(Node):
            def __init__(self):
                super().__init__(
                    "old", cli_args=["--ros-args", "-r", "__node:=new", "-r", "a:=b", "-r", "b:=c", "-p", "rate:=4"]
                )
                self.create_publisher(String, "~/x", 10)
                self.create_publisher(String, "a", self.declare_parameter("rate", 1).value)
        """
    )
    assert [(each["name"], each["qos"]["depth"]) for each in record["entities"]] == [("/new/x", 10), ("/b", 4)]


def test_timers_of_one_line_are_told_apart_by_their_period(execute):
    record = execute(
        """
        import rclpy

        if __name__ == "__main__":
            node = rclpy.create_node("clock")
            for period in (0.5, 2.0):
                node.create_timer(period, print)
        """
    )
    assert sorted(each["period_s"] for each in record["entities"]) == [0.5, 2.0]
