"""``sceneweaver repair`` of folders and of files of other systems."""

from __future__ import annotations

import json

import pytest

from sceneweaver.repairs import stream
from sceneweaver.repairs.sources import given_scenes
from sceneweaver.repairs.stream import Choice, repair_stream
from sceneweaver.scene import InputError, Pose, Room, Scene
from tests.layout.made import scene, thing


def at(obj, x, y, yaw=0.0):
    return obj.model_copy(update={"pose": Pose.from_yaw(x, y, 0.0, yaw)})


def room_of(k: int) -> Scene:
    """A box in the wall, another that overlaps it; the third room has one longer than the room."""
    a, b = at(thing("a"), 0.1, 1.0 + 0.1 * k), at(thing("b"), 0.3, 1.3 + 0.1 * k, 0.1)
    more = [at(thing("whale", (9, 2, 1)), 2, 2)] if k == 2 else []
    return scene([a, b, *more], [], room=Room(outline=((0, 0), (4, 0), (4, 3), (0, 3)))).model_copy(
        update={"id": f"room-{k}"}
    )


@pytest.fixture
def folder(tmp_path):
    path = tmp_path / "in"
    path.mkdir()
    for k in range(5):
        room_of(k).save(path / f"room-{k}.json")
    (path / "notes.json").write_text('{"some": "thing"}')
    return path


def contents(out):
    """Bytes of all files that are promised to be equal, by name."""
    return {
        str(p.relative_to(out)): p.read_bytes() for p in sorted(out.rglob("*")) if p.is_file() and p.suffix != ".time"
    }


OPTIONS = ("--device", "cpu", "--candidates", 4)


def test_a_folder_gets_scenes_tables_and_a_report(run, folder, tmp_path):
    out = tmp_path / "out"
    ended = run("repair", folder, "-o", out, *OPTIONS)
    assert ended.code == 3, "one room is not valid"
    report = json.loads((out / "repair.json").read_text())
    assert report["scenes"] == 5 and report["valid_before"] == 0 and report["valid_after"] == 4
    assert report["infeasible"] == 1 and report["share_valid_of_feasible"] == 1.0
    assert [row["scene"] for row in report["unmended"]] == ["room-2"] and "whale" in report["unmended"][0][
        "explanation"
    ]
    assert report["violations_before"]["collision"] >= 5 and report["movement_moved"]["p50"] > 0
    assert "seconds" not in report
    for text in ("collisions", "out of bounds", "share valid", "80.0 %", "p50", "p90", "max", "whale", str(out)):
        assert text in ended.out
    import pyarrow.parquet as pq

    rows, objects = (pq.read_table(out / f"{name}.parquet").to_pylist() for name in ("scenes", "objects"))
    assert len(rows) == 5 and len(objects) == 11 and rows[0]["format"] == "scene"
    moved = {(row["scene"], row["object"]): row["distance"] for row in objects}
    for k in (0, 1, 3, 4):
        far = [distance for (room, _), distance in moved.items() if room == f"room-{k}"]
        assert sum(d > 1e-3 for d in far) == 1 and sum(far) < 0.4, "one of the two makes way for both"
        after = Scene.load(out / "scenes" / f"room-{k}.json")
        x, y, _ = after.object("a").pose.position
        assert moved[f"room-{k}", "a"] == pytest.approx(((x - 0.1) ** 2 + (y - 1.0 - 0.1 * k) ** 2) ** 0.5, abs=1e-9)
        assert after.relations == () and run("check", out / "scenes" / f"room-{k}.json").code == 0


