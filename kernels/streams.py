"""Seeds of candidates' random streams, made on the host."""

import numpy as np


def streams(seed: int, candidates: np.ndarray) -> np.ndarray:
    """Seeds of the candidates' random streams: a function of the run's seed and the candidate's number alone.

    Two rounds of the 32-bit finaliser of MurmurHash3 (public domain) keep neighbours apart.
    """
    x = candidates.astype(np.uint64) * np.uint64(0x9E3779B1) + np.uint64(seed % 2**32) * np.uint64(0x85EBCA77)
    mask = np.uint64(0xFFFFFFFF)
    for _ in range(2):
        x &= mask
        x ^= x >> np.uint64(16)
        x = (x * np.uint64(0x85EBCA6B)) & mask
        x ^= x >> np.uint64(13)
        x = (x * np.uint64(0xC2B2AE35)) & mask
        x ^= x >> np.uint64(16)
    return x.astype(np.uint32)
