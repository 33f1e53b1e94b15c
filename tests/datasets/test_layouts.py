"""Layouts as a product: every row is a valid layout of its program, and the files follow from the specification."""

from __future__ import annotations

import hashlib
import json
import shutil
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest
import yaml

from sceneweaver.datasets import Folder, Requests, Spec, make_block, read_rows
from sceneweaver.datasets.checking import verify_dataset
from sceneweaver.datasets.digests import write_checksums
from sceneweaver.datasets.engines.manifest import create
from sceneweaver.datasets.layouts import join, load_layout, load_program, pack, write_programs
from sceneweaver.datasets.layouts.block import as_tall_as_it_stands
from sceneweaver.datasets.layouts.collect import Seen, Signatures
from sceneweaver.datasets.layouts.tables import Writers, posed, row_groups
from sceneweaver.layout.compile import compile_scene
from sceneweaver.layout.sampling import first_layouts
from sceneweaver.scene import InputError, Scene
from sceneweaver.verify import check
from tests.test_repository import ROOT, code_blocks

GUIDE = (ROOT / "docs" / "datasets_layouts.md").read_text()
ZOO = ROOT / "tests" / "zoo"
NAMES = ("bedroom-small.json", "living.json", "dining-round.json", "children-twin.json")
LAYOUTS = 40
PARTS = ((-1.0, 2.0, [0.0, 0.9]), (-0.2, 0.4, [0.9, 1.5]))  # along y, depth and height [m]


def spec_of(**changes) -> Spec:
    fields = {
        "schema": "sceneweaver.dataset/1",
        "name": "few",
        "product": "layouts",
        "count": LAYOUTS * len(NAMES),
        "seed": 5,
        "requests": {"scenes": NAMES},
        "rooms": {"layouts": LAYOUTS, "candidates": 8},
        "splits": {"train": 1.0, "test": 1.0},
        "block": 2,
    }
    return Spec.model_validate(fields | changes)


def made(path: Path, blocks: tuple[int, ...]) -> Folder:
    folder, requests = Folder(path), Requests(spec_of(), ZOO)
    for number in blocks:
        make_block(folder, requests, number, "cpu")
    pack(folder, requests)
    return folder


@pytest.fixture(scope="module")
def dataset(tmp_path_factory) -> Folder:
    return made(tmp_path_factory.mktemp("layouts"), (0, 1))


def digests(dataset: Folder) -> dict[str, str]:
    paths = [*dataset.data.iterdir(), *dataset.meta.iterdir()]
    same = (path for path in paths if path.name != "seconds.parquet")
    return {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in same}


def table(dataset: Folder):
    import pyarrow.parquet as pq

    return pq.read_table(dataset.data)


def programs(dataset: Folder) -> list[dict]:
    import pyarrow.parquet as pq

    return pq.read_table(dataset.meta / "programs.parquet").to_pylist()


