"""How work is run: processes that do it, the deadline by which it has to be done, and its options."""
