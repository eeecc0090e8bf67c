"""How right archlint is: what it reads in the source, beside what a run of the same nodes creates."""
