"""Damaged data sets: what a run goes on from is what was written, or is noticed and made anew."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path
from unittest import mock

import pytest

from sceneweaver.datasets import Folder
from sceneweaver.datasets.checking import verify_dataset
from sceneweaver.datasets.engines import begin, merge, open_dataset
from sceneweaver.datasets.engines.run import run_lock
from sceneweaver.datasets.reading import extract, spans_of
from sceneweaver.datasets.seals import (
    SEAL,
    DamagedError,
    folder_fault,
    read_seal,
    require_inside,
    seal_folder,
    sealed_row,
)
from sceneweaver.io import InputError
from sceneweaver.io.tars import header
from tests.datasets import tamper, torture
from tests.sizes import share

COUNT = 12


@pytest.fixture(scope="module")
def stages(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A data set of scenes that cost nothing, at each stage, and another version of it."""
    place = tmp_path_factory.mktemp("stages")
    tamper.make_stages(place, "scenes", COUNT, easy=True)
    return place


@pytest.fixture(scope="module")
def expected(stages: Path) -> dict[str, str]:
    return torture.content(stages / "whole")


def attempt(stages: Path, expected: dict[str, str], stage: str, kind: str, way: str) -> tamper.Case:
    found = tamper.tried(tamper.Case(stage, kind, way), stages, stages / "spec.yaml", expected, easy=True, seed=0)
    assert found is not None
    return found


BLOCK = "work/blocks/*/*/"
CASES = [
    ("made", BLOCK + "samples.tar", "flip"),
    ("made", BLOCK + "samples.tar", "cut"),
    ("made", BLOCK + "rows.jsonl", "gone"),
    ("made", BLOCK + "rows.jsonl", "swap"),
    ("made", BLOCK + "seal.sha256", "pipe"),
    ("made", "assets/*/*", "flip"),
    ("made", "assets/*/*", "gone"),
    ("made", "dataset.json", "flip"),
    ("made", "spec.yaml", "cut"),
    ("made", "work/begun.sha256", "older"),
    ("half packed", "work/plan/*.parquet", "flip"),
    ("half packed", BLOCK + "samples.tar", "flip"),
    ("one shard", "data/*", "flip"),
    ("one shard", "data/*", "gone"),
    ("not summed", "meta/index.parquet", "cut"),
    ("whole", "data/*", "gone"),
    ("whole", "data/*", "flip"),
    ("whole", "data/*", "pipe"),
    ("whole", "meta/index.parquet", "cut"),
    ("whole", "meta/assets.parquet", "folder"),
    ("whole", "README.md", "flip"),
    ("whole", "checksums.sha256", "cut"),
    ("whole", "meta/seconds.parquet", "flip"),
    ("whole", "work/packed", "flip"),
]


@pytest.mark.parametrize(("stage", "kind", "way"), share(CASES, 2), ids=lambda value: value.replace("/", "-"))
def test_damage_is_noticed_and_made_anew_to_the_same_bytes(stages, expected, stage, kind, way):
    found = attempt(stages, expected, stage, kind, way)
    assert found.noticed and found.equal, found.detail


def test_a_record_counts_where_no_other_file_holds_it_and_packing_has_not_begun(stages, expected, tmp_path):
    """Each process writes the records that it meets; one that another wrote as well may go without a word."""
    copies = tmp_path / "stages"
    for stage in ("made", "one shard"):
        folder = shutil.copytree(stages / stage, copies / stage) / "work" / "assets"
        folder.mkdir()
        for name, assets in (("0", "ab"), ("1", "bc"), ("2", "c")):
            rows = [json.dumps(sealed_row({"asset": asset, "files": []})) + "\n" for asset in assets]
            (folder / f"{name}.jsonl").write_text("".join(rows))

    def needed(stage: str, name: str) -> bool:
        case = tamper.Case(stage, f"work/assets/{name}.jsonl", "gone")
        with mock.patch.object(tamper, "RECORDS", case.kind):
            found = tamper.tried(case, copies, stages / "spec.yaml", expected, easy=True, seed=0)
        assert found is not None and found.equal
        return found.needed

    assert [needed("made", name) for name in "012"] == [True, False, False]
    assert not needed("one shard", "0")


def test_the_beginning_of_a_shard_counts_as_far_as_it_is_what_was_planned(stages, expected):
    for way in ("flip", "cut", "older"):
        assert attempt(stages, expected, "half packed", "work/plan/*.tar", way).equal


@pytest.mark.slow
@pytest.mark.parametrize("product", ["scenes", "layouts"])
def test_every_kind_of_file_damaged_in_every_way(product, capsys):
    count = {"scenes": COUNT, "layouts": 32}[product]
    options = ["--scenes", str(count), "--product", product]
    assert tamper.main([*options, "--easy"] if product == "scenes" else options) == 0, capsys.readouterr().out


