"""Runs that are killed again and again, on few and many workers, by Ray: all of them have to give the same bytes.

    python -m tests.datasets.torture --scenes 200 --kills 20

makes a data set undisturbed, then one whose whole process group is killed at random moments and resumed each time, then
with other numbers of workers, as shards, and by Ray with a worker killed; it compares every file but the times.
"""

from __future__ import annotations

import argparse
import contextlib
import hashlib
import math
import os
import random
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from sceneweaver.datasets import Request, Sample
from sceneweaver.datasets.engines import Listener, Options, begin, open_dataset, resume

SPEC = """
schema: sceneweaver.dataset/1
name: torture
count: {count}
block: 4
rooms: {{candidates: 8}}
requests:
  prompts:
  - a small storage room with one shelf
  - a storage room with two shelves and a box
  - a small study with a desk and a chair
"""
TIMES = ("meta/seconds.parquet", "work/")
"""What no two runs agree on."""


def fake(spec, requests: list[Request], store, device: str = "cpu"):
    """Scenes that cost next to nothing and can be packed."""
    from tests.datasets.small import small_sample, small_scene

    for request in requests:
        time.sleep(0.02)
        asset = store.put(f"asset {request.seed % 9}".encode(), "bin")
        sample: Sample = small_sample(
            request, small_scene(request.index), columns={"assets": [asset]}, glb=asset.encode()
        )
        yield sample


def content(out: Path) -> dict[str, str]:
    """The SHA-256 of each file that has to be the same."""
    found = {}
    for path in sorted(out.rglob("*")):
        name = path.relative_to(out).as_posix()
        if path.is_file() and not name.startswith(TIMES):
            data = path.read_bytes()
            if name == "checksums.sha256":
                data = b"".join(line for line in data.splitlines(True) if TIMES[0].encode() not in line)
            found[name] = hashlib.sha256(data).hexdigest()
    return found


def command(spec: Path, out: Path, *options: str, easy: bool) -> list[str]:
    if easy:
        return [sys.executable, "-m", "tests.datasets.torture", "--make", str(spec), str(out), *options]
    return [sys.executable, "-m", "sceneweaver", "dataset", "make", str(spec), "--out", str(out), *options]


def killed(spec: Path, out: Path, kills: int, rng: random.Random, *, easy: bool) -> list[str]:
    """Make a data set with so many kills of the whole process group; where each came, by the blocks that there were.

    Each run is killed a random while after it has made another part of the work, so that all kills come before the end
    however quick or slow the machine is; the last ones come when all is made, and may find it whole.
    """
    moments: list[str] = []
    for number in range(kills):
        process = subprocess.Popen(command(spec, out, "--workers", "2", easy=easy), start_new_session=True)
        dataset = open_dataset(out) if (out / "dataset.json").exists() else None
        blocks = 0 if dataset is None else dataset.requests.blocks
        share = (number + rng.random()) / max(kills - PACKED, 1)
        aim = math.ceil(0.9 * share * blocks) if share < 1 else blocks + 1
        while process.poll() is None and _done(out, blocks) < aim:
            time.sleep(0.005)
        if process.poll() is None:
            time.sleep(rng.uniform(0.0, 0.2))
        ended = process.poll() is not None
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        moments.append(f"{_done(out, blocks)}/{blocks}{' (ended)' * ended}")
    subprocess.run(command(spec, out, "--workers", "2", easy=easy), check=True)
    return moments


PACKED = 4
"""How many of the kills come when all blocks are made."""


def _done(out: Path, blocks: int) -> int:
    """How many blocks are made; one more when packing has begun."""
    if (out / "work" / "plan").exists() or (out / "checksums.sha256").exists():
        return blocks + 1
    return sum(1 for _ in out.glob("work/blocks/*/[0-9]*"))


