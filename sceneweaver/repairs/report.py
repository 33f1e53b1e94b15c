"""What a repair did: the judge before and after, who moved, and what could not be mended."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass
from typing import Any

from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.geometry.rotations import tilt_of
from sceneweaver.scene import Relation, Scene
from sceneweaver.verify import Report, Violation

from .upright import UPRIGHT


@dataclass(frozen=True)
class Move:
    """How far an object went: in the plane [m], upwards [m], and turned counter-clockwise [degrees]."""

    id: str
    distance: float
    rise: float
    turn: float


@dataclass(frozen=True)
class Repair:
    """A repaired scene with its report.

    Attributes:
        source: the scene as it was.
        scene: the scene after the repair; the very same when there was nothing to do.
        before, after: the judge on both, with all relations taken for soft when they were not asked for.
        moves: the objects that moved, in the scene's order.
        notes: what the engine cannot represent and so left as it was.
        explanation: why nothing valid was found with all objects; None otherwise.
        proof: the same where it is proved, by arithmetic; None where it was searched for, or nothing is to explain.
        taken_out: the objects that were taken out so that the rest is valid; only where that was allowed.
        held: the soft relations that held before, where they were to go on holding.
        lost: those of them that do not hold any more.
        nearly: the soft relations that were missed by 30 cm at most, where soft ones count.
        unmended: those of them that are missed still.
        seed, device: of the run; the device is None when nothing had to be solved.
        seconds: from call to return.
        timed_out: True when the time limit cut the run off.

    Examples:
        >>> import sceneweaver as sw
        >>> repaired = sw.repair_report(sw.Scene.example("bedroom"))
        >>> repaired.valid, repaired.moves, repaired.device  # it was in order already
        (True, (), None)
    """

    source: Scene
    scene: Scene
    before: Report
    after: Report
    moves: tuple[Move, ...]
    notes: tuple[str, ...]
    explanation: str | None
    seed: int
    device: str | None
    seconds: float
    timed_out: bool = False
    proof: str | None = None
    taken_out: tuple[str, ...] = ()
    held: tuple[Relation, ...] = ()
    lost: tuple[Relation, ...] = ()
    nearly: tuple[Relation, ...] = ()
    unmended: tuple[Relation, ...] = ()

    @property
    def valid(self) -> bool:
        """Whether the judge calls the repaired scene valid."""
        return self.after.valid

    @property
    def unmet(self) -> tuple[Violation, ...]:
        """What still makes the scene invalid."""
        return tuple(v for v in self.after.violations if v.hard)

    def to_dict(self) -> dict[str, Any]:
        """Plain JSON data; scenes are left out."""
        return {
            "valid": self.valid,
            "moved": [asdict(m) for m in self.moves],
            "notes": list(self.notes),
            "explanation": self.explanation,
            "seed": self.seed,
            "device": self.device,
            "seconds": self.seconds,
            "timed_out": self.timed_out,
            "proved": self.proof is not None,
            "taken_out": list(self.taken_out),
            "soft_relations": {
                "held": len(self.held),
                "lost": [_named(r) for r in self.lost],
                "nearly": len(self.nearly),
                "unmended": [_named(r) for r in self.unmended],
            },
            "before": self.before.to_dict(),
            "metrics": self.after.to_dict(),
        }


def _named(relation: Relation) -> dict[str, Any]:
    return relation.model_dump(mode="json", exclude_defaults=True)


def moves_between(before: Scene, after: Scene) -> tuple[Move, ...]:
    """Who moved, of the objects that two scenes have in common."""
    moves, known = [], {o.id: o for o in before.objects}
    for b in after.objects:
        a = known.get(b.id, b)
        if a.pose != b.pose:
            (x, y, z), (u, v, w) = a.pose.position, b.pose.position
            turn = math.degrees(wrap_angle(b.pose.yaw - a.pose.yaw))
            moves.append(Move(a.id, math.hypot(u - x, v - y), w - z, turn))
    return tuple(moves)


def notes_on(scene: Scene) -> tuple[str, ...]:
    """What a repair leaves as it is, because poses are x, y, z and yaw and nothing is added or taken away."""
    notes = [
        f"{o.id} leans by {math.degrees(tilt_of(o.pose.quaternion)):.1f} degrees and keeps that; "
        "a repair moves and turns, but does not set upright"
        for o in scene.objects
        if tilt_of(o.pose.quaternion) > UPRIGHT
    ]
    if scene.dropped:
        names = ", ".join(d.id for d in scene.dropped)
        notes.append(f"{names}: listed as dropped and not brought back by a repair")
    return tuple(notes)
