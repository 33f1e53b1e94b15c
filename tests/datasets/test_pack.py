"""Packing: shards, tables and texts, whole after any cut, in equal bytes."""

import hashlib
import json
import os
import shutil
import tarfile

import pytest

from sceneweaver.datasets import Folder
from sceneweaver.datasets.files import pack, packing, packing_began, planned
from sceneweaver.datasets.seals import sealed_row
from sceneweaver.datasets.tables import arrow
from sceneweaver.scene import InputError
from tests.datasets.small import make_small


def contents(root):
    """SHA-256 of every file by its path."""
    files = [p for p in sorted(root.rglob("*")) if p.is_file()]
    return {p.relative_to(root).as_posix(): hashlib.sha256(p.read_bytes()).hexdigest() for p in files}


def rows_of(root):
    return arrow().parquet.read_table(root / "meta" / "index.parquet").to_pylist()


@pytest.fixture(scope="module")
def packed(tmp_path_factory):
    root = tmp_path_factory.mktemp("packed")
    requests = make_small(root, 12, failed=(3,))
    pack(Folder(root), requests)
    return root


def test_every_delivered_scene_is_in_the_shard_that_the_index_names(packed):
    rows = rows_of(packed)
    assert [row["index"] for row in rows] == list(range(12))
    assert [row["index"] for row in rows if row["status"] != "ok"] == [3]
    assert rows[3]["split"] is None and rows[3]["reason"] == "too small: nothing fits"
    for name in {row["shard"] for row in rows} - {None}:
        expected = [row["key"] for row in rows if row["shard"] == name]
        with tarfile.open(packed / name) as tar:
            members = tar.getmembers()
            assert [m.name for m in members] == [f"{k}.{s}" for k in expected for s in ("metrics.json", "scene.json")]
            assert {m.mtime for m in members} == {0}
            for key in expected:
                scene = json.loads(tar.extractfile(f"{key}.scene.json").read())
                assert scene["room"]["type"] == rows[int(key)]["room_type"]


def test_the_hash_of_a_row_is_that_of_its_files(packed):
    row = rows_of(packed)[5]
    digest = hashlib.sha256()
    with tarfile.open(packed / row["shard"]) as tar:
        for suffix in ("metrics.json", "scene.json"):
            content = tar.extractfile(f"{row['key']}.{suffix}").read()
            digest.update(f"{suffix}:{len(content)}\n".encode() + content)
    assert row["content_hash"] == digest.hexdigest()


def test_checksums_cover_all_files_but_times(packed):
    lines = [line.split("  ") for line in (packed / "checksums.sha256").read_text().splitlines()]
    found = contents(packed)
    assert {name for _, name in lines} == set(found) - {"checksums.sha256", "meta/seconds.parquet"}
    assert all(found[name] == digest for digest, name in lines)


def test_times_lie_in_a_table_of_their_own(packed):
    rows = arrow().parquet.read_table(packed / "meta" / "seconds.parquet").to_pylist()
    assert {"index": 0, "stage": "export", "seconds": 0.5} in rows
    assert len(rows) == 11 * 2 + 1


def test_nothing_is_left_of_the_blocks_and_packing_again_changes_nothing(packed):
    before = contents(packed)
    assert not list((packed / "work").rglob("*.jsonl")) and not (packed / "work" / "plan").exists()
    requests = make_small(packed / "other", 12)
    shutil.rmtree(packed / "other")
    pack(Folder(packed), requests)
    assert contents(packed) == before


class Killed(BaseException):
    """As a signal would, it passes through every handler."""


def test_killed_at_any_step_it_goes_on_to_the_same_bytes(tmp_path, monkeypatch):
    monkeypatch.setattr(packing, "SAFE", 0)  # so that blocks go one by one
    whole, torn = tmp_path / "whole", tmp_path / "torn"
    requests = make_small(whole, 8, failed=(1,), shard=1, splits={"train": 0.7, "test": 0.3})
    shutil.copytree(whole, torn)
    pack(Folder(whole), requests)
    assert packing_began(Folder(whole))
    steps = {"left": 0}

    def counted(function):
        def call(*args, **kwargs):
            steps["left"] -= 1
            if steps["left"] == 0:
                raise Killed
            return function(*args, **kwargs)

        return call

    for name in ("fsync", "replace", "rename", "truncate"):
        monkeypatch.setattr(os, name, counted(getattr(os, name)))
    deaths, allowed = 0, 1
    while True:
        steps["left"] = allowed
        try:
            pack(Folder(torn), requests)
            break
        except Killed:
            deaths += 1
            allowed = 1 + deaths
    assert deaths >= 8
    assert contents(torn) == contents(whole)


