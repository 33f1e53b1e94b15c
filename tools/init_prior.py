"""A whole room from the knowledge base and the request: outline, objects with bodies, relations."""

from __future__ import annotations

from sceneweaver.generate.room import first_draft

from .base import Context, Proposal


class InitPrior:
    """Draws the room that the knowledge base and the request describe."""

    name = "init_prior"

    def propose(self, context: Context) -> Proposal:
        """A new scene; ``inputs`` may hold ``style``, ``roomier``, a factor on a floor that nobody fixed, and ``fill``,
        a factor on what is put into it."""
        inputs = context.inputs
        style, roomier = str(inputs.get("style") or ""), float(inputs.get("roomier", 1.0))
        fill = float(inputs.get("fill", 1.0))
        return first_draft(context, style=style, roomier=roomier, fill=fill, hurried=context.hurried)
