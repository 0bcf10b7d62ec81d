"""A planner that is made once and asked many times."""

from __future__ import annotations

from typing import Any, Dict, Mapping, Optional, Sequence, Union

from . import _amble, _check, _scenarios
from ._errors import InputError
from ._walk import Path, Walk

Place = Union[Sequence[float], Mapping[str, Any]]
"""[x, y], or [x, y, z] where floors lie over one another [m]; or {"at": ..., "heading": degrees}.
Without a heading any is right."""


def _place(place: Place) -> Mapping[str, Any]:
    if isinstance(place, Mapping):
        return place
    if isinstance(place, str) or not hasattr(place, "__iter__"):
        raise TypeError(f"{place!r} is no place; expected [x, y], [x, y, z] or {{'at': ..., 'heading': ...}}")
    return {"at": list(place)}


class Planner:
    """A scene, a walker and a roadmap of where he can walk: made once, asked from as many threads as like.

        planner = amble.Planner("environments/scenes/living-room/scene.yaml", {"height": 1.8})
        walk = planner.plan([1, 1], {"at": [6.5, 4.8], "heading": 0})

    An answer depends on the question alone, to the bit: not on those before it, beside it, or on
    threads. Its walks share the scene with the planner.
    """

    def __init__(self, scene: Path, character: Union[Mapping[str, Any], float, None] = None,
                 library: Optional[Path] = None, *, walk: Optional[Mapping[str, Any]] = None,
                 bounds: Optional[Mapping[str, Any]] = None, planner: str = "visibility", seed: int = 1,
                 time_limit: float = 60.0, fps: float = 60.0, roadmap: Optional[Path] = None,
                 max_failures: int = _amble.roadmap_failures, threads: Optional[int] = None,
                 name: str = "planner") -> None:
        """Reads all of it, and has the roadmap grow.

        scene:        a scene file
        character:    what scenarios say of it ({"height": 1.75, "max_slope": 20, ...}), or a stature [m]
        library:      "default", or a motion library's file; None: the character's
        walk:         what scenarios say of it: {"speed": 1.2, "style": ..., "actions": [...]}
        bounds:       where to look: {"min": [x, y], "max": [x, y]} [m]; None: all that can be walked on
        planner:      searches what the roadmap does not answer
        seed:         of the roadmap, and of searches
        time_limit:   of each walk, and of the roadmap [s]
        fps:          frames a second [24 to 240]
        roadmap:      file of a kept one, instead of a new one; a stale one is refused
        max_failures: in a row, after which the roadmap is good enough [1 to 1,000,000]
        threads:      change no result; None: as many as there are cores
        name:         for messages

        Raises InputError; TimeoutError where the limit passes while the scene is read; KeyboardInterrupt at Ctrl-C.
        """
        person = {"height": character} if isinstance(character, (int, float)) else dict(character or {})
        if library is not None:
            person["library"] = library
        self._fixed: Dict[str, Any] = {"scene": scene}
        for key, value in {"character": person, "walk": walk, "bounds": bounds}.items():
            if value:
                self._fixed[key] = value
        self._search = {"name": planner, "seed": _check.whole("seed", seed, 0, 2**31 - 1),
                        "time_limit": _check.number("time_limit", time_limit, 0.001, 86400, "s")}
        self._fps = _check.fps(fps)
        self._name = name
        asked = self._asked(threads)
        if roadmap is not None:
            asked.roadmap = roadmap
        nowhere = {"at": [0, 0]}
        text = _scenarios.text_of({**self._fixed, "planner": self._search, "start": nowhere, "goal": nowhere})
        failures = _check.whole("max_failures", max_failures, 1, 1_000_000)
        try:
            self._made = _amble.make_planner(f"<{name}>", text, asked, failures)
        except InputError as error:
            raise _scenarios.without_line(error, f"<{name}>", text) from None

    def __repr__(self) -> str:
        roadmap = self.roadmap
        return f"<amble.Planner: {roadmap['guards']} guards, {roadmap['connectors']} connectors>"

    def _asked(self, threads: Optional[int], names: str = "") -> _amble.Asked:
        asked = _amble.Asked()
        asked.fps, asked.threads, asked.names = self._fps, _check.threads(threads), _check.naming(names)
        return asked

    def plan(self, start: Place, goal: Place, via: Sequence[Place] = (), *, seed: Optional[int] = None,
             time_limit: Optional[float] = None, names: str = "", threads: int = 1, name: str = "") -> Walk:
        """One walk; as amble.plan(), that none is found is a result. Any number of threads may call it at once.

        start, goal: [x, y] or [x, y, z] [m], or {"at": ..., "heading": degrees}
        via:         places that are passed in order
        seed, time_limit [s]: in place of the planner's
        names:       names joints as "mixamo", "vrm", ... do
        threads:     of this one search; change no result
        name:        of the walk, in its report
        """
        asked = self._asked(threads, names)
        search = dict(self._search)
        if seed is not None:
            search["seed"] = _check.whole("seed", seed, 0, 2**31 - 1)
        if time_limit is not None:
            search["time_limit"] = _check.number("time_limit", time_limit, 0.001, 86400, "s")
        values = {**self._fixed, "planner": search, "start": _place(start), "goal": _place(goal)}
        if len(via) > 0:
            values["via"] = [_place(place) for place in via]
        asked.command = f"amble.Planner(...).plan({start!r}, {goal!r}, {via!r}, seed={search['seed']})"
        file, text = f"<{name or self._name}>", _scenarios.text_of(values)
        try:
            return Walk(self._made.plan(file, text, asked))
        except InputError as error:
            raise _scenarios.without_line(error, file, text) from None

    @property
    def roadmap(self) -> Dict[str, Any]:
        """guards, connectors, edges, samples, coverage [0 to 1]"""
        return self._made.roadmap

    def save(self, path: Path) -> None:
        """Keeps the roadmap in a file, as `amble roadmap build` does."""
        self._made.save(path)
