"""Hang something on walls that the furniture left bare."""

from __future__ import annotations

from sceneweaver.generate.quantity import COMPLETE
from sceneweaver.generate.wall_objects import BARE, covered
from sceneweaver.scene import InputError

from .base import Context, Proposal
from .card import checked


class AddWallObjects:
    """Covers bare walls; each thing gets an exact place."""

    name = "add_wall_objects"

    def propose(self, context: Context) -> Proposal:
        """Things for the walls of ``inputs["walls"]``; without any for all walls."""
        inputs = checked(self.name, context.inputs or {})
        if len(context.brief.entities) >= COMPLETE:
            return Proposal(unmet=("the request names enough",))
        walls, last = list(inputs.get("walls") or ()), len(context.scene.room.walls) - 1
        for k in walls:
            if k > last:
                raise InputError(f"tool {self.name}: inputs.walls: there is no wall {k}; use 0 to {last}")
        edits = covered(context, walls, float(inputs.get("bare", BARE)))
        return Proposal(edits=tuple(edits), unmet=() if edits else ("no wall has a free place for anything",))
