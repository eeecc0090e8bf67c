"""The oracle: nodes are really executed against a recording stand-in for rclpy, and each entity is
noted."""
