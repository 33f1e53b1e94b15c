"""The pictures of docs: forty designed rooms at eye level, and contact sheets of all furniture.

```
python -m benchmarks.gallery rooms --work /tmp/rooms --jobs 8 --device cuda:0   # designs, pictures, docs/gallery.md
python -m benchmarks.gallery sheets --device cuda:0                             # docs/images/assets-*.jpg
```

Rooms that are there already are not designed again.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from PIL import Image

from benchmarks.settings import ROOT
from sceneweaver.assets.category import read_yaml
from sceneweaver.scene import Scene

LIMIT = 180
"""Seconds that a design may take."""

WIDTH, HEIGHT = 960, 640
IMAGES = ROOT / "docs" / "images"
SHEETS = {
    "seating-beds": ("seating", "beds"),
    "tables-storage": ("tables", "storage"),
    "kitchen-bath": ("kitchen", "bathroom", "laundry", "hospitality"),
    "decor": ("lighting", "walls", "textiles", "plants", "decor", "outdoor", "generic"),
    "work-leisure": ("office", "gym", "kids", "workshop", "leisure", "clinic", "shop", "lab"),
    "small-1": ("tableware", "kitchenware", "cookware", "food", "books", "electronics", "desk_things"),
    "small-2": ("toys", "toiletries", "bath_small", "containers", "tools"),
    "small-3": ("music", "play", "games", "art", "ornaments"),
}
"""Contact sheets by the files of ``assets/categories`` that they show."""


def design(name: str, prompt: str, work: Path) -> None:
    """Design one room in a process of its own."""
    folder = work / name
    if (folder / "scene.json").exists():
        return
    command = [sys.executable, "-m", "sceneweaver", "design", prompt, "--seed", "7", "-o", str(folder)]
    command += ["--no-pictures", "--export", "none", "--time-limit", str(LIMIT)]
    subprocess.run(command, capture_output=True, timeout=2 * LIMIT, check=False)


def picture(name: str, work: Path, device: str) -> None:
    """Draw the eye view that shows most, as a light JPEG."""
    from sceneweaver.render import Quality, draw_room

    scene = Scene.load(work / name / "scene.json")
    size = 2 * WIDTH, 2 * HEIGHT
    drawn = draw_room(scene, None, "eye-corner", *size, quality=Quality.fine(), device=device)
    folder = IMAGES / "gallery"
    folder.mkdir(exist_ok=True)
    drawn.resize((WIDTH, HEIGHT), Image.Resampling.LANCZOS).save(folder / f"{name}.jpg", quality=84, optimize=True)


def page(rooms: dict[str, str], work: Path) -> str:
    """docs/gallery.md: a picture a room, what was asked, and what the judge says."""
    lines = [
        "# Gallery",
        "",
        f"{len(rooms)} rooms, each asked for in one sentence with seed 7, none left out, at eye level.",
    ]
    lines += ["`python -m benchmarks.gallery rooms` makes this page.", ""]
    for name, prompt in rooms.items():
        metrics = json.loads((work / name / "metrics.json").read_text())
        count = len(Scene.load(work / name / "scene.json").objects)
        valid = "valid" if metrics.get("valid") else "not valid"
        lines += [f"![{prompt}](images/gallery/{name}.jpg)", "", f"*{prompt}*: {count} objects, {valid}.", ""]
    return "\n".join(lines)


def sheets(device: str) -> None:
    """Draw the contact sheets again."""
    from sceneweaver.assets.parametric import make, makers
    from sceneweaver.render.studio import contact_sheet

    folder = ROOT / "sceneweaver" / "assets" / "categories"
    for sheet, files in SHEETS.items():
        names = [name for file in files for name in read_yaml(folder / f"{file}.yaml") if name in makers()]
        rows = [(name.replace("_", " "), make(name, 4)) for name in names]
        drawn = contact_sheet(rows, columns=12, tile=150, device=device)
        drawn.convert("RGB").save(IMAGES / f"assets-{sheet}.jpg", quality=82, optimize=True)
        print(sheet, len(names), flush=True)


def main() -> int:
    """Make rooms or sheets."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("rooms", "sheets"))
    parser.add_argument("--work", type=Path, default=Path("gallery"))
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--device", default="cpu")
    options = parser.parse_args()
    if options.what == "sheets":
        sheets(options.device)
        return 0
    rooms = read_yaml(Path(__file__).with_suffix(".yaml"))
    with ThreadPoolExecutor(options.jobs) as pool:
        list(pool.map(lambda name: design(name, rooms[name], options.work), rooms))
    done = {name: prompt for name, prompt in rooms.items() if (options.work / name / "scene.json").exists()}
    for name in done:
        picture(name, options.work, options.device)
    (ROOT / "docs" / "gallery.md").write_text(page(done, options.work))
    print(f"{len(done)} of {len(rooms)} rooms", *(f"missing: {n}" for n in rooms if n not in done), sep="\n")
    return 0 if len(done) == len(rooms) else 1


if __name__ == "__main__":
    raise SystemExit(main())
