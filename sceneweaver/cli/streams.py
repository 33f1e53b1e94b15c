"""What libraries say, kept off stdout, and what is said on stderr meanwhile; it loads nothing heavy."""

from __future__ import annotations

import contextlib
import io
import os
import sys
import tempfile
from collections.abc import Iterator

import typer

from sceneweaver.runtime.compiling import Compiling

_stderr: int | None = None
"""The descriptor of stderr while `no_chatter` keeps the usual one away."""


class CompilingLine:
    """Says on stderr how far the compiling of kernels is: on a terminal a line that moves, else a line now and then."""

    EVERY = 15.0
    """Seconds between two lines where there is no terminal."""

    def __init__(self) -> None:
        self._said = 0.0

    def __call__(self, state: Compiling) -> None:
        """Say it."""
        descriptor = 2 if _stderr is None else _stderr
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

    With SCENEWEAVER_DEBUG everything is shown.
    """
    global _stderr
    if os.environ.get("SCENEWEAVER_DEBUG"):
        yield
        return
    sys.stdout.flush()
    sys.stderr.flush()
    out, err, before = os.dup(1), os.dup(2), _stderr
    with tempfile.TemporaryFile() as said, contextlib.redirect_stdout(io.StringIO()):
        try:
            with open(os.devnull, "wb") as nowhere:
                os.dup2(nowhere.fileno(), 1)
            os.dup2(said.fileno(), 2)
            _stderr = err
            yield
        finally:
            _stderr = before
            sys.stderr.flush()
            os.dup2(out, 1)
            os.dup2(err, 2)
            os.close(out)
            os.close(err)
            said.seek(0)
            for line in said.read().decode(errors="replace").splitlines():
                if line.strip():
                    typer.echo(line, err=True)
