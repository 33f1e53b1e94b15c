"""The report of a data set: what it counts and draws, whole and half way, and its filter in a browser."""

from __future__ import annotations

import json
import math
import re
from pathlib import Path

import numpy as np
import pytest

import sceneweaver as sw
from sceneweaver.datasets import Folder
from sceneweaver.datasets.engines.manifest import create
from sceneweaver.datasets.files import pack
from sceneweaver.datasets.report import collect, memory_svg, write_report
from sceneweaver.datasets.report.charts import histogram, memory, nice, plan, throughput
from sceneweaver.datasets.report.collect import CELLS, PICTURES, Sampler, gather, shell_signature, turn_of, turned
from sceneweaver.datasets.seals import sealed_row
from sceneweaver.datasets.statistics import Spread
from sceneweaver.scene import InputError
from tests.datasets.small import make_small, small_spec
from tests.report.browser import BINARY, Browser

COUNT = 6


@pytest.fixture(scope="module")
def half_way(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A data set whose blocks are not packed; the last scene failed."""
    root = tmp_path_factory.mktemp("half way")
    create(Folder(root), small_spec(COUNT), "cpu", {"spec.yaml": b""})
    make_small(root, COUNT, failed=(COUNT - 1,))
    records = Folder(root).records
    records.mkdir(parents=True)
    lines = [_record(k, 10.0 * k, 10.0 * k + 20.0, worker=k % 2, rss=3e8 + 1e6 * k) for k in range(6)]
    (records / "a.jsonl").write_text("".join(json.dumps(sealed_row(line)) + "\n" for line in lines))
    return root


def _record(block: int, start: float, end: float, worker: int = 0, rss: float = 3e8) -> dict:
    made = {"ok": 4, "rejected": 1, "failed": 0}
    return {"block": block, "start": start, "end": end, "worker": worker, "host": "a", "pid": worker, "rss": rss} | made


def test_a_run_half_way_has_a_page_and_a_whole_one_the_same_scenes(half_way, tmp_path):
    text = write_report(half_way, tmp_path / "early.html").read_text()
    assert "still being made" in text and text.count("<figure data-kind=") == COUNT - 1
    assert "Scenes a second" in text and "too small" in text
    assert not re.search(r'(src|href)="(?!data:)', text) and "default-src 'none'" in text
    before = gather(Folder(half_way))
    pack(Folder(half_way), make_small(tmp_path / "other", COUNT))
    after = gather(Folder(half_way))
    assert before.plans == after.plans and before.relations == after.relations and after.read == COUNT - 1
    assert all(np.array_equal(before.heat[name], cells) for name, cells in after.heat.items())
    assert "still being made" not in write_report(half_way).read_text()


def test_many_processes_gather_what_one_does(tmp_path, monkeypatch):
    folder = Folder(tmp_path)
    pack(folder, make_small(tmp_path, COUNT))
    monkeypatch.setattr(collect, "_TOGETHER", 2)
    one = gather(folder, pictures=4)
    monkeypatch.setattr(collect, "MANY", 2)
    two = gather(folder, pictures=4, workers=2)
    assert len(one.plans) == len(one.wall) == 4 and one.read == two.read == COUNT
    for name in ("numbers", "wall", "pairs", "together", "present", "relations", "shells", "palettes", "plans"):
        assert getattr(two, name) == getattr(one, name), name
    assert one.heat and all(np.array_equal(two.heat[name], cells) for name, cells in one.heat.items())


def test_nothing_made_is_said(tmp_path):
    create(Folder(tmp_path), small_spec(2), "cpu", {"spec.yaml": b""})
    with pytest.raises(InputError, match="nothing is made yet"):
        write_report(tmp_path)


def test_a_plan_has_its_objects_where_they_stand():
    scene = sw.Scene.example("bedroom")
    bed = scene.object("bed")
    drawn = plan(scene.to_json())
    corners = {
        (round(100 * (bed.pose.position[0] + x)), round(-100 * (bed.pose.position[1] + y)))
        for x, y in (_turn(p, bed.pose.yaw) for part in bed.solids for p in part.polygon)
    }
    paths = [
        {(int(x), int(y)) for x, y in re.findall(r"(-?\d+) (-?\d+)", path)}
        for path in re.findall(r"<path d='([^']*)' fill='#\w+' stroke", drawn)
    ]
    assert any(path and path <= corners for path in paths)
    assert len(drawn) < 20_000


def _turn(point, yaw: float) -> tuple[float, float]:
    x, y = point
    return x * math.cos(yaw) - y * math.sin(yaw), x * math.sin(yaw) + y * math.cos(yaw)


@pytest.mark.parametrize("wall", range(4))
def test_every_room_is_turned_for_its_door_to_be_below(wall):
    room = sw.Room.rectangle(5, 3).with_door(wall, at=0.5)
    door, turn = room.doors[0], turn_of(room.model_dump())
    start, end = np.array(room.outline[door.wall]), np.array(room.outline[(door.wall + 1) % 4])
    along = (end - start) / np.linalg.norm(end - start)
    middle = turned((start + along * (door.offset + door.width / 2)).tolist(), turn)
    corners = [turned(p, turn) for p in room.outline]
    assert middle[1] == pytest.approx(min(y for _, y in corners))


def test_things_at_a_wall_are_at_the_edge_of_the_heat_map(half_way):
    found = gather(Folder(half_way))
    assert all(cells.shape == (CELLS, CELLS) and cells.sum() >= 1 for cells in found.heat.values())
    assert found.present and max(found.present.values()) <= found.read
    assert all(count <= min(found.present[a], found.present[b]) for (a, b), count in found.together.items())


def test_shells_are_the_same_however_they_lie():
    outline = [(0, 0), (4, 0), (4, 2), (2, 2), (2, 3), (0, 3)]
    moved = [(y + 7, -x) for x, y in outline]  # turned clockwise
    assert shell_signature(outline) == shell_signature(moved[2:] + moved[:2])
    assert shell_signature(outline) != shell_signature([(0, 0), (4, 0), (4, 2), (2, 2), (2, 3.2), (0, 3.2)])


def test_every_kind_of_room_takes_its_turn_on_the_wall():
    sampler = Sampler()
    kinds = {"office": 2000, "kitchen": 30, "bedroom": 1000}
    rows = [
        {"status": "ok", "key": f"{kind}{k:05d}", "room_type": kind, "near_duplicate_group": k}
        for kind, count in kinds.items()
        for k in range(count)
    ]
    assert sum(1 for _ in sampler.watch(iter(rows))) == len(rows)
    wall = sampler.wall()
    counts = {kind: sum(row["room_type"] == kind for row in wall.values()) for kind in kinds}
    assert len(wall) == PICTURES and counts == {"office": 185, "kitchen": 30, "bedroom": 185}
    places = [int(key[-5:]) for key, row in wall.items() if row["room_type"] == "office"]
    assert 800 < np.mean(places) < 1200  # spread over the set
    assert len(sampler.pairs) == 8 and all(a != b for a, b in sampler.pairs)


def test_throughput_counts_every_scene_and_memory_every_worker():
    records = [_record(k, 3.0 * k, 3.0 * k + 7.0, worker=k % 3, rss=1e8 * (k + 1)) for k in range(12)]
    _, line = throughput(records)
    width = (line[1][0] - line[0][0]) * 60
    assert sum(rate for _, rate in line) * width == pytest.approx(12 * 4)
    lines = memory(records)
    assert [name for name, _ in lines] == [f"worker {k} on a" for k in range(3)]
    assert lines[0][1] == [(5, 100.0), (10, 400.0), (15, 700.0), (20, 1000.0)]
    assert memory_svg(records).startswith("<svg xmlns=") and memory_svg([]) == ""


def test_charts_hold_their_ends():
    spread = Spread(0.0, 10.0, 10)
    for value in (2.5, 2.6, 12.0):
        spread.add(value)
    drawn = histogram(spread.result())
    assert drawn.count("<rect") == 2 and ">10+<" in drawn
    assert [nice(step) for step in (0.3, 1.0, 12.0, 0.0)] == [0.5, 1.0, 20.0, 1.0]


@pytest.mark.slow
@pytest.mark.skipif(BINARY is None, reason="no browser")
def test_the_filter_shows_what_fits(half_way, tmp_path):
    path = write_report(half_way, tmp_path / "page.html")
    with Browser() as page:
        page.open(path.as_uri())
        shown = "document.querySelectorAll('#wall > figure:not([hidden])').length"
        assert page.js(shown) == COUNT - 1
        page.js("f = document.getElementById('filter'); f.kind.value = 'bedroom'; f.dispatchEvent(new Event('input'))")
        kinds = page.js("[...document.querySelectorAll('#wall > figure:not([hidden])')].map(f => f.dataset.kind)")
        assert set(kinds) == {"bedroom"} and len(kinds) < COUNT - 1
        page.js("f.kind.value = ''; f.grade.value = 9; f.dispatchEvent(new Event('input'))")
        assert page.js(shown) == 0 and page.js("document.getElementById('count').textContent") == "0 of 5 plans"
        assert page.logs == [f"request: {path.as_uri()}"]


@pytest.mark.parametrize("content", [b"", b"[", b"{}", b'{"room": 3}', b"[1]"])
def test_a_damaged_scene_is_named_in_one_line(content):
    with pytest.raises(InputError, match="^00000001: its scene.json is damaged .*; see: sceneweaver dataset verify"):
        collect._look_at(collect.Gathered({}, {}, []), [(0, ("00000001", content))], 1, {"00000001"})
