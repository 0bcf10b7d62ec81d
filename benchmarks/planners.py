"""Planners on the same validator: ours, OMPL's trees, and the one for the body's bounding cylinder."""
import statistics

import run

PLANNERS = ("visibility", "prm", "rrt", "est", "sst", "rrtstar", "cylinder")
SCENARIOS = ("living-room", "apartment", "maze", "two-doors", "u-trap", "narrow-gap-070", "rubble", "stairs-up")


def median(values, form):
    return form.format(statistics.median(values)) if values else ""


def measure(scenarios, runs, seconds, tell):
    """Markdown, a row a scenario and planner: share solved, medians of time and of the walk's duration and length.

    Each run by a seed of its own. Time is roadmap or tree, query and refinement, of all runs; walks are the refined ones."""
    head = ("scenario", "planner", f"solved, of {runs}", "time [s]", "poses checked", "walk [s]", "walk [m]", "clearance [mm]")
    lines = [head, ("---",) * len(head)]
    for scenario in scenarios or SCENARIOS:
        for planner in PLANNERS:
            lines.append((scenario, planner, *figures(scenario, planner, runs, seconds)))
            tell(" | ".join(lines[-1]))
    about = "\n".join(f"- {line}" for line in run.machine())
    table = "\n".join("| " + " | ".join(line) + " |" for line in lines)
    return f"# Planners on the same validator\n\n{about}\n- a limit of {seconds:g} s a run, seeds 1 to {runs}, one thread\n\n{table}\n"


def figures(scenario, planner, runs, seconds):
    file = scenario if scenario.endswith(".yaml") else run.ROOT / "scenarios" / f"{scenario}.yaml"
    options = ("--planner", planner, "--time-limit", seconds)
    reports = [run.plan(file, *options, "--seed", seed) for seed in range(1, runs + 1)]
    solved = [report for report in reports if report["status"] == "solved"]
    times = [sum(report["times"][part] for part in ("roadmap", "search", "refine")) for report in reports]
    return (
        f"{len(solved)}",
        median(times, "{:.2f}"),
        median([report["poses_checked"] for report in reports], "{:.0f}"),
        median([report["duration"] for report in solved], "{:.1f}"),
        median([report["length"] for report in solved], "{:.1f}"),
        median([1e3 * report["clearance"]["min"] for report in solved], "{:.0f}"),
    )
