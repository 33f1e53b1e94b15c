"""Keys are taken out of whatever is kept or said, however they are written."""

import base64
import html
import json
import logging
import time
from urllib.parse import quote

import pytest

from sceneweaver.llm import Endpoint, ModelError, Reply, open_client, redact
from sceneweaver.llm.secrets import HIDDEN, guard_logs, line
from sceneweaver.runtime.deadline import Deadline, TimeUp
from tests.llm.misbehaviour import always, catalogue, misbehaving
from tests.llm.model_server import ModelServer, Said, answering
from tests.llm.planted_key import planted

KEY = 'sk-Ab/9+"x<y>0123456789_-zZ=='


class Plan(Reply):
    """What to do."""

    name: str


@pytest.fixture
def key(monkeypatch):
    monkeypatch.setenv("SCENEWEAVER_API_KEY", KEY)
    return KEY


FORMS = {
    "as it stands": lambda key: key,
    "spaced": " ".join,
    "on lines": "\n".join,
    "escaped lines": "\\n".join,
    "invisible characters": "\u200b".join,
    "nulls": "\0".join,
    "backwards": lambda key: key[::-1],
    "URL": lambda key: quote(key, safe=""),
    "JSON": json.dumps,
    "JSON in JSON": lambda key: json.dumps(json.dumps(key)),
    "JSON with slashes": lambda key: json.dumps(key).replace("/", "\\/"),
    "HTML": html.escape,
    "hexadecimal": lambda key: key.encode().hex(),
    "first half": lambda key: key[: len(key) // 2],
    "last half": lambda key: key[len(key) // 2 :],
    **{
        f"base64 after {n}": lambda key, n=n: base64.b64encode(b"x" * n + key.encode() + b"yy").decode()
        for n in range(4)
    },
    "base64 for URLs": lambda key: base64.urlsafe_b64encode(b"Bearer " + key.encode()).decode(),
}


@pytest.mark.parametrize("form", FORMS.values(), ids=FORMS)
def test_forms(key, form):
    written = form(key)
    clean = redact(f"so: {written} and on")
    assert HIDDEN in clean and clean.startswith("so: ") and clean.endswith(" and on")
    rest = clean.replace(HIDDEN, "")
    assert not any(written[at : at + 12] in rest for at in range(len(written) - 11))


def test_data(key):
    assert redact({key: [1, (key,), None]}) == {HIDDEN: [1, (HIDDEN,), None]}


def test_other_secrets(monkeypatch):
    monkeypatch.setenv("SOME_HUB_TOKEN", "hub-0123456789")
    monkeypatch.setenv("HTTPS_PROXY", "http://me:pass%20word0@proxy:3128")
    monkeypatch.setenv("OPENAI_API_KEY", "EMPTY")
    assert redact("hub-0123456789, pass word0, pass%20word0") == f"{HIDDEN}, {HIDDEN}, {HIDDEN}"
    assert redact("EMPTY rooms, me and proxy") == "EMPTY rooms, me and proxy"


def test_nothing_to_hide_changes_nothing(key):
    text = "a sofa, a lamp; 12.5 m2 über 3 Räume\n\t{}"
    assert redact(text) == text


def test_line(key):
    assert line(f"one\n two {key} three" + " x" * 400) == line(f"one two {HIDDEN} three" + " x" * 400)
    assert len(line("x" * 1000)) == 300


def test_long_texts_take_no_time(key):
    text = "s" + " " * 300_000 + "sk-Ab " * 30_000
    began = time.monotonic()
    redact(text)
    assert time.monotonic() - began < 20  # seconds; the square of the length would take hours


def test_logs(key, caplog):
    guard_logs()
    logger = logging.getLogger("httpcore2.http11")
    with caplog.at_level(logging.DEBUG, "httpcore2"):
        logger.debug("receive_response_headers.complete %r", [(b"X-Echo", key.encode())])
        try:
            raise ValueError(key)
        except ValueError:
            logger.debug("failed", exc_info=True)
    assert caplog.records and "ValueError" in caplog.text
    assert "0123456789" not in caplog.text


ECHOES = [one.name for one in catalogue("echoes")]


@pytest.mark.parametrize("name", ECHOES)
@pytest.mark.parametrize("kind", ["openai", "anthropic"])
def test_a_server_that_shows_the_key(name, kind, tmp_path, capfd):
    script = misbehaving(answering({Plan: {"name": "bed"}}), always(name))
    with planted() as key, ModelServer(script) as server:
        endpoint = Endpoint.of(f"{kind}:m", server.url if kind == "openai" else server.root, tries=1)
        client = open_client(endpoint, records=tmp_path / "llm")
        try:
            key.said.append(repr(client.ask("plan", Plan, "Plan.", ["a room"], retries=1)))
        except ModelError as error:
            key.raised(error)
        key.said += [repr(client), repr(vars(client)), repr(endpoint), client.lost, str(client.usage.to_dict())]
        assert key.key in server.keys_seen
    key.assert_nowhere(tmp_path, capfd.readouterr())


def test_no_key_in_the_frames_of_an_interrupted_wait(tmp_path):
    with planted() as key, ModelServer(lambda asked: Said(raw=lambda wire: wire.wait(5.0))) as server:
        client = open_client(Endpoint.of("m", server.url), records=tmp_path / "llm")
        end = time.monotonic() + 0.4
        with pytest.raises(TimeUp) as caught, Deadline(end).enforced():
            client.ask("plan", Plan, "Plan.", ["a room"])
        key.raised(caught.value)
    key.assert_nowhere(tmp_path)
    assert "interrupted" in (tmp_path / "llm" / "0001-plan.json").read_text()
