"""The configuration: read, checked, merged, and applied to findings."""
