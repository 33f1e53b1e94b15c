"""Smoothing of light over neighbouring pixels of one surface, as far as its noise asks for it.

Edge-avoiding wavelets guided by variance, after Dammertz et al. (2010) and Schied et al. (SVGF, 2017), for one picture:
how bright two pixels are is compared in a smoother picture, so that rims of shadows are smooth lines.
"""

import warp as wp

from .light_kernels import clamped
from .world_kernels import luminance

wp.set_module_options({"enable_backward": False, "fast_math": True, "max_unroll": 1})


@wp.struct
class Grid:
    """Pixels that are lit, row by row, and the ``point``, ``normal`` and ``key`` of the surface that each shows (a
    negative key: none). ``spread`` is how much wider a pixel gets over a metre from ``eye``."""

    columns: int
    rows: int
    eye: wp.vec3
    spread: float
    point: wp.array(dtype=wp.vec3)
    normal: wp.array(dtype=wp.vec3)
    key: wp.array(dtype=int)


@wp.struct
class Layers:
    """Light of the pixels of a grid over pi: all but the sun's (``soft``), the sun's, what is reflected (``gloss``),
    and the mean direction that soft light comes from."""

    soft: wp.array(dtype=wp.vec3)
    sun: wp.array(dtype=wp.vec3)
    gloss: wp.array(dtype=wp.vec3)
    toward: wp.array(dtype=wp.vec3)


@wp.func
def pixel_at(grid: Grid, x: int, y: int):
    """The number of a pixel, -1 beside the picture."""
    if x >= 0 and y >= 0 and x < grid.columns and y < grid.rows:
        return y * grid.columns + x
    return -1


@wp.func
def alike(grid: Grid, j: int, p: wp.vec3, n: wp.vec3, key: int, slack: float):
    """Whether a pixel shows the surface of a point: 0..1, by instance, normals and distance from the plane [``slack``,
    m]."""
    if key != grid.key[j]:
        return 0.0
    q, m = grid.point[j], grid.normal[j]
    away = wp.abs(wp.dot(q - p, n)) + wp.abs(wp.dot(q - p, m))
    bend = wp.max(wp.dot(n, m), 0.0)
    bend = bend * bend
    bend = bend * bend
    bend = bend * bend
    return bend * bend * bend * wp.exp(-away / slack)


@wp.func
def _spline(step: int):
    """The cubic B-spline, 1 in the middle: what alternates from pixel to pixel vanishes."""
    a = wp.abs(step)
    return wp.where(a == 0, 1.0, wp.where(a == 1, 2.0 / 3.0, 1.0 / 6.0))


@wp.func
def akin(grid: Grid, j: int, n: wp.vec3, key: int):
    """Whether a pixel shows a face of one object that looks about the same way: for what is narrower than a pixel."""
    if key != grid.key[j]:
        return 0.0
    bend = wp.max(wp.dot(n, grid.normal[j]), 0.0)
    return bend * bend * 0.2


@wp.kernel
def find_guide(
    # Problem:
    grid: Grid,
    start: int,
    # State in:
    layers: Layers,
    variance: wp.array(dtype=float),
    # State out:
    layers_out: Layers,
    guide_out: wp.array(dtype=wp.vec2),
):
    """How bright a pixel is by its surroundings, and by how much that may be wrong: few samples know little of their
    own. Neither soft light nor gloss stays much brighter than all around."""
    i = start + wp.tid()
    x, y = i % grid.columns, i // grid.columns
    p, n = grid.point[i], grid.normal[i]
    slack = 0.002 + 0.6 * grid.spread * wp.length(p - grid.eye)
    count = float(0.0)
    noise = float(0.0)
    first = wp.vec2(0.0, 0.0)
    second = wp.vec2(0.0, 0.0)
    for dy in range(-2, 3):
        for dx in range(-2, 3):
            j = pixel_at(grid, x + dx, y + dy)
            if j >= 0 and j != i:
                w = alike(grid, j, p, n, grid.key[i], slack) * _spline(dx) * _spline(dy)
                if w > 1.0e-3:
                    bright = wp.vec2(luminance(layers.soft[j]), luminance(layers.gloss[j]))
                    noise += variance[j] * w * w
                    count += w
                    first = first + bright * w
                    second = second + wp.cw_mul(bright, bright) * w
    lit = layers.soft[i]
    shine = layers.gloss[i]
    if count > 0.7:
        mean = first / count
        vary = second / count - wp.cw_mul(mean, mean)
        lit = clamped(lit, mean[0] + 2.0 * wp.sqrt(wp.max(vary[0], 0.0)) + 1.0e-4)
        shine = clamped(shine, mean[1] + 2.0 * wp.sqrt(wp.max(vary[1], 0.0)) + 1.0e-4)
    layers_out.soft[i] = lit
    layers_out.gloss[i] = shine
    level = (first[0] + luminance(lit)) / (count + 1.0)
    # The mean of some pixels is less noisy than each, as far as they differ by noise at all.
    error = wp.sqrt((noise + variance[i]) / (count + 1.0) / (count + 1.0))
    guide_out[i] = wp.vec2(level, 7.0 * error + 0.02 * level + 1.0e-4)


