"""What rules ask whatever they are about: the code at a place, what reaches what, what is certain of a node."""
