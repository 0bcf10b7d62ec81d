#!/usr/bin/env python3
"""A data set of the walks of a batch, as PyTorch and its like take one; NumPy is all that it needs.

    python3 examples/batch/dataset.py DIR [--frames 60] [--stride 30] [--batch 16] [--seed 0]

Walks is a map-style data set: `len(walks)`, `walks[i]` -> {name: array} of a whole walk. Windows cuts walks into stretches of as
many frames each, and Batches draws them in a seeded order and stacks them: what a training loop goes over. With PyTorch,
`torch.utils.data.DataLoader(Windows(walks, 60, 30), batch_size=16)` takes the first two as they are.

DIR is a merged batch whose walks have labels (docs/batch.md says what each array holds), in folders or in packs (`--pack`).
"""
import argparse
import collections
import csv
import json
import pathlib

import numpy as np

# Arrays with a row a frame, of those in labels.npz: what a window is cut from.
BY_FRAME = ("root_positions", "quaternions", "positions", "path_positions", "path_headings", "path_speeds", "phases", "planted",
            "clearance", "contact", "activity")


class Walks:
    """The walks that were found, in the table's order; those that `keep(row)` says where it is given.

    rows: their lines of index.jsonl: scene, height, speed, caption, length, ...
    Of walks that were asked for the last few are kept in memory.
    """

    def __init__(self, folder, keep=lambda row: True, kept=64):
        self.folder = pathlib.Path(folder)
        with (self.folder / "index.jsonl").open(encoding="utf-8") as lines:
            rows = [json.loads(line) for line in lines]
        self.rows = [row for row in rows if row["status"] == "solved" and keep(row)]
        self._packs = self._read_packs()
        self._kept = kept
        self._read = collections.OrderedDict()

    def __len__(self):
        return len(self.rows)

    def __getitem__(self, index):
        key = self.rows[index]["walk"]
        if key not in self._read:
            self._read[key] = self._load(key)
            if len(self._read) > self._kept:
                self._read.popitem(last=False)
        self._read.move_to_end(key)
        return self._read[key]

    def _read_packs(self):
        """The pack of each walk, where the batch was packed."""
        index = self.folder / "packs" / "index.csv"
        if not index.exists():
            return {}
        with index.open(newline="", encoding="utf-8") as lines:
            return {line["walk"]: self.folder / "packs" / line["pack"] for line in csv.DictReader(lines)}

    def _load(self, key):
        if key not in self._packs:
            with np.load(self.folder / "walks" / key[:2] / key / "labels.npz") as file:
                return {name: file[name] for name in file.files}
        with np.load(self._packs[key]) as file:  # which has the walk's other files beside its arrays, with an ending
            own = [name for name in file.files if name.startswith(f"{key}/") and "." not in name]
            return {name[len(key) + 1 :]: file[name] for name in own}


class Windows:
    """Stretches of `frames` frames, one every `stride` of them, of all walks that are so long.

    windows[i] is {name: array of `frames` rows}, and `walk`, the number of its walk, and `first`, its first frame.
    """

    def __init__(self, walks, frames, stride, names=BY_FRAME):
        self.walks, self.frames, self.names = walks, frames, names
        self.places = [(walk, first) for walk, row in enumerate(walks.rows) for first in range(0, row["frames"] - frames + 1, stride)]

    def __len__(self):
        return len(self.places)

    def __getitem__(self, index):
        walk, first = self.places[index]
        arrays = self.walks[walk]
        window = {name: arrays[name][first : first + self.frames] for name in self.names}
        return {**window, "walk": np.int64(walk), "first": np.int64(first)}


class Batches:
    """Windows in an order that the seed decides, another one each time over them, `size` of them stacked; the last may be fewer."""

    def __init__(self, windows, size, seed=0):
        self.windows, self.size, self.seed, self.epoch = windows, size, seed, 0

    def __iter__(self):
        order = np.random.default_rng([self.seed, self.epoch]).permutation(len(self.windows))
        self.epoch += 1
        for first in range(0, len(order), self.size):
            chosen = [self.windows[i] for i in order[first : first + self.size]]
            yield {name: np.stack([window[name] for window in chosen]) for name in chosen[0]}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder")
    parser.add_argument("--frames", type=int, default=60)
    parser.add_argument("--stride", type=int, default=30)
    parser.add_argument("--batch", type=int, default=16)
    parser.add_argument("--seed", type=int, default=0)
    asked = parser.parse_args()
    walks = Walks(asked.folder)
    windows = Windows(walks, asked.frames, asked.stride)
    print(f"{len(walks)} walks, {len(windows)} windows of {asked.frames} frames")
    for number, batch in enumerate(Batches(windows, asked.batch, asked.seed)):
        shapes = ", ".join(f"{name} {'x'.join(map(str, array.shape))}" for name, array in batch.items())
        print(f"batch {number}: {shapes}")


if __name__ == "__main__":
    main()