def test_a_whole_set_without_a_shard_is_told_and_its_sizes_are_looked_at_alone(stages, expected, tmp_path, monkeypatch):
    out = shutil.copytree(stages / "whole", tmp_path / "set")
    monkeypatch.setattr("sceneweaver.datasets.seals.sha256", lambda path: pytest.fail(f"{path} was read"))
    dataset = open_dataset(out)
    from sceneweaver.datasets.engines.mending import lost

    assert lost(dataset) == []
    (out / "data" / "train-000000.tar").unlink()
    assert lost(dataset) == [("data/train-000000.tar", "is missing")]


def test_a_seal_says_what_is_wrong(tmp_path):
    folder = tmp_path / "00000007"
    folder.mkdir()
    (folder / "rows.jsonl").write_text("{}\n")
    (folder / "samples.tar").write_bytes(bytes(100))
    seal_folder(folder)
    assert folder_fault(folder) == "" and len(read_seal(folder / SEAL)) == 2
    (folder / "samples.tar").write_bytes(bytes(99) + b"1")
    assert folder_fault(folder) == "samples.tar has other content"
    (folder / "samples.tar").write_bytes(bytes(9))
    assert folder_fault(folder) == "samples.tar has 9 bytes, not 100"
    (folder / "samples.tar").write_bytes(bytes(100))
    (folder / "more").write_text("")
    assert folder_fault(folder) == "more is no part of it"
    (folder / "more").unlink()
    other = folder.rename(tmp_path / "00000008")
    assert folder_fault(other) == f"{SEAL}: has other content"  # of another block
    for name in ("/etc/passwd", "../x", "a/../../x", ""):
        with pytest.raises(DamagedError, match="no path within the data set"):
            require_inside(name, tmp_path)


HOLD = """
import sys, time
from pathlib import Path
from sceneweaver.datasets.engines.run import run_lock
from sceneweaver.datasets.folder import Folder
with run_lock(Folder(Path(sys.argv[1])), None):
    print("ready", flush=True)
    time.sleep(120)
"""


def test_whoever_comes_second_hears_which_process_holds_the_folder(stages, tmp_path):
    out = shutil.copytree(stages / "made", tmp_path / "set")
    other = shutil.copytree(stages / "made", tmp_path / "other")
    process = subprocess.Popen([sys.executable, "-c", HOLD, str(out)], stdout=subprocess.PIPE)
    try:
        assert process.stdout is not None and process.stdout.readline() == b"ready\n"
        held = rf"is being written by process {process.pid}; wait for it"
        for call in (
            lambda: tamper.make(out, stages / "spec.yaml", easy=True),
            lambda: tamper.make(out, easy=True),
            lambda: merge([out, other], tmp_path / "merged"),
            lambda: verify_dataset(out),
        ):
            with pytest.raises(InputError, match=held):
                call()
        (out / "dataset.json").unlink()  # as it is while the first one begins
        (out / "work" / "begun.sha256").unlink()
        with pytest.raises(InputError, match=held):
            begin(stages / "spec.yaml", out, "cpu")
    finally:
        process.kill()
        process.wait()


def test_two_that_begin_at_once_are_of_one_data_set(stages, tmp_path, monkeypatch):
    """The second one has seen no manifest, and finds it when it holds the folder."""
    from sceneweaver.datasets.engines import manifest

    out, loaded = tmp_path / "set", []
    load = manifest.load_source

    def late(source):
        found = load(source)
        if not loaded:
            loaded.append(source)
            begin(source, out, "cpu")
        return found

    monkeypatch.setattr(manifest, "load_source", late)
    monkeypatch.setattr(manifest.os.path, "lexists", _blind_once(out / "dataset.json"))
    assert begin(stages / "spec.yaml", out, "cpu").to_dict() == open_dataset(out).to_dict()


def _blind_once(path: Path):
    lexists, seen = os.path.lexists, []

    def answer(place):
        if Path(place) == path and len(seen) < 3:
            seen.append(place)
            return len(seen) != 3 and lexists(place)
        return lexists(place)

    return answer


@pytest.mark.parametrize(
    ("field", "value"),
    [("schema", "sceneweaver.dataset-manifest/2"), ("name", "other"), ("hash", "0" * 64), ("device", "tpu")],
)
def test_a_manifest_that_does_not_agree_with_itself_is_named(stages, tmp_path, field, value):
    out = shutil.copytree(stages / "whole", tmp_path / "set")
    (out / "work" / "begun.sha256").unlink()
    path = out / "dataset.json"
    path.write_text(json.dumps(json.loads(path.read_text()) | {field: value}))
    with pytest.raises(InputError, match=f"dataset.json: damaged: {field} is") as found:
        verify_dataset(out)
    assert "\n" not in str(found.value)


def found_in(out: Path) -> set[tuple[str, str]]:
    return {(fault["check"], fault["key"]) for fault in verify_dataset(out, sample=1).data["first"]}


