"""What comes of a plan of another system: a home, what was assumed, and the plan as its file has it."""

from __future__ import annotations

from dataclasses import dataclass

from sceneweaver.home import Home

from ..model import SourceRoom


@dataclass(frozen=True)
class ImportedHome:
    """A home of another system, and what became of its plan.

    ``notes`` say in one line each what was assumed, changed or left out; ``raw`` are the rooms as the file has them,
    with their openings and objects, metres.

    Examples:
        >>> import tempfile, pathlib
        >>> import sceneweaver as sw
        >>> file = pathlib.Path(tempfile.mkdtemp()) / "one.svg"
        >>> _ = file.write_text('<svg data-scale="0.01"><rect id="studio" width="500" height="400"/></svg>')
        >>> (imported,) = sw.read_homes(file)
        >>> imported.format, imported.home.rooms[0].type, imported.notes[0]
        ('svg', 'studio_apartment', "a unit is 0.01 m, by the drawing's data-scale")
    """

    home: Home
    format: str
    notes: tuple[str, ...]
    raw: tuple[SourceRoom, ...]
