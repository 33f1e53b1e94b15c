"""What is asked, and where: from arguments and the environment, never with a key in it."""

import json
import subprocess
import sys

import pytest

from sceneweaver.llm import Endpoint, ModelUnreachable, Reply, open_client
from sceneweaver.scene import InputError, MissingDependencyError
from tests.llm.model_server import ModelServer, answering

KEY = "sk-test-0123456789abcdef"
LOCAL = "http://127.0.0.1:11434/v1"


class Plan(Reply):
    """What to do."""

    steps: int


@pytest.fixture(autouse=True)
def nothing_configured(monkeypatch):
    for name in ("MODEL", "BASE_URL", "API_KEY", "MODEL_TIMEOUT", "MODEL_STREAM"):
        monkeypatch.delenv(f"SCENEWEAVER_{name}", raising=False)
    for name in ("OPENAI_API_KEY", "ANTHROPIC_API_KEY", "OPENAI_BASE_URL", "ANTHROPIC_BASE_URL"):
        monkeypatch.delenv(name, raising=False)


def test_nothing_is_configured():
    with pytest.raises(MissingDependencyError, match="set SCENEWEAVER_MODEL") as error:
        Endpoint.of()
    assert error.value.exit_code == 4


@pytest.mark.parametrize(
    ("model", "name"), [("openai:gpt", "OPENAI_API_KEY"), ("anthropic:claude", "ANTHROPIC_API_KEY")]
)
def test_a_vendors_host_needs_a_key(model, name, monkeypatch):
    with pytest.raises(MissingDependencyError, match=f"set {name}"):
        Endpoint.of(model)
    monkeypatch.setenv(name, KEY)
    assert Endpoint.of(model).key_name == name
    monkeypatch.setenv("SCENEWEAVER_API_KEY", KEY)
    assert Endpoint.of(model).key_name == "SCENEWEAVER_API_KEY"


def test_a_vendors_key_goes_to_the_vendor_alone(monkeypatch):
    monkeypatch.setenv("OPENAI_API_KEY", KEY)
    with ModelServer(answering({Plan: {"steps": 1}})) as server:
        open_client(Endpoint.of("small", server.url)).ask("plan", Plan, "Plan.", ["a room"])
    assert server.keys_seen == set()


@pytest.mark.parametrize("kind", ["openai", "anthropic"])
def test_only_our_headers_go_out(kind, monkeypatch):
    monkeypatch.setenv("SCENEWEAVER_API_KEY", KEY)
    monkeypatch.setenv("OPENAI_ORG_ID", "org-of-the-user")
    monkeypatch.setenv("ANTHROPIC_AUTH_TOKEN", "another-token")
    monkeypatch.setenv("ANTHROPIC_CUSTOM_HEADERS", "X-Tell: all")
    with ModelServer(answering({Plan: {"steps": 1}})) as server:
        url = server.url if kind == "openai" else server.root
        open_client(Endpoint.of(f"{kind}:small", url)).ask("plan", Plan, "Plan.", ["a room"])
    assert server.keys_seen == {KEY}
    sent = set(server.requests[0].headers)
    assert not {"openai-organization", "x-tell"} & sent and not [name for name in sent if name.startswith("x-stain")]


def test_other_variables_redirect_nothing(monkeypatch):
    monkeypatch.setenv("OPENAI_BASE_URL", LOCAL)
    monkeypatch.setenv("OPENAI_API_KEY", KEY)
    assert Endpoint.of("openai:gpt").url == "https://api.openai.com/v1"


def test_environment(monkeypatch):
    for name, value in {
        "MODEL": "llama3.2:3b",
        "BASE_URL": LOCAL,
        "MODEL_TIMEOUT": "7.5",
        "MODEL_STREAM": "yes",
        "MODEL_ANSWERS": "prompted",
        "MODEL_PICTURES": "no",
        "MODEL_TEMPERATURE": "0",
        "MODEL_MAX_TOKENS": "900",
        "MODEL_PER_MINUTE": "30",
    }.items():
        monkeypatch.setenv(f"SCENEWEAVER_{name}", value)
    found = Endpoint.of()
    assert found == Endpoint("llama3.2:3b", LOCAL, 7.5, True, "prompted", False, 0.0, 900, 30.0)
    assert (found.kind, found.name, found.title) == ("openai", "llama3.2:3b", "openai:llama3.2:3b")
    assert Endpoint.of("other", timeout=3.0).timeout == 3.0


