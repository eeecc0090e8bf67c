"""Judge: one module a theme, one generator function a rule."""

from __future__ import annotations

MODULES: tuple[str, ...] = (
    "callback_entities",
    "callback_waits",
    "goal_outcomes",
    "launch",
    "launch_arguments",
    "launch_values",
    "limitless_calls",
    "long_services",
    "handlers",
    "hardcoded",
    "names",
    "nested_services",
    "node_names",
    "only_thread",
    "ownership",
    "packages",
    "circles",
    "parameter_reads",
    "parameter_overrides",
    "parameters",
    "polling",
    "sequences",
    "service_cycles",
    "signatures",
    "slow_callbacks",
    "spinning",
    "starvation",
    "timeouts",
    "type_mismatches",
    "undeclared",
    "wait_loops",
    "contracts",
    "conventions",
    "fields",
    "graph_shape",
    "near_misses",
    "published",
    "qos",
    "required",
    "run_time",
    "unmatched",
)
"""The modules of this package that register rules; a new theme is a new row."""

MADE_BY_SESSION: tuple[str, ...] = ("LNT001", "LNT002", "LNT003")
"""Rules that no module registers: they are about archlint's own run, so the session reports them."""
