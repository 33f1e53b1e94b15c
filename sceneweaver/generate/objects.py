"""Single objects with bodies for a scene: placed by their relations or where such things usually go."""

from __future__ import annotations

import random
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from sceneweaver.assets import Asset, Wish, drawable, resolve
from sceneweaver.assets.roles import has_role
from sceneweaver.assets.taxonomy import category_named, likeliness
from sceneweaver.knowledge import Item, Place
from sceneweaver.scene import InputError, Intent, Pose, SceneObject
from sceneweaver.scene.edits import Add, AnyEdit, Relate

from .draft import Draft
from .hanging import OVER, before_window, hanging_height, hung_between, is_lit_table
from .program import free_zones, suite_of
from .relating import place_of, relations_of
from .setup import Setup
from .surface_spots import fits_on, spot_on
from .usual import item_for, places_for


@dataclass
class Added:
    """What some rows became: edits, what was decided, and what could not be done."""

    setup: Setup
    draft: Draft
    told: bool
    edits: list[AnyEdit] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    unmet: list[str] = field(default_factory=list)


def added(setup: Setup, rows: Sequence[Mapping[str, Any]], told: bool = True) -> Added:
    """Objects for rows as the card of ``add_objects`` has them.

    Args:
        setup: the scene that they are added to.
        rows: of ``objects``.
        told: whether a caller names them; else they are read from a sentence, and all count as asked for.

    Raises:
        InputError: for a relation that is none.
    """
    work = Added(setup, Draft.of(setup.scene), told)
    for k, row in enumerate(rows):
        _add(work, row, k)
    return work


def _add(work: Added, row: Mapping[str, Any], number: int) -> None:
    """All objects of one entry."""
    setup, draft = work.setup, work.draft
    where = f"tool add_objects: inputs.objects[{number}]"
    match = resolve(row["category"], "surface" if row.get("on") else row.get("mount"))
    if match.note and match.how != "spelling":
        work.notes.append(match.note)
    item = item_for(setup.room_type, match.category, draft, row.get("item"))
    places = [place_of(p, f"{where}.place[{i}]") for i, p in enumerate(row.get("place", ()))]
    on = row.get("on")
    asked_on = [on] if isinstance(on, str) else list(on or ())
    asked_on += [word for p in places if p.type in ("on_top", "inside") for word in p.targets]
    places = [p for p in places if p.type not in ("on_top", "inside", "on_floor")]
    count = int(row.get("count", 1))
    mount = _mount(row, match.category, item, asked_on)
    try:
        assets = _bodies(work, row, match.category, item, places, count, number, mount)
    except InputError as error:
        work.unmet.append(f"{row['category']}: {error}")
        return
    for k, asset in enumerate(assets):
        if mount == "floor" and asset.size[2] > 0.02 and draft.crammed(asset.size, asset.category):
            work.unmet.append(f"{len(assets) - k} of {count} {match.category}: the floor or the walls are full")
            return
        subject = _object(work, row, asset, item, mount, asked_on, k, number)
        if subject is None:
            place = " or ".join(asked_on) or "what is in the room"
            work.unmet.append(f"{len(assets) - k} of {count} {match.category}: there is no free place on {place}")
            return
        draft.objects[subject.id] = subject
        work.edits.append(Add(object=subject))
        relations, failed = relations_of(draft, places, subject, count)
        work.unmet += failed
        if not relations:
            relations, _ = relations_of(draft, places_for(draft, item, subject), subject)
        draft.relations += relations
        work.edits += [Relate(relation=r) for r in relations]


def _mount(row: Mapping[str, Any], category: str, item: Item | None, on: Sequence[str]) -> str:
    if on:
        return "surface"
    known = category_named(category).mount
    wanted = row.get("mount") or (item.mount if item is not None else None)
    if wanted is None and item is not None and item.on and "surface" in known:
        return "surface"
    return wanted or known[0]


def _bodies(
    work: Added,
    row: Mapping[str, Any],
    category: str,
    item: Item | None,
    places: Sequence[Place],
    count: int,
    number: int,
    mount: str,
) -> list[Asset]:
    """Bodies for all of an entry: like those of its set that are there, equal ones, or for small things different."""
    setup, draft, room = work.setup, work.draft, work.setup.scene.room
    free = not any(row.get(k) for k in ("size", "color", "material", "style", "words"))
    same = item.same if item is not None else mount != "surface" and not has_role(category, "assorted")
    if same and free:
        twin = next((o for o in draft.objects.values() if o.category == category and o.asset is not None), None)
        if twin is not None and twin.asset is not None and twin.mount == mount:
            try:
                return [setup.library.load(twin.asset).of_style(twin.attributes.get("style"))] * count
            except InputError:
                pass  # the asset came from a source that is not there now; another one has to do
    wish = replace(_wish(setup, row, item, setup.seed + 101 * number), mount=mount)
    if mount == "wall" and has_role(category, "window_cover") and room.windows:
        top = max(w.sill + w.height for w in room.windows)
        pane = max(w.width for w in room.windows), room.windows[0].height, top
        wish = before_window(wish, category, pane, room.height)
    if mount == "ceiling" and wish.size[2] is None:
        over = [p.to for p in places or (item.place if item is not None else ()) if p.type in OVER and p.to]
        under = [draft.objects[id] for word in over for id in draft.named(word)]
        low = next((o.size[2] for o in under if is_lit_table(o.category, o.size[2])), None)
        drop = hanging_height(category, room.height, low)
        wish = replace(wish, size=(*wish.size[:2], drop)) if drop is not None else wish
    return setup.library.choose(category, count, wish, same)


