"""Walks through scenes."""

from __future__ import annotations

import json
import os
from typing import TYPE_CHECKING, Any, Dict, Optional, Sequence, Union

from . import _amble, _check
from ._errors import NoWalkError
from ._motion import Steps

if TYPE_CHECKING:  # arrays bring NumPy when they are made: to load it takes as long as the rest
    import numpy as np
    from numpy.typing import NDArray

Path = Union[str, "os.PathLike[str]"]


class Walk(Steps):
    """A planned walk; or, where `solved` is False, why there is none.

    `bool(walk)` is `walk.solved`. Arrays of a walk that is none raise NoWalkError. They are those
    of walk.npz, to the bit.
    """

    def __init__(self, made: _amble.Walk) -> None:
        super().__init__(made)
        self._clearance: Optional[NDArray[np.float64]] = None

    def __bool__(self) -> bool:
        return self.solved

    def __repr__(self) -> str:
        if not self.solved:
            return f"<amble.Walk: {self.status}: {self.why}>"
        return f"<amble.Walk: {self.path_arcs[-1]:.2f} m, {self.duration:.2f} s, {self.frames} frames>"

    @property
    def status(self) -> str:
        """ "solved", "no_walk", "start_blocked" or "goal_blocked"."""
        return self._made.status

    @property
    def solved(self) -> bool:
        return self.status == "solved"

    @property
    def why(self) -> str:
        """Without a walk: what stood in the way, and what would do; else ""."""
        return self._made.why

    @property
    def report(self) -> Dict[str, Any]:
        """What report.json says: lengths in metres, angles in degrees (docs/files.md). A new dict each time."""
        return json.loads(self._made.report)

    @property
    def bvh(self) -> bytes:
        """The bytes of walk.bvh; b"" without a walk."""
        return self._made.bvh

    @property
    def arrays(self) -> Dict[str, Any]:
        if not self.solved:
            raise NoWalkError(f"{self.status}: {self.why}")
        return super().arrays

    @property
    def clearance(self) -> NDArray[np.float64]:
        """(F,): from the body to the nearest thing that soles do not stand on, 2 at most [m].

        Measured when it is first asked for, of the frames that walk.bvh has: the least is the report's.
        """
        if self._clearance is None:
            self.arrays  # of a walk that is none
            self._clearance = self._made.clearance()
        return self._clearance

    def write(self, path: Path, formats: Optional[Sequence[str]] = None, *, views: Sequence[str] = (),
              threads: Optional[int] = None) -> None:
        """Writes what `amble plan` writes: the same bytes.

        path:    a file, of the format that its ending names: .bvh, .json (the report), .glb, .npz,
                 .html, .svg, .png, .mp4; else a folder, which is made if need be
        formats: of a folder: names of `amble.FORMATS`; None: the usual ones
        views:   of a folder: pictures from "top", "side", "corner", "first"
        threads: changes no byte; None: as many as there are cores

        Either all files are there afterwards, or none. Raises InputError, naming what cannot be written.
        """
        with_threads = _check.threads(threads)
        if formats is None and not views and os.path.splitext(os.fspath(path))[1] and not os.path.isdir(path):
            self._made.write_file(path, with_threads)
            return
        chosen = _amble.usual_formats() if formats is None else list(formats)
        for name in chosen:
            _check.one_of("formats", name, _amble.format_names())
        for name in views:
            _check.one_of("views", name, _amble.view_names())
        self._made.write_folder(path, chosen, list(views), with_threads)
