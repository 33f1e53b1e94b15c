"""Directions and points to sample: even sequences, hemispheres, rectangles by solid angle, glossy lobes."""

import warp as wp

from .ray_kernels import PI, tangent

wp.set_module_options({"enable_backward": False, "fast_math": True, "max_unroll": 1})

_LEAST_ANGLE = wp.constant(4.0e-3)  # solid angle [sr] under which single precision no longer tells rectangles apart


@wp.struct
class SphericalRectangle:
    """A rectangle as seen from a point, ready to be sampled by solid angle."""

    x: wp.vec3
    y: wp.vec3
    z: wp.vec3
    x0: float
    x1: float
    y0: float
    y1: float
    z0: float
    b0: float
    b1: float
    k: float
    solid_angle: float


@wp.func
def cosine_direction(n: wp.vec3, e: wp.vec2):
    """A direction about n with a density of cosine over pi."""
    t1 = tangent(n)
    t2 = wp.cross(n, t1)
    r = wp.sqrt(e[0])
    a = 2.0 * PI * e[1]
    return t1 * (r * wp.cos(a)) + t2 * (r * wp.sin(a)) + n * wp.sqrt(wp.max(0.0, 1.0 - e[0]))


@wp.func
def cone_direction(axis: wp.vec3, softness: float, e: wp.vec2):
    """A direction in the cone about an axis whose half angle has the tangent ``softness``."""
    t1 = tangent(axis)
    t2 = wp.cross(axis, t1)
    r = softness * wp.sqrt(e[0])
    a = 2.0 * PI * e[1]
    return wp.normalize(axis + t1 * (r * wp.cos(a)) + t2 * (r * wp.sin(a)))


@wp.func
def reflected(way: wp.vec3, n: wp.vec3):
    """A direction thrown back by a mirror with normal n."""
    return way - n * (2.0 * wp.dot(way, n))


@wp.func
def glossy_direction(way: wp.vec3, n: wp.vec3, roughness: float, e: wp.vec2):
    """A direction thrown back by a GGX surface: visible normals, sampled after Heitz (2018)."""
    t1 = tangent(n)
    t2 = wp.cross(n, t1)
    alpha = wp.max(roughness * roughness, 1.0e-4)
    v = -way
    stretched = wp.normalize(wp.vec3(alpha * wp.dot(v, t1), alpha * wp.dot(v, t2), wp.max(wp.dot(v, n), 1.0e-3)))
    flat = stretched[0] * stretched[0] + stretched[1] * stretched[1]
    a = wp.vec3(1.0, 0.0, 0.0)
    if flat > 1.0e-9:
        a = wp.vec3(-stretched[1], stretched[0], 0.0) / wp.sqrt(flat)
    b = wp.cross(stretched, a)
    r = wp.sqrt(e[0])
    p1 = r * wp.cos(2.0 * PI * e[1])
    p2 = r * wp.sin(2.0 * PI * e[1])
    s = 0.5 * (1.0 + stretched[2])
    p2 = (1.0 - s) * wp.sqrt(wp.max(0.0, 1.0 - p1 * p1)) + s * p2
    m = a * p1 + b * p2 + stretched * wp.sqrt(wp.max(0.0, 1.0 - p1 * p1 - p2 * p2))
    m = wp.normalize(wp.vec3(alpha * m[0], alpha * m[1], wp.max(m[2], 1.0e-6)))
    return reflected(way, t1 * m[0] + t2 * m[1] + n * m[2])


@wp.func
def glossy_lobe(away: wp.vec3, n: wp.vec3, roughness: float, way: wp.vec3):
    """Pi times how much of the light along -``way`` a GGX surface throws to ``away``, for a Fresnel of 1."""
    alpha = wp.max(roughness * roughness, 0.012)
    a2 = alpha * alpha
    h = wp.normalize(away + way)
    nh, nl, nv = wp.max(wp.dot(n, h), 0.0), wp.max(wp.dot(n, way), 1.0e-3), wp.max(wp.dot(n, away), 1.0e-3)
    d = nh * nh * (a2 - 1.0) + 1.0
    masked = nl * wp.sqrt(nv * nv * (1.0 - a2) + a2) + nv * wp.sqrt(nl * nl * (1.0 - a2) + a2)
    return a2 / (d * d) * 0.5 / wp.max(masked, 1.0e-4)


