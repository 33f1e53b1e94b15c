"""Relations and terms of your own: one call enters them in the catalogue, the engine and the judge."""

from __future__ import annotations

import logging
from collections.abc import Iterable, Mapping
from typing import Any

from sceneweaver.layout.probe import Predicate, check_relation, check_term
from sceneweaver.layout.probe import check_gradient as check_gradient
from sceneweaver.layout.residual_cost import ResidualCost as ResidualCost
from sceneweaver.layout.residual_cost import residual_cost as residual_cost
from sceneweaver.layout.user import TERMS, WIDTH, enter_relation, enter_term, leave_relation, leave_term
from sceneweaver.scene import InputError, ParamSpec, RelationSpec
from sceneweaver.scene.catalogue import CATALOGUE, register_relation, unregister_relation
from sceneweaver.verify.relations import JUDGES, register_judge

log = logging.getLogger(__name__)


def define_relation(
    name: str,
    *,
    residual: Any,
    holds: Predicate,
    params: Mapping[str, float] | None = None,
    target: str = "object",
    scale: float = 1.0,
    ties_zones: bool = False,
    description: str = "",
    check: bool = True,
) -> None:
    """Define a relation type; scenes may use it from then on, on CPU and CUDA.

    Residual and predicate are tried first, at the same sample poses and sizes and with the defaults of the params: the
    residual has to be finite everywhere, also of two things at one pose, smooth, to have a gradient where something is
    missing, in metres by its scale, and to lead to poses at which it holds; the predicate has to say the same, also
    close to the edge, with other params and under other ids. What an evaluation costs is logged at level INFO by the
    logger ``sceneweaver.extend``, where someone listens; `residual_cost` measures it.

    Args:
        name: the relation's ``type``.
        residual: a ``wp.func`` ``f(a, b, size_a, size_b, p)`` of the poses (``wp.vec4`` x, y, z, yaw), the sizes
            (``wp.vec3``) and the params (``wp.vec4``), that is at most 0 where the relation holds and grows smoothly
            with what is missing. Without a target b is zero.
        holds: the judge's own test in Python: ``holds(subject, target, params) -> bool``.
        params: up to four numbers with their defaults, in the order in which they reach the residual.
        target: "object" or "none".
        scale: metres that a unit of the residual counts as.
        ties_zones: True exempts the two objects from each other's hard zones.
        description: what the type means, for catalogues and messages.
        check: False leaves out what is tried at sample poses, for a predicate that asks more of objects than their
            poses and sizes (the samples have the category "thing", no parts and no surfaces).

    Raises:
        InputError: the name is taken, the residual does not compile, or what was found at which sample poses: no
            number, not smooth, flat, never met, or a predicate that disagrees.

    Examples:
        >>> import sceneweaver as sw, warp as wp
        >>> @wp.func
        ... def higher(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
        ...     return b[2] + size_b[2] + p[0] - a[2]
        >>> def holds(subject, target, params):
        ...     top = target.pose.position[2] + target.size[2]
        ...     return subject.pose.position[2] >= top + params["by"]
        >>> sw.define_relation("higher", residual=higher, holds=holds, params={"by": 0.1})
        >>> sw.Relation(type="higher", subject="picture", target="bed").hard
        True
        >>> sw.undefine_relation("higher")
    """
    defaults = dict(params or {})
    if len(defaults) > WIDTH:
        raise InputError(f'relation "{name}": {len(defaults)} params; at most {WIDTH} reach a residual')
    if target not in ("object", "none"):
        raise InputError(f'relation "{name}": target "{target}" is not "object" or "none"')
    if not scale > 0:
        raise InputError(f'relation "{name}": scale {scale!r} is not a positive number')
    if name in CATALOGUE:
        raise InputError(f'relation "{name}" is there already; choose another name')
    if check:
        check_relation(f'relation "{name}"', residual, holds, defaults, scale, target == "object")
    _log_cost(f'relation "{name}"', residual)
    enter_relation(name, residual, scale)
    specs = {k: ParamSpec(k, "number", float(v), "", "") for k, v in defaults.items()}
    register_relation(RelationSpec(name, description, target=target, params=specs, ties_zones=ties_zones))

    def judge(case: Any) -> bool:
        numbers = {k: case.number(k) for k in defaults}
        return bool(holds(case.subject.item, case.target.item if case.target else None, numbers))

    register_judge(name, judge)


def undefine_relation(name: str) -> None:
    """Take back a relation defined here.

    Raises:
        InputError: it is built in or unknown.

    Examples:
        >>> import sceneweaver as sw
        >>> sw.undefine_relation("against_wall")
        Traceback (most recent call last):
            ...
        sceneweaver.io.errors.InputError: relation type "against_wall" is built in; ...
    """
    unregister_relation(name)
    del JUDGES[name]
    leave_relation(name)


def define_term(
    name: str,
    *,
    residual: Any,
    subjects: Iterable[str],
    targets: Iterable[str] | None = None,
    params: Iterable[float] = (),
    weight: float = 1.0,
    scale: float = 1.0,
) -> None:
    """Add a term to the energy of every scene that is compiled from then on, on CPU and CUDA.

    A term belongs to no relation: scenes, judge and critic know nothing of it. Among valid layouts it weighs as much as
    a soft relation, and it makes none invalid.

    Args:
        name: any text; it takes the term back (`undefine_term`).
        residual: a ``wp.func`` as for `define_relation`: what is above 0 costs.
        subjects: categories of the objects a; the term is taken for each such object of a room.
        targets: categories of the objects b: the term is taken for each pair. None: b is zero.
        params: up to four numbers that reach the residual.
        weight: how much it counts, 1 as much as a soft relation of weight 1.
        scale: metres that a unit of the residual counts as.

    Raises:
        InputError: the name is taken, a number is out of range, the residual does not compile, or what was found at
            which sample poses: no number, not smooth, flat, or never above 0.

    Examples:
        >>> import sceneweaver as sw, warp as wp
        >>> @wp.func
        ... def quiet(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
        ...     return p[0] - wp.length(wp.vec2(a[0] - b[0], a[1] - b[1]))
        >>> sw.define_term("quiet", residual=quiet, subjects=["bed"], targets=["speaker"], params=[2.0])
        >>> sw.undefine_term("quiet")
    """
    numbers = tuple(params)
    if name in TERMS:
        raise InputError(f'term "{name}" is there already; choose another name')
    if len(numbers) > WIDTH:
        raise InputError(f'term "{name}": {len(numbers)} params; at most {WIDTH} reach a residual')
    if isinstance(subjects, str) or isinstance(targets, str):
        raise InputError(f'term "{name}": subjects and targets are lists of categories')
    if not (weight > 0 and scale > 0):
        raise InputError(f'term "{name}": weight {weight!r} and scale {scale!r} have to be positive numbers')
    check_term(f'term "{name}"', residual, numbers, targets is not None)
    _log_cost(f'term "{name}"', residual)
    enter_term(name, residual, subjects, targets, numbers, weight, scale)


def undefine_term(name: str) -> None:
    """Take back a term.

    Raises:
        InputError: there is none of this name.

    Examples:
        >>> import sceneweaver as sw
        >>> sw.undefine_term("loud")
        Traceback (most recent call last):
            ...
        sceneweaver.io.errors.InputError: term "loud" is unknown
    """
    if name not in TERMS:
        raise InputError(f'term "{name}" is unknown')
    leave_term(name)


def _log_cost(label: str, residual: Any) -> None:
    if log.isEnabledFor(logging.INFO):
        log.info("%s: %s", label, residual_cost(residual))
