"""What rules ask of a system: waits, deadlocks, delivery, what reaches what."""
