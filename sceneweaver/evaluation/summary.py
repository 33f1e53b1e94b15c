"""The figures of a system from the rows of its scenes."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

import numpy as np

from .intervals import interval, ratio_of_sums
from .judge import SceneRow
from .metrics import ABSENT, METRICS, Metric
from .sets import category_diversity, category_kl, layout_diversity

MOST_NOTES = 12
"""Notes of a system that are kept, the commonest first."""

_PERCENTILES = {"depth_p50": 50.0, "depth_p95": 95.0, "depth_most": 100.0}
_NUMBERS = re.compile(r"\d+(\.\d+)?")


@dataclass(frozen=True)
class Figure:
    """A figure of a system.

    Attributes:
        value: it, in the unit of its metric; None where there is none.
        low, high: ends of its 95 % interval, by bootstrap over scenes; None for fewer than two scenes, and for figures
            that are no mean.
        scenes: how many scenes it is of.
        missing: why there is none.
        assumed: whether it rests on sizes that are in no file.
    """

    value: float | None
    low: float | None = None
    high: float | None = None
    scenes: int = 0
    missing: str = ""
    assumed: bool = False

    def text(self, metric: Metric) -> str:
        """For reading: "not in the files" and its like where there is none."""
        if self.value is None:
            return self.missing
        shown = number_text(self.value, metric)
        if self.low is not None and self.high is not None:
            shown += f" ({number_text(self.low, metric)} to {number_text(self.high, metric)})"
        return f"~ {shown}" if self.assumed else shown


def number_text(value: float, metric: Metric) -> str:
    """A number in the unit of a metric: shares in percent."""
    if metric.unit == "share":
        return f"{100 * value:.1f} %"
    if metric.unit == "mm":
        return f"{value:.0f} mm" if value >= 10 else f"{value:.1f} mm"  # noqa: PLR2004 - two digits are enough
    return f"{value:.2f}"


@dataclass(frozen=True)
class Evaluation:
    """What the scenes of one system are worth, all by the same judge.

    Attributes:
        name: of the system.
        figures: by the key of each metric.
        rows: of the scenes that were judged, in their order.
        refused: a line for each file that could not be read.
        formats: how many scenes are of each format.
        notes: what was assumed or left out in reading, with the number of scenes.
        cut_off: whether time was up before all scenes were judged.

    Examples:
        >>> import sceneweaver as sw
        >>> found = sw.evaluate(sw.Scene.example("bedroom"), stability=False)
        >>> found.figures["collisions"].value, found.figures["stable_objects"].missing
        (0.0, 'not simulated (--no-stability)')
    """

    name: str
    figures: Mapping[str, Figure]
    rows: tuple[SceneRow, ...] = ()
    refused: tuple[str, ...] = ()
    formats: Mapping[str, int] = field(default_factory=dict)
    notes: tuple[tuple[str, int], ...] = ()
    cut_off: bool = False

    @property
    def judged(self) -> int:
        """Scenes of which something was measured."""
        return sum(not row.error for row in self.rows)

    @property
    def failed(self) -> tuple[SceneRow, ...]:
        """Scenes of which nothing was."""
        return tuple(row for row in self.rows if row.error)

    @property
    def lacks(self) -> dict[str, int]:
        """What files do not say and why else figures are missing, with the number of scenes, the most first."""
        counts = Counter(why for row in self.rows for why in dict.fromkeys((*row.lacks, *row.missing.values())))
        return dict(counts.most_common())

    def to_dict(self) -> dict[str, Any]:
        """Plain JSON data, without the rows."""
        return {
            "name": self.name,
            "scenes": self.judged,
            "failed": [{"scene": row.scene, "error": row.error} for row in self.failed],
            "refused": list(self.refused),
            "cut_off": self.cut_off,
            "formats": dict(self.formats),
            "figures": {key: _plain(figure) for key, figure in self.figures.items()},
            "lacks": self.lacks,
            "notes": [{"note": note, "scenes": scenes} for note, scenes in self.notes],
        }


def _plain(figure: Figure) -> dict[str, Any]:
    data = asdict(figure)
    if figure.value is not None:
        del data["missing"]
    if not figure.assumed:
        del data["assumed"]
    return data


def summed(
    name: str,
    rows: Sequence[SceneRow],
    *,
    reference: Sequence[Mapping[str, int]] | None = None,
    refused: Sequence[str] = (),
    cut_off: bool = False,
) -> Evaluation:
    """The figures of some rows.

    Args:
        name: of the system.
        rows: of its scenes.
        reference: categories of the scenes of the reference set; None: there is none.
        refused: a line for each file that could not be read.
        cut_off: whether time was up before all were judged.
    """
    good = [row for row in rows if not row.error]
    return Evaluation(
        name,
        {metric.key: _figure(metric, good, reference) for metric in METRICS},
        tuple(rows),
        tuple(refused),
        dict(Counter(row.format for row in good)),
        _notes(good),
        cut_off,
    )


def _figure(metric: Metric, rows: Sequence[SceneRow], reference: Sequence[Mapping[str, int]] | None) -> Figure:
    if not rows:
        return Figure(None, missing="no scene was judged")
    if metric.of_set:
        return _of_set(metric, rows, reference)
    having = [row for row in rows if metric.key in row.figures]
    if not having:
        return Figure(None, missing=_reason(metric.key, rows))
    top, bottom = np.array([row.figures[metric.key] for row in having], dtype=float).T
    ends = interval(top, bottom)
    low, high = ends if ends is not None else (None, None)
    return Figure(ratio_of_sums(top, bottom), low, high, len(having), assumed=_assumed(metric, having))


def _assumed(metric: Metric, rows: Sequence[SceneRow]) -> bool:
    return "sizes" in metric.needs and not metric.key.startswith("size") and any(row.guessed for row in rows)


def _reason(key: str, rows: Sequence[SceneRow]) -> str:
    """Why no scene has a figure: the commonest reason."""
    counts = Counter(row.missing[key] for row in rows if key in row.missing)
    return counts.most_common(1)[0][0] if counts else "not measured"


def _of_set(metric: Metric, rows: Sequence[SceneRow], reference: Sequence[Mapping[str, int]] | None) -> Figure:
    having = [row for row in rows if metric.key not in row.missing]
    if metric.key == "category_kl" and reference is None:
        return Figure(None, missing=ABSENT["reference"])
    if not having:
        return Figure(None, missing=_reason(metric.key, rows))
    count, assumed = len(having), _assumed(metric, having)
    if metric.key == "category_kl":
        found = category_kl(reference or (), [row.categories for row in having])
        if found is None:
            return Figure(None, missing="no object to compare")
        low, high = found[1] if found[1] is not None else (None, None)
        return Figure(found[0], low, high, count)
    if metric.key in ("category_diversity", "layout_diversity"):
        by_things = metric.key == "category_diversity"
        value = (
            category_diversity([row.categories for row in having])
            if by_things
            else layout_diversity([row.plan for row in having])
        )
        return Figure(value, scenes=count, missing="" if value is not None else ABSENT["several"], assumed=assumed)
    depths = [depth for row in having for depth in row.depths]
    if not depths:
        return Figure(None, scenes=count, missing="nothing penetrates")
    return Figure(float(np.percentile(depths, _PERCENTILES[metric.key])), scenes=count, assumed=assumed)


def _notes(rows: Sequence[SceneRow]) -> tuple[tuple[str, int], ...]:
    """Notes of the rows, those that differ in names and numbers alone taken together."""
    kinds: dict[str, list[str]] = {}
    for row in rows:
        for kind, note in {_kind(note): note for note in row.notes}.items():
            kinds.setdefault(kind, []).append(note)
    common = sorted(kinds.values(), key=lambda notes: (-len(notes), notes[0]))[:MOST_NOTES]
    return tuple((notes[0] if len(notes) == 1 else f"such as: {notes[0]}", len(notes)) for notes in common)


def _kind(note: str) -> str:
    """What a note is about: of "of assumed size: sink, stove" the first part, of "bed: taken for a sofa" the second."""
    before, colon, after = note.partition(": ")
    said = before if colon and " " in before else after or before
    return _NUMBERS.sub("#", said)
