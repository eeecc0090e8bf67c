"""What ``archlint diff`` says: the formats of a comparison."""
