"""archlint."""
