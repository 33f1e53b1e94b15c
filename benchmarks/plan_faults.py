"""What a strict architect objects to in a plan, counted: the rows of ``data/plan_faults.yaml`` as the exact checker has
them."""

from __future__ import annotations

from collections import Counter
from functools import cache
from pathlib import Path

from sceneweaver.home import Home
from sceneweaver.plans import Profile, Programme, check_plan

ROWS = Path(__file__).parent / "data" / "plan_faults.yaml"


@cache
def strict() -> Profile:
    """The rows, each a kind of fault."""
    return Profile.load(ROWS)


def plan_faults(home: Home, programme: Programme) -> Counter[str]:
    """Faults of a plan by kind; what the programme itself asks for is not judged here."""
    kinds = {row.id for row in strict().rows}
    report = check_plan(home, programme.with_storeys(), strict())
    return Counter(violation.rule for violation in report.violations if violation.rule in kinds)
