"""The table of what is measured, beside its peers and the bars of the project."""
import pathlib
import shutil
import statistics
import tempfile

import run
from draw_hall import draw

SCENES = ("living-room", "apartment", "maze", "rubble", "stairs-up", "rolling-terrain")  # of collision_benchmark
STOREYS = ("two-storeys", "stairs-up", "stairs-down", "stairs-or-ramp", "stairs-or-ramp-blocked")
SEEDS = 20
LIVING_ROOM = run.ROOT / "scenarios" / "living-room.yaml"

NOT_CLAIMED = """\
- Figures of other machines, of scenes above a million triangles, of more than two threads.
- That FCL, OMPL, Recast, Assimp or Eigen could not be used faster: each is set up as its manual has it, and compiled as Debian
  does or, what is headers of FCL and Eigen, with -O3.
- FCL is asked at frames only, and of what has ground not about soles; ours also proves what lies between frames. Both are
  given the same walks, which touch nothing: where things are touched both end sooner.
- Recast answers another question: where a cylinder's axis may be. It says nothing of a body that turns, steps over, or swings
  its arms, and proves no walk; where a cylinder is enough it is the better tool.
- Times of OMPL's planners are those of our steering, which they ask for every edge."""


def si(value):
    if value >= 1e6:
        return f"{value / 1e6:.3g} million"
    return f"{float(f'{value:.3g}'):,.0f}" if value >= 100 else f"{value:.3g}"


def rate(value):
    return f"{si(value)}/s"


def duration(value):
    for size, unit in ((1.0, "s"), (1e-3, "ms"), (1e-6, "us")):
        if value >= size:
            return f"{value / size:.3g} {unit}"
    return f"{value / 1e-9:.3g} ns"


class Table:
    """Rows of measure, ours, peer, ratio, bar."""

    def __init__(self, tell):
        self.rows, self.tell = [], tell

    def add(self, measure, ours, peer="", ratio="", bar="", held=None):
        if held is not None:
            bar += ": held" if held else ": missed"
        row = (measure, ours, peer, ratio, bar)
        self.rows.append(row)
        self.tell(" | ".join(cell for cell in row if cell))

    def compare(self, measure, ours, peer, peer_name, least=None, show=rate):
        """Rates, or times where `show` is duration; how many times better ours is."""
        ratio = ours / peer if show is rate else peer / ours
        bar, held = (f"{least}x", ratio >= least) if least else ("", None)
        self.add(measure, show(ours), f"{show(peer)} {peer_name}", f"{ratio:.3g}", bar, held)

    def within(self, measure, ours, most, show=duration):
        self.add(measure, show(ours), bar=f"{show(most)}", held=ours <= most)

    def markdown(self):
        head = ("measure", "ours", "peer", "times", "at least, or at most")
        lines = ["| " + " | ".join(row) + " |" for row in (head, ("---",) * len(head), *self.rows)]
        about = "\n".join(f"- {line}" for line in run.machine())
        return f"# What scripts/bench measured\n\n{about}\n\n" + "\n".join(lines) + f"\n\nNot claimed:\n\n{NOT_CLAIMED}\n"


def collision(table):
    found = run.rows("collision", SCENES)
    ours = {scene: found[f"synthesisAndCheck/{scene}"]["poses/s"] for scene in SCENES}
    alone = {scene: found[f"wholeBodyCheck/{scene}"]["poses/s"] for scene in SCENES}
    for scene in SCENES:
        for boxes, least in (("OBBRSSd", 20), ("OBBd", None), ("OBBf", 8)):
            peer = found[f"fclManager<{boxes}>/{scene}"]["poses/s"]
            name = f"FCL's manager, {boxes}"
            table.compare(f"poses made and checked, {scene}", ours[scene], peer, name, least)
            table.compare(f"poses checked, {scene}", alone[scene], peer, name)
        merged = found[f"fclMerged<OBBRSSd>/{scene}"]["poses/s"]
        table.compare(f"poses made and checked, {scene}", ours[scene], merged, "FCL, one tree")
    first = SCENES[0]
    for measure, row in (("a capsule near things: touches", "touchACapsule"), ("how far it is", "distanceOfACapsule")):
        values = [found[f"{name}/{first}"]["items_per_second"] for name in (row, row + "ByFcl")]
        table.compare(measure, *values, "FCL")
    trees = [run.seconds(found[f"{name}/{first}"]) for name in ("makeObstacles", "makeObstaclesByFcl")]
    table.compare(f"trees of the {first}", *trees, "FCL", show=duration)


