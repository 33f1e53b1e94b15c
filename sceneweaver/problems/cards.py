"""The card of a problem: what it is and what is known of it, as Markdown."""

from __future__ import annotations

from typing import Any

from .certificates import prove
from .recipes import families

FACTS = {
    "tightness": "share of the floor that is taken",
    "density": "hard relations an object",
    "wishes": "soft relations an object",
    "wall_fill": "share of the walls that backs stand at",
    "surface_tightness": "share of the boards that is taken",
}


def card_of(case: Any) -> str:
    """A title, a line on the family, a table of figures, what proves the problem, how hard it is.

    ``case`` is a `ProblemCase`, whose module imports this one.
    """
    scene = case.scene
    lines = [f"# {case.name}", "", families()[case.family], ""]
    relations = [
        f"{len(some)} {word}: {', '.join(sorted({r.type for r in some}))}"
        for word, hard in (("hard", True), ("soft", False))
        if (some := [r for r in scene.relations if r.hard == hard])
    ]
    carried = sum(o.support is not None for o in scene.objects)
    zones = sum(z.hard for o in scene.objects for z in o.zones)
    parts = sum(len(o.solids) for o in scene.objects)
    rows = {
        "objects": f"{len(scene.objects)}" + (f", {carried} of them on surfaces" if carried else ""),
        "bodies": f"{parts} convex prisms, {zones} hard zones",
        "relations": "; ".join(relations) or "none",
        "room": f"{len(scene.room.outline)} walls, {len(scene.room.doors)} doors, {len(scene.room.windows)} windows",
        **{text: f"{case.facts[key]:g}" for key, text in FACTS.items() if key in case.facts},
        "starts": ", ".join(case.starts),
        "version": f"{case.version}, SHA-256 {case.hash[:16]}",
    }
    lines += ["| | |", "| --- | --- |", *(f"| {key} | {value} |" for key, value in rows.items()), ""]
    if case.certificate is not None:
        lines += [f"**No layout is valid**: {prove(scene, case.certificate)} (`{case.certificate['kind']}`).", ""]
    else:
        best = "not measured" if case.best_energy is None else f"{case.best_energy:.4g} m"
        lines += [f"A valid layout is known. Lowest energy of a valid one: {best}.", ""]
    shares = [(name, row) for name, row in case.difficulty.items() if isinstance(row, dict)]
    if shares:
        lines += ["| optimiser | start | layouts | valid | CPU seconds |", "| --- | --- | ---: | ---: | ---: |"]
        lines += [
            f"| {name} | {row['start']} | {row['candidates']} | {row['valid']:.0%} | {row['seconds']:.1f} |"
            for name, row in shares
        ]
        lines.append("")
    return "\n".join(lines)
