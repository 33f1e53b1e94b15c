"""Requests for whole homes: what is read of them, what stays a request for one room, what their plans meet."""

from __future__ import annotations

import importlib
import importlib.util
import time
from collections import defaultdict
from collections.abc import Iterator
from typing import Any

from benchmarks.families.requests import requests
from benchmarks.home_requests import SETS, Asked, home_requests, verdicts
from benchmarks.judging import Judge
from benchmarks.results import Column, Result
from benchmarks.settings import Settings
from sceneweaver.language.homes import demands, is_home, read_home

CANDIDATES, TRIES, LIMIT = 256, 3, 60.0
"""Plans that are searched for at once, envelopes that are tried, and seconds for each of them."""

READ = (
    Column("set", "set"),
    Column("kind", "kind"),
    Column("requests", "requests", "count"),
    Column("home", "taken for homes", "count"),
    Column("asked", "to read", "count"),
    Column("met", "read", "count"),
    Column("share", "share", "share"),
    Column("whole", "all read", "count"),
    Column("ms", "ms a request", "number"),
)
MISSED = (Column("id", "id"), Column("missed", "not read as meant"), Column("unread", "said not to be understood"))
PLANNED = (
    Column("id", "id"),
    Column("rooms", "rooms", "count"),
    Column("valid", "valid plans", "count"),
    Column("asked", "demands", "count"),
    Column("met", "met", "count"),
    Column("partly", "partly", "count"),
    Column("not_met", "not met"),
)


def run(settings: Settings, judge: Judge) -> Result:
    """Read all requests, look that requests for one room stay such, and plan those of people."""
    del judge
    result = Result(
        "home_requests",
        "Requests for whole homes",
        "What a careful reader takes from a request for a home, practice, office or school, and how much of it the "
        "reader has: numbers and areas of rooms, storeys, what lies next to what, envelope, words for single rooms. It "
        "was tuned on one set; held_out was put away before the reader was begun. Then plans of the twelve requests of "
        "people, with their demands as measured in the plan.",
    )
    table = result.add("read", "What is read of requests", READ, keys=2)
    missed = result.add("missed", "What is not read as meant", MISSED)
    for name in SETS:
        asked = home_requests(name)[:2] if settings.quick else home_requests(name)
        table.rows += _rows(name, asked)
        missed.rows += _missed(asked)
    rooms = requests()
    taken = [text for text in rooms if is_home(text)]
    result.failures += [f"taken for a home: {text}" for text in taken]
    result.notes.append(f"Of {len(rooms)} requests for one room {len(taken)} are taken for homes.")
    if settings.quick or importlib.util.find_spec("sceneweaver.plans.solve") is None:
        return result
    planned = result.add("planned", "Plans of requests of people", PLANNED)
    planned.rows += [_planned(asked, settings) for asked in home_requests("people")]
    all_, met = (sum(row[key] for row in planned.rows) for key in ("asked", "met"))
    result.notes.append(f"{met} of {all_} demands are met by the plans.")
    return result


def _rows(name: str, asked: list[Asked]) -> Iterator[dict[str, Any]]:
    """A row for each kind of requests of a set, and one for all."""
    found: dict[str, list[tuple[int, int, bool, float]]] = defaultdict(list)
    for one in asked:
        read_home(one.text)  # words are loaded once
        began = time.process_time()
        read = read_home(one.text)
        taken = 1000 * (time.process_time() - began)
        held = [met for _, met in verdicts(one, read)]
        for kind in (one.kind, "all"):
            found[kind].append((len(held), sum(held), is_home(one.text), taken))
    for kind, rows in found.items():
        to_read, met = sum(row[0] for row in rows), sum(row[1] for row in rows)
        yield {
            "set": name,
            "kind": kind,
            "requests": len(rows),
            "home": sum(row[2] for row in rows),
            "asked": to_read,
            "met": met,
            "share": met / to_read,
            "whole": sum(row[0] == row[1] for row in rows),
            "ms": sum(row[3] for row in rows) / len(rows),
        }


def _missed(asked: list[Asked]) -> Iterator[dict[str, Any]]:
    for one in asked:
        read = read_home(one.text)
        wrong = [words for words, met in verdicts(one, read) if not met]
        if wrong:
            yield {"id": one.id, "missed": "; ".join(wrong), "unread": "; ".join(u.words for u in read.unread)}


def _planned(asked: Asked, settings: Settings) -> dict[str, Any]:
    """The best plan of a request, in the first of a few envelopes that has any."""
    solve_plans = importlib.import_module("sceneweaver.plans.solve").solve_plans

    read = read_home(asked.text)
    row: dict[str, Any] = {"id": asked.id, "rooms": len(read.programme.rooms), "asked": 0, "met": 0, "partly": 0}
    for seed in range(settings.seed, settings.seed + TRIES):
        solved = solve_plans(
            read.programme,
            read.envelope(seed),
            candidates=settings.most or CANDIDATES,
            seed=seed,
            profile=read.profile,
            device=settings.device,
            time_limit=LIMIT,
        )
        row |= {"valid": len(solved.valid), "not_met": "no valid plan"}
        if len(solved.valid):
            held = demands(read, solved.best)
            unmet = [f"{demand.words} ({demand.detail})" for demand in held if demand.status == "not met"]
            row |= {"asked": len(held), "not_met": "; ".join(unmet)}
            row |= {key: sum(d.status == key for d in held) for key in ("met", "partly")}
            break
    return row
