"""A learned analysis of requests: what is mentioned, and what is said of what, for clauses that no rule reads."""
