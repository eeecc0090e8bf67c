"""How far a run follows a program: each limit with what it is for."""

DEPTH = 48
"""How many calls deep a run follows."""
CLASSES = 100
"""How many classes one derives from, itself among them: each is looked through for each attribute of each other."""
IMPORTS = 200
"""How many imports deep a module is run.  Python raises RecursionError where 140 to 160 modules import each other in a
row (tried with 3.10 to 3.13), and g++ refuses more includes inside each other."""
STEPS = 8_000
"""How many statements one callback may run."""
PROGRAM_STEPS = 80_000
"""How many statements all of a program may run, its entry point first; from then on each root has few."""
TEST_STEPS = 8_000
"""The same for test code: its nodes are shown, but what it calls in the library is not its own."""
FEW_STEPS = 400
"""What a root may run in any case, so that no callback goes unseen."""
EXTRA_STEPS = 80_000
"""What all roots of a program may run in this way, once its own statements are spent: each of them may start more."""
ROOTS = 4_000
"""How many callbacks and methods of a program run: a fleet of nodes has some hundreds."""
SELF_STARTS = 2
"""How often a function runs as a callback that it started itself.  A callback that makes a node of its own class
gives each node a callback of its own; the third does what the second did."""
NESTED_CALLS = 3
"""How many calls of one function run at a time, each in the one before."""
RUNS = 150
"""How often one root runs a function with any arguments."""
WORK_OF_A_STEP = 500
"""How many slots and items that branches leave may be joined for the price of a statement."""
UNROLL = 512
"""How many items of a known collection a loop is unrolled over."""
FLAG_ROUNDS = 16
"""How many rounds of ``while self.running:`` are followed that leave the flag as it is: others end such a loop."""
RETURNS = 128
"""From how many rounds a function may return, with a condition that is not known, before one more round stands for the
rest of its loops: each return keeps all that was written before it."""
SHARE_OF_A_LOOP = 3 / 4
"""Of the statements that may still run, what one loop may have of them before one more round stands for the rest of
it: loops over the pixels of a picture are long, and what follows them is to be followed, too."""
COMPREHENDED = 8_000
"""How many items all comprehensions of a program go through one by one: tables of numbers are no names."""
