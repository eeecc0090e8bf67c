"""What ROS says: names, remapping, quality of service, interfaces, packages."""
