"""What it is worth to choose among more valid layouts, and to recombine the best of them."""

from __future__ import annotations

import time
from dataclasses import replace
from statistics import fmean
from typing import Any

import numpy as np

from benchmarks.designs import PAPER
from benchmarks.drafts import Draft, draft
from benchmarks.judging import Judge
from benchmarks.parallel import each
from benchmarks.results import Column, Plot, Result
from benchmarks.settings import Settings
from benchmarks.signature import signatures
from sceneweaver.agent.executor import Outcome
from sceneweaver.critic import Review
from sceneweaver.layout import Solution, improve, refine
from sceneweaver.layout.solution import missing_points

COUNTS = (16, 64, 256, 1024, 4096)
FINALISTS = 10
GENERATIONS, CHILDREN, DRAWN = 4, 32, 64
COMPARED = 40  # valid layouts that kernel and critic both rate
FEWEST = 8  # valid layouts from which a correlation is told
ATTEMPTS = 2  # as the agent's

ROOM, COUNT = Column("room", "room"), Column("candidates", "candidates")
CURVE = (
    ROOM,
    COUNT,
    Column("valid", "valid", "count"),
    Column("points", "points lost, best", "number"),
    Column("finalists", "points lost, ten", "number"),
    Column("layout", "layout", "number"),
    Column("functionality", "functionality", "number"),
    Column("grade", "grade", "number"),
    Column("before", "grade without choice", "number"),
    Column("worth", "worth", "number"),
    Column("worth_before", "worth without choice", "number"),
    Column("signatures", "signatures of ten", "count"),
    Column("seconds", "CPU seconds", "number"),
)
MEANS = (COUNT, *(replace(c, form="number") for c in CURVE[3:-1]), Column("rooms", "rooms", "count"))
AGREEMENT = (
    ROOM,
    Column("layouts", "layouts", "count"),
    Column("layout", "layout", "number"),
    Column("functionality", "functionality", "number"),
    Column("both", "both", "number"),
    Column("worth", "worth", "number"),
    Column("spread", "spread of grades", "number"),
)
IMPROVED = f"{DRAWN} + {GENERATIONS} x {CHILDREN}"


def run(settings: Settings, judge: Judge) -> Result:
    """Curves of quality over the number of candidates for the ten kinds of rooms."""
    del judge
    result = Result(
        "choice",
        "Choice among valid layouts",
        "The first draft of each kind of room, laid out by more and more candidates. Points lost: what the terms of "
        "design quality take off, for the best layout and as the mean of the ten that the critic sees (the best of "
        "each signature). Grade: the critic's mean of layout and functionality of the layout that it likes best among "
        "them; without choice the ten come as the relations rank them. Worth: what the agent ranks by, the mean of all "
        "grades less what soft relations that fail take off, of the best of the ten. Signatures: how many of the ten "
        "differ in the wall, the 0.5 m cell or the eighth of a turn of some piece. "
        f"The row {IMPROVED}: {DRAWN} candidates, and {GENERATIONS} generations of {CHILDREN} recombined ones.",
    )
    names = settings.kinds or tuple(PAPER)[: 1 if settings.quick else None]
    if min(settings.jobs, len(names)) > 1:  # kernels are compiled here, and not by every process
        _of_room("bathroom", replace(settings, quick=True, most=FINALISTS))
    columns = each(_of_room, [(name, settings) for name in names], settings.jobs)
    curve, agreement = ([row for rows in column for row in rows] for column in zip(*columns, strict=True))
    result.add("curve", "Quality over candidates", CURVE, keys=2, detail=len(names) > 1).rows = curve
    lacking = {r["room"] for r in curve if None in (r["grade"], r["before"])}
    means = [
        {"candidates": count, **{c.key: fmean(r[c.key] for r in found) for c in MEANS[1:-1]}, "rooms": len(found)}
        for count in dict.fromkeys(r["candidates"] for r in curve)
        if (found := [r for r in curve if r["candidates"] == count and r["room"] not in lacking])
    ]
    result.add("means", "Means over rooms with valid layouts in every row", MEANS).rows = means
    result.add(
        "agreement", "Rank correlation of points lost with what the critic takes off", AGREEMENT
    ).rows = agreement
    drawn = [row for row in means if isinstance(row["candidates"], int)]
    result.add("drawn", "Means over drawn candidates", MEANS, detail=True).rows = drawn
    for key, title in (("points", "Points lost of the best layout"), ("grade", "Critic's grade")):
        y = (key,) if key == "points" else ("grade", "before")
        result.plots.append(Plot(f"choice-{key}", title, "drawn", "candidates", y, log_x=True, page=True))
    result.notes.append(
        f"Without a valid layout in some row, and so left out of the means: {', '.join(sorted(lacking)) or 'none'}. "
        "Spearman's correlation over valid layouts drawn at random of all, soft relations that "
        "fail included on both sides; 1: the same order. Spread: the standard deviation of the critic's grades there; "
        "where it is small there is little to agree on."
    )
    return result


