"""Sums of files: the same by one process and by many."""

from __future__ import annotations

import hashlib

from sceneweaver.datasets import digests


def test_many_processes_give_the_sums_of_one_in_order(tmp_path, monkeypatch):
    contents = {f"{k:03d}.bin": bytes([k % 7]) * k for k in range(50)}
    for name, content in contents.items():
        (tmp_path / name).write_bytes(content)
    expected = [hashlib.sha256(content).hexdigest() for content in contents.values()]
    assert digests.sha256_of(tmp_path, list(contents)) == expected
    monkeypatch.setattr(digests, "MANY", 10)
    monkeypatch.setattr(digests, "TOGETHER", 8)
    monkeypatch.setattr(digests, "cores", lambda: 2)
    assert digests.sha256_of(tmp_path, list(contents)) == expected
    assert digests.sha256_of(tmp_path, []) == []
