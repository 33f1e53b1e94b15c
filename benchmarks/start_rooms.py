"""The rooms of docs/starts.md: one request with each way to begin, and one scene of another system gone on from.

python -m benchmarks.start_rooms --work out/starts [--device cuda:0]

Designs, pictures, and the parts of the page between its marks; rooms and pictures that the folder has already are not
made again. The scenes of another system and what the scripted model says are in ``data/starts``.
"""

from __future__ import annotations

import argparse
import re
import shutil
import textwrap
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from PIL import Image

import sceneweaver as sw
from benchmarks.gallery import IMAGES
from benchmarks.settings import ROOT
from sceneweaver.agent import Result
from sceneweaver.knowledge.load import read_yaml
from sceneweaver.render import Quality, draw_room
from tests.agent.by_model.scripted import Script

REQUEST = "a bedroom with a double bed, two nightstands and a wardrobe, without a television"
SEED, STEPS = 7, 6
DATA = Path(__file__).with_name("data") / "starts"
OUTPUTS = "layoutgpt_bedrooms.json"
GONE_ON = "2ad0682d-77c6-420a-bc7c-157447bc6481_MasterBedroom-76652"
"""The room that is gone on from."""

PAGE = ROOT / "docs" / "starts.md"
LINE = 120
"""Characters of a line of the page."""

TALLER = 12
"""Pixels between two pictures."""

SIZE = 560, 400
"""Of a picture at eye level, in pixels; those from above are as wide."""

WAYS: Mapping[str, str] = {
    "library": "`--init library`: the scene of our own library that is most like the request, adapted",
    "model": "`--init model --scene-model FOLDER`: of LayoutGPT's rooms the one nearest to the request, as it is, "
    "then mended and completed",
    "llm": "`--init llm`: what a language model writes down. No model was asked here: the reply is scripted "
    "(`benchmarks/data/starts/programme.yaml`)",
    "prior": "`--init prior`: our draft, its poses drawn by the learned prior",
}


def options(way: str, outputs: Path) -> dict[str, Any]:
    """The arguments of a design that begins in one way."""
    more: dict[str, dict[str, Any]] = {
        "model": {"scene_model": outputs},
        "llm": {"model": Script(read_yaml((DATA / "programme.yaml").read_text("utf-8"))).client},
    }
    return {"init": way, **more.get(way, {})}


def design(folder: Path, device: str, **more: Any) -> Result:
    """One design; where its folder is there already it goes on there, which a finished one does at once."""
    common: dict[str, Any] = {"seed": SEED, "steps": STEPS, "time_limit": None, "pictures": "none", "export": "none"}
    return sw.design(REQUEST, out=folder, device=device, **common, **more)


def picture(scene: sw.Scene, file: Path, device: str) -> None:
    """A room at eye level over the room from above, as a light JPEG among the pictures of docs; drawn once."""
    folder = IMAGES / "starts"
    folder.mkdir(exist_ok=True)
    if not file.exists():
        _drawn(scene, device).save(file, quality=82, optimize=True)
    shutil.copy(file, folder / file.name)


