"""What happens to a picture after its rays are cast: edges are found, light is smoothed, and all becomes sRGB."""

import warp as wp

wp.set_module_options({"enable_backward": False, "fast_math": True})


@wp.func
def likeness(n: wp.vec3, other: wp.vec3, depth: float, other_depth: float):
    """How much two points are on one smooth surface, 0 to 1: by their normals and distances from the camera [m]."""
    alike = wp.max(0.0, wp.dot(n, other))
    gap = (other_depth - depth) / wp.max(0.02 * depth, 1.0e-3)
    near = wp.max(0.0, 1.0 - 0.25 * gap * gap)
    # Powers by hand: a bell with a width of about 0.02 of the distance, and the 24th power of the cosine.
    n2, a2 = near * near, alike * alike
    a4 = a2 * a2
    a8 = a4 * a4
    return a8 * a8 * a8 * n2 * n2


@wp.func
def tone_mapped(linear: wp.vec3):
    """Linear light in sRGB, 0 to 1: straight for most of the range, then a soft shoulder."""
    out = wp.vec3(0.0)
    for k in range(3):
        v = linear[k]
        if v > 0.7:
            v = 0.7 + 0.3 * (1.0 - wp.exp(-(v - 0.7) / 0.3))
        if v <= 0.0031308:
            v = 12.92 * v
        else:
            v = 1.055 * wp.pow(v, 1.0 / 2.4) - 0.055
        out[k] = wp.clamp(v, 0.0, 1.0)
    return out


@wp.kernel
def find_edges(
    # Problem:
    width: int,
    height: int,
    start: int,
    # State in:
    color: wp.array(dtype=wp.vec3),
    shine: wp.array(dtype=wp.vec3),
    normal: wp.array(dtype=wp.vec3),
    depth: wp.array(dtype=float),
    objects: wp.array(dtype=int),
    # State out:
    edge_out: wp.array(dtype=wp.uint8),
):
    """Where one ray is not enough: pixels that differ from one of their eight neighbours."""
    pixel = start + wp.tid()
    px, py = pixel % width, pixel // width
    c, n, far, who = color[pixel], normal[pixel], depth[pixel], objects[pixel]
    glow = wp.min(shine[pixel][0] + shine[pixel][1] + shine[pixel][2], 3.0)
    found = int(0)
    for dy in range(-1, 2):
        for dx in range(-1, 2):
            x, y = px + dx, py + dy
            if found == 0 and x >= 0 and x < width and y >= 0 and y < height:
                k = y * width + x
                if objects[k] != who:
                    found = 1
                elif who >= 0:
                    step = wp.abs(color[k] - c)
                    bright = wp.min(shine[k][0] + shine[k][1] + shine[k][2], 3.0)
                    if wp.abs(depth[k] - far) > 0.02 * wp.min(far, depth[k]) or wp.dot(n, normal[k]) < 0.96:
                        found = 1
                    elif wp.max(step[0], wp.max(step[1], step[2])) > 0.05 or wp.abs(bright - glow) > 0.15:
                        found = 1
    edge_out[pixel] = wp.uint8(found)


