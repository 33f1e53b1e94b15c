"""Repair of a whole data set: scenes one after another, resumed after an interruption with the same bytes."""

from __future__ import annotations

import io
import json
import re
import time
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Future
from contextlib import nullcontext
from dataclasses import asdict, dataclass
from itertools import chain, islice
from pathlib import Path

from sceneweaver.io import InputError, load_json, locked, write_atomic
from sceneweaver.runtime.processes import pool
from sceneweaver.scene import Scene

from .rows import Row, object_rows, scene_row, summary
from .run import repair_many

CHUNK = 32
"""Scenes that are repaired in shared launches, and the step of a resumed run."""

SETTINGS, SHARDS, SCENES = "settings.json", "shards", "scenes"
REPORT, TABLES = "repair.json", ("scenes", "objects")

_ID = re.compile(r"[^\w.-]+")


@dataclass(frozen=True)
class Given:
    """A scene to repair: its name in files, the scene with what it should keep, and columns about where it is from.

    ``added`` relations of the scene, at its end, take part in the repair and are not written.
    """

    name: str
    scene: Scene
    about: Row
    added: int = 0


@dataclass(frozen=True)
class Choice:
    """How scenes of a data set are repaired; arguments of `repair_many`."""

    relations: bool = True
    soft: bool = True
    drop: bool = False
    candidates: int | None = None
    seed: int = 0
    device: str = "auto"
    explain: bool = True


@dataclass(frozen=True)
class Streamed:
    """What became of a data set: the summary of all, the rows, seconds of work, and whether all of it is done."""

    report: Row
    scenes: list[Row]
    seconds: float
    done: bool


def repair_stream(
    given: Iterable[Given],
    out: Path,
    choice: Choice,
    *,
    source: Row,
    jobs: int = 1,
    stop: Callable[[], bool] = lambda: False,
    told: Callable[[int, int], None] = lambda scenes, valid: None,
) -> Streamed:
    """Repair scenes into a folder: ``scenes/<name>.json``, ``scenes.parquet``, ``objects.parquet``, ``repair.json``.

    Scenes go in chunks of `CHUNK`; what a chunk gives depends on its scenes and ``choice`` alone. A chunk that is done
    leaves a shard, and the same call goes on after those that are there. With a CPU and equal arguments the files are
    the same, byte by byte, however often it was interrupted and however many jobs there are.

    Args:
        given: the scenes, the same and in the same order each time.
        out: the folder.
        choice: how to repair.
        source: what names the data set; a folder of another one, or with another choice, is refused.
        jobs: processes.
        stop: asked between chunks whether to end early.
        told: called with the number of scenes done and of those that are valid, after each chunk.

    Raises:
        InputError: the folder has another run, or there is no scene.
    """
    todo = iter(given)
    first = list(islice(todo, 1))  # read before anything is written
    if not first:
        raise InputError("there is no scene to repair")
    settings = {"source": source, "choice": {k: v for k, v in asdict(choice).items() if k != "device"}, "chunk": CHUNK}
    _claim(out, settings)
    with locked(out / SETTINGS, f"--out: {out}"):
        shards: list[Path] = []
        count = valid = 0
        for shard in _chunks(chain(first, todo), out, choice, jobs, stop):
            shards.append(shard)
            rows = load_json(shard)["scenes"]
            count, valid = count + len(rows), valid + sum(row["valid_after"] for row in rows)
            told(count, valid)
        read = [load_json(shard) for shard in shards]
        scenes, objects = ([row for part in read for row in part[name]] for name in TABLES)
        seconds = sum(load_json(shard.with_suffix(".time"))["seconds"] for shard in shards)
        done = not stop()
        report = {"source": source, "choice": settings["choice"], **summary(scenes, objects)}
        if done:
            for name, rows in zip(TABLES, (scenes, objects), strict=True):
                _write_parquet(out / f"{name}.parquet", rows)
            invalid = [{k: row[k] for k in INVALID} for row in scenes if not row["valid_after"] or row["taken_out"]]
            text = json.dumps({**report, "unmended": invalid}, ensure_ascii=False, indent=1)
            write_atomic(out / REPORT, text + "\n")
    return Streamed(report, scenes, seconds, done)


