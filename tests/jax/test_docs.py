"""The examples of docs/research.md run, in their order."""

from __future__ import annotations

import jax
import numpy as np

from tests.test_repository import ROOT, code_blocks


def test_the_examples_run():
    blocks = code_blocks((ROOT / "docs" / "research.md").read_text(), "python")
    ours = [block for block in blocks if "torch" not in block]
    names: dict = {}
    for number, block in enumerate(ours):
        exec(compile(block, f"<example {number} in research.md>", "exec"), names)
    assert len(ours) == len(blocks) - 1 == 6
    assert names["jacobian"].shape == (names["problem"].items, names["problem"].objects, 4)
    assert names["solution"].poses.shape[0] == 64 and np.isfinite(names["slope"]).all()
    poses = names["poses"][:4]
    assert (names["adam"](names["problem"], poses, jax.random.key(1), steps=20) != poses).any()
