"""Stoves, ovens, hobs, hoods, dishwashers, microwaves."""

from __future__ import annotations

from ...drawing import Box, Drawing, draws
from ...drawing.components import (
    SWING,
    TURN,
    bar_pull,
    carcass,
    cavity,
    compartments,
    drawer,
    handle,
    knob,
    lip,
    rack,
    unit,
    walls,
)
from ...drawing.drawing import Look
from .kitchen_common import PLINTH, SETBACK, burners, coat_of, feet, knobs, oven_door, plinth, worktop_of


def _oven(d: Drawing, box: Box, coat: Look) -> None:
    """The dark room of an oven in its case, with two racks on ledges; its door is drawn before it."""
    case = cavity(d, box, coat, 0.012, 0.002, None).inset(back=0.05)  # behind it are its fan and its wires
    room = cavity(d, case, "black paint", 0.028, 0.012, None).inset(front=0.005)
    racks = [rack(d, room.inset(front=0.015, top=(1 - share) * room.height)) for share in (0.3, 0.62)]
    levels = [room.z[0], *(own.z[1] for own in racks), room.z[1]]
    spans = zip(levels[:-1], levels[1:], (0.005, 0.005, 0.0), strict=True)
    compartments(d, [room.to(z=(low, high - wire)) for low, high, wire in spans])


def _sides(d: Drawing, box: Box, case: Box, coat: Look) -> Box:
    """Panels of 4 mm over both sides of a case, which hide its joints; returns the box between them."""
    for side in (case.left(0.004), case.right(0.004)):
        d.box(side, coat, bevel=0.001)
    return box.inset(y=0.004)


@draws("stove")
def stove(d: Drawing) -> None:
    """A cooktop over a panel of knobs, an oven door with window and bar, and a drawer below."""
    coat = coat_of(d, "cream paint", "navy paint", "red paint")
    pull = d.material("handles", "chrome", "brushed steel", "brass")
    bounds = d.bounds
    gas = bounds.height > 0.915  # a plate of glass is flush with worktops of 0.9 m, iron grates stand over them
    steel_top = "black paint" if d.chance("black top", 0.4) else "brushed steel"
    top = bounds.z[1] - (0.035 if gas else 0.0)
    front = bounds.inset(front=0.025)
    case = front.inset(front=0.04)
    count = 6 if gas and bounds.width >= 0.72 else 4
    with d.part("body"):
        feet(d, case.bottom(0.07), 0.02)
        plinth(d, case.bottom(0.068))
        case = _sides(d, case, case.to(z=(0.068, top - 0.022)), coat)
        plate = front.inset(front=-0.01).to(z=(top - 0.022, top))
        d.box(plate, steel_top if gas else "black glass", bevel=0.004)
        burners(d, plate.inset(x=0.03, y=0.03), gas, count)
        controls = case.to(z=(top - 0.126, top - 0.022))
        d.box(controls, coat, bevel=0.0)
        dark = d.chance("black panel", 0.4)
        panel = d.box(controls.inset(y=0.002).front(-0.04).inset(bottom=0.001), "black glass" if dark else coat)
        each = 3 if bounds.width > 0.59 else 2  # so that fingers fit between them
        for k, share in enumerate(((0.03, 0.42), (0.58, 0.97))):
            knobs(d, panel.share(y=share), each, pull if coat.metallic else "black plastic", first=each * k)
        d.print(panel.front(0.0).place(width=0.1, height=0.035), "screen")
        rooms = case.to(z=(0.235, controls.z[0]))
        cells = rooms.columns([0.62, 0.38]) if bounds.width > 0.8 and d.chance("two ovens", 0.5) else [rooms]
        for k, cell in enumerate(cells):
            _oven(d, cell, coat)
            oven_door(d, f"oven-{k}", cell.inset(y=0.002, bottom=0.002, top=0.002).front(-0.04), coat, pull)
        below = case.to(z=(0.068, 0.235))
        room = carcass(d, below, coat)
        tray = front.to(z=below.z).inset(back=room.x[0] - front.x[0])
        drawer(d, "drawer", tray, coat, pull, "bar", 0.35, "grey plastic", overlay=0.018)
    if not gas:
        d.surface("hob", case.to(z=bounds.z), inset=0.02)
    d.fit()


