"""Ctrl-C and SIGTERM ask a long command to end early with what it has; a second one ends it at once."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sceneweaver.agent.deadline import Stop

SIGNALS = (signal.SIGINT, signal.SIGTERM)


@contextmanager
def stoppable() -> Iterator[Stop]:
    """A stop that these signals ask for while the block runs. Only the main thread hears of them."""
    from sceneweaver.agent.deadline import Stop

    stop = Stop()
    if threading.current_thread() is not threading.main_thread():
        yield stop
        return
    before = {number: signal.getsignal(number) for number in SIGNALS}

    def ask(number: int, frame: FrameType | None) -> None:
        for each, handler in before.items():
            signal.signal(each, handler)
        stop.request(signal.Signals(number).name)

    try:
        for number in SIGNALS:
            if before[number] is not signal.SIG_IGN:  # as a shell leaves Ctrl-C for what runs in the background
                signal.signal(number, ask)
        yield stop
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
