"""The base of all models of the package: frozen, no unknown keys, errors of one line."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, ClassVar, Self

from pydantic import BaseModel, ConfigDict, ValidationError

from sceneweaver.io import InputError
from sceneweaver.io.messages import quote

from .messages import one_line


class FrozenModel(BaseModel):
    """A frozen model whose errors are InputErrors of one line."""

    model_config = ConfigDict(
        extra="forbid", frozen=True, allow_inf_nan=False, serialize_by_alias=True, defer_build=True
    )
    _noun: ClassVar[str] = ""

    def __init__(self, /, **data: Any) -> None:
        try:
            super().__init__(**data)
        except ValidationError as error:
            raise InputError(one_line(error, type(self), data, self._prefix(data))) from None

    __init__.__pydantic_base_init__ = True  # pyright: ignore[reportFunctionMemberAccess] - nested models skip it

    @classmethod
    def model_validate(cls, obj: Any, **options: Any) -> Self:
        """As pydantic's, but raises InputError with one line."""
        try:
            return super().model_validate(obj, **options)
        except ValidationError as error:
            raise InputError(one_line(error, cls, obj, cls._prefix(obj))) from None

    @classmethod
    def _prefix(cls, data: Any) -> str:
        """How an error names the model itself, for models made on their own."""
        name = data.get("id") if isinstance(data, Mapping) else None
        noun = cls._noun or cls.__name__.lower()
        return f"{noun} {quote(name)}" if isinstance(name, str) and name else noun