INVALID = ("scene", "valid_after", "proved_infeasible", "taken_out", "explanation")


def _claim(out: Path, settings: Row) -> None:
    """Make the folder this run's own."""
    out.mkdir(parents=True, exist_ok=True)
    if (out / SETTINGS).exists():
        if load_json(out / SETTINGS) != json.loads(json.dumps(settings)):
            raise InputError(
                f"--out: {out} has the repair of another source or with other options; choose another folder"
            )
        return
    if any(out.iterdir()):
        raise InputError(f"--out: {out} is not empty; choose another folder")
    write_atomic(out / SETTINGS, json.dumps(settings, ensure_ascii=False, indent=1) + "\n")


def _chunks(given: Iterable[Given], out: Path, choice: Choice, jobs: int, stop: Callable[[], bool]) -> Iterator[Path]:
    """The shards of all chunks in order, made where they are not there yet."""
    for folder in (SHARDS, SCENES):
        (out / folder).mkdir(exist_ok=True)
    todo = iter(given)
    waiting: deque[tuple[Path, Future[tuple[Row, list[tuple[str, str]]]] | None]] = deque()
    with pool(jobs) if jobs > 1 else nullcontext() as processes:
        number = 0
        while True:
            chunk = list(islice(todo, CHUNK)) if not stop() else []
            if chunk:
                shard = out / SHARDS / f"{number:06d}.json"
                number += 1
                if shard.exists():
                    waiting.append((shard, None))
                elif processes is None:
                    _keep(out, shard, mended(chunk, choice))
                    waiting.append((shard, None))
                else:
                    waiting.append((shard, processes.submit(mended, chunk, choice)))
            while waiting and (not chunk or len(waiting) > 2 * jobs or processes is None):
                shard, future = waiting.popleft()
                if future is not None:
                    _keep(out, shard, future.result())
                yield shard
            if not chunk:
                return


def mended(chunk: Sequence[Given], choice: Choice) -> tuple[Row, list[tuple[str, str]]]:
    """What a chunk gives: rows of both tables with the seconds it took, and the texts of its scenes by name."""
    began = time.monotonic()
    done = repair_many([each.scene for each in chunk], **asdict(choice))
    rows: Row = {"scenes": [], "objects": []}
    texts = []
    for each, repair in zip(chunk, done, strict=True):
        rows["scenes"].append(scene_row(each.name, repair, each.about))
        rows["objects"] += object_rows(each.name, repair)
        texts.append((each.name, _text(each, repair.scene)))
    return {**rows, "seconds": time.monotonic() - began}, texts


def _text(given: Given, scene: Scene) -> str:
    """The repaired scene as JSON, without the relations that were added to it."""
    added = given.scene.relations[len(given.scene.relations) - given.added :]
    kept = tuple(r for r in scene.relations if not any(r is other for other in added))
    return scene.model_copy(update={"relations": kept}).dumps() if given.added else scene.dumps()


def _keep(out: Path, shard: Path, found: tuple[Row, list[tuple[str, str]]]) -> None:
    """Write the scenes of a chunk, then its shard, which says that it is done."""
    rows, texts = found
    for name, text in texts:
        write_atomic(out / SCENES / f"{name}.json", text)
    write_atomic(shard.with_suffix(".time"), json.dumps({"seconds": rows.pop("seconds")}))
    write_atomic(shard, json.dumps(rows, ensure_ascii=False))


def _write_parquet(path: Path, rows: Sequence[Row]) -> None:
    import pyarrow as pa
    import pyarrow.parquet as pq

    names = list(rows[0]) if rows else []
    columns = {name: [row[name] for row in rows] for name in names}
    types = {"taken_out": pa.list_(pa.string()), "notes": pa.list_(pa.string()), "explanation": pa.string()}
    arrays = {
        name: pa.array(values, types[name] if isinstance(values[0], list) or name == "explanation" else None)
        for name, values in columns.items()
    }
    buffer = io.BytesIO()
    pq.write_table(pa.table(arrays), buffer, compression="zstd")
    write_atomic(path, buffer.getvalue())


def file_name(text: str) -> str:
    """A name of files out of the id of a scene."""
    return _ID.sub("-", text).strip(".-")[:120] or "scene"
