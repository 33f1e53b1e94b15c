"""Random fields on a torus: arrays [n, n] that repeat without a seam.

Row 0 is the top (v = 1), column 0 the left (u = 0); wavelengths are shares of the side. Equal seeds give equal fields.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np


@cache
def grid(n: int) -> tuple[np.ndarray, np.ndarray]:
    """u and v in 0..1 of the middles of the pixels, each [n, n]."""
    middle = (np.arange(n) + 0.5) / n
    u, v = np.meshgrid(middle, middle[::-1])
    u.setflags(write=False)
    v.setflags(write=False)
    return u, v


def field(n: int, seed: int, wave: float | tuple[float, float], slope: float = 2.0) -> np.ndarray:
    """A Gaussian random field with mean 0 and standard deviation 1.

    Args:
        n: Side in pixels.
        seed: Of the random numbers.
        wave: Wavelength above which the spectrum is flat, along u and v as shares of the side.
        slope: How fast the amplitude falls below it: 1 rough, 2 soft, 4 smooth.
    """
    lu, lv = wave if isinstance(wave, tuple) else (wave, wave)
    white = np.fft.rfft2(np.random.default_rng(seed).standard_normal((n, n)))
    fu, fv = np.arange(n // 2 + 1)[None, :], np.fft.fftfreq(n, 1 / n)[:, None]
    white *= (1.0 + (fu * lu) ** 2 + (fv * lv) ** 2) ** (-slope)
    white[0, 0] = 0.0
    values = np.fft.irfft2(white, (n, n))
    return values / max(float(values.std()), 1e-12)


def warped(image: np.ndarray, du: np.ndarray | float, dv: np.ndarray | float) -> np.ndarray:
    """An image [n, n] read at places moved by (du, dv), shares of its side."""
    from scipy.ndimage import map_coordinates

    n = len(image)
    rows, columns = np.indices((n, n))
    return map_coordinates(image, [rows - dv * n, columns + du * n], order=1, mode="grid-wrap")


def blurred(image: np.ndarray, width: float | tuple[float, float]) -> np.ndarray:
    """An image smoothed by a Gaussian of this width, along u and v as shares of its side."""
    from scipy.ndimage import gaussian_filter

    wu, wv = width if isinstance(width, tuple) else (width, width)
    return gaussian_filter(image, (wv * len(image), wu * len(image)), mode="wrap")


@dataclass(frozen=True)
class Cells:
    """Worley cells: distances to the nearest and second nearest point [shares of the side] and which is nearest."""

    first: np.ndarray
    second: np.ndarray
    number: np.ndarray
    points: np.ndarray

    @property
    def border(self) -> np.ndarray:
        """About the distance to the border of the cell."""
        return (self.second - self.first) / 2


def cells(n: int, seed: int, rows: int, columns: int | None = None, jitter: float = 1.0) -> Cells:
    """Cells around one point in each box of a grid of ``rows`` by ``columns``, moved by up to half a box.

    Distances are in a frame in which the boxes are square, and 1 is the side along v.
    """
    from scipy.spatial import KDTree

    columns = columns or rows
    rng = np.random.default_rng(seed)
    i, j = np.indices((columns, rows)).reshape(2, -1)
    stretch = columns / rows
    points = np.stack([i + 0.5, j + 0.5], 1) + jitter * (rng.random((rows * columns, 2)) - 0.5)
    points = np.mod(points / rows, [stretch, 1.0])
    u, v = grid(n)
    tree = KDTree(points, boxsize=[stretch, 1.0])
    found = tree.query(np.stack([u.ravel() * stretch, v.ravel()], 1), k=2)
    near, number = (np.asarray(part) for part in found)
    shape = (n, n)
    return Cells(near[:, 0].reshape(shape), near[:, 1].reshape(shape), number[:, 0].reshape(shape), points)


def step(low: float, high: float, x: np.ndarray) -> np.ndarray:
    """A smooth step from 0 at ``low`` to 1 at ``high``."""
    t = np.clip((x - low) / (high - low), 0.0, 1.0)
    return t * t * (3 - 2 * t)


def spread(number: np.ndarray, seed: int) -> np.ndarray:
    """A random value in 0..1 for each whole number of an array."""
    _, index = np.unique(number, return_inverse=True)
    return np.random.default_rng(seed).random(int(index.max()) + 1)[index].reshape(number.shape)


def strands(n: int, seed: int, wave: float, length: float, turn: float = 1.0) -> np.ndarray:
    """Hair that lies along slowly turning ways: noise drawn out along them (line integral convolution), mean 0 and
    standard deviation 1.

    Args:
        n: Side in pixels.
        seed: Of the random numbers.
        wave: How soon the direction turns, share of the side.
        length: Of a strand, share of the side.
        turn: How far it turns [rad], in standard deviations.
    """
    angle = turn * field(n, seed, wave, 2.5)
    du, dv = np.cos(angle), np.sin(angle)
    noise = field(n, seed + 1, 0.004, 1.0)
    rows, columns = np.indices((n, n)).astype(float)
    count = max(4, int(length * n / 3))
    total = noise.copy()
    for sign in (1.0, -1.0):
        r, c = rows.copy(), columns.copy()
        for _ in range(count):
            at = np.mod(r, n).astype(int) % n, np.mod(c, n).astype(int) % n
            r -= 1.5 * sign * dv[at]
            c += 1.5 * sign * du[at]
            total += noise[np.mod(r, n).astype(int) % n, np.mod(c, n).astype(int) % n]
    total -= total.mean()
    return total / total.std()
