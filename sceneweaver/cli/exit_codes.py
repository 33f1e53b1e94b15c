"""How the commands end, apart from 0 (done and valid) and 1 (a fault of the program)."""

BAD_INPUT = 2
NOT_VALID = 3
MISSING = 4
UNFINISHED = 5
INTERRUPTED = 130
