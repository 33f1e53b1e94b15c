"""Numbers in words, in German, Spanish, French and Chinese, up to two hundred."""

from __future__ import annotations

from functools import cache

from .vocabulary import words

LARGEST = 200
"""The largest number that has a name here."""


@cache
def numerals(language: str) -> dict[str, int]:
    """The names of numbers from 2 on."""
    return {_name(n, language): n for n in range(LARGEST, 1, -1)} | ({"两百": 200} if language == "zh" else {})


@cache
def decades(language: str) -> dict[str, int]:
    """What the decades of the last century are called, with their first year: "années 50"."""
    found: dict[str, int] = {}
    for tens in range(20, 100, 10):
        name = _name(tens, language)
        forms = {
            "de": (f"{tens}er jahre", f"{name}er jahre", f"{tens}er-jahre", f"{tens}ern", f"{tens}er jahren"),
            "es": (f"años {tens}", f"años {name}", f"los años {name}", f"los {tens}"),
            "fr": (f"années {tens}", f"années {name}", f"des années {tens}", f"des années {name}"),
            "zh": (f"{tens}年代", f"{name}年代"),
        }[language]
        found |= dict.fromkeys(forms, 1900 + tens)
    return found


def _name(n: int, language: str) -> str:
    return {"de": _german, "es": _spanish, "fr": _french, "zh": _chinese}[language](n)


@cache
def _row(name: str) -> list[str]:
    """Names of numbers in order: those of ones that are no compounds, or of tens."""
    return words("translations/numerals")[name].split()


def _german(n: int) -> str:
    if n >= 100:
        return ("" if n < 200 else "zwei") + "hundert" + (_german(n % 100) if n % 100 else "")
    if n < 20:
        return _row("german")[n]
    tens, ones = _row("german_tens")[n // 10 - 2], n % 10
    return f"{_row('german')[ones]}und{tens}" if ones else tens


def _spanish(n: int) -> str:
    if n >= 100:
        return ("cien" if n == 100 else f"ciento {_spanish(n - 100)}") if n < 200 else "doscientos"
    if n < 30:
        return _row("spanish")[n]
    tens, ones = _row("spanish_tens")[n // 10 - 3], n % 10
    return f"{tens} y {_row('spanish')[ones]}" if ones else tens


def _french(n: int) -> str:
    if n >= 100:
        return ("cent" if n == 100 else f"cent {_french(n - 100)}") if n < 200 else "deux cents"
    if n < 20:
        return _row("french")[n]
    if n < 70:
        tens, ones = _row("french_tens")[n // 10 - 2], n % 10
        return tens if not ones else f"{tens} et un" if ones == 1 else f"{tens}-{_row('french')[ones]}"
    if n < 80:
        return "soixante et onze" if n == 71 else f"soixante-{_row('french')[n - 60]}"
    return "quatre-vingts" if n == 80 else f"quatre-vingt-{_row('french')[n - 80]}"


def _chinese(n: int) -> str:
    if n >= 100:
        rest = n % 100
        return f"{_row('chinese')[n // 100]}百" + (
            ("零" if rest < 10 else "一" if rest < 20 else "") + _chinese(rest) if rest else ""
        )
    tens, ones = divmod(n, 10)
    return ("" if not tens else "十" if tens == 1 else f"{_row('chinese')[tens]}十") + (
        _row("chinese")[ones] if ones else ""
    )
