"""Bytecode of archlint and of the tests is kept, whatever the environment says: each worker would compile all of it."""

import sys

sys.dont_write_bytecode = False
