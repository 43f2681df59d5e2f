"""fps, speedup and efficiency against threads: with what bounds them, and where cores and hardware threads end."""

from report_page.chart import Chart, estimate_text, few_enough, point_of, samples_sentence
from report_page.factors import number_of
from report_page.layout import layout_of, longest_line
from report_page.panel import Border, Bound, Panel, Point, round_values, spread
from report_page.spec import panels_spec
from study_charts.numbers import short

BASES = {"speedup": "speedup (serial = 1)", "speedup_one": "speedup (its own 1 thread = 1)"}


def borders_of(cores, pus, most):
    """Where threads begin to share a core, and where they begin to share a hardware thread, as far as there are so many."""
    found = [Border(cores + 0.5, "hyper-threads")] if pus > cores else []
    found.append(Border(pus + 0.5, "oversubscribed"))
    return [border for border in found if border.x < most]


def speedup_bounds(cores, counts):
    dense = sorted({*counts, float(cores)} if counts[0] < cores < counts[-1] else set(counts))
    return [Bound("linear", [(n, n) for n in dense]), Bound(f"{cores} physical cores", [(n, min(n, cores)) for n in dense])]


def threads_of(row):
    return number_of(row["factors"]["threads"])


def ceilings(run, rows, counts):
    """What independent serial processes reach together, where `raysweep report` has one value a thread count."""
    cells = {tuple(sorted((k, v) for k, v in r["factors"].items() if k in ("scene", "mode", "core"))) for r in rows}
    if len(cells) != 1:
        return []
    where = dict(next(iter(cells)))
    found = {}
    for line in run.table("scaling"):
        if line.get("ceiling") and all(line.get(k) == v for k, v in where.items()) and float(line["threads"]) <= run.pus:
            found.setdefault(float(line["threads"]), set()).add(line["ceiling"])
    points = [(n, float(min(values))) for n, values in sorted(found.items()) if len(values) == 1 and n in counts]
    return [Bound("as many serial processes", [(1.0, 1.0), *points])] if points else []


def amdahl(run, rows, counts):
    """Amdahl's law as tables/laws.csv fitted it, as fps; of one series alone, for more would not be read."""
    fits = set()
    for line in run.table("laws"):
        if line.get("amdahl_sigma") and all(line.get(k) in (None, rows[0]["factors"].get(k)) for k in ("scene", "mode", "scheduler")):
            fits.add((float(line["amdahl_fps_of_one"]), float(line["amdahl_sigma"])))
    if len(fits) != 1 or len({r["factors"].get("scheduler") for r in rows}) > 1:
        return []
    one, sigma = fits.pop()
    return [Bound("Amdahl, fitted up to the cores", [(n, one * n / (1 + sigma * (n - 1))) for n in counts])]


def tile_bounds(rows, base, layout):
    """The speedup that the longest item, or all items shared evenly, would leave: speedup / quality."""
    found = []
    for row in rows:
        speedup, quality = row["values"].get(base), row["values"].get("quality")
        if speedup and quality and quality["value"]:
            bound, series = speedup["value"] / quality["value"], layout.series_of(row)
            found.append(Point(series, threads_of(row), bound, tip=[[series, ""], ["bound by the items' costs", short(bound, 4)]]))
    return found


def efficiency_point(row, base, layout):
    """Speedup / threads, ends alike."""
    point = point_of(row, base, threads_of(row), layout.series_of(row), names=("threads",))
    if point is None:
        return None
    n = point.x
    ends = [None if end is None else end / n for end in (point.low, point.high)]
    estimate = {"value": point.y / n, "low": ends[0], "high": ends[1]}
    samples = [(number, value / n) for number, value in point.samples]
    return Point(point.series, n, point.y / n, *ends, [[point.series, ""], ["threads", f"{n:g}"], ["efficiency", estimate_text(estimate)]], samples)


def existing(points):
    return [p for p in points if p is not None]


def base_of(rows):
    """Speedup against serial where all rows have it; else against one thread of the same scheduler; None without either."""
    for base in BASES:
        if rows and all(base in row["values"] for row in rows):
            return base
    return None