@draws("oven_tower")
def oven_tower(d: Drawing) -> None:
    """A tall kitchen column with an oven at hand height, a small oven over it, drawers below, a door above."""
    names = ("white paint", "oak", "light grey paint", "walnut", "sage paint", "navy paint", "black paint")
    leaf, shell = d.material("fronts", *names), d.material("body", "white paint", "light grey paint")
    steel = d.material("oven", d.pick("oven coat", ["brushed steel", "black paint", "steel"]))
    pull = d.material("pulls", "black steel", "steel", "brass")
    bounds = d.bounds.inset(front=0.0275)
    low, middle, high = 0.69, 1.3, 1.69
    with d.part("body"):
        plinth(d, bounds.bottom(PLINTH))
        bounds = _sides(d, bounds, bounds.inset(bottom=PLINTH, front=0.019), shell)
        unit(d, "low", bounds.to(z=(PLINTH, low)), "drawers", shell, leaf, pull)
        niche = carcass(d, bounds.inset(front=0.019).to(z=(low, high)), shell, board=0.01)
        for name, z in (("oven", (niche.z[0], middle)), ("small oven", (middle + 0.004, niche.z[1]))):
            cell = niche.to(z=z)
            _oven(d, cell.inset(top=0.105), "grey plastic")
            d.box(cell.top(0.105), "grey plastic", bevel=0.0)
            face = cell.front(-0.019).inset(y=-0.008)
            panel = d.box(face.top(0.1), "black glass", bevel=0.002)
            d.print(panel.front(0.0).place(width=0.12, height=0.04), "screen")
            for k, side in enumerate((panel.share(y=(0.1, 0.3)), panel.share(y=(0.7, 0.9)))):
                knob(d, side, steel, 0.022, 0.022, name=f"{name} knob-{k}")
            oven_door(d, name, face.inset(top=0.103), steel, "chrome")
        top = bounds.to(z=(high, bounds.z[1]))
        unit(d, "top", top, "door", shell, leaf, pull, grip=0.2)
    d.fit()


@draws("hob")
def hob(d: Drawing) -> None:
    """A glass or steel plate with four or six places to cook, and its controls along the front."""
    bounds = d.bounds
    gas = bounds.height > 0.045
    look = d.material("plate", d.pick("plate kind", ["brushed steel", "black glass"]) if gas else "black glass")
    plate = bounds.inset(top=0.035 if gas else 0.0)
    count = 6 if bounds.width > 0.78 and gas else 4
    with d.part("hob"):
        if not gas:
            d.box(plate.inset(x=0.02, y=0.02, top=0.006), "black plastic", bevel=0.0)
        d.box(plate if gas else plate.top(0.007), look, bevel=0.002)
        burners(d, plate.inset(back=0.02, front=0.105 if gas else 0.08, y=0.02), gas, count)
        plate_dark = look.called("black glass")
        row = plate.top(0.0).front(0.09).place(width=(count + 1) * 0.065 if gas else 0.28)
        for k, place in enumerate(row.columns(count + 1 if gas else 8)):
            if gas:
                body, metal = Box.sized(0.036, 0.036, 0.022, place.center), "chrome" if plate_dark else "black plastic"
                with d.hinge(f"knob-{k}", place.center, (0.0, 0.0, -1.0), (0.0, TURN), "control"):
                    d.cylinder(body, metal, ends=(1.0, 0.85), bevel=0.002, segments=14)
                    d.grasp("knob", body.center, (0.0, 0.0, -1.0), (1.0, 0.0, 0.0), body.depth, body.width)
            else:
                d.print(place.place(0.005, 0.016), "white plastic")
    if not gas:
        d.surface("hob", plate.inset(back=0.02, front=0.08, y=0.02))
    d.fit()


