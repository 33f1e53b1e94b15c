"""The examples of docs/research.md run, in their order."""

from __future__ import annotations

import numpy as np
import pytest

from tests.test_repository import ROOT, code_blocks


@pytest.mark.slow
def test_the_examples_run():
    for library in ("optax", "optimistix", "blackjax", "evosax"):
        pytest.importorskip(library)
    blocks = code_blocks((ROOT / "docs" / "research.md").read_text(), "python")
    ours = [block for block in blocks if "torch" not in block]
    names: dict = {}
    for number, block in enumerate(ours):
        exec(compile(block, f"<example {number} in research.md>", "exec"), names)
    assert len(ours) == len(blocks) - 1 > 4
    assert names["jacobian"].shape == (names["problem"].items, names["problem"].objects, 4)
    assert names["solution"].poses.shape[0] == 64 and np.isfinite(names["slope"]).all()
    problem, energy = names["problem"], lambda poses: np.asarray(names["swj"].energy(names["problem"], poses))
    poses = names["poses"][:8]
    assert energy(names["adam"](problem, poses, steps=100)).mean() < 0.5 * energy(poses).mean()
    assert (energy(names["found"]) <= energy(poses)).all() and energy(names["found"]).mean() < 0.6 * energy(
        poses
    ).mean()
    assert names["layouts"].shape == (30, problem.objects, 4) and np.ptp(energy(names["layouts"])) > 0
    assert (
        np.isfinite(energy(names["layouts"])).all() and names["strategy"].best_fitness <= energy(names["members"]).min()
    )
