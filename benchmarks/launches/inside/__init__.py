"""What runs in the environment that has launch: it imports nothing of archlint."""
