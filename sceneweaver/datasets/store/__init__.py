"""The files that all scenes of a data set share: a store in which names follow from the content."""

from __future__ import annotations

import contextlib
import hashlib
import os
import re
from contextlib import ExitStack
from pathlib import Path
from typing import Any

from sceneweaver.io import bring_to_disk, open_writable, sweep, temporary_folder

DIGITS = 32
"""Hex digits of a SHA-256 in a name: two contents share a name with a chance of about 1e-38 a pair."""

NAME = re.compile(rb"assets/[0-9a-f]{2}/[0-9a-f]{%d}\.[a-z0-9]{1,8}" % DIGITS)
"""How files name those of the store."""


class AssetStore:
    """Files in ``assets/<two digits>/<hash>.<suffix>`` below the root of a data set; many processes may write.

    A file is written in a temporary folder and renamed, so that it is there whole; `sync` brings all to the disk.
    Keep one for as many scenes as possible: ``notes`` is where its users remember what they have put there.
    """

    def __init__(self, root: Path):
        self.root = root
        self.notes: dict[Any, Any] = {}
        self._known: set[str] = set()
        self._fresh: list[Path] = []
        self._held = ExitStack()
        self._draft: Path | None = None

    def put(self, content: bytes, suffix: str) -> str:
        """Keep a content, unless it is there.

        Returns:
            Its path relative to the root of the data set, with "/" between the parts.

        Raises:
            OSError: the store cannot be written.
        """
        name = hashlib.sha256(content).hexdigest()[:DIGITS]
        relative = f"assets/{name[:2]}/{name}.{suffix}"
        if not self.holds(relative, len(content)):
            path = self.root / relative
            draft = self._drafts() / path.name
            with open_writable(draft, "wb") as file:
                file.write(content)
            path.parent.mkdir(parents=True, exist_ok=True)
            os.replace(draft, path)
            self._fresh.append(path)
            self._known.add(relative)
        return relative

    def holds(self, path: str, size: int) -> bool:
        """Whether a file of that relative path and size [bytes] is there: one cut off by a power cut is shorter."""
        if path in self._known:
            return True
        with contextlib.suppress(OSError):
            if (self.root / path).stat().st_size == size:
                self._known.add(path)
                return True
        return False

    def sync(self) -> None:
        """Bring what was put to the disk: call it before the files that name it get their final names.

        Raises:
            OSError: the disk is full or gone.
        """
        while self._fresh:
            bring_to_disk(self._fresh[-1])
            self._fresh.pop()

    def close(self) -> None:
        """Let go of the temporary folder."""
        self._held.close()
        self._draft = None

    def _drafts(self) -> Path:
        """A temporary folder on the disk of the store; what killed processes left there goes."""
        if self._draft is None or not self._draft.exists():
            folder = self.root / "assets"
            folder.mkdir(parents=True, exist_ok=True)
            sweep(folder)
            self._draft = self._held.enter_context(temporary_folder(folder))
        return self._draft
