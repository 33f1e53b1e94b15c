"""The measurement of homes of a data set."""

from __future__ import annotations

import re

import pytest

from benchmarks import dataset_homes


def test_homes_are_measured_and_equal_ones_are_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    said: list[str] = []
    monkeypatch.setattr(dataset_homes, "say", said.append)
    for _ in range(2):
        words = ["--plans", "--homes", "1", "--first", "1", "--programme", "flat-studio", "--exports", ""]
        assert dataset_homes.main(words) == 0
    first, mean, second, _ = said
    assert first.startswith("home 1: ") and "valid, 4 rooms, 0 unmet" in first and mean.endswith("CPU s a home")
    digests = [re.search(r"files (\w{12});", line) for line in (first, second)]
    assert digests[0] and digests[1] and digests[0][1] == digests[1][1]
