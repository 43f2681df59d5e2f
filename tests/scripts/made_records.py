"""Records made up for tests. Their numbers are drawn, nothing was measured."""

import itertools
import json
import random

METHODS = [
    "moller_trumbore", "kensler_shirley", "morozov", "shevtsov", "badouel", "wald", "keidy", "perpendicular_planes",
    "plucker", "half_spaces", "signed_areas", "angle_sum", "woop_watertight", "baldwin_weber", "havel_herout",
]  # fmt: skip
VARIANT = {
    "division": "early", "reciprocal": "exact", "order": "weights_first", "edges": "inclusive", "early_out": "yes",
    "output": "weights", "data": "bare",
}  # fmt: skip
FACTORS = ["division=late", "reciprocal=newton", "edges=strict", "data=precomputed", "rays=8", "triangles=8", "contraction=on"]
NO_ERROR = {"count": 0, "p50": None, "p99": None, "p999": None, "max": None, "mean": None}


def error(p99, count=100):
    return {"count": count, "p50": p99 / 3, "p99": p99, "p999": p99 * 2, "max": p99 * 4, "mean": p99 / 2}


def accuracy_record(**members):
    """A faultless cell of W1; `members` replaces what a test is about."""
    record = {
        "schema": 3, "kind": "accuracy", "experiment": "made-up", "cell": "", "launch": 0, "round": 0, "seed": 1, "valid": True,
        "reason": "", "method": "wald", "change": "base",
        "variant": VARIANT, "precision": "float", "case": "W1", "difficulty_of": "distance of the aim", "difficulty": 1.0,
        "level": 0, "rays": 1000, "mesh_rays": 1000, "trials": 4000, "hits": 1000, "boundary": 0, "false_hits": 0,
        "false_misses": 0, "nonfinite": 0, "missed_rays": 0, "extra": 0, "uncovered": 0, "other_nearest": 0, "t_error": error(1.5),
        "uv_error": error(1e-7), "weight_error": error(9.0), "consistency": error(2.0), "off_plane": error(1.0),
    }  # fmt: skip
    unknown = set(members) - set(record)
    assert not unknown, unknown
    return record | members


def kernel_record(**members):
    """A round of 5 ns a test; `members` replaces what a test is about."""
    record = {
        "schema": 3, "kind": "kernel", "experiment": "made-up", "cell": "", "launch": 0, "round": 0, "seed": 1, "valid": True,
        "reason": "", "kernel": "intersection", "method": "wald", "change": "base", "variant": VARIANT, "precision": "float",
        "rays_at_once": 1, "triangles_at_once": 1, "layout": "aos", "contraction": "off", "compiler": "gcc 12.2.0",
        "isa": "scalar", "bytes": 48, "protocol": "random", "parameter": None, "scene": "", "threads": 1, "scheduler": "shares", "hit_rate": 0.1,
        "tests": 1000, "iterations": 10, "seconds": [5e-5], "clock": "processor",
    }  # fmt: skip
    unknown = set(members) - set(record)
    assert not unknown, unknown
    return record | members


def seconds_of(ns):
    """Samples that give `ns` a test in `kernel_record`."""
    return [ns * 1e-5]


