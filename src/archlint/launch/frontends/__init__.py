"""XML and YAML launch files as the same actions that Python makes."""