@draws("range_hood")
def range_hood(d: Drawing) -> None:
    """A chimney in two lengths over a pyramid or a thin box, with filters, lights and buttons."""
    steel = coat_of(d)
    pyramid = d.pick("kind", ["pyramid", "box"]) == "pyramid"
    bounds = d.bounds
    canopy = bounds.bottom(0.055)
    shaft = bounds.place(0.26, 0.28, at="back").inset(bottom=canopy.height)
    with d.part("canopy"):
        walls(d, canopy, steel, 0.012, 0.001)
        d.box(canopy.inset(x=0.012, y=0.012).top(0.03), steel, bevel=0.0)
        if pyramid:
            shaft = shaft.inset(bottom=0.2 + 0.12 * (bounds.height - 0.7))
            rim, neck = canopy.inset(front=0.01, y=0.01), shaft
            low = [(x, y, canopy.z[1] - 0.001) for x in rim.x for y in rim.y]
            d.hull(low + [(x, y, shaft.z[0]) for x in neck.x for y in neck.y], steel)
        filters = canopy.inset(back=0.06, front=0.14, y=0.03, top=0.03).top(0.006)
        for panel in filters.columns(2, gap=0.02):
            d.box(panel, "aluminium", bevel=0.0)
            with d.grid(panel.bottom(0.0), y=9):
                d.box(Box.sized(panel.depth - 0.03, 0.005, 0.003, (0.0, 0.0, -0.003)), "grey plastic", bevel=0.0)
        for share in (0.2, 0.8):
            light = canopy.inset(x=0.03, top=0.03).front(0.07).share(y=(share, share)).anchor("top")
            d.cylinder(Box.sized(0.06, 0.06, 0.008, (light[0], light[1], light[2] - 0.006)), "lamp glow", segments=16)
        for place in canopy.place(width=0.15).columns(5):
            d.print(place.front(0.0).place(width=0.016, height=0.012), "black plastic", 0.0004)
    with d.part("chimney"):
        lower, upper = shaft.rows(2)
        d.box(lower.inset(bottom=-0.001), steel, bevel=0.001)
        d.box(upper.inset(front=0.004, y=0.004), steel, bevel=0.001)
        with d.mirror("y"):
            for slot in upper.inset(x=0.06, y=0.004, top=0.05).left(0.0).top(0.07).rows(4, gap=0.012):
                d.print(slot, "black plastic")
    d.fit()


@draws("dishwasher")
def dishwasher(d: Drawing) -> None:
    """A steel tub with two racks behind a front that falls open, under a worktop or a lid of its own."""
    coat = coat_of(d)
    own_lid = coat if coat.called("black paint") else "white paint"
    lid, thick = worktop_of(d) if d.in_suite else (own_lid, 0.03)
    bounds = d.bounds
    front = bounds.inset(front=SETBACK, bottom=PLINTH, top=thick)
    case = front.inset(front=0.025)
    with d.part("body"):
        plinth(d, bounds.inset(front=SETBACK).bottom(PLINTH))
        d.box(bounds.top(thick), lid)
        tub = cavity(d, case, "grey plastic" if coat.metallic else "white paint", 0.012, 0.003, None)
        room = cavity(d, tub, "steel", 0.02, 0.02, None)
        levels = [room.z[1]]
        for share in (0.5, 0.92):
            tray = room.inset(front=0.01, x=0.01, y=0.01, top=share * room.height)
            rack(d, tray, "grey plastic")
            walls(d, tray.top(-0.09).top(0.005), "grey plastic", 0.005, 0.0)
            compartments(d, [tray.to(z=(tray.z[1], levels[-1] - 0.005))], f"rack-{len(levels)}")
            levels.append(tray.z[1])
        leaf = front.inset(y=0.002, bottom=0.01, top=0.003).front(0.025)
        with d.hinge("door", leaf.anchor("front bottom"), axis=(0.0, 1.0, 0.0), limits=(0.0, 1.5)):
            panel, low = leaf.top(0.11), leaf.inset(top=0.113)
            d.box(low, coat, bevel=0.004)
            d.box(panel, "black plastic" if coat.metallic else coat, bevel=0.004)
            if d.chance("bar", 0.6):
                handle(d, low.top(0.11), "chrome", "bar", 0.75 * low.width)
            else:
                lip(d, low.top(0.02).front(-0.022).place(width=0.2), "grey plastic", bevel=0.006)
            face = panel.front(0.0).place(height=0.03)
            d.print(face.share(y=(0.54, 0.68)), "screen")
            for button in face.share(y=(0.22, 0.44)).columns(4):
                d.print(button.place(width=0.016, height=0.014), "grey plastic", 0.0004)
            d.print(face.share(y=(0.86, 0.94)).place(height=0.014), "chrome", 0.0004)
    d.surface("top", bounds.inset(front=SETBACK), inset=0.01)
    d.fit()


