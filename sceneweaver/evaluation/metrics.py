"""What is measured: each figure with its definition, where it comes from, and what a file must hold for it."""

from __future__ import annotations

from typing import Literal, NamedTuple

Needs = Literal["objects", "labels", "sizes", "room", "openings", "prompts", "reference", "physics", "several"]
"""What a figure cannot do without: what objects are, their sizes, the room's outline, its doors and windows, an
annotated request, a reference set, a simulation, several scenes."""

PAPER = "SceneWeaver (table of quantitative results): #Obj, #OB, #CN"
SCENE_EVAL = "SceneEval (Tam et al. 2025), github.com/3dlg-hcvc/SceneEval"
SCENE_SMITH = "SceneSmith, github.com/nepfaff/scenesmith: static equilibrium, 5 s, 1 cm and 0.1 rad"
PHY_SCENE = "PhyScene (Yang et al. 2024), scripts/eval"
OWN = "this library's judge, sceneweaver.check"


class Metric(NamedTuple):
    """A figure of a system: the sum of a numerator over its scenes, divided by the sum of a denominator.

    ``better`` is "more", "less" or "" where neither is; ``unit`` is "share", "m", "mm", "nat" or "" for a count.
    """

    key: str
    title: str
    unit: str
    better: str
    needs: tuple[Needs, ...]
    definition: str
    source: str

    @property
    def of_set(self) -> bool:
        """Whether it is one of a set of scenes, and not a mean over them."""
        return self.key in OF_SETS


OF_SETS = frozenset(("category_kl", "category_diversity", "layout_diversity", "depth_p50", "depth_p95", "depth_most"))
"""Figures that are no ratio of sums over scenes."""

_SOLID: tuple[Needs, ...] = ("sizes",)
_INSIDE: tuple[Needs, ...] = ("sizes", "room")

