"""The inputs of a tool by a model: from its card, the scene and an instruction; tried out before anyone relies on them.

A model names objects, relations and groups, never a place or an angle. What it says is checked by the card, by rules
(`input_rules`), by a trial of the tool and by applying its edits; what is wrong is told to it, a few times.
"""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Annotated, Any

from pydantic import Field, WithJsonSchema, create_model

from sceneweaver.agent.memory import Call
from sceneweaver.io.messages import shorten
from sceneweaver.llm import ModelClient, ModelError, Reply
from sceneweaver.scene import InputError, SceneWeaverError
from sceneweaver.scene.edits import apply_all
from sceneweaver.tools.base import Context, Proposal, Tool
from sceneweaver.tools.card import ToolCard
from sceneweaver.tools.registry import Registered

from .catalogue_text import catalogue_data
from .input_rules import check_extent, wrong_changes, wrong_inputs
from .scene_text import compact, prompt, scene_text

RETRIES = 3
"""Times that a model is told what is wrong with inputs."""

AGAIN = "The tool can do these inputs in part only. Give inputs that it can do, or the same again to do that part."
"""What a model is told, once, of inputs of which something stays undone."""

LONGEST_REQUEST, SENTENCE = 4000, 400
"""Characters of a request and of a sentence that are told."""

PROBLEMS = 6
"""Problems that are told at once."""


def filled(client: ModelClient, registered: Registered, context: Context, call: Call) -> Call:
    """A call with inputs by a model; what the call has already is a suggestion to it.

    A tool that asks a model by itself (``card.needs``) is left as it is.

    Args:
        client: whom to ask.
        registered: the tool, ours or another's.
        context: what the tool may look at; its instruction and inputs are those of the call.
        call: what is to be done.

    Raises:
        ModelError: when the model gives no inputs that can be used; the call as it was is as good as before.
        InputError: when the tool does not load.
    """
    card = registered.card
    if card.needs == "model":
        return call
    trial = _Trial(card, registered.load(), context, call)
    asked = question(card, context, call)

    def answer(*more: str) -> dict[str, Any]:
        reply = client.ask(
            "inputs", answer_for(card), instructions(), [asked, *more], check=trial.check, retries=RETRIES
        )
        return dict(reply.inputs)  # pyright: ignore[reportAttributeAccessIssue]

    inputs = answer()
    open_ = trial.unmet(inputs)
    if open_:
        told = {"your_inputs": inputs, "what_cannot_be_done": open_}
        with suppress(ModelError):  # then the rest of it is done
            again = answer(f"{AGAIN}\n{compact(told)}")
            inputs = again if len(trial.unmet(again)) <= len(open_) else inputs
    return call.model_copy(update={"inputs": inputs})


def try_out(registered: Registered, context: Context, call: Call) -> Call:
    """A call whose inputs a model gave without being asked for them, without what says nothing in them.

    Raises:
        InputError: when they are refused, with what is wrong, or when the tool does not load.
    """
    if registered.card.needs == "model":
        return call
    trial = _Trial(registered.card, registered.load(), context, call)
    return call.model_copy(update={"inputs": trial.sound(call.inputs)})


def instructions() -> str:
    """What a model is told of its part, whatever the tool."""
    return f"{prompt('inputs')}\n\n{prompt('scene')}"


def answer_for(card: ToolCard) -> type[Reply]:
    """The type of an answer: inputs as a card has them, without those that are withheld from models."""
    schema = plain_schema(card.inputs)
    schema["properties"] = _given(card, schema)
    kind = Annotated[dict[str, Any], WithJsonSchema({**schema, "type": "object"})]
    return create_model("Inputs", __base__=Reply, inputs=(kind, Field(description=f"Inputs of {card.name}")))


_OF_TYPE = {"object": ("properties", "required", "additionalProperties"), "array": ("items", "minItems", "maxItems")}
"""Keys of a schema that say something of one type alone."""


def plain_schema(schema: Mapping[str, Any]) -> dict[str, Any]:
    """A schema whose lists of types are alternatives: some endpoints know no other way to say so."""
    made = {key: plain_schema(value) if isinstance(value, Mapping) else value for key, value in schema.items()}
    if "properties" in schema:
        made["properties"] = {name: plain_schema(inner) for name, inner in schema["properties"].items()}
    if not isinstance(made.get("type"), list):
        return made
    types, kept = made.pop("type"), {key: made.pop(key) for key in ("description", "default") if key in made}
    own = {key: made.pop(key) for keys in _OF_TYPE.values() for key in keys if key in made}
    alternatives = []
    for name in types:
        said_of_it = {key: own[key] for key in _OF_TYPE.get(name, ()) if key in own}
        alternatives.append({"type": name} | said_of_it | ({} if name in _OF_TYPE or name == "null" else made))
    return kept | {"anyOf": alternatives}


