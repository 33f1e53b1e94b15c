"""Bottles, jars and tins: a turned body with a cap, labels around it, and what shows through glass."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...drawing import Box, Drawing, draws
from .small_parts import CERAMICS, PLASTICS, Profile, filling, open_vessel, pump, spread, wrap

Form = tuple[Profile, Profile]
"""The profiles of a body and of its cap."""


@dataclass(frozen=True)
class Vessel:
    """Finishes by role, one of some forms, bands by role or finish between two heights, and what is in it how high."""

    finishes: dict[str, str]
    forms: tuple[Form, ...]
    bands: tuple[tuple[str, float, float], ...] = ()
    inside: tuple[str, float] | None = None
    pump: bool = False
    oval: bool = False


def screw(radius: float, low: float, taper: float = 0.0) -> Profile:
    """A screw cap with a cut upper edge, up to the top."""
    return [(radius, low), (radius - taper, 0.99), (radius - taper - 0.04, 1.0)]


def knobbed(radius: float, low: float) -> Profile:
    """A flat lid with a knob."""
    rim = low + 0.4 * (1 - low)
    knob = [(0.15, rim + 0.3 * (1 - rim)), (0.26, rim + 0.6 * (1 - rim)), (0.2, 1.0)]
    return [(radius, low), (radius, rim - 0.01), (radius - 0.03, rim), (0.16, rim), *knob]


CAPS = "white plastic, black plastic, grey plastic, brass"
BOTTLE = [(0.85, 0.0), (1.0, 0.025), (1.0, 0.6), (0.96, 0.64), (0.82, 0.7), (0.5, 0.77), (0.36, 0.82), (0.33, 0.95)]
HOCK = [(0.9, 0.0), (1.0, 0.015), (1.0, 0.42), (0.9, 0.5), (0.62, 0.63), (0.42, 0.72), (0.38, 0.98)]
CLARET = [(0.9, 0.0), (1.0, 0.015), (1.0, 0.57), (0.95, 0.62), (0.7, 0.68), (0.44, 0.73), (0.38, 0.98)]
FOIL = [(0.43, 0.76), (0.41, 0.95), (0.44, 0.955), (0.44, 0.985), (0.4, 1.0)]
BEER = [(0.88, 0.0), (1.0, 0.02), (1.0, 0.52), (0.92, 0.58), (0.62, 0.7), (0.48, 0.77), (0.4, 0.975)]
WAIST = [(0.88, 0.0), (1.0, 0.03), (1.0, 0.28), (0.86, 0.4), (0.98, 0.52), (0.9, 0.65), (0.42, 0.84), (0.38, 0.9)]
OVAL = [(0.9, 0.0), (1.0, 0.03), (1.0, 0.66), (0.92, 0.74), (0.68, 0.8), (0.42, 0.84)]
ON_CAP = [(0.5, 0.13), (0.9, 0.2), (1.0, 0.5), (0.97, 0.8), (0.84, 0.93), (0.5, 1.0)]
SQUEEZED = [(0.9, 0.0), (1.0, 0.03), (0.92, 0.38), (1.0, 0.58), (0.68, 0.76), (0.3, 0.82)]
STRAIGHT = [(0.92, 0.0), (1.0, 0.04), (1.0, 0.68), (0.97, 0.72), (0.84, 0.78)]
CANISTER = [(0.93, 0.0), (1.0, 0.03), (1.0, 0.8), (0.92, 0.87)]
ROUND = [(0.7, 0.0), (0.95, 0.1), (1.0, 0.35), (0.92, 0.6), (0.68, 0.76)]

VESSELS = {
    "bottle": Vessel(
        {
            "body": "green glass, clear plastic, amber glass, glass",
            "cap": "blue plastic, white plastic, black plastic, red plastic, brass",
            "label": "paper, navy paint, sage paint, yellow plastic",
        },
        ((BOTTLE, screw(0.4, 0.93)),),
        (("label", 0.2, 0.45), ("cap", 0.3, 0.35)),
    ),
    "wine_bottle": Vessel(
        {"body": "green glass, green glass, amber glass", "foil": "red paint, black paint, brass, navy paint"},
        ((HOCK, FOIL), (CLARET, FOIL)),
        (("paper", 0.12, 0.38), ("foil", 0.3, 0.33), ("foil", 0.15, 0.16)),
    ),
    "beer_bottle": Vessel(
        {
            "body": "amber glass, amber glass, green glass",
            "cap": "steel, brass",
            "label": "red plastic, yellow plastic, blue plastic, green plastic",
        },
        ((BEER, [(0.5, 0.963), (0.5, 0.98), (0.42, 1.0)]),),
        (("label", 0.18, 0.44), ("paper", 0.27, 0.35), ("label", 0.8, 0.9)),
    ),
    "juice_bottle": Vessel(
        {"body": "clear plastic, glass", "cap": "green plastic, orange plastic, white plastic, red plastic"},
        ((WAIST, screw(0.48, 0.89)),),
        (("paper", 0.08, 0.26), ("cap", 0.11, 0.15)),
        ("orange peel, tomato, lemon peel, red apple, green apple", 0.76),
    ),
    "lotion_bottle": Vessel(
        {
            "body": PLASTICS + ", amber glass",
            "pump": "white plastic, black plastic, steel",
            "label": "paper, sand pigment, blush pigment",
        },
        (([(0.93, 0.0), (1.0, 0.01), (1.0, 0.6), (0.9, 0.64), (0.42, 0.7)], []),),
        (("label", 0.11, 0.46), ("ink pigment", 0.34, 0.37), ("ochre pigment", 0.15, 0.165)),
        pump=True,
    ),
    "medicine_bottle": Vessel(
        {
            "body": "amber glass, white plastic, green glass, blue plastic",
            "cap": "white plastic",
            "stripe": "red plastic, blue plastic, green plastic",
        },
        (([(0.94, 0.0), (1.0, 0.03), (1.0, 0.66), (0.76, 0.74)], screw(0.88, 0.73, 0.02)),),
        (("paper", 0.14, 0.56), ("stripe", 0.42, 0.5), ("ink pigment", 0.3, 0.33)),
    ),
    "shampoo_bottle": Vessel(
        {"body": PLASTICS, "cap": CAPS, "label": "paper, navy paint, sage paint, yellow plastic"},
        ((OVAL, screw(0.46, 0.83)), (ON_CAP, [(0.72, 0.0), (0.78, 0.02), (0.82, 0.15)])),
        (("label", 0.26, 0.6), ("ink pigment", 0.48, 0.51), ("chalk pigment", 0.34, 0.36)),
        oval=True,
    ),
    "dish_soap": Vessel(
        {
            "body": "green plastic, yellow plastic, clear plastic, blue plastic, orange plastic",
            "cap": "white plastic, blue plastic, red plastic",
        },
        ((SQUEEZED, [(0.34, 0.81), (0.3, 0.92), (0.16, 0.925), (0.1, 1.0)]),),
        (("paper", 0.12, 0.34), ("blue plastic", 0.2, 0.26)),
        oval=True,
    ),
    "jar": Vessel(
        {"body": "glass", "lid": "brass, red plastic, white steel, black steel, green plastic"},
        ((STRAIGHT, screw(0.92, 0.79)),),
        (("paper", 0.18, 0.56), ("ochre pigment", 0.3, 0.42)),
        ("tomato, grape, cheese, orange peel, dark leaf, amber glass, chocolate", 0.68),
    ),
    "spice_jar": Vessel(
        {"body": "glass", "lid": "bamboo, black plastic, steel, cork"},
        ((STRAIGHT, screw(0.88, 0.77)),),
        (("paper", 0.22, 0.46), ("ink pigment", 0.33, 0.36)),
        ("terracotta, mustard fabric, pale leaf, black paint, tomato, bread crust", 0.6),
    ),
    "storage_jar": Vessel(
        {"body": "glass, glass, glass, " + CERAMICS, "lid": "bamboo, oak, steel, cork, black steel"},
        ((CANISTER, knobbed(0.97, 0.86)),),
        (("paper", 0.34, 0.5),),
        ("bread crumb, icing, terracotta, bread crust, coffee, lemon peel", 0.66),
    ),
    "cotton_jar": Vessel(
        {"body": "glass", "lid": "bamboo, chrome, brass, oak"},
        (([(0.95, 0.0), (1.0, 0.03), (1.0, 0.76)], knobbed(1.0, 0.76)),),
    ),
    "cookie_jar": Vessel(
        {"body": "glass", "lid": "oak, steel, red plastic, walnut"},
        ((ROUND, [(0.74, 0.76), (0.74, 0.83), (0.6, 0.88), (0.12, 0.9), (0.1, 0.92), (0.17, 0.96), (0.1, 1.0)]),),
    ),
    "tin": Vessel(
        {
            "body": "red paint, navy paint, green paint, cream paint, teal paint, brass, black paint",
            "trim": "brass, white paint, steel",
        },
        (
            (
                [(0.96, 0.0), (0.97, 0.01), (0.97, 0.75), (1.0, 0.76), (1.0, 0.95)],
                [(0.97, 0.95), (0.9, 0.97), (0.86, 1.0)],
            ),
        ),
        (("trim", 0.06, 0.1), ("trim", 0.66, 0.7), ("cream paint", 0.26, 0.52), ("trim", 0.36, 0.42)),
    ),
    "can": Vessel(
        {
            "label": "red plastic, green plastic, yellow plastic, blue plastic, white plastic, orange plastic",
            "body": "steel",
            "lid": "steel",
        },
        (([(0.96, 0.0), (1.0, 0.03), (1.0, 0.05), (0.975, 0.07), (0.975, 0.93), (1.0, 0.95), (1.0, 0.96)], []),),
        (("label", 0.08, 0.92), ("paper", 0.62, 0.8), ("cream paint", 0.12, 0.24)),
    ),
    "thermos": Vessel(
        {
            "body": "brushed steel, black steel, teal paint, red paint, sage paint, navy paint, mint plastic",
            "cap": "brushed steel, black plastic, bamboo",
        },
        (([(0.94, 0.0), (1.0, 0.015), (1.0, 0.72), (0.8, 0.79)], [(0.8, 0.795), (0.73, 0.985), (0.68, 1.0)]),),
        (("black plastic", 0.02, 0.045), ("cap", 0.3, 0.32)),
    ),
}


def vessel(d: Drawing) -> None:
    """A bottle, jar or tin of the table; its shoulder is higher or lower by the seed."""
    kind = VESSELS[d.category.name]
    box = d.bounds if kind.oval else d.even("round")
    lift = d.uniform("shoulder", -0.03, 0.03)

    def lifted(z: float) -> float:
        return z + 4 * lift * z * (1 - z)

    looks = {role: d.material(role, names) for role, names in kind.finishes.items()}
    body, cap = ([(r, lifted(z)) for r, z in profile] for profile in d.pick("form", kind.forms))
    roles = list(looks)
    d.turned(box, body, looks["body"])
    if kind.pump:
        pump(d, body[-1][1] * box.height - 0.002, box.height, 0.97 * box.depth / 2, looks[roles[1]])
    if cap:
        d.turned(box, cap, looks[roles[1]])
    if kind.inside and looks["body"].opacity < 1:
        contents = d.pick("inside", kind.inside[0].split(", "))
        filling(d, box, body, body[0][1] + 0.02, lifted(kind.inside[1]), contents)
    for layer, (look, low, high) in enumerate(kind.bands):
        wrap(d, box, body, lifted(low), lifted(high), looks.get(look, look), layer)
    if d.category.name in LOOSE:
        with d.no_colliders():
            LOOSE[d.category.name](d, box)
    if d.category.name == "can":
        lid(d, box)


def cotton(d: Drawing, box: Box) -> None:
    """Cotton balls."""
    size = 0.29 * box.width
    for level in range(5):
        with d.at(z=0.006 + level * 0.13 * box.height, yaw=1.2 * level):
            for x, y in spread(7, 0.33 * box.width):
                d.ball(Box.sized(size, size, size, (x, y, 0.0)), "icing", 8)


def biscuits(d: Drawing, box: Box) -> None:
    """Biscuits that lie crosswise."""
    r = box.width / 2
    for level in range(5):
        for k in range(5):
            a = k * 2 * np.pi / 5 + level
            look = "cake sponge" if (level + k) % 3 else "chocolate"
            with d.at(0.45 * r * np.cos(a), 0.45 * r * np.sin(a), (0.05 + 0.12 * level) * box.height, pitch=0.2):
                d.cylinder(Box.sized(0.6 * r, 0.6 * r, 0.08 * box.height), look, bevel=0.003, segments=12)


def pills(d: Drawing, box: Box) -> None:
    """Pills in two colours."""
    for k, (x, y) in enumerate(spread(10, 0.6 * box.width / 2)):
        own = Box.sized(0.2 * box.width, 0.12 * box.width, 0.1 * box.width, (x, y, (0.06 + 0.016 * k) * box.height))
        d.ball(own, ("white plastic", "red plastic")[k % 2], 8)


LOOSE = {"cotton_jar": cotton, "cookie_jar": biscuits, "medicine_bottle": pills}


def lid(d: Drawing, box: Box) -> None:
    """The end of a tin can: a rim around a sunken lid, with a ring to pull."""
    rim = [(1.0, 0.96), (0.99, 0.995), (0.97, 1.0), (0.94, 1.0), (0.92, 0.975), (0.0, 0.975)]
    d.turned(box, rim, "steel", hollow=True)
    pull = Box.sized(0.24 * box.depth, 0.16 * box.width, 0.003, (0.1 * box.depth, 0.0, 0.975 * box.height))
    d.hoop(pull, 0.0015, "steel", steps=12)


draws(*(name for name, kind in VESSELS.items() if not kind.oval), whole=True, even="round")(vessel)
draws(*(name for name, kind in VESSELS.items() if kind.oval), whole=True)(vessel)


@draws("soap_dispenser", whole=True, even="round")
def soap_dispenser(d: Drawing) -> None:
    """A round or square bottle of liquid soap with a pump and a label."""
    box = d.even("round")
    look = d.material("body", CERAMICS, "concrete, marble, amber glass")
    head = d.material("pump", "steel, brass, black steel, chrome")
    bottle = box.share(z=(0.0, 0.68))
    paper = d.pick("label", ["paper", "sand pigment", "white paint"])
    if d.chance("square", 0.3):
        d.sections(
            bottle, [(0.94, 0.94, 0.0), (1, 1, 0.03), (1, 1, 0.9), (0.5, 0.5, 1)], look, radius=0.12, convex=True
        )
        d.print(bottle.front(0.0).share(y=(0.25, 0.75), z=(0.3, 0.65)), paper)
        d.print(bottle.front(0.0).share(y=(0.32, 0.68), z=(0.5, 0.54)), "ink pigment", 0.0004)
    else:
        body = [(0.92, 0.0), (1.0, 0.05), (1.0, 0.8), (0.8, 0.93), (0.42, 1.0)]
        d.turned(bottle, body, look)
        wrap(d, bottle, body, 0.28, 0.6, paper)
        wrap(d, bottle, body, 0.42, 0.46, "ink pigment", 1)
    pump(d, bottle.z[1] - 0.002, box.z[1], 0.48 * box.depth, head)


@draws("carafe", whole=True, even="round")
def carafe(d: Drawing) -> None:
    """A glass bottle with a waist, water or wine in it, and a cork."""
    box = d.even("round")
    glass = d.material("body", "glass")
    body = [(0.86, 0.0), (1.0, 0.03), (0.97, 0.25), (0.72, 0.47), (0.5, 0.62), (0.4, 0.78), (0.56, 0.95)]
    open_vessel(
        d, box, body, glass, 0.0025, 0.03, d.pick("drink", ["frosted glass", "aubergine", "frosted glass"]), 0.47
    )
    d.cylinder(
        box.share(z=(0.8, 1.0)).inset(x=0.25 * box.depth, y=0.25 * box.width), "cork", ends=(0.8, 1.0), bevel=0.003
    )


@draws("detergent_bottle", whole=True)
def detergent_bottle(d: Drawing) -> None:
    """A big bottle with a handle, a measuring cap and a bright label."""
    box = d.bounds
    look = d.material("body", "blue plastic, orange plastic, white plastic, green plastic, lilac plastic, red plastic")
    cap = d.material("cap", "white plastic, blue plastic, yellow plastic")
    low, shoulder = box.share(z=(0.0, 0.5)), box.share(z=(0.495, 0.82))
    d.sections(low, [(0.95, 0.97, 0.0), (1, 1, 0.03), (1, 1, 1)], look, radius=0.35, convex=True)
    slope = [(1.0, 0.7, 0.0, 0.0, -0.15), (0.8, 0.58, 0.57, 0.0, -0.15), (0.48, 0.36, 1.0, 0.0, -0.17)]
    d.sections(shoulder, slope, look, radius=0.35)
    h, w = box.height, box.width
    grip = [(0, 0.06 * w, 0.75 * h), (0, 0.28 * w, 0.745 * h), (0, 0.42 * w, 0.66 * h), (0, 0.42 * w, 0.48 * h)]
    d.sweep(grip, 0.014, look, 8)
    mouth = Box.sized(0.6 * box.depth, 0.6 * box.depth, 0.18 * h + 0.004, (0.0, -0.17 * w, 0.82 * h - 0.004))
    d.cylinder(mouth, cap, ends=(1.0, 0.93), bevel=0.003)
    front = low.front(0.0)
    d.print(
        front.share(y=(0.3, 0.7), z=(0.2, 0.84)), "blue plastic" if look.name == "white plastic" else "white plastic"
    )
    sun = d.pick("sun", ["yellow plastic", "pink plastic", "green plastic"])
    with d.no_colliders():
        place = Box.around(front.anchor(), 0.0008, 0.32 * w, 0.32 * w).move(z=0.03 * h)
        d.cylinder(place, sun, "x", segments=20)
    d.print(front.share(y=(0.31, 0.69), z=(0.5, 0.6)), "navy paint", 0.0005)
