#!/usr/bin/python3
"""Walks as a data set: windows of frames out of a folder of NPZ files, in shuffled batches, with NumPy alone.

    /usr/bin/python3 examples/python/dataset.py FOLDER

The files are those of `amble plan --formats npz`, of many_walks.py, or of a batch: its packs, which hold fifty walks each
(`amble batch --pack`), where it has them. `WalkWindows` has what PyTorch asks of a data set, so that
`torch.utils.data.DataLoader(WalkWindows(folder))` takes it; `batches()` does without.
"""

import pathlib
import sys

import numpy as np

ARRAYS = ("positions", "quaternions", "planted", "phases", "path_headings", "path_positions")


def walks_in(folder):
    """A file and what the names of its arrays begin with, for each walk: "" where the file is of one."""
    folder = pathlib.Path(folder)
    files = sorted((folder / "packs").glob("*.npz"))
    if not files:  # a walk's labels hold its arrays too
        files = [file for file in sorted(folder.rglob("*.npz"))
                 if file.name != "labels.npz" or not (file.parent / "walk.npz").exists()]
    for file in files:
        with np.load(file) as arrays:
            for name in sorted(arrays.files):
                if name == "phases" or name.endswith("/phases") and name.count("/") == 1:
                    yield file, name[:-len("phases")], len(arrays[name])


class WalkWindows:
    """Every window of `frames` frames, `step` apart. In the frame of the walker where each begins: he stands at (0, 0) and
    faces +x, so that a window does not tell where in the room it is."""

    def __init__(self, folder, frames=60, step=30):
        self.frames = frames
        self.walks = list(walks_in(folder))
        self.windows = [(index, first) for index, (_, _, length) in enumerate(self.walks)
                        for first in range(0, length - frames + 1, step)]
        self._open = (-1, None)

    def __len__(self):
        return len(self.windows)

    def __getitem__(self, index):
        """positions (frames, joints, 3) [m], quaternions (frames, joints, 4), planted (frames, 2), phases (frames,)."""
        number, first = self.windows[index]
        walk = self._walk(number)
        frames = slice(first, first + self.frames)
        heading, origin = walk["path_headings"][first], walk["path_positions"][first]
        turn = np.array([[np.cos(heading), np.sin(heading), 0], [-np.sin(heading), np.cos(heading), 0], [0, 0, 1]])
        half = -0.5 * heading
        root = quaternion_product([np.cos(half), 0, 0, np.sin(half)], walk["quaternions"][frames, 0])
        quaternions = walk["quaternions"][frames].copy()
        quaternions[:, 0] = root
        return {"positions": ((walk["positions"][frames] - origin) @ turn.T).astype(np.float32),
                "quaternions": quaternions.astype(np.float32),
                "planted": walk["planted"][frames], "phases": walk["phases"][frames].astype(np.float32)}

    def _walk(self, number):
        """Its arrays; those of the last one are kept, since its windows are often asked for one after another."""
        if self._open[0] != number:
            file, prefix, _ = self.walks[number]
            with np.load(file) as arrays:
                self._open = (number, {name: arrays[prefix + name] for name in ARRAYS})
        return self._open[1]


def quaternion_product(a, b):
    """The turn b, then the turn a about the same axes; (w, x, y, z) along the last axis of b."""
    w, x, y, z = a
    bw, bx, by, bz = np.moveaxis(b, -1, 0)
    return np.stack([w * bw - x * bx - y * by - z * bz, w * bx + x * bw + y * bz - z * by,
                     w * by - x * bz + y * bw + z * bx, w * bz + x * by - y * bx + z * bw], axis=-1)


def batches(dataset, size, seed=0):
    """All windows once, in an order that the seed gives, `size` at a time; what is left over at the end is left out."""
    order = np.random.default_rng(seed).permutation(len(dataset))
    for first in range(0, len(order) - size + 1, size):
        items = [dataset[index] for index in order[first:first + size]]
        yield {name: np.stack([item[name] for item in items]) for name in items[0]}


def main(folder):
    dataset = WalkWindows(folder)
    count, planted = 0, 0.0
    for batch in batches(dataset, size=4):
        count += len(batch["phases"])
        planted += batch["planted"].mean() * len(batch["phases"])
    print(f"{len(dataset)} windows of {len(dataset.walks)} walks; {count} in batches; a foot is planted for "
          f"{planted / max(1, count):.0%} of the time")


if __name__ == "__main__":
    main(*sys.argv[1:])
