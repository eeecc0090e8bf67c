"""Stand-in for nav2_simple_commander."""