def decisions(table):
    found = run.rows("decisions", repetitions=1)
    wrong, bodies, near = (int(sum(row[key] for row in found.values())) for key in ("wrong", "bodies", "near"))
    peer = "distances by brute force"
    measure = f"wrong decisions of {bodies:,}, {near:,} within 1 mm to 1e-6 m of a contact"
    table.add(measure, str(wrong), peer, bar="0", held=wrong == 0)


def synthesis(table):
    found = run.rows("synthesis")
    ours, peer = (found[row]["items_per_second"] for row in ("synthesizeWalk", "synthesizeWithPlainEigen"))
    table.compare("poses of a walk made", ours, peer, "plain Eigen -O3, without steps and footholds", 15)


def engine(table):
    found = run.rows("engine")
    cycle, pose = (found[row]["cpu_time"] * 1e-9 for row in ("engineCycle", "enginePose"))
    table.within("a cycle of the speed engine at another speed (Glardon 2004: 0.8 ms)", cycle, 50e-6)
    table.add("a pose of the speed engine at any speed and phase", duration(pose))


def bvh(table):
    found = run.rows("bvh")
    for measure, row, peer, name, least in (
        ("BVH read, bytes", "readBvh", "readBvhWithAssimp", "Assimp", 5),
        ("BVH written, bytes", "writeBvh", "writeBvhWithSnprintf", "snprintf", 8),
    ):
        values = [found[each]["bytes_per_second"] if each in found else None for each in (row, peer)]
        if values[1]:
            table.compare(measure, *values, name, least)
        else:
            table.add(measure, rate(values[0]))


def ground(table):
    found = run.rows("ground")
    ours, peer = (run.seconds(found[row]) for row in ("heightAndNormal", "heightByFcl"))
    table.compare("height and normal of the ground, a million triangles", ours, peer, "FCL, a rod let down", show=duration)
    table.add("place for a foot there", duration(run.seconds(found["footPlacement"])))


def plants(table):
    found = run.rows("plants")
    ours, peer = (found[row]["items_per_second"] for row in ("detectPlants", "fixedThresholds"))
    table.compare("foot plants of a clip, frames", ours, peer, "two fixed thresholds")


def navmesh(table):
    with tempfile.TemporaryDirectory() as folder:
        hall = draw(pathlib.Path(folder) / "boxes")
        mesh = draw(pathlib.Path(folder) / "mesh", triangles=1_000_000)
        mesh = mesh.rename(mesh.with_name("hall-mesh.yaml"))
        scenes = ["living-room", "apartment", str(hall), str(mesh)]
        only = "^(recast|detour|loading|mapAndWay|proof|plan)"
        found = run.rows("navmesh", scenes, repetitions=3, only=only)
    for scene in ("living-room", "apartment", "hall", "hall-mesh"):

        def cost(row, clock="cpu_time"):
            return run.seconds(found[f"{row}/{scene}"], clock)

        def told(row):
            return found[f"{row}/{scene}"].get("label", "")

        recast, fine = cost("recastBuild"), cost("recastBuildFine")
        query = f"Recast {duration(recast)}, with our cells {duration(fine)}; then Detour {duration(cost('detourQuery'))}"
        table.add(f"{scene}: loaded", duration(cost("loading", "real_time")))
        way = f"{duration(cost('mapAndWay'))} ({told('mapAndWay')})"
        table.add(f"{scene}: map and first way", way, f"{query} ({told('detourQuery')})", f"{fine / cost('mapAndWay'):.2g}")
        proof = f"{duration(cost('proof'))} ({told('proof')})"
        table.add(f"{scene}: whether there is a proof of no walk", proof)
        cylinder = f"{duration(cost('planOfCylinder'))} for the bounding cylinder ({told('planOfCylinder')})"
        table.add(f"{scene}: planned, once loaded", f"{duration(cost('plan'))} ({told('plan')})", cylinder)


