"""What walks and captures have in common: their frames, as arrays."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, Tuple

if TYPE_CHECKING:  # arrays bring NumPy when they are made: to load it takes as long as the rest
    import numpy as np
    from numpy.typing import NDArray


class Motion:
    """Frames of a skeleton. F is the number of frames, J of joints.

    World is right-handed, z up, in metres. Arrays are read-only: views of the motion itself, or the
    one copy that is made of it, when the first of them is asked for.
    """

    def __init__(self, made: Any) -> None:
        self._made = made
        self._arrays: Dict[str, Any] = {}

    @property
    def arrays(self) -> Dict[str, Any]:
        """All of them by name, joint_names and frame_time too."""
        if not self._arrays:
            self._arrays = self._made.arrays()
        return self._arrays

    @property
    def frames(self) -> int:
        """F."""
        return len(self.arrays["root_positions"])

    @property
    def frame_time(self) -> float:
        """Of a frame [s]."""
        return self.arrays["frame_time"]

    @property
    def duration(self) -> float:
        """From the first frame to the last [s]."""
        return max(0, self.frames - 1) * self.frame_time

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


class Steps(Motion):
    """A motion that was made step by step: its root path and its prints. N is the number of footprints.

    Heading 0 faces +x, a left turn is positive.
    """

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
        """(F, 2): whether the left and the right sole touch the ground."""
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
