"""The transition table of the search: kernels follow it, all of it can be reached, and a round comes to an end."""

from __future__ import annotations

import ast
from pathlib import Path

import numpy as np
import warp as wp

from sceneweaver.kernels import state_machine, transitions
from sceneweaver.kernels.state_machine import EVENTS, MOVING, NO_JOB, PHASES, STOP, TRANSITIONS, next_job, next_phase

PHASE_FUNCTIONS = {"moving_event": "MOVING", "polishing_event": "POLISHING", "finishing_event": "FINISHING"}


@wp.kernel(enable_backward=False)
def _look_up(pairs: wp.array(dtype=wp.vec2i), found: wp.array(dtype=wp.vec2i)):
    i = wp.tid()
    found[i] = wp.vec2i(next_phase(pairs[i][0], pairs[i][1]), next_job(pairs[i][0], pairs[i][1]))


def test_kernels_follow_the_table(device):
    pairs = [(phase, event) for phase in range(PHASES) for event in range(EVENTS)]
    found = wp.zeros(len(pairs), dtype=wp.vec2i, device=device)
    wp.launch(_look_up, len(pairs), [wp.array(pairs, dtype=wp.vec2i, device=device), found], device=device)
    for pair, got in zip(pairs, found.numpy(), strict=True):
        expected = TRANSITIONS.get(pair)
        assert got[1] == STOP if expected is None else tuple(got) == expected, pair


def test_the_table_has_just_the_events_that_phases_can_have():
    """Every event that the code of a phase names is in the table, and no other."""
    tree = ast.parse(Path(transitions.__file__).read_text())
    functions = {node.name: node for node in tree.body if isinstance(node, ast.FunctionDef)}
    named = set()
    for function, phase in PHASE_FUNCTIONS.items():
        for node in ast.walk(functions[function]):
            if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "event":
                event = ast.unparse(node.value).removeprefix("int(").removesuffix(")")
                named.add((getattr(state_machine, phase), getattr(state_machine, event)))
    assert named == set(TRANSITIONS)


def test_every_phase_can_be_reached_and_can_end():
    reached = {MOVING}
    for _ in range(PHASES):
        reached |= {phase for (before, _), (phase, _) in TRANSITIONS.items() if before in reached}
    assert reached == set(range(PHASES))
    ends = {before for (before, _), (_, job) in TRANSITIONS.items() if job == STOP}
    leads = {before: {phase for (b, _), (phase, _) in TRANSITIONS.items() if b == before} for before in reached}
    assert all(ends & (leads[phase] | {phase}) for phase in reached)
    for (before, _), (phase, job) in TRANSITIONS.items():
        assert (job == NO_JOB) == (phase != before), "another phase is entered before it has a job"
    assert len(np.unique(list(TRANSITIONS), axis=0)) == len(TRANSITIONS)
