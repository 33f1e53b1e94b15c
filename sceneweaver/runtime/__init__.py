"""How work is run: processes that do it, and the deadline by which it has to be done."""
