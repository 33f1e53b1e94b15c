"""Is a data set what it says it is? Everything is measured again, from its files alone."""

from .verify import Verification, verify_dataset

__all__ = ["Verification", "verify_dataset"]
