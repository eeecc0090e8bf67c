"""MSG001: fields of an answer, where a method waits for it and the main program calls that method."""

from __future__ import annotations

import pytest

from checks.judging import Judge

ASKING = """
    import time

    import rclpy
    from nav_msgs.srv import GetMap
    from rclpy.node import Node
    from std_srvs.srv import SetBool, Trigger


    class Robot(Node):
        def __init__(self):
            super().__init__('robot')
            self.switch = self.create_client(SetBool, 'enable')
            self.stop = self.create_client(Trigger, 'stop')
            self.maps = self.create_client(GetMap, 'map')

        def enable(self, client, request):
            {call}
            while rclpy.ok() and not future.done():
                time.sleep(0.1)
            result = future.result()
            if result is None:
                return False
            if not result.success:
                {read}
            return True


    def main():
        rclpy.init()
        robot = Robot()
        robot.enable(robot.switch, SetBool.Request(data=True))
        rclpy.shutdown()


    if __name__ == '__main__':
        main()
"""
OWN = "future = self.switch.call_async(SetBool.Request(data=True))"


def test_a_branch_for_an_answer_that_the_method_has_asked_for(judge: Judge):
    [found] = judge("MSG001", ASKING.format(call=OWN, read="print(result.error_message)  # here"))
    assert found.message == "the response of std_srvs/srv/SetBool has no field 'error_message'"
    assert found.help == "this line raises AttributeError when it runs; the fields are success, message"


@pytest.mark.parametrize(
    ("call", "read"),
    [
        pytest.param(OWN, "print(result.message)", id="it has the field"),
        pytest.param("future = client.call_async(request)", "print(result.map)", id="others may pass another client"),
        pytest.param(
            "future = (self.switch if request.data else self.maps).call_async(request)",
            "print(result.map)",
            id="one of two clients",
        ),
        pytest.param(
            "self.last = self.maps if client.service_is_ready() else self.switch\n"
            "            future = self.last.call_async(request)",
            "print(result.map)",
            id="an attribute that holds one of two",
        ),
        pytest.param(OWN, "print(getattr(result, 'error_message', ''))", id="it asks whether there is one"),
    ],
)
def test_a_branch_that_may_be_for_another_answer(judge: Judge, call: str, read: str):
    judge("MSG001", ASKING.format(call=call, read=read))
