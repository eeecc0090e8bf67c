"""PRM004: names that are almost that of a parameter which every node has."""

from __future__ import annotations

import pytest

from robot_package import TALKER, node


def param(name: str) -> str:
    return f'<param name="{name}" value="true"/>'


@pytest.mark.parametrize("name", ["use_sime_time", "use_simtime", "use_sim_tiem"])
@pytest.mark.parametrize("start", [{}, {"pkg": "moveit_ros_move_group", "exec": "move_group"}])
def test_a_name_that_is_almost_use_sim_time(findings, name, start):
    (finding,) = findings("PRM004", node(param(name), **start))
    assert finding.message == (f"no node has a parameter '{name}'; did you mean 'use_sim_time', which every node has?")


def test_one_slip_in_several_nodes_and_launch_files_is_one_finding(findings):
    twice = node(param("use_simtime")) + node(param("use_simtime"), name="other")
    copy = {"launch/copy.launch.xml": f"<launch>{node(param('use_simtime'))}</launch>"}
    (finding,) = findings("PRM004", twice, **copy)
    assert len(finding.related) == 2
    assert len(findings("PRM004", node(param("use_simtime") + param("use_sim_tiem")))) == 2


def test_a_key_of_a_parameter_file(findings):
    files = {"config/all.yaml": "/**:\n  ros__parameters:\n    use_sim_tim: true\n"}
    (finding,) = findings("PRM004", node('<param from="$(find-pkg-share robot)/config/all.yaml"/>'), **files)
    assert (finding.place.file, finding.place.line) == ("config/all.yaml", 3)


@pytest.mark.parametrize("name", ["use_sim_time", "use_sim", "use_real_time", "sim_time"])
def test_another_name(findings, name):
    other = {"pkg": "moveit_ros_move_group", "exec": "move_group"}
    assert findings("PRM004", node(param(name), **other)) == []


def test_a_name_that_the_node_declares(findings):
    talker = TALKER.replace("'rate', 1.0", "'use_sim_times', True")
    assert findings("PRM004", node(param("use_sim_times")), **{"robot/talker.py": talker}) == []
