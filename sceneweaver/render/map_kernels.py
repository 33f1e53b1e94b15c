"""Seamless maps with their mips in one long array, read at a point."""

import warp as wp

wp.set_module_options({"enable_backward": False, "fast_math": True, "max_unroll": 1})


@wp.struct
class Pattern:
    """Where the maps of a texture are: one over the metres that they cover, and the mips from the largest on."""

    scale: wp.vec2
    start: int
    width: int
    levels: int


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
