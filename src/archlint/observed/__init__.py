"""What a running system says of itself: read from a file, held by ``analysis/comparison.py`` against the source."""
