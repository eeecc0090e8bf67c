"""Link: the facts of all files in, what each program would create and wait for out."""
