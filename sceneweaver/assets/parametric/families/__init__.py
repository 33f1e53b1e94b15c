"""The drawings, one module a family; each registers its categories with ``draws``."""