def _of_room(name: str, settings: Settings) -> tuple[list[dict[str, Any]], list[dict[str, Any]]]:
    """The rows of one kind of room: its curve, and how far terms and critic agree."""
    made = draft(name, settings.seed)
    solution, rows = _curve(name, made, settings)
    return [*rows, _improved(name, made, solution, settings)], _agreement(name, made, solution)


class Critic:
    """The critic's word on a solution's candidates, each asked for once."""

    def __init__(self, made: Draft, solution: Solution) -> None:
        """``solution`` is of the draft's plain scene."""
        self._made, self._solution = made, solution
        self._kept: dict[int, tuple[Review, float] | None] = {}

    def review(self, candidate: int) -> tuple[Review, float] | None:
        """The review and what the layout is worth to the agent; None where the judge finds fault with it."""
        if candidate not in self._kept:
            scene = self._solution.scene(candidate)
            report, review = self._made.judged(scene)
            worth = -Outcome(scene, report, review).key[-1]
            self._kept[candidate] = (review, worth) if report.valid else None
        return self._kept[candidate]

    def best(self, candidates: list[int]) -> tuple[Review | None, float | None]:
        """The best review among some, and the most that one of them is worth."""
        found = [r for i in candidates if (r := self.review(i)) is not None]
        return max((review for review, _ in found), key=_grade, default=None), max((w for _, w in found), default=None)


def _grade(review: Review) -> float:
    return (review.grades["layout"] + review.grades["functionality"]) / 2


def _curve(name: str, made: Draft, settings: Settings) -> tuple[Solution, list[dict[str, Any]]]:
    """All candidates are refined at once: the first n are what n alone would be."""
    most = settings.size(COUNTS[-1], COUNTS[1])
    began = time.process_time()
    solution = refine(
        made.plain,
        candidates=most,
        seed=settings.seed,
        device=settings.device,
        steps=ATTEMPTS,
        snap=True,
        quality=made.terms,
    )
    spent = time.process_time() - began
    critic = Critic(made, solution)
    counts = [n for n in COUNTS if n <= most] or [most]
    return solution, [_row(name, n, _first(solution, n), critic, spent * n / most) for n in counts]


def _first(solution: Solution, count: int) -> Solution:
    """The first candidates of a solution. Its walkable floor is known of the best of all only, so that is left out."""
    arrays = ("poses", "status", "relations", "energy", "quality")
    nothing = np.full(count, np.nan, dtype=np.float32)
    return replace(solution, walkable=nothing, **{key: getattr(solution, key)[:count] for key in arrays})


def _row(name: str, count: int | str, solution: Solution, critic: Critic, seconds: float) -> dict[str, Any]:
    row: dict[str, Any] = dict.fromkeys((c.key for c in CURVE), None)
    row |= {"room": name, "candidates": count, "valid": len(solution.ranked), "seconds": seconds}
    if not len(solution.ranked):
        return row
    chosen = solution.best_candidates(FINALISTS)
    plain = replace(solution, quality=None).best_candidates(FINALISTS)
    (best, row["worth"]), (before, row["worth_before"]) = critic.best(chosen), critic.best(plain)
    assert solution.quality is not None
    row |= {
        "points": -float(solution.quality[chosen[0]]),
        "finalists": -float(solution.quality[chosen].mean()),
        "signatures": len(np.unique(signatures(solution.source, solution.poses[chosen]), axis=0)),
    }
    for key, review in (("grade", best), ("before", before)):
        row[key] = None if review is None else _grade(review)
    if best is not None:
        row |= {key: best.grades[key] for key in ("layout", "functionality")}
    return row


def _improved(name: str, made: Draft, solution: Solution, settings: Settings) -> dict[str, Any]:
    first = _first(solution, min(DRAWN, solution.candidates))
    began = time.process_time()
    found = improve(first, made.terms, candidates=CHILDREN, generations=GENERATIONS, steps=ATTEMPTS, snap=True)
    spent = time.process_time() - began
    return _row(name, IMPROVED, found, Critic(made, found), spent)


def _agreement(name: str, made: Draft, solution: Solution) -> list[dict[str, Any]]:
    """Whether what the kernels take off and what the critic takes off rank layouts alike."""
    from scipy.stats import spearmanr

    assert solution.quality is not None
    valid = np.flatnonzero(solution.status == 0)
    some = np.random.default_rng(0).permutation(valid)[:COMPARED]
    critic = Critic(made, solution)
    lost = missing_points(solution.source, solution.relations)
    rows = [(float(solution.quality[i] - lost[i]), r) for i in some if (r := critic.review(int(i))) is not None]
    if len(rows) < FEWEST:
        return []
    points = [p for p, _ in rows]
    grades = {key: [r.grades[key] for _, (r, _) in rows] for key in ("layout", "functionality")}
    grades |= {"both": [_grade(r) for _, (r, _) in rows], "worth": [worth for _, (_, worth) in rows]}

    def correlation(values: list[float]) -> float | None:
        return float(np.asarray(spearmanr(points, values)[0])) if np.ptp(values) > 0 and np.ptp(points) > 0 else None

    found = {key: correlation(values) for key, values in grades.items()}
    return [{"room": name, "layouts": len(rows), **found, "spread": float(np.std(grades["both"]))}]
