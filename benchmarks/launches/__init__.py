"""Launch files of public repositories: how many load, and whether launch itself starts the same from them."""
