"""Keys are taken out of whatever is kept or said, however they are written."""

import base64
import codecs
import gzip
import html
import json
import logging
import random
import time
import tracemalloc
import zlib
from urllib.parse import quote

import pytest

from sceneweaver.llm import Endpoint, ModelError, Reply, open_client, redact
from sceneweaver.llm.secrets import HIDDEN, guard_logs, line
from sceneweaver.runtime.deadline import Deadline, TimeUp
from tests.llm.bad_echoes import key_of
from tests.llm.bad_statuses import status
from tests.llm.hiding_places import blobs
from tests.llm.misbehaviour import always, catalogue, misbehaving
from tests.llm.model_server import ModelServer, answering
from tests.llm.planted_key import KEY as PLANTED
from tests.llm.planted_key import planted
from tests.llm.said import Asked, Said
from tests.sizes import often

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
    "dots": ".".join,
    "pieces of 3": lambda key: "-".join(key[at : at + 3] for at in range(0, len(key), 3)),
    "all in percent": lambda key: "".join(f"%{ord(letter):02X}" for letter in key),
    "percent of percent": lambda key: quote(quote(key, safe=""), safe=""),
    "some in percent": lambda key: "".join(
        f"%{ord(letter):02x}" if at % 3 == 0 else letter for at, letter in enumerate(key)
    ),
    "upper case": str.upper,
    "swapped case": str.swapcase,
    "wide letters": lambda key: "".join(chr(ord(letter) + 0xFEE0) for letter in key),
    "base16": lambda key: base64.b16encode(key.encode()).decode(),
    **{f"base32 after {n}": lambda key, n=n: base64.b32encode(b"x" * n + key.encode()).decode() for n in range(5)},
    "base32 in small letters, dotted": lambda key: ".".join(base64.b32encode(key.encode()).decode().lower()),
    "base85": lambda key: base64.b85encode(key.encode()).decode(),
    "ascii85 of a header": lambda key: base64.a85encode(b"Bearer " + key.encode()).decode(),
    "base64 backwards": lambda key: base64.b64encode(key.encode()).decode()[::-1],
    "base64 of backwards": lambda key: base64.b64encode(key[::-1].encode()).decode(),
    "rot13": lambda key: codecs.encode(key, "rot13"),
    "rot13, large, dotted": lambda key: ".".join(codecs.encode(key, "rot13").upper()),
    "rot47": lambda key: "".join(chr(33 + (ord(letter) + 14) % 94) for letter in key),
    "ordinals": lambda key: ", ".join(str(ord(letter)) for letter in key),
    "ordinals in hexadecimal": lambda key: " ".join(f"0x{ord(letter):x}" for letter in key),
    "ordinals in octal": lambda key: "".join(f"\\{ord(letter):03o}" for letter in key),
    "ordinals in binary": lambda key: " ".join(f"{ord(letter):08b}" for letter in key),
    "gzip": lambda key: base64.b64encode(gzip.compress(key.encode())).decode(),
    "gzip for URLs": lambda key: base64.urlsafe_b64encode(gzip.compress(b"Bearer " + key.encode())).decode(),
    "gzip on lines": lambda key: base64.encodebytes(gzip.compress(f"{'x' * 99}{key}".encode())).decode(),
    "gzip in JSON": lambda key: json.dumps(base64.encodebytes(gzip.compress(key.encode())).decode()),
    "gzip without its end": lambda key: base64.b64encode(gzip.compress(key.encode())[:-8]).decode(),
    "gzip of gzip": lambda key: base64.b64encode(gzip.compress(base64.b64encode(gzip.compress(key.encode())))).decode(),
    "gzip of base64": lambda key: base64.b64encode(gzip.compress(base64.b64encode(key.encode()))).decode(),
    "gzip after other letters": lambda key: f"data{base64.b64encode(gzip.compress(key.encode())).decode()}",
    "zlib": lambda key: base64.b64encode(zlib.compress(key.encode())).decode(),
    "zlib, not compressed": lambda key: base64.b64encode(zlib.compress(key.encode(), 0)).decode(),
    "deflate": lambda key: base64.b64encode(zlib.compress(key.encode(), wbits=-15)).decode(),
    "deflate of a small window": lambda key: base64.b64encode(zlib.compress(key.encode(), wbits=-9)).decode(),
    "HTML numbers": lambda key: "".join(f"&#{ord(letter)};" for letter in key),
}


@pytest.mark.parametrize("form", FORMS.values(), ids=FORMS)
def test_forms(key, form):
    written = form(key)
    clean = redact(f"so: {written} and on")
    assert HIDDEN in clean and clean.startswith("so: ") and clean.endswith(" and on")
    rest = clean.replace(HIDDEN, "")
    assert not any(written[at : at + 12] in rest for at in range(len(written) - 11))
    assert redact(f"so: {form('a lamp by the bed, 2.5 m')} and on").count(HIDDEN) == 0


