"""What varies among the rows of an experiment, and how few names tell them apart."""

import re

# From the outermost, which would be a chart of its own, to the innermost, which would be a line. Others stand between.
FIRST = ["kernel", "protocol", "case", "scene", "mode", "core"]
LAST = ["method", "change", "scheduler", "runtime", "item", "chunk", "threads"]
# What follows from others as a rule: names that are the first to go where rows differ without them.
FOLLOWS = ["environment", "spin_count", "wait_policy", "isa", "pin", "bytes", "height", "layout", "compiler", "order"]
UNITS = {
    "fps": "frames a second", "nanoseconds": "nanoseconds", "frame_seconds": "seconds a frame", "build_seconds": "seconds to build",
    "chunk": "chunks", "leaf": "primitives a leaf", "depth": "depth of rays", "rmse": "error (RMSE)", "flip_mean": "error (FLIP)",
    "t_error_p99": "p99 error of t (ε)", "t_error_p50": "median error of t (ε)", "wrong_pixels": "wrong pixels", "ticks": "ticks of the clock",
}  # fmt: skip
PER_THREAD = re.compile(r"([\d.]+)/thread")


def number_of(text):
    """What a value counts: "8" or "8/thread" is 8; None where it is no number."""
    match = PER_THREAD.fullmatch(text)
    try:
        return float(match[1] if match else text)
    except ValueError:
        return None


def in_order(values):
    """Each value once: by number where all are numbers, else as they first stand."""
    found = list(dict.fromkeys(values))
    numbers = [number_of(v) for v in found]
    return found if None in numbers else [v for _, v in sorted(zip(numbers, found))]


def varying(rows):
    """{name: values} of the factors with more than one value, from outermost to innermost."""
    names = dict.fromkeys(name for row in rows for name in row["factors"])
    found = {name: in_order(row["factors"].get(name, "-") for row in rows) for name in names}

    def place(name):
        return (0, FIRST.index(name)) if name in FIRST else (2, LAST.index(name)) if name in LAST else (1, 0)

    return {name: found[name] for name in sorted(found, key=place) if len(found[name]) > 1}


def telling(rows, apart=()):
    """The fewest factors, by dropping what follows from others first, that tell rows apart together with those in `apart`."""
    kept = [name for name in varying(rows) if name not in apart]
    plain = [name for name in reversed(kept) if name not in FIRST + LAST + FOLLOWS]
    for name in [n for n in FOLLOWS + plain + ["runtime", "chunk", "item", "change"] if n in kept]:
        rest = [n for n in kept if n != name]
        seen = {tuple(row["factors"].get(n) for n in [*rest, *apart]) for row in rows}
        if len(seen) == len({tuple(row["factors"].get(n) for n in [*kept, *apart]) for row in rows}):
            kept = rest
    return kept


def label(factors, names):
    """Values that tell a row: words by themselves, numbers with their names; "-" is left out."""
    texts = []
    for name in names:
        text = factors.get(name, "-")
        if text in ("-", ""):
            continue
        texts.append(f"{name.replace('_', ' ')} {text}" if number_of(text) is not None else text)
    return ", ".join(texts)


def unit_of(name, rows):
    """A name for an axis of a factor, whose values say whether they are a thread's."""
    each = any(PER_THREAD.fullmatch(row["factors"].get(name, "-")) for row in rows)
    return f"{unit(name)} a thread" if each else unit(name)


def unit(name):
    """A name for an axis."""
    return UNITS.get(name, name.replace("_", " "))
