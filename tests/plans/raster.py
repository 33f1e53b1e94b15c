"""The second reading of plans: rooms as pixels of 50 mm, counted. Slow, short, and shares nothing with the checker."""

from __future__ import annotations

from collections import deque

import numpy as np

from sceneweaver.home import Home, HomeRoom

P = 50
"""A pixel [mm]."""

MARGIN = 32
"""Pixels around the plan."""


class Raster:
    """A storey as pictures: ``rooms[id]`` is True where the room's floor is."""

    def __init__(self, home: Home, storey: str) -> None:
        self.home = home
        self.members = home.rooms_of(storey)
        corners = np.array([p for room in home.rooms for p in room.outline]) * 1000
        self.origin = np.round(corners.min(0)).astype(int) - MARGIN * P
        self.shape = (np.round(corners.max(0)).astype(int) + MARGIN * P - self.origin) // P
        self.rooms = {room.id: self._filled(room) for room in self.members}

    def _filled(self, room: HomeRoom) -> np.ndarray:
        """Even-odd rule at the middles of the pixels."""
        x = self.origin[0] + P * (np.arange(self.shape[0]) + 0.5)
        y = self.origin[1] + P * (np.arange(self.shape[1]) + 0.5)
        inside = np.zeros(tuple(self.shape), bool)
        points = [(round(a * 1000), round(b * 1000)) for a, b in room.outline]
        for (ax, ay), (bx, by) in zip(points, points[1:] + points[:1], strict=True):
            if ax == bx:
                inside ^= (x[:, None] > ax) & (y[None, :] > min(ay, by)) & (y[None, :] < max(ay, by))
        return inside

    def pixel(self, x: float, y: float) -> tuple[int, int]:
        """The line of pixels at a point [m]."""
        return round((x * 1000 - self.origin[0]) / P), round((y * 1000 - self.origin[1]) / P)

    def ahead(self, room: HomeRoom, wall: int, offset: float, width: float, depth: float) -> np.ndarray:
        """The pixels before an opening, out of the room."""
        (ax, ay), (bx, by) = room.outline[wall], room.outline[(wall + 1) % len(room.outline)]
        length = abs(ax - bx) + abs(ay - by)
        tx, ty = (bx - ax) / length, (by - ay) / length
        p = (ax + tx * offset, ay + ty * offset)
        q = (p[0] + tx * width + ty * depth, p[1] + ty * width - tx * depth)
        (i0, j0), (i1, j1) = self.pixel(*p), self.pixel(*q)
        picture = np.zeros(tuple(self.shape), bool)
        picture[min(i0, i1) : max(i0, i1), min(j0, j1) : max(j0, j1)] = True
        return picture


def grown(picture: np.ndarray, by: int) -> np.ndarray:
    """Every pixel that is at most ``by`` pixels away along both axes."""
    found = picture.copy()
    for axis in (0, 1):
        once = found.copy()
        for k in range(1, by + 1):
            once |= np.roll(found, k, axis) | np.roll(found, -k, axis)
        found = once
    return found


def gap(a: np.ndarray, b: np.ndarray) -> int:
    """Distance between two pictures, the larger of both axes [mm], up to 200 mm; -50 where they overlap."""
    if (a & b).any():
        return -P
    return next((k - 1 for k in range(1, 5) if (grown(a, k) & b).any()), 4) * P


def cropped(picture: np.ndarray) -> tuple[np.ndarray, tuple[int, int]]:
    """A picture without the empty rows and columns around it, and where its corner was."""
    i, j = np.nonzero(picture)
    return picture[i.min() : i.max() + 1, j.min() : j.max() + 1], (int(i.min()), int(j.min()))


def fits(picture: np.ndarray, k: int) -> np.ndarray:
    """Where the lower left corner of a square of ``k`` pixels may be."""
    sums = np.zeros(tuple(n + 1 for n in picture.shape), int)
    sums[1:, 1:] = picture.astype(int).cumsum(0).cumsum(1)
    if min(picture.shape) < k:
        return np.zeros((0, 0), bool)
    return sums[k:, k:] - sums[:-k, k:] - sums[k:, :-k] + sums[:-k, :-k] == k * k


def largest_square(picture: np.ndarray) -> int:
    """Side of the largest square [mm]."""
    picture, k = cropped(picture)[0], 0
    while fits(picture, k + 1).any():
        k += 1
    return k * P


def rectangles(picture: np.ndarray) -> set[tuple[int, int]]:
    """(width, depth) [pixels] of all rectangles of which no wider one of the same rows is there."""
    part, _ = cropped(picture)
    found: set[tuple[int, int]] = set()
    for low in range(part.shape[0]):
        column = np.ones(part.shape[1], bool)
        for high in range(low, part.shape[0]):
            column &= part[high]
            run = best = 0
            for free in column:
                run = run + 1 if free else 0
                best = max(best, run)
            if not best:
                break
            found.add((high - low + 1, best))
    return found


def flood(free: np.ndarray, starts: np.ndarray) -> np.ndarray:
    """What is reached along the axes."""
    seen = free & starts
    queue = deque(zip(*np.nonzero(seen), strict=True))
    while queue:
        i, j = queue.popleft()
        for a, b in ((i + 1, j), (i - 1, j), (i, j + 1), (i, j - 1)):
            if 0 <= a < free.shape[0] and 0 <= b < free.shape[1] and free[a, b] and not seen[a, b]:
                seen[a, b] = True
                queue.append((a, b))
    return seen
