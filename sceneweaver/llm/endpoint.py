"""Which model is asked, where, and how. Keys are read from the environment when a request leaves, and kept nowhere."""

from __future__ import annotations

import math
import os
from dataclasses import asdict, dataclass, fields
from typing import Any, Literal, Self, cast, get_args
from urllib.parse import SplitResult, urlsplit

from sceneweaver.scene import InputError, MissingDependencyError

from .secrets import line, redact

Answers = Literal["tool", "native", "prompted"]
"""How a structured answer is asked for: a function call, the endpoint's JSON schema mode, or words in the prompt."""

PREFIX = "SCENEWEAVER_"
KEY = PREFIX + "API_KEY"

HOSTS = {"openai": "https://api.openai.com/v1", "anthropic": "https://api.anthropic.com"}
"""Where each kind of endpoint is when no base URL is given."""

VENDOR_KEYS = {"openai": "OPENAI_API_KEY", "anthropic": "ANTHROPIC_API_KEY"}
"""Keys that go to the hosts above, and to no other."""

VARIABLES = {
    "model": "MODEL",
    "base_url": "BASE_URL",
    "timeout": "MODEL_TIMEOUT",
    "stream": "MODEL_STREAM",
    "answers": "MODEL_ANSWERS",
    "pictures": "MODEL_PICTURES",
    "temperature": "MODEL_TEMPERATURE",
    "max_tokens": "MODEL_MAX_TOKENS",
    "per_minute": "MODEL_PER_MINUTE",
}
"""Fields that the environment may set, each by a variable with `SCENEWEAVER_` before it."""


@dataclass(frozen=True)
class Endpoint:
    """A model that can be asked. Holds no key: see `has_key`.

    `OPENAI_BASE_URL` and its like of other libraries are not looked at: only what is said here redirects a request.

    Attributes:
        model: "openai:NAME", "anthropic:NAME", or NAME alone for chat completions of the OpenAI kind at `base_url`.
        base_url: where, such as "http://127.0.0.1:11434/v1"; None for the vendor's own host.
        timeout: seconds that one request may take in total, its whole reply read.
        stream: whether replies come in pieces.
        answers: how structured answers are asked for.
        pictures: whether the model takes pictures.
        temperature: of sampling; None leaves it to the endpoint.
        max_tokens: most tokens of an answer; None leaves it to the endpoint (8192 for Anthropic, which needs a number).
        per_minute: most requests a minute; None for no limit of ours.
        tries: times that a request is made before an error that may pass counts as one that stays.
        max_bytes: most bytes of a reply.

    Raises:
        InputError: naming the field that is wrong.

    Examples:
        >>> from sceneweaver.llm import Endpoint
        >>> Endpoint("llama3.2:3b", "http://127.0.0.1:11434/v1").title
        'openai:llama3.2:3b'
    """

    model: str
    base_url: str | None = None
    timeout: float = 120.0
    stream: bool = False
    answers: Answers = "tool"
    pictures: bool = True
    temperature: float | None = None
    max_tokens: int | None = None
    per_minute: float | None = None
    tries: int = 5
    max_bytes: int = 512 * 1024

    def __post_init__(self) -> None:
        prefix, found, name = self.model.partition(":")
        if not self.model.strip() or (found and prefix in HOSTS and not name.strip()):
            raise InputError("model: has no name; write openai:NAME or anthropic:NAME")
        if len(self.model) > 200 or not self.model.isprintable():
            raise InputError("model: is no name of a model; write openai:NAME or anthropic:NAME")
        if self.base_url is None and prefix not in HOSTS:
            raise InputError(
                f"model: {line(self.model)!r} does not say whose it is; write openai:NAME or anthropic:NAME, "
                f"or give the base URL of a server of your own ({PREFIX}BASE_URL)"
            )
        if self.base_url is not None:
            _check_url(self.base_url)
        _positive("timeout", self.timeout, "seconds")
        _positive("tries", self.tries, "times")
        _positive("max_bytes", self.max_bytes, "bytes")
        if self.answers not in get_args(Answers):
            raise InputError(
                f"answers: {self.answers!r} is no way to answer; choose from {', '.join(get_args(Answers))}"
            )
        if self.temperature is not None and not 0 <= self.temperature <= 2:
            raise InputError(f"temperature: {self.temperature} is not between 0 and 2")
        if self.max_tokens is not None:
            _positive("max_tokens", self.max_tokens, "tokens")
        if self.per_minute is not None:
            _positive("per_minute", self.per_minute, "requests")

    @classmethod
    def of(cls, model: str | None = None, base_url: str | None = None, **options: Any) -> Self:
        """An endpoint from arguments and, where one is None, from the environment: `SCENEWEAVER_MODEL`,
        `SCENEWEAVER_BASE_URL`, `SCENEWEAVER_MODEL_TIMEOUT` and so on.

        Raises:
            MissingDependencyError: when no model is configured, or the vendor's host would be asked without a key.
            InputError: for a value that is wrong, naming the variable where it comes from one.
        """
        given = {"model": model, "base_url": base_url, **options}
        if unknown := set(given) - {field.name for field in fields(cls)}:
            raise InputError(f"{sorted(unknown)[0]}: is no option of an endpoint")
        for field, variable in VARIABLES.items():
            if given.get(field) is None and (text := os.environ.get(PREFIX + variable, "").strip()):
                given[field] = _parsed(field, PREFIX + variable, text)
        if given["model"] is None:
            raise MissingDependencyError(
                f"no model is configured; set {PREFIX}MODEL to openai:NAME or anthropic:NAME, "
                f"or to NAME with {PREFIX}BASE_URL for a server of your own"
            )
        endpoint = cls(**{field: value for field, value in given.items() if value is not None})
        if endpoint.base_url is None and not endpoint.has_key:
            raise MissingDependencyError(
                f"{endpoint.title} needs a key; set {VENDOR_KEYS[endpoint.kind]} or {KEY} in the environment"
            )
        return endpoint

    @property
    def kind(self) -> str:
        """The protocol: "openai" for chat completions, "anthropic" for messages."""
        prefix = self.model.partition(":")[0]
        return prefix if prefix in HOSTS else "openai"

    @property
    def name(self) -> str:
        """The model's name as the endpoint knows it."""
        prefix, _, name = self.model.partition(":")
        return name if prefix in HOSTS else self.model

    @property
    def title(self) -> str:
        """Protocol and name, for reports and records."""
        return redact(f"{self.kind}:{self.name}")

    @property
    def url(self) -> str:
        """Where requests go."""
        return self.base_url or HOSTS[self.kind]

    @property
    def local(self) -> bool:
        """Whether it is a server on this machine."""
        return urlsplit(self.url).hostname in ("localhost", "127.0.0.1", "::1")

    @property
    def key_name(self) -> str | None:
        """The variable of the environment whose key goes along with requests."""
        vendors_own = urlsplit(self.url)[:2] == urlsplit(HOSTS[self.kind])[:2]  # never without encryption
        names = [KEY, VENDOR_KEYS[self.kind]] if vendors_own else [KEY]
        return next((name for name in names if os.environ.get(name, "").strip()), None)

    @property
    def has_key(self) -> bool:
        """Whether the environment holds a key for this endpoint."""
        return self.key_name is not None

    def to_dict(self) -> dict[str, Any]:
        """The fields as JSON data. There is no key among them."""
        return redact(asdict(self))