@pytest.mark.parametrize(
    ("fields", "says"),
    [
        ({"model": "gpt"}, "write openai:NAME"),
        ({"model": "openai:"}, "model: has no name"),
        ({"model": "a\nb", "base_url": LOCAL}, "model: is no name"),
        ({"base_url": "ftp://host/v1"}, "base_url: is no URL of a server"),
        ({"base_url": "localhost:8000"}, "base_url: is no URL of a server"),
        ({"base_url": "http://[::1/v1"}, "base_url: is no URL"),
        ({"base_url": "http://host:99999/v1"}, "base_url: is no URL"),
        ({"base_url": f"http://me:{KEY}@host/v1"}, "base_url: holds a user name or a password"),
        ({"base_url": f"http://host/v1?key={KEY}"}, "base_url: holds a query"),
        ({"base_url": f"http://host/{KEY}/v1"}, "base_url: holds a key"),
        ({"timeout": 0.0}, "timeout: 0.0"),
        ({"timeout": float("nan")}, "timeout: nan"),
        ({"answers": "sung"}, "answers: 'sung'"),
        ({"temperature": 3.0}, "temperature: 3.0"),
        ({"max_tokens": 0}, "max_tokens: 0"),
        ({"tries": True}, "tries: True"),
    ],
)
def test_refused(fields, says, monkeypatch):
    monkeypatch.setenv("SCENEWEAVER_API_KEY", KEY)
    with pytest.raises(InputError, match=says) as error:
        Endpoint(**{"model": "openai:small", **fields})
    assert KEY not in str(error.value) and "\n" not in str(error.value)


@pytest.mark.parametrize(("name", "value"), [("TIMEOUT", "soon"), ("STREAM", "perhaps"), ("MAX_TOKENS", "1e3")])
def test_wrong_variable(name, value, monkeypatch):
    monkeypatch.setenv(f"SCENEWEAVER_MODEL_{name}", value)
    with pytest.raises(InputError, match=f"SCENEWEAVER_MODEL_{name}: '{value}'"):
        Endpoint.of("small", LOCAL)


def test_key_that_cannot_be_sent(monkeypatch):
    monkeypatch.setenv("SCENEWEAVER_API_KEY", "two words\nand a line")
    with pytest.raises(InputError, match="SCENEWEAVER_API_KEY: holds characters") as error:
        open_client(Endpoint.of("small", LOCAL))
    assert "words\n" not in str(error.value)


@pytest.mark.parametrize("library", ["pydantic_ai.settings", "openai", "anthropic"])
def test_library_is_not_installed(library, monkeypatch):
    monkeypatch.setitem(sys.modules, library, None)
    kind = "anthropic" if library == "anthropic" else "openai"
    with pytest.raises(
        MissingDependencyError, match=r"\(extra 'llm'\); install it with: pip install 'pydantic-ai-slim"
    ):
        open_client(Endpoint.of(f"{kind}:small", LOCAL))


def test_nothing_is_loaded_before_it_is_needed():
    code = "import sceneweaver.llm, sys; print({'pydantic_ai', 'httpx2', 'openai', 'anthropic'} & set(sys.modules))"
    ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120, check=True)
    assert ran.stdout.strip() == "set()"


def test_holds_no_key(monkeypatch):
    monkeypatch.setenv("SCENEWEAVER_API_KEY", KEY)
    endpoint = Endpoint.of("small", LOCAL)
    assert endpoint.has_key
    assert KEY not in repr(endpoint) + json.dumps(endpoint.to_dict())


def test_nobody_there():
    client = open_client(Endpoint.of("small", "http://127.0.0.1:9/v1", tries=1))
    with pytest.raises(ModelUnreachable, match="no connection to http://127.0.0.1:9/v1"):
        client.ask("plan", Plan, "Plan.", ["a room"])
    assert client.lost


@pytest.mark.parametrize("answers", ["tool", "native", "prompted"])
@pytest.mark.parametrize("stream", [False, True])
def test_ways_to_answer(answers, stream, tmp_path):
    with ModelServer(answering({Plan: {"steps": 3}})) as server:
        client = open_client(Endpoint.of("small", server.url, answers=answers, stream=stream), records=tmp_path / "llm")
        assert client.ask("plan", Plan, "Plan.", ["a room"]).steps == 3
    assert bool(server.requests[0].tools) == (answers == "tool") and server.requests[0].stream == stream


def test_stream_makes_no_difference_to_records(tmp_path):
    found = []
    for stream in (False, True):
        folder = tmp_path / str(stream)
        with ModelServer(answering({Plan: [{"steps": "x"}, {"steps": 3}]})) as server:
            open_client(Endpoint.of("small", server.url, stream=stream), records=folder).ask(
                "plan", Plan, "Plan.", ["a room"]
            )
        record = json.loads((folder / "0001-plan.json").read_text())
        record["usage"].pop("seconds")
        found.append(record)
    assert found[0] == found[1]


def test_no_proxy_for_a_server_on_this_machine(monkeypatch):
    monkeypatch.setenv("HTTP_PROXY", "http://127.0.0.1:9")
    monkeypatch.setenv("ALL_PROXY", "http://127.0.0.1:9")
    with ModelServer(answering({Plan: {"steps": 1}})) as server:
        assert open_client(Endpoint.of("small", server.url)).ask("plan", Plan, "Plan.", ["a room"]).steps == 1


def test_base_url_of_messages_with_a_version():
    with ModelServer(answering({Plan: {"steps": 1}})) as server:
        client = open_client(Endpoint.of("anthropic:small", server.url))
        assert client.ask("plan", Plan, "Plan.", ["a room"]).steps == 1
