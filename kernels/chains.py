"""Steps of Markov chains over valid layouts: what happens before and after the rounds of a search that makes one."""

import warp as wp

from .bodies import object_count
from .plan import SearchRun
from .tables import Problems, State
from .verdict import VALID, DeviceVerdict

wp.set_module_options({"enable_backward": False})


@wp.struct
class ChainState:
    """Where the chains stand, beside the layouts themselves."""

    seed: wp.array(dtype=wp.uint32)  # [candidate]: of all its steps
    open: wp.array(dtype=wp.int32)  # [candidate]: 1 while more layouts of it are wanted
    step: wp.array(dtype=wp.int32)  # [1]: steps done
    last: wp.array2d(dtype=wp.vec4)  # [candidate, object]: poses of the last valid layout
    fresh: wp.array(dtype=wp.int32)  # [candidate]: 1 where the last step has led to another valid layout


@wp.kernel
def begin_step(
    # State in:
    chains: ChainState,
    # State in and out:
    s: State,
    run: SearchRun,
):
    """Open chains are searched again, each step with random numbers of its own."""
    candidate = wp.tid()
    if candidate == 0:
        run.clock[0] = 0
        run.left[0] = 0
    run.active[candidate] = chains.open[candidate]
    run.total[candidate] = 0.0
    s.rng[candidate] = wp.rand_init(int(chains.seed[candidate]), chains.step[0])


@wp.kernel
def end_step(
    # Problem:
    b: Problems,
    # State in:
    verdict: DeviceVerdict,
    # State in and out:
    s: State,
    chains: ChainState,
):
    """Keep the layouts that are valid; the others go back to the last one that was."""
    candidate = wp.tid()
    if candidate == 0:
        chains.step[0] = chains.step[0] + 1
    chains.fresh[candidate] = 0
    if chains.open[candidate] == 0:
        return
    valid = int(verdict.status[candidate]) == VALID
    for obj in range(object_count(b.tables, b.problem[candidate])):
        if valid:
            chains.last[candidate, obj] = s.poses[candidate, obj]
        else:
            pose = chains.last[candidate, obj]
            s.poses[candidate, obj] = pose
            s.turns[candidate, obj] = wp.vec2(wp.cos(pose[3]), wp.sin(pose[3]))
    if valid:
        chains.fresh[candidate] = 1
