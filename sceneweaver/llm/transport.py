"""Connections to endpoints: what goes out in a header, and how much may come back."""

from __future__ import annotations

import os
import re
import warnings
from collections.abc import AsyncIterator
from typing import TYPE_CHECKING, Any

from sceneweaver.runtime.package import missing_extra
from sceneweaver.scene import InputError, MissingDependencyError

from .endpoint import Endpoint
from .faults import TooLong

if TYPE_CHECKING:
    import httpx2
    from pydantic_ai.models import Model

HEADERS = frozenset(
    ("host", "accept", "content-type", "content-length", "transfer-encoding", "connection", "anthropic-version")
    + ("anthropic-beta",)
)
"""Headers that go out beside the key. Others would come from variables of the environment that are not ours."""

NO_KEY = "none"
"""What the libraries hold in the place of a key. The key itself is put into a request as it leaves."""


def model_of(endpoint: Endpoint) -> Model:
    """The model of an endpoint, for pydantic-ai. Nothing is sent yet.

    Raises:
        MissingDependencyError: when the libraries are not installed.
        InputError: when the key is none that can be sent.
    """
    name = endpoint.key_name
    if name is not None and not re.fullmatch(r"[!-~]+", os.environ[name].strip()):
        raise InputError(f"{name}: holds characters that no key has, such as a space; set it to the key alone")
    try:
        return _built(endpoint)
    except ImportError:
        raise MissingDependencyError(missing_extra("llm", "models need pydantic-ai")) from None


def _built(endpoint: Endpoint) -> Model:
    import httpx2
    from pydantic_ai.settings import ModelSettings

    _silence_usage()
    http = httpx2.AsyncClient(
        timeout=httpx2.Timeout(endpoint.timeout, connect=min(endpoint.timeout, 10.0)),
        limits=httpx2.Limits(max_connections=16, max_keepalive_connections=0),
        trust_env=not endpoint.local,  # proxies of the environment, but not for a server on this machine
        event_hooks={"request": [_dressed(endpoint)], "response": [_bounded(endpoint)]},
        follow_redirects=False,  # a key goes to the host that was named, and to no other
    )
    settings = ModelSettings()
    if endpoint.temperature is not None:
        settings["temperature"] = endpoint.temperature
    if endpoint.max_tokens is not None or endpoint.kind == "anthropic":
        settings["max_tokens"] = endpoint.max_tokens or 8192
    if endpoint.kind == "anthropic":
        from anthropic import AsyncAnthropic
        from pydantic_ai.models.anthropic import AnthropicModel
        from pydantic_ai.providers.anthropic import AnthropicProvider

        client = AsyncAnthropic(
            api_key=NO_KEY,
            base_url=endpoint.url.rstrip("/").removesuffix("/v1"),  # which it adds itself
            max_retries=0,
            timeout=endpoint.timeout,
            http_client=http,
            open_telemetry=False,
        )
        return AnthropicModel(endpoint.name, provider=AnthropicProvider(anthropic_client=client), settings=settings)
    from openai import AsyncOpenAI
    from pydantic_ai.models.openai import OpenAIChatModel
    from pydantic_ai.providers.openai import OpenAIProvider
    from pydantic_ai.providers.openai_compatible import OpenAICompatibleProvider

    openai = AsyncOpenAI(
        api_key=NO_KEY, base_url=endpoint.url, max_retries=0, timeout=endpoint.timeout, http_client=http
    )
    provider = (
        OpenAIProvider(openai_client=openai)
        if endpoint.base_url is None
        else OpenAICompatibleProvider("openai", openai_client=openai)
    )
    return OpenAIChatModel(endpoint.name, provider=provider, settings=settings)


def _silence_usage() -> None:
    """Let pydantic-ai not print what a server says about tokens and its own guess of a cost: we count ourselves."""
    from pydantic_ai.exceptions import CostCalculationFailedWarning, CostNotFoundWarning, UsageExtractionFailedWarning

    for category in (CostCalculationFailedWarning, CostNotFoundWarning, UsageExtractionFailedWarning):
        warnings.filterwarnings("ignore", category=category)


def _dressed(endpoint: Endpoint) -> Any:
    async def dress(request: httpx2.Request) -> None:
        for name in [name for name in request.headers if name.lower() not in HEADERS]:
            del request.headers[name]
        request.headers["User-Agent"] = "sceneweaver"
        request.headers["Accept-Encoding"] = "identity"  # so that its bytes are what we count
        if endpoint.key_name is not None:
            if endpoint.kind == "anthropic":
                request.headers["x-api-key"] = os.environ[endpoint.key_name].strip()
            else:
                request.headers["Authorization"] = f"Bearer {os.environ[endpoint.key_name].strip()}"

    return dress


def _bounded(endpoint: Endpoint) -> Any:
    import httpx2

    class Bounded(httpx2.AsyncByteStream):
        """A reply that ends with `TooLong` where it has more bytes than it may."""

        def __init__(self, stream: httpx2.AsyncByteStream) -> None:
            self._stream = stream

        async def __aiter__(self) -> AsyncIterator[bytes]:
            size = 0
            async for piece in self._stream:
                size += len(piece)
                if size > endpoint.max_bytes:
                    raise TooLong(f"the reply is longer than {endpoint.max_bytes} bytes")
                yield piece

        async def aclose(self) -> None:
            await self._stream.aclose()

    async def bound(response: httpx2.Response) -> None:
        if response.headers.get("Content-Encoding", "identity").lower() != "identity":
            raise TooLong("the reply is compressed, which was not asked for")
        if isinstance(response.stream, httpx2.AsyncByteStream):
            response.stream = Bounded(response.stream)

    return bound
