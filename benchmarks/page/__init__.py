"""How the HTML page behaves in a real browser; `python -m benchmarks.page` measures it."""
