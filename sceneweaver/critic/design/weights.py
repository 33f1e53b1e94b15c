"""Weights: racks whose bars can be loaded, benches that lie one way, a wide mirror, room between machines."""

from __future__ import annotations

import math
from collections.abc import Iterator

from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.knowledge.design_rules import design_rules, limit
from sceneweaver.verify.solids import Body

from ..grade import Finding
from ..survey import QUARTER, Survey
from .breach import breach
from .gym import MACHINES, MATS, MIRRORS, RACKS
from .measure import applies, clear_depth, names

BAR = 0.8
"""Height [m] above which the ends of a bar are loaded."""


def faults(survey: Survey) -> Iterator[Finding]:
    """Breaches of the rules for weights."""
    if applies(survey, "rack_usable"):
        yield from _racks(survey)
        yield from _weights(survey)
        yield from _pinned(survey)


def _racks(survey: Survey) -> Iterator[Finding]:
    """Bars that cannot be loaded, and things that stand inside a rack."""
    side = limit("rack_usable", "side")
    for rack in survey.on_floor(RACKS):
        within = [b for b, _ in survey.near(rack, 0.0) if b.item.mount == "floor" and _within(rack, b)]
        within = [b for b in within if b.item.category not in {"weight_bench", *MATS}]
        if within:
            yield breach(
                "rack_usable",
                (rack.id, *(b.id for b in within)),
                f"{names(within)} stands inside {rack.id}",
                measured=float(len(within)),
                suggestion=f"move {names(within)} out of {rack.id}",
            )
        ends = {s: clear_depth(survey, rack, s, side, lambda b: b.z[1] < BAR)[0] for s in ("left", "right")}
        if min(ends.values()) < side - 0.05:
            end = min(ends, key=lambda s: (round(ends[s], 3), s))
            yield breach(
                "rack_usable",
                (rack.id,),
                f"{ends[end]:.2f} m at the {end} end of the bar of {rack.id}: plates cannot be put on",
                measured=ends[end],
                allowed=(side, None),
                suggestion=f"leave {side:g} m at both ends of {rack.id}",
            )


def _within(rack: Body, body: Body) -> bool:
    ahead, aside = rack.local(body.centre)
    return abs(ahead) < rack.size[0] / 2 - 0.05 and abs(aside) < rack.size[1] / 2 - 0.05


def _weights(survey: Survey) -> Iterator[Finding]:
    """Benches along several axes, and a gym without a wide mirror."""
    limits = design_rules()["weights_at_mirror"].limits
    benches = survey.on_floor(("weight_bench",))
    if len(benches) > 1:
        off = [
            b for b in benches if abs(wrap_angle(b.yaw - benches[0].yaw, 2 * QUARTER)) > math.radians(limits["angle"])
        ]
        if off:
            yield breach(
                "weights_at_mirror",
                (b.id for b in benches),
                f"{names(benches)} lie along several axes",
                measured=float(len(off)),
                suggestion=f"turn {names(benches)} the same way, to the mirror",
            )
    mirrors = survey.of_kind(MIRRORS)
    if mirrors:
        wide = sum(b.size[1] for b in mirrors)
        least = limits["width"] if survey.room_type.name == "gym" else limits["home"]
        if wide < least:
            yield breach(
                "weights_at_mirror",
                (b.id for b in mirrors),
                f"{names(mirrors)} is {wide:.2f} m wide for a whole room",
                measured=wide,
                allowed=(least, None),
                suggestion=f"hang mirrors at least {least:g} m wide behind the weights",
            )


def _pinned(survey: Survey) -> Iterator[Finding]:
    """Machines that nearly touch each other, and benches that touch a wall."""
    least = limit("pieces_apart", "machine")
    close: list[tuple[float, str, str]] = []
    machines = survey.on_floor(MACHINES - RACKS)
    for body in machines:
        gap = float(survey.wall_gaps[body.index])
        if body.item.category == "weight_bench" and gap < least / 3:
            close.append((gap, body.id, "the wall"))
        near = survey.near(body, least)
        close += [(g, body.id, b.id) for b, g in near if b in machines and b.index > body.index and g < least - 0.05]
    if close:
        gap, one, other = min(close)
        ids = dict.fromkeys(name for row in close for name in row[1:] if name != "the wall")
        yield breach(
            "pieces_apart",
            ids,
            f"{gap:.2f} m between {one} and {other}" + (f"; {len(close)} are that close" if len(close) > 1 else ""),
            measured=gap,
            allowed=(least, None),
            weight=min(2.0, 0.7 + 0.3 * len(close)),
            suggestion=f"leave {least:g} m between machines",
        )
