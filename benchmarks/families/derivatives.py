"""Derivatives by every kind of parameter beside finite differences of scenes that are compiled anew."""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache

import numpy as np
import warp as wp

import sceneweaver as sw
from benchmarks import rooms
from benchmarks.judging import Judge
from benchmarks.machine import resolve
from benchmarks.parallel import each
from benchmarks.results import Column, Result
from benchmarks.settings import Settings
from sceneweaver import problems
from sceneweaver.layout.parameters import KINDS

BOUND = 1e-3
ZOO = ("bedroom-small", "bedroom-tight", "children-twin", "dining-round", "living", "living-dining-L", "studio-U")
ZOO += ("bedroom-full-wall", "office-20", "gym-30", "lockers-wall-full", "restaurant-60")
EXAMPLES = ("bedroom", "living-room", "study")
MADE = (("rooms", 8, "L"), ("rooms", 10, "U"), ("packing", 12, None), ("bodies", 8, None), ("relations", 12, None))
LAYOUTS, QUICK_LAYOUTS = 4, 2
MOST, QUICK_MOST = 24, 4  # parameters of a kind that are looked at in one problem, drawn
STEP = {"relation": 8e-3, "size": 8e-3, "outline": 8e-3, "opening": 8e-3, "weight": 0.25, "term": 0.25}
DEGREES = 0.5
FLOOR = 0.1  # share of a kind's largest slope in a problem, below which errors are shares of that
LEAST = 0.01  # [m/m, m/rad] below which a slope is below what float32 leaves of a difference
FINE = 3e-4  # share of a slope, at least of `NOISY`, by which those over two steps may differ where no kink is near
NOISY = 0.33  # [m/m, m/rad]

COLUMNS = (
    Column("kind", "kind"),
    Column("problems", "problems", "count"),
    Column("samples", "samples", "count"),
    Column("sloped", "of which above 0.01", "count"),
    Column("kinks", "at kinks, left out", "count"),
    Column("lost", "without derivative", "count"),
    Column("median", "median error", "number"),
    Column("worst", "worst error", "number"),
    Column("where", "where"),
)


