"""Folders of runs made up for tests, as `raysweep report` leaves them. Their numbers are drawn, nothing was measured."""

import json
import pathlib
import random

ROUNDS = 7
MODES = ["low", "middle", "hard", "very_hard"]
MACHINE = {"host": "made-up", "cpu": "No processor", "cores": 6, "pus": 12}
PUBLISHED = pathlib.Path(__file__).resolve().parents[2] / "results/published"


def estimate(value, width=0.01):
    """A value whose interval is `width` to both sides."""
    return {"value": value, "low": value * (1 - width), "high": value * (1 + width), "count": ROUNDS}


def row(factors, quantity, value, draw, notes=(), **more):
    """A row of the quantity, with samples about its value; `more` are other quantities' values."""
    texts = {name: str(text) for name, text in factors.items()}
    samples = [[n, value * draw.uniform(0.98, 1.02)] for n in range(ROUNDS)]
    return {
        "cell": ",".join(f"{k}={v}" for k, v in texts.items()), "factors": texts, "samples": {quantity: samples}, "notes": list(notes),
        "values": {quantity: estimate(value)} | {name: estimate(v) for name, v in more.items()}, "oversubscribed": False,
    }  # fmt: skip


def report(experiment, kind, rows, **members):
    made = {
        "schema": 1, "experiment": experiment, "title": f"{experiment}, made up", "question": f"What does {experiment} show?", "kind": kind,
        "command": f"raysweep run experiments/configs/{experiment}.toml", "machine": MACHINE, "noise_floor": 0.012, "rows": rows,
        "claims": [], "published": None, "tables": [table()],
    }  # fmt: skip
    unknown = set(members) - set(made)
    assert not unknown, unknown
    return made | members


def table():
    return {
        "name": "scaling", "title": "made up", "caption": "made up\nsecond line", "rows": [["a & b", "1.5 [1.4, 1.6]"], ["<c>", "–"]],
        "columns": [{"title": "scheduler", "number": False}, {"title": "fps", "number": True}],
    }  # fmt: skip


def side(verdict, groups=(), sentence="Made up."):
    return {"verdict": verdict, "sentence": sentence, "groups": list(groups)}


def group(value, holds, low=None, high=None, of=None, problem=None):
    return {
        "group": of or {},
        "value": value,
        "low": low,
        "high": high,
        "expected_low": 1.2,
        "expected_high": 1.3,
        "holds": holds,
        "problem": problem,
    }


def claims():
    """One of each verdict."""
    return [
        {
            "id": "kept", "text": "hyper-threading brings a quarter", "source": "Made-up 2011, 5.3", "rule": "fps at 12 threads over that at 6 is 1.2 to 1.3", "why": None,
            "published": side("holds in the source", [group(1.25, True, 1.24, 1.26)]), "ours": side("reproduced", [group(1.25, True, 1.23, 1.27, {"mode": "low"}), group(1.24, True, 1.22, 1.26, {"mode": "hard"})]),
        },
        {
            "id": "broken", "text": "it peaks <at> the end", "source": "Made-up 2011, 6", "rule": "fps is largest at 24 threads", "why": "The processor has fewer & other cores.",
            "published": side("contradicted by its own table", [group(0.9, False)]), "ours": side("not reproduced", [group(0.8, False, 0.79, 0.81)]),
        },
        {
            "id": "open", "text": "it needs more processors", "source": "Made-up 2011, 7", "rule": "fps at 64 threads over that at 1 is at least 50", "why": None,
            "published": side("not in a table"), "ours": side("cannot be tested here", sentence="cores >= 64 is false: there are 6."),
        },
    ]  # fmt: skip


def published_of(name, quantity, x, rows, rename=None):
    """The printed file's cells beside rows of ours, by mode and `x`, each column divided by its first row."""
    lines = (PUBLISHED / name).read_text(encoding="utf-8").split()
    heads, cells, firsts, seen = lines[0].split(",")[1:], [], {}, set()
    ours = {(r["factors"]["mode"], r["factors"][x]): r["values"][quantity] for r in rows}
    for line in lines[1:]:
        at, *values = line.split(",")
        at = (rename or "{}").format(at)
        if at in seen:
            continue
        seen.add(at)
        for mode, text in zip(heads, values):
            found = ours.get((mode, at))
            first = firsts.setdefault(mode, (float(text), found))
            scaled = None
            if found and first[1]:
                scaled = {end: found[end] / first[1]["value"] for end in ("value", "low", "high")}
            cells.append(
                {
                    "factors": {x: at, "mode": mode},
                    "printed": text,
                    "printed_normalised": float(text) / first[0],
                    "ours": found,
                    "ours_normalised": scaled,
                }
            )
    return {
        "file": f"published/{name}",
        "quantity": quantity,
        "normalise": "first_row",
        "rows_are": [x],
        "machine": {"cores": 6, "pus": 12},
        "rows": cells,
    }


