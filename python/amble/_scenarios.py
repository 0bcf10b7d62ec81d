"""Scenarios as callers give them: a file, the name of one that comes with Amble, or a dict."""

from __future__ import annotations

import json
import os
from typing import Any, Mapping, Optional, Tuple, Union

from . import _amble
from ._errors import InputError

Scenario = Union[str, "os.PathLike[str]", Mapping[str, Any]]


def _plain(value: Any) -> Any:
    """Of what JSON does not know: paths, NumPy's numbers and arrays."""
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if hasattr(value, "tolist"):
        return value.tolist()
    raise TypeError(f"{type(value).__name__} in a scenario; expected what YAML can say: dicts, "
                    "lists, texts, numbers")


def text_of(values: Mapping[str, Any]) -> str:
    """As YAML, of which JSON is a part, on one line."""
    try:
        return json.dumps(values, default=_plain, ensure_ascii=False, allow_nan=False)
    except ValueError as error:
        problem = "a dict that holds itself" if "ircular" in str(error) else "nan or inf"
        raise ValueError(f"{problem} in a scenario; expected what YAML can say, and finite numbers") from error


def find(scenario: Scenario, name: str) -> Tuple[str, Optional[str]]:
    """The file, and the text of what is in none."""
    if isinstance(scenario, Mapping):
        return f"<{name}>", text_of(scenario)
    if not isinstance(scenario, (str, os.PathLike)):
        raise TypeError(f"a scenario is of type {type(scenario).__name__}; expected the path of its file, "
                        "the name of one that comes with Amble, or a dict")
    file = os.fspath(scenario)
    if not os.path.exists(file) and not os.path.dirname(file) and not file.endswith(".yaml"):
        shipped = os.path.join(_amble.data_directory(), "scenarios", file + ".yaml")
        if os.path.exists(shipped):
            return shipped, None
    return file, None


def without_line(error: InputError, file: str, text: Optional[str]) -> InputError:
    """Of a dict: its text has lines that nobody has seen."""
    if text is None or error.file != file:
        return error
    expected = f"; expected {error.expected}" if error.expected else ""
    return InputError(f"{file}: {error.problem}{expected}", file, None, error.problem, error.expected)
