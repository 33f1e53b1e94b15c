"""Train the prior on what `python -m benchmarks prior_data` wrote; goes on where an earlier call stopped."""

from __future__ import annotations

import argparse
import json
import time
from dataclasses import replace
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.console import say
from benchmarks.prior_data import all_words, read_parts
from sceneweaver.io import read_arrays, write_atomic
from sceneweaver.prior.network import Shape, layout_of
from sceneweaver.prior.training import Recipe, State, split_rooms, tested, train, trained_names
from sceneweaver.prior.vocabulary import Words
from sceneweaver.prior.weights import save_weights

TESTED = 40
"""One in so many rooms is left out, to measure the loss in."""

SMALL = {"wide": 32, "deep": 2, "heads": 4, "slim": 32, "steps": 2, "eyes": 4}
"""A network to see that everything works."""


def main(arguments: list[str] | None = None) -> int:
    """Train for some seconds; 1 when the loss is no number."""
    p = argparse.ArgumentParser(prog="python -m benchmarks prior_train", description=__doc__)
    p.add_argument("--data", type=Path, required=True, help="the folder of prior_data")
    p.add_argument("--work", type=Path, required=True, help="a folder for the state; what is there is gone on from")
    p.add_argument("--weights", type=Path, required=True, help="the file of weights to write, again at every stage")
    p.add_argument("--seconds", type=float, default=900.0, help="of the whole training, which its schedule follows")
    p.add_argument("--steps", type=int, help="of the whole training, in place of seconds: then equal seeds agree")
    p.add_argument("--stop", type=float, help="seconds after which this call stops; default: when training is whole")
    p.add_argument("--stage", type=float, default=100.0, help="seconds between two states that are kept")
    p.add_argument("--seed", type=int, default=0)
    p.add_argument("--quick", action="store_true", help="a tiny network, to see that everything works")
    asked = p.parse_args(arguments)
    began = time.monotonic()
    data, words = trained_names(read_parts(asked.data), all_words())
    small = SMALL if asked.quick else {}
    shape = Shape(len(words.categories), len(words.kinds), len(words.relations), **small)
    sides = (words.relation("left_of"), words.relation("right_of"))
    assert None not in sides
    recipe = Recipe(sides=sides)  # pyright: ignore[reportArgumentType]
    recipe = replace(recipe, rooms=8, layouts=4, low="float32") if asked.quick else recipe
    test = np.arange(len(data["counts"])) % TESTED == 0
    measure = tested(split_rooms(data, test), shape, recipe)
    data = split_rooms(data, ~test)
    path, state = asked.work / "state.npz", None
    asked.work.mkdir(parents=True, exist_ok=True)
    if path.exists():
        state = State.of(read_arrays(path, max_bytes=2**32))
        say(f"goes on at step {state.step} after {state.seconds:.0f} s")
    size = sum(int(np.prod(s)) for s in layout_of(shape).values())
    rooms, layouts = len(data["counts"]), len(data["poses"])
    say(f"{rooms} rooms, {layouts} layouts, {len(words.categories)} categories, {size:,} weights")
    about = {
        "rooms": rooms,
        "layouts": layouts,
        "kinds": len(words.kinds),
        "valid": float(data["valid"].mean()),
        "quality": float(data["quality"].mean()),
        "median": float(data["median"].mean()),
        "weights": size,
        "seed": asked.seed,
    }
    loss, last, kept, first = float("nan"), time.monotonic(), 0, None
    losses: list[tuple[int, float]] = []
    now = None
    for now, loss, step in train(
        data, shape, recipe, seed=asked.seed, steps=asked.steps, seconds=asked.seconds, state=state
    ):
        first = first or (time.monotonic(), step)
        losses.append((step, loss))
        if not np.isfinite(loss):
            say(f"step {step}: the loss is {loss}")
            return 1
        if time.monotonic() - last >= asked.stage:
            rate = (step - first[1]) / max(time.monotonic() - first[0], 1e-9)
            stage = now()
            mean, other = np.mean([v for _, v in losses[kept:]]), measure(stage.average)
            say(f"step {step}: loss {mean:.4f}, {other:.4f} in rooms left out, {rate:.1f} steps/s")
            about |= {"loss": round(float(mean), 4), "test_loss": round(other, 4)}
            last, kept = time.monotonic(), len(losses)
            _keep(asked, path, stage, shape, words, about, losses)
        if asked.stop is not None and time.monotonic() - began >= asked.stop:
            break
    if now is not None:
        stage = now()
        mean, other = np.mean([v for _, v in losses[-8:]]), measure(stage.average)
        about |= {"loss": round(float(mean), 4), "test_loss": round(other, 4)}
        _keep(asked, path, stage, shape, words, about, losses)
        say(f"stopped at step {losses[-1][0]}: loss {mean:.4f}, {other:.4f} in rooms left out")
    return 0


def _keep(
    asked: argparse.Namespace,
    path: Path,
    state: State,
    shape: Shape,
    words: Words,
    about: dict[str, Any],
    losses: list[tuple[int, float]],
) -> None:
    """Write the state to go on from, the weights, and the losses."""
    file = BytesIO()
    np.savez(file, **state.arrays())  # pyright: ignore[reportArgumentType]
    write_atomic(path, file.getvalue())
    about |= {"steps": state.step, "seconds": round(state.seconds, 1)}
    asked.weights.parent.mkdir(parents=True, exist_ok=True)
    save_weights(asked.weights, state.average, shape, words, about)
    stride = max(1, len(losses) // 400)
    curve = [[step, round(value, 5)] for step, value in losses[::stride]]
    write_atomic(asked.weights.with_suffix(".json"), json.dumps({"about": about, "loss": curve}))


if __name__ == "__main__":
    raise SystemExit(main())
