"""QoS that changes after it is made, and durations that are no bound."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
    import rclpy
    from rclpy.duration import Duration, Infinite
    from rclpy.node import Node
    from rclpy.qos import QoSProfile, ReliabilityPolicy, qos_profile_sensor_data
    from std_msgs.msg import String
    {imports}

    class {name}(Node):
        def __init__(self):
            super().__init__('{name}')
            {body}

        def on_text(self, message):
            pass


    def main():
        rclpy.init()
        rclpy.spin({name}())


    if __name__ == '__main__':
        main()
"""
PUBLISH = "self.create_publisher(String, 'said', {})"
SUBSCRIBE = "self.create_subscription(String, 'said', self.on_text, {})"
CHANGE = "qos_profile_sensor_data.reliability = ReliabilityPolicy.RELIABLE"


def written(name: str, body: str, imports: str = "") -> str:
    return NODE.format(name=name, body=body, imports=imports)


@pytest.mark.parametrize(
    ("before", "imports", "mark"),
    [
        ("pass", "", "  # here"),
        (CHANGE, "", ""),
        (f"profile = qos_profile_sensor_data; {CHANGE.replace('qos_profile_sensor_data', 'profile')}", "", ""),
        (CHANGE.replace("qos", "copy.copy(qos").replace("data", "data)"), "import copy", "  # here"),
        ("pass", CHANGE, ""),  # other programs import the module too, or not
    ],
)
def test_a_preset_is_one_object_for_all_who_use_it(judge: Judge, before: str, imports: str, mark: str):
    talker = written("Talker", f"{before}; {PUBLISH.format('qos_profile_sensor_data')}", imports)
    judge("QOS001", talker, written("Listener", SUBSCRIBE.format("10") + mark))


def test_a_publisher_that_fits_none_of_several_subscriptions_is_one_finding(judge: Judge):
    talker = written("Talker", PUBLISH.format("qos_profile_sensor_data"))
    listeners = [written(name, SUBSCRIBE.format("10")) for name in ("Second", "Third")]
    first = written("First", SUBSCRIBE.format("10") + "  # here")
    [told] = judge("QOS001", talker, first, *listeners)
    assert (
        told.message
        == "/Talker offers best effort on '/said', but 3 subscriptions request reliable: no message arrives"
    )
    assert told.help == "publish with reliable"
    assert [related.place.file for related in told.related] == ["node.py", "node2.py", "node3.py"]


def test_a_subscription_that_fits_none_of_several_publishers_is_one_finding(judge: Judge):
    talkers = [written(name, PUBLISH.format("qos_profile_sensor_data")) for name in ("Talker", "Other")]
    [told] = judge("QOS001", written("Listener", SUBSCRIBE.format("10") + "  # here"), *talkers)
    assert [related.place.file for related in told.related] == ["node1.py", "node2.py"]


POLICY = """import outside

    def policy(text):
        if outside.clean(text) == 'last':
            return HistoryPolicy.KEEP_LAST
        if outside.clean(text) == 'all':
            return HistoryPolicy.KEEP_ALL
        raise ValueError(text)

    def profile(text):
        return QoSProfile(history=policy(text), depth=10)

    def everything():
        return QoSProfile(history=HistoryPolicy.KEEP_ALL, depth=10)
"""


@pytest.mark.parametrize(
    ("given", "mark"),
    [
        ("profile(outside.text())", ""),  # it may be the sound one
        ("everything()", "  # here"),
        ("QoSProfile(depth=1) if outside.one() else everything()", "  # here"),  # that one never is
        ("everything() if outside.one() else QoSProfile(depth=1)", "  # here"),  # whichever comes last
        ("QoSProfile(depth=2) if outside.one() else QoSProfile(depth=1)", ""),
    ],
)
def test_a_profile_with_a_policy_that_is_not_known_may_be_sound(judge: Judge, given: str, mark: str):
    imports = "from rclpy.qos import HistoryPolicy\n    " + POLICY
    judge("QOS004", written("Talker", PUBLISH.format(given) + mark, imports))


def test_another_program_has_presets_of_its_own(judge: Judge):
    changed = written("Changed", f"{CHANGE}; {PUBLISH.format('qos_profile_sensor_data')}")
    other = written("Other", PUBLISH.format("qos_profile_sensor_data"))
    judge("QOS001", changed, other, written("Listener", SUBSCRIBE.format("10") + "  # here"))


@pytest.mark.parametrize(
    ("offered", "requested", "mark"),
    [
        ("10", "QoSProfile(depth=1, deadline=Infinite)", ""),
        ("10", "QoSProfile(depth=1, deadline=Duration(seconds=9223372036, nanoseconds=854775807))", ""),
        ("10", "QoSProfile(depth=1, liveliness_lease_duration=Infinite)", ""),
        ("QoSProfile(depth=1, deadline=Infinite)", "QoSProfile(depth=1, deadline=Duration(seconds=1))", "  # here"),
        ("10", "QoSProfile(depth=1, deadline=Duration(seconds=1))", "  # here"),
    ],
)
def test_an_endless_duration_is_no_bound(judge: Judge, offered: str, requested: str, mark: str):
    talker = written("Talker", PUBLISH.format(offered))
    judge("QOS003", talker, written("Listener", SUBSCRIBE.format(requested) + mark))


DEPTHS = """
    from rclpy.node import Node
    from std_msgs.msg import String

    class Talker(Node):
        def __init__(self):
            super().__init__('talker')
            self.said = self.create_publisher(String, 'said', 0)  # here
            self.heard = self.create_subscription(String, 'heard', print, {depth})

    class Other(Node):
        def __init__(self):
            super().__init__('other')
            self.told = self.create_publisher(String, 'told', {depth})
"""


@pytest.mark.parametrize(("depth", "more"), [("0", "; 2 more profiles do the same"), ("1", "")])
def test_one_habit_of_a_workspace_is_one_finding(judge: Judge, depth: str, more: str):
    (found,) = judge("QOS004", DEPTHS.format(depth=depth))
    assert found.message == (
        f"the profile has history keep_last with depth 0: what that means depends on the middleware{more}"
    )
    assert [row.place.line for row in found.related] == ([8, 13] if more else [])


BRIDGES = """
    import rclpy
    from std_msgs.msg import Int8


    def bridge(name, topic, depth=10):
        node = rclpy.create_node(name)
        node.create_publisher(Int8, topic, depth){helper}
        return node


    def main():
        rclpy.init()
        first = bridge('one', 'a', depth={first})
        second = bridge('two', 'b', depth=0){caller}
        rclpy.spin(first)
        rclpy.spin(second)


    if __name__ == '__main__':
        main()
"""


@pytest.mark.parametrize(
    ("first", "helper", "caller"),
    [("5", "", "  # here"), ("0", "  # here", "")],
    ids=["another caller gives a sound depth", "all give the same"],
)
def test_the_depth_that_a_caller_of_a_helper_gives(judge: Judge, first: str, helper: str, caller: str):
    text = BRIDGES.replace("{first}", first).replace("{helper}", helper).replace("{caller}", caller)
    judge("QOS004", text)