def test_resume_after_a_kill_and_jobs_give_the_same_bytes(folder, tmp_path, monkeypatch):
    monkeypatch.setattr(stream, "CHUNK", 2)
    choice, source = Choice(candidates=4, device="cpu", explain=False), {"path": "in"}

    def repaired(out, **options):
        return repair_stream(given_scenes(folder), out, choice, source=source, **options)

    whole = repaired(tmp_path / "whole")
    mended, calls = stream.mended, []

    def killed(chunk, options):
        calls.append([each.name for each in chunk])
        if len(calls) == 2:
            raise KeyboardInterrupt
        return mended(chunk, options)

    monkeypatch.setattr(stream, "mended", killed)
    with pytest.raises(KeyboardInterrupt):
        repaired(tmp_path / "cut")
    assert not (tmp_path / "cut" / "repair.json").exists()
    again = repaired(tmp_path / "cut")
    assert calls == [["room-0", "room-1"], ["room-2", "room-3"], ["room-2", "room-3"], ["room-4"]]
    assert contents(tmp_path / "cut") == contents(tmp_path / "whole") and again.report == whole.report
    assert repaired(tmp_path / "cut").report == whole.report and len(calls) == 4, "nothing is done twice"
    stopped = repaired(tmp_path / "stopped", stop=lambda: len(calls) >= 5)
    assert not stopped.done and stopped.report["scenes"] == 2 and not (tmp_path / "stopped" / "repair.json").exists()


@pytest.mark.slow
def test_processes_give_the_same_bytes(run, folder, tmp_path):
    for jobs in (1, 2):
        assert run("repair", folder, "-o", tmp_path / f"out{jobs}", *OPTIONS, "--jobs", jobs).code == 3
    assert contents(tmp_path / "out1") == contents(tmp_path / "out2")


def test_another_run_is_not_overwritten(run, folder, tmp_path):
    out = tmp_path / "out"
    assert run("repair", folder, "-o", out, *OPTIONS, "--limit", 1).code == 0
    ended = run("repair", folder, "-o", out, *OPTIONS, "--limit", 1, "--seed", 1)
    assert ended.code == 2 and "--out" in ended.err and ended.err.count("\n") == 1
    (tmp_path / "full").mkdir()
    (tmp_path / "full" / "mine.txt").write_text("x")
    assert run("repair", folder, "-o", tmp_path / "full", *OPTIONS).code == 2
    assert run("repair", folder, "-o", tmp_path / "one.json", *OPTIONS).code == 2


def test_files_of_other_systems(run, tmp_path):
    from tests.importers.test_layoutgpt import entry

    path = tmp_path / "bedroom.json"
    path.write_text(json.dumps([entry(), entry(name="b")]))
    ended = run("repair", path, "-o", tmp_path / "out", *OPTIONS, "--assets", "boxes", "--json")
    assert ended.code == 0 and ended.json["scenes"] == 2 and ended.json["valid_after"] == 2
    after = Scene.load(tmp_path / "out" / "scenes" / "bedroom-b.json")
    assert len(after.objects) == 4 and ended.json["seconds"] > 0


def test_drop_of_many(run, folder, tmp_path):
    ended = run("repair", folder, "-o", tmp_path / "out", *OPTIONS, "--drop", "--json")
    assert ended.code == 0 and ended.json["taken_out"] == 1 and ended.json["valid_after"] == 5
    assert {o.id for o in Scene.load(tmp_path / "out" / "scenes" / "room-2.json").objects} == {"a", "b"}


def test_broken_files_are_told_and_passed_over(run, folder, tmp_path):
    (folder / "room-9.json").write_text('{"schema": "sceneweaver.scene/1", "id": ')
    ended = run("repair", folder, "-o", tmp_path / "out", *OPTIONS, "--json")
    assert ended.code == 3 and ended.json["scenes"] == 5
    assert len(ended.json["refused"]) == 1 and "room-9.json" in ended.err


def test_nothing_to_read_is_one_line(run, tmp_path):
    (tmp_path / "in").mkdir()
    ended = run("repair", tmp_path / "in", "-o", tmp_path / "out", *OPTIONS)
    assert ended.code == 2 and ended.err.count("\n") == 1
    with pytest.raises(InputError):
        list(given_scenes(tmp_path / "in", "scene"))
