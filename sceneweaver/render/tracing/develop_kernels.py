"""From smooth light to the picture: surfaces in the light of the pixels around them, exposed and tone mapped."""

import warp as wp

from .filter_kernels import Grid, Layers, akin, alike, pixel_at
from .light_kernels import Lights, light_around
from .ray_kernels import Lens, camera_ray, even_point
from .view_kernels import Seen, is_matt, key_of, pixel_width, what_is_seen
from .world_kernels import Cache, World

wp.set_module_options({"enable_backward": False, "fast_math": True, "max_unroll": 1})


@wp.struct
class Film:
    """Exposure, contrast, the gains of the white balance, and rays for pixels at an edge and for all others."""

    exposure: float
    contrast: float
    balance: wp.vec3
    rays: int
    plain_rays: int


@wp.struct
class Picture:
    """What comes out, of each pixel: display colours 0..1, linear light, and distance [m] and instance (-1: none) of
    the first surface in its middle."""

    rgb: wp.array(dtype=wp.vec3)
    linear: wp.array(dtype=wp.vec3)
    distance: wp.array(dtype=float)
    instance: wp.array(dtype=int)


@wp.func
def shoulder(x: float, contrast: float):
    """Contrast about the middle, linear up to 0.6, then bent toward 1."""
    knee = 0.6
    x = 0.4 * wp.pow(x / 0.4, contrast)
    if x <= knee:
        return x
    t = (x - knee) / (1.0 - knee)
    return knee + (1.0 - knee) * (1.0 - wp.exp(-t))


@wp.func
def tone_mapped(color: wp.vec3, contrast: float):
    """Linear colour to display values 0..1 in sRGB: bright colours are bent toward white, hues stay."""
    c = wp.vec3(wp.max(color[0], 0.0), wp.max(color[1], 0.0), wp.max(color[2], 0.0))
    peak = wp.max(c[0], wp.max(c[1], c[2]))
    if peak > 1.0e-6:
        low = shoulder(peak, contrast)
        c = c * (low / peak)
        # What is far over white loses its colour.
        fade = 1.0 - 1.0 / (0.12 * wp.max(peak - low, 0.0) + 1.0)
        c = c * (1.0 - fade) + wp.vec3(low) * fade
    out = wp.vec3(0.0)
    for k in range(3):
        x = wp.clamp(c[k], 0.0, 1.0)
        out[k] = wp.where(x <= 0.0031308, 12.92 * x, 1.055 * wp.pow(wp.max(x, 1.0e-6), 1.0 / 2.4) - 0.055)
    return out


@wp.kernel
def find_edges(
    # Problem:
    grid: Grid,
    start: int,
    # State out:
    edge_out: wp.array(dtype=wp.uint8),
):
    """Marks places where a surface ends."""
    i = start + wp.tid()
    x, y = i % grid.columns, i // grid.columns
    p, n = grid.point[i], grid.normal[i]
    slack = 0.002 + 1.5 * grid.spread * wp.length(p - grid.eye)
    found = int(0)
    for dy in range(-1, 2):
        for dx in range(-1, 2):
            j = pixel_at(grid, x + dx, y + dy)
            if j >= 0 and found == 0:
                if grid.key[j] != grid.key[i]:
                    found = 1
                elif grid.key[i] >= 0 and alike(grid, j, p, n, grid.key[i], slack) < 0.3:
                    found = 1
    edge_out[i] = wp.uint8(found)


@wp.struct
class Blend:
    """Sums of layers over neighbouring pixels of a grid, and of their weights; ``lone``: none shows the surface."""

    soft: wp.vec3
    sun: wp.vec3
    gloss: wp.vec3
    toward: wp.vec3
    weight: float
    lone: int


@wp.func
def _with_pixel(sums: Blend, layers: Layers, j: int, w: float):
    """The sums with a pixel of some weight more."""
    sums.soft = sums.soft + layers.soft[j] * w
    sums.sun = sums.sun + layers.sun[j] * w
    sums.gloss = sums.gloss + layers.gloss[j] * w
    sums.toward = sums.toward + layers.toward[j] * w
    sums.weight += w
    return sums