def threads_rows(draw, most=24):
    rows = [
        row({"mode": m, "scheduler": "serial", "runtime": "-", "threads": 1}, "fps", 8.0 / (i + 1), draw, speedup=1.0, quality=1.0)
        for i, m in enumerate(MODES)
    ]
    for i, mode in enumerate(MODES):
        for n in range(1, most + 1):
            speedup = min(n, 6) * (1.0 if n <= 6 else min(1.27, 1 + 0.045 * (n - 6))) * 0.97
            notes = ["oversubscribed"] if n > 12 else []
            rows.append(
                row(
                    {"mode": mode, "scheduler": "omp_static", "runtime": "libgomp", "threads": n},
                    "fps",
                    8.0 / (i + 1) * speedup,
                    draw,
                    notes,
                    speedup=speedup,
                    quality=0.93,
                )
            )
    return rows


def frames(rows, draw):
    """Records of pictures: a launch a round."""
    return [
        {"kind": "picture", "valid": True, "processes": 1, "cell": r["cell"], "round": n, "frame_seconds": [1 / fps * draw.uniform(1, 1.05) for _ in range(3)]}
        for r in rows for n, fps in r["samples"]["fps"]
    ]  # fmt: skip


def write(folder, made, records=(), files=None):
    """A run's folder; `files` are further ones, by their paths."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "report.json").write_text(json.dumps(made), encoding="utf-8")
    (folder / "machine.json").write_text(json.dumps(MACHINE | {"kernel": "Linux", "load": 0.1}), encoding="utf-8")
    if records:
        (folder / "records.jsonl").write_text("".join(json.dumps(r) + "\n" for r in records), encoding="utf-8")
    for name, text in (files or {}).items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    return folder


SCHEDULE = """mode,scheduler,runtime,threads,inflation,inflation_low,inflation_high,busy,in_scheduler,idle
low,omp_static,libgomp,1,0,0,0.01,1,0,0
low,omp_static,libgomp,12,0.4,0.35,0.45,0.8,0.05,0.15
"""
LAWS = """mode,scheduler,threads,amdahl_fps_of_one,amdahl_sigma
low,omp_static,1,7.8,0.01
"""


def trace():
    """Two workers' chunks in a frame, as `raysweep render --trace` writes them."""
    names = [{"ph": "M", "name": "thread_name", "pid": 0, "tid": t, "args": {"name": n}} for t, n in enumerate(("frames", "worker 0", "worker 1"))]
    frame = {"ph": "X", "pid": 0, "tid": 0, "name": "frame 0", "ts": 0, "dur": 900, "args": {}}
    chunks = [
        {"ph": "X", "pid": 0, "tid": t, "name": f"items {i} to {i}", "ts": 100 * i, "dur": 90, "args": {"first_item": i, "items": 1, "processor": t}}
        for t in (1, 2) for i in range(4 * t)
    ]  # fmt: skip
    return json.dumps({"traceEvents": [*names, frame, *chunks], "otherData": {"cell": "scene=made-up"}})


def threads_run(folder):
    draw = random.Random(1)
    rows = threads_rows(draw)
    printed = published_of("morozov2011_table3_openmp_fps.csv", "fps", "threads", rows)
    made = report("m11-t3", "picture", rows, claims=claims(), published=printed)
    return write(folder, made, frames(rows, draw), {"tables/schedule.csv": SCHEDULE, "tables/laws.csv": LAWS, "marbles.trace.json": trace()})


def sweep_run(folder, experiment, x, file, values, rename=None):
    """A factor of numbers swept in four modes beside the printed table."""
    draw = random.Random(2)
    rows = [
        row({"mode": m, "scheduler": "omp_static", x: v, "threads": 12}, "fps", 40 / (i + 1) / (1 + 0.1 * k), draw)
        for i, m in enumerate(MODES) for k, v in enumerate(values)
    ]  # fmt: skip
    return write(folder, report(experiment, "picture", rows, published=published_of(file, "fps", x, rows, rename)))


