"""``sceneweaver examples``."""

from __future__ import annotations

from pathlib import Path

import typer

import sceneweaver.scene
from sceneweaver.scene import EXAMPLES, Scene

from .output import print_json


def run_examples(*, as_json: bool) -> int:
    """List the bundled rooms with the paths of their files."""
    folder = Path(sceneweaver.scene.__file__).parent / "examples"
    rows = []
    for name in EXAMPLES:
        scene = Scene.example(name)
        rows.append(
            {
                "name": name,
                "objects": len(scene.objects),
                "relations": len(scene.relations),
                "prompt": scene.prompt,
                "path": str(folder / f"{name}.json"),
            }
        )
    if as_json:
        print_json({"examples": rows})
        return 0
    for row in rows:
        typer.secho(f"{row['name']}", bold=True, nl=False)
        typer.echo(f"  {row['objects']} objects, {row['relations']} relations: {row['prompt']}")
        typer.echo(f"  {row['path']}")
    return 0
