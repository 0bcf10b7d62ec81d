"""A hall of rooms with doors and furniture, drawn by a seed: a scene and a scenario from corner to corner.

    draw_hall.py DIR [--columns N] [--rows N] [--objects N] [--seed N] [--triangles N]

Rooms are 10 by 6 m, walls 0.12 m thick and 2.6 m high, doors 0.9 m wide; the doors are those of a random tree of
rooms and a fifth of the others. Furniture stands anywhere in a room but within 1.6 m of its walls, none in the rooms
of start and goal. With --triangles all is one mesh of about so many, each face cut into squares.
"""
import argparse
import pathlib
import random

ROOM = (10.0, 6.0)  # [m]
WALL, HEIGHT, DOOR = 0.12, 2.6, 0.9  # [m]


def draw(folder, columns=10, rows=10, objects=700, seed=1, triangles=0):
    """Writes scene.yaml (with hall.obj) and hall.yaml into the folder; returns the latter's path."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    boxes = hall(columns, rows, objects, random.Random(seed))
    lines = ["name: hall", "objects:"]
    if triangles:
        write_mesh(folder / "hall.obj", boxes, triangles)
        lines.append("  - {name: hall, mesh: hall.obj, up: z}")
    else:
        for name, at, size in boxes:
            place, lengths = (", ".join(f"{v:.3f}" for v in vector) for vector in (at, size))
            lines.append(f"  - {{name: {name}, box: {{size: [{lengths}]}}, at: [{place}]}}")
    (folder / "scene.yaml").write_text("\n".join(lines) + "\n")
    goal = ", ".join(f"{count * length - 2:g}" for count, length in zip((columns, rows), ROOM))
    scenario = folder / "hall.yaml"
    scenario.write_text(f"scene: scene.yaml\nstart: {{at: [2, 2]}}\ngoal: {{at: [{goal}]}}\nplanner: {{time_limit: 600}}\n")
    return scenario


def hall(columns, rows, objects, drawn):
    """Boxes: name, middle, lengths."""
    width, depth = columns * ROOM[0], rows * ROOM[1]
    boxes = []

    def box(name, x, y, length, breadth, height, low=0.0):
        boxes.append((name, (x, y, low + height / 2), (length, breadth, height)))

    box("floor", width / 2, depth / 2, width + 0.4, depth + 0.4, 0.1, -0.1)
    for name, x in (("west", -0.1), ("east", width + 0.1)):
        box(name, x, depth / 2, 0.2, depth + 0.4, HEIGHT)
    for name, y in (("south", -0.1), ("north", depth + 0.1)):
        box(name, width / 2, y, width, 0.2, HEIGHT)
    for number, (wall, has_door) in enumerate(walls(columns, rows, drawn), 1):
        add_wall(box, f"wall-{number}", wall, has_door, drawn)
    ends = {(0, 0), (columns - 1, rows - 1)}
    rooms = [(i, j) for i in range(columns) for j in range(rows) if (i, j) not in ends]
    number = 0
    while rooms and len(boxes) < objects:
        i, j = drawn.choice(rooms)
        x, y = ROOM[0] * i + drawn.uniform(2, 8), ROOM[1] * j + drawn.uniform(1.6, 4.4)
        number += 1
        box(f"thing-{number}", x, y, drawn.uniform(0.3, 1.4), drawn.uniform(0.3, 1.4), drawn.choice((0.45, 0.75, 0.9, 1.8)))
    return boxes


def walls(columns, rows, drawn):
    """Between neighbours, in drawn order, and whether there is a door: Kruskal's tree and some more."""
    parent = {(i, j): (i, j) for i in range(columns) for j in range(rows)}

    def root(room):
        while parent[room] != room:
            room = parent[room]
        return room

    between = [((i, j), (i + 1, j)) for i in range(columns - 1) for j in range(rows)]
    between += [((i, j), (i, j + 1)) for i in range(columns) for j in range(rows - 1)]
    drawn.shuffle(between)
    for a, b in between:
        joins = root(a) != root(b)
        parent[root(a)] = root(b)
        yield (a, b), joins or drawn.random() < 0.2


def add_wall(box, name, wall, has_door, drawn):
    (i, j), (i2, j2) = wall
    along = 1 if i2 > i else 0  # the axis
    across = ROOM[1 - along] * (i2 if along else j2)
    low = ROOM[along] * (j if along else i)
    high = low + ROOM[along]
    spans = [(name, low, high)]
    if has_door:
        door = drawn.uniform(low + 1.2, high - 1.2)
        spans = [(name + "a", low, door - DOOR / 2), (name + "b", door + DOOR / 2, high)]
    for part, begin, end in spans:
        middle, length = (begin + end) / 2, end - begin
        if along:
            box(part, across, middle, WALL, length, HEIGHT)
        else:
            box(part, middle, across, length, WALL, HEIGHT)


def write_mesh(file, boxes, triangles):
    """An object a box, its faces cut into squares that fit together."""
    floor = 4  # times as fine
    cuts = 1
    while 12 * cuts * cuts * (len(boxes) - 1 + floor * floor) < triangles:
        cuts += 1
    with open(file, "w") as out:
        first = 1
        for name, at, size in boxes:
            first += write_box(out, name, at, size, cuts * (floor if name == "floor" else 1), first)


def write_box(out, name, at, size, cuts, first):
    """Corners with an index 0 or `cuts` along some axis; returns how many."""
    numbers = {}
    faces = []

    def corner(index):
        if index not in numbers:
            numbers[index] = first + len(numbers)
            out.write("v %.4f %.4f %.4f\n" % tuple(m + s * (k / cuts - 0.5) for m, s, k in zip(at, size, index)))
        return numbers[index]

    out.write(f"o {name}\n")
    for axis in range(3):
        for side in (0, cuts):
            for a in range(cuts):
                for b in range(cuts):
                    square = []
                    for da, db in ((0, 0), (1, 0), (1, 1), (0, 1)) if side else ((0, 0), (0, 1), (1, 1), (1, 0)):
                        index = [0, 0, 0]
                        index[axis], index[(axis + 1) % 3], index[(axis + 2) % 3] = side, a + da, b + db
                        square.append(corner(tuple(index)))
                    faces.append("f %d %d %d\nf %d %d %d\n" % (*square[:3], square[0], *square[2:]))
    out.writelines(faces)
    return len(numbers)


if __name__ == "__main__":
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("folder", metavar="DIR")
    for option, usual in (("columns", 10), ("rows", 10), ("objects", 700), ("seed", 1), ("triangles", 0)):
        options.add_argument("--" + option, type=int, default=usual, metavar="N")
    print(draw(**vars(options.parse_args())))