def chunks_run(folder):
    draw = random.Random(3)
    rows = [
        row({"scheduler": s, "runtime": "-", "chunk": c, "threads": 2}, "fps", 10 + i - abs(k - 2), draw)
        for i, s in enumerate(("thread_dynamic", "omp_dynamic", "omp_guided")) for k, c in enumerate(("1", "2", "8", "64", "512"))
    ]  # fmt: skip
    rows[-1] = without_intervals(rows[-1])
    return write(folder, report("chunks", "picture", rows))


METHODS = ["moller_trumbore", "kensler_shirley", "morozov", "wald", "plucker"]


def without_intervals(made):
    """As of fewer than six rounds."""
    for e in made["values"].values():
        e["low"] = e["high"] = None
    return made


def kernel_run(folder):
    draw = random.Random(4)
    rows = [
        row({"kernel": "intersection", "method": m, "change": "base", "precision": p, "protocol": "random"}, "nanoseconds", 4 * 2**i * (1.25 if p == "double" else 1), draw)
        for i, m in enumerate(METHODS) for p in ("float", "double")
    ]  # fmt: skip
    rows[-1] = without_intervals(rows[-1])
    return write(folder, report("speed", "kernel", rows))


def accuracy_run(folder):
    draw = random.Random(5)
    rows = []
    for i, method in enumerate(METHODS):
        for precision in ("float", "double"):
            for case in ("F1", "F2"):
                for k, difficulty in enumerate(("1", "100", "10000")):
                    made = row(
                        {"method": method, "change": "base", "precision": precision, "case": case, "difficulty": difficulty},
                        "t_error_p99",
                        1.5 * (i + 1) * 10**k,
                        draw,
                    )
                    made["samples"] = {}
                    made["values"]["t_error_p99"] |= {"low": None, "high": None}
                    rows.append(made)
    return write(folder, report("errors", "accuracy", rows))


def pixels_run(folder):
    draw = random.Random(6)
    rows = [
        row({"scene": "chair", "pattern": p, "subpixels": n}, "nanoseconds", 100 * n * n, draw, rmse=(0.02 if p == "grid" else 0.015) / n)
        for p in ("grid", "circle") for n in (1, 2, 3, 4)
    ]  # fmt: skip
    return write(folder, report("m11-aa", "pixels", rows))


def overhead_run(folder):
    """What scripts/record_overhead leaves: no report.json."""
    folder.mkdir(parents=True)
    sizes = [
        f"{s},,default,2,2000,{n},{n * 10},{n * 11},{n / (n + 4 * (i + 1))}"
        for i, s in enumerate(("thread_dynamic", "tbb_auto"))
        for n in (1, 4, 16, 64, 256)
    ]
    (folder / "task_sizes.csv").write_text(
        "\n".join(["scheduler,runtime,wait,threads,tasks,iterations,task_ns,run_ns,efficiency", *sizes]) + "\n", encoding="utf-8"
    )
    told = [
        "scheduler,runtime,wait,threads,metg95_ns,metg95_kind,notes",
        "thread_dynamic,,default,2,760,bracketed,",
        "tbb_auto,,default,2,1500,bracketed,drifted",
    ]
    (folder / "overhead.csv").write_text("\n".join(told) + "\n", encoding="utf-8")
    (folder / "machine.json").write_text(json.dumps(MACHINE), encoding="utf-8")
    return folder


def all_runs(folder):
    """One run of each kind, in the order of a page."""
    return [
        threads_run(folder / "m11-t3"), sweep_run(folder / "m11-t8", "m11-t8", "leaf", "morozov2011_table8_bvh_leaf_fps.csv", [4, 8, 16, 64, 256, 1024, 4096, 16384]),
        sweep_run(folder / "m11-t9", "m11-t9", "chunk", "morozov2011_table9_chunks_per_thread_fps.csv", [f"{n}/thread" for n in (1, 2, 3, 6, 12)], "{}/thread"),
        chunks_run(folder / "chunks"), kernel_run(folder / "speed"), accuracy_run(folder / "errors"), pixels_run(folder / "m11-aa"), overhead_run(folder / "overhead"),
    ]  # fmt: skip
