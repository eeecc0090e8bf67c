"""What rclpy and its companions offer, as data: names, signatures, what a call creates or waits on."""
