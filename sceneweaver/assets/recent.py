"""Results of costly calls, as many of the last ones as fit in some memory."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Hashable
from threading import Lock
from typing import Generic, TypeVar

Key = TypeVar("Key", bound=Hashable)
Value = TypeVar("Value")


class Recent(Generic[Key, Value]):
    """The values used last. Threads may share it; two that miss at once both make the value.

    Args:
        most: Bytes that are kept at most.
        size: Bytes of a value.
    """

    def __init__(self, most: int, size: Callable[[Value], int]):
        self.most, self._size = most, size
        self.nbytes = self.hits = self.misses = 0
        self._values: OrderedDict[Key, tuple[Value, int]] = OrderedDict()
        self._lock = Lock()

    def get(self, key: Key, make: Callable[[], Value]) -> Value:
        """The value of a key, made unless it is kept."""
        with self._lock:
            if key in self._values:
                self.hits += 1
                self._values.move_to_end(key)
                return self._values[key][0]
        value = make()
        self.put(key, value)
        return value

    def peek(self, key: Key) -> Value | None:
        """The value of a key; None: it is not kept."""
        with self._lock:
            if key not in self._values:
                return None
            self.hits += 1
            self._values.move_to_end(key)
            return self._values[key][0]

    def put(self, key: Key, value: Value) -> None:
        """Keep a value, unless there is one of that key."""
        with self._lock:
            self.misses += 1
            if key not in self._values:
                self._values[key] = value, self._size(value)
                self.nbytes += self._values[key][1]
            while self.nbytes > self.most and len(self._values) > 1:
                self.nbytes -= self._values.popitem(last=False)[1][1]

    def clear(self) -> None:
        """Forget all."""
        with self._lock:
            self._values.clear()
            self.nbytes = self.hits = self.misses = 0
