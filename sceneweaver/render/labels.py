"""Where labels go: inside their object where they fit, else beside it with a leader line, never over one another.

Works on a coarse grid of the picture whose cells say which object is on top. Objects are labelled in an order that
depends only on their size and id, so that the order in a file changes nothing.
"""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from sceneweaver.render.canvas import Point, line_height, text_width

CELL = 2  # pixels of the picture to a cell

# Owners of cells that no object covers.
PAPER_OWNER, FLOOR_OWNER, WALL_OWNER, MARK_OWNER = -1, 0, -2, -3

_COST_PAPER, _COST_FLOOR, _COST_WALL, _COST_OTHER, _COST_KIN, _COST_EDGE = 0.06, 0.0, 0.7, 1.0, 0.25, 2.5
_CLEAR, _MAX_COVER = 0.12, 0.5  # a label beside its object may cost this much per cell, at best and at most


@dataclass(frozen=True)
class Wanted:
    """An object that wants a label: its owner number in the grid, its outline's centre and its text."""

    key: str
    owner: int
    category: str
    text: str
    center: Point
    area: float
    below: int = 0  # the owner number of the object that it stands on, if any


@dataclass(frozen=True)
class Placed:
    """Lines of text centred at ``at``, on the object or beside it; a ``leader`` is a line from there to the object."""

    key: str
    lines: tuple[str, ...]
    at: Point
    size: int
    upright: bool = False
    beside: bool = False
    leader: tuple[Point, Point] | None = None


@dataclass(frozen=True)
class Labelling:
    """All placed labels, with how many objects show only their number and how many nothing."""

    placed: tuple[Placed, ...]
    numbered: int
    left_out: int


def place(
    wanted: Sequence[Wanted], owners: np.ndarray, edges: np.ndarray, sizes: Sequence[int], crowd: int = 24
) -> Labelling:
    """Place labels on a grid of owners [rows, columns]; ``sizes`` are font sizes, largest first.

    ``edges`` marks cells on outlines, which labels cross only where they must. When more than ``crowd`` labels do not
    fit inside their objects, the categories concerned show numbers alone.
    """
    grid = _Grid(owners, edges)
    order = sorted(wanted, key=lambda w: (-round(w.area, 1), w.key))
    fits = {w.key: grid.fit(w, sizes) for w in order}
    crowded = sum(fit is None for fit in fits.values()) > crowd
    by_number = _by_number(order, fits) if crowded else frozenset()
    placed: list[Placed] = []
    rest: list[Wanted] = []
    numbered = left_out = 0
    for w, fit in _calm(grid, order, fits, by_number, sizes):
        if fit is None:
            rest.append(w)
            continue
        numbered += w.category in by_number
        placed.append(fit)
        grid.take(fit)
    for w in rest:
        size = sizes[-1] if crowded else round((sizes[-1] + sizes[-2]) / 2)
        # On the free floor beside the object, else across the lines on it, else wherever it covers least.
        fit = grid.beside(w, size, _CLEAR) or grid.fit(w, sizes, cross_edges=True) or grid.beside(w, size, _MAX_COVER)
        if fit is None:
            left_out += 1
        else:
            placed.append(fit)
            grid.take(fit)
    return Labelling(tuple(placed), numbered, left_out)


def _by_number(order: Sequence[Wanted], fits: dict[str, Placed | None]) -> frozenset[str]:
    """The categories of which a good part have no room for their names."""
    members = Counter(w.category for w in order)
    failed = Counter(w.category for w in order if fits[w.key] is None)
    return frozenset(name for name, count in failed.items() if count > 1 and count >= 0.2 * members[name])