@draws("microwave")
def microwave(d: Drawing) -> None:
    """A box with a turntable behind a door with a window, and a panel with a clock, buttons or knobs."""
    coat = d.material("body", "brushed steel", "white plastic", "black plastic", "red plastic", "steel")
    bounds = d.bounds
    case = bounds.inset(front=0.052, bottom=0.01)
    with d.part("body"):
        feet(d, case.bottom(0.012).move(z=-0.01), 0.014)
        inside = cavity(d, case, coat, 0.006, 0.008, None)
        # Seen from its front, the panel is to the viewer's right, which is +y.
        wide = 0.26 * case.width
        d.box(inside.left(wide - 0.006), "grey plastic", bevel=0.0)
        room = cavity(d, inside.inset(left=wide - 0.006), "white plastic", 0.012, 0.012)
        plate = room.inset(all=0.01).bottom(0.006)
        d.cylinder(plate.place(min(plate.size[:2]), min(plate.size[:2])), "glass", segments=28)
        with d.mirror("y"):
            for vent in case.left(0.0).inset(back=0.05).back(0.1).share(z=(0.5, 0.8)).split("x", 6, gap=0.01):
                d.print(vent, "black plastic")
        front = case.inset(y=0.001, bottom=0.002, top=0.002).front(-0.022)
        dark = d.chance("dark panel", 0.6)
        panel = d.box(front.left(wide - 0.002), "black glass" if dark else coat)
        clock = d.print(panel.front(0.0).top(0.07).inset(y=0.15 * wide, bottom=0.038, top=0.008), "screen")
        d.print(clock.inset(y=0.25 * clock.width, z=0.006), "lamp glow", 0.00045)
        if d.chance("knobs", 0.4):
            for k, place in enumerate(panel.inset(top=0.07).rows(2)):
                knob(d, place, "chrome", 0.021, 0.022, "black plastic", f"knob-{k}")
        else:
            keys = panel.inset(top=0.08, bottom=0.03).place(width=0.08).front(0.0)
            for key in (cell for row in keys.rows(4) for cell in row.columns(3)):
                d.print(key.inset(y=0.004, z=0.2 * key.height), "grey plastic", 0.0004)
        leaf = front.inset(left=wide)
        with d.hinge("door", leaf.anchor("front right bottom"), limits=(-SWING, 0.0)):
            window = leaf.inset(right=0.035, left=0.06, bottom=0.035, top=0.035)
            for part in (leaf.to(y=(leaf.y[0], window.y[0])), leaf.to(y=(window.y[1], leaf.y[1]))):
                d.box(part, coat)
            for z in ((leaf.z[0], window.z[0]), (window.z[1], leaf.z[1])):
                d.box(leaf.to(y=window.y, z=z), coat)
            d.box(window.place(depth=0.006), "smoked glass", bevel=0.0)
            x, y = leaf.x[1], leaf.y[1] - 0.03
            bar_pull(d, (x, y, window.z[0]), (x, y, window.z[1]), "chrome", 0.0075, 0.022)
    d.surface("top", case, inset=0.015)
    d.fit()
