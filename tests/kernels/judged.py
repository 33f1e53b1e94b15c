"""What the engine says about layouts beside what the judge says: nothing that the engine passes may fail."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sceneweaver.geometry.se2 import relative
from sceneweaver.layout.compile import CompiledScene
from sceneweaver.scene import Scene
from sceneweaver.verify import check
from sceneweaver.verify.relations import judge_relation
from sceneweaver.verify.solids import Placed
from tests.kernels.harness import verdict
from tests.kernels.transform import with_poses

BY_SURFACE = ("on_top", "inside")  # true by construction where surfaces are in order
NOT_ITS_DUTY = ("unsupported",)  # heights of what stands are the compiler's


@dataclass
class Counts:
    """Layouts, those valid to the engine and to the judge; relations that the judge passes, and the engine of them."""

    layouts: int = 0
    valid: int = 0
    judged_valid: int = 0
    holding: int = 0
    passed: int = 0


def engine(compiled: CompiledScene, layouts: np.ndarray, device: str) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The engine's valid [B], faults of objects with those on their surfaces [B, N], relations that hold [B, R]."""
    room = verdict(compiled.room, layouts, device)
    fault = room.fault != 0
    for domain in compiled.domains:
        local = relative(layouts[:, domain.surface.members], layouts[:, None, domain.surface.supporter])
        local[..., 2] = 0.0
        fault[:, domain.surface.members] |= verdict(domain.problem, local, device).fault != 0
    valid = (room.status == 0) & ~fault.any(axis=1) & (not compiled.room.faulty)
    holds = room.holds[:, : len(compiled.scene.relations)].copy()
    for rider, relation in compiled.room.riders.items():
        holds[:, relation] &= room.holds[:, rider]
    return valid, fault, holds


def compare(compiled: CompiledScene, layouts: np.ndarray, device: str) -> Counts:
    """Assert that the judge agrees with whatever the engine passes: layouts, objects, relations."""
    counts = Counts()
    valid, fault, holds = engine(compiled, layouts, device)
    index = {o.id: i for i, o in enumerate(compiled.scene.objects)}
    for c, layout in enumerate(layouts):
        scene = with_poses(compiled.scene, layout)
        report = check(scene, walkable=False)
        counts.layouts += 1
        counts.valid += int(valid[c])
        counts.judged_valid += int(report.valid)
        assert report.valid or not valid[c], f"{scene.id} {c}: {[v.detail for v in report.violations]}"
        for v in report.violations:
            if v.kind in ("collision", "out_of_bounds", "blocked_zone", "blocked_opening"):
                assert all(fault[c, index[o]] for o in v.objects if o in index), f"{scene.id} {c}: {v.detail}"
        _relations(scene, holds[c], counts, f"{scene.id} {c}")
    return counts


def _relations(scene: Scene, holds: np.ndarray, counts: Counts, name: str) -> None:
    placed = Placed.of(scene)
    groups = {r.target: True for r in scene.relations if r.type == "around"}  # the angle between two belongs to one
    for relation, passed in zip(scene.relations, holds, strict=True):
        if relation.type == "around":
            groups[relation.target] &= bool(passed)
    for relation, passed in zip(scene.relations, holds, strict=True):
        if relation.type == "around":
            passed = groups[relation.target]
        if relation.type not in BY_SURFACE:
            found = judge_relation(placed, relation)
            counts.holding += int(found.holds)
            counts.passed += int(passed)
            said = f"{relation.subject} {relation.type} {relation.target}"
            assert found.holds or not passed, f"{name}: {said}: {found.text}"