def accuracy_records(methods=tuple(METHODS), seed=1):
    """Cells of cases of two classes, some of them with failures."""
    draw = random.Random(seed)
    cases = [("W1", [256.0, 1.0, 0.0]), ("F1", [1.0, 1e4, 1e8])]
    for case, difficulties in cases:
        for precision in ("float", "double"):
            for method in methods:
                bad = draw.random() < 0.6
                for level, difficulty in enumerate(difficulties):
                    wrong = draw.randrange(1, 900) if bad and level else 0
                    mesh = {"missed_rays": wrong // 2, "extra": wrong // 3} if case[0] == "W" else {"mesh_rays": 0}
                    yield accuracy_record(
                        method=method, precision=precision, case=case, difficulty=difficulty, level=level,
                        false_misses=wrong, false_hits=wrong // 4, t_error=error(10 ** draw.uniform(0, 1 + level)), **mesh,
                    )  # fmt: skip


def kernel_records(methods=tuple(METHODS), rounds=8, seed=1):
    """Every protocol, both precisions, one factor at a time; each round with a drift of its own."""
    draw = random.Random(seed)
    workloads = [("random", None), ("worst-case", None), ("packet-common", None)]
    workloads += [("hit-rate", h / 10) for h in range(0, 11, 2)]
    drift = [draw.uniform(0.97, 1.05) for _ in range(rounds)]
    for method in methods:
        for precision in ("float", "double"):
            cost = draw.uniform(3, 30) * (1.3 if precision == "double" else 1)
            for change in ["base", *FACTORS]:
                factor, _, value = change.partition("=")
                wide = {"rays_at_once": int(value)} if factor == "rays" else {"triangles_at_once": int(value)} if factor == "triangles" else {}
                variant = VARIANT | {factor: value} if factor in VARIANT else VARIANT
                extra = {"contraction": "on"} if factor == "contraction" else {}
                share = 1.0 if change == "base" else draw.uniform(0.15, 0.4) if wide else draw.uniform(0.85, 1.2)
                for protocol, parameter in workloads:
                    if (protocol == "packet-common") != (factor == "rays"):
                        continue
                    harder = 1.6 if protocol == "worst-case" else 1 + (parameter or 0) * 0.5
                    for number in range(rounds):
                        ns = cost * share * harder * drift[number] * draw.uniform(0.99, 1.03)
                        yield kernel_record(
                            method=method, change=change, variant=variant, precision=precision, protocol=protocol,
                            parameter=parameter, round=number, hit_rate=parameter if parameter is not None else 0.1,
                            seconds=[ns * 1e-5 * draw.uniform(1, 1.01) for _ in range(3)], **wide, **extra,
                        )  # fmt: skip


def pixel_records(methods=tuple(METHODS[:6]), seed=1):
    draw = random.Random(seed)
    for scene, offset, precision, method in itertools.product(("chair", "ice"), (0.0, 1e3), ("float", "double"), methods):
        wrong = 0 if precision == "double" else draw.choice([0, 3, 40, 700])
        for number, core in itertools.product(range(7), ("scalar", "wide")):
            yield {
                "schema": 2, "kind": "pixels", "experiment": "made-up", "launch": 0, "round": number, "seed": 1, "valid": True,
                "reason": "", "method": method, "precision": precision, "scene": scene, "offset": offset, "core": core,
                "wrong_pixels": wrong, "hole_pixels": wrong // 2, "pixels": 65536, "flip_mean": wrong * 1e-6,
                "max_difference": min(wrong, 255), "rmse": wrong * 1e-5, "rays": 65536, "seconds": [draw.uniform(0.02, 0.06)],
                "pattern": "grid", "subpixels": 1, "reference_subpixels": 1, "edge_pixels": 900, "edge_rmse": wrong * 1e-4,
            }  # fmt: skip


def sampling_records(seed=1):
    """Few samples by two patterns in two scenes: the circle's errors are two thirds of the grid's."""
    of_rounding = next(pixel_records(seed=seed))
    for scene, pattern, samples in itertools.product(("chair", "ice"), ("grid", "circle"), (2, 4, 9, 16)):
        error = (0.3 if pattern == "grid" else 0.2) / samples
        yield of_rounding | {"scene": scene, "offset": 0.0, "pattern": pattern, "subpixels": samples, "reference_subpixels": 1024, "edge_rmse": error}


def atlas_records(methods=tuple(METHODS[:4]), seed=1):
    draw = random.Random(seed)
    x, y = [1.0, 1e-2, 1e-4, 1e-6], [1.0, 1e2, 1e4]
    for method in methods:
        misses = [[draw.randrange(0, 100) if i + j > 2 else 0 for i in range(len(x))] for j in range(len(y))]
        yield {
            "schema": 1, "kind": "atlas", "experiment": "made-up", "part": "grid", "map": "size-offset", "seed": 1,
            "method": method, "precision": "float", "x_of": "size / distance", "y_of": "offset / size", "x": x, "y": y,
            "hits": [[100] * len(x) for _ in y], "false_misses": misses,
        }  # fmt: skip
    points = [[10 ** draw.uniform(-3, 0), 10 ** draw.uniform(0, 2)] for _ in range(200)]
    yield {
        "schema": 1, "kind": "atlas", "experiment": "made-up", "part": "scene", "map": "size-offset", "scene": "chair",
        "triangles": 200, "x": [p[0] for p in points], "y": [p[1] for p in points],
    }  # fmt: skip


def write_run(folder, records):
    """A folder as a run leaves it, without plan and machine."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "records.jsonl").write_text("".join(json.dumps(r, sort_keys=True) + "\n" for r in records), encoding="utf-8")
    return folder
