"""archlint: the architecture linter and graph analyzer for ROS 2."""

__version__ = "0.1.0"
