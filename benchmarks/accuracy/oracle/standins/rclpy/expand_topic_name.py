"""Stand-in for rclpy.expand_topic_name."""

from __future__ import annotations

from benchmarks.accuracy.oracle.names import expand


def expand_topic_name(topic_name: str, node_name: str, node_namespace: str) -> str:
    """The fully qualified form of a name."""
    return expand(topic_name, node_name, node_namespace)
