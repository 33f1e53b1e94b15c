"""Requests run in a thread of their own; whoever asks waits in his, and can leave at any moment.

The caller's thread is never inside a library for longer than `LOOK`, so a deadline or Ctrl-C ends a wait at once. It
may have an event loop of its own that runs; ours is another.
"""

from __future__ import annotations

import asyncio
import concurrent.futures
import os
import queue
import threading
from collections.abc import Callable, Coroutine
from types import TracebackType
from typing import Any, Generic, Self, TypeVar

from sceneweaver.runtime.deadline import checkpoint

LOOK = 0.05
"""Seconds between two looks at whether to go on waiting."""

LEAVE = 0.3
"""Seconds that requests which are cancelled get to close what they have open."""

Result = TypeVar("Result")


class CallQueue:
    """Calls from the thread of the requests that have to be made in the thread of the caller."""

    def __init__(self) -> None:
        self._calls: queue.SimpleQueue[tuple[Callable[[], Any], asyncio.Future[Any]] | None] = queue.SimpleQueue()

    async def call(self, function: Callable[[], Result]) -> Result:
        """Have the caller's thread call a function. What it raises ends the wait there."""
        future: asyncio.Future[Result] = asyncio.get_running_loop().create_future()
        self._calls.put((function, future))
        return await future

    def serve(self, seconds: float) -> None:
        """Wait for a call, or for the end of the requests, for some seconds at most, and do it."""
        try:
            found = self._calls.get(timeout=seconds)
        except queue.Empty:
            return
        if found is not None:
            function, future = found
            result = function()
            future.get_loop().call_soon_threadsafe(_settle, future, result)

    def close(self) -> None:
        """Wake the caller's thread."""
        self._calls.put(None)


class Waiting(Generic[Result]):
    """A ``with`` block while a coroutine runs in the thread of the requests; cancelled when the block ends before it.

    Args:
        work: the coroutine.
        calls: functions that it has the caller's thread call.
    """

    def __init__(self, work: Coroutine[Any, Any, Result], calls: CallQueue) -> None:
        self._work, self._calls = work, calls
        self._future: concurrent.futures.Future[Result] | None = None
        self._ended = threading.Event()

    def __enter__(self) -> Self:
        self._future = asyncio.run_coroutine_threadsafe(self._to_its_end(), _loop())
        self._future.add_done_callback(lambda _: self._calls.close())
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._future is not None and self._future.cancel():
            self._ended.wait(LEAVE)

    async def _to_its_end(self) -> Result:
        try:
            return await self._work
        finally:
            self._ended.set()

    def result(self, stopped: Callable[[], bool]) -> Result | None:
        """What the coroutine gives back; None when ``stopped`` says so before."""
        assert self._future is not None
        while not self._future.done():
            if stopped():
                return None
            checkpoint()
            self._calls.serve(LOOK)
        return self._future.result()


class _Thread:
    """The event loop of all requests of this process."""

    def __init__(self) -> None:
        self.loop = asyncio.new_event_loop()
        threading.Thread(target=self._run, name="sceneweaver-models", daemon=True).start()

    def _run(self) -> None:
        asyncio.set_event_loop(self.loop)
        self.loop.run_forever()


_thread: _Thread | None = None
_starting = threading.Lock()


def _loop() -> asyncio.AbstractEventLoop:
    global _thread
    with _starting:
        if _thread is None:
            _thread = _Thread()
        return _thread.loop


def _forget() -> None:
    """A child process has a copy of the loop, but nobody who runs it."""
    global _thread, _starting
    _thread, _starting = None, threading.Lock()


os.register_at_fork(after_in_child=_forget)


def _settle(future: asyncio.Future[Any], result: Any) -> None:
    if not future.done():
        future.set_result(result)
