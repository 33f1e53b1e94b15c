"""Whether all that is said of a problem is so."""

from __future__ import annotations

import hashlib

import numpy as np

from sceneweaver.scene import InputError
from sceneweaver.verify import check

from .case import ProblemCase, canonical
from .certificates import prove
from .store import manifest

ROUNDING = 1e-4  # [m]


def verify(case: ProblemCase) -> None:
    """Check a problem: its hash, its witness by the judge and by the engine, or its certificate.

    Raises:
        InputError: with what is wrong, in one line.

    Examples:
        >>> from sceneweaver import problems
        >>> problems.verify(problems.load("infeasible/area-n010"))
    """
    found = hashlib.sha256(canonical(case)).hexdigest()
    row = manifest().get(case.name)
    if found != case.hash or (row is not None and row["hash"] != case.hash):
        raise InputError(f"problem {case.name}: its hash is {found[:12]}, not what it is said to be")
    if (case.witness is None) == (case.certificate is None):
        raise InputError(f"problem {case.name}: it needs either a witness or a certificate")
    if case.certificate is not None:
        prove(case.scene, case.certificate)
        return
    assert case.witness is not None
    report = check(case.layout(case.witness), walkable=False)
    if not report.valid:
        first = report.violations[0]
        raise InputError(f"problem {case.name}: the judge finds the witness not valid ({first.kind}: {first.detail})")
    if check(case.scene, walkable=False).valid:
        raise InputError(f"problem {case.name}: its scene is valid already; it is to be a bad start")
    problem = case.compile("cpu")
    poses = np.array(case.witness)[None]
    if not problem.feasible(poses)[0]:
        raise InputError(f"problem {case.name}: the engine finds the witness not feasible")
    if case.best_energy is None:
        return
    if case.best_energy > float(problem.energy(poses)[0]) + ROUNDING:
        raise InputError(f"problem {case.name}: the witness has less than the best known energy")
    if case.best is not None:
        energy = float(problem.energy(case.best[None])[0])
        if abs(energy - case.best_energy) > ROUNDING or not check(case.layout(case.best), walkable=False).valid:
            raise InputError(f"problem {case.name}: its best layout is not valid, or has {energy:.6f} m")
