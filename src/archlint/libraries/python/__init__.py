"""What interpreted code imports of Python's own library."""
