"""API001: texts with places for another number of values than are given."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
    import rclpy
    from rclpy.node import Node


    class Arm(Node):
        def __init__(self):
            super().__init__('arm')
            self.timer = self.create_timer(1.0, self.report)

        def report(self):
            name, count = self.get_name(), 3
            {line}


    def main():
        rclpy.init()
        rclpy.spin(Arm())


    main()
"""


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("'%s at %d' % (name, count)", False),
        ("'%s at %d, %d%%' % (name, count)", True),
        ("'%s at %d%%' % (name, count)", False),
        ("'%s' % (name, count)", True),
        ("'%s at %.2f' % 3.0", True),
        ("'%s at %d' % count", True),
        ("'%s at %d' % f'{name}'", True),
        ("'%s at %d' % name", False),  # which may be a tuple
        ("'%s at %d' % (*name, count)", False),
        ("'name' % name", False),
        ("'name' % count", True),
        ("'name' % {'name': name}", False),
        ("'%(name)s at %(count)d' % {'name': name, 'count': count}", False),
        ("'%*d' % (count, count)", False),
        ("'{} at {}'.format(name, count)", False),
        ("'{} at {}'.format(name)", True),
        ("'{0} and {0}'.format(name)", False),
        ("'{0} and {1}'.format(name)", True),
        ("'{{}} {}'.format(name)", False),
        ("'{:{}}'.format(name, count)", False),
        ("'{:{}}'.format(name)", True),
        ("'{} at {count}'.format(name, count=count)", False),
        ("'{} at {count}'.format(name, cuont=count)", True),
        ("'{}'.format(name, count)", False),  # what is too much is left unused
        ("'{} at {}'.format(*name)", False),
        ("'{p.x} at {p.y}'.format(p=name)", False),
    ],
)
def test_places_and_values(judge: Judge, text: str, told: bool):
    judge("API001", NODE.format(line=f"self.get_logger().info({text}){'  # here' if told else ''}"))


def test_what_is_said_of_it(judge: Judge):
    lines = ("print('%s' % (name, count))  # here", "print('{size}'.format(name))  # here")
    one, other = (judge("API001", NODE.format(line=line))[0] for line in lines)
    assert one.message == "the text has one place for 2 values: this line raises TypeError"
    assert other.message == "the text has a place for 'size', which no argument is called: this line raises KeyError"
    assert other.help == "give it: size=…"


def test_an_error_that_somebody_expects(judge: Judge):
    judge("API001", NODE.format(line="try: print('{} {}'.format(name))\n            except IndexError: pass"))
