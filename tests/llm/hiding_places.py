"""Where a key may hide: files inside files, encodings, pieces."""

from __future__ import annotations

import base64
import gzip
import io
import re
import string
import zipfile
import zlib
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from urllib.parse import quote

PART = 12
"""Characters of a key that may not be shown in a row, wherever they are cut out of it."""

PNG = b"\x89PNG\r\n\x1a\n"
DATA_URL = re.compile(rb"base64,([A-Za-z0-9+/=\s]{40,})")
DEEPEST = 4


def forms(key: str) -> dict[str, list[bytes]]:
    """What to look for, by the name of the form."""
    raw = key.encode()
    base64s = []
    for shift in range(3):
        code = base64.b64encode(bytes(shift) + raw)
        base64s += [part for part in _windows(code[4:-4], 20) for part in (part, _url_safe(part))]
    return {
        "plain": _windows(raw, PART),
        "backwards": _windows(raw[::-1], PART),
        "for URLs": _windows(quote(key, safe="").encode(), PART + 8),
        "base64": base64s,
        "hexadecimal": [raw.hex().encode()[:40], raw.hex().upper().encode()[:40]],
    }


def found_in(data: bytes, wanted: dict[str, list[bytes]]) -> str | None:
    """Name of the form that is in the data, also with white space or nulls in between; None if none is."""
    squeezed = data.translate(None, b"\x00" + string.whitespace.encode())
    for name, parts in wanted.items():
        if any(part in squeezed for part in parts):
            return name
    return None


def blobs(place: Any, name: str = "") -> Iterator[tuple[str, bytes]]:
    """Name and bytes of all that is in a place: each file, its name, and what is packed in it."""
    if isinstance(place, Path):
        for path in sorted(place.rglob("*")) if place.is_dir() else [place]:
            yield f"the name of {path}", str(path.relative_to(place.parent)).encode()
            if path.is_file():
                yield from _unpacked(str(path), path.read_bytes(), 0)
    elif isinstance(place, bytes):
        yield from _unpacked(name or "some bytes", place, 0)
    elif isinstance(place, str):
        yield from _unpacked(name or f"the text {place[:60]!r}", place.encode(errors="replace"), 0)
    else:
        for i, part in enumerate(place):
            yield from blobs(part, f"part {i} of the output")


def _windows(code: bytes, size: int) -> list[bytes]:
    return [code[i : i + size] for i in range(max(1, len(code) - size + 1))]


def _url_safe(code: bytes) -> bytes:
    return code.replace(b"+", b"-").replace(b"/", b"_")


def _unpacked(name: str, data: bytes, depth: int) -> Iterator[tuple[str, bytes]]:
    yield name, data
    if depth >= DEEPEST:
        return
    inner: list[tuple[str, bytes]] = []
    if data[:2] == b"\x1f\x8b":
        inner.append((f"{name} (gzip)", gzip.decompress(data)))
    if data[:4] == b"PK\x03\x04":
        with zipfile.ZipFile(io.BytesIO(data)) as packed:
            inner += [(f"{name}/{entry}", packed.read(entry)) for entry in packed.namelist()]
    start = data.find(PNG)
    while start >= 0:
        inner += [(f"{name} (PNG {kind})", text) for kind, text in _png_texts(data, start + 8)]
        start = data.find(PNG, start + 8)
    for match in DATA_URL.finditer(data):
        with_pad = re.sub(rb"[^A-Za-z0-9+/]", b"", match[1])
        inner.append((f"{name} (data URL)", base64.b64decode(with_pad + b"=" * (-len(with_pad) % 4))))
    for title, content in inner:
        yield from _unpacked(title, content, depth + 1)


def _png_texts(data: bytes, at: int) -> Iterator[tuple[str, bytes]]:
    while at + 8 <= len(data):
        size, kind = int.from_bytes(data[at : at + 4], "big"), data[at + 4 : at + 8]
        chunk = data[at + 8 : at + 8 + size]
        at += size + 12
        if kind == b"IEND":
            return
        if kind in (b"zTXt", b"iTXt"):
            for offset in range(min(len(chunk), 100)):
                if chunk[offset : offset + 1] == b"\x78":
                    try:
                        yield kind.decode(), zlib.decompress(chunk[offset:])
                    except zlib.error:
                        continue