def _drawn(scene: sw.Scene, device: str) -> Image.Image:
    width, height = SIZE
    eye = draw_room(scene, None, "eye-corner", 2 * width, 2 * height, quality=Quality.fine(), device=device)
    above = draw_room(scene, None, "top", 2 * width, 2 * width, quality=Quality.normal(), device=device)
    above = above.resize((width, round(width * above.height / above.width)), Image.Resampling.LANCZOS)
    sheet = Image.new("RGB", (width, height + TALLER + width), "white")
    sheet.paste(eye.resize(SIZE, Image.Resampling.LANCZOS), (0, 0))
    above.thumbnail((width, width))
    sheet.paste(above, ((width - above.width) // 2, height + TALLER))
    return sheet.convert("RGB")


def facts(result: Result) -> list[str]:
    """What became of a request, and of the scene that it began with."""
    found, report = result.review.alignment.summary, result.report
    grade = sum(result.review.grades.values()) / len(result.review.grades)
    verdict = "valid" if report.valid else "not valid"
    lines = [
        f"{len(result.scene.objects)} objects, {verdict}, {found['met']} of {found['total']} items as asked, "
        f"mean grade {grade:.1f}, {len(result.steps)} steps: "
        + ", ".join(f"`{step.call.tool}`" for step in result.steps if step.call is not None and step.accepted)
    ]
    return [*lines, *(result.start.lines if result.start is not None else ())]


def table(results: Mapping[str, Result]) -> str:
    """The four rooms side by side, and a list of what each is; pictures by reference, as a row is one line."""
    rows = ["| " + " | ".join(results) + " |", "| " + " | ".join("---" for _ in results) + " |"]
    rows.append("| " + " | ".join(f"![{way}]" for way in results) + " |")
    text = ["\n".join(rows), "\n".join(f"[{way}]: images/starts/{way}.jpg" for way in results)]
    for way, result in results.items():
        lines = [f"**{way}**, {WAYS[way]}:", "", *(f"- {line}" for line in facts(result))]
        lines += [
            f"- {note}" for note in result.notes[:3] if note.startswith(("begun", "took", "a model", "init prior"))
        ]
        text.append("\n".join(lines))
    return "\n\n".join(text)


def refined(result: Result, before: sw.Report) -> str:
    """What going on from a scene changed."""
    hard = [v for v in before.violations if v.hard]
    kinds = ", ".join(f"{sum(v.kind == k for v in hard)} {k}" for k in sorted({v.kind for v in hard}))
    lines = [f"- as it came: {kinds or 'nothing wrong'}", *(f"- {line}" for line in facts(result))]
    return (
        "| as LayoutGPT wrote it | gone on from |\n| --- | --- |\n| ![before](images/starts/before.jpg) | "
        "![after](images/starts/after.jpg) |\n\n" + "\n".join(lines)
    )


def put(page: str, mark: str, text: str) -> str:
    """The page with other text between two marks."""
    begin, end = f"<!-- {mark} -->", f"<!-- end of {mark} -->"
    return re.sub(f"{re.escape(begin)}.*?{re.escape(end)}", lambda _: f"{begin}\n\n{text}\n\n{end}", page, flags=re.S)


def wrapped(page: str) -> str:
    """The page with its long lines of lists and paragraphs broken; tables stay."""
    lines = []
    for line in page.splitlines():
        if len(line) <= LINE or line.startswith("|"):
            lines.append(line)
        else:
            inset = "  " if line.startswith("- ") else ""
            lines += textwrap.wrap(line, LINE, subsequent_indent=inset, break_on_hyphens=False, break_long_words=False)
    return "\n".join(lines) + "\n"


def main() -> None:
    """Make the rooms, their pictures and the page."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.start_rooms", description=main.__doc__)
    parser.add_argument("--work", type=Path, default=Path("out/starts"))
    parser.add_argument("--device", default="cpu")
    given = parser.parse_args()
    outputs = given.work / "layoutgpt"  # a copy: an index is written beside the files
    outputs.mkdir(parents=True, exist_ok=True)
    shutil.copy(DATA / OUTPUTS, outputs / OUTPUTS)
    results = {}
    for way in WAYS:
        results[way] = design(given.work / way, given.device, **options(way, outputs))
        print(way, *facts(results[way]), sep="\n  ")
        picture(results[way].scene, given.work / f"{way}.jpg", given.device)
    one = design(given.work / "gone_on_from", given.device, start=f"{outputs / OUTPUTS}#{GONE_ON}")
    origin = sw.Scene.load(given.work / "gone_on_from" / "start.json")
    print("gone on from", *facts(one), sep="\n  ")
    picture(origin, given.work / "before.jpg", given.device)
    picture(one.scene, given.work / "after.jpg", given.device)
    page = put(PAGE.read_text("utf-8"), "four rooms", table(results))
    page = put(page, "gone on from", refined(one, sw.check(origin)))
    page = page.replace(f"{given.work}/", "").replace(f"layoutgpt/{OUTPUTS}#{GONE_ON}", "the room that LayoutGPT wrote")
    PAGE.write_text(wrapped(page), "utf-8")


if __name__ == "__main__":
    main()
