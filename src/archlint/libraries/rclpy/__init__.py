"""What interpreted code imports of rclpy: nodes and all that they make."""
