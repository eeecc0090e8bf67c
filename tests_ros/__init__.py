"""archlint's graph held against running nodes: needs the environments that ``make test-ros`` sets up."""
