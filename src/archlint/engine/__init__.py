"""A run, from folders to findings, and what is kept of it."""