@wp.kernel
def smooth(
    # Problem:
    grid: Grid,
    step: int,
    start: int,
    # State in:
    layers: Layers,
    guide: wp.array(dtype=wp.vec2),
    # State out:
    layers_out: Layers,
    guide_out: wp.array(dtype=wp.vec2),
):
    """One level, of all light but the sun's: every pixel with 24 around it that are ``step`` pixels apart."""
    i = start + wp.tid()
    x, y = i % grid.columns, i // grid.columns
    mine = grid.key[i]
    layers_out.soft[i] = layers.soft[i]
    layers_out.gloss[i] = layers.gloss[i]
    layers_out.toward[i] = layers.toward[i]
    guide_out[i] = guide[i]
    if mine >= 0:
        p, n = grid.point[i], grid.normal[i]
        slack = 0.002 + 0.6 * grid.spread * wp.length(p - grid.eye) * float(step)
        bright = guide[i]
        shine = luminance(layers.gloss[i])
        lone = int(0)
        for _attempt in range(2):
            total = float(0.0)
            shares = float(0.0)
            support = float(0.0)
            sum_soft = wp.vec3(0.0)
            sum_gloss = wp.vec3(0.0)
            sum_toward = wp.vec3(0.0)
            sum_guide = float(0.0)
            for dy in range(-2, 3):
                for dx in range(-2, 3):
                    j = pixel_at(grid, x + dx * step, y + dy * step)
                    if j >= 0:
                        w = alike(grid, j, p, n, mine, slack)
                        if lone == 1:
                            w = wp.max(w, akin(grid, j, n, mine))
                        if w > 1.0e-4:
                            support += w
                            w = w * _spline(dx) * _spline(dy)
                            off = (guide[j][0] - bright[0]) / (bright[1] + guide[j][1])
                            ws = w * wp.exp(-2.0 * off * off)
                            sum_soft = sum_soft + layers.soft[j] * ws
                            sum_toward = sum_toward + layers.toward[j] * ws
                            sum_guide += guide[j][0] * ws
                            shares += ws
                            g = layers.gloss[j]
                            wg = w / (1.0 + 2.0 * wp.abs(luminance(g) - shine) / (shine + 0.2))
                            sum_gloss = sum_gloss + g * wg
                            total += wg
            layers_out.soft[i] = sum_soft / wp.max(shares, 1.0e-6)
            layers_out.toward[i] = sum_toward / wp.max(shares, 1.0e-6)
            # What is smoother is compared more closely at the next level.
            level = sum_guide / wp.max(shares, 1.0e-6)
            guide_out[i] = wp.vec2(level, wp.max(0.8 * bright[1], 0.015 * level))
            if step <= 4:
                layers_out.gloss[i] = sum_gloss / wp.max(total, 1.0e-6)
            if support > 3.0 or step > 2:
                break
            lone = 1


@wp.kernel
def smooth_sun(
    # Problem:
    grid: Grid,
    start: int,
    # State in:
    sun: wp.array(dtype=wp.vec3),
    # State out:
    sun_out: wp.array(dtype=wp.vec3),
):
    """Sunlight with its noisy rims smoothed over two pixels."""
    i = start + wp.tid()
    x, y = i % grid.columns, i // grid.columns
    sun_out[i] = sun[i]
    if grid.key[i] >= 0:
        p, n = grid.point[i], grid.normal[i]
        slack = 0.002 + 0.6 * grid.spread * wp.length(p - grid.eye)
        total = float(0.0)
        found = wp.vec3(0.0)
        for dy in range(-2, 3):
            for dx in range(-2, 3):
                j = pixel_at(grid, x + dx, y + dy)
                if j >= 0:
                    w = alike(grid, j, p, n, grid.key[i], slack)
                    w = w * _spline(dx) * _spline(dy)
                    found = found + sun[j] * w
                    total += w
        if total > 1.0e-6:
            sun_out[i] = found / total
