"""A whole room from the knowledge base and the request: outline, objects with bodies, relations."""

from __future__ import annotations

from sceneweaver.generate.room import first_draft

from .base import Context, Proposal


class InitPrior:
    """Draws the room that the knowledge base and the request describe."""

    name = "init_prior"

    def propose(self, context: Context) -> Proposal:
        """A new scene; ``inputs`` may hold ``style``, and ``roomier``, a factor on a floor that nobody fixed."""
        inputs = context.inputs
        made = first_draft(
            context,
            style=str(inputs.get("style") or ""),
            roomier=float(inputs.get("roomier", 1.0)),
            hurried=context.hurried,
        )
        return Proposal(
            scene=made.scene,
            variants=made.variants,
            rooms=made.rooms,
            larger=made.larger,
            fresh=True,
            notes=made.notes,
            unmet=made.unmet,
        )
