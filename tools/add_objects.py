"""Add objects with bodies: what a call names, placed by its relations or where such things usually go."""

from __future__ import annotations

from sceneweaver.generate.draft import Draft
from sceneweaver.generate.objects import added
from sceneweaver.generate.reading import rows_of
from sceneweaver.scene import InputError

from .base import Context, Proposal
from .card import checked


class AddObjects:
    """Adds furniture and single things; each gets a body, an id and relations."""

    name = "add_objects"

    def propose(self, context: Context) -> Proposal:
        """Objects of ``inputs["objects"]``, or those that the instruction names."""
        notes: list[str] = []
        if context.inputs:
            rows = checked(self.name, context.inputs)["objects"]
        elif context.instruction.strip():
            rows, notes = rows_of(context.instruction, Draft.of(context.scene))
            if not rows:
                raise InputError(f"tool {self.name}: instruction names nothing to add; name things, such as two plants")
        else:
            raise InputError(f"tool {self.name}: inputs.objects is missing; name what to add")
        made = added(context, rows, told=bool(context.inputs))
        return Proposal(edits=tuple(made.edits), notes=(*notes, *made.notes), unmet=tuple(made.unmet))