def halls(table):
    with tempfile.TemporaryDirectory() as folder:
        for name, triangles, most, gigabytes in (("700 boxes", 0, 3.0, 1), ("a mesh of 1.04 million triangles", 1_000_000, 6.0, 2)):
            scenario = draw(pathlib.Path(folder) / str(triangles), triangles=triangles)
            report = run.plans(scenario, 3)
            measure = f"hall, 100 rooms, {name}, corner to corner, whole process ({report['status']})"
            table.within(measure, report["wall"], most)
            table.within("its memory", report["memory"] / 1e9, gigabytes, lambda value: f"{value:.2g} GB")


def plan(table):
    whole = run.plans(LIVING_ROOM, 5)
    table.within("living-room, whole process", whole["wall"], 0.4)
    rows = run.rows("plan", repetitions=3, only="^(planScenario|newEnds)/")
    warm, cold = rows["newEnds/warm"], rows["newEnds/cold"]
    table.within("a kept roadmap of the living-room, new start and goal: the walk", warm["search_median_s"], 0.005)
    values = run.seconds(warm), run.seconds(cold)
    table.compare("with its refinement", *values, "without a kept roadmap", show=duration)
    found = {row.split("/")[1]: entry for row, entry in rows.items() if row.startswith("planScenario/")}

    def planning(name):
        return sum(found[name][part] for part in ("roadmap_s", "query_s", "refine_s"))

    table.within("living-room cold: map, roadmap, query, refinement", planning("living-room"), 0.1)
    plain = [name for name in found if name not in STOREYS]
    for measure, names, most in (
        ("the slowest other scenario", [name for name in plain if found[name].get("label") != "no_walk"], 1.0),
        ("the slowest of stairs and storeys", [name for name in STOREYS if name in found], 2.0),
        ("the slowest without a walk", [name for name in plain if found[name].get("label") == "no_walk"], 0.5),
    ):
        slowest = max(names, key=planning)
        table.within(f"{measure}: {slowest}", planning(slowest), most)
    table.add(f"all {len(found)} scenarios, planning", duration(sum(map(planning, found))))


def clearance(table):
    least = [run.plan(LIVING_ROOM, "--seed", seed)["clearance"]["min"] for seed in range(1, SEEDS + 1)]
    for name, value, bar in (("least", min(least), 0.015), ("median", statistics.median(least), 0.040)):
        measure = f"clearance of the living room's walks over {SEEDS} seeds, {name}"
        table.add(measure, f"{1e3 * value:.0f} mm", bar=f"{1e3 * bar:.0f} mm", held=value >= bar)


def formats(table):
    stairs = run.ROOT / "scenarios" / "stairs-up.yaml"

    def writing(names):
        """The report of the run, of three, that wrote quickest."""
        return min((run.plan(stairs, formats=names) for _ in range(3)), key=lambda report: report["times"]["export"])

    each = ("bvh", "svg", "png", "html", "report", "views", "strip", "glb", "csv", "npz", "sdf")
    for name in each:
        table.add(f"writing {name} of a walk up stairs", duration(writing(f"json,{name}")["times"]["export"]))
    report = writing(",".join(("json", *each)))
    table.within(f"writing all of these of its {report['duration']:.0f} s", report["times"]["export"], 1.0)
    if shutil.which("ffmpeg"):
        film = writing("json,mp4")
        table.add("writing mp4, a second of the walk", duration(film["times"]["export"] / film["duration"]))


# By name, in the table's order, with the programs that each needs.
PARTS = {
    "collision": (collision, ["collision_benchmark"]),
    "decisions": (decisions, ["decisions_benchmark"]),
    "synthesis": (synthesis, ["synthesis_benchmark"]),
    "engine": (engine, ["engine_benchmark"]),
    "bvh": (bvh, ["bvh_benchmark"]),
    "ground": (ground, ["ground_benchmark"]),
    "plants": (plants, ["plants_benchmark"]),
    "plan": (plan, ["plan_benchmark", "amble_app"]),
    "halls": (halls, ["amble_app"]),
    "clearance": (clearance, ["amble_app"]),
    "formats": (formats, ["amble_app"]),
    "navmesh": (navmesh, ["navmesh_benchmark"]),
}
