"""Launch files, run symbolically: what they start, under which names, with which parameters."""