class Threads:
    """The panels of one run's rows with threads."""

    def __init__(self, run):
        self.run = run
        # Serial has no threads: it is what others are held against.
        rows = [r for r in run.report["rows"] if r["factors"].get("scheduler") != "serial"]
        self.rows = [r for r in rows if number_of(r["factors"].get("threads", "-")) is not None and "fps" in r["values"]]
        self.counts = sorted({threads_of(r) for r in self.rows})
        self.layout = layout_of(self.rows, apart=("threads",))
        self.base = base_of(self.rows)
        self.common = {
            "x_title": "threads", "borders": borders_of(run.cores, run.pus, max(self.counts, default=0)), "x_values": round_values(self.counts),
            "log_x": bool(self.counts) and spread(self.counts) > 30,
        }  # fmt: skip

    def panel(self, title, y_title, points, **more):
        return Panel(title, y_title=y_title, points=existing(points), **(self.common | more))

    def fps(self, title, rows):
        raw = few_enough(self.rows, "fps")
        points = [point_of(r, "fps", threads_of(r), self.layout.series_of(r), raw, ("threads",)) for r in rows]
        log = spread([p.y for p in existing(points)]) > 12
        return self.panel(title, "frames a second", points, log_y=log, bounds=amdahl(self.run, rows, self.counts))

    def speedup(self, title, rows, **more):
        points = [point_of(r, self.base, threads_of(r), self.layout.series_of(r), names=("threads",)) for r in rows]
        bounds = speedup_bounds(self.run.cores, self.counts) + ceilings(self.run, rows, self.counts)
        return self.panel(title, BASES[self.base], points, bounds=bounds, ticks=tile_bounds(rows, self.base, self.layout), **more)

    def efficiency(self, title, rows):
        cores = self.run.cores
        bounds = [Bound("linear", [(n, 1.0) for n in self.counts]), Bound(f"{cores} physical cores", [(n, min(1.0, cores / n)) for n in self.counts])]
        return self.panel(title, "speedup / threads", [efficiency_point(r, self.base, self.layout) for r in rows], bounds=bounds, y_format="~%")

    def panels(self):
        """(panels, columns): all three of up to four groups of rows; of more, the speedup alone."""
        groups, made = self.layout.panels, []
        if self.base and len(groups) > 4:
            return [self.speedup(t, rows, width=200, height=150) for t, rows in groups], 4
        for title, rows in groups:
            head = title + ": " if title else ""
            made.append(self.fps(head + "fps", rows))
            if self.base:
                made += [self.speedup(head + "speedup", rows), self.efficiency(head + "efficiency", rows)]
        return made, 3 if self.base else min(3, len(made))


def fastest_sentence(rows, layout):
    """What is fastest among the rows of a panel."""
    best = max(rows, key=lambda r: r["values"]["fps"]["value"])
    who = layout.series_of(best)
    by = f"{who}, " if who != "this run" else ""
    return f"{by}threads {best['factors']['threads']}: {estimate_text(best['values']['fps'])}"


def threads_chart(run):
    """None where fewer than two thread counts were run, or two of so many schedulers that names tell more than lines."""
    threads = Threads(run)
    if longest_line(threads.rows, "threads") < 2:
        return None
    if len(threads.counts) < 3 and len(threads.layout.panels) > 4:
        return None
    panels, columns = threads.panels()
    panels = [p for p in panels if p.points]
    groups = threads.layout.panels
    title = "Highest median fps: " + "; ".join((f"{t}: " if t else "") + fastest_sentence(rows, threads.layout) for t, rows in groups[:3])
    text = ["Speedup and efficiency are paired by round."] if threads.base else []
    text.append(samples_sentence(threads.rows, "fps"))
    if any(p.ticks for p in panels):
        text.append("Short level bars: the most that the items' own costs allow, Σ cost / processors or the longest item.")
    text.append("Vertical lines: where threads begin to share cores or processors.")
    text.append(threads.layout.sentence())
    spec = panels_spec(panels, threads.layout.series, threads.layout.legend_title() or "run", columns, legend=len(threads.layout.series) > 1)
    return Chart("threads", title, " ".join(t for t in text if t), spec)
