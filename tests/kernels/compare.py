"""Comparing what the kernels give with the float64 reference."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from sceneweaver.layout.compile import LayoutProblem
from sceneweaver.layout.pack import WEIGHTS
from tests.kernels import twin
from tests.kernels.harness import Energies, batch_of, run_energy

ENERGY = (1e-4, 5e-6)  # relative and absolute [m]; float32 places objects of a 10 m room to about 1e-6 m
GRADIENT = (1e-3, 1e-4)  # relative and absolute, of the norm of an object's gradient (x, y, z, yaw)
LEFT_OUT = 0.03  # share of the objects that may stand so near to a kink that there is no one gradient
JUMP = 50.0  # a slope that differs so much between two step sizes is a step in the energy itself

UNEVEN = {
    "collision": 1.3,
    "bounds": 0.7,
    "zone": 1.1,
    "opening": 0.9,
    "relation": 0.8,
    "pull": 0.3,
    "soft": 0.6,
    "knee": 0.04,
}
"""Weights that are all different, so that no two can be mistaken for each other."""


@dataclass
class Tally:
    """Objects compared, left out near kinks, and taking part in any active term; worst relative errors."""

    compared: int = 0
    left_out: int = 0
    active: int = 0
    worst_energy: float = 0.0
    worst_gradient: float = 0.0


def against(references: Sequence[twin.Reference], found: Energies, name: str = "") -> Tally:
    """Assert that energies agree with their references, object by object."""
    tally = Tally()
    for c, ref in enumerate(references):
        n = len(ref.share)
        size = np.linalg.norm(ref.gradient, axis=1)
        allowed = GRADIENT[0] * size + GRADIENT[1]
        smooth, steady = ref.rough < 0.3 * allowed, ref.rough < JUMP
        tally.compared += n
        tally.left_out += int(np.sum(~smooth))
        tally.active += int(np.sum((size > 0.0) | (ref.share > 0.0)))
        for what, mine, theirs in (("share", found.share, ref.share), ("soft", found.soft, ref.soft)):
            off = np.where(steady, np.abs(mine[c, :n] - theirs), 0.0)
            wrong = off > ENERGY[0] * np.abs(theirs) + ENERGY[1]
            assert not wrong.any(), _say(name, what, c, wrong, mine[c, :n], theirs)
            tally.worst_energy = max(tally.worst_energy, float((off / (np.abs(theirs) + 0.01)).max(initial=0.0)))
        off = np.where(smooth, np.linalg.norm(found.gradient[c, :n] - ref.gradient, axis=1), 0.0)
        assert not (off > allowed).any(), _say(name, "gradient", c, off > allowed, found.gradient[c, :n], ref.gradient)
        tally.worst_gradient = max(tally.worst_gradient, float((off / (size + 0.1)).max(initial=0.0)))
    assert tally.left_out <= LEFT_OUT * tally.compared, f"{name}: {tally.left_out} of {tally.compared} left out"
    return tally


def check(
    problems: Sequence[LayoutProblem],
    which: Sequence[int],
    layouts: Sequence[np.ndarray],
    options: Sequence[np.ndarray],
    device: str,
    weights: Mapping[str, float] | None = None,
    anchors: Sequence[np.ndarray] | None = None,
    name: str = "",
) -> Tally:
    """Run the kernel on a batch of layouts and compare it with the reference."""
    found = run_energy(batch_of(problems, which, layouts, device, options, anchors, weights))
    full = {**WEIGHTS, **(weights or {})}
    pulls = [None] * len(layouts) if anchors is None else anchors
    references = [
        twin.energy(problems[p], layout, chosen, pull, weights=full)
        for p, layout, chosen, pull in zip(which, layouts, options, pulls, strict=True)
    ]
    return against(references, found, name)


def _say(name: str, what: str, candidate: int, wrong: np.ndarray, mine: np.ndarray, theirs: np.ndarray) -> str:
    first = int(np.argmax(wrong))
    return (
        f"{name} candidate {candidate}: {what} of objects {np.flatnonzero(wrong).tolist()} is off; "
        f"object {first}: kernel {mine[first]}, reference {theirs[first]}"
    )
