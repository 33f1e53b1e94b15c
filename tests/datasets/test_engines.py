"""Runs of data sets: the same bytes whoever makes them, and no trouble of one room ends them."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from sceneweaver.datasets import read_rows
from sceneweaver.datasets.engines import (
    Listener,
    Options,
    begin,
    estimate,
    merge,
    missing,
    open_dataset,
    read_records,
    resume,
    status,
)
from sceneweaver.datasets.engines.run import run_lock
from sceneweaver.datasets.engines.schedule import Job, Schedule
from sceneweaver.datasets.engines.status import grown
from sceneweaver.datasets.folder import DiskFullError, disk_full
from sceneweaver.io import write_atomic
from sceneweaver.scene import InputError
from tests.datasets import fake

SPEC = """
schema: sceneweaver.dataset/1
name: tiny
count: 12
block: 2
requests: {prompts: [%s]}
"""


def spec_file(folder: Path, *prompts: str, more: str = "") -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / "spec.yaml"
    path.write_text(SPEC % ", ".join(f'"{p}"' for p in prompts or ["a room"]) + more)
    return path


def made(source: Path, out: Path, workers: int = 1, **options: object) -> list[str]:
    """Make a data set; what was noticed on the way."""
    notices: list[str] = []
    dataset = begin(source, out, "cpu")
    listener = Listener(lambda record: None, notices.append)
    resume(dataset, Options(workers=workers, **options), listener, produce=fake.produce, pack=lambda dataset: None)
    return notices


def content(out: Path) -> dict[str, bytes]:
    """All that a data set holds but what no two runs agree on."""
    times = ("seconds.jsonl", "seal.sha256")  # the seal of a block has the digest of its times
    paths = (p for p in out.rglob("*") if p.is_file() and p.name not in times and "records" not in p.parts)
    return {str(p.relative_to(out)): p.read_bytes() for p in paths}


def rows(out: Path) -> list[dict]:
    dataset = open_dataset(out)
    return [row for n in range(dataset.requests.blocks) for row in read_rows(dataset.folder.block(n))]


def test_workers_and_shares_on_other_disks_make_the_same_bytes(tmp_path):
    source = spec_file(tmp_path, "a room", "a hopeless room", "b room")
    made(source, tmp_path / "one", workers=1)
    made(source, tmp_path / "two", workers=2)
    for shard in ((0, 2), (1, 2)):
        made(source, tmp_path / f"disk{shard[0]}", workers=1, shard=shard)
    assert not (tmp_path / "disk0" / "work" / "complete").exists()
    assert missing(merge([tmp_path / "disk0", tmp_path / "disk1"], tmp_path / "merged")) == []
    made(source, tmp_path / "merged", workers=1)
    expected = content(tmp_path / "one")
    assert content(tmp_path / "two") == expected == content(tmp_path / "merged")
    assert [row["status"] for row in rows(tmp_path / "one")] == ["ok", "rejected", "ok"] * 4
    with pytest.raises(InputError, match="is whole: there is nothing to merge"):
        merge([tmp_path / "one", tmp_path / "disk0"], tmp_path / "more")


def test_a_room_that_crashes_is_a_row_and_the_others_are_served(tmp_path):
    source = spec_file(tmp_path, "a room", "b room", "c room", "d room", "crash", "e room")
    source.write_text(source.read_text().replace("12", "6"))
    notices = made(source, tmp_path / "out")
    assert [row["status"] for row in rows(tmp_path / "out")] == ["ok", "ok", "ok", "ok", "failed", "ok"]
    assert {row.get("reason") for row in rows(tmp_path / "out")} == {None, "worker killed by signal 9"}
    assert "room 4: worker killed by signal 9; it has failed" in notices


def test_state_and_records_of_a_run_whose_workers_take_too_much_memory(tmp_path):
    made(spec_file(tmp_path, "a room", "hopeless"), tmp_path / "out", workers=1, shard=(1, 3), memory=1)
    found = status(open_dataset(tmp_path / "out"))
    assert (found.blocks, found.made, found.whole, found.running) == (6, 2, False, True)
    assert found.rows == {"ok": 2, "rejected": 2, "failed": 0} and found.reasons == {"gate grade": 2}
    assert found.seconds_left == pytest.approx(8 / found.rate)
    records = read_records(open_dataset(tmp_path / "out").folder)
    assert [record["block"] for record in records] == [1, 4] and len({record["pid"] for record in records}) == 2
    assert all(r["start"] <= r["end"] and 10**7 < r["rss"] <= r["peak_rss"] * 1.01 and r["ok"] == 1 for r in records)


def test_a_full_disk_is_waited_for(tmp_path, monkeypatch):
    source = spec_file(tmp_path, "a room", "full")
    with pytest.raises(DiskFullError, match=r"disk full: .* MB free, about 64 MB are needed"):
        made(source, tmp_path / "out", workers=1, patient=False)
    assert not (tmp_path / "out" / "work" / "blocks" / "00000" / "00000000").exists()
    notices = made(spec_file(tmp_path / "b", "full"), tmp_path / "other", workers=1)
    assert [text for text in notices if text.startswith("disk full")] and "trying again" in notices
    assert {row["status"] for row in rows(tmp_path / "other")} == {"ok"}


def test_an_error_about_a_full_disk_is_known_through_others(tmp_path):
    try:
        try:
            raise OSError(28, "No space left on device")
        except OSError:
            raise InputError("cannot be written") from None
    except InputError as error:
        assert disk_full(error)
    with pytest.raises(InputError) as found:
        write_atomic(tmp_path / "no" / "file", "")
    assert not disk_full(found.value)


def test_a_changed_specification_is_named_by_its_first_field(tmp_path):
    made(spec_file(tmp_path), tmp_path / "out", workers=1)
    before = content(tmp_path / "out")
    with pytest.raises(InputError, match=r"spec: count is 13, but .*out was begun with 12; choose another folder"):
        source = spec_file(tmp_path / "b")
        source.write_text(source.read_text().replace("12", "13"))
        begin(source, tmp_path / "out", "cpu")
    with pytest.raises(InputError, match=r"--device: cuda:0, but .* was begun on cpu"):
        begin(spec_file(tmp_path), tmp_path / "out", "cuda:0")
    assert content(tmp_path / "out") == before


def test_a_file_of_prompts_goes_with_the_data_set(tmp_path):
    source = spec_file(tmp_path / "in")
    source.write_text(source.read_text().replace('prompts: ["a room"]', "prompts_file: ../wishes.csv"))
    (tmp_path / "wishes.csv").write_text("prompt\na bed\n")
    made(source, tmp_path / "out", workers=1)
    (tmp_path / "wishes.csv").write_text("prompt\na desk\n")
    assert open_dataset(tmp_path / "out").requests[3].prompt == "a bed"
    with pytest.raises(InputError, match="prompts_file has other content"):
        begin(source, tmp_path / "out", "cpu")


@pytest.mark.parametrize("place", ["file", "file/below", "full"])
def test_places_that_will_not_do_are_one_line(tmp_path, place):
    (tmp_path / "file").write_text("")
    (tmp_path / "full").mkdir()
    (tmp_path / "full" / "thesis.txt").write_text("")
    with pytest.raises(InputError, match="choose another") as found:
        begin(spec_file(tmp_path / "in"), tmp_path / place, "cpu")
    assert "\n" not in str(found.value)
    with pytest.raises(InputError, match="no data set"):
        open_dataset(tmp_path / "full")


def test_a_plan_is_for_the_whole_from_a_sample(tmp_path):
    source = spec_file(tmp_path, "a room", "hopeless")
    source.write_text(source.read_text().replace("12", "1000"))
    found = estimate(source, sample=8, workers=2, device="cpu", produce=fake.produce)
    assert (found.count, found.sample, found.shares) == (1000, 8, {"ok": 4, "rejected": 4, "failed": 0})
    assert found.seconds > 1000 * found.scene_seconds / 2 and found.bytes > 1000 * 500
    assert grown([(n, 100 * round(n**0.5)) for n in (1, 4, 16, 64)], 6400) == pytest.approx(8000, rel=1e-6)
    assert grown([(2, 0), (4, 0)], 100) == 0 and grown([(4, 20)], 100) == 500


def test_one_run_at_a_time_or_several_of_different_shards(tmp_path):
    dataset = begin(spec_file(tmp_path), tmp_path / "out", "cpu")
    taken = f"being written by process {os.getpid()}"
    with run_lock(dataset.folder, (0, 2)), run_lock(dataset.folder, (1, 2)):
        for shard in (None, (1, 2)):
            with pytest.raises(InputError, match=taken), run_lock(dataset.folder, shard):
                pass
    with run_lock(dataset.folder, None), pytest.raises(InputError, match=taken), run_lock(dataset.folder, None):
        pass


def test_a_run_whose_time_is_over_leaves_whole_blocks_to_the_next(tmp_path):
    source, records, packed = spec_file(tmp_path), [], []
    dataset = begin(source, tmp_path / "out", "cpu")
    listener = Listener(records.append, print)
    options = Options(workers=1, time_limit=1e-9)
    assert not resume(dataset, options, listener, produce=fake.produce, pack=packed.append)
    assert not records and not packed and len(missing(dataset)) == 6
    (tmp_path / "out" / "work" / "journal").mkdir(
        parents=True
    )  # what processes tell each other, which goes with the last block
    (tmp_path / "out" / "work" / "journal" / "1.journal").write_bytes(bytes(9))
    made(source, tmp_path / "out")
    made(source, tmp_path / "unbroken")
    assert content(tmp_path / "out") == content(tmp_path / "unbroken")


def test_no_block_begins_that_would_not_be_made_in_time(tmp_path, monkeypatch):
    clock = 0.0
    monkeypatch.setattr("sceneweaver.datasets.engines.schedule.time.monotonic", lambda: clock)
    dataset = begin(spec_file(tmp_path), tmp_path / "out", "cpu")
    schedule = Schedule(Job(dataset, Listener(lambda record: None, print), until=100.0), range(6), 1)
    first = schedule.take()
    schedule.heard(first, ("done", {"bytes": 1, "start": 0.0, "end": 40.0}), {})
    clock = 59.0
    second = schedule.take()
    assert second is not None and not schedule.over
    clock = 61.0
    assert schedule.take() is None and not schedule.over  # the second block is in hand
    clock = 101.0
    assert schedule.over  # and dropped
    clock = 61.0
    schedule.heard(second, ("done", {"bytes": 1, "start": 59.0, "end": 61.0}), {})
    assert schedule.take() is None and schedule.over and schedule.waiting == 4


RUN = """
import sys
from pathlib import Path
from sceneweaver.datasets.engines import Listener, Options, begin, resume
from tests.datasets import fake
if __name__ == "__main__":
    dataset = begin(Path(sys.argv[1]), Path(sys.argv[2]), "cpu")
    resume(dataset, Options(workers=1), Listener(lambda r: None, print), produce=fake.produce,
        pack=lambda dataset: None)
"""


def test_a_killed_run_goes_on_to_the_same_bytes(tmp_path):
    source = spec_file(tmp_path, "slow", "slow a", "slow b")
    script = tmp_path / "run.py"
    script.write_text(RUN)
    command = [sys.executable, str(script), str(source), str(tmp_path / "out")]
    process = subprocess.Popen(command, start_new_session=True, env={**os.environ, "PYTHONPATH": os.getcwd()})
    blocks = tmp_path / "out" / "work" / "blocks"
    until = time.monotonic() + 60
    while not list(blocks.glob("*/[0-9]*")) and time.monotonic() < until:
        time.sleep(0.01)
    os.killpg(process.pid, signal.SIGKILL)
    process.wait()
    assert 0 < len(missing(open_dataset(tmp_path / "out"))) < 6
    made(source, tmp_path / "out", workers=1)
    made(source, tmp_path / "unbroken", workers=1)
    assert content(tmp_path / "out") == content(tmp_path / "unbroken")
    assert json.loads((tmp_path / "out" / "dataset.json").read_text())["device"] == "cpu"
