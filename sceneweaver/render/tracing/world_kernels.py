"""What rays meet: surfaces of materials with seamless maps, and the radiance cache of the room.

Radiance is relative: that of the sky's zenith is about 1. Lengths are in metres.
"""

import warp as wp

from .ray_kernels import Hit, Meshes

wp.set_module_options({"enable_backward": False, "fast_math": True, "max_unroll": 1})

OFFSET = wp.constant(4.0e-4)  # by which a ray starts off its surface


@wp.struct
class Pattern:
    """Where the maps of a texture are: one over the metres that they cover, and the mips from the largest on."""

    scale: wp.vec2
    start: int
    width: int
    levels: int


@wp.struct
class Finish:
    """A material: linear base colour, with what its maps are multiplied by and without (``plain``), radiance that it
    emits, and its numbers; ``pattern`` -1 has no maps."""

    color: wp.vec3
    plain: wp.vec3
    emission: wp.vec3
    roughness: float
    metallic: float
    opacity: float
    pattern: int


@wp.struct
class World:
    """Meshes and what they look like.

    Corner normals and texture coordinates are [3 F]. ``colors`` holds tint and roughness and ``bumps`` the tangent
    space normal and metal of each texel, 8 bits each; tints are square roots of linear values.
    """

    meshes: Meshes
    normals: wp.array(dtype=wp.vec3)
    uvs: wp.array(dtype=wp.vec2)
    tangents: wp.array(dtype=wp.vec3)
    face_finish: wp.array(dtype=int)
    face_instance: wp.array(dtype=int)
    finishes: wp.array(dtype=Finish)
    patterns: wp.array(dtype=Pattern)
    colors: wp.array(dtype=wp.uint32)
    bumps: wp.array(dtype=wp.uint32)


@wp.struct
class Cache:
    """Irradiance over pi in cells of a grid, one entry for each of six sides; ``index`` -1 has none.

    ``bounced`` leaves out sunlight that is sampled as that of a lamp."""

    low: wp.vec3
    cell: float
    nx: int
    ny: int
    nz: int
    index: wp.array(dtype=int)
    light: wp.array(dtype=wp.vec3)
    bounced: wp.array(dtype=wp.vec3)
    mean: wp.vec3


@wp.struct
class Shade:
    """What a surface is like at a point: normals turned against the ray, and its finish with the maps applied.

    ``bump`` is the smooth normal as the maps bend it."""

    normal: wp.vec3
    bump: wp.vec3
    flat: wp.vec3
    color: wp.vec3
    emission: wp.vec3
    roughness: float
    metallic: float
    opacity: float
    instance: int
    back: int


@wp.func
def _channel(texel: wp.uint32, shift: int):
    return float((texel >> wp.uint32(shift)) & wp.uint32(255)) * (1.0 / 255.0)


@wp.func
def _unpacked(texel: wp.uint32):
    return wp.vec4(_channel(texel, 0), _channel(texel, 8), _channel(texel, 16), _channel(texel, 24))


@wp.func
def _tint(texel: wp.uint32):
    c = _unpacked(texel)
    return wp.vec4(c[0] * c[0], c[1] * c[1], c[2] * c[2], c[3])


@wp.func
def _level_start(pattern: Pattern, level: int):
    """Where the texels of a mip begin."""
    start = pattern.start
    width = pattern.width
    for _k in range(level):
        start += width * width
        width = width // 2
    return start


@wp.func
def _bilinear(texels: wp.array(dtype=wp.uint32), start: int, width: int, uv: wp.vec2, tint: int):
    """The texel values around a point of a seamless map; v runs up, rows run down."""
    x = uv[0] * float(width) - 0.5
    y = (1.0 - uv[1]) * float(width) - 0.5
    fx, fy = wp.floor(x), wp.floor(y)
    ax, ay = x - fx, y - fy
    mask = width - 1
    x0, y0 = int(fx) & mask, int(fy) & mask
    x1, y1 = (x0 + 1) & mask, (y0 + 1) & mask
    t00, t10 = texels[start + y0 * width + x0], texels[start + y0 * width + x1]
    t01, t11 = texels[start + y1 * width + x0], texels[start + y1 * width + x1]
    if tint == 1:
        top = _tint(t00) * (1.0 - ax) + _tint(t10) * ax
        return top * (1.0 - ay) + (_tint(t01) * (1.0 - ax) + _tint(t11) * ax) * ay
    top = _unpacked(t00) * (1.0 - ax) + _unpacked(t10) * ax
    return top * (1.0 - ay) + (_unpacked(t01) * (1.0 - ax) + _unpacked(t11) * ax) * ay


