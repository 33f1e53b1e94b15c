"""How far doors, drawers and lids open before something is in their way.

Each opens alone, with all else closed. In its way are the collision parts of other objects, walls, floor, ceiling, the
closed leaves of the room's doors, and the other links of its own piece. What a hand moves aside is not (a free thing up
to `LIGHT`, a seat up to `LIGHT_SEAT`), nor are rugs.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import groupby

import numpy as np

from sceneweaver.assets import Asset, categories
from sceneweaver.runtime.deadline import checkpoint
from sceneweaver.scene import Scene
from sceneweaver.verify.openable_parts import Bodies
from sceneweaver.verify.report import OPEN, LinkTravel, Report, Violation
from sceneweaver.verify.sweeps import STEPS, Block, Scenery

NEEDED_DOORS = frozenset(("wardrobe", "built_in_wardrobe", "microwave"))
"""Categories of which each door and lid has to open, as of all appliances; of other pieces at least half of what
opens."""


def measure(scene: Scene, load: Callable[[str], Asset] | None = None) -> list[LinkTravel]:
    """How far each door, drawer and lid of a scene opens; the room's doors come last.

    Args:
        scene: what to judge.
        load: from asset id to asset; None: the library of this user.

    Raises:
        InputError: an asset that cannot be loaded.
    """
    made = Bodies.of(scene, load)
    scenery = Scenery(made.blocks)
    owner = np.array([body.object for body in made.bodies], dtype=int)
    base = np.array([body.number == 0 for body in made.bodies], dtype=bool)
    yields = np.array([body.yields for body in made.bodies], dtype=bool)
    parts: dict[int, list[Block]] = {}
    for block in made.blocks:
        parts.setdefault(block.body, []).append(block)
    found = []
    for opening in made.openings:
        checkpoint()
        body = made.bodies[opening.body]
        skip = np.where((owner == body.object) & (owner >= 0), base, yields)
        skip[opening.body] = True
        free, met = scenery.first_met(parts[opening.body], opening.motion, skip)
        blocker = None if met is None else made.bodies[met].name
        found.append(LinkTravel(body.name, opening.link, opening.role, min(free / STEPS, opening.most), blocker))
    return found


def judged(report: Report, scene: Scene, found: Sequence[LinkTravel]) -> Report:
    """A report of the same scene with what was found, and without what it said of that before."""
    wrong = violations(scene, found)
    kept = tuple(v for v in report.violations if v.kind != "blocked_link")
    return replace(
        report,
        valid=not any(v.hard for v in (*kept, *wrong)),
        openable_share=sum(link.opens for link in found) / len(found) if found else None,
        blocked_links=tuple(link for link in found if not link.opens),
        violations=(*kept, *wrong),
    )


def violations(scene: Scene, found: Sequence[LinkTravel]) -> list[Violation]:
    """One for each link that is needed and does not open.

    Needed are the room's doors, doors and lids of appliances and of `NEEDED_DOORS`, and of each other piece at least
    half of its links: where fewer open, those that open the farthest.
    """
    kinds = {o.id: o.category.strip().lower().replace(" ", "_") for o in scene.objects}
    blocked: list[Violation] = []
    for name, links in groupby(found, key=lambda link: link.object):
        blocked += [_violation(link) for link in _needed(list(links), kinds.get(name)) if not link.opens]
    return blocked


def _needed(links: list[LinkTravel], kind: str | None) -> list[LinkTravel]:
    """Which links of one object (or of the room's door, whose kind is None) have to open."""
    if kind is None:
        return links
    known = categories().get(kind)
    if kind in NEEDED_DOORS or (known is not None and known.parent == "appliance"):
        return [link for link in links if link.role != "drawer"]
    return sorted(links, key=lambda link: -link.share)[: (len(links) + 1) // 2]


def _violation(link: LinkTravel) -> Violation:
    by = link.blocked_by or "its own hinge"
    what = "" if link.object == link.blocked_by else f": {by} is in its way"
    detail = f"{link.link} of {link.object} opens to {link.share:.0%}, not to {OPEN:.0%}{what}"
    objects = (link.object,) if link.blocked_by in (None, link.object) else (link.object, link.blocked_by)
    return Violation("blocked_link", objects, detail, OPEN - link.share)
