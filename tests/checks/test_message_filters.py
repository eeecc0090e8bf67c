"""What message_filters calls a callback with: a message of each filter, in their order."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
    import rclpy
    from lenses import find_filters, make
    from message_filters import ApproximateTimeSynchronizer, Subscriber, TimeSynchronizer
    from rclpy.node import Node
    from sensor_msgs.msg import CameraInfo, Image


    class Viewer(Node):
        def __init__(self):
            super().__init__('viewer')
            image = Subscriber(self, Image, 'image')
            info = Subscriber(self, CameraInfo, 'info')
            {made}
            filter_.registerCallback({registered}){on_line}

        {callback}


    def main():
        rclpy.init()
        rclpy.spin(Viewer())


    if __name__ == '__main__':
        main()
"""
EXACT = "filter_ = TimeSynchronizer([image, info], 10)"


def _node(made: str, registered: str, callback: str, on_line: str = "") -> str:
    return NODE.format(made=made, registered=registered, callback=callback, on_line=on_line)


@pytest.mark.parametrize(
    ("made", "callback"),
    [
        (EXACT, "def show(self, image, info): print(image.header.stamp.to_sec())  # here"),
        (EXACT, "def show(self, image, info): print(info.encoding)  # here"),
        ("filter_ = ApproximateTimeSynchronizer((image, info), 10, 0.1)", "def show(self, a, b): print(a.k)  # here"),
        ("filter_ = TimeSynchronizer(fs=[image, info], queue_size=10)", "def show(self, a, b): print(a.k)  # here"),
        (EXACT, "def show(self, *messages): print(messages[1].encoding)  # here"),
        ("filter_ = info", "def show(self, message): print(message.encoding)  # here"),
        (EXACT, "def show(self, image, info): print(image.encoding, info.k)"),
        ("filter_ = TimeSynchronizer([image, info, make()], 10)", "def show(self, a, b, c): print(c.encoding)"),
        ("filter_ = TimeSynchronizer({image, info}, 10)", "def show(self, a, b): print(a.k, b.k)"),
        ("filter_ = TimeSynchronizer(find_filters(), 10)", "def show(self, a, b): print(a.k, b.k)"),
    ],
)
def test_fields_of_the_messages_that_a_filter_passes_on(judge: Judge, made: str, callback: str):
    judge("MSG001", _node(made, "self.show", callback))


def test_a_subscriber_of_one_of_two_types(judge: Judge):
    made = "filter_ = Subscriber(self, Image if self.has_parameter('raw') else CameraInfo, 'camera')"
    judge("MSG001", _node(made, "self.show", "def show(self, message): print(message.encoding, message.k)"))


@pytest.mark.parametrize(
    ("made", "registered", "callback", "told"),
    [
        (EXACT, "self.show", "def show(self, image): pass", True),
        (EXACT, "self.show", "def show(self, image, info, odometry): pass", True),
        (EXACT, "self.show, 'left'", "def show(self, image, info): pass", True),
        ("filter_ = info", "self.show", "def show(self, image, info): pass", True),
        (EXACT, "self.shwo", "def show(self, image, info): pass", True),
        (EXACT, "self.show", "def show(self, image, info): pass", False),
        (EXACT, "self.show, 'left'", "def show(self, image, info, side): pass", False),
        (EXACT, "self.show, *self.sides", "def show(self, image, info, side): pass", False),
        (EXACT, "self.show", "def show(self, *messages): pass", False),
        (EXACT, "self.show", "def show(self, image, info, side='left'): pass", False),
        ("filter_ = TimeSynchronizer(find_filters(), 10)", "self.show", "def show(self, image): pass", False),
    ],
)
def test_how_many_messages_a_filter_passes_on(judge: Judge, made: str, registered: str, callback: str, told: bool):
    judge("EXE006", _node(made, registered, callback, "  # here" if told else ""))


@pytest.mark.parametrize(
    ("made", "told"),
    [
        ("filter_ = Subscriber(self, Image, 'camera', 10)", True),
        ("filter_ = Subscriber(self, Image, 'camera', qos_profile=10)", False),
        ("filter_ = Subscriber(self, Image, 'camera')", False),
        ("filter_ = Subscriber(*make())", False),
    ],
)
def test_a_profile_that_a_subscriber_is_given_by_position(judge: Judge, made: str, told: bool):
    source = _node(f"{made}{'  # here' if told else ''}", "self.show", "def show(self, message): pass")
    rows = judge("API001", source, config='distro = "humble"')
    if told:
        assert rows[0].message == "Subscriber() fails: it takes at most 3 arguments by position"
        assert rows[0].help == "give the profile by name, qos_profile=…: here it takes the place of the callback"


def test_a_profile_by_position_where_newer_distributions_are_meant(judge: Judge):
    """They may take it."""
    source = _node("filter_ = Subscriber(self, Image, 'camera', 10)", "self.show", "def show(self, message): pass")
    judge("API001", source)
