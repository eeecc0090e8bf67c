"""What is run, how it is kept in, and what becomes of what cannot be known."""

from __future__ import annotations

import pytest

TALKER = """
    import rclpy
    from rclpy.node import Node
    from std_msgs.msg import String


    class Talker(Node):
        def __init__(self, name="talker"):
            super().__init__(name)
            self.create_publisher(String, f"{name}/out", 10)
    """


def test_console_scripts_of_setup_py_are_programs(execute):
    record = execute(
        {
            "pkg/package.xml": "<package><name>pkg</name></package>",
            "pkg/setup.py": """
                from setuptools import setup
                name = "pkg"
                setup(name=name, entry_points={"console_scripts": [f"run = {name}.program:main"]})
                """,
            "pkg/pkg/__init__.py": "",
            "pkg/pkg/talker.py": TALKER,
            "pkg/pkg/program.py": """
                import rclpy
                from pkg.talker import Talker

                def main():
                    rclpy.init()
                    rclpy.spin(Talker("given"))
                """,
        }
    )
    assert [(each["file"], each["name"], each["phase"]) for each in record["entities"]] == [
        ("pkg/pkg/talker.py", "/given/out", "main")
    ]


def test_a_class_that_no_program_constructs_is_constructed(execute):
    (entity,) = execute(TALKER)["entities"]
    assert (entity["name"], entity["phase"]) == ("/talker/out", "class")


def test_a_helper_that_no_program_reaches_is_called_with_a_node(execute):
    (entity,) = execute(
        """
        from std_msgs.msg import String


        class Reporter:
            def __init__(self, node):
                self.publisher = node.create_publisher(String, "/report", 10)
        """
    )["entities"]
    assert (entity["line"], entity["name"], entity["phase"]) == (6, "/report", "forced")


def test_loops_sleeps_and_inputs_end(entities):
    assert entities(
        """
        import threading
        import time
        import rclpy
        from std_msgs.msg import String


        def main():
            rclpy.init()
            node = rclpy.create_node("talker")
            worker = threading.Thread(target=lambda: node.create_publisher(String, "thread", 10))
            worker.start()
            while rclpy.ok():
                rclpy.spin_once(node)
            input("press enter")
            try:
                while True:
                    time.sleep(3600)
            except KeyboardInterrupt:
                node.create_publisher(String, "end", 10)
            worker.join()


        if __name__ == "__main__":
            main()
        """
    ) == [(10, "publisher", "/thread"), (19, "publisher", "/end")]


def test_missing_modules_are_stood_in_for_and_taint_names(execute):
    record = execute(
        """
        import rclpy
        import robot_vendor_sdk as sdk
        from std_msgs.msg import String


        @sdk.traced
        def main():
            node = rclpy.create_node("driver")
            robot = sdk.connect()
            first, second = robot.arms
            node.create_publisher(String, f"arm/{first.name}/state", 10)
            node.create_publisher(String, f"arm{int(robot.number) + 1}/state", 10)
            node.create_publisher(String, "known", 10)


        if __name__ == "__main__":
            main()
        """
    )
    assert [(each["line"], each["name"], each.get("pattern")) for each in record["entities"]] == [
        (11, None, "/arm/*/state"),
        (12, None, "/arm*/state"),
        (13, "/known", None),
    ]


def test_constants_of_the_workspaces_own_messages_are_known(entities):
    assert entities(
        {
            "topics/package.xml": "<package><name>topics</name></package>",
            "topics/msg/Names.msg": "string GOAL = goal_pose  # where to go\nint32 count 3\n",
            "topics/CMakeLists.txt": "",
            "node.py": """
                from rclpy.node import Node
                from std_msgs.msg import String
                from topics.msg import Names


                class Pilot(Node):
                    def __init__(self):
                        super().__init__("pilot")
                        self.create_publisher(String, Names.GOAL, Names().count)
                """,
        }
    ) == [(9, "publisher", "/goal_pose")]


def test_a_failing_statement_is_skipped_at_the_second_try(execute):
    record = execute(
        """
        from rclpy.node import Node
        from std_msgs.msg import String


        class Reader(Node):
            def __init__(self):
                super().__init__("reader")
                settings = {}
                topic = settings["topic"]
                self.create_publisher(String, topic, 10)
                self.create_publisher(String, "known", 10)
        """
    )
    assert [(each["line"], each["name"], each["resumed"]) for each in record["entities"]] == [
        (10, None, True),
        (11, "/known", True),
    ]
    failures = [failure for run in record["runs"] for failure in run["failures"]]
    assert failures[0]["reason"] == "KeyError: 'topic'"
    assert failures[0]["where"] == "node.py:9"