@pytest.mark.parametrize("size", [1, 2, 5, 8])
def test_from_field_to_field(key, size):
    parts = [key[at : at + size] for at in range(0, len(key), size)]
    fields = [
        {"name": part, "why": {"of": "".join(rest)}}
        for part, *rest in (parts[at : at + 2] for at in range(0, len(parts), 2))
    ]
    for said in (parts, fields, json.dumps(parts), json.dumps(fields)):
        clean = str(redact(said))
        assert HIDDEN in clean and not [part for part in parts if sum(map(str.isalnum, part)) > 1 and part in clean]


def test_numbers(key):
    assert redact([ord(letter) for letter in key]) == [HIDDEN] * len(key)
    assert redact({"poses": [1, 2, 3.5, True, 40]}) == {"poses": [1, 2, 3.5, True, 40]}


@pytest.mark.parametrize("change", [str, str.upper, str.swapcase])
def test_pieces_with_words_between(monkeypatch, change):
    monkeypatch.setenv("SCENEWEAVER_API_KEY", PLANTED)
    pieces = [PLANTED[at : at + 8] for at in range(0, len(PLANTED) - 8, 8)]
    clean = redact(" then ".join(change(piece) for piece in pieces))
    assert [part.strip("/+-_=") for part in clean.split(" then ")] == [HIDDEN] * len(pieces)


@pytest.mark.parametrize("secret", ["living-room-lamp", "a key of words", "/srv/my rooms", "12345678", "changeme"])
def test_what_looks_like_words_is_hidden_whole_only(monkeypatch, secret):
    monkeypatch.setenv("SCENEWEAVER_API_KEY", secret)
    assert redact(f"so: {secret}!") == f"so: {HIDDEN}!"
    text = "a living room, a key of room 1, 234567, /srv/rooms"
    assert redact(text) == text


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


def packed(data):
    return base64.b64encode(gzip.compress(data)).decode()


def test_packed_texts_are_unpacked_no_further_than_is_allowed(key, monkeypatch):
    """What is larger than is looked at is taken for a secret; little memory is used for it."""
    bomb, plain = packed(b"a lamp " * 2**23), packed(b"a lamp " * 2**10)
    tracemalloc.start()
    try:
        assert redact(f"so: {bomb}") == f"so: {HIDDEN}" and redact(f"so: {plain}") == f"so: {plain}"
        assert tracemalloc.get_traced_memory()[1] < 2**25
    finally:
        tracemalloc.stop()
    assert redact(f"so: {packed(b'a lamp ' * 2**16 + key.encode())}") == f"so: {HIDDEN}"
    monkeypatch.setattr("sceneweaver.llm.packed.MOST_IN_ALL", 2**14)
    clean = redact(" and ".join([plain] * 5))
    assert clean.startswith(plain) and clean.endswith(HIDDEN)


def test_what_was_packed_without_a_secret_stays(key):
    text = " ".join(base64.b64encode(zlib.compress(b"a lamp and %d chairs" % k)).decode() for k in range(40))
    picture = base64.b64encode(b"\x89PNG\r\n\x1a\n" + random.Random(0).randbytes(2**16)).decode()
    assert redact(text) == text and redact(picture) == picture


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


@pytest.mark.parametrize("form", often(FORMS.values(), list(FORMS.values())[::5]), ids=FORMS)
def test_a_server_that_shows_the_key_in_another_form(form, tmp_path):
    """As an answer that is taken, and in the words of an error: neither is kept on disk, given or said."""

    def answer(asked: Asked) -> Said:
        shown = form(key_of(asked))
        if len(server.requests) > 1:
            return status(400, f"no such key: {shown}")
        return Said(calls=((next(iter(asked.tools)), {"name": f"bed {shown}"}),))

    said: list[str] = []
    with planted() as key, ModelServer(lambda asked: answer(asked)) as server:
        client = open_client(Endpoint.of("openai:m", server.url, tries=1), records=tmp_path / "llm")
        for _ in range(2):
            try:
                said.append(repr(client.ask("plan", Plan, "Plan.", ["a room"], retries=0)))
            except ModelError as error:
                said.append(str(error))
    written = ["".join(json.dumps(text)[1:-1].split()) for text in (form(key.key), form(key.key[::-1]))]
    for text in (*said, *(data.decode(errors="replace") for _, data in blobs(tmp_path))):
        squeezed = "".join(text.split())
        assert not any(one[at : at + 16] in squeezed for one in written for at in range(len(one) - 15))
    assert len(server.requests) == 2 and HIDDEN in "".join(said)


def test_no_key_in_the_frames_of_an_interrupted_wait(tmp_path):
    with planted() as key, ModelServer(lambda asked: Said(raw=lambda wire: wire.wait(5.0))) as server:
        client = open_client(Endpoint.of("m", server.url), records=tmp_path / "llm")
        end = time.monotonic() + 0.4
        with pytest.raises(TimeUp) as caught, Deadline(end).enforced():
            client.ask("plan", Plan, "Plan.", ["a room"])
        key.raised(caught.value)
    key.assert_nowhere(tmp_path)
    assert "interrupted" in (tmp_path / "llm" / "0001-plan.json").read_text()