@wp.func
def _blended(grid: Grid, layers: Layers, seen: Seen, gx: float, gy: float, slack: float):
    """The light around a place of the grid, of pixels that show the surface seen there; ``weight`` 0: of none."""
    mine = key_of(seen)
    left, top = int(wp.floor(gx)), int(wp.floor(gy))
    fx, fy = gx - float(left), gy - float(top)
    sums = Blend()
    for corner in range(16):
        # The four places around the point; when none is of its surface, the twelve around those.
        cx, cy = corner % 2, (corner // 2) % 2
        if corner >= 4:
            cx, cy = (corner - 4) % 4 - 1, (corner - 4) // 4 - 1
        if corner < 4 or sums.weight < 0.02:
            j = pixel_at(grid, left + cx, top + cy)
            if j >= 0:
                near = wp.max(1.0 - wp.abs(fx - float(cx)), 0.02) * wp.max(1.0 - wp.abs(fy - float(cy)), 0.02)
                sums = _with_pixel(sums, layers, j, near * alike(grid, j, seen.point, seen.normal, mine, slack))
    if sums.weight < 1.0e-3:
        sums.lone = 1
        for corner in range(16):
            j = pixel_at(grid, left + corner % 4 - 1, top + corner // 4 - 1)
            if j >= 0:
                sums = _with_pixel(sums, layers, j, akin(grid, j, seen.normal, mine))
    return sums


@wp.func
def _lit(lights: Lights, cache: Cache, seen: Seen, sums: Blend, e: wp.vec2):
    """The colour of a surface in the light around it."""
    if sums.weight < 1.0e-3:
        # Too narrow for any place around to show it: in the light of its surroundings.
        sums = Blend()
        sums.soft = light_around(lights, cache, seen.point, seen.flat, e)
        sums.gloss = sums.soft
        sums.weight = 1.0
    way = sums.toward / sums.weight
    # Bumps: a surface that is bent toward where the light comes from has more of it.
    bent = (1.0 + 1.5 * wp.dot(seen.bump, way)) / wp.max(1.0 + 1.5 * wp.dot(seen.normal, way), 0.2)
    light = sums.soft / sums.weight * wp.clamp(bent, 0.4, 1.6)
    glare = wp.max(wp.dot(seen.bump, lights.sun), 0.0) / wp.max(wp.dot(seen.normal, lights.sun), 0.1)
    light = light + sums.sun * (wp.clamp(glare, 0.3, 2.0) / sums.weight)
    shine = sums.gloss / sums.weight
    if is_matt(lights, seen) == 1:
        shine = light
    return wp.cw_mul(seen.color, light) + wp.cw_mul(seen.gloss, shine)


@wp.func
def _place_in_pixel(ray: int, paired: int):
    """Where in a pixel a ray goes through it: the first one in the middle, the others evenly.

    ``paired`` ones lie on either side of the middle, so that the first pair tells whether something ends in the pixel.
    """
    if ray == 0:
        return wp.vec2(0.5, 0.5)
    if paired == 0:
        return even_point(ray)
    e = even_point((ray + 1) // 2)
    if ray % 2 == 0:
        e = wp.vec2(1.0) - e
    return e


@wp.kernel
def develop(
    # Problem:
    world: World,
    lights: Lights,
    cache: Cache,
    lens: Lens,
    film: Film,
    grid: Grid,
    start: int,
    # State in:
    layers: Layers,
    edge: wp.array(dtype=wp.uint8),
    # State out:
    picture_out: Picture,
):
    """The picture, and the first surface in the middle of each pixel."""
    i = start + wp.tid()
    px, py = i % lens.width, i // lens.width
    size = pixel_width(lens)
    scale_x, scale_y = float(grid.columns) / float(lens.width), float(grid.rows) / float(lens.height)
    column, row = wp.min(int(float(px) * scale_x), grid.columns - 1), wp.min(int(float(py) * scale_y), grid.rows - 1)
    rays = wp.where(edge[row * grid.columns + column] > wp.uint8(0), film.rays, film.plain_rays)
    cast = float(0.0)
    first = Seen()
    differs = int(0)
    total = wp.vec3(0.0)
    linear = wp.vec3(0.0)
    for s in range(wp.max(film.rays, film.plain_rays)):
        if s >= rays:
            break
        e = _place_in_pixel(s, lights.direct.on)
        jx, jy = float(px) + e[0], float(py) + e[1]
        seen = what_is_seen(world, lights, cache, camera_ray(lens, jx, jy), size)
        if s == 0:
            first = seen
            picture_out.distance[i] = seen.first_depth
            picture_out.instance[i] = seen.first_instance
        elif seen.instance != first.instance or seen.path != first.path or wp.dot(seen.normal, first.normal) < 0.96:
            differs = 1
        elif wp.abs(seen.depth - first.depth) > 0.02 * first.depth:
            differs = 1
        color = seen.shine
        if seen.instance >= 0:
            slack = 0.004 + 2.0 * (size[0] + size[1] * seen.depth) / scale_x
            around = _blended(grid, layers, seen, jx * scale_x - 0.5, jy * scale_y - 0.5, slack)
            color = color + _lit(lights, cache, seen, around, e)
            if s == 0 and around.lone == 1:
                # One ray met by chance what is far narrower than the pixel, such as the side of a fold: by itself it
                # would be a speck.
                rays = wp.max(film.rays, film.plain_rays)
                differs = 1
        linear = linear + color
        shown = wp.cw_mul(color, film.balance) * film.exposure
        total = total + tone_mapped(shown, film.contrast)
        cast += 1.0
        # A draft looks closer only where the first rays show that something ends in this pixel.
        if s == 2 and differs == 0 and lights.direct.on == 1:
            break
    picture_out.rgb[i] = total / cast
    picture_out.linear[i] = linear / cast
