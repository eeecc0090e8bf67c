"""Known defects, planted one at a time in copies of real packages: what is found, and what else is said."""
