"""Lanes: on a GPU the 32 threads of a warp work on one candidate; on a CPU one thread is all the lanes there are.

Code for lanes deals out its loops as ``range(lane(), count, lanes())``. All lanes of a warp have to come to ``meet``
and to the exchanges below, which on a CPU have nothing to exchange. What one lane wrote the others see after ``meet``.
Where there are fewer tasks than lanes, a *team* of neighbouring lanes shares a task.
"""

import warp as wp

wp.set_module_options({"enable_backward": False})

WARP = 32  # threads that work on one candidate on a GPU


@wp.func_native("""
#if defined(__CUDA_ARCH__)
    return threadIdx.x & 31;
#else
    return 0;
#endif
""")
def lane() -> wp.int32:
    """This thread's number in its warp."""
    ...


@wp.func_native("""
#if defined(__CUDA_ARCH__)
    return 32;
#else
    return 1;
#endif
""")
def lanes() -> wp.int32:
    """How many threads work on a candidate."""
    ...


@wp.func_native("""
#if defined(__CUDA_ARCH__)
    __syncwarp();
#endif
""")
def meet():
    """Wait for the other lanes."""
    ...


@wp.func_native("""
#if defined(__CUDA_ARCH__)
    return __shfl_sync(0xffffffffu, value, source);
#else
    return value;
#endif
""")
def number_of(value: wp.float32, source: wp.int32) -> wp.float32:
    """The value that a lane holds."""
    ...


@wp.func_native("""
#if defined(__CUDA_ARCH__)
    return __shfl_sync(0xffffffffu, value, source);
#else
    return value;
#endif
""")
def index_of(value: wp.int32, source: wp.int32) -> wp.int32:
    """The index that a lane holds."""
    ...


@wp.func
def pose_of(pose: wp.vec4, source: wp.int32):
    """The pose that a lane holds."""
    return wp.vec4(
        number_of(pose[0], source), number_of(pose[1], source), number_of(pose[2], source), number_of(pose[3], source)
    )


@wp.func_native("""
#if defined(__CUDA_ARCH__)
    for (int step = 16; step > 0; step >>= 1) value += __shfl_xor_sync(0xffffffffu, value, step);
#endif
    return value;
""")
def sum_of(value: wp.float32) -> wp.float32:
    """The sum over the lanes, the same in each of them, added up in a fixed order."""
    ...


@wp.func_native("""
#if defined(__CUDA_ARCH__)
    int first = threadIdx.x & 31 & ~(team - 1);
    unsigned mask = (team == 32 ? 0xffffffffu : ((1u << team) - 1u) << first);
    for (int step = team >> 1; step > 0; step >>= 1) value += __shfl_xor_sync(mask, value, step);
#endif
    return value;
""")
def sum_of_team(value: wp.float32, team: wp.int32) -> wp.float32:
    """The sum over a team: neighbouring lanes, a power of two, all of which have to come here."""
    ...


@wp.func
def sum_of_poses(pose: wp.vec4, team: wp.int32):
    """The sum over a team of a vector of four."""
    return wp.vec4(
        sum_of_team(pose[0], team), sum_of_team(pose[1], team), sum_of_team(pose[2], team), sum_of_team(pose[3], team)
    )


@wp.func
def team_for(count: wp.int32):
    """How many lanes each of so many tasks gets: a power of two."""
    team = int(lanes())
    while team > 1 and team * count > lanes():
        team = team // 2
    return team


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
def lowest(value: wp.float32) -> wp.int32:
    """The lane with the lowest value; the first of equals."""
    ...
