"""Collects the best scenes of a folder of runs into a library that `init_library` begins with.

``python -m benchmarks.library_scenes RUNS --to FOLDER``
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from sceneweaver.io import parse_json, read_bytes, write_atomic
from sceneweaver.knowledge.library import INDEX, card_of, own_folder
from sceneweaver.scene import InputError, Scene

DIGITS = 6
"""Decimals of numbers in library files."""


def collect(runs: str | Path, to: str | Path, least: float = 0.0, each: int = 3, unjudged: bool = False) -> list[str]:
    """Copy the best valid scenes of a folder of runs into a library folder, and write its index.

    Args:
        runs: a folder with scene.json files anywhere in it; metrics.json beside one says whether it is valid.
        to: the library folder.
        least: mean grade of the critic that a scene must have.
        each: scenes of each kind of room at most.
        unjudged: whether scenes without metrics are taken as well.

    Returns:
        The names of the scenes.
    """
    rows: list[tuple[float, str, Scene]] = []
    for file in sorted(Path(runs).rglob("scene.json")):
        if "steps" in file.relative_to(runs).parts:
            continue  # a step on the way, not a result
        metrics = _metrics(file.with_name("metrics.json"))
        if metrics is None and not unjudged or metrics is not None and not metrics.get("valid"):
            continue
        numbers = [v for v in ((metrics or {}).get("scores") or {}).values() if isinstance(v, int | float)]
        grade = sum(numbers) / len(numbers) if numbers else 0.0
        if grade >= least:
            rows.append((grade, str(file), Scene.load(file)))
    rows.sort(key=lambda row: (-row[0], row[1]))
    taken: Counter[str] = Counter()
    place, cards = Path(to), []
    place.mkdir(parents=True, exist_ok=True)
    for grade, _, scene in rows:
        kind = str(scene.provenance.get("room") or scene.room.type).replace(" ", "_")
        if taken[kind] == each:
            continue
        taken[kind] += 1
        name = f"{kind}-{taken[kind]}"
        data = _rounded(scene.to_json())
        Scene.from_json(data)  # it loads, or the caller learns why not
        write_atomic(place / f"{name}.json", json.dumps(data, separators=(",", ":"), ensure_ascii=False) + "\n")
        cards.append(card_of(name, data, round(grade, 2)))
    text = json.dumps([card.model_dump(mode="json") for card in cards], indent=1)
    write_atomic(place / INDEX, text + "\n")
    return [card.name for card in cards]


def _metrics(file: Path) -> dict[str, Any] | None:
    try:
        data = parse_json(read_bytes(file))
    except InputError:
        return None
    return data if isinstance(data, dict) else None


def _rounded(data: Any) -> Any:
    if isinstance(data, float):
        return round(data, DIGITS)
    if isinstance(data, Mapping):
        return {k: _rounded(v) for k, v in data.items()}
    return [_rounded(v) for v in data] if isinstance(data, list | tuple) else data


def main(arguments: Sequence[str] | None = None) -> int:
    """Collect scenes from the command line; the number of scenes is what it says."""
    import argparse
    import sys

    parser = argparse.ArgumentParser(prog="python -m benchmarks.library_scenes", description=main.__doc__)
    parser.add_argument("runs", help="folder with runs")
    parser.add_argument("--to", default=str(own_folder()), help="library folder")
    parser.add_argument("--least", type=float, default=0.0, help="least mean grade")
    parser.add_argument("--each", type=int, default=3, help="scenes of each kind of room at most")
    parser.add_argument("--unjudged", action="store_true", help="take scenes without metrics.json, too")
    given = parser.parse_args(arguments)
    names = collect(given.runs, given.to, given.least, given.each, given.unjudged)
    sys.stdout.write(f"{len(names)} scenes in {given.to}: {', '.join(names)}\n")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
