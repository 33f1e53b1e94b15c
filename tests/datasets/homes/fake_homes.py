"""Homes that cost nothing: the flat that ships with the library, with boxes that follow from the seed."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from sceneweaver.assets import Library
from sceneweaver.datasets import AssetStore, Request, Sample, Spec
from sceneweaver.datasets.homes import MadeHome, produce_homes
from sceneweaver.scene import InputError
from tests.datasets.fake import trouble
from tests.verify.build import box
from tests.verify.home.homes import flat, thing


@dataclass(frozen=True)
class Plan:
    """A plan's report that says yes."""

    valid: bool = True


def make(spec: Spec, request: Request, seed: int, library: Library) -> MadeHome:
    """A flat with a bed and a box; what is asked for says what is wrong with it."""
    rng = np.random.default_rng(seed)
    if "nothing" in request.prompt:
        raise InputError("programme: no plan keeps all rules: it is asked for nothing")
    x, y = (round(float(v), 3) for v in rng.uniform((0.8, 0.8), (3.0, 1.8)))
    home = flat(
        living=[box("box", (0.5, 0.5, 0.5), x, y)],
        bedroom_2=[thing("bed", "bed", (2.0, 1.6, 0.5), 9.0, 6.5, 180.0)],
        **({"hall": [box("bar", (0.3, 1.5, 1.0), 5.4, 2.0, 90.0)]} if "shut" in request.prompt else {}),
    )
    return MadeHome(home, Plan(), ("a terrace",) if "terrace" in request.prompt else ())  # type: ignore[arg-type]


def produce(spec: Spec, requests: Sequence[Request], store: AssetStore, device: str = "cpu") -> Iterator[Sample]:
    """As `produce_homes`, of these homes, with troubles on request."""
    for request in requests:
        trouble(request, store.root)
        yield from produce_homes(spec, [request], store, device, make=make)
