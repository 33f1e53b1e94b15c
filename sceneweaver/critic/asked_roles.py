"""Whether a thing can serve as another: a crate "as a table", a trunk that "doubles as a bench"."""

from __future__ import annotations

from sceneweaver.assets import categories, resolve
from sceneweaver.assets.plurals import singular
from sceneweaver.language.vocabulary import words
from sceneweaver.rules.faults import fault_kind
from sceneweaver.verify.solids import Body

AS = "as "
"""What the value of such an attribute begins with; the noun follows."""


def serves_as(body: Body, noun: str) -> tuple[bool, str] | None:
    """Whether a body is about as high as what it is to serve as, and how high it is; None where no height is known."""
    name = singular(noun)
    match = resolve(name)
    rows = [categories().get(n) for n in (match.category, *words("nouns")["kinds"].get(name, ()))]
    heights = [row.size.height for row in rows if row is not None and row.size is not None]
    if match.how == "generic" or not heights:
        return None
    factor = fault_kind("wrong_asked_size").limits["medium"]
    low, high = min(h[0] for h in heights), max(h[1] for h in heights)
    top = float(body.size[2])
    return low / factor <= top <= high * factor, f"{top:.2f} m high"


__all__ = ["AS", "serves_as"]
