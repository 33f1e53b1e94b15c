"""What residuals of the user's own are tried with when they are defined: sample poses, and what has to hold there."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import warp as wp

from sceneweaver.kernels import user
from sceneweaver.kernels.features import STEP
from sceneweaver.scene import InputError, Pose, SceneObject

from .probe_edges import check_edge, check_ids, check_jumps, check_other_params, check_scale
from .probe_samples import Samples, anywhere, pairs_of
from .user import HELD, MARGIN

Predicate = Callable[[SceneObject, SceneObject | None, Mapping[str, float]], bool]

ROUGH = 0.1
"""Share of random poses at which a gradient may be off: a few kinks are fine."""

FLAT = 0.5
"""Share of the poses at which something is missing that may be without a gradient: there the engine is blind."""

APART = 5.0e-3
"""[m] A residual nearer to 0 than this is not compared with the predicate."""

WRONG_HELD, WRONG_MISSED = 0.02, 0.1
"""Of the poses at which a residual says that it holds, and of the others, the shares that the predicate may deny."""

STEPS = 24  # of a descent from each
DEPTH, NEARER = 0.05, 0.75  # [m] below 0 that its first step heads for, and by how much nearer each next one


@dataclass(frozen=True)
class Found:
    """What a residual is at samples: values [K], Warp's gradient by a, and the engine's by a and by b [K, 4]."""

    value: np.ndarray
    exact: np.ndarray
    by_a: np.ndarray
    by_b: np.ndarray


def check_gradient(residual: wp.Function, *, count: int = 256, seed: int = 0) -> float:
    """Compare the engine's differences with Warp's own derivative of a residual at random poses.

    Args:
        residual: as for `define_relation`.
        count: how many random pairs of poses.
        seed: equal seeds draw equal poses.

    Returns:
        The share of the poses, 0 to 1, at which the two differ by more than a hundredth: kinks and steps. Up to 0.1 is
        accepted of relations and terms.

    Raises:
        InputError: the residual is no ``wp.func`` of the right form, or its gradient is not finite.

    Examples:
        >>> import sceneweaver as sw, warp as wp
        >>> @wp.func
        ... def far(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
        ...     return wp.length(wp.vec2(a[0] - b[0], a[1] - b[1])) - 1.0
        >>> sw.check_gradient(far) < 0.02
        True
    """
    probe = Probe("residual", residual)
    return probe.rough(anywhere(count, seed))


def check_term(label: str, residual: wp.Function, params: Sequence[float], pairs: bool) -> None:
    """Refuse the residual of a term that is no number, rough, flat or never above 0; ``label`` names it in messages.

    Raises:
        InputError: what is wrong with it, and at which poses.
    """
    probe, samples = Probe(label, residual), pairs_of(params, pairs)
    found = probe.regular(samples)
    if not (found.value > 0).any():
        raise InputError(
            f"{label}: its residual is at most 0 at all {len(samples.a)} sample poses, so it costs nothing"
        )


def check_relation(
    label: str,
    residual: wp.Function,
    holds: Predicate,
    params: Mapping[str, float],
    scale: float,
    pairs: bool,
) -> None:
    """Refuse a relation whose residual is no number, rough, flat or never met, or not what its predicate says.

    Both are tried at the same sample poses and sizes, with the defaults of the params, and where a descent along the
    residual's gradient leads from there. ``scale`` is how many metres a unit of the residual counts as.

    Raises:
        InputError: what is wrong with it, and at which poses.
    """
    probe, samples = Probe(label, residual), pairs_of(tuple(params.values()), pairs)
    first = probe.regular(samples, APART / scale)
    check_scale(label, first.value, first.by_a, scale)
    ends = probe.descended(samples, scale)
    found = probe.at(ends)
    held, least = -HELD * MARGIN / scale, int(np.argmin(found.value))
    if not (found.value <= held).any():
        raise InputError(
            f"{label}: nothing satisfies its residual: {found.value[least]:.3g} is the least that was found from "
            f"{len(samples.a)} sample poses on ({ends.words(least)}), and it has to get below {held:.1g}; "
            "give it some slack, or mend its sign"
        )
    value = np.concatenate([first.value, found.value])
    both = replace(
        samples,
        **{
            n: np.concatenate([getattr(samples, n), getattr(ends, n)]) for n in ("a", "b", "size_a", "size_b", "params")
        },
    )
    said = np.array([_said(label, holds, both, k, params, pairs) for k in range(len(value))])
    inside = value <= -APART / scale
    inside = inside if inside.any() else value <= held
    _agree(
        label, both, value, inside & ~said, inside, WRONG_HELD, "the residual says that it holds, `holds` says False"
    )
    missed = value > APART / scale
    _agree(
        label, both, value, missed & said, missed, WRONG_MISSED, "the residual says that it does not, `holds` says True"
    )

    def asked(at: Samples, k: int, numbers: Mapping[str, float], ids: tuple[str, str]) -> bool:
        return _said(label, holds, at, k, numbers, pairs, ids)

    check_ids(label, both, asked, params)
    check_edge(label, probe.values, samples, ends, asked, params, scale)
    check_other_params(label, probe.values, both, asked, params, scale)


def _agree(
    label: str, at: Samples, value: np.ndarray, wrong: np.ndarray, of: np.ndarray, most: float, what: str
) -> None:
    share = wrong.sum() / max(of.sum(), 1)
    if share > most:
        k = int(np.flatnonzero(wrong)[0])
        raise InputError(
            f"{label}: engine and judge disagree at {share:.0%} of {of.sum()} sample poses: {what}, as at "
            f"{at.words(k)}, where the residual is {value[k]:.3g}"
        )


def _said(
    label: str,
    holds: Predicate,
    at: Samples,
    k: int,
    params: Mapping[str, float],
    pairs: bool,
    ids: tuple[str, str] = ("a", "b"),
) -> bool:
    """What the predicate says of a pair."""
    subject = _thing(ids[0], at.size_a[k], at.a[k])
    try:
        said: Any = holds(subject, _thing(ids[1], at.size_b[k], at.b[k]) if pairs else None, dict(params))
    except Exception as error:  # whatever a user's function raises
        text = f"{type(error).__name__}: {error}".splitlines()[0]
        raise InputError(f"{label}: holds raises {text}, with {at.words(k)}") from error
    if not isinstance(said, bool | np.bool_):
        raise InputError(f"{label}: holds returns {said!r} of type {type(said).__name__}; return True or False")
    return bool(said)


def _thing(name: str, size: np.ndarray, pose: np.ndarray) -> SceneObject:
    d, w, h = (float(v) for v in size)
    x, y, z, yaw = (float(v) for v in pose)
    return SceneObject(id=name, category="thing", size=(d, w, h), pose=Pose.from_yaw(x, y, z, yaw))


class Probe:
    """A residual that is looked at as the engine does."""

    def __init__(self, label: str, residual: wp.Function) -> None:
        """``label`` says in messages what it is of."""
        if not isinstance(residual, wp.Function):
            raise InputError(f"{label}: residual is not a wp.func; decorate it with @wp.func")
        self.label, self._measure = label, user.prober(residual)

    def at(self, samples: Samples) -> Found:
        """The residual at samples; errors where it does not compile."""
        try:
            return Found(*self._measure(samples.a, samples.b, samples.size_a, samples.size_b, samples.params))
        except Exception as error:  # Warp's own errors have no common type
            text = str(error).strip().splitlines()
            raise InputError(
                f"{self.label}: residual does not compile as f(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, "
                f"size_b: wp.vec3, p: wp.vec4) -> number: {text[-1] if text else type(error).__name__}"
            ) from error

    def rough(self, samples: Samples) -> float:
        """The share of samples at which the engine's differences and Warp's own gradient differ."""
        found = self.at(samples)
        self._require_numbers(samples, found.exact, found.by_a)
        off = np.abs(found.exact - found.by_a).max(axis=1) > 1e-2 * (1.0 + np.abs(found.exact).max(axis=1))
        return float(off.mean())

    def regular(self, samples: Samples, missing: float = 0.0) -> Found:
        """The residual at samples, which is finite, smooth, and has a slope where more than ``missing`` is missing."""
        found = self.at(samples)
        self._require_numbers(samples, found.value[:, None], found.by_a, found.by_b)
        off = self.rough(anywhere(256, 0))
        if off > ROUGH:
            raise InputError(
                f"{self.label}: the residual is not smooth: Warp's gradient and differences over {STEP} disagree at "
                f"{off:.0%} of random poses"
            )
        positive = found.value > missing
        flat = positive & (np.abs(np.concatenate([found.by_a, found.by_b], axis=1)).max(axis=1) < 1.0e-6)
        if flat.sum() > FLAT * positive.sum():
            raise InputError(
                f"{self.label}: the residual is flat: its gradient is 0 at {flat.sum()} of {positive.sum()} sample "
                f"poses at which something is missing, as at {samples.words(int(np.flatnonzero(flat)[0]))}; "
                "the engine can not follow it"
            )
        check_jumps(self.label, self.values, samples, found.value, found.by_a)
        return found

    def values(self, samples: Samples) -> np.ndarray:
        """The residual [K] at samples."""
        return self.at(samples).value

    def descended(self, samples: Samples, scale: float) -> Samples:
        """The lowest that is found from each sample by Polyak steps of a along the residual's gradient."""
        a, best, lowest = samples.a.copy(), samples.a.copy(), np.full(len(samples.a), np.inf)
        for k in range(STEPS):
            found = self.at(replace(samples, a=a))
            better = found.value < lowest
            best[better], lowest[better] = a[better], found.value[better]
            steep = np.maximum((found.by_a**2).sum(axis=1), 1.0e-6)
            size = np.maximum(found.value + DEPTH * NEARER**k / scale, 0.0) / steep
            step = np.nan_to_num(size[:, None] * found.by_a, nan=0.0, posinf=0.0, neginf=0.0)
            a = (a - np.clip(step, -1.0, 1.0)).astype(np.float32)
        return replace(samples, a=best)

    def _require_numbers(self, samples: Samples, *arrays: np.ndarray) -> None:
        wrong = ~np.isfinite(np.concatenate(arrays, axis=1)).all(axis=1)
        if wrong.any():
            raise InputError(
                f"{self.label}: the residual or its gradient is not finite with "
                f"{samples.words(int(np.flatnonzero(wrong)[0]))}; add a small number inside sqrt, length and division"
            )
