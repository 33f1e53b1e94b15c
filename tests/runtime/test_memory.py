"""What a process holds, and what it gives back."""

from __future__ import annotations

import platform
import subprocess
import sys

import pytest

HOLES = """
from sceneweaver.runtime.memory import freed_memory_given_back, memory

with freed_memory_given_back():
    things = [bytes(1024) for _ in range(2**16)]
    kept = things[::64]
    del things
    full = memory()[0]
print(full, memory()[0])
"""


@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="other C libraries have no malloc_trim")
def test_what_lies_between_things_in_use_is_given_back():
    ran = subprocess.run([sys.executable, "-c", HOLES], capture_output=True, text=True, check=True)
    full, after = map(int, ran.stdout.split())
    assert full - after > 2**25  # of the 64 MiB
