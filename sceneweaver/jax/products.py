"""Products with derivatives of measurements, as operations of JAX that have derivatives themselves.

A measurement f maps coordinates u [B, U] of layouts (poses, then values of parameters) to numbers [B, M]. Its
derivative J is never a matrix: ``push`` is J v, ``pull`` is J^T w, each linear in its last argument and the other
turned round. Their own change along u is ``bend_push`` and ``bend_pull``, differences of gradients over 1 mm and 1 mrad
(`sceneweaver.layout.difference`); as second derivatives are symmetric, these are each other turned round as well. So
everything may be differentiated twice, in any order of forwards and backwards. A third derivative raises an error.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any, NamedTuple, Protocol

import jax
import jax.numpy as jnp
from jax.core import ShapedArray
from jax.extend.core import Primitive
from jax.interpreters import ad, batching, mlir

from sceneweaver.layout import Problem, difference
from sceneweaver.scene import InputError


class Measurement(Protocol):
    """A function of coordinates, hashable: what an operation is about."""

    @property
    def problem(self) -> Problem:
        """What it is of."""
        ...

    def hint(self, u: jax.Array, which: jax.Array) -> jax.Array:
        """What `push` and `pull` want to know of a place [B, ...]."""
        ...

    def push(self, u: jax.Array, which: jax.Array, hint: jax.Array, v: jax.Array) -> jax.Array:
        """J v [B, M]."""
        ...

    def pull(self, u: jax.Array, which: jax.Array, hint: jax.Array, w: jax.Array) -> jax.Array:
        """J^T w [B, U]."""
        ...


class Operation(NamedTuple):
    """A primitive with the function that computes it."""

    primitive: Primitive
    compute: Callable


def _push(u: Any, which: Any, hint: Any, v: Any, *, of: Measurement) -> jax.Array:
    return of.push(u, which, hint, v)


def _pull(u: Any, which: Any, hint: Any, w: Any, *, of: Measurement) -> jax.Array:
    return of.pull(u, which, hint, w)


def _moved(of: Measurement, product: Callable, u: Any, which: Any, hint: Any, fixed: Any, along: Any) -> jax.Array:
    """The change of a product along a movement of its place."""
    twice, both = jnp.concatenate([which, which]), jnp.concatenate([fixed, fixed])

    def there(moved: jax.Array) -> jax.Array:
        place = moved[..., 0]
        return product(place, twice, of.hint(place, twice), both)

    return difference(jnp, there, product(u, which, hint, fixed), u[..., None], along[..., None])


def _bend_push(u: Any, which: Any, hint: Any, v: Any, along: Any, *, of: Measurement) -> jax.Array:
    return _moved(of, of.push, u, which, hint, v, along)


def _bend_pull(u: Any, which: Any, hint: Any, w: Any, along: Any, *, of: Measurement) -> jax.Array:
    return _moved(of, of.pull, u, which, hint, w, along)


def _operation(name: str, compute: Callable) -> Operation:
    primitive = Primitive(f"sceneweaver_{name}")
    primitive.def_impl(jax.jit(compute, static_argnames="of"))
    primitive.def_abstract_eval(lambda *args, of: ShapedArray(*_shape(compute, args, of)))
    mlir.register_lowering(primitive, mlir.lower_fun(compute, multiple_results=False))
    batching.primitive_batchers[primitive] = partial(_batched, primitive)
    return Operation(primitive, compute)


def _shape(compute: Callable, args: tuple, of: Measurement) -> tuple[tuple[int, ...], Any]:
    found = jax.eval_shape(partial(compute, of=of), *(jax.ShapeDtypeStruct(a.shape, a.dtype) for a in args))
    return found.shape, found.dtype


def _batched(primitive: Primitive, args: tuple, dims: tuple, *, of: Measurement) -> tuple[jax.Array, int]:
    """All examples are layouts of one batch."""
    size = next(a.shape[d] for a, d in zip(args, dims, strict=True) if d is not None)
    whole = [
        jnp.broadcast_to(a, (size, *a.shape)) if d is None else jnp.moveaxis(a, d, 0)
        for a, d in zip(args, dims, strict=True)
    ]
    found = primitive.bind(*(a.reshape(-1, *a.shape[2:]) for a in whole), of=of)
    return found.reshape(size, -1, *found.shape[1:]), 0


PUSH, PULL = _operation("push", _push), _operation("pull", _pull)
BEND_PUSH, BEND_PULL = _operation("bend_push", _bend_push), _operation("bend_pull", _bend_pull)


def _nothing(value: Any) -> Any:
    """The tangent of a constant."""
    return ad.Zero.from_primal_value(value)  # pyright: ignore[reportAttributeAccessIssue]


def _sum(*terms: Any) -> Any:
    """Tangents added up, those that are nothing left out."""
    found = None
    for term in terms:
        found = term if found is None else found if term is None else found + term
    return found


def _jvp(this: Operation, bend: Operation, primals: tuple, tangents: tuple, *, of: Measurement) -> tuple[Any, Any]:
    u, which, hint, v = primals
    du, dv = tangents[0], tangents[3]
    value = this.primitive.bind(*primals, of=of)
    bent = None if type(du) is ad.Zero else bend.primitive.bind(u, which, hint, v, du, of=of)
    other = None if type(dv) is ad.Zero else this.primitive.bind(u, which, hint, dv, of=of)
    found = _sum(bent, other)
    return value, _nothing(value) if found is None else found


def _bend_jvp(this: Operation, primals: tuple, tangents: tuple, *, of: Measurement) -> tuple[Any, Any]:
    u, which, hint, v, along = primals
    if type(tangents[0]) is not ad.Zero:
        raise InputError("third derivatives are not available: energy and residuals are differentiable twice")
    dv, da = tangents[3], tangents[4]
    value = this.primitive.bind(*primals, of=of)
    found = _sum(
        None if type(dv) is ad.Zero else this.primitive.bind(u, which, hint, dv, along, of=of),
        None if type(da) is ad.Zero else this.primitive.bind(u, which, hint, v, da, of=of),
    )
    return value, _nothing(value) if found is None else found


def _turned(other: Operation, up: Any, u: Any, which: Any, hint: Any, v: Any, *, of: Measurement) -> tuple:
    given = None if type(up) is ad.Zero else other.primitive.bind(u, which, hint, up, of=of)
    return None, None, None, given


def _bend_push_turned(up: Any, u: Any, which: Any, hint: Any, v: Any, along: Any, *, of: Measurement) -> tuple:
    """w . d(J v) along a = (d(J^T w) along v) . a, and the same with v and a exchanged."""
    if type(up) is ad.Zero:
        return None, None, None, None, None
    if ad.is_undefined_primal(v):
        return None, None, None, BEND_PULL.primitive.bind(u, which, hint, up, along, of=of), None
    return None, None, None, None, BEND_PULL.primitive.bind(u, which, hint, up, v, of=of)


def _bend_pull_turned(up: Any, u: Any, which: Any, hint: Any, w: Any, along: Any, *, of: Measurement) -> tuple:
    """c . d(J^T w) along a = w . (d(J c) along a) = (d(J^T w) along c) . a."""
    if type(up) is ad.Zero:
        return None, None, None, None, None
    if ad.is_undefined_primal(w):
        return None, None, None, BEND_PUSH.primitive.bind(u, which, hint, up, along, of=of), None
    return None, None, None, None, BEND_PULL.primitive.bind(u, which, hint, w, up, of=of)


ad.primitive_jvps[PUSH.primitive] = partial(_jvp, PUSH, BEND_PUSH)
ad.primitive_jvps[PULL.primitive] = partial(_jvp, PULL, BEND_PULL)
ad.primitive_jvps[BEND_PUSH.primitive] = partial(_bend_jvp, BEND_PUSH)
ad.primitive_jvps[BEND_PULL.primitive] = partial(_bend_jvp, BEND_PULL)
ad.primitive_transposes[PUSH.primitive] = partial(_turned, PULL)
ad.primitive_transposes[PULL.primitive] = partial(_turned, PUSH)
ad.primitive_transposes[BEND_PUSH.primitive] = _bend_push_turned
ad.primitive_transposes[BEND_PULL.primitive] = _bend_pull_turned


def push(of: Measurement, u: jax.Array, which: jax.Array, hint: jax.Array, v: jax.Array) -> jax.Array:
    """J v [B, M], differentiable by the place u and by v."""
    return PUSH.primitive.bind(u, which, jax.lax.stop_gradient(hint), v, of=of)