@wp.func
def mip_of(pattern: Pattern, footprint: float):
    """Which mip, as a fraction, has texels as large as a footprint [m]."""
    texels = footprint * wp.min(pattern.scale[0], pattern.scale[1]) * float(pattern.width)
    return wp.clamp(wp.log2(wp.max(texels, 1.0)), 0.0, float(pattern.levels - 1))


@wp.func
def map_texel(texels: wp.array(dtype=wp.uint32), pattern: Pattern, mip: float, uv: wp.vec2, tint: int):
    """Map values at a point between two mips."""
    level = int(mip)
    share = mip - float(level)
    start = _level_start(pattern, level)
    width = pattern.width >> level
    value = _bilinear(texels, start, width, uv, tint)
    if share > 0.01 and level + 1 < pattern.levels:
        value = value * (1.0 - share) + _bilinear(texels, start + width * width, width // 2, uv, tint) * share
    return value


@wp.func
def passed(finish: Finish):
    """The share of light that goes through a see-through surface, by colour."""
    if finish.roughness > 0.3:
        return finish.color * (1.0 - finish.opacity)
    return (wp.vec3(1.0 - finish.opacity) + finish.color * finish.opacity) * 0.93


@wp.func
def transmitted(world: World, origin: wp.vec3, way: wp.vec3, reach: float):
    """How much light comes along a ray: nothing past what is opaque, most of it through glass."""
    share = wp.vec3(1.0)
    if wp.mesh_query_ray_anyhit(world.meshes.solid, origin, way, reach):
        return wp.vec3(0.0)
    if world.meshes.clear_count > 0:
        at = origin
        left = reach
        for _k in range(8):
            found = wp.mesh_query_ray(world.meshes.clear, at, way, left)
            if not found.result:
                break
            share = wp.cw_mul(share, passed(world.finishes[world.face_finish[world.meshes.clear_start + found.face]]))
            at = at + way * (found.t + OFFSET)
            left = left - found.t - OFFSET
    return share


@wp.func
def texture_point(world: World, hit: Hit, pattern: Pattern):
    """Texture coordinates of a hit in tiles; the whole ones are dropped."""
    f = 3 * hit.face
    uv = world.uvs[f] * hit.u + world.uvs[f + 1] * hit.v + world.uvs[f + 2] * (1.0 - hit.u - hit.v)
    uv = wp.cw_mul(uv, pattern.scale)
    return wp.vec2(uv[0] - wp.floor(uv[0]), uv[1] - wp.floor(uv[1]))


@wp.func
def shade_of(world: World, hit: Hit, way: wp.vec3, footprint: float, detail: int):
    """The surface at a hit; ``footprint`` [m] is how wide a ray is there, ``detail`` 0 leaves out bumps."""
    s = Shade()
    finish = world.finishes[world.face_finish[hit.face]]
    s.instance = world.face_instance[hit.face]
    s.color = finish.color
    s.emission = finish.emission
    s.roughness = finish.roughness
    s.metallic = finish.metallic
    s.opacity = finish.opacity
    f = 3 * hit.face
    w = 1.0 - hit.u - hit.v
    n = wp.normalize(world.normals[f] * hit.u + world.normals[f + 1] * hit.v + world.normals[f + 2] * w)
    s.flat = hit.normal
    turn = float(1.0)
    if wp.dot(s.flat, way) > 0.0:
        turn = -1.0
        s.back = 1
    s.flat = s.flat * turn
    n = n * turn
    if wp.dot(n, way) > -0.02:
        n = wp.normalize(n - way * (wp.dot(n, way) + 0.02))
    s.normal = n
    if finish.pattern >= 0:
        pattern = world.patterns[finish.pattern]
        uv = texture_point(world, hit, pattern)
        t = world.tangents[hit.face]
        t = wp.normalize(t - n * wp.dot(n, t))
        b = wp.cross(n, t) * turn
        # Seen aslant a pixel is long: several texels along it, else it would be blurred across as well.
        lean = way - n * wp.dot(way, n)
        cosine = wp.max(wp.abs(wp.dot(way, n)), 0.05)
        taps = wp.clamp(int(wp.ceil(1.0 / cosine - 0.3)), 1, 4)
        if detail == 0:
            taps = 1
        long = wp.vec2(wp.dot(lean, t), wp.dot(lean, b)) / wp.max(wp.length(lean), 1.0e-4)
        long = wp.cw_mul(long, pattern.scale) * (footprint / cosine)
        mip = mip_of(pattern, wp.max(footprint, footprint / (cosine * float(taps))))
        tint = wp.vec4(0.0)
        bump = wp.vec4(0.0)
        for k in range(taps):
            at = uv + long * ((float(k) + 0.5) / float(taps) - 0.5)
            at = wp.vec2(at[0] - wp.floor(at[0]), at[1] - wp.floor(at[1]))
            tint = tint + map_texel(world.colors, pattern, mip, at, 1) / float(taps)
            if detail == 1:
                bump = bump + map_texel(world.bumps, pattern, mip, at, 0) / float(taps)
        s.color = wp.cw_mul(s.color, wp.vec3(tint[0], tint[1], tint[2]))
        s.roughness = wp.clamp(s.roughness * tint[3], 0.02, 1.0)
        if detail == 1:
            s.metallic = s.metallic * bump[3]
            m = bump * 2.0 - wp.vec4(1.0)
            n = wp.normalize(t * m[0] + b * m[1] + n * wp.max(m[2], 0.1))
    s.bump = n
    return s


@wp.func
def diffuse_of(s: Shade):
    """What a surface throws back in all directions, taken for the whole of it; metals count with their gloss."""
    return s.color * (1.0 - 0.15 * s.metallic)


@wp.func
def side_of(n: wp.vec3):
    """The side of a cell that a normal looks out of: 0..5."""
    a = wp.vec3(wp.abs(n[0]), wp.abs(n[1]), wp.abs(n[2]))
    if a[0] >= a[1] and a[0] >= a[2]:
        return wp.where(n[0] > 0.0, 0, 1)
    if a[1] >= a[2]:
        return wp.where(n[1] > 0.0, 2, 3)
    return wp.where(n[2] > 0.0, 4, 5)


@wp.func
def cell_of(cache: Cache, p: wp.vec3, n: wp.vec3):
    """The entry of the cache for a point, -1 for none."""
    q = (p + n * (0.02 * cache.cell) - cache.low) / cache.cell
    x, y, z = int(wp.floor(q[0])), int(wp.floor(q[1])), int(wp.floor(q[2]))
    if x < 0 or y < 0 or z < 0 or x >= cache.nx or y >= cache.ny or z >= cache.nz:
        return -1
    return cache.index[((z * cache.ny + y) * cache.nx + x) * 6 + side_of(n)]


@wp.func
def cell_near(cache: Cache, p: wp.vec3, n: wp.vec3, e: wp.vec2):
    """The entry of the cache for some point near one, so that cells leave no edges; -1 for none."""
    t1 = wp.vec3(0.0, 0.0, 1.0)
    if wp.abs(n[2]) > 0.7:
        t1 = wp.vec3(1.0, 0.0, 0.0)
    t2 = wp.cross(n, t1)
    jitter = t1 * ((e[0] - 0.5) * cache.cell) + t2 * ((e[1] - 0.5) * cache.cell)
    k = cell_of(cache, p + jitter, n)
    if k < 0:
        k = cell_of(cache, p, n)
    if k < 0:
        k = cell_of(cache, p + n * (0.5 * cache.cell), n)
    return k


@wp.func
def cached_light(cache: Cache, light: wp.array(dtype=wp.vec3), p: wp.vec3, n: wp.vec3, e: wp.vec2):
    """Irradiance over pi near a point: ``light`` is one of the arrays of the cache."""
    k = cell_near(cache, p, n, e)
    if k < 0:
        return cache.mean
    return light[k]


@wp.func
def luminance(c: wp.vec3):
    """How bright a linear colour is."""
    return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]


@wp.func
def schlick(cosine: float, f0: float):
    """Fresnel reflectance of a dielectric, after Schlick."""
    m = wp.clamp(1.0 - cosine, 0.0, 1.0)
    return f0 + (1.0 - f0) * m * m * m * m * m
