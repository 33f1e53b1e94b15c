"""Partners of their own: of what each of several things has, none counts for two of them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from sceneweaver.language import StatedRelation

from .survey import Survey


def share_of(survey: Survey, said: StatedRelation) -> int:
    """How many subjects each target of a relation has for its own, at least, by the numbers that the request gives."""
    if said.count is not None:
        return max(1, said.count[0])
    subject = survey.brief.entity(said.subject)
    targets = [entity for name in said.targets if (entity := survey.brief.entity(name)) is not None]
    many = sum((entity.count or (1, 1))[0] for entity in targets)
    if subject is None or subject.count is None or not many or said.side is not None:
        return 1
    return max(1, subject.count[0] // many)


def own_partners(candidates: Mapping[str, Sequence[str]], share: int) -> dict[str, list[str]]:
    """By target up to ``share`` subjects of its own, so that as many targets as possible have all of theirs.

    Args:
        candidates: for each target the subjects that are where they should be to it.
        share: how many each needs.

    Returns:
        The subjects of each target; none stands under two.
    """
    owner: dict[str, str] = {}

    def take(target: str, tried: set[str]) -> bool:
        for subject in candidates[target]:
            if subject in tried:
                continue
            tried.add(subject)
            if subject not in owner or take(owner[subject], tried):
                owner[subject] = target
                return True
        return False

    for _ in range(share):
        for target in candidates:
            take(target, {subject for subject, of in owner.items() if of == target})
    found: dict[str, list[str]] = {target: [] for target in candidates}
    for subject, target in owner.items():
        found[target].append(subject)
    return found


__all__ = ["own_partners", "share_of"]
