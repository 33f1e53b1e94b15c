"""Make a finished room look lived-in."""

from __future__ import annotations

import random

from sceneweaver.generate.traces import FreeFloor, moved_chairs
from sceneweaver.io.messages import show
from sceneweaver.knowledge.small_things import traces
from sceneweaver.scene import InputError
from sceneweaver.scene.edits import Add, AnyEdit

from .base import Context, Proposal


class AddClutter:
    """Makes a finished room look lived-in; every edit by itself leaves it valid as far as a tool can tell."""

    name = "add_clutter"

    def propose(self, context: Context) -> Proposal:
        """Small shifts of chairs, then things on the floor; ``inputs`` may give the ``clutter`` in 0..1."""
        clutter = context.inputs.get("clutter", context.clutter)
        if isinstance(clutter, bool) or not isinstance(clutter, int | float) or not 0 <= clutter <= 1:
            raise InputError(f"clutter: {show(clutter)} is no number from 0 to 1")
        if clutter == 0 or context.brief.only or context.brief.density == "sparse":
            return Proposal(notes=("the room is left as it is",))
        dice = random.Random(f"{context.seed}/clutter")
        edits: list[AnyEdit] = [*moved_chairs(context.scene, clutter, dice)]
        floor = FreeFloor(context, dice)
        for trace in traces():
            if trace.clutter <= clutter and (not trace.rooms or context.room_type.name in trace.rooms):
                edits += [Add(object=obj) for obj in floor.strewn(trace, clutter)]
        return Proposal(edits=tuple(edits))