def test_every_layout_is_valid(dataset):
    rows = programs(dataset)
    assert [row["layouts"] for row in rows] == [LAYOUTS] * len(NAMES)
    for row in rows:
        for layout in (0, LAYOUTS // 2, LAYOUTS - 1):
            scene = load_layout(dataset.path, row["program"], layout)
            assert check(scene, walkable=False).valid, (row["program"], layout)
            assert scene.replace_poses({o.id: o.pose for o in scene.objects}) == scene
        assert load_program(dataset.path, row["program"]).ids == scene.ids


def test_rows_are_distinct_and_say_which_are_alike(dataset):
    found = table(dataset)
    width = found.schema.field("poses").type.list_size
    assert width == 4 * max(row["object_count"] for row in programs(dataset))
    for row in programs(dataset):
        mine = found.filter(np.equal(found["program"].to_numpy(), row["program"]))
        assert mine["layout"].to_pylist() == list(range(LAYOUTS))
        assert len(set(mine["signature"].to_pylist())) == LAYOUTS
        assert 1 <= len(set(mine["near_duplicate_group"].to_pylist())) <= LAYOUTS
        poses = np.array(mine["poses"].to_pylist(), dtype=np.float32).reshape(LAYOUTS, -1, 4)
        count = row["object_count"]
        assert np.isfinite(poses[:, :count]).all() and np.isnan(poses[:, count:]).all()


def test_the_order_of_blocks_and_other_processes_change_nothing(dataset, tmp_path):
    assert digests(made(tmp_path, (1, 0))) == digests(dataset)


def test_programs_made_one_by_one_give_the_same_bytes(dataset, tmp_path):
    folder, requests = Folder(tmp_path), Requests(spec_of(), ZOO)
    for number in range(requests.blocks):
        parts = []
        for request in requests.block(number):
            parts.append(tmp_path / "parts" / str(request.room))
            write_programs(parts[-1], requests, [request], "cpu")
        join(folder.block(number), requests, parts)
    pack(folder, requests)
    assert digests(folder) == digests(dataset)


def test_a_program_that_ended_its_worker_is_a_row_with_the_reason(tmp_path):
    requests = Requests(spec_of(), ZOO)
    path = tmp_path / "part"
    write_programs(path, requests, requests.block(0)[:1], "cpu", {0: "worker killed by signal 9"})
    (row,) = read_rows(path)
    assert (row["status"], row["reason"], row["room"]) == ("failed", "worker killed by signal 9", 0)


def test_polars_and_duckdb_read_them(dataset):
    import duckdb
    import polars

    files = f"{dataset.data}/*.parquet"
    frame = polars.scan_parquet(files).group_by("program").agg(polars.len(), polars.col("soft").min()).collect()
    assert sorted(frame["len"].to_list()) == [LAYOUTS] * len(NAMES)
    ((count, least),) = duckdb.sql(f"select count(*), min(len(poses)) from '{files}'").fetchall()
    assert count == LAYOUTS * len(NAMES) and least == table(dataset).schema.field("poses").type.list_size


@pytest.mark.parametrize("block", code_blocks(GUIDE, "python"), ids=lambda text: text.split()[1])
def test_the_guide_runs(block, dataset, monkeypatch):
    monkeypatch.chdir(dataset.path)
    exec(compile(block, "<docs/datasets_layouts.md>", "exec"), {"__name__": "guide"})


def test_the_specification_of_the_guide_is_one():
    (text,) = code_blocks(GUIDE, "yaml")
    assert len(Requests(Spec.model_validate(yaml.safe_load(text)))) == 20


def test_programs_keep_to_one_split(dataset):
    import pyarrow.parquet as pq

    where: dict[int, set[str]] = {}
    for path in dataset.data.iterdir():
        for program in set(pq.read_table(path)["program"].to_pylist()):
            where.setdefault(program, set()).add(path.name.split("-")[0])
    assert {k: {row["split"]} for k, row in enumerate(programs(dataset))} == where


def test_what_is_not_there_is_said(dataset):
    with pytest.raises(InputError, match="no layouts of program 99"):
        load_program(dataset.path, 99)
    with pytest.raises(InputError, match="has 40 layouts, none of number 40"):
        load_layout(dataset.path, 0, LAYOUTS)
    with pytest.raises(InputError, match="not packed yet"):
        load_program(dataset.path / "meta", 0)


def test_a_program_that_does_not_fit_has_a_reason(tmp_path):
    spec = spec_of(rooms={"layouts": 2, "objects": (1, 3), "attempts": 1}, count=2)
    folder, requests = Folder(tmp_path), Requests(spec, ZOO)
    make_block(folder, requests, 0, "cpu")
    pack(folder, requests)
    (row,) = programs(folder)
    assert row["status"] == "rejected" and row["reason"].endswith("objects, not 1 to 3") and row["layouts"] == 0


def test_signatures_tell_cells_and_turns_apart():
    scene = Scene.load(ZOO / "living.json")
    poses = np.array([[(*o.pose.position, o.pose.yaw) for o in scene.objects]] * 4, dtype=np.float32)
    free = next(k for k, o in enumerate(scene.objects) if o.mount == "floor" and not o.fixed)
    poses[1, free, 0] = poses[0, free, 0] + 0.5
    poses[2, free, 3] = poses[0, free, 3] + np.pi / 2
    poses[3, free, 3] = poses[0, free, 3] + 2 * np.pi
    hashes = Signatures(scene).distinct(poses)
    assert hashes[0] == hashes[3] and len(set(hashes.tolist())) == 3
    assert not len(Signatures(scene).distinct(poses[:0])) and not len(Signatures(scene).group(poses[:0]))


def test_what_was_seen_counts_once():
    seen, rng, known = Seen(), np.random.default_rng(0), set()
    for _ in range(20):
        hashes = rng.integers(0, 200, 50)
        first: list[int] = []
        for k, value in enumerate(hashes.tolist()):
            if value not in known and len(first) < 12:
                known.add(value)
                first.append(k)
        assert seen.add(hashes, 12).tolist() == first


def test_verification_finds_a_moved_object_a_lost_layout_and_a_wrong_split(dataset, tmp_path):
    import pyarrow as pa
    import pyarrow.parquet as pq

    root = tmp_path / "set"
    create(Folder(root), spec_of(), "cpu")
    shutil.copytree(dataset.path, root, dirs_exist_ok=True)
    write_checksums(Folder(root))
    found = verify_dataset(root, sample=8)
    assert found.ok and found.data["counts"]["judged"] == 8 and found.data["counts"]["layouts"] == LAYOUTS * len(NAMES)

    shard = sorted((root / "data").iterdir())[0]
    rows = pq.read_table(shard)
    program = rows["program"][0].as_py()
    poses = rows["poses"].to_pylist()
    poses[0][0] += 30.0
    wrong = rows.set_column(2, rows.schema.field("poses"), pa.array(poses, rows.schema.field("poses").type))
    others = wrong.filter(np.not_equal(wrong["program"].to_numpy(), program))
    with pq.ParquetWriter(shard, rows.schema) as writer:
        writer.write_table(wrong.filter(np.equal(wrong["program"].to_numpy(), program)).slice(0, LAYOUTS - 1))
        for name in sorted(set(others["program"].to_pylist())):
            writer.write_table(others.filter(np.equal(others["program"].to_numpy(), name)))
    path = root / "meta" / "programs.parquet"
    table = pq.read_table(path).to_pylist()
    table[program]["split"] = "validation"
    pq.write_table(pa.Table.from_pylist(table, pq.read_schema(path)), path)
    named = {(fault["check"], fault["key"]) for fault in verify_dataset(root).data["first"]}
    assert {("checksum", f"data/{shard.name}"), ("checksum", "meta/programs.parquet")} <= named
    assert {("judge", f"{program}/0"), ("shard", str(program)), ("index", str(program))} <= named


def test_many_threads_hand_over_layouts(tmp_path):
    import pyarrow as pa

    rows, before = pa.table({"program": [0]}), sys.getswitchinterval()
    sys.setswitchinterval(1e-6)
    try:
        with Writers(tmp_path, rows.schema) as writers, ThreadPoolExecutor(16) as pool:
            list(pool.map(lambda program: writers.write(program, rows), range(400)))
    finally:
        sys.setswitchinterval(before)
    assert len(row_groups(tmp_path)) == 400


def test_a_shelf_above_a_counter_is_above_what_stands_on_it():
    box = {"category": "counter", "mount": "floor", "size": [0.6, 2.0, 0.9], "pose": {"position": [2, 0.31, 0]}}
    machine = [{"polygon": [[-0.3, y], [0.3, y], [0.3, y + w], [-0.3, y + w]], "z": z} for y, w, z in PARTS]
    shelf = {"id": "shelf", "category": "wall_shelf", "mount": "wall", "size": [0.2, 1.0, 0.2]}
    scene = Scene.loads(
        json.dumps(
            {
                "schema": "sceneweaver.scene/1",
                "id": "counter",
                "room": {"outline": [[0, 0], [4, 0], [4, 3], [0, 3]]},
                "objects": [{"id": "counter", "parts": machine, **box}, shelf],
                "relations": [
                    {"type": "against_wall", "subject": "counter"},
                    {"type": "against_wall", "subject": "shelf"},
                    {"type": "above", "subject": "shelf", "target": "counter"},
                ],
            }
        )
    )
    taller = as_tall_as_it_stands(scene)
    assert taller.object("counter").size == (0.6, 2.0, 1.5) and taller.object("shelf") == scene.object("shelf")
    (found,) = first_layouts([compile_scene(taller)], range(8), 4, [0], "cpu")
    assert len(found.poses) >= 2
    assert all(check(posed(taller, poses), walkable=False).valid for poses in found.poses)
