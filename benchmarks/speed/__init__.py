"""How long runs take, beside other runs and other programs."""
