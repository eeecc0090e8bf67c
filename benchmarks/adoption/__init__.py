"""A team takes archlint up: each step of the README, done on a copy of a workspace with the real programs.

``python -m benchmarks.adoption [WORKSPACE…]`` does it on the fixtures, or on checkouts of real repositories.
``make adoption`` makes the environment with pre-commit and colcon first.
"""