def said(schema: Mapping[str, Any], data: Any) -> Any:
    """Data without the nulls that small models write for what they leave out, where a schema knows no null."""
    if isinstance(data, Mapping):
        inner, extra = schema.get("properties", {}), schema.get("additionalProperties")
        of = {name: inner.get(name, extra if isinstance(extra, Mapping) else {}) for name in data}
        return {name: said(of[name], value) for name, value in data.items() if value is not None or _nullable(of[name])}
    if isinstance(data, list):
        return [said(schema.get("items", {}), value) for value in data]
    return data


def _nullable(schema: Mapping[str, Any]) -> bool:
    types = schema.get("type")
    return types is None or "null" in ([types] if isinstance(types, str) else types)


def question(card: ToolCard, context: Context, call: Call) -> str:
    """What a model is told: card, instruction, request, scene and catalogue, as JSON."""
    brief, scene = context.brief, context.scene
    told = card.model_dump(include={"name", "description", "when", "when_not", "strengths", "weaknesses", "example"})
    told["inputs"] = {**card.inputs, "properties": _given(card, card.inputs)}
    request: dict[str, Any] = {
        "text": shorten(brief.text, LONGEST_REQUEST),
        "asks_for": [
            {"id": e.id, "noun": shorten(e.noun), "category": e.category, "count": list(e.count or (1, 1))}
            for e in brief.entities
        ],
        "does_not_want": [shorten(e.words) for e in brief.exclusions],
    }
    if brief.only:
        request["only_what_it_names"] = True
    rows = {
        "card": compact(told),
        "instruction": compact(shorten(call.instruction or brief.text, LONGEST_REQUEST)),
        "why": compact(shorten(call.reason, SENTENCE)),
        "suggestion": compact({k: v for k, v in call.inputs.items() if k not in card.withheld}),
        "request": compact(request),
        "catalogue": compact(catalogue_data(card, context, call)),
        "scene": scene_text(scene),
    }
    return "{" + ",\n".join(f'"{key}":{text}' for key, text in rows.items()) + "}"


def _given(card: ToolCard, schema: Mapping[str, Any]) -> dict[str, Any]:
    """The inputs in a schema that a model may give."""
    return {k: v for k, v in schema.get("properties", {}).items() if k not in card.withheld}


@dataclass(frozen=True)
class _Trial:
    """Tries inputs out on a scene; equal inputs come to the same."""

    card: ToolCard
    tool: Tool
    context: Context
    call: Call

    def check(self, answer: Reply) -> Reply:
        """The answer without what says nothing; an InputError that says what is wrong refuses it."""
        inputs = self.sound(answer.inputs)  # pyright: ignore[reportAttributeAccessIssue]
        return answer.model_copy(update={"inputs": inputs})

    def sound(self, given: Mapping[str, Any]) -> dict[str, Any]:
        """The same for inputs."""
        check_extent(given)
        inputs = said(self.card.inputs, given)
        self._check(inputs)
        return inputs

    def _check(self, inputs: Mapping[str, Any]) -> None:
        for name in self.card.withheld:
            if name in inputs:
                raise InputError(f"inputs.{name} is not for you to give; leave it out")
        self.card.check(inputs)
        scene, brief = self.context.scene, self.context.brief
        _refuse(wrong_inputs(inputs, scene, brief))
        proposal = self._proposed(inputs)
        after, _ = apply_all(proposal.scene or scene, proposal.edits)
        if proposal.scene is not None:
            return
        _refuse(wrong_changes(scene, after, brief))
        if not proposal.edits and not proposal.fresh:
            why = [shorten(text, SENTENCE) for text in (*proposal.unmet, *proposal.notes)][:PROBLEMS]
            raise InputError("with these inputs nothing changes" + (f": {'; '.join(why)}" if why else ""))

    def unmet(self, inputs: Mapping[str, Any]) -> list[str]:
        """What the tool cannot do of inputs that pass."""
        return [shorten(text, SENTENCE) for text in self._proposed(inputs).unmet[:PROBLEMS]]

    def _proposed(self, inputs: Mapping[str, Any]) -> Proposal:
        """What the tool makes of inputs; whatever goes wrong in it is a reason for others."""
        context = replace(
            self.context, instruction=self.call.instruction, inputs=inputs, seed=self.call.seed, client=None
        )
        try:
            return self.tool.propose(context)
        except SceneWeaverError:
            raise
        except Exception as error:  # a foreign tool may do anything
            kind = type(error).__name__
            raise InputError(f"tool {self.card.name} cannot use these inputs ({kind}); give others") from error


def _refuse(problems: list[str]) -> None:
    if problems:
        raise InputError("; ".join(problems[:PROBLEMS]))
