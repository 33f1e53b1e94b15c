"""Data sets that are damaged in every way at every stage: all of it has to be noticed, and made anew to the same bytes.

    python -m tests.datasets.tamper --scenes 200 --jobs 16

makes a data set, stops it before packing, while it is packed, and when it is whole. Of each stage it takes copies, and
damages one file of each kind in each way: a byte flipped, cut in half, emptied, removed, replaced by a folder, a pipe
or a link, swapped with another one, or taken from another version of the data set. Each copy is resumed (whole ones are
verified first), and all files are compared with the undisturbed data set.
"""

from __future__ import annotations

import argparse
import contextlib
import os
import random
import shutil
import sys
import tempfile
import time
from collections.abc import Callable, Iterable, Sequence
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import NamedTuple
from unittest import mock

from sceneweaver.datasets import work
from sceneweaver.datasets.checking import verify_dataset
from sceneweaver.datasets.engines import Listener, Options, begin, open_dataset, resume, run
from sceneweaver.datasets.engines.schedule import Job, Task, attempt
from sceneweaver.datasets.files import packing
from sceneweaver.datasets.store import AssetStore
from sceneweaver.datasets.store.scene_files import asset_rows
from sceneweaver.io import SceneWeaverError
from sceneweaver.runtime.processes import pool
from tests.datasets import torture

SCENES = """
schema: sceneweaver.dataset/1
name: tampered
seed: {seed}
count: {count}
block: 4
rooms: {{candidates: 8}}
exports: [glb]
captions: false
splits: {{train: 0.6, test: 0.4}}
requests:
  prompts:
  - a small storage room with one shelf
  - a storage room with two shelves and a box
  - a small study with a desk and a chair
"""
LAYOUTS = """
schema: sceneweaver.dataset/1
name: tampered
product: layouts
seed: {seed}
count: {count}
block: 2
rooms: {{candidates: 8, layouts: 8}}
splits: {{train: 0.6, test: 0.4}}
requests: {{scenes: [{zoo}/bedroom-small.json, {zoo}/living.json, {zoo}/dining-round.json, {zoo}/children-twin.json]}}
"""
pack_layouts = import_module("sceneweaver.datasets.layouts.pack")  # the package has a function of that name

ZOO = Path(__file__).parents[1] / "zoo"


class Stopped(BaseException):
    """What ends a run at some stage, as a signal would."""


class Inline:
    """An engine that makes blocks in this process."""

    def __init__(self, job: Job, devices: Sequence[str]):
        self._job, self._device = job, devices[0]

    def run(self, numbers: Iterable[int]) -> None:
        work._store.cache_clear()  # a run has processes that know nothing yet
        for number in numbers:
            kind, value = attempt(self._job.dataset, Task(number), self._device, self._job.produce, lambda: None)
            assert kind == "done", value
            self._job.listener.block({**value, "worker": 0, "host": "here", "pid": os.getpid()})


def make(
    out: Path, source: Path | None = None, *, easy: bool, pack: Callable | None = None, workers: int = 1
) -> list[str]:
    """Make or resume a data set, with one worker in this process; what was noticed."""
    notices: list[str] = []
    dataset = open_dataset(out) if source is None else begin(source, out, "cpu")
    listener = Listener(lambda record: None, notices.append)
    with contextlib.nullcontext() if workers > 1 else mock.patch.object(run, "LocalEngine", Inline):
        options = Options(workers=workers, full_check=True)
        resume(dataset, options, listener, produce=_fake if easy else None, pack=pack)
    return notices


def _fake(*args, **options):
    with mock.patch.object(torture.time, "sleep", lambda seconds: None):
        yield from torture.fake(*args, **options)


def stop(dataset: object = None) -> None:
    raise Stopped


def half_packed(dataset) -> None:
    """Pack until half of the blocks are gone."""
    calls: list[object] = []
    sync = packing.Shards.sync

    def counted(shards) -> None:
        sync(shards)
        calls.append(shards)
        if len(calls) > dataset.requests.blocks // 2:
            raise Stopped

    with mock.patch.object(packing.Shards, "sync", counted), mock.patch.object(packing, "SAFE", 0):
        work.pack(dataset.folder, dataset.requests)


def one_shard(dataset) -> None:
    """Pack until one shard is finished, and the blocks are gone."""
    finish, calls = packing.Shards._finish, []

    def counted(shards, name) -> None:
        if calls:
            raise Stopped
        finish(shards, name)
        calls.append(name)

    with mock.patch.object(packing.Shards, "_finish", counted), mock.patch.object(packing, "SAFE", 0):
        work.pack(dataset.folder, dataset.requests)


def tables_left(dataset) -> None:
    """Pack until all but checksums and texts are there."""
    place = packing if dataset.spec.product == "scenes" else pack_layouts
    with mock.patch.object(place, "finish", lambda *args: stop()):
        work.pack(dataset.folder, dataset.requests)


