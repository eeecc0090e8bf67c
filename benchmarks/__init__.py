"""Measurements of archlint: accuracy and speed."""
