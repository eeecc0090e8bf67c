"""What a running system says of itself: read from a file, held by ``checks/compared.py`` against the source."""
