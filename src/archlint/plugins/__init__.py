"""Rules that a team brings: Python files of its repository, and packages that are installed beside archlint."""