@wp.func
def near_the_middle(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    """A term to weigh: how far [m] from a point, less a share of the depth."""
    to = wp.vec2(a[0] - p[0], a[1] - p[1])  # pyright: ignore
    return wp.sqrt(wp.dot(to, to) + 1.0e-4) - 0.5 * size_a[0]  # pyright: ignore


@dataclass
class Compared:
    """Slopes of one kind in one problem: found and by differences [sample], and how many samples were left out."""

    name: str
    kind: str
    found: np.ndarray
    expected: np.ndarray
    labels: list[str]
    kinks: int
    lost: int

    @property
    def errors(self) -> np.ndarray:
        """Errors [sample] as shares of `sizes_of` the slopes."""
        return np.abs(self.found - self.expected) / sizes_of(self.expected)


def sizes_of(slopes: np.ndarray) -> np.ndarray:
    """What errors of slopes are shares of: their size, of small ones `FLOOR` times the largest, or `LEAST`."""
    size = np.abs(slopes)
    return np.maximum(size, max(LEAST, FLOOR * size.max(initial=0.0)))


@contextmanager
def user_term() -> Iterator[None]:
    """With a term of the user's own for chairs, desks and crates."""
    names = {o.category for scene in scenes().values() for o in scene.objects if o.mount == "floor"}
    sw.define_term("near the middle", residual=near_the_middle, subjects=names, params=(1.5, 1.0))
    try:
        yield
    finally:
        sw.undefine_term("near the middle")


@cache
def scenes() -> dict[str, sw.Scene]:
    """Twenty problems: rooms of ``tests/zoo``, examples, and rooms made by `sceneweaver.problems`."""
    found = {name: rooms.load(name) for name in ZOO}
    found |= {f"example {name}": sw.Scene.example(name) for name in EXAMPLES}
    for family, count, shape in MADE:
        case = problems.generate(family, count, 0.3, 1, shape=shape)
        found[case.name] = case.scene
    return found


def layouts(problem: sw.Problem, count: int, seed: int) -> np.ndarray:
    """Layouts in general position: half drawn from the relations, half near the given one, all shaken."""
    rng = np.random.default_rng(seed)
    drawn = problem.sample(seed, (count + 1) // 2)
    near = np.repeat(problem.home, count // 2, axis=0)
    poses = np.concatenate([drawn, near])
    noise = rng.normal(0.0, (0.06, 0.06, 0.0, 0.1), (count, *poses.shape[1:])).astype(np.float32)
    return poses + noise


def energies(problem: sw.Problem, poses: np.ndarray) -> np.ndarray:
    """The items' energies [B, M] in float64, whose differences lose less than those of sums."""
    return problem.residuals(poses)[0].astype(np.float64) ** 2 / 0.1


def compare(name: str, problem: sw.Problem, kind: str, poses: np.ndarray, most: int, seed: int = 0) -> Compared:
    """Slopes by parameters of one kind, as found and by central differences.

    A sample is a layout and a parameter. It is left out as lying at a kink where central differences over a step and
    over half of it are apart, or where the slopes ahead and behind do not come nearer to each other by half with half
    the step, as those of a smooth function do.
    """
    found = problem.parameter_gradient(poses, of=kind)[kind]
    base, mask = problem.parameters.values[kind], problem.parameters.mask[kind]
    places = [tuple(at) for at in np.argwhere(mask).tolist()]
    labels = problem.parameters.labels[kind][0]
    chosen = np.random.default_rng(seed).permutation(len(places))[:most]
    rows: list[tuple[np.ndarray, np.ndarray, np.ndarray, str]] = []
    here = energies(problem, poses)
    for i in chosen.tolist():
        step = DEGREES if labels[i].endswith("degrees") else STEP[kind]
        sides = []
        for h in (step, -step, step / 2, -step / 2):
            values = base.copy()
            values[places[i]] += h
            try:
                there = energies(problem.at({kind: values}), poses)
                # items come and go where a number is no longer that of a neighbour
                rise = (there - here).sum(1) if there.shape == here.shape else there.sum(1) - here.sum(1)
                sides.append(rise / h)
            except sw.InputError:  # an opening that would leave its wall, say
                break
        if len(sides) < 4:
            continue
        ahead, behind, half_ahead, half_behind = sides
        whole, half = 0.5 * (ahead + behind), 0.5 * (half_ahead + half_behind)
        bend = np.maximum(np.abs(whole - half), 0.5 * np.abs((ahead - behind) - 2.0 * (half_ahead - half_behind)))
        unit = np.degrees(1.0) if labels[i].endswith("degrees") else 1.0
        rows.append((unit * found[(slice(None), *places[i][1:])], unit * whole, unit * bend, labels[i]))
    if not rows:
        return Compared(name, kind, np.zeros(0), np.zeros(0), [], 0, 0)
    slopes, expected, bend = (np.stack([row[c] for row in rows]) for c in range(3))  # pyright: ignore[reportCallIssue, reportArgumentType]
    lost = np.isnan(slopes)
    kinks = ~lost & (bend > FINE * np.maximum(np.abs(expected), NOISY))
    used = ~lost & ~kinks
    names = [row[3] for row in rows]
    where = [names[i] for i, _ in np.argwhere(used).tolist()]
    return Compared(name, kind, slopes[used], expected[used], where, int(kinks.sum()), int(lost.sum()))


def one_of(name: str, kind: str, device: str, count: int, most: int, seed: int) -> tuple[Compared, float]:
    """One kind of parameter in one problem, and the processor time of the derivatives [s]."""
    with user_term():
        problem = sw.compile(scenes()[name], device=device)
        poses = layouts(problem, count, seed)
        began = time.process_time()
        problem.parameter_gradient(poses, of=kind)
        spent = time.process_time() - began
        return compare(name, problem, kind, poses, most, seed), spent


def run(settings: Settings, judge: Judge) -> Result:
    """All kinds in all problems."""
    about = (
        "Derivatives of the energy by parameters (`problem.parameter_gradient`) beside central differences of problems "
        f"compiled anew, in {len(scenes())} problems: rooms of `tests/zoo`, examples, and made ones. Errors are shares "
        f"of the slope, of slopes below {FLOOR:g} of the largest of their kind in a problem shares of that; angles are "
        "radians. Samples are left out as lying at kinks where differences over two steps disagree. Of a kind at most "
        f"{settings.count or MOST} parameters are looked at in a problem (`--count`); problems are shared out among "
        "`--jobs` processes."
    )
    result = Result("derivatives", "Derivatives", about)
    table = result.add("kinds", "Errors by kind of parameter", COLUMNS)
    most = QUICK_MOST if settings.quick else settings.count or MOST
    count = QUICK_LAYOUTS if settings.quick else LAYOUTS
    device = resolve(settings.device)
    names = sorted(scenes(), key=lambda name: -len(scenes()[name].objects))  # what takes longest begins first
    calls = [(name, kind, device, count, most, settings.seed) for name in names for kind in KINDS]
    one_of(names[-1], KINDS[0], device, 1, 1, 0)  # compiles the kernels, before processes would do so side by side
    measured = each(one_of, calls, settings.jobs)
    order = list(scenes())
    measured.sort(key=lambda found: order.index(found[0].name))
    found = {kind: [part for part, _ in measured if part.kind == kind] for kind in KINDS}
    spent = {kind: sum(seconds for part, seconds in measured if part.kind == kind) for kind in KINDS}
    for kind, parts in found.items():
        errors = np.concatenate([part.errors for part in parts])
        worst = max(parts, key=lambda part: part.errors.max(initial=0.0))
        at = int(worst.errors.argmax()) if worst.errors.size else 0
        table.rows.append(
            {
                "kind": kind,
                "problems": sum(part.errors.size > 0 for part in parts),
                "samples": errors.size,
                "sloped": sum(int((np.abs(part.expected) > LEAST).sum()) for part in parts),
                "kinks": sum(part.kinks for part in parts),
                "lost": sum(part.lost for part in parts),
                "median": float(np.median(errors)) if errors.size else 0.0,
                "worst": float(errors.max(initial=0.0)),
                "where": f"{worst.name}: {worst.labels[at]}" if worst.labels else "",
            }
        )
        if errors.max(initial=0.0) > BOUND:
            result.failures.append(f"{kind}: an error of {errors.max():.2g}; the bound is {BOUND:g}")
    spent_text = ", ".join(f"{kind} {seconds:.1f} s" for kind, seconds in spent.items())
    result.notes.append(f"First `parameter_gradient` of all problems, with its compiles: {spent_text} of process time.")
    return result
