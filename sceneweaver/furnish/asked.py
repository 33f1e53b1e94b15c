"""What is asked for of a home, in words or as a programme, read once for all that is done with it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TypeVar

from sceneweaver.home import Home
from sceneweaver.language.homes import HomeDemand, HomeRequest, demands, read_home
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
        return self.within(programme), (*raises, *more)

    def envelope_of(self, programme: Programme, seed: int, own: bool = False) -> Envelope:
        """What a plan of the programme has to fit into; ``own``: whatever sides were asked for."""
        if self.envelope is not None:
            return self.envelope
        if self.request is None:
            return envelope_for(programme, seed)
        free = {"width": None, "depth": None, "l_shape": False, "window_sides": None} if own else {}
        return replace(self.request, programme=programme, **free).envelope(seed)

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

    def demands(self, home: Home) -> tuple[HomeDemand, ...]:
        """What the request asks for, as the finished home, measured anew, has it; what was not understood as well."""
        return tuple(demands(self.request, home)) if self.request is not None else ()

    def within(self, programme: Programme) -> Programme:
        """The programme in which no room has more floor than the request allows it at most, nor all rooms together.

        Where rules or furniture need more of a room, it keeps that least.
        """
        if self.request is None:
            return programme
        caps = {room.id: room.most for room in self.request.rooms if room.most is not None}
        rooms = tuple(
            room.model_copy(update={"area": _capped(room.area, caps[room.id])}) if room.id in caps else room
            for room in programme.rooms
        )
        programme = programme.model_copy(update={"rooms": rooms})
        indoors = [room for room in rooms if not {"outdoor", "stairs"} & room.kind.roles]
        if self.request.most is not None and sum(room.area[1] for room in indoors) > (self.request.area or 0):
            programme = totalled(programme, self.request.area or self.request.most, self.areas, self.profile)
        return programme

    @property
    def style(self) -> str:
        """The words for the look of all rooms, as a request."""
        styles = " ".join(self.request.styles) if self.request is not None else ""
        return f"a {styles} home" if styles else "a home"

    @property
    def notes(self) -> tuple[str, ...]:
        """What was assumed of the request."""
        return (*self.request.assumed, *self.request.notes) if self.request is not None else ()

    @property
    def remarks(self) -> tuple[str, ...]:
        """What is said and is no demand."""
        return tuple(one.words for one in self.request.remarks) if self.request is not None else ()


def _capped(area: tuple[float, float, float], most: float) -> tuple[float, float, float]:
    least, target, high = area
    top = max(least, min(high, most))
    return least, min(max(target, least), top), top
