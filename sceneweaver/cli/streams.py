"""What libraries say, kept off stdout, and what is said on stderr meanwhile; it loads nothing heavy."""

from __future__ import annotations

import contextlib
import io
import os
import sys
import tempfile
from collections.abc import Iterator
from typing import TextIO

import typer

from sceneweaver.runtime.compiling import Compiling

_kept: tuple[int, int, TextIO] | None = None
"""The descriptors of stdout and stderr and Python's stdout while `no_chatter` keeps the usual ones away."""


class CompilingLine:
    """Says on stderr how far the compiling of kernels is: on a terminal a line that moves, else a line now and then."""

    EVERY = 15.0
    """Seconds between two lines where there is no terminal."""

    def __init__(self) -> None:
        self._said = 0.0

    def __call__(self, state: Compiling) -> None:
        """Say it."""
        descriptor = 2 if _kept is None else _kept[1]
        last = state.done == state.total
        if os.isatty(descriptor):
            text = f"\r\x1b[K{state}" + "\n" * last
        elif state.done == 0 or last or state.seconds - self._said >= self.EVERY:
            self._said, text = state.seconds, f"{state}\n"
        else:
            return
        with contextlib.suppress(OSError):
            os.write(descriptor, text.encode())


@contextlib.contextmanager
def no_chatter() -> Iterator[None]:
    """Keep what libraries say, also from C, off stdout, which belongs to the results; on stderr it comes at the end.

    What is printed within `spoken` is shown. With SCENEWEAVER_DEBUG everything is.
    """
    global _kept
    if os.environ.get("SCENEWEAVER_DEBUG"):
        yield
        return
    sys.stdout.flush()
    sys.stderr.flush()
    out, err, usual, before = os.dup(1), os.dup(2), sys.stdout, _kept
    with tempfile.TemporaryFile() as said, contextlib.redirect_stdout(io.StringIO()):
        try:
            with open(os.devnull, "wb") as nowhere:
                os.dup2(nowhere.fileno(), 1)
            os.dup2(said.fileno(), 2)
            _kept = out, err, usual
            yield
        finally:
            _kept = before
            sys.stderr.flush()
            os.dup2(out, 1)
            os.dup2(err, 2)
            os.close(out)
            os.close(err)
            said.seek(0)
            for line in said.read().decode(errors="replace").splitlines():
                if line.strip():
                    typer.echo(line, err=True)


@contextlib.contextmanager
def spoken() -> Iterator[None]:
    """Show at once what is printed on stdout and stderr, also while `no_chatter` keeps both away."""
    if _kept is None:
        yield
        return
    sys.stderr.flush()
    before, (*usual, stdout) = (os.dup(1), os.dup(2)), _kept
    try:
        for number, descriptor in enumerate(usual, 1):
            os.dup2(descriptor, number)
        with contextlib.redirect_stdout(stdout):
            yield
            sys.stdout.flush()
            sys.stderr.flush()
    finally:
        for number, descriptor in enumerate(before, 1):
            os.dup2(descriptor, number)
            os.close(descriptor)