@wp.kernel
def smooth(
    # Problem:
    pixels: wp.array(dtype=int),
    width: int,
    height: int,
    start: int,
    radius: int,
    spacing: int,
    # State in:
    share: wp.array(dtype=wp.uint8),
    dense: wp.array(dtype=wp.uint8),
    ambient: wp.array(dtype=wp.vec3),
    sun: wp.array(dtype=wp.vec3),
    normal: wp.array(dtype=wp.vec3),
    depth: wp.array(dtype=float),
    objects: wp.array(dtype=int),
    # State out:
    ambient_out: wp.array(dtype=wp.vec3),
    sun_out: wp.array(dtype=wp.vec3),
):
    """The light of some pixels, smoothed among those of one object and one direction.

    ``share`` is for how many pixels the light of each one stands, 0 where none was cast. In blocks of ``spacing`` x
    ``spacing`` pixels that is the first pixel's alone, unless ``dense``, by block, says that others have some as well;
    a window then ends halfway between two blocks.
    """
    pixel = pixels[start + wp.tid()]
    px, py = pixel % width, pixel // width
    n = normal[pixel]
    far = depth[pixel]
    who = objects[pixel]
    around, direct = wp.vec3(0.0), wp.vec3(0.0)
    weight = float(0.0)
    columns = (width + spacing - 1) // spacing
    last_row, last_column = wp.min(height, py + radius + 1), wp.min(width, px + radius + 1)
    for by in range(wp.max(py - radius, 0) // spacing, wp.min(py + radius, height - 1) // spacing + 1):
        for bx in range(wp.max(px - radius, 0) // spacing, wp.min(px + radius, width - 1) // spacing + 1):
            side = int(1)
            if dense[by * columns + bx] != wp.uint8(0):
                side = spacing
            for y in range(wp.max(by * spacing, py - radius), wp.min(by * spacing + side, last_row)):
                for x in range(wp.max(bx * spacing, px - radius), wp.min(bx * spacing + side, last_column)):
                    k = y * width + x
                    if share[k] != wp.uint8(0) and objects[k] == who:
                        w = float(share[k]) * likeness(n, normal[k], far, depth[k])
                        if k == pixel:
                            w = w + 1.0e-4
                        if spacing > 1:
                            if wp.abs(x - px) == radius:
                                w = 0.5 * w
                            if wp.abs(y - py) == radius:
                                w = 0.5 * w
                        around = around + ambient[k] * w
                        direct = direct + sun[k] * w
                        weight = weight + w
    ambient_out[pixel] = around / weight
    sun_out[pixel] = direct / weight


@wp.kernel
def develop(
    # Problem:
    width: int,
    height: int,
    start: int,
    spacing: int,
    exposure: float,
    # State in:
    share: wp.array(dtype=wp.uint8),
    color: wp.array(dtype=wp.vec3),
    gloss: wp.array(dtype=wp.vec3),
    glint: wp.array(dtype=wp.vec3),
    shine: wp.array(dtype=wp.vec3),
    normal: wp.array(dtype=wp.vec3),
    depth: wp.array(dtype=float),
    objects: wp.array(dtype=int),
    # State in and out:
    ambient: wp.array(dtype=wp.vec3),
    sun: wp.array(dtype=wp.vec3),
    # State out:
    picture_out: wp.array(dtype=wp.vec3),
):
    """Bring all pixels to sRGB; those without a ``share`` get the light of the first pixels of the blocks around."""
    pixel = start + wp.tid()
    px, py = pixel % width, pixel // width
    around, direct = wp.vec3(0.0), wp.vec3(0.0)
    if share[pixel] != wp.uint8(0):
        around = around + ambient[pixel]
        direct = direct + sun[pixel]
    elif objects[pixel] >= 0:
        weight = float(0.0)
        left, top = px - px % spacing, py - py % spacing
        for y in range(top, wp.min(height, py + spacing), spacing):
            for x in range(left, wp.min(width, px + spacing), spacing):
                k = y * width + x
                if objects[k] == objects[pixel]:
                    near = float((spacing - wp.abs(x - px)) * (spacing - wp.abs(y - py)))
                    w = near * likeness(normal[pixel], normal[k], depth[pixel], depth[k]) + 1.0e-9
                    around = around + ambient[k] * w
                    direct = direct + sun[k] * w
                    weight = weight + w
        around = around / wp.max(weight, 1.0e-9)
        direct = direct / wp.max(weight, 1.0e-9)
    if share[pixel] == wp.uint8(0):
        ambient[pixel] = around
        sun[pixel] = direct
    linear = wp.cw_mul(color[pixel], around + direct) + shine[pixel]
    linear = linear + wp.cw_mul(gloss[pixel], around) + wp.cw_mul(glint[pixel], direct)
    picture_out[pixel] = tone_mapped(linear * exposure)