def _calm(
    grid: _Grid,
    order: Sequence[Wanted],
    fits: dict[str, Placed | None],
    by_number: frozenset[str],
    sizes: Sequence[int],
) -> Iterator[tuple[Wanted, Placed | None]]:
    """Labels inside their objects, with one size for all of a category: the smallest that any of them needs."""
    small = (sizes[-1], max(7, round(sizes[-1] * 0.8)))
    for w in order:
        if w.category in by_number:
            fits[w.key] = grid.fit_number(w, small)
    least: dict[str, int] = {}
    for w in order:
        fit = fits[w.key]
        if fit is not None:
            least[w.category] = min(least.get(w.category, fit.size), fit.size)
    for w in order:
        fit = fits[w.key]
        if fit is not None and fit.size > least[w.category]:
            if w.category in by_number:
                fit = grid.fit_number(w, (least[w.category],)) or fit
            else:
                fit = grid.fit(w, sizes, least[w.category]) or fit
        yield w, fit


def split(text: str) -> tuple[str, str] | None:
    """A name in two lines of about equal length, cut after an underscore or before a hyphen."""
    cuts = [m.end() for m in re.finditer(r"[_ ](?=.)", text)] + [m.start() for m in re.finditer(r"(?<=.)-", text)]
    if not cuts:
        return None
    at = min(cuts, key=lambda c: (abs(2 * c - len(text)), c))
    return text[:at].rstrip(), text[at:].lstrip()


