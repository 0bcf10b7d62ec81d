"""What callers give, made what the library takes; ValueError where it cannot be."""

from __future__ import annotations

import math
import re
from typing import Optional, Sequence, Tuple, Union

from . import _amble

Range = Union[float, Tuple[float, float]]
Amount = Union[float, Tuple[float, float], str]


def number(what: str, value: float, least: float, most: float, unit: str) -> float:
    """Within a range, both ends included."""
    given = float(value)
    if math.isnan(given) or given < least or given > most:
        raise ValueError(f"{what} is {value}; expected {least:g} to {most:g} {unit}".rstrip())
    return given


def optional(what: str, value: Optional[float], least: float, most: float, unit: str) -> Optional[float]:
    return None if value is None else number(what, value, least, most, unit)


def pair(what: str, value: Sequence[float], first: Tuple[float, float], second: Tuple[float, float],
         unit: str) -> Tuple[float, float]:
    if len(value) != 2:
        raise ValueError(f"{what} has {len(value)} numbers; expected two")
    return (number(what + "[0]", value[0], *first, unit), number(what + "[1]", value[1], *second, unit))


def ramp(what: str, value: Optional[Range], least: float, most: float,
         unit: str) -> Optional[Tuple[float, float]]:
    """A number, or two: from the begin to the end."""
    if value is None:
        return None
    ends = (value, value) if not isinstance(value, Sequence) else value
    return pair(what, ends, (least, most), (least, most), unit)


def amount(what: str, value: Optional[Amount], least: float, most: float,
           unit: str) -> Optional[Tuple[float, float, bool]]:
    """A ramp; or "1.2x" and "1x..1.3x", as many times what was captured."""
    if value is None:
        return None
    if not isinstance(value, str):
        ends = ramp(what, value, least, most, unit)
        return (*ends, False) if ends else None
    parts = [re.fullmatch(r"([0-9.]+)x", part) for part in value.split("..")]
    if len(parts) > 2 or not all(parts):
        raise ValueError(f"{what} is {value!r}; expected \"1.2x\", \"1x..1.3x\", or numbers [{unit}]")
    factors = [float(part.group(1)) for part in parts if part]
    return (factors[0], factors[-1], True)


def threads(count: Optional[int]) -> int:
    """None: as many as there are cores."""
    if count is None:
        return _amble.usual_threads()
    return whole("threads", count, 1, 64)


def whole(what: str, value: int, least: int, most: int) -> int:
    if value != int(value) or not least <= value <= most:
        raise ValueError(f"{what} is {value}; expected a whole number from {least} to {most}")
    return int(value)


def one_of(what: str, value: str, names: Sequence[str]) -> str:
    if value not in names:
        raise ValueError(f"{what} is {value!r}; expected one of {', '.join(repr(name) for name in names)}")
    return value


def is_z_up(up: Optional[str]) -> Optional[bool]:
    return None if up is None else one_of("up", up, ("y", "z")) == "z"


def fps(value: float) -> float:
    return number("fps", value, 24, 240, "frames a second")


def naming(names: str) -> str:
    return names and one_of("names", names, _amble.joint_namings())
