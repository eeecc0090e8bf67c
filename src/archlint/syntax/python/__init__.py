"""One Python file, lowered to facts."""
