"""Furnished rooms drawn by a seed, as scenes to walk through: two rooms with doors between them, tables, chairs and other
furniture, and a platform with stairs.

    draw_rooms.py DIR [--rooms N] [--walks N] [--seed N]

Writes DIR/room-01.yaml, room-02.yaml, ..., and DIR/job.yaml, which asks for so many walks in them. The furniture's meshes are those of environments/scenes/living-room, beside
which this lies in a clone of Amble. The same seed gives the same files.
"""
import argparse
import os
import pathlib
import random

MESHES = pathlib.Path(__file__).resolve().parents[2] / "environments" / "scenes" / "living-room" / "meshes"
HEIGHT, WALL = 2.5, 0.12  # of walls, and how thick they are [m]
RISER, GOING, RISERS = 0.17, 0.30, 3  # of stairs [m]
# Breadth and depth of what stands along walls, and of what stands in the room [m].
ALONG = {"sofa": (2.15, 0.92), "bookshelf": (1.2, 0.3), "armchair": (0.86, 0.86), "plant": (0.5, 0.5), "lamp": (0.42, 0.42)}
INSIDE = {"dining-table": (1.5, 0.85), "low-table": (0.6, 0.9), "piano-stool": (0.44, 0.34)}
CHAIR = (0.44, 0.48)


class Room:
    """Things of a scene, and the rectangles that they stand on."""

    def __init__(self, drawn):
        self.drawn, self.lines, self.taken, self.count = drawn, [], [], {}

    def name(self, kind):
        self.count[kind] = self.count.get(kind, 0) + 1
        return f"{kind}-{self.count[kind]}"

    def box(self, kind, low, high):
        at = [(a + b) / 2 for a, b in zip(low, high)]
        size = [b - a for a, b in zip(low, high)]
        self.lines.append(f"  - {{name: {self.name(kind)}, box: {{size: {row(size)}}}, at: {row(at)}}}")

    def mesh(self, kind, at, turn):
        self.lines.append(f"  - {{name: {self.name(kind)}, mesh: {kind}.obj, up: y, at: {row((*at, 0))}, turn: {turn}}}")

    def place(self, kind, size, at, turn):
        """True where it stands: free of all before."""
        wide, deep = size if turn % 180 == 0 else size[::-1]
        rectangle = (at[0] - wide / 2, at[1] - deep / 2, at[0] + wide / 2, at[1] + deep / 2)
        if any(overlap(rectangle, other) for other in self.taken):
            return False
        self.taken.append(rectangle)
        self.mesh(kind, at, turn)
        return True


def row(numbers):
    return "[" + ", ".join(f"{number:.3f}" for number in numbers) + "]"


def overlap(a, b):
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]


def draw(drawn):
    """The lines of a scene."""
    room = Room(drawn)
    length, depth = drawn.uniform(9.5, 12), drawn.uniform(6, 7.5)
    room.box("floor", (-WALL, -WALL, -0.1), (length + WALL, depth + WALL, 0))
    room.box("wall", (-WALL, -WALL, 0), (0, depth + WALL, HEIGHT))
    room.box("wall", (length, -WALL, 0), (length + WALL, depth + WALL, HEIGHT))
    room.box("wall", (0, -WALL, 0), (length, 0, HEIGHT))
    room.box("wall", (0, depth, 0), (length, depth + WALL, HEIGHT))
    add_divider(room, drawn.uniform(0.42, 0.58) * length, depth)
    add_platform(room, length, depth)
    for _ in range(drawn.randint(5, 8)):
        add_along(room, length, depth)
    for _ in range(drawn.randint(2, 4)):
        add_inside(room, length, depth)
    return room.lines


def add_divider(room, x, depth):
    """A wall across, with one door or two; nothing stands before them."""
    doors = sorted(room.drawn.sample((0.22, 0.5, 0.78), room.drawn.randint(1, 2)))
    low = 0.0
    for door in doors:
        wide, middle = room.drawn.uniform(0.9, 1.1), door * depth
        room.box("divider", (x - WALL / 2, low, 0), (x + WALL / 2, middle - wide / 2, HEIGHT))
        room.box("lintel", (x - WALL / 2, middle - wide / 2, 2.1), (x + WALL / 2, middle + wide / 2, HEIGHT))
        room.taken.append((x - 1.1, middle - wide, x + 1.1, middle + wide))
        low = middle + wide / 2
    room.box("divider", (x - WALL / 2, low, 0), (x + WALL / 2, depth, HEIGHT))
    room.taken.append((x - WALL / 2, 0, x + WALL / 2, depth))


def add_platform(room, length, depth):
    """In the corner at the far end, with stairs up to it."""
    wide, deep = room.drawn.uniform(1.6, 2.2), room.drawn.uniform(2.2, 3)
    x = length - wide
    room.box("platform", (x, depth - deep, 0), (length, depth, RISER * RISERS))
    for step in range(1, RISERS):
        front = x - GOING * (RISERS - step)
        room.box("stair", (front, depth - 1.6, 0), (front + GOING, depth - 0.2, RISER * step))
    room.taken.append((x - GOING * RISERS - 1.2, depth - deep - 0.2, length, depth))


def add_along(room, length, depth):
    for _ in range(20):
        kind = room.drawn.choice(sorted(ALONG))
        wide, deep = ALONG[kind]
        turn = room.drawn.choice((0, 90, 180, 270))
        gap = deep / 2 + 0.04
        along = room.drawn.uniform(wide / 2, (length if turn % 180 == 0 else depth) - wide / 2)
        at = {0: (along, depth - gap), 90: (gap, along), 180: (along, gap), 270: (length - gap, along)}[turn]
        if room.place(kind, (wide, deep), at, turn):
            return


def add_inside(room, length, depth):
    for _ in range(20):
        kind, turn = room.drawn.choice(sorted(INSIDE)), room.drawn.choice((0, 90))
        at = (room.drawn.uniform(1.6, length - 1.6), room.drawn.uniform(1.6, depth - 1.6))
        if not room.place(kind, INSIDE[kind], at, turn):
            continue
        if kind == "dining-table":
            add_chairs(room, at, turn)
        return


def add_chairs(room, at, turn):
    """Two to four around a table, that look at it."""
    for side in room.drawn.sample((-1, 1, -2, 2), room.drawn.randint(2, 4)):
        across, along = 0.72 if side > 0 else -0.72, 0.36 if abs(side) == 1 else -0.36
        dx, dy = (along, across) if turn == 0 else (across, along)
        face = (0 if across > 0 else 180) if turn == 0 else (270 if across > 0 else 90)
        room.place("chair", CHAIR, (at[0] + dx, at[1] + dy), face)


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("folder", metavar="DIR", type=pathlib.Path)
    options.add_argument("--rooms", type=int, default=10)
    options.add_argument("--walks", type=int, default=100)
    options.add_argument("--seed", type=int, default=1)
    options = options.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    meshes = os.path.relpath(MESHES, options.folder.resolve())
    for number in range(1, options.rooms + 1):
        lines = draw(random.Random(f"{options.seed} {number}"))
        lines = [line.replace("mesh: ", f"mesh: {meshes}/") for line in lines]
        text = "\n".join([f"name: room-{number:02}", "objects:", *lines]) + "\n"
        (options.folder / f"room-{number:02}.yaml").write_text(text, encoding="utf-8")
    job = pathlib.Path(__file__).with_name("rooms.yaml").read_text(encoding="utf-8")
    (options.folder / "job.yaml").write_text(job.replace("sample: 100", f"sample: {options.walks}"), encoding="utf-8")


if __name__ == "__main__":
    main()