def by_ray(spec: Path, out: Path, *, easy: bool) -> int:
    """Make a data set by Ray, and kill one of its workers once there is a block; its process number."""
    process = subprocess.Popen(command(spec, out, "--engine", "ray", "--workers", "2", easy=easy))
    victim = 0
    while process.poll() is None:
        time.sleep(0.2)
        if not victim and list(out.glob("work/blocks/*/[0-9]*")):
            found = subprocess.run(["pgrep", "-f", "^ray::_remote"], capture_output=True, text=True).stdout.split()
            if found:
                victim = int(found[0])
                with contextlib.suppress(ProcessLookupError):
                    os.kill(victim, signal.SIGKILL)
    assert process.returncode == 0, f"exit code {process.returncode}"
    return victim


def differing(expected: dict[str, str], found: dict[str, str]) -> list[str]:
    return sorted(name for name in expected | found if expected.get(name) != found.get(name))


def main(argv: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--scenes", type=int, default=200)
    parser.add_argument("--kills", type=int, default=20)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--others", default="1,4,shards,ray", help="besides the killed run: workers, shards, ray")
    parser.add_argument("--easy", action="store_true", help="scenes that cost nothing")
    parser.add_argument("--out", type=Path, help="keep the data sets here")
    parser.add_argument("--make", nargs=2, type=Path, help=argparse.SUPPRESS)
    parser.add_argument("--workers", type=int, default=2, help=argparse.SUPPRESS)
    parser.add_argument("--engine", default="local", help=argparse.SUPPRESS)
    parser.add_argument("--shard", help=argparse.SUPPRESS)
    args = parser.parse_args(argv)
    if args.make:
        dataset = begin(args.make[0], args.make[1], "cpu")
        shard = tuple(map(int, args.shard.split("/"))) if args.shard else None
        options = Options(workers=args.workers, engine=args.engine, shard=shard)
        resume(dataset, options, Listener(lambda record: None, print), produce=fake)
        return 0
    with tempfile.TemporaryDirectory() as scratch:
        return torture(args, args.out or Path(scratch))


def torture(args: argparse.Namespace, place: Path) -> int:
    """All runs, each compared with the undisturbed one; 1 when one differs."""
    place.mkdir(parents=True, exist_ok=True)
    spec = place / "spec.yaml"
    spec.write_text(SPEC.format(count=args.scenes))
    begun, wrong = time.monotonic(), 0

    def compare(name: str, text: str) -> None:
        nonlocal wrong
        found = differing(expected, content(place / name))
        wrong += bool(found)
        print(f"{name}: {'equal' if not found else f'DIFFERS in {found[:8]}'} ({text})", flush=True)

    def run(name: str, *options: str) -> None:
        subprocess.run(command(spec, place / name, *options, easy=args.easy), check=True)

    run("undisturbed", "--workers", "2")
    seconds = time.monotonic() - begun
    expected = content(place / "undisturbed")
    print(f"undisturbed: {args.scenes} scenes, {len(expected)} files, {seconds:.0f} s", flush=True)
    moments = killed(spec, place / "killed", args.kills, random.Random(args.seed), easy=args.easy)
    hit = sum("ended" not in moment for moment in moments)
    compare("killed", f"{hit} kills before the end, at {', '.join(moments)} blocks")
    for other in filter(None, args.others.split(",")):
        if other == "ray":
            compare_text = f"worker {by_ray(spec, place / 'ray', easy=args.easy)} of Ray killed"
            compare("ray", compare_text)
        elif other == "shards":
            for shard in (2, 0, 1):
                run("shards", "--workers", "1", "--shard", f"{shard}/3")
            run("shards", "--workers", "1")
            compare("shards", "three shards, then the whole")
        else:
            run(f"{other}-workers", "--workers", other)
            compare(f"{other}-workers", "undisturbed")
    print(f"{'all equal' if not wrong else f'{wrong} differ'}, {time.monotonic() - begun:.0f} s", flush=True)
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main())