def test_a_torn_end_of_a_shard_is_written_again(tmp_path, monkeypatch):
    monkeypatch.setattr(packing, "SAFE", 0)
    whole, torn = tmp_path / "whole", tmp_path / "torn"
    requests = make_small(whole, 8)
    shutil.copytree(whole, torn)
    pack(Folder(whole), requests)
    sync, calls = packing.Shards.sync, []

    def killed(self):
        sync(self)
        calls.append(self)
        if len(calls) == 3:  # the samples of three blocks are copied, two of the blocks are gone
            raise Killed

    monkeypatch.setattr(packing.Shards, "sync", killed)
    with pytest.raises(Killed):
        pack(Folder(torn), requests)
    wanted = planned.planned(Folder(torn))
    begun = {torn / "work" / "plan" / name.rpartition("/")[2]: scenes for name, scenes in wanted.items()}
    begun = {path: planned.there(path, scenes)[1] for path, scenes in begun.items() if path.exists()}
    assert any(begun.values())
    for path, end in begun.items():
        with open(path, "r+b") as file:
            file.truncate(max(end - 700, 0))
    pack(Folder(torn), requests)
    assert contents(torn) == contents(whole)


def test_a_missing_block_is_named(tmp_path):
    requests = make_small(tmp_path, 6)
    shutil.rmtree(Folder(tmp_path).block(1))
    with pytest.raises(InputError, match="block 00000001 of 3 is missing"):
        pack(Folder(tmp_path), requests)
    assert not packing_began(Folder(tmp_path))


def test_a_shard_ends_where_the_next_scene_would_not_fit(tmp_path):
    requests = make_small(tmp_path, 6, splits={"all": 1.0}, shard=1, files={"glb": bytes(400_000)})
    pack(Folder(tmp_path), requests)
    assert [row["shard"][-8:-4] for row in rows_of(tmp_path)] == ["0000", "0000", "0001", "0001", "0002", "0002"]
    with tarfile.open(tmp_path / "data" / "all-000002.tar") as tar:
        assert len(tar.getnames()) == 6


def test_nothing_delivered_is_a_data_set_as_well(tmp_path):
    requests = make_small(tmp_path, 4, failed=(0, 1, 2, 3))
    pack(Folder(tmp_path), requests)
    assert {row["status"] for row in rows_of(tmp_path)} == {"failed"}
    assert list((tmp_path / "data").iterdir()) == []
    assert "| too small | 4 |" in (tmp_path / "README.md").read_text()


def test_assets_that_no_scene_names_go_and_others_are_listed(tmp_path):
    from sceneweaver.datasets import AssetStore

    store = AssetStore(tmp_path)
    kept, left = store.put(b"mesh", "bin"), store.put(b"of a scene that failed", "bin")
    requests = make_small(tmp_path, 2, row={"assets": [kept], "asset_ids": ["chair:1"]})
    lines = [
        {"asset": name, "category": "chair", "source": "abo", "licence": "CC-BY-4.0", "attribution": "Amazon Berkeley "}
        | {"files": [path], "bytes": 4}
        for name, path in (("chair:1", kept), ("chair:2", left))
    ]
    record = tmp_path / "work" / "assets" / "0.jsonl"
    record.parent.mkdir()
    torn = '{"asset": "torn'
    wrong = json.dumps(sealed_row(lines[0]) | {"licence": "MIT"}) + "\n"
    record.write_text("".join(json.dumps(sealed_row(line)) + "\n" for line in lines) + wrong + torn)
    pack(Folder(tmp_path), requests)
    assert (tmp_path / kept).exists() and not (tmp_path / left).exists()
    table = arrow().parquet.read_table(tmp_path / "meta" / "assets.parquet").to_pylist()
    assert table == lines[:1]
    text = (tmp_path / "LICENSES.md").read_text()
    assert "| abo | [CC-BY-4.0](https://creativecommons.org/licenses/by/4.0/) | Amazon Berkeley  | 1 |" in text
    assert kept in (tmp_path / "checksums.sha256").read_text()
    assert "license: cc-by-4.0" in (tmp_path / "README.md").read_text()
