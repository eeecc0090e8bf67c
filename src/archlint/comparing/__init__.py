"""What a change does to an architecture: two graphs, as ``archlint graph --format json`` writes them, are compared."""
