"""The published JSON Schema of a scene, made from the models: ``scene.schema.json`` beside this file.

``python -m sceneweaver.scene.schema`` writes it anew. It says less than the models do: that polygons are simple, that
ids are unique and that names lead somewhere is checked on loading only.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

from sceneweaver.io import write_atomic

from .catalogue import CATALOGUE
from .migrate import SCHEMA
from .model import Scene

DIALECT = "https://json-schema.org/draft/2020-12/schema"
FILE = Path(__file__).with_name("scene.schema.json")


def json_schema() -> dict[str, Any]:
    """The JSON Schema (draft 2020-12) of a scene file; relation types are those of the catalogue at this moment."""
    data = Scene.model_json_schema(by_alias=True, mode="validation")
    _tidy(data)
    data["required"] = sorted({"schema", *data["required"]})
    data["properties"]["schema"] = {"const": SCHEMA, "description": "Name and version of this format"}
    relation = data["$defs"]["Relation"]["properties"]
    relation["type"] = {"enum": list(CATALOGUE), "description": relation["type"]["description"]}
    data["$defs"]["Relation"]["oneOf"] = [_relation(name) for name in CATALOGUE]
    head = {"$schema": DIALECT, "$id": f"urn:{SCHEMA.replace('/', ':')}", "title": "SceneWeaver scene"}
    return {**head, **data}


def text() -> str:
    """The text of ``scene.schema.json``."""
    return json.dumps(json_schema(), indent=1, ensure_ascii=False) + "\n"


def main() -> int:
    """Write ``scene.schema.json`` anew."""
    write_atomic(FILE, text())
    sys.stdout.write(f"{FILE}\n")
    return 0


def _relation(name: str) -> dict[str, Any]:
    """What one relation type asks of target and params."""
    spec = CATALOGUE[name]
    types = {"none": ["null"], "objects": ["array"]}.get(spec.target_kind, ["string"])
    types = [*types, "null"] if spec.target_optional and spec.target_kind != "none" else types
    params: dict[str, Any] = {}
    for key, param in spec.params.items():
        number: dict[str, Any] = {"type": "integer" if param.type == "integer" else "number"}
        for ours, theirs in (("minimum", "minimum"), ("maximum", "maximum"), ("exclusive_minimum", "exclusiveMinimum")):
            if getattr(param, ours) is not None:
                number[theirs] = getattr(param, ours)
        if param.type == "choice":
            number = {"enum": list(param.choices)}
        if param.type == "range":
            number = {"type": "array", "items": number, "minItems": 2, "maxItems": 2}
            number = {"anyOf": [{"const": param.default}, number]} if isinstance(param.default, str) else number
        unit = f" [{param.unit}]" if param.unit else ""
        number["description"] = param.description + unit
        if param.default is not None:
            number["default"] = param.default
        params[key] = number
    required = [key for key, param in spec.params.items() if param.required]
    allowed: dict[str, Any] = {"properties": params, "additionalProperties": False}
    if required:
        allowed["required"] = required
    out: dict[str, Any] = {
        "description": spec.description,
        "properties": {
            "type": {"const": name},
            "target": {"type": types[0] if len(types) == 1 else types},
            "params": allowed,
        },
    }
    if spec.target_kind == "wall":
        out["properties"]["target"]["pattern"] = "^wall:[0-9]+$"
    needed = [*([] if spec.target_optional else ["target"]), *(["params"] if required else [])]
    return {**out, "required": needed} if needed else out


def _tidy(node: Any) -> None:
    """Drop the titles that pydantic makes up from names, and what docstrings say about Python."""
    if isinstance(node, dict):
        if isinstance(node.get("description"), str):
            node["description"] = node["description"].split("\n\n")[0]
        if isinstance(node.get("title"), str):
            del node["title"]
        for value in node.values():
            _tidy(value)
    elif isinstance(node, list):
        for value in node:
            _tidy(value)


if __name__ == "__main__":
    raise SystemExit(main())