def planned(dataset) -> None:
    """Pack until the plan is there."""
    with mock.patch.object(pack_layouts, "_take", stop):
        work.pack(dataset.folder, dataset.requests)


STAGES = {
    "scenes": {
        "made": stop,
        "half packed": half_packed,
        "one shard": one_shard,
        "not summed": tables_left,
        "whole": None,
    },
    "layouts": {"made": stop, "planned": planned, "not summed": tables_left, "whole": None},
}
_BLOCK = "work/blocks/*/*/"
BEGUN = ("dataset.json", "spec.yaml", "work/begun.sha256")
KINDS = {
    "made": (
        *BEGUN,
        *(_BLOCK + name for name in ("samples.tar", "layouts-0.parquet", "rows.jsonl", "seconds.jsonl", "seal.sha256")),
    ),
    "half packed": (_BLOCK + "samples.tar", _BLOCK + "seal.sha256", "work/plan/*.parquet", "work/plan/*.tar"),
    "one shard": ("data/*", "work/plan/*.tar", "work/plan/index.parquet", "work/plan/seal.sha256"),
    "planned": ("work/plan/data/*", "work/plan/*.parquet", "work/plan/seal.sha256", _BLOCK + "layouts-0.parquet"),
    "not summed": ("data/*", "meta/index.parquet", "meta/programs.parquet", "work/plan/seal.sha256"),
    "whole": (
        *BEGUN,
        "data/*",
        "meta/index.parquet",
        "meta/programs.parquet",
        "meta/assets.parquet",
        "meta/statistics.json",
    )
    + ("meta/seconds.parquet", "README.md", "LICENSES.md", "croissant.json", "checksums.sha256", "work/packed")
    + ("inputs/*",),
}
RECORDS = "work/assets/*.jsonl"
STORE = ("assets/*/*", RECORDS)
"""The store of assets, at any stage of scenes."""

STATED = ("file", "manifest", "checksum", "index", "shard", "content")
"""Checks of files and tables, as opposed to those of scenes."""

UNTRUSTED = (
    "work/plan/*.tar",
    "work/records/*.jsonl",
    "work/journal/*.journal",
    "work/journal/*/*.journal",
    "work/complete",
)
"""What no byte depends on, so that it need not be noticed: of the beginning of a shard, what is as planned counts."""

WAYS = ("flip", "cut", "empty", "gone", "folder", "pipe", "link", "swap", "older")


class Case(NamedTuple):
    """A kind of file of a stage, damaged in a way, and what came of it; ``needed`` is false where no byte depends on
    what was damaged, so that it need not be noticed."""

    stage: str
    kind: str
    way: str
    needed: bool = True
    noticed: bool = False
    equal: bool = False
    detail: str = ""


