"""A planted key is found wherever it hides, or the tests that look for it say nothing."""

from __future__ import annotations

import base64
import gzip
import logging
import zipfile
import zlib
from collections.abc import Callable
from pathlib import Path
from urllib.parse import quote

import pytest

from tests.llm.planted_key import KEY, Planted, planted

RAW = KEY.encode()


def png(kind: bytes, content: bytes) -> bytes:
    chunk = len(content).to_bytes(4, "big") + kind + content + zlib.crc32(kind + content).to_bytes(4, "big")
    return b"\x89PNG\r\n\x1a\n" + chunk + b"\0\0\0\0IEND\xaeB`\x82"


HIDDEN: dict[str, bytes] = {
    "plain": b"key: " + RAW,
    "first half": RAW[: len(RAW) // 2],
    "second half": RAW[len(RAW) // 2 :],
    "lines": b"\n".join(RAW[i : i + 5] for i in range(0, len(RAW), 5)),
    "utf-16": KEY.encode("utf-16"),
    "backwards": RAW[::-1],
    "url": quote(KEY, safe="").encode(),
    "base64": base64.b64encode(RAW),
    "base64 of a header": base64.b64encode(b"Authorization: Bearer " + RAW + b"\r\n"),
    "base64 for URLs": base64.urlsafe_b64encode(b"x" + RAW),
    "hexadecimal": RAW.hex().encode(),
    "gzip": gzip.compress(b"a log\n" + RAW),
    "png text": png(b"tEXt", b"Prompt\0" + RAW),
    "png packed text": png(b"zTXt", b"Prompt\0\0" + zlib.compress(b"look " + RAW)),
    "data URL": b'<img src="data:image/png;base64,'
    + base64.b64encode(png(b"iTXt", b"k\0\1\0\0\0" + zlib.compress(RAW))),
}


@pytest.mark.parametrize("place", HIDDEN)
def test_found_in_a_file(tmp_path: Path, place: str) -> None:
    (tmp_path / "deep").mkdir()
    (tmp_path / "deep" / "file.bin").write_bytes(
        b"before " * 3 * (not HIDDEN[place].startswith(b"\x1f")) + HIDDEN[place]
    )
    with pytest.raises(AssertionError, match="the key"):
        Planted().assert_nowhere(tmp_path)


def test_found_in_an_archive_and_in_a_name(tmp_path: Path) -> None:
    with zipfile.ZipFile(tmp_path / "room.usdz", "w", zipfile.ZIP_DEFLATED) as packed:
        packed.writestr("inner.json.gz", HIDDEN["gzip"])
    with pytest.raises(AssertionError, match=r"inner.json.gz \(gzip\)"):
        Planted().assert_nowhere(tmp_path)
    (tmp_path / "room.usdz").rename(tmp_path / f"{KEY[9:30]}.usdz")
    with pytest.raises(AssertionError, match="the name of"):
        Planted().assert_nowhere(tmp_path)


def locals_hold_it(key: str) -> None:
    headers = {"x-api-key": key}
    raise ValueError(f"{len(headers)} header")


def context_holds_it(key: str) -> None:
    try:
        locals_hold_it(key)
    except ValueError:
        raise RuntimeError("no answer") from None


@pytest.mark.parametrize("raising", [locals_hold_it, context_holds_it])
def test_found_in_the_local_variables_of_a_traceback(raising: Callable[[str], None]) -> None:
    with planted() as key:
        with pytest.raises((ValueError, RuntimeError)) as caught:
            raising(key.key)
        key.raised(caught.value)
    with pytest.raises(AssertionError, match="in what was said"):
        key.assert_nowhere()


def test_found_in_logs_and_output() -> None:
    with planted() as key:
        logging.getLogger("some.library").debug("headers: %s", {"authorization": f"Bearer {KEY}"})
    with pytest.raises(AssertionError, match="in what was said"):
        key.assert_nowhere()
    with pytest.raises(AssertionError, match="part 1 of the output"):
        Planted().assert_nowhere(("fine", f"error: {KEY[3:20]}"))


def test_nothing_found_where_nothing_is(tmp_path: Path) -> None:
    (tmp_path / "scene.json").write_text('{"objects": []}')
    with planted() as key:
        logging.getLogger("openai").debug("sk-...%s", KEY[-4:])
        key.raised(ValueError("no key"))
        key.assert_nowhere(tmp_path, ("out", "err"), b"bytes", "text")
    assert set(key.environment) >= {"SCENEWEAVER_API_KEY", "OPENAI_LOG"} and len(key.said) >= 2