@pytest.mark.parametrize("kind", ["pipe", "device", "link", "folder"])
def test_what_is_no_file_in_place_of_a_shard_is_a_finding(stages, tmp_path, kind):
    out = shutil.copytree(stages / "whole", tmp_path / "set")
    path = out / "data" / "train-000000.tar"
    (tmp_path / "aside").write_bytes(path.read_bytes())
    path.unlink()
    if kind == "pipe":
        os.mkfifo(path)
    elif kind == "folder":
        path.mkdir()
    else:
        path.symlink_to("/dev/zero" if kind == "device" else tmp_path / "aside")
    check = "checksum" if kind == "folder" else "file"
    assert {(check, "data/train-000000.tar"), ("shard", "train-000000.tar")} <= found_in(out)


def test_tables_that_cannot_be_read_and_foreign_files_are_findings(stages, tmp_path):
    out = shutil.copytree(stages / "whole", tmp_path / "set")
    index = out / "meta" / "index.parquet"
    index.write_bytes(index.read_bytes()[:-100])
    (out / "meta" / "assets.parquet").write_bytes(b"PAR1")
    (out / "notes.txt").write_text("mine")
    (out / "assets" / "more.bin").write_text("mine")
    named = found_in(out)
    assert {("index", "index.parquet"), ("checksum", "meta/index.parquet"), ("checksum", "assets/more.bin")} <= named
    assert {("file", "notes.txt"), ("checksum", "meta/assets.parquet")} <= named


def test_a_shard_that_may_not_be_read_is_a_finding(stages, tmp_path, monkeypatch):
    out = shutil.copytree(stages / "whole", tmp_path / "set")
    opened = os.open

    def refused(path, *args, **options):
        if os.fspath(path).endswith("train-000000.tar"):
            raise PermissionError(13, "Permission denied")
        return opened(path, *args, **options)

    monkeypatch.setattr(os, "open", refused)
    found = verify_dataset(out, sample=1)
    lines = [fault["detail"] for fault in found.data["first"] if fault["key"].endswith("train-000000.tar")]
    assert lines and all("Permission denied" in line for line in lines)


@pytest.mark.parametrize("name", ["../out.txt", "/etc/out", "link"])
def test_shards_hold_plain_files_with_names_within(tmp_path, name):
    import tarfile

    path = tmp_path / "a.tar"
    with tarfile.open(path, "w") as tar:
        member = tarfile.TarInfo(name)
        if name == "link":
            member.type, member.linkname = tarfile.SYMTYPE, "/etc/passwd"
        tar.addfile(member)
    with pytest.raises(InputError, match="in it"):
        list(spans_of(path, 1))
    path.write_bytes(header("00000000.glb", 2**31) + bytes(1024))
    with pytest.raises(InputError, match="no whole tar file"):
        list(spans_of(path, 1))


def test_a_scene_that_is_not_what_was_delivered_is_not_taken_out(stages, tmp_path):
    out = shutil.copytree(stages / "whole", tmp_path / "set")
    for path in (out / "data").iterdir():
        content = bytearray(path.read_bytes())
        content[content.index(b'"schema"') + 2] ^= 1
        path.write_bytes(content)
    with pytest.raises(InputError, match="not what was delivered; fetch it anew"):
        for number in range(COUNT):
            extract(out, f"{number:08d}", tmp_path / "one" / str(number))


def test_a_shard_run_locks_out_a_whole_one_by_name(stages, tmp_path):
    out = shutil.copytree(stages / "made", tmp_path / "set")
    held = f"written by process {os.getpid()}"
    with run_lock(Folder(out), (0, 2)), pytest.raises(InputError, match=held):
        verify_dataset(out)


@pytest.mark.parametrize("name", ["work", "data", "meta", "assets", "work/plan"])
def test_a_folder_of_a_set_that_is_a_link_is_not_written_through(stages, tmp_path, name):
    out, away = shutil.copytree(stages / "made", tmp_path / "set"), tmp_path / "away"
    away.mkdir()
    shutil.rmtree(out / name, ignore_errors=True)
    (out / name).symlink_to(away)
    with pytest.raises(InputError, match="this is a link to another place"):
        tamper.make(out, easy=True)
    assert not list(away.iterdir())


@pytest.mark.parametrize("name", ["work", "inputs"])
def test_no_set_begins_through_a_link(tmp_path, name):
    out, away, spec = tmp_path / "set", tmp_path / "away", tmp_path / "spec.yaml"
    out.mkdir(), away.mkdir()
    (out / name).symlink_to(away)
    spec.write_text(tamper.LAYOUTS.format(seed=0, count=2, zoo=tamper.ZOO))
    with pytest.raises(InputError, match=f"{out} is not empty"):
        begin(spec, out, "cpu")
    assert not list(away.iterdir()) and [path.name for path in out.iterdir()] == [name]
