"""What Python and rclpy refuse of the workspace's own code: names, attributes, arguments, and what callbacks return."""
