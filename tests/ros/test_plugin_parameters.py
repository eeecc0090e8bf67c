"""The types of the parameters of well-known plugins, held against what their documentation says."""

from __future__ import annotations

import pytest

from archlint.ros.plugin_parameters import spelt, type_in, well_known


@pytest.mark.parametrize(
    ("plugin", "name", "kind"),
    [
        ("dwb_core::DWBLocalPlanner", "max_vel_x", "double"),
        ("dwb_core::DWBLocalPlanner", "vx_samples", "integer"),
        ("dwb_core::DWBLocalPlanner", "RotateToGoal.slowing_factor", "double"),
        ("nav2_mppi_controller::MPPIController", "batch_size", "integer"),
        ("nav2_mppi_controller::MPPIController", "GoalCritic.cost_weight", "double"),
        ("nav2_costmap_2d::ObstacleLayer", "scan.raytrace_max_range", "double"),
        ("nav2_costmap_2d::VoxelLayer", "z_voxels", "integer"),
        ("nav2_navfn_planner/NavfnPlanner", "use_astar", "bool"),
        ("nav2_smac_planner::SmacPlannerHybrid", "smoother.max_iterations", "integer"),
        ("joint_trajectory_controller/JointTrajectoryController", "gains.elbow.p", "double"),
        ("diff_drive_controller/DiffDriveController", "left_wheel_names", "string_array"),
        ("dwb_core::DWBLocalPlanner", "colour", None),
    ],
)
def test_a_parameter_of_a_plugin(plugin: str, name: str, kind: str | None):
    assert type_in(well_known().plugins[spelt(plugin)], name) == kind


@pytest.mark.parametrize(
    ("node", "name", "kind"),
    [
        ("amcl", "max_particles", "integer"),
        ("local_costmap", "width", "integer"),
        ("global_costmap", "resolution", "double"),
        ("controller_server", "controller_frequency", "double"),
        ("controller_server", "controller_plugins", None),
    ],
)
def test_a_parameter_of_a_node(node: str, name: str, kind: str | None):
    assert type_in(well_known().nodes[node], name) == kind


def test_no_name_is_without_its_last_word():
    table = well_known()
    for types in (*table.plugins.values(), *table.nodes.values()):
        assert not [name for name in types if name.endswith("*") or ".." in name or not name]
