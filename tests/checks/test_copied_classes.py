"""TMO003: what a copy of nav2's navigator waits for is nav2's own matter."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NAVIGATOR = """
    import rclpy
    from nav2_msgs.action import NavigateToPose
    from rclpy.action import ActionClient
    from rclpy.node import Node


    class {name}(Node):
        def __init__(self):
            super().__init__('navigator')
            self.client = ActionClient(self, NavigateToPose, 'navigate_to_pose')
            self.handle = None

        def {go}(self, pose):
            future = self.client.send_goal_async(NavigateToPose.Goal(pose=pose))
            rclpy.spin_until_future_complete(self, future){here}
            self.handle = future.result()

        def cancelTask(self):
            if self.handle is not None:
                self.handle.cancel_goal_async()

        def isTaskComplete(self):
            return self.handle is None

        def getResult(self):
            return self.handle

        def waitUntilNav2Active(self):
            self.client.wait_for_server(timeout_sec=5.0)


    def main():
        rclpy.init()
        navigator = {name}()
        navigator.{go}(None)
        navigator.cancelTask()


    main()
"""


@pytest.mark.parametrize(
    ("name", "go", "told"),
    [("BasicNavigator", "goToPose", False), ("BasicNavigator", "drive", True), ("Guide", "goToPose", True)],
)
def test_a_wait_of_the_original(judge: Judge, name: str, go: str, told: bool):
    lost = "[rules.TMO003]\nlost-answers = true\n"
    judge("TMO003", NAVIGATOR.format(name=name, go=go, here="  # here" if told else ""), config=lost)
