"""Models of RoboCasa's fixtures in the user's folder: which one a style names, and how large it is."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from sceneweaver.io import InputError, load_xml, load_yaml

_STYLE = "style*.yaml"


@dataclass(frozen=True)
class FixtureModel:
    """A model: (width, depth, height) [m] between its exterior sites, and their middle from its origin."""

    name: str
    size: tuple[float, float, float]
    offset: tuple[float, float, float]


class FixtureModels:
    """The models that a style names: ``style001.yaml`` beside the layout or in the folder, models in the folder."""

    def __init__(self, layout: Path, folder: Path | None):
        self.style: Path | None = None
        self._names: dict[str, Any] = {}
        self._models: dict[str, FixtureModel | None] = {}
        self._files = {} if folder is None else {p.parent.name: p for p in sorted(folder.rglob("model.xml"))}
        found = sorted(layout.parent.glob(_STYLE)) or (sorted(folder.rglob(_STYLE)) if folder is not None else [])
        if found:
            self.style = found[0]
            data = load_yaml(self.style)
            self._names = data if isinstance(data, dict) else {}

    def find(self, kind: str) -> FixtureModel | None:
        """The model that stands for a type of fixture, where style and model are there."""
        name = self._names.get(kind)
        if not isinstance(name, str) or name not in self._files:
            return None
        if name not in self._models:
            self._models[name] = _measured(name, self._files[name])
        return self._models[name]


def _measured(name: str, path: Path) -> FixtureModel | None:
    """A model by its sites ext_p0, ext_px, ext_py and ext_pz; None where it has none."""
    sites: dict[str, list[float]] = {}
    for site in load_xml(path).iter("site"):
        try:
            sites[str(site.get("name"))] = [float(v) for v in (site.get("pos") or "0 0 0").split()]
        except ValueError:
            raise InputError(f"{path.parent.name}/{path.name}: site {site.get('name')}: pos must be numbers") from None
    corners = [sites.get(f"ext_{end}") for end in ("p0", "px", "py", "pz")]
    if any(c is None or len(c) != 3 for c in corners):
        return None
    p0, *ends = (c for c in corners if c is not None)
    x, y, z = (abs(end[k] - p0[k]) for k, end in enumerate(ends))
    if min(x, y, z) <= 0:
        return None
    a, b, c = ((end[k] + p0[k]) / 2 for k, end in enumerate(ends))
    return FixtureModel(name, (x, y, z), (a, b, c))
