"""The terms of an objective as tables on a device."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import warp as wp

from sceneweaver.kernels import objective as k
from sceneweaver.kernels import user
from sceneweaver.scene import Scene

from .objective import MANHATTAN, ObjectiveTerm, feature_of
from .objective_members import fluxes_of, members_of, pins_of, places_of

CODES = {
    "wire_length": k.WIRE_LENGTH,
    "flow": k.FLOW,
    "walking": k.FLOW,  # as the crow flies; the way over free floor is measured at the end
    "cost": k.COST,
    "exposed_wall": k.EXPOSED_WALL,
    "light": k.LIGHT,
    "user": k.USER,
}


def pack_objective(scene: Scene, terms: Sequence[ObjectiveTerm], objects: int, device: str) -> k.Objective:
    """Checked terms as tables; ``objects`` is how many bodies the problem has, those of the scene first."""
    places = places_of(scene)
    number = {name: i for i, name in enumerate(places)}
    index = {name: i for i, name in enumerate(scene.ids)}
    member, pin, amount, start = [], [], [], [0]
    terms_of: list[list[int]] = [[] for _ in range(objects)]
    for t, term in enumerate(terms):
        names = members_of(scene, term)
        member += [index[name] if name in index else -1 - number[name] for name in names]
        pin += pins_of(scene, term)
        amount += fluxes_of(scene, term)
        start.append(len(member))
        for i in dict.fromkeys(m for m in member[start[-2] :] if m >= 0):
            terms_of[i].append(t)
    columns = {
        "kind": [CODES[term.kind] for term in terms],
        "code": [user.feature_of(feature_of(term)) if term.kind == "user" else 0 for term in terms],
        "weight": [term.weight for term in terms],
        "params": [_params(term) for term in terms],
        "member_start": start,
        "member": member,
        "pin": pin,
        "amount": amount,
        "incidence_start": np.cumsum([0, *map(len, terms_of)]),
        "incidence": [t for mine in terms_of for t in mine],
        "place": [(*place.middle, *place.inward) for place in places.values()],
        "place_half": [place.half for place in places.values()],
    }
    packed = k.Objective()
    for table in k.OBJECTIVE:
        scalar, width = getattr(table.dtype, "_wp_scalar_type_", table.dtype), getattr(table.dtype, "_length_", 1)
        values = np.asarray(columns[table.name], dtype=wp.dtype_to_numpy(scalar))
        values = values.reshape(-1, width) if width > 1 else values.reshape(-1)
        setattr(packed, table.name, wp.array(values, dtype=table.dtype, device=device))
    packed.terms = len(terms)
    return packed


def _params(term: ObjectiveTerm) -> tuple[float, ...]:
    if term.kind == "flow":
        return float(term.value("metric") == MANHATTAN), 0.0, 0.0, 0.0
    if term.kind == "cost":
        x, y = term.value("point") or term.value("direction")
        return float(x), float(y), float(term.value("metric") == MANHATTAN), float(term.value("direction") is not None)
    if term.kind == "exposed_wall":
        return float(term.value("depth")), 0.0, 0.0, 0.0
    if term.kind == "light":
        return float(term.value("target")), 0.0, 0.0, 0.0
    values = [float(v) for v in term.value("values")] if term.kind == "user" else []
    return tuple([*values, 0.0, 0.0, 0.0, 0.0][:4])
