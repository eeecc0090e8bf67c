"""What each action does to the launch context, and what it starts."""
