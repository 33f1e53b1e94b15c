"""The sections of the report, each a piece of HTML; empty where there is nothing to show."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from sceneweaver.knowledge.palettes import palettes
from sceneweaver.report.html import esc

from . import charts
from .charts import box_of, extent_of, image_url, path_of
from .collect import Gathered

_SPREADS = {
    "area": "Floor area [m²]",
    "object_count": "Objects",
    "relation_count": "Relations",
    "grade": "Grade by the critic, of 10",
    "clutter": "Clutter asked for",
    "walkable_share": "Floor that can be walked on",
    "openable_share": "Doors and drawers that open",
    "relations_satisfied": "Relations that hold",
}
_CONTENTS = {"room_type": "Rooms", "split": "Splits", "licence": "Licences of assets"}
_GATES = {
    "status": "Requests",
    "reasons": "Why scenes are missing",
    "gates_failed": "Gates not passed at last",
    "attempt": "Attempts before the delivered one",
    "unmet": "Wishes not met, of delivered scenes",
}
_MAPS, _NAMES, _OUTLINES, _SCALE = 18, 26, 60, 9.0  # heat maps, names of the matrix, shells; widest shell drawn [m]


def section(title: str, body: str, aside: str = "") -> str:
    """A titled section; nothing without a body."""
    if not body:
        return ""
    note = f'<p class="aside">{aside}</p>' if aside else ""
    return f"<section><h2>{esc(title)}</h2>{note}{body}</section>"


def header(name: str, numbers: Mapping[str, Any], verification: Mapping[str, Any] | None, whole: bool) -> str:
    """What it is, in a line, whether it was verified, and the numbers that matter most."""
    variety, layouts = numbers["diversity"], numbers.get("layouts")
    noun = "layouts" if layouts else "scenes"
    tags = []
    if not whole:
        tags.append('<span class="tag fair">still being made</span>')
    if verification is not None:
        good = verification["ok"]
        judged = verification["counts"].get("judged", 0)
        text = (
            f"{judged:,} {'layouts' if layouts else 'scenes'} judged again: all holds"
            if good
            else "verification found faults"
        )
        tags.append(f'<span class="tag {"good" if good else "bad"}">{text}</span>')
    tiles = [
        (f"{layouts or numbers['scenes']:,}", noun),
        (f"{numbers['rooms']:,}", "programs" if layouts else "rooms"),
        (f"{numbers['objects']:,}", "objects in programs" if layouts else "objects"),
        (_percent(numbers["served"]), "of requests served"),
        (f"{numbers['invalid']:,}", "of these not valid"),
        (_percent(variety["near_duplicate_share"]) if whole else "\u2013", "near-duplicates"),
        (f"{variety['categories']:,}", "categories"),
        (_size(numbers["bytes"]), f"of {noun}"),
    ]
    cells = "".join(f"<div><b>{value}</b><span>{label}</span></div>" for value, label in tiles)
    return (
        f'<header><p class="eyebrow">Data set of {noun}</p><h1>{esc(name)}</h1>'
        f'<p class="tags">{"".join(tags)}</p><div class="tiles">{cells}</div></header>'
    )


def wall(found: Gathered) -> str:
    """Plans of a sample with a filter."""
    if not found.wall:
        return ""
    kinds = sorted({row["room_type"] or "" for row in found.wall.values()})
    options = "".join(f'<option value="{esc(kind)}">{esc(_words(kind))}</option>' for kind in kinds)
    most = max((row["object_count"] or 0 for row in found.wall.values()), default=0)
    cards = "".join(_card(row, found.plans[key]) for key, row in found.wall.items() if key in found.plans)
    return section(
        "Samples",
        f'<form class="filter" id="filter"><label>Room <select name="kind"><option value="">all kinds</option>{options}'
        '</select></label><label>Grade from <input name="grade" type="range" min="0" max="10" step="0.1" value="0">'
        '<output name="grade-shown">0</output></label><label>Objects up to '
        f'<input name="objects" type="range" min="0" max="{most}" step="1" value="{most}">'
        f'<output name="objects-shown">{most}</output></label><span id="count" role="status"></span></form>'
        f'<div class="wall" id="wall">{cards}</div><button type="button" id="more" hidden>Show more</button>',
        "The kinds of rooms take turns. Point at a plan to read its request.",
    )


def _card(row: Mapping[str, Any], svg: str) -> str:
    grade = row["grade"]
    shown = "" if grade is None else f"<b>{grade:.1f}</b>"
    return (
        f'<figure data-kind="{esc(row["room_type"] or "")}" data-grade="{10 if grade is None else grade:.3f}" '
        f'data-objects="{row["object_count"] or 0}" title="{esc(row["prompt"] or "")}">'
        f'<img loading="lazy" alt="Plan: {esc(row["prompt"] or row["key"])}" src="{image_url(svg)}">'
        f"<figcaption><span>{esc(_words(row['room_type'] or ''))}</span>{shown}"
        f"<small>{row['object_count'] or 0} objects · {esc(row['key'])}</small></figcaption></figure>"
    )


def contents(found: Gathered) -> str:
    """Kinds of rooms, splits and the spread of what is measured of each scene."""
    numbers = found.numbers
    parts = _panels(numbers, numbers["scenes"], _CONTENTS)
    spreads = {name: spread for name, spread in numbers["spreads"].items() if spread["count"]}
    parts_of = "".join(
        f"<div><h3>{_SPREADS[name]}</h3>{charts.histogram(spread, percent=spread['high'] == 1.0)}"
        f"<small>{_spread_text(spread)}</small></div>"
        for name, spread in spreads.items()
    )
    return section("What is in it", f'<div class="columns">{parts}</div>') + section(
        "Spread", f'<div class="grid">{parts_of}</div>', "Over the delivered scenes; the dashed line is the mean."
    )


def places(found: Gathered) -> str:
    """Heat maps of positions by category."""
    often = sorted(found.heat, key=lambda name: (-float(found.heat[name].sum()), name))[:_MAPS]
    maps = "".join(
        f"<figure>{charts.heat_map(found.heat[name])}<figcaption><span>{esc(_words(name))}</span>"
        f"<small>{int(found.heat[name].sum()):,} placed</small></figcaption></figure>"
        for name in often
    )
    return section(
        "Where things stand",
        f'<div class="maps">{maps}</div>' if maps else "",
        "Every room is turned for its first door to be in the lower side, and stretched to a square. "
        "Brightest to darkest: never to most often.",
    )


def together(found: Gathered) -> str:
    """What stands in the same rooms, ordered so that what belongs together lies side by side."""
    from scipy.cluster.hierarchy import leaves_list, linkage
    from scipy.spatial.distance import squareform

    names = [name for name, _ in sorted(found.present.items(), key=lambda pair: (-pair[1], pair[0]))[:_NAMES]]
    if len(names) < 3:
        return ""
    share = np.eye(len(names))
    for a, first in enumerate(names):
        for b, second in enumerate(names[:a]):
            both = found.together[min(first, second), max(first, second)]
            either = found.present[first] + found.present[second] - both
            share[a, b] = share[b, a] = both / either if either else 0.0
    order = leaves_list(linkage(squareform(1.0 - share, checks=False), "average", optimal_ordering=True))
    names = [_words(names[k]) for k in order]
    return section(
        "What stands together",
        charts.matrix(names, share[np.ix_(order, order)]),
        f"The {len(names)} categories that stand on the floor of most scenes. The darker a square, the larger the "
        "share of scenes with either that have both.",
    )


def relations(found: Gathered) -> str:
    """How often each relation is asked for."""
    total: Counter[str] = Counter()
    for (name, _), count in found.relations.items():
        total[name] += count
    often = sorted(total.items(), key=lambda pair: (-pair[1], pair[0]))
    rows = [(_words(name), n, f"{n:,} ({found.relations[name, True]:,} hard)") for name, n in often]
    return section("Relations", _card_of(charts.bars(rows)) if rows else "", "What the scenes ask for, by type.")


def shells(found: Gathered) -> str:
    """Outlines of rooms, all to one scale."""
    if not found.shells:
        return ""
    ranked = sorted(found.shells.items(), key=lambda pair: (len(pair[1][0]), _area(pair[1][0]), pair[0]))
    shown = [ranked[k][1] for k in np.linspace(0, len(ranked) - 1, min(_OUTLINES, len(ranked))).round().astype(int)]
    widest = max(extent_of(outline) for outline, _ in shown)
    drawn = "".join(_shell(outline, count, min(1.0, _SCALE / widest)) for outline, count in shown)
    corners: Counter[int] = Counter()
    for outline, count in found.shells.values():
        corners[len(outline)] += count
    total = corners.total()
    table = charts.bars([(f"{n} walls", count, _percent(count / total)) for n, count in sorted(corners.items())])
    return section(
        "Shells of rooms",
        f'{_card_of(table)}<div class="shells">{drawn}</div>',
        f"{len(found.shells):,} outlines that differ by 5 cm or more, in {found.read:,} scenes.",
    )


def _shell(outline: Sequence[Sequence[float]], count: int, scale: float) -> str:
    left, low, right, high = box_of(outline)
    width, height = (right - left) * scale, (high - low) * scale
    box = f"{100 * left - 6:.0f} {-100 * high - 6:.0f} {100 * (right - left) + 12:.0f} {100 * (high - low) + 12:.0f}"
    return (
        f'<svg viewBox="{box}" style="width:{0.75 * width:.2f}rem;height:{0.75 * height:.2f}rem">'
        f'<title>{_area(outline):.1f} m², {count} scenes</title><path d="{path_of(outline)}"/></svg>'
    )


def _area(outline: Sequence[Sequence[float]]) -> float:
    points = np.asarray(outline, dtype=float)
    x, y = points[:, 0], points[:, 1]
    return abs(float(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))) / 2


def coverage(found: Gathered) -> str:
    """How much of the knowledge base is used."""
    known, covered = palettes(), found.numbers["coverage"]
    used = len(found.palettes.keys() & known.keys())
    rows = [
        ("kinds of rooms", covered["room_types"]["seen"], covered["room_types"]["known"]),
        ("categories", covered["categories"]["seen"], covered["categories"]["known"]),
        ("palettes", used, len(known)),
    ]
    drawn = charts.bars([(name, seen / of, f"{seen} of {of}") for name, seen, of in rows], 1.0)
    unseen = {name: covered[name]["unseen"] for name in ("room_types", "categories")}
    unseen["palettes"] = sorted(set(known) - found.palettes.keys())
    lists = "".join(
        f"<details><summary>{_words(kind)} not used: {len(names)}</summary><p>{esc(', '.join(map(_words, names)))}</p>"
        "</details>"
        for kind, names in unseen.items()
        if names
    )
    variety = found.numbers["diversity"]
    facts = (
        f"Entropy of categories: {variety['category_entropy']:.2f} bits, as of "
        f"{variety['effective_categories']:.0f} equally frequent ones. Distinct layouts by signature: "
        f"{variety['layout_signatures']:,}."
    )
    return section("Coverage of the knowledge base", _card_of(drawn + lists), facts)


def gates(found: Gathered) -> str:
    """What was not delivered, and why."""
    numbers = found.numbers
    parts = _panels(numbers, numbers["requests"], _GATES)
    return section("Delivered and not", f'<div class="columns">{parts}</div>')


def _panels(numbers: Mapping[str, Any], total: int, titles: Mapping[str, str]) -> str:
    """Bars of some tallies of the statistics, by name; those that say nothing are left out."""
    return "".join(
        f"<div><h3>{title}</h3>{charts.bars(_counted(numbers[name], total or 1))}</div>"
        for name, title in titles.items()
        if numbers[name] and set(numbers[name]) != {"0"}
    )


def near_duplicates(found: Gathered) -> str:
    """Pairs side by side."""
    pairs = "".join(
        f'<div class="pair">{"".join(_twin(key, found.plans[key]) for key in pair)}</div>'
        for pair in found.pairs
        if all(key in found.plans for key in pair)
    )
    return section("Near-duplicates", f'<div class="pairs">{pairs}</div>' if pairs else "", "They share a split.")


def _twin(key: str, svg: str) -> str:
    return f'<figure><img loading="lazy" alt="" src="{image_url(svg)}"><figcaption>{esc(key)}</figcaption></figure>'


def progress(records: Sequence[Mapping[str, Any]]) -> str:
    """How the run went."""
    if not records:
        return ""
    parts = f"<div><h3>Scenes a second</h3>{charts.throughput_svg(records)}</div>"
    if charts.memory(records):
        parts += f"<div><h3>Memory of each worker</h3>{charts.memory_svg(records)}</div>"
    hosts = len({record.get("host") for record in records})
    workers = len({(record.get("host"), record.get("worker")) for record in records})
    aside = f"{len(records):,} blocks by {workers} workers on {hosts} machine{'s' if hosts != 1 else ''}."
    return section("The run", f'<div class="columns wide">{parts}</div>', aside)


def _card_of(body: str) -> str:
    return f'<div class="columns"><div>{body}</div></div>'


def _counted(tally: Mapping[str, int], total: int) -> list[tuple[str, float, str]]:
    return [(_words(name), count, f"{count:,} ({_percent(count / total)})") for name, count in tally.items()]


def _spread_text(spread: Mapping[str, Any]) -> str:
    scale, unit = (100, " %") if spread["high"] == 1.0 else (1, "")
    mean, least, most = (scale * spread[key] for key in ("mean", "least", "most"))
    return f"mean {mean:.3g}{unit}, from {least:.3g} to {most:.3g}{unit}"


def _words(name: str) -> str:
    return name.replace("_", " ")


def _percent(share: float) -> str:
    return f"{100 * share:.1f} %" if share < 0.9995 or share == 1.0 else f"{100 * share:.2f} %"


def _size(count: float) -> str:
    units = ["bytes", "kB", "MB", "GB"]
    while count >= 999.5 and len(units) > 1:
        count /= 1000
        units.pop(0)
    return f"{count:.3g} {units[0]}"
