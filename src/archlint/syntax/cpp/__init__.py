"""C++: a file lowered to the same facts as one of Python."""
