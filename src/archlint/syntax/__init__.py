"""Compile: one file's bytes in, its facts out."""