def _wish(setup: Setup, row: Mapping[str, Any], item: Item | None, seed: int) -> Wish:
    rng = random.Random(seed)
    size: list[float | None] = [None, None, None]
    if item is not None:
        size = [None if r is None else round(rng.uniform(*r), 3) for r in item.size]
    said = drawable(resolve(row["category"]).category, row["words"]).size if row.get("words") else (None, None, None)
    if any(extent is not None for extent in said):
        size = list(said)
    for k, given in enumerate(row.get("size", ())):
        size[k] = given if given is not None else size[k]
    palette = setup.scene.palette
    style = row.get("style") or setup.brief.style or (palette.style if palette is not None else None)
    return Wish(
        size=(size[0], size[1], size[2]),
        color=row.get("color") or (item.color if item is not None else None),
        material=row.get("material"),
        style=style,
        palette=palette.code if palette is not None else None,
        words=row.get("words", ""),
        seed=seed % 2**31,
        count=1,
        beyond=any(extent is not None for extent in said),
        suite=suite_of(item, palette.seed) if palette is not None else None,
    )


def _object(
    work: Added,
    row: Mapping[str, Any],
    asset: Asset,
    item: Item | None,
    mount: str,
    on: Sequence[str],
    k: int,
    number: int,
) -> SceneObject | None:
    """One scene object; None when it should stand on something and nothing has room for it."""
    setup, draft = work.setup, work.draft
    asked = row.get("asked") or _asked(setup, draft, asset.category)
    fallback = item.need if item is not None else "usual"
    priority = row.get("need") or ("asked" if asked is not None or not work.told else fallback)
    id, support, pose, heights = draft.fresh(asset.category), None, Pose(), None
    room_height = draft.room.height
    if mount == "surface":
        supports = _supports(draft, asset, item, on)
        found = spot_on(draft.objects, draft.room, supports, asset.size, setup.seed + 13 * number + k)
        if found is None:
            return None
        support, pose = found
    elif mount == "ceiling":
        pose = Pose(position=(0.0, 0.0, max(0.0, room_height - asset.size[2])))
    elif mount == "wall":
        heights = hung_between(asset, item, room_height)
        pose = Pose(position=(0.0, 0.0, sum(heights) / 2))
    intent = Intent(
        priority=priority,
        request=asked,
        program_item=item.id if item is not None else None,
        mounting_height=heights,
        keep_clear=mount == "wall" and not has_role(asset.category, "window_cover"),
    )
    obj = asset.object(id, pose=pose, mount=mount, support=support)  # type: ignore[arg-type]
    return obj.model_copy(update={"intent": intent, "zones": free_zones(item, obj)})


def _asked(setup: Setup, draft: Draft, category: str) -> str | None:
    """What in the request an object of that category stands for, where the request has more than there are."""
    for asked in setup.brief.entities:
        if asked.category != category:
            continue
        there = sum(o.intent.request == asked.id for o in draft.objects.values())
        if there < (asked.count[1] if asked.count else 1):
            return asked.id
    return None


def _supports(draft: Draft, asset: Asset, item: Item | None, on: Sequence[str]) -> list[str]:
    """What may carry an asset: what was asked for, else what its item or its category usually stands on, else any."""

    def able(ids: Sequence[str]) -> list[str]:
        found = [i for i in dict.fromkeys(ids) if any(fits_on(s, asset.size) for s in draft.objects[i].surfaces)]
        return sorted(found, key=lambda i: _laden(draft, i, asset.category))

    if on:
        return able([id for word in on for id in draft.named(word)])
    usual = [id for name in (item.on if item is not None else ()) for id in draft.named(name)]
    ranks = {o.id: likeliness(asset.category, o.category) for o in draft.objects.values()}
    likely = [
        able([id for id, found in ranks.items() if found == rank])
        for rank in sorted({rank for rank in ranks.values() if rank is not None})
    ]
    rest = [o.id for o in draft.objects.values() if not has_role(o.category, "soft_top")]
    return [*dict.fromkeys([*able(usual), *(id for ids in likely for id in ids), *able(rest)])]


def _laden(draft: Draft, id: str, category: str) -> tuple[int, int]:
    """How much of the same kind, and of any, an object carries already."""
    on = [o for o in draft.objects.values() if o.support is not None and o.support.object == id]
    return sum(o.category == category for o in on), len(on)
