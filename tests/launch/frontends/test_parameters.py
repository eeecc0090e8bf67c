"""The parameters that launch files in XML and YAML give nodes."""

from __future__ import annotations

import pytest

from archlint.systems.overrides import NotKnown
from launching import names, parameters, remaps


def test_types_of_parameters(launches):
    launched = launches.xml(
        """<arg name="x" default="1.5"/><node pkg="robot" exec="talker">
          <param name="a" value="1"/><param name="b" value="1" type="str"/><param name="c" value="$(var x)"/>
          <param name="d"><param name="e" value="true"/></param><param name="f" value="[1, 2]"/>
        </node>"""
    )
    assert parameters(launched.started[0]) == {"a": 1, "b": "1", "c": 1.5, "d.e": True, "f": [1, 2]}


def test_yaml_keeps_types_but_for_texts_that_look_like_numbers(launches):
    launched = launches.yaml(
        "launch:\n- node:\n    pkg: robot\n    exec: talker\n    namespace: left\n"
        "    param:\n    - {name: a, value: 1}\n    - {name: b, value: '1'}\n    - {name: c, value: one}\n"
        "    remap:\n    - {from: x, to: y}\n"
    )
    (started,) = launched.started
    why = "a string that looks like a number, which ROS releases read differently"
    assert parameters(started) == {"a": 1, "b": NotKnown(why), "c": "one"}
    assert remaps(started) == [("x", "y")]
    assert names(launched) == ["/left/-"]


@pytest.mark.parametrize(
    ("attributes", "value"),
    [
        ('value="1"', 1),
        ('value="1" type="float"', 1.0),
        ('value="1" type="int"', 1),
        ('value="1" type="str"', "1"),
        ('value="yes" type="bool"', True),
        ('value="0.5"', 0.5),
        ('value="x" type="int"', NotKnown("a value that is not of type int")),
    ],
)
def test_the_type_of_a_parameter_in_xml(launches, attributes, value):
    launched = launches.xml(f'<node pkg="robot" exec="talker"><param name="p" {attributes}/></node>')
    found = parameters(launched.started[0])["p"]
    assert (type(found), found) == (type(value), value)
