"""The planning pipelines that moveit_configs_utils brings along, as data.

Source: the files in ``moveit_configs_utils/default_configs`` of MoveIt 2, branches jazzy and main.
"""

from __future__ import annotations

from collections.abc import Mapping

from archlint.ros.distros import DISTROS

SINCE = DISTROS[DISTROS.index("jazzy") :]
"""The distributions whose MoveIt has these; humble's names the adapters in one text."""

Data = str | int | float | bool | list[str] | Mapping[str, "Data"]

_REQUEST = "default_planning_request_adapters"
_RESPONSE = "default_planning_response_adapters"
_CHECKS = ("ResolveConstraintFrames", "ValidateWorkspaceBounds", "CheckStartStateBounds", "CheckStartStateCollision")
_ANSWERS = ("ValidateSolution", "DisplayMotionPath")


def _pipeline(plugin: str, *answers: str, **more: Data) -> dict[str, Data]:
    return {
        "planning_plugins": [plugin],
        "request_adapters": [f"{_REQUEST}/{name}" for name in _CHECKS],
        "response_adapters": [f"{_RESPONSE}/{name}" for name in (*answers, *_ANSWERS)],
        **more,
    }


_TIMED = "AddTimeOptimalParameterization"
_PILZ = "pilz_industrial_motion_planner"
_STOMP: dict[str, Data] = {
    "num_timesteps": 60,
    "num_iterations": 40,
    "num_iterations_after_valid": 0,
    "num_rollouts": 30,
    "max_rollouts": 30,
    "exponentiated_cost_sensitivity": 0.8,
    "control_cost_weight": 0.1,
    "delta_t": 0.1,
}

PIPELINES: dict[str, dict[str, Data]] = {
    "chomp": _pipeline("chomp_interface/CHOMPPlanner", _TIMED, enable_failure_recovery=True, ridge_factor=0.01),
    "ompl": _pipeline("ompl_interface/OMPLPlanner", _TIMED),
    _PILZ: _pipeline(
        f"{_PILZ}/CommandPlanner",
        default_planner_config="PTP",
        capabilities=f"{_PILZ}/MoveGroupSequenceAction {_PILZ}/MoveGroupSequenceService",
    ),
    "stomp": _pipeline("stomp_moveit/StompPlanner", _TIMED, stomp_moveit=_STOMP),
}
"""By the name of the pipeline."""

_GROWS: dict[str, Data] = {"range": 0.0}
_AIMS: dict[str, Data] = {**_GROWS, "goal_bias": 0.05}
_BORDER: dict[str, Data] = {"border_fraction": 0.9, "min_valid_path_fraction": 0.5}
_PROJECTS: dict[str, Data] = {**_BORDER, "failed_expansion_score_factor": 0.5}
_SPARSE: dict[str, Data] = {"stretch_factor": 3.0, "sparse_delta_fraction": 0.25, "dense_delta_fraction": 0.001}
_MARCHES: dict[str, Data] = {"num_samples": 1000, "nearest_k": 1, "cache_cc": 1, "extended_fmt": 1}
_FRONTIER: dict[str, Data] = {"frountier_threshold": 0.0}

_PLANNERS: dict[str, dict[str, Data]] = {
    "AnytimePathShortening": {
        "shortcut": 1,
        "hybridize": 1,
        "max_hybrid_paths": 24,
        "num_planners": 4,
        "planners": "",
    },
    "SBL": _GROWS,
    "EST": _AIMS,
    "LBKPIECE": {**_GROWS, **_BORDER},
    "BKPIECE": {**_GROWS, **_PROJECTS},
    "KPIECE": {**_AIMS, **_PROJECTS},
    "RRT": _AIMS,
    "RRTConnect": _GROWS,
    "RRTstar": {**_AIMS, "delay_collision_checking": 1},
    "TRRT": {
        **_AIMS,
        **_FRONTIER,
        "max_states_failed": 10,
        "temp_change_factor": 2.0,
        "min_temperature": 10e-10,
        "init_temperature": 10e-6,
        "frountierNodeRatio": 0.1,
        "k_constant": 0.0,
    },
    "PRM": {"max_nearest_neighbors": 10},
    "PRMstar": {},
    "FMT": {**_MARCHES, "radius_multiplier": 1.1, "heuristics": 0},
    "BFMT": {**_MARCHES, "radius_multiplier": 1.0, "balanced": 0, "optimality": 1, "heuristics": 1},
    "PDST": {},
    "STRIDE": {
        **_AIMS,
        "use_projected_distance": 0,
        "degree": 16,
        "max_degree": 18,
        "min_degree": 12,
        "max_pts_per_leaf": 6,
        "estimated_dimension": 0.0,
        "min_valid_path_fraction": 0.2,
    },
    "BiTRRT": {
        **_GROWS,
        **_FRONTIER,
        "temp_change_factor": 0.1,
        "init_temperature": 100,
        "frountier_node_ratio": 0.1,
        "cost_threshold": 1e300,
    },
    "LBTRRT": {**_AIMS, "epsilon": 0.4},
    "BiEST": _GROWS,
    "ProjEST": _AIMS,
    "LazyPRM": _GROWS,
    "LazyPRMstar": {},
    "SPARS": {**_SPARSE, "max_failures": 1000},
    "SPARStwo": {**_SPARSE, "max_failures": 5000},
}
PLANNER_CONFIGS: dict[str, Data] = {
    "planner_configs": {name: {"type": f"geometric::{name}", **settings} for name, settings in _PLANNERS.items()}
}
"""What the pipeline ``ompl`` gets where its own file has no ``planner_configs``."""

__all__ = ["PIPELINES", "PLANNER_CONFIGS", "SINCE", "Data"]
