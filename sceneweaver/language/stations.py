"""Places that are no things: "three stations, each with a chair, a mirror and a lamp".

What each of them has is there so many times, and stands together: near the first of it that stands on the floor. The
places themselves are no bodies.
"""

from __future__ import annotations

from .chunks import NounPhrase
from .distribution import is_each
from .parsed import Left, Mention, Parsed, Said
from .state import State
from .things import match_of, singular
from .vocabulary import words


def names_stations(state: State, phrase: NounPhrase) -> bool:
    """Whether a phrase counts places of each of which the request tells what is there."""
    if phrase.determiner or phrase.count is None or phrase.count[0] < 2 or phrase.count[0] != phrase.count[1]:
        return False
    if phrase.of is not None or not {*singular(phrase.text).split()[-1:]} & {*words("nouns")["places"]}:
        return False
    if match_of(singular(phrase.text)).how != "generic":
        return False  # a styling station is a thing
    return any(chunk.kind == "noun" and is_each(chunk.value) for chunk in state.chunks[state.at : state.at + 12])


def new_stations(state: State, phrase: NounPhrase) -> Mention:
    """So many places, of which nothing is made."""
    group = Mention(phrase.text, "chair", phrase.count, plural=True, span=state.span_of(phrase))
    state.out.stations.append(group)
    return group


def station_group(state: State) -> Mention | None:
    """The places that were counted last, or those of the people that the request speaks of."""
    if state.out.stations:
        return state.out.stations[-1]
    people = next((c.people for c in reversed(state.out.capacities) if c.people > 1 and not c.each), state.out.people)
    if people is None or people < 2:
        return None
    group = Mention("place", "chair", (people, people), plural=True)
    state.out.stations.append(group)
    return group


def settle_stations(parsed: Parsed) -> None:
    """What each place has stands together, at the first of it that stands on the floor."""
    for group in parsed.stations:
        own = [m for m in parsed.mentions if m.per is group]
        floor = [m for m in own if m.mount == "floor" and not m.is_small] or own
        if not floor:
            if group.span is not None:
                parsed.unread.append(Left(group.noun, span=group.span))
            continue
        if group.span is not None:
            parsed.referred.append(group.span)
        first, tied = floor[0], {m for said in parsed.said for m in said.subjects if said.targets != (group,)}
        parsed.said = [said for said in parsed.said if group not in (*said.targets, *said.subjects)]
        for mention in own:
            mention.per = first if mention is not first else None
            if mention is not first and mention not in tied:
                words_ = f"{group.noun} with {mention.noun}"
                parsed.said.append(
                    Said("near", [mention], (first,), words_, each=True, implied=True, span=mention.span)
                )


__all__ = ["names_stations", "new_stations", "settle_stations", "station_group"]