@wp.func
def split_sum(roughness: float, cosine: float):
    """Scale and bias of the reflectance at normal incidence for light from all sides: fit by Karis (2014)."""
    c = wp.vec4(1.0 - roughness, 0.0425 - 0.0275 * roughness, 1.04 - 0.572 * roughness, -0.04 + 0.022 * roughness)
    a = wp.min(c[0] * c[0], wp.pow(2.0, -9.28 * cosine)) * c[0] + c[1]
    return wp.vec2(-1.04 * a + c[2], 1.04 * a + c[3])


@wp.func
def _edge_normal(x: float, y: float, z: float):
    return wp.normalize(wp.vec3(x, y, z))


@wp.func
def spherical_rectangle(corner: wp.vec3, ex: wp.vec3, ey: wp.vec3, origin: wp.vec3):
    """A rectangle from a corner along two edges [m], as seen from a point (Urena, Fajardo and King 2013)."""
    q = SphericalRectangle()
    width, height = wp.length(ex), wp.length(ey)
    q.x = ex / width
    q.y = ey / height
    q.z = wp.cross(q.x, q.y)
    d = corner - origin
    q.z0 = wp.dot(d, q.z)
    if q.z0 > 0.0:
        q.z = -q.z
        q.z0 = -q.z0
    q.z0 = wp.min(q.z0, -1.0e-5)
    q.x0 = wp.dot(d, q.x)
    q.y0 = wp.dot(d, q.y)
    q.x1 = q.x0 + width
    q.y1 = q.y0 + height
    n0 = _edge_normal(0.0, q.z0, -q.y0)
    n1 = _edge_normal(-q.z0, 0.0, q.x1)
    n2 = _edge_normal(0.0, -q.z0, q.y1)
    n3 = _edge_normal(q.z0, 0.0, -q.x0)
    g0 = wp.acos(wp.clamp(-wp.dot(n0, n1), -1.0, 1.0))
    g1 = wp.acos(wp.clamp(-wp.dot(n1, n2), -1.0, 1.0))
    g2 = wp.acos(wp.clamp(-wp.dot(n2, n3), -1.0, 1.0))
    g3 = wp.acos(wp.clamp(-wp.dot(n3, n0), -1.0, 1.0))
    q.b0 = n0[2]
    q.b1 = n2[2]
    q.k = 2.0 * PI - g2 - g3
    q.solid_angle = g0 + g1 - q.k
    return q


@wp.func
def rectangle_sample(q: SphericalRectangle, e: wp.vec2):
    """From the point to one of the rectangle, evenly by solid angle (evenly by area where it looks tiny) [m]."""
    if q.solid_angle < _LEAST_ANGLE:
        return q.x * (q.x0 + e[0] * (q.x1 - q.x0)) + q.y * (q.y0 + e[1] * (q.y1 - q.y0)) + q.z * q.z0
    au = e[0] * q.solid_angle + q.k
    fu = (wp.cos(au) * q.b0 - q.b1) / wp.sin(au)
    cu = wp.clamp(wp.sign(fu) / wp.sqrt(fu * fu + q.b0 * q.b0), -0.999999, 0.999999)
    xu = wp.clamp(-(cu * q.z0) / wp.sqrt(1.0 - cu * cu), q.x0, q.x1)
    d2 = xu * xu + q.z0 * q.z0
    h0 = q.y0 / wp.sqrt(d2 + q.y0 * q.y0)
    h1 = q.y1 / wp.sqrt(d2 + q.y1 * q.y1)
    hv = h0 + e[1] * (h1 - h0)
    yv = q.y1
    if hv * hv < 0.999999:
        yv = wp.clamp(hv * wp.sqrt(d2) / wp.sqrt(1.0 - hv * hv), q.y0, q.y1)
    return q.x * xu + q.y * yv + q.z * q.z0


@wp.func
def rectangle_weight(q: SphericalRectangle, to: wp.vec3):
    """One over the density [sr] of a sample."""
    if q.solid_angle < _LEAST_ANGLE:
        d2 = wp.max(wp.dot(to, to), 1.0e-8)
        return (q.x1 - q.x0) * (q.y1 - q.y0) * wp.abs(q.z0) / (d2 * wp.sqrt(d2))
    return q.solid_angle