def _check_url(text: str) -> None:
    """Refuse a URL that holds a secret or leads nowhere; the words never repeat it, as it may hold one."""
    try:
        url: SplitResult = urlsplit(text)
        port = url.port
    except ValueError:
        raise InputError("base_url: is no URL; write one such as http://127.0.0.1:8000/v1") from None
    if url.username is not None or url.password is not None:
        raise InputError(f"base_url: holds a user name or a password; take it out and set {KEY} instead")
    if url.query or url.fragment:
        raise InputError(f"base_url: holds a query, and keys in it would reach files; set {KEY} for a key")
    if url.scheme not in ("http", "https") or not url.hostname or port == 0 or not text.isprintable() or " " in text:
        raise InputError("base_url: is no URL of a server; write one such as http://127.0.0.1:8000/v1")
    if redact(text) != text:
        raise InputError(f"base_url: holds a key; take it out and set {KEY} instead")


def _positive(field: str, value: float, unit: str) -> None:
    if isinstance(value, bool) or not isinstance(value, int | float) or not 0 < value < math.inf:
        raise InputError(f"{field}: {value!r} is no number of {unit} above zero")


def _parsed(field: str, variable: str, text: str) -> Any:
    if field in ("stream", "pictures"):
        if text.lower() not in ("0", "1", "yes", "no", "true", "false"):
            raise InputError(f"{variable}: {line(text)!r} is neither yes nor no")
        return text.lower() in ("1", "yes", "true")
    if field in ("timeout", "temperature", "per_minute", "max_tokens"):
        try:
            return int(text) if field == "max_tokens" else float(text)
        except ValueError:
            raise InputError(f"{variable}: {line(text)!r} is no number") from None
    return cast(Any, text)
