"""Infinigen's asset generators, run by ``infinigen_worker.py`` in an environment of their own and brought into a store.

Infinigen: A. Raistrick et al., "Infinigen Indoors: Photorealistic Indoor Scenes using Procedural Generation" (2024).
One process a generator: what crashes or hangs is reported and skipped, and the rest goes on.
"""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from sceneweaver.io.messages import suggest
from sceneweaver.scene import InputError, MissingDependencyError

from ..asset import Asset
from ..imports.hints import Hints
from ..imports.prepare import content_hash, prepare
from ..store import Store

WORKER = Path(__file__).with_name("infinigen_worker.py")

# Category of ours: module under infinigen.assets.objects, and factory.
GENERATORS: dict[str, tuple[str, str]] = {
    "office_chair": ("seating", "OfficeChairFactory"),
    "chair": ("seating", "ChairFactory"),
    "bar_stool": ("seating", "BarChairFactory"),
    "sofa": ("seating", "SofaFactory"),
    "armchair": ("seating", "ArmChairFactory"),
    "bed": ("seating", "BedFactory"),
    "desk": ("shelves", "SimpleDeskFactory"),
    "bookcase": ("shelves", "SimpleBookcaseFactory"),
    "cabinet": ("shelves", "SingleCabinetFactory"),
    "cube_shelf": ("shelves", "CellShelfFactory"),
    "tv_stand": ("shelves", "TVStandFactory"),
    "kitchen_cabinet": ("shelves", "KitchenCabinetFactory"),
    "dining_table": ("tables", "TableDiningFactory"),
    "coffee_table": ("tables", "CoffeeTableFactory"),
    "side_table": ("tables", "SideTableFactory"),
    "table_lamp": ("lamp", "DeskLampFactory"),
    "floor_lamp": ("lamp", "FloorLampFactory"),
    "tv": ("appliances", "TVFactory"),
    "monitor": ("appliances", "MonitorFactory"),
    "microwave": ("appliances", "MicrowaveFactory"),
    "dishwasher": ("appliances", "DishwasherFactory"),
    "stove": ("appliances", "OvenFactory"),
    "toilet": ("bathroom", "ToiletFactory"),
    "bathtub": ("bathroom", "BathtubFactory"),
    "pedestal_sink": ("bathroom", "StandingSinkFactory"),
    "wall_mirror": ("wall_decorations", "MirrorFactory"),
    "picture": ("wall_decorations", "WallArtFactory"),
    "mug": ("tableware", "CupFactory"),
    "plate": ("tableware", "PlateFactory"),
    "bowl": ("tableware", "BowlFactory"),
    "potted_plant": ("tableware", "LargePlantContainerFactory"),
}

COMMON = ("office_chair", "desk", "dining_table", "bookcase", "sofa", "tv", "floor_lamp", "toilet")


@dataclass(frozen=True)
class GenerationResult:
    """What came of one generator: the asset, or the reason why there is none."""

    category: str
    seed: int
    asset: Asset | None
    reason: str
    seconds: float


def generate(
    categories: Sequence[str],
    seeds: Sequence[int],
    store: Store,
    *,
    seconds: float = 300.0,
    setup_seconds: float = 1800.0,
    worker: Path = WORKER,
) -> Iterator[GenerationResult]:
    """Run generators and keep what they make; one outcome for each category and seed, in order.

    The environment is made first (once: uv keeps it), within ``setup_seconds``; each generator has ``seconds``.

    Raises:
        InputError: for a category without a generator.
        MissingDependencyError: without uv, or when the environment cannot be made.
    """
    for category in categories:
        if category not in GENERATORS:
            raise InputError(f"infinigen: '{category}' has no generator{suggest(category, GENERATORS)}")
    uv = _uv()
    _set_up(uv, worker, setup_seconds)
    for category in categories:
        for seed in seeds:
            yield _one(uv, worker, category, seed, store, seconds)


def _uv() -> str:
    """The uv command: $UV, on the path, beside this interpreter, or in the checkout's .uv folder."""
    places = [
        os.environ.get("UV"),
        shutil.which("uv"),
        str(Path(sys.prefix, "bin", "uv")),
        str(Path(sys.prefix).parent / ".uv" / "bin" / "uv"),
    ]
    for place in places:
        if place and Path(place).is_file():
            return place
    raise MissingDependencyError("infinigen runs in an environment that uv makes; install it with: pip install uv")


def _set_up(uv: str, worker: Path, seconds: float) -> None:
    code, text = _run([uv, "sync", "--quiet", "--script", str(worker)], seconds)
    if code != 0:
        why = f"not ready within {seconds:g} s" if code is None else text
        raise MissingDependencyError(f"infinigen: its environment could not be made ({why})")


def _one(uv: str, worker: Path, category: str, seed: int, store: Store, seconds: float) -> GenerationResult:
    import time

    start = time.perf_counter()
    module, factory = GENERATORS[category]
    with tempfile.TemporaryDirectory(prefix="sceneweaver-") as folder:
        out = Path(folder, f"{category}.npz")
        command = [uv, "run", "--quiet", "--script", str(worker), module, factory, str(seed), str(out)]
        code, text = _run(command, seconds)
        asset, reason = None, ""
        if code is None:
            reason = f"not done within {seconds:g} s"
        elif code != 0 or not out.exists():
            reason = text or f"ended with code {code}"
        else:
            hints = Hints(
                path=out,
                name=f"{category}-{seed}",
                category=category,
                up="z",
                front="x",
                metres=1.0,
                source="infinigen",
                licence="BSD-3-Clause",
                attribution="Infinigen",
            )
            try:
                asset = prepare(hints, cache=store.cache, seconds=seconds)
                store.add(asset, content_hash(asset))
            except InputError as error:
                asset, reason = None, str(error)
    return GenerationResult(category, seed, asset, reason, time.perf_counter() - start)


def _run(command: list[str], seconds: float) -> tuple[int | None, str]:
    """Exit code (None after the time limit, when all processes have been ended) and the last line of stderr."""
    environment = {k: v for k, v in os.environ.items() if k not in ("PYTHONPATH", "VIRTUAL_ENV", "PYTHONHOME")}
    process = subprocess.Popen(
        command,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        env=environment,
        start_new_session=True,
    )
    try:
        _, stderr = process.communicate(timeout=seconds)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.communicate()
        return None, ""
    except BaseException:
        os.killpg(process.pid, signal.SIGKILL)
        raise
    lines = stderr.decode(errors="replace").strip().splitlines()
    return process.returncode, " ".join(lines[-1].split())[:200] if lines else ""
