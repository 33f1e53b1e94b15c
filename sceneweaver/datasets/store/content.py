"""A store of files whose names follow from their content."""

from __future__ import annotations

import hashlib
from pathlib import Path

from sceneweaver.scene import write_atomic

DIGITS = 32
"""Hex digits of a SHA-256 in a name: two contents share a name with a chance of about 1e-38 a pair."""


class AssetStore:
    """Files in ``assets/<two digits>/<hash>.<suffix>`` below the root of a data set; many processes may write."""

    def __init__(self, root: Path):
        self.root = root
        self._known: set[str] = set()

    def put(self, content: bytes, suffix: str) -> str:
        """Keep a content, unless it is there.

        Returns:
            Its path relative to the root of the data set, with "/" between the parts.
        """
        name = hashlib.sha256(content).hexdigest()[:DIGITS]
        relative = f"assets/{name[:2]}/{name}.{suffix}"
        if relative not in self._known:
            path = self.root / relative
            if not path.exists():
                path.parent.mkdir(parents=True, exist_ok=True)
                write_atomic(path, content)
            self._known.add(relative)
        return relative