def damage(path: Path, way: str, other: Path | None, older: Path, aside: Path, rng: random.Random) -> bool:
    """Damage a file; whether it can be damaged in this way."""
    content = path.read_bytes()
    if way == "flip":
        if not content:
            return False
        place = rng.randrange(len(content))
        path.write_bytes(content[:place] + bytes([content[place] ^ (1 << rng.randrange(8))]) + content[place + 1 :])
    elif way in ("cut", "empty"):
        if not content:
            return False
        path.write_bytes(content[: len(content) // 2] if way == "cut" else b"")
    elif way == "swap":
        if other is None or other.read_bytes() == content:
            return False
        path.write_bytes(other.read_bytes())
        other.write_bytes(content)
    elif way == "older":
        if not older.is_file() or older.read_bytes() == content:
            return False
        path.write_bytes(older.read_bytes())
    else:
        path.unlink()
        if way == "folder":
            path.mkdir()
        elif way == "pipe":
            os.mkfifo(path)
        elif way == "link":
            aside.write_bytes(content)  # even one to the very same content
            path.symlink_to(aside)
    return True


def tried(case: Case, stages: Path, source: Path, expected: dict[str, str], *, easy: bool, seed: int) -> Case | None:
    """Damage a copy of a stage, and make it whole again; None where that stage has no such file, or it no such way."""
    rng = random.Random(f"{seed} {case.stage} {case.kind} {case.way}")
    with tempfile.TemporaryDirectory(prefix="sw-tamper-") as scratch:
        out = Path(scratch) / "set"
        shutil.copytree(stages / case.stage, out)
        paths = sorted(path for path in out.glob(case.kind) if path.is_file())
        if not paths:
            return None
        path = rng.choice(paths)
        others = [one for one in paths if one != path and one.read_bytes() != path.read_bytes()]
        older = stages / f"older {case.stage}" / path.relative_to(out)
        known = records_needed(case, out)
        if not damage(path, case.way, rng.choice(others) if others else None, older, Path(scratch) / "aside", rng):
            return None
        needed = case.kind not in UNTRUSTED and (case.kind != RECORDS or records_needed(case, out) != known)
        said: list[str] = []
        if case.stage == "whole":
            with noted(said, "verify: "):
                said += verified(out)
            if not (said or case.kind.startswith("work/")):
                said.append("BUT verify says nothing")
        with noted(said, "resume: "):
            said += make(out, easy=easy)
        if any(line.startswith("resume: ") for line in said):  # with its specification, as the line says
            with noted(said, "make: "):
                said += make(out, source, easy=easy)
        wrong = torture.differing(expected, torture.content(out))
        noticed = bool(said) and not any(line.startswith("BUT") for line in said)
        detail = f"{path.relative_to(out)}: {'; '.join(said)[:300] or 'nothing said'}"
        return case._replace(
            needed=needed, noticed=noticed, equal=not wrong, detail=detail + f"; DIFFERS in {wrong[:4]}" * bool(wrong)
        )


def records_needed(case: Case, out: Path) -> list[dict]:
    """What packing needs of the records of assets: each process writes those that it meets, so that many are told more
    than once; from its plan on, packing needs none."""
    return asset_rows(AssetStore(out)) if case.stage == "made" and case.kind == RECORDS else []


def verified(out: Path) -> list[str]:
    """The faults of files and tables that verification finds; scenes that cost nothing are not as they are judged."""
    found = verify_dataset(out, sample=1)
    for name in ("verification.json", "verification.md"):
        (out / name).unlink()
    return [f"{fault['key']}: {fault['detail']}" for fault in found.data["first"] if fault["check"] in STATED]


@contextlib.contextmanager
def noted(said: list[str], who: str):
    """A refusal is a line; any other error ends the run."""
    try:
        yield
    except SceneWeaverError as error:
        assert "\n" not in str(error)
        said.append(f"{who}{error}")


def cases(product: str) -> list[Case]:
    """All kinds of files of all stages, in all ways."""
    return [
        Case(stage, kind, way)
        for stage in STAGES[product]
        for kind in (*KINDS[stage], *(STORE if product == "scenes" else ()), *UNTRUSTED)
        for way in WAYS
    ]


def make_stages(place: Path, product: str, scenes: int, *, easy: bool, workers: int = 1) -> Path:
    """A data set at all its stages, and another version of it; the specification."""
    text = SCENES if product == "scenes" else LAYOUTS
    for name, seed in (("", 0), ("older ", 1)):
        source = place / f"{name}spec.yaml"
        source.write_text(text.format(seed=seed, count=scenes, zoo=ZOO))
        first = True
        for stage, pack in STAGES[product].items():
            out = place / f"{name}{stage}"
            if not first:
                shutil.copytree(place / f"{name}made", out)
            with contextlib.suppress(Stopped):
                make(out, source, easy=easy, pack=pack, workers=workers if first else 1)
            first = False
    return place / "spec.yaml"


def main(argv: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--scenes", type=int, default=12)
    parser.add_argument("--product", choices=list(STAGES), default="scenes")
    parser.add_argument("--easy", action="store_true", help="scenes that cost nothing")
    parser.add_argument("--jobs", type=int, default=1, help="processes that make the data set, and try cases")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--only", default="", help="cases whose stage, kind and way have this in them")
    args = parser.parse_args(argv)
    began = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="sw-stages-") as scratch:
        place = Path(scratch)
        source = make_stages(place, args.product, args.scenes, easy=args.easy, workers=args.jobs)
        expected = torture.content(place / "whole")
        chosen = [case for case in cases(args.product) if args.only in f"{case.stage} {case.kind} {case.way}"]
        attempt_one = partial(tried, stages=place, source=source, expected=expected, easy=args.easy, seed=args.seed)
        if args.jobs > 1:
            with pool(args.jobs) as processes:
                found = [case for case in processes.map(attempt_one, chosen) if case is not None]
        else:
            found = [case for case in map(attempt_one, chosen) if case is not None]
    return report(found, time.monotonic() - began)


def report(found: list[Case], seconds: float) -> int:
    """Print a table of all cases: ok, or what is wrong; 1 when something is."""
    ways = [way for way in WAYS if any(case.way == way for case in found)]
    by_kind: dict[tuple[str, str], dict[str, str]] = {}
    bad = []
    for case in found:
        text = "ok" if case.noticed and case.equal else "-" if case.equal and not case.needed else "BAD"
        by_kind.setdefault((case.stage, case.kind), {})[case.way] = text
        if text == "BAD":
            bad.append(case)
    print(f"{'stage':12} {'file':34} " + " ".join(f"{way:6}" for way in ways))
    for (stage, kind), row in by_kind.items():
        print(f"{stage:12} {kind:34} " + " ".join(f"{row.get(way, ''):6}" for way in ways))
    for case in bad:
        print(f"{case.stage}, {case.kind}, {case.way}: noticed {case.noticed}, equal {case.equal}: {case.detail}")
    needed = [case for case in found if case.needed]
    print(
        f"{len(found)} cases in {seconds:.0f} s; of {len(needed)} that bytes depend on, noticed "
        f"{sum(case.noticed for case in needed)}; equal after repair: {sum(case.equal for case in found)}",
        flush=True,
    )
    return bool(bad)


if __name__ == "__main__":
    sys.exit(main())
