"""Substitutions: what their text is in a launch context."""
