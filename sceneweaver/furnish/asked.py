"""What is asked for of a home, in words or as a programme, read once for all that is done with it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TypeVar

from sceneweaver.home import Home
from sceneweaver.language.homes import HomeRequest, demands, read_home
from sceneweaver.language.homes import room_requests as told_requests
from sceneweaver.plans import Envelope, Profile, Programme, envelope_for, feasible, totalled
from sceneweaver.scene import InputError

from .demands import furnishable
from .giving_way import areas_asked

ENVELOPES = 3
"""Envelopes that are tried where the first one that was chosen takes no valid plan."""

Plans = TypeVar("Plans")


@dataclass(frozen=True)
class Asked:
    """What is asked for: a programme with what its rooms are to hold, and what the plan fits into.

    Attributes:
        prompt: the request in words; may be empty.
        programme: the rooms.
        profile: rules that the plan keeps.
        envelope: what it fits into; None: as the request says, or chosen.
        request: the request as it is read; None where the programme is given.
    """

    prompt: str
    programme: Programme
    profile: Profile
    envelope: Envelope | None
    request: HomeRequest | None

    @classmethod
    def of(cls, prompt: str, programme: Programme | None, envelope: Envelope | None, profile: str | None) -> Asked:
        """What a request in words, or a programme, asks for; what else is given goes before what the words say.

        Raises:
            InputError: for words that say nothing, and a profile that is not known.
        """
        request = read_home(prompt) if prompt.strip() and programme is None else None
        made = programme or (request.programme if request is not None else None)
        assert made is not None
        rules = Profile.of(profile or "base") if profile or request is None else request.rules
        return cls(prompt, made, rules, envelope, request)

    @property
    def areas(self) -> frozenset[str]:
        """Ids of the rooms whose area was asked for."""
        return areas_asked(self.request, self.programme)

    @property
    def outside(self) -> tuple[str, ...]:
        """Ids of the rooms that are to have a door outside."""
        return tuple(room.id for room in self.request.rooms if room.outside) if self.request is not None else ()

    def possible(self) -> tuple[Programme, tuple[str, ...]]:
        """The programme as rules and furniture allow it, and what gave way."""
        programme, raises = feasible(self.programme, self.profile, self.areas)
        programme, more = furnishable(programme, self.texts, self.areas)
        if self.request is not None and self.request.area is not None:
            programme = totalled(programme, self.request.area, self.areas, self.profile)
        return programme, (*raises, *more)

    def envelope_of(self, programme: Programme, seed: int, own: bool = False) -> Envelope:
        """What a plan of the programme has to fit into; ``own``: whatever sides were asked for."""
        if self.envelope is not None:
            return self.envelope
        if self.request is not None and not own:
            return replace(self.request, programme=programme).envelope(seed)
        return envelope_for(programme, seed)

    def fitted(self, programme: Programme, seed: int, solve: Callable[[Envelope], Plans]) -> Plans:
        """What ``solve`` finds for a programme; of several envelopes that are ours to choose, in the first that takes
        a valid plan.

        Raises:
            InputError: none takes one; it says why the first did not.
        """
        wrong: InputError | None = None
        for k in range(1 if self.envelope is not None else ENVELOPES):
            try:
                return solve(self.envelope_of(programme, seed + k))
            except InputError as error:
                wrong = wrong or error
        assert wrong is not None
        raise wrong

    @property
    def texts(self) -> dict[str, str]:
        """By room of the programme, what the request says of it."""
        return told_requests(self.request, told_only=True) if self.request is not None else {}

    def told(self, home: Home) -> dict[str, str]:
        """By room of a home, what the request says of it."""
        return told_requests(self.request, home, told_only=True) if self.request is not None else {}

    def unmet(self, home: Home) -> list[str]:
        """What the request asks for and the finished home, measured anew, does not have."""
        found = demands(self.request, home) if self.request is not None else ()
        return [f"{one.words}: {one.status}, {one.detail}" for one in found if one.status != "met"]

    @property
    def style(self) -> str:
        """The words for the look of all rooms, as a request."""
        styles = " ".join(self.request.styles) if self.request is not None else ""
        return f"a {styles} home" if styles else "a home"

    @property
    def notes(self) -> tuple[str, ...]:
        """What was assumed of the request."""
        if self.request is None:
            return ()
        unread = [f"not understood: {word.words}" for word in self.request.unread]
        return (*self.request.assumed, *self.request.notes, *unread)
