"""Walks."""

from __future__ import annotations

import json
from typing import Any, Dict, Tuple

import numpy as np
from numpy.typing import NDArray

from . import _amble
from ._errors import NoWalkError


class Walk:
    """A planned walk; or, where `solved` is False, why there is none.

    `bool(walk)` is `walk.solved`. Arrays of a walk that is none raise NoWalkError.

    World is right-handed, z up, in metres; heading 0 faces +x, a left turn is positive. F frames,
    J joints, N footprints. Arrays are those of walk.npz, to the bit, and read-only: views of what
    was planned, of which no second copy is made.
    """

    def __init__(self, made: _amble.Walk) -> None:
        self._made = made
        self._report: Dict[str, Any] = {}
        self._arrays: Dict[str, Any] = {}

    def __bool__(self) -> bool:
        return self.solved

    def __repr__(self) -> str:
        if not self.solved:
            return f"<amble.Walk: {self.status}: {self.why}>"
        return f"<amble.Walk: {self.report['length']:.2f} m, {self.duration:.2f} s, {self.frames} frames>"

    @property
    def status(self) -> str:
        """ "solved", "no_walk", "start_blocked" or "goal_blocked"."""
        return self._made.status

    @property
    def solved(self) -> bool:
        return self.status == "solved"

    @property
    def why(self) -> str:
        """Without a walk: what stood in the way, and what would do. Else ""."""
        return self._made.why

    @property
    def report(self) -> Dict[str, Any]:
        """report.json: lengths in metres, angles in degrees (docs/files.md)."""
        if not self._report:
            self._report = json.loads(self._made.report)
        return self._report

    @property
    def bvh(self) -> bytes:
        """The bytes of walk.bvh; b"" without a walk."""
        return self._made.bvh

    @property
    def arrays(self) -> Dict[str, Any]:
        """All arrays by the names that walk.npz has for them, joint_names and frame_time with them."""
        if not self.solved:
            raise NoWalkError(f"{self.status}: {self.why}")
        if not self._arrays:
            self._arrays = self._made.arrays()
        return self._arrays

    @property
    def frames(self) -> int:
        """F."""
        return len(self.arrays["phases"])

    @property
    def frame_time(self) -> float:
        """Of a frame [s]."""
        return self.arrays["frame_time"]

    @property
    def duration(self) -> float:
        """From the first frame to the last [s]."""
        return (self.frames - 1) * self.frame_time

    @property
    def joint_names(self) -> Tuple[str, ...]:
        """J names, a parent before its children."""
        return self.arrays["joint_names"]

    @property
    def parents(self) -> NDArray[np.int32]:
        """(J,): index of each joint's parent; -1 of the root."""
        return self.arrays["parents"]

    @property
    def offsets(self) -> NDArray[np.float64]:
        """(J, 3): each joint's origin in its parent's frame [m]."""
        return self.arrays["offsets"]

    @property
    def quaternions(self) -> NDArray[np.float64]:
        """(F, J, 4): (w, x, y, z) of each joint in its parent's frame; of the root in World."""
        return self.arrays["quaternions"]

    @property
    def positions(self) -> NDArray[np.float64]:
        """(F, J, 3): each joint's origin in World [m]."""
        return self.arrays["positions"]

    @property
    def root_positions(self) -> NDArray[np.float64]:
        """(F, 3): the root joint's origin in World [m]."""
        return self.arrays["root_positions"]

    @property
    def path_positions(self) -> NDArray[np.float64]:
        """(F, 3): of the root path, on the ground [m]."""
        return self.arrays["path_positions"]

    @property
    def path_headings(self) -> NDArray[np.float64]:
        """(F,): of the root path [rad]."""
        return self.arrays["path_headings"]

    @property
    def path_speeds(self) -> NDArray[np.float64]:
        """(F,): along the root path [m/s]."""
        return self.arrays["path_speeds"]

    @property
    def path_turn_rates(self) -> NDArray[np.float64]:
        """(F,): left positive [rad/s]."""
        return self.arrays["path_turn_rates"]

    @property
    def path_arcs(self) -> NDArray[np.float64]:
        """(F,): walked along the root path since the begin [m]."""
        return self.arrays["path_arcs"]

    @property
    def phases(self) -> NDArray[np.float64]:
        """(F,): of the walk cycle, 0 <= . < 1; 0 is the middle of the double support with the left foot in front."""
        return self.arrays["phases"]

    @property
    def planted(self) -> NDArray[np.bool_]:
        """(F, 2): whether the left and the right sole are on the ground."""
        return self.arrays["planted"]

    @property
    def footprint_sides(self) -> NDArray[np.int32]:
        """(N,): 0 left, 1 right."""
        return self.arrays["footprint_sides"]

    @property
    def footprint_positions(self) -> NDArray[np.float64]:
        """(N, 3): middle of the sole, on the ground [m]."""
        return self.arrays["footprint_positions"]

    @property
    def footprint_headings(self) -> NDArray[np.float64]:
        """(N,): of the foot [rad]."""
        return self.arrays["footprint_headings"]

    @property
    def footprint_frames(self) -> NDArray[np.int32]:
        """(N, 2): the first and the last frame in which it is planted."""
        return self.arrays["footprint_frames"]
