"""Warp-level primitives, under their CUDA names.

On a GPU the 32 threads of a warp work on one candidate; on a CPU one thread is the whole warp, and there is nothing to
exchange. Loops are dealt out as ``range(lane_id(), count, warp_size())``. All lanes of a warp have to come to
``syncwarp`` and to the exchanges below; what one lane wrote the others see after ``syncwarp``. Where there are fewer
tasks than lanes, a *subwarp* of neighbouring lanes shares a task.
"""

import warp as wp

wp.set_module_options({"enable_backward": False})

WARP_SIZE = wp.constant(32)  # threads of a warp on a GPU


@wp.func_native("""
#if defined(__CUDA_ARCH__)
    return threadIdx.x & 31;
#else
    return 0;
#endif
""")
def lane_id() -> wp.int32:
    """This thread's number in its warp."""
    ...


@wp.func_native("""
#if defined(__CUDA_ARCH__)
    return 32;
#else
    return 1;
#endif
""")
def warp_size() -> wp.int32:
    """How many threads work on a candidate."""
    ...


@wp.func_native("""
#if defined(__CUDA_ARCH__)
    __syncwarp();
#endif
""")
def syncwarp():
    """Wait for the other lanes."""
    ...


@wp.func_native("""
#if defined(__CUDA_ARCH__)
    return __shfl_sync(0xffffffffu, value, source);
#else
    return value;
#endif
""")
def shfl_float(value: wp.float32, source: wp.int32) -> wp.float32:
    """The float that lane ``source`` holds."""
    ...


@wp.func_native("""
#if defined(__CUDA_ARCH__)
    return __shfl_sync(0xffffffffu, value, source);
#else
    return value;
#endif
""")
def shfl_int(value: wp.int32, source: wp.int32) -> wp.int32:
    """The integer that lane ``source`` holds."""
    ...


@wp.func
def shfl_vec4(v: wp.vec4, source: wp.int32):
    """The vector that lane ``source`` holds."""
    return wp.vec4(
        shfl_float(v[0], source), shfl_float(v[1], source), shfl_float(v[2], source), shfl_float(v[3], source)
    )


@wp.func_native("""
#if defined(__CUDA_ARCH__)
    for (int step = 16; step > 0; step >>= 1) value += __shfl_xor_sync(0xffffffffu, value, step);
#endif
    return value;
""")
def warp_sum(value: wp.float32) -> wp.float32:
    """The sum over the lanes, the same in each of them, added up in a fixed order."""
    ...


@wp.func_native("""
#if defined(__CUDA_ARCH__)
    int first = threadIdx.x & 31 & ~(subwarp - 1);
    unsigned mask = (subwarp == 32 ? 0xffffffffu : ((1u << subwarp) - 1u) << first);
    for (int step = subwarp >> 1; step > 0; step >>= 1) value += __shfl_xor_sync(mask, value, step);
#endif
    return value;
""")
def subwarp_sum(value: wp.float32, subwarp: wp.int32) -> wp.float32:
    """The sum over a subwarp: neighbouring lanes, a power of two, all of which have to come here."""
    ...


@wp.func
def subwarp_sum_vec4(v: wp.vec4, subwarp: wp.int32):
    """The sum over a subwarp of a vector of four."""
    return wp.vec4(
        subwarp_sum(v[0], subwarp),
        subwarp_sum(v[1], subwarp),
        subwarp_sum(v[2], subwarp),
        subwarp_sum(v[3], subwarp),
    )


@wp.func
def subwarp_size(count: wp.int32):
    """How many lanes each of so many tasks gets: a power of two."""
    subwarp = int(warp_size())
    while subwarp > 1 and subwarp * count > warp_size():
        subwarp = subwarp // 2
    return subwarp


@wp.func_native("""
#if defined(__CUDA_ARCH__)
    int best = threadIdx.x & 31;
    for (int step = 16; step > 0; step >>= 1) {
        float v = __shfl_xor_sync(0xffffffffu, value, step);
        int l = __shfl_xor_sync(0xffffffffu, best, step);
        if (v < value || (v == value && l < best)) { value = v; best = l; }
    }
    return best;
#else
    return 0;
#endif
""")
def warp_argmin(value: wp.float32) -> wp.int32:
    """The lane with the lowest value; the first of equals."""
    ...


@wp.func_native("""
#if defined(__CUDA_ARCH__)
    const unsigned here = __activemask();
    const int lane = threadIdx.x & 31;
    const int leader = __ffs(here) - 1;
    int first = 0;
    if (lane == leader) first = atomicAdd(counter.data, __popc(here));
    return __shfl_sync(here, first, leader) + __popc(here & ((1u << lane) - 1u));
#else
    return counter.data[0]++;
#endif
""")
def next_slot(counter: wp.array(dtype=wp.int32)) -> wp.int32:  # pyright: ignore[reportInvalidTypeForm]
    """Count up ``counter[0]`` and return its value before; one atomic addition serves all lanes that come here."""
    ...


@wp.func_native("""
#if defined(__CUDA_ARCH__)
    return __popc(__ballot_sync(__activemask(), holds));
#else
    return holds ? 1 : 0;
#endif
""")
def lanes_with(holds: wp.bool) -> wp.int32:
    """Of how many lanes that come here together this holds."""
    ...
