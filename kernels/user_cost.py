"""What a residual of the user's own costs: kernels that do nothing but evaluate one."""

import warp as wp

wp.set_module_options({"enable_backward": False})


@wp.func
def box_gap(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    """Distance in plan of the middle of a from the box of b: what a plain row of a built-in relation computes."""
    c = wp.cos(b[3])
    s = wp.sin(b[3])
    x = a[0] - b[0]
    y = a[1] - b[1]
    u = wp.max(wp.abs(c * x + s * y) - 0.5 * size_b[0], 0.0)
    v = wp.max(wp.abs(c * y - s * x) - 0.5 * size_b[1], 0.0)
    return wp.sqrt(u * u + v * v + 1.0e-6) - p[0]


def spender(residual: wp.Function) -> wp.Kernel:
    """A kernel that evaluates a residual again and again, a thread a pair, for what it costs."""

    @wp.kernel(module="unique", enable_backward=False)
    def spend(
        # Problem:
        repeats: wp.int32,
        # State in:
        a: wp.array(dtype=wp.vec4),
        b: wp.array(dtype=wp.vec4),
        # State out:
        total_out: wp.array(dtype=wp.float32),
    ):
        i = wp.tid()
        total = float(0.0)
        size = wp.vec3(0.6, 0.8, 0.9)
        pose = a[i]
        for k in range(repeats):
            moved = wp.vec4(pose[0] + 1.0e-3 * float(k), pose[1], pose[2], pose[3] + 1.0e-3 * float(k))
            total += float(residual(moved, b[i], size, size, wp.vec4(0.5, 0.5, 0.5, 0.5)))
        total_out[i] = total

    return spend
