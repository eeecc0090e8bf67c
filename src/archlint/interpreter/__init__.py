"""Abstract interpretation of Python: what its values can be, and what it calls."""
