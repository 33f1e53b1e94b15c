"""Energy of an object and its gradient: the terms of the energy in one list, and evaluators built from it.

One thread per (candidate, object) adds up every term that its object takes part in, so nothing is written twice and
no atomics are needed. Each penalty is C1 in the length that it is a penalty of: quadratic up to a knee, then linear
(Huber), on the clearance that is missing to a small safety margin, so that the optimum is strictly feasible. That
length itself has kinks where the witness changes, and jumps where a body leaves a pocket by a face that is no way out.
"""

from functools import cache, reduce
from operator import or_
from typing import NamedTuple

import warp as wp

from .bodies import Body, Layout, candidate_of, layout_of, viewed_body
from .geometry import FAR
from .tables import BOUNDS, BOXES, DISTANCES, FORMULAS, POLYGONS, PULL, RELATIONS, Energy, Problems, State, TermSlice
from .terms_bounds import add_bounds, add_pull
from .terms_contacts import add_contacts
from .terms_relations import add_relations

wp.set_module_options({"enable_backward": False})


class Term(NamedTuple):
    """A kind of terms: its bit in ``Tables.object_terms``, and the function that adds an object's terms of it."""

    kind: int
    add: wp.Function


# Terms that share a function are gone through together, in the order of this list.
TERMS = (
    Term(BOUNDS, add_bounds),
    Term(PULL, add_pull),
    Term(FORMULAS, add_relations),
    Term(DISTANCES, add_relations),
    Term(RELATIONS, add_relations),
    Term(BOXES, add_contacts),
    Term(POLYGONS, add_contacts),
)
EVERY_KIND = reduce(or_, (term.kind for term in TERMS))


@cache
def evaluator(kinds: int) -> wp.Function:
    """A function that adds up all terms of some kinds (bits) of an object.

    Its arguments are the problems, the layout, the object ``x`` where the view sees it, and which of the terms the
    thread takes; it returns an `Energy`. A term's function gets the kinds that are wanted of it and the total so far as
    well.
    """
    chosen: dict[wp.Function, int] = {}
    for term in TERMS:
        if term.kind & kinds:
            chosen[term.add] = chosen.get(term.add, 0) | term.kind
    energy = no_energy
    for add, wanted in chosen.items():
        energy = _then(energy, add, wanted)
    return energy


@wp.func
def no_energy(b: Problems, layout: Layout, x: Body, part: TermSlice):
    """The energy of no terms."""
    return Energy()


def _then(before: wp.Function, add: wp.Function, kinds: int) -> wp.Function:
    """The energy of some terms and those that a function adds."""

    @wp.func(name=f"{before.key}_{add.key}_{kinds}")
    def energy(b: Problems, layout: Layout, x: Body, part: TermSlice):
        return add(b, layout, x, part, kinds, before(b, layout, x, part))

    return energy


@cache
def object_evaluator(kinds: int) -> wp.Function:
    """`evaluator` for an object by its number (local)."""
    energy_of = evaluator(kinds)

    @wp.func(name=f"object_energy_{kinds}")
    def energy(b: Problems, layout: Layout, obj: wp.int32, part: TermSlice):
        x = viewed_body(layout, obj)
        if not wp.isfinite(x.pose):  # comparisons with NaN are false, so every term would pass it
            return Energy(FAR, FAR, 0.0, wp.vec4(0.0, 0.0, 0.0, 0.0))
        return energy_of(b, layout, x, part)

    return energy


object_energy = object_evaluator(EVERY_KIND)
"""The `Energy` of everything that an object takes part in. Pairs that the view moves together are left out."""


@wp.kernel
def evaluate(
    # Problem:
    b: Problems,
    # State in:
    s: State,
    # State out:
    share_out: wp.array2d(dtype=wp.float32),
    soft_out: wp.array2d(dtype=wp.float32),
    gradient_out: wp.array2d(dtype=wp.vec4),
):
    """Energy share, soft part of it and gradient of every object, [candidate, object]."""
    candidate, obj = wp.tid()
    c = candidate_of(b, candidate)
    energy = Energy()
    if obj < c.objects:
        layout = layout_of(c, s)
        layout.view.crowd = 1
        energy = object_energy(b, layout, obj, TermSlice(0, 1, FAR))
    share_out[candidate, obj] = energy.share
    soft_out[candidate, obj] = energy.soft
    gradient_out[candidate, obj] = energy.gradient
