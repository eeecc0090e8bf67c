"""Stand-in for rosidl_runtime_py; what is not here is unknown."""