def shortened(text: str, size: int, width: float) -> str:
    """The text with its middle left out so that it is at most ``width`` pixels wide."""
    if text_width(text, size) <= width:
        return text
    low, high, short = 1, len(text), text[:1] + "…"  # of the characters that are kept: what fits, and what does not
    while high - low > 1:
        keep = (low + high) // 2
        tail = min(keep // 3, 6)
        tried = text[: keep - tail].rstrip() + "…" + text[len(text) - tail :]
        if text_width(tried, size) <= width:
            low, short = keep, tried
        else:
            high = keep
    return short


def _forms(text: str, sizes: Sequence[int], tall: float) -> list[tuple[int, tuple[str, ...], bool]]:
    """Ways to write a label (size, lines, upright), the preferred first: large and level before small or upright.

    ``tall`` is the height of the place over its width; only tall places get upright text.
    """
    one, two = (text,), split(text)
    forms: list[tuple[int, tuple[str, ...], bool]] = []
    for size in sizes[:2]:
        forms.append((size, one, False))
        if tall >= 1.6:
            forms.append((size, one, True))
    forms += [(size, two, False) for size in sizes[:2] if two is not None]
    for size in sizes[2:]:
        forms.append((size, one, False))
        if tall >= 1.15:
            forms += [(s, one, True) for s in (*sizes[:2], size)]
        if two is not None:
            forms.append((size, two, False))
    return forms


class _Grid:
    """Cells of the picture with their owners, and which of them labels have taken."""

    def __init__(self, owners: np.ndarray, edges: np.ndarray) -> None:
        self.owners, self.edges = owners, edges
        self.taken = np.zeros(owners.shape, dtype=bool)
        self.cost = np.full(owners.shape, _COST_OTHER, dtype=np.float32)
        self.cost[owners == PAPER_OWNER] = _COST_PAPER
        self.cost[owners == FLOOR_OWNER] = _COST_FLOOR
        self.cost[owners == WALL_OWNER] = _COST_WALL
        self._boxes = _boxes(owners)

    def fit(self, w: Wanted, sizes: Sequence[int], most: int | None = None, cross_edges: bool = False) -> Placed | None:
        """The best label, of size ``most`` at most, that lies fully on the visible part of its object."""
        box = self._boxes.get(w.owner)
        if box is None:
            return None
        tall = (box[1] - box[0]) / (box[3] - box[2])
        own = self._own(w, cross_edges)
        for size, lines, upright in _forms(w.text, sizes, tall):
            found = self._inside(own, lines, size, upright) if most is None or size <= most else None
            if found is not None:
                return Placed(w.key, lines, found, size, upright)
        return None

    def fit_number(self, w: Wanted, sizes: Sequence[int]) -> Placed | None:
        """The number at the end of the name, on its object."""
        match = re.search(r"\d+$", w.text)
        if match is None or w.owner not in self._boxes:
            return None
        for cross_edges in (False, True):
            own = self._own(w, cross_edges)
            for size in sizes:
                found = self._inside(own, (match.group(),), size, upright=False, margin=2)
                if found is not None:
                    return Placed(w.key, (match.group(),), found, size)
        return None

    def beside(self, w: Wanted, size: int, most: float) -> Placed | None:
        """A label near its object with a leader line, where it costs ``most`` per cell at most."""
        text = shortened(w.text, size, 14 * size)
        cols, rows = _cells(text_width(text, size) + 8), _cells(line_height(size) + 4)
        reach = _cells(6.5 * size) + cols // 2
        cx, cy = self._visible_center(w)
        left, top = max(0, int(cx) - reach - cols // 2), max(0, int(cy) - reach)
        right = min(self.owners.shape[1], int(cx) + reach + cols // 2)
        bottom = min(self.owners.shape[0], int(cy) + reach)
        if right - left < cols or bottom - top < rows:
            return None
        box = (slice(top, bottom), slice(left, right))
        cost = self.cost[box].copy()
        owners = self.owners[box]
        cost[(owners == w.owner) | ((owners == w.below) & (w.below > 0))] = _COST_KIN
        cost[self.edges[box]] += _COST_EDGE
        cover = window_sums(cost, rows, cols) / (rows * cols)
        blocked = window_sums(self.taken[box].astype(np.float32), rows, cols)
        y, x = np.mgrid[0 : cover.shape[0], 0 : cover.shape[1]].astype(np.float32)
        dx = np.maximum(np.abs(x + left + cols / 2 - cx) - cols / 2, 0)
        dy = np.maximum(np.abs(y + top + rows / 2 - cy) - rows / 2, 0)
        # A gentle pull to the middle breaks ties between equal places.
        distance = np.hypot(dx, dy) + 0.08 * np.abs(x + left + cols / 2 - cx)
        score = cover * 70 + distance * (CELL / size * 2.2)
        score[(blocked > 0) | (cover > most)] = np.inf
        best = int(np.argmin(score))
        if not np.isfinite(score.flat[best]):
            return None
        row, col = divmod(best, score.shape[1])
        x0, y0 = (left + col) * CELL, (top + row) * CELL
        at = (x0 + cols * CELL / 2, y0 + rows * CELL / 2)
        target = self._edge_toward(w, at)
        start = (
            min(max(target[0], x0 + 3), x0 + cols * CELL - 3),
            min(max(target[1], y0 + 2), y0 + rows * CELL - 2),
        )
        far = math.dist(start, target) > 0.35 * size
        return Placed(w.key, (text,), at, size, beside=True, leader=(start, target) if far else None)

    def take(self, label: Placed) -> None:
        """Mark the cells of a placed label and its leader."""
        self.taken[cells(*box_of(label))] = True
        if label.leader is not None:
            (ax, ay), (bx, by) = label.leader
            count = max(2, int(math.dist(*label.leader) / CELL))
            xs = np.clip(np.linspace(ax, bx, count) / CELL, 0, self.taken.shape[1] - 1).astype(int)
            ys = np.clip(np.linspace(ay, by, count) / CELL, 0, self.taken.shape[0] - 1).astype(int)
            self.taken[ys, xs] = True

    def _own(self, w: Wanted, cross_edges: bool) -> tuple[np.ndarray, int, int]:
        """The free visible cells of an object within their bounding box, and its upper left cell."""
        top, bottom, left, right = self._boxes[w.owner]
        box = (slice(top, bottom), slice(left, right))
        own = (self.owners[box] == w.owner) & ~self.taken[box]
        if not cross_edges:
            own &= ~self.edges[box]
        return own.astype(np.float32), top, left

    def _visible_center(self, w: Wanted) -> Point:
        """The middle of an object's visible cells, or its own middle when nothing is visible; in cells."""
        if w.owner not in self._boxes:
            return w.center[0] / CELL, w.center[1] / CELL
        own, top, left = self._own(w, cross_edges=True)
        ys, xs = np.nonzero(own)
        if not xs.size:
            return w.center[0] / CELL, w.center[1] / CELL
        return left + float(xs.mean()) + 0.5, top + float(ys.mean()) + 0.5

    def _edge_toward(self, w: Wanted, at: Point) -> Point:
        """A visible point of an object, a little inside its edge, on the side of ``at``; in pixels."""
        cx, cy = self._visible_center(w)
        if w.owner not in self._boxes:
            return cx * CELL, cy * CELL
        own, top, left = self._own(w, cross_edges=True)
        ys, xs = np.nonzero(own)
        if not xs.size:
            return cx * CELL, cy * CELL
        # Nearest to a point two thirds of the way from the label to the object's middle.
        near_x = cx + (at[0] / CELL - cx) * 0.3 - left - 0.5
        near_y = cy + (at[1] / CELL - cy) * 0.3 - top - 0.5
        best = int(np.argmin((xs - near_x) ** 2 + (ys - near_y) ** 2))
        px, py = left + float(xs[best]) + 0.5, top + float(ys[best]) + 0.5
        return (px + (cx - px) * 0.3) * CELL, (py + (cy - py) * 0.3) * CELL

    def _inside(
        self, own: tuple[np.ndarray, int, int], lines: tuple[str, ...], size: int, upright: bool, margin: int = 6
    ) -> Point | None:
        """Where a block of text fits on the given cells, as near as possible to their middle; in pixels."""
        mask, top, left = own
        long = _cells(max(text_width(line, size) for line in lines) + margin)
        short = _cells(line_height(size) * (len(lines) - 1) + size * 0.86 + margin / 2)
        rows, cols = (long, short) if upright else (short, long)
        if rows > mask.shape[0] or cols > mask.shape[1]:
            return None
        ys, xs = np.nonzero(window_sums(mask, rows, cols) > rows * cols - 0.5)
        if not xs.size:
            return None
        all_ys, all_xs = np.nonzero(mask)
        middle_x, middle_y = float(all_xs.mean()) + 0.5, float(all_ys.mean()) + 0.5
        best = int(np.argmin((xs + cols / 2 - middle_x) ** 2 + (ys + rows / 2 - middle_y) ** 2))
        x, y = float(xs[best]) + cols / 2, float(ys[best]) + rows / 2
        if math.hypot(x - middle_x, y - middle_y) < 1.5:
            x, y = middle_x, middle_y
        return (left + x) * CELL, (top + y) * CELL


def box_of(label: Placed) -> tuple[float, float, float, float]:
    """The rectangle that a label covers: left, top, right, bottom."""
    half_long = max(text_width(line, label.size) for line in label.lines) / 2 + 2
    half_short = line_height(label.size) * len(label.lines) / 2 + 1
    half_x, half_y = (half_short, half_long) if label.upright else (half_long, half_short)
    return (label.at[0] - half_x, label.at[1] - half_y, label.at[0] + half_x, label.at[1] + half_y)


def _boxes(owners: np.ndarray) -> dict[int, tuple[int, int, int, int]]:
    """Top, bottom, left and right of the visible cells of every object."""
    from scipy.ndimage import find_objects

    found = enumerate(find_objects(np.maximum(owners, 0)), 1)
    return {k: (box[0].start, box[0].stop, box[1].start, box[1].stop) for k, box in found if box is not None}


def cells(left: float, top: float, right: float, bottom: float) -> tuple[slice, slice]:
    """The rows and columns of cells that a rectangle of the picture touches [pixels]."""
    rows = slice(max(0, int(top / CELL)), max(0, math.ceil(bottom / CELL)))
    return rows, slice(max(0, int(left / CELL)), max(0, math.ceil(right / CELL)))


def _cells(pixels: float) -> int:
    return max(1, math.ceil(pixels / CELL))


def window_sums(values: np.ndarray, rows: int, cols: int) -> np.ndarray:
    """Sums of all windows of rows x cols cells."""
    table = np.zeros((values.shape[0] + 1, values.shape[1] + 1), dtype=np.float64)
    table[1:, 1:] = values.cumsum(0, dtype=np.float64).cumsum(1)
    return table[rows:, cols:] - table[:-rows, cols:] - table[rows:, :-cols] + table[:-rows, :-cols]
