"""What launch files and parameter files say, held against what launch makes of it."""
