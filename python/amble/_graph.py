"""Cluster graphs of captures: which of their frames are alike, and so where one can be left for another."""

from __future__ import annotations

import json
from typing import Any, Dict, List, Optional, Sequence, Tuple

from . import _amble, _check
from ._clips import Clip
from ._errors import NoWalkError
from ._walk import Path


class Graph:
    """A graph that is kept in a file (`amble graph build`). Its clips stay where they are, and are read when they are played.

        graph = amble.Graph.build(["Walk1.bvh", "WalkToRun.bvh"], "walks.graph")
        ways = graph.query("Walk1:60", "WalkToRun:120")["ways"]
        graph.play(ways["nearest"]["play"]).write("speedup.bvh")
    """

    def __init__(self, path: Path) -> None:
        """Raises InputError where a clip has changed since it was built."""
        self._made = _amble.open_graph(path)

    @classmethod
    def build(cls, clips: Sequence[Path], path: Path, *, fps: Optional[float] = None,
              threads: Optional[int] = None) -> "Graph":
        """Finds which frames are alike, and writes the graph.

        fps:     frames a second that are compared; None: 30, or those of the slowest clip
        threads: change no result; None: as many as there are cores
        """
        graph = cls.__new__(cls)
        rate = _check.optional("fps", fps, 1, 1000, "frames a second") or 0.0
        graph._made = _amble.build_graph(list(clips), path, rate, _check.threads(threads))
        return graph

    def __repr__(self) -> str:
        return f"<amble.Graph {self._made.file}: {', '.join(self.clips)}>"

    @property
    def clips(self) -> Dict[str, Tuple[int, int]]:
        """By name: the first and the last frame, as its file numbers them."""
        return self._made.clips

    @property
    def warnings(self) -> Tuple[str, ...]:
        """What was unsure when it was built; of one that was opened, none."""
        return self._made.warnings

    def query(self, start: str, end: str, *, error: float = _amble.graph_error, stay: float = 0.5) -> Dict[str, Any]:
        """Ways from one frame to another, "CLIP:FRAME", as `amble graph query --json` says them.

        error: frames that differ by less are alike [m]
        stay:  a clip is played so long between two jumps [s]

        "ways" has, of "cluster", "nearest", "best" and "through", those that there are, each with what plays it.
        """
        return json.loads(self._made.query(start, end, _check.number("error", error, 0, 100, "m"),
                                           _check.number("stay", stay, 0, 1000, "s")))

    def play(self, ranges: str, *, blend: float = _amble.graph_blend, fps: Optional[float] = None,
             footlock: bool = False) -> Clip:
        """Parts of clips, one after another: "CLIP:A-B,CLIP:C-D,...", where B meets C.

        blend:    time over which two clips are mixed at a join [s]
        fps:      frames a second; None: the graph's
        footlock: hold planted feet where they stand
        """
        return Clip(self._made.play(ranges, _check.number("blend", blend, 0, 10, "s"),
                                    _check.optional("fps", fps, 1, 1000, "frames a second") or 0.0, footlock))

    def loops(self, clip: str, *, error: float = _amble.graph_error, shortest: float = 0.4,
              at: Optional[int] = None, count: int = 2) -> List[Dict[str, Any]]:
        """Parts of a clip that can be played again and again, as `amble graph loop` lists them, the smoothest first.

        error:    frames that differ by less are alike [m]
        shortest: loops take at least so long [s]
        at:       those that are left nearest to this frame of the file first; None: the smoothest
        count:    times that "play" goes through it

        Of each: "leave" and "enter" ("CLIP:FRAME"), "duration" [s], "error" [m], and "play", for play().
        """
        return self._made.loops(clip, _check.number("error", error, 0, 100, "m"),
                                _check.number("shortest", shortest, 0, 1000, "s"),
                                None if at is None else _check.whole("at", at, 0, 10**9),
                                _check.whole("count", count, 1, 10000))

    def loop(self, clip: str, count: int = 2, *, at: Optional[int] = None, shortest: float = 0.4,
             error: float = _amble.graph_error, blend: float = _amble.graph_blend, fps: Optional[float] = None,
             footlock: bool = False) -> Clip:
        """A clip played through the first of its loops so many times. Raises NoWalkError where it has none."""
        found = self.loops(clip, error=error, shortest=shortest, at=at, count=count)
        if not found:
            raise NoWalkError(f"{clip} comes to no place again at error {error:g} m")
        return self.play(found[0]["play"], blend=blend, fps=fps, footlock=footlock)
