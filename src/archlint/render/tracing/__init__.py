"""Show: where data comes from and goes to, and what breaks with a change, in each format."""
