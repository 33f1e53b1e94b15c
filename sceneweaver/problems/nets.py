"""Nets and flows between blocks: what a chip connects and what a factory carries, drawn without regard to a layout.

Who is tied to whom follows a hidden order of the blocks: the smaller the part of the order that a tie stays in, the
likelier it is, so that there are clusters within clusters as in circuits (Rent's rule; Landman and Russo, *IEEE
Transactions on Computers* C-20, 1971). The order has nothing to do with where the witness has the blocks.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

Json = dict[str, Any]

# Blocks, nets and pins of the circuits GSRC n10 to n200 and MCNC apte, xerox, hp, ami33, ami49: the figures that
# net counts are interpolated between. Nothing of the circuits themselves is used.
NETS = {
    "gsrc": ((10, 118), (30, 349), (50, 485), (100, 885), (200, 1585)),
    "mcnc": ((9, 97), (10, 203), (11, 83), (33, 123), (49, 408)),
}
MORE_PINS = {"gsrc": 0.08, "mcnc": 0.5}
"""The chance that a net has one more pin, above two; geometric."""
MOST_PINS = 12
WITH_PAD = 0.25
CLOSER = 0.62  # the chance that a tie stays within half of the part it is in


def members(order: np.ndarray, count: int, rng: np.random.Generator) -> list[int]:
    """So many different blocks out of one part of the hidden order."""
    part = len(order)
    while part // 2 >= max(count, 3) and rng.random() < CLOSER:
        part //= 2
    first = int(rng.integers(len(order) - part + 1))
    return [int(order[first + k]) for k in sorted(rng.choice(part, count, replace=False))]


def nets(kind: str, ids: Sequence[str], sizes: Sequence[Any], pads: Sequence[str], rng: np.random.Generator) -> Any:
    """Wire lengths of multi-pin nets of "gsrc" (pins at centres) or "mcnc" blocks (pins anywhere on blocks).

    Equal nets at centres are one with their number as its weight.
    """
    blocks, counts = zip(*NETS[kind], strict=True)
    order = rng.permutation(len(ids))
    found: dict[tuple[str, ...], Json] = {}
    for number in range(round(float(np.interp(len(ids), blocks, counts)))):
        pins = 2
        while pins < min(MOST_PINS, len(ids)) and rng.random() < MORE_PINS[kind]:
            pins += 1
        pad = [pads[int(rng.integers(len(pads)))]] if pads and rng.random() < WITH_PAD else []
        chosen = sorted(members(order, pins - len(pad), rng))
        names = (*(ids[k] for k in chosen), *pad)
        if kind == "gsrc":
            row = found.setdefault(names, {"kind": "wire_length", "objects": list(names), "weight": 0.0})
            row["weight"] += 1.0
            continue
        at = [[round(float(rng.uniform(-0.45, 0.45)) * sizes[k][a], 3) for a in (0, 1)] for k in chosen]
        params = {"pins": at + [[0.0, 0.0]] * len(pad)}
        key = (str(number),)
        found[key] = {"kind": "wire_length", "objects": list(names), "weight": 1.0, "params": params}
    return list(found.values())


def flows(ids: Sequence[str], share: float, rng: np.random.Generator) -> list[Json]:
    """Flows between pairs of blocks, whole numbers as in the problems of Nugent, Vollmann and Ruml 1968.

    ``share`` of the pairs have one, more often within a part of the hidden order.
    """
    order = rng.permutation(len(ids))
    wanted = max(round(share * len(ids) * (len(ids) - 1) / 2), len(ids) - 1)
    found: dict[tuple[int, int], int] = {}
    for k in range(len(ids) - 1):  # nothing is left without
        found[_pair(order[k], order[k + 1])] = 1 + int(rng.exponential(3.0))
    while len(found) < wanted:
        a, b = members(order, 2, rng) if rng.random() < 0.7 else rng.choice(len(ids), 2, replace=False)
        found[_pair(a, b)] = 1 + int(rng.exponential(3.0))
    return [flow(ids[a], ids[b], float(weight)) for (a, b), weight in sorted(found.items())]


def flow(one: str, other: str, weight: float) -> Json:
    """A flow between two things, along the axes."""
    return {"kind": "flow", "objects": [one, other], "weight": weight, "params": {"metric": "manhattan"}}


def _pair(a: Any, b: Any) -> tuple[int, int]:
    return (int(min(a, b)), int(max(a, b)))