def test_the_programs_own_handling_of_errors_keeps_its_meaning(execute):
    record = execute(
        """
        from rclpy.node import Node
        from std_msgs.msg import String


        def topic():
            raise LookupError("none configured")


        class Reader(Node):
            def __init__(self):
                super().__init__("reader")
                try:
                    name = topic()
                except LookupError:
                    name = "fallback"
                self.create_publisher(String, name, 10)
                unknown_function()
                self.create_publisher(String, "after", 10)
        """
    )
    assert {each["name"] for each in record["entities"]} == {"/fallback", "/after"}


@pytest.mark.parametrize(
    "deed",
    [
        "open(__file__, 'a').write('# changed')",
        "__import__('pathlib').Path(__file__).with_name('new').mkdir()",
        "__import__('os').remove(__file__)",
        "__import__('socket').create_connection(('127.0.0.1', 9))",
    ],
)
def test_nothing_outside_is_touched(execute, tmp_path, deed):
    record = execute(
        f"""
        import rclpy

        if __name__ == "__main__":
            node = rclpy.create_node("vandal")
            {deed}
        """
    )
    (left,) = (tmp_path / "workspace").iterdir()
    assert left.name == "node.py"
    assert left.read_text().endswith(f"{deed}\n")
    reasons = [failure["reason"] for run in record["runs"] for failure in run["failures"]]
    assert any("not allowed" in reason or "no network" in reason for reason in reasons)


def test_interface_folders_of_the_workspace_do_not_hide_the_interfaces(execute):
    (entity,) = execute(
        {
            "robot_msgs/package.xml": "<package><name>robot_msgs</name></package>",
            "robot_msgs/CMakeLists.txt": "",
            "robot_msgs/srv/Move.srv": "float64 distance\n---\nbool success\n",
            "app/package.xml": "<package><name>app</name></package>",
            "app/move.py": """
                import rclpy
                from robot_msgs.srv import Move

                if __name__ == "__main__":
                    rclpy.create_node("mover").create_client(Move, "move")
                """,
        }
    )["entities"]
    assert entity["type"] == "robot_msgs/srv/Move"


def test_star_imports_of_messages_give_what_the_packages_hold(execute):
    record = execute(
        """
        import rclpy
        from sensor_msgs.msg import *
        from std_msgs.msg import *
        from vendor_msgs.msg import *

        if __name__ == "__main__":
            node = rclpy.create_node("mixed")
            for kind in (Image, String, MotorState):
                node.create_publisher(kind, "out", 10)
        """
    )
    assert {each["type"] for each in record["entities"]} == {
        "sensor_msgs/msg/Image",
        "std_msgs/msg/String",
        "vendor_msgs/msg/MotorState",
    }


def test_what_differs_from_run_to_run_is_unknown(execute):
    record = execute(
        """
        import os
        import socket
        import uuid
        import rclpy
        from std_msgs.msg import String

        if __name__ == "__main__":
            node = rclpy.create_node(f"worker_{os.getpid()}")
            node.create_publisher(String, f"{socket.gethostname()}/out", 10)
            node.create_publisher(String, "session_" + uuid.uuid4().hex, 10)
            node.create_publisher(String, os.environ["ROBOT_NAME"] + "/out", 10)
        """
    )
    patterns = [(each["name"], each["pattern"], each["node"]) for each in record["entities"]]
    assert patterns == [
        (None, "/*/out", "/worker_*"),
        (None, "/session_*", "/worker_*"),
        (None, "/*/out", "/worker_*"),
    ]


def test_a_loop_without_end_does_not_fill_the_record(execute):
    record = execute(
        """
        import itertools
        import rclpy
        from std_msgs.msg import String

        if __name__ == "__main__":
            node = rclpy.create_node("endless")
            for number in itertools.count():
                node.create_publisher(String, f"out_{number}", 10)
        """
    )
    assert len(record["entities"]) == 500


def test_what_a_parameter_or_an_unknown_value_left_out_is_run_the_other_way(execute):
    record = execute(
        """
        from rclpy.node import Node
        from std_msgs.msg import String
        import vendor_sdk


        class Talker(Node):
            def __init__(self):
                super().__init__("talker")
                self.declare_parameter("verbose", False)
                self.create_publisher(String, "always", 10)
                if self.get_parameter("verbose").value:
                    self.create_publisher(String, "verbose", 10)
                if not vendor_sdk.connected:
                    self.create_publisher(String, "offline", 10)
        """
    )
    assert [(each["name"], each["other_way"]) for each in record["entities"]] == [
        ("/always", False),
        ("/verbose", True),
        ("/offline", True),
    ]
