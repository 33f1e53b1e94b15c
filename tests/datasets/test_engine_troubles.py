"""Troubles of runs that take many processes to try; slow for that."""

from __future__ import annotations

import pytest

from sceneweaver.datasets.engines import Listener, Options, begin, merge, open_dataset, resume
from sceneweaver.datasets.reading import rows_of
from sceneweaver.datasets.tables import read_table
from tests.datasets import torture
from tests.datasets.test_engines import content, made, rows, spec_file

pytestmark = pytest.mark.slow


def test_rooms_that_crash_hang_or_raise_are_rows_and_the_others_are_served(tmp_path):
    prompts = ["a room", "crash", "b room", "flaky", "hang", "fault"]
    notices = made(spec_file(tmp_path, *prompts, more="time_limit: 0.5"), tmp_path / "out", workers=2)
    found = {row["prompt"]: (row["status"], row.get("reason")) for row in rows(tmp_path / "out")[:6]}
    assert found == {
        "a room": ("ok", None),
        "crash": ("failed", "worker killed by signal 9"),
        "b room": ("ok", None),
        "flaky": ("ok", None),
        "hang": ("failed", "worker hung: no scene for too long"),
        "fault": ("failed", "ValueError: no such wall"),
    }
    assert any("room 1: worker killed by signal 9; it has failed" in text for text in notices)


def test_a_block_made_room_by_room_is_the_block_made_at_once(tmp_path):
    name = "work/blocks/00000/00000000/rows.jsonl"
    alone, at_once = tmp_path / "alone", tmp_path / "at_once"
    notices = made(spec_file(tmp_path / "a", "a room", "flaky", "a hopeless room", "b room"), alone)
    assert any(text.startswith("block 0") for text in notices)
    assert made(spec_file(tmp_path / "b", "a room", "flakx", "a hopeless room", "b room"), at_once) == []
    assert content(at_once)[name].replace(b"flakx", b"flaky") == content(alone)[name]


def test_whole_data_sets_are_joined_with_new_numbers_and_their_names(tmp_path):
    for name, count in (("first", 5), ("second", 3)):
        source = spec_file(tmp_path / f"{name}-spec")
        source.write_text(source.read_text().replace("tiny", name).replace("12", str(count)))
        dataset = begin(source, tmp_path / name, "cpu")
        resume(dataset, Options(workers=1), Listener(print, print), produce=torture.fake)
    parts = [tmp_path / "first", tmp_path / "second"]
    joined = merge(parts, tmp_path / "both")
    resume(merge(parts, tmp_path / "both"), Options(workers=1), Listener(print, print))
    found = list(rows_of(joined.folder))
    assert [(row["index"], row["room"], row["source"]) for row in found] == [
        *((n, n, "first") for n in range(5)),
        *((n, n, "second") for n in range(5, 8)),
    ]
    hashes = [row["content_hash"] for part in parts for row in rows_of(open_dataset(part).folder)]
    assert [row["content_hash"] for row in found] == hashes
    times = [row for part in parts for row in read_table(open_dataset(part).folder.meta / "seconds.parquet")]
    joined_times = list(read_table(joined.folder.meta / "seconds.parquet"))
    assert times and [row["seconds"] for row in joined_times] == [row["seconds"] for row in times]
    assert {row["index"] for row in joined_times} == set(range(8))


def test_killed_again_and_again_it_ends_in_the_same_bytes(capsys):
    assert torture.main(["--scenes", "200", "--kills", "20", "--others", "1,4,shards", "--easy"]) == 0
    said = capsys.readouterr().out
    hit = int(said.partition("killed: equal (")[2].partition(" kills before the end")[0])
    assert hit >= 20 - torture.PACKED, said  # those that come while it packs may find it whole
