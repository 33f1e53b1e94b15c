"""Servers that show the key that they were sent."""

from __future__ import annotations

import base64
import itertools
from urllib.parse import quote

from tests.llm.bad_answers import arguments, mapped, with_arguments
from tests.llm.bad_statuses import status
from tests.llm.misbehaviour import bad
from tests.llm.said import Asked, Said


def key_of(asked: Asked) -> str:
    """The key of a request."""
    return asked.headers.get("x-api-key") or asked.headers.get("authorization", "").removeprefix("Bearer ")


@bad("echoes")
def key_in_error(asked: Asked, good: Said) -> Said:
    return status(401, f"Incorrect API key provided: {key_of(asked)}. Headers: {asked.headers}")


@bad("echoes")
def key_in_server_error(asked: Asked, good: Said) -> Said:
    return status(500, f"Traceback: authorization={key_of(asked)}", X_Request_Id=key_of(asked))


@bad("echoes")
def key_in_text(asked: Asked, good: Said) -> Said:
    return Said(text=f"Your key is {key_of(asked)}.")


@bad("echoes")
def key_in_refusal(asked: Asked, good: Said) -> Said:
    return Said(refusal=f"I do not serve {key_of(asked)}")


@bad("echoes")
def key_in_arguments(asked: Asked, good: Said) -> Said:
    """Valid wherever a text may be anything."""
    changed = mapped(arguments(good), lambda value: f"{value} {key_of(asked)}" if isinstance(value, str) else value)
    return with_arguments(asked, good, changed)


@bad("echoes")
def key_in_field_names(asked: Asked, good: Said) -> Said:
    return with_arguments(asked, good, {**arguments(good), key_of(asked): 1})


@bad("echoes")
def key_in_tool_name(asked: Asked, good: Said) -> Said:
    return Said(calls=((key_of(asked), {}),))


@bad("echoes")
def key_in_headers(asked: Asked, good: Said) -> Said:
    headers = {"X-Echo": key_of(asked), "Set-Cookie": f"session={key_of(asked)}", "Retry-After": key_of(asked)}
    return Said(raw=lambda wire: wire.error(429, "slow down", headers))


@bad("echoes")
def key_in_redirect(asked: Asked, good: Said) -> Said:
    return Said(raw=lambda wire: wire.document(307, b"", headers={"Location": f"http://127.0.0.1:9/{key_of(asked)}"}))


@bad("echoes")
def key_in_broken_json(asked: Asked, good: Said) -> Said:
    return with_arguments(asked, good, f'{{"key": "{key_of(asked)}", broken')


@bad("echoes")
def key_in_html(asked: Asked, good: Said) -> Said:
    page = f"<p>{key_of(asked)}</p>".encode()
    return Said(raw=lambda wire: wire.document(200, page, "text/html"))


@bad("echoes")
def key_in_halves(asked: Asked, good: Said) -> Said:
    """One half in each text, in turns."""
    key = key_of(asked)
    halves = itertools.cycle([key[: len(key) // 2], key[len(key) // 2 :]])
    return with_arguments(
        asked, good, mapped(arguments(good), lambda value: next(halves) if isinstance(value, str) else value)
    )


@bad("echoes")
def key_in_codes(asked: Asked, good: Said) -> Said:
    """As base64 of a header, for URLs, in hexadecimal, with blanks."""
    key = key_of(asked)
    header = base64.b64encode(f"Authorization: Bearer {key}".encode()).decode()
    codes = itertools.cycle([header, quote(key, safe=""), key.encode().hex(), " ".join(key)])
    return with_arguments(
        asked, good, mapped(arguments(good), lambda value: next(codes) if isinstance(value, str) else value)
    )


@bad("echoes")
def key_in_codes_of_errors(asked: Asked, good: Said) -> Said:
    key = key_of(asked)
    return status(500, f"{base64.b64encode(b'x' + key.encode()).decode()} {quote(key, safe='')} {key[:20]} {key[20:]}")
