"""What only rclcpp and the C++ libraries around it offer; the rest goes by rclpy's names, see ``syntax/cpp``."""