METRICS = (
    Metric("objects", "#Obj", "", "", ("objects",), "Objects in a scene, on average.", PAPER),
    Metric(
        "out_of_bounds",
        "#OB",
        "",
        "less",
        _INSIDE,
        "Objects of a scene that leave the room by more than 1 mm: through a wall, the ceiling or (what hangs) the "
        "floor. The paper names no tolerance.",
        f"{PAPER}; {OWN}",
    ),
    Metric(
        "collisions",
        "#CN",
        "",
        "less",
        _SOLID,
        "Pairs of objects of a scene that penetrate each other deeper than 1 mm and share more than 1 cm3 or 1 % of "
        "the smaller. The paper names no tolerance.",
        f"{PAPER}; {OWN}",
    ),
    Metric(
        "clean_scenes",
        "scenes without either",
        "share",
        "more",
        _INSIDE,
        "Scenes in which nothing collides and nothing is out of bounds (#OB = #CN = 0).",
        OWN,
    ),
    Metric(
        "penetrating_objects",
        "penetrating objects",
        "share",
        "less",
        _SOLID,
        "Objects that take part in a penetration deeper than 1 mm, of all objects of all scenes.",
        f"{SCENE_EVAL}: objects in collision, of which each pair is moved apart by 5 mm and tried again; here 1 mm",
    ),
    Metric(
        "penetrating_scenes",
        "penetrating scenes",
        "share",
        "less",
        _SOLID,
        "Scenes with a pair of objects that penetrate deeper than 1 mm.",
        f"{SCENE_EVAL}: scene in collision; here 1 mm",
    ),
    Metric("depth_p50", "depth, median", "mm", "less", _SOLID, "Median depth of all penetrations over 1 mm.", OWN),
    Metric("depth_p95", "depth, 95 %", "mm", "less", _SOLID, "95th percentile of their depths.", OWN),
    Metric("depth_most", "depth, most", "mm", "less", _SOLID, "The deepest penetration of all scenes.", OWN),
    Metric(
        "stable_objects",
        "stable",
        "share",
        "more",
        ("sizes", "physics"),
        "Objects that may move and, after 5 s of MuJoCo, are within 1 cm and 0.1 rad of where they were put, of all "
        "that may move; what hangs and what is fixed is held. In a scene whose simulation diverges, none.",
        f"{SCENE_SMITH}; simulated there by Drake",
    ),
    Metric(
        "supported_objects",
        "supported",
        "share",
        "more",
        _SOLID,
        "Objects whose underside touches the floor or another's top within 5 mm so that their middle lies over the "
        "hull of the contact; what hangs touches a wall or the ceiling within 5 mm.",
        f"{SCENE_EVAL}: support; rays there, exact areas of convex parts here, and the file or its geometry says what "
        "holds an object where SceneEval asks a vision model",
    ),
    Metric(
        "navigability",
        "navigability",
        "share",
        "more",
        _INSIDE,
        "Largest connected free area for a base of 0.25 m, of all area that is free for it, on a grid of 5 cm; solids "
        "between 2 cm and 1.8 m above the floor are in the way, rugs are not.",
        f"{PHY_SCENE}/walkable_metric.py (base of 0.3 m); {SCENE_EVAL}: navigability (0.2 m, rugs in the way)",
    ),
    Metric(
        "accessibility",
        "accessibility",
        "share",
        "more",
        ("labels", "sizes", "room"),
        "Of each thing on the floor that is used from a side: how much of a strip of 0.2 m, 5 cm before that side, is "
        "floor of the room without another's box; of several sides the best. Mean over the things.",
        f"{SCENE_EVAL}: accessibility; the taxonomy says which sides, where SceneEval asks a language model",
    ),
    Metric(
        "openings_clear",
        "openings clear",
        "share",
        "more",
        ("sizes", "room", "openings"),
        "Doors and windows with nothing in the space before them (as deep as a door is wide; 0.5 m before a window; as "
        "high as the opening). What is walked on, and what dresses a window, does not count.",
        f"{SCENE_EVAL}: opening clearance",
    ),
    Metric(
        "openings_covered",
        "openings covered",
        "share",
        "less",
        ("sizes", "room", "openings"),
        "Of the area of doors and windows what is covered by the things in the space before them. Mean over openings.",
        f"{SCENE_EVAL}: opening clearance, total occlusion",
    ),
    Metric(
        "counts_met",
        "counts (CNT)",
        "share",
        "more",
        ("labels", "prompts"),
        "Lines of ObjCount that hold: as many objects of the category as asked.",
        f"{SCENE_EVAL}: CNT; the taxonomy matches objects, where SceneEval asks a vision model",
    ),
    Metric(
        "attributes_met",
        "attributes (ATR)",
        "share",
        "more",
        ("labels", "prompts"),
        "Lines of ObjAttr that hold, of those that a scene file can tell (size, colour, material, style, shape); a "
        "missing object fails.",
        f"{SCENE_EVAL}: ATR; this library's critic judges",
    ),
    Metric(
        "object_relations_met",
        "object relations (OOR)",
        "share",
        "more",
        ("labels", "prompts", "sizes"),
        "Lines of OORel that hold: as many groups of objects as asked stand to each other as said.",
        f"{SCENE_EVAL}: OOR; words mean what sceneweaver/rules/stated.yaml says",
    ),
    Metric(
        "room_relations_met",
        "room relations (OAR)",
        "share",
        "more",
        ("labels", "prompts", "sizes", "room"),
        "Lines of OARel that hold: as many objects as asked stand to walls, openings and the room as said.",
        f"{SCENE_EVAL}: OAR; words mean what sceneweaver/rules/stated.yaml says",
    ),
    Metric(
        "sizes_usual",
        "usual sizes",
        "share",
        "more",
        ("labels", "sizes"),
        "Objects of known categories of which depth, width and height are all in the usual range of the taxonomy.",
        "sceneweaver/assets/categories",
    ),
    Metric(
        "size_log_ratio",
        "size off by",
        "",
        "less",
        ("labels", "sizes"),
        "Absolute logarithm of the ratio of an extent to the nearest end of its usual range, 0 inside: mean over "
        "depth, width and height of objects of known categories (0.1 is about 10 %).",
        "sceneweaver/assets/categories",
    ),
    Metric(
        "category_kl",
        "category KL",
        "nat",
        "less",
        ("labels", "reference"),
        "Sum of p (log(p + 1e-6) - log(q + 1e-6)) over categories: p their frequencies in the reference set, q in the "
        "system's scenes.",
        f"{PHY_SCENE}/calc_ckl.py (CKL)",
    ),
    Metric(
        "category_diversity",
        "diversity of things",
        "share",
        "more",
        ("labels", "several"),
        "Mean over pairs of scenes of 1 - (sum of least counts) / (sum of largest counts) of categories: 0 where all "
        "scenes hold the same things.",
        OWN,
    ),
    Metric(
        "layout_diversity",
        "diversity of layouts",
        "share",
        "more",
        ("sizes", "several"),
        "Mean over pairs of scenes of 1 - intersection over union of what is covered in plan, each room's box scaled "
        "to 32 x 32 cells: 0 where all layouts are the same.",
        OWN,
    ),
)
"""All figures, in the order of the table."""

BY_KEY = {metric.key: metric for metric in METRICS}

ABSENT: dict[Needs, str] = {
    "objects": "no objects",
    "labels": "what objects are is not in the files",
    "sizes": "sizes are not in the files",
    "room": "the room's outline is not in the files",
    "openings": "doors and windows are not in the files",
    "prompts": "no annotated request (--prompts)",
    "reference": "no reference set (--reference)",
    "physics": "not simulated (--no-stability)",
    "several": "takes two scenes",
}
"""What to say where a figure lacks what it needs."""
