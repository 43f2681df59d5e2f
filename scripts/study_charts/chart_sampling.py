"""What few samples a pixel do to edges: errors against a picture of many, by pattern."""

import matplotlib.pyplot as plt

from study_charts.chart_pixels import picture_of
from study_charts.numbers import short
from study_charts.runs import in_order
from study_charts.style import Chart, Looks


def edge_errors(records):
    """(picture, pattern) → samples → RMSE at edges, of records whose reference has other samples than they."""
    errors = {}
    for r in records:
        if r["valid"] and r["subpixels"] != r["reference_subpixels"] and r["edge_rmse"] is not None:
            errors.setdefault((picture_of(r), r["pattern"]), {})[r["subpixels"]] = r["edge_rmse"]
    return errors


def wins(errors, pattern, other):
    """(how often the first has the smaller error, of how many pictures and counts that both have)."""
    pairs = [
        (of_picture[n], errors[picture, other][n])
        for (picture, name), of_picture in errors.items() if name == pattern and (picture, other) in errors
        for n in of_picture if n in errors[picture, other]
    ]  # fmt: skip
    return sum(a < b for a, b in pairs), len(pairs)


def title_of(errors):
    won, of = wins(errors, "circle", "grid")
    if of:
        return f"At edges a circle is nearer to many samples than a grid of as many in {won} of {of} cases"
    best = min(errors, key=lambda key: min(errors[key].values()))
    return f"The least error at edges: {short(min(errors[best].values()))}, {best[1]} on {best[0]}"


def sampling_chart(records):
    """A panel a picture, a line a pattern; None without such records."""
    errors = edge_errors(records)
    if not errors:
        return None
    pictures, looks = in_order(p for p, _ in errors), Looks(in_order(p for _, p in errors))
    figure, panels = plt.subplots(1, len(pictures), figsize=(max(4.6 * len(pictures), 7), 4.4), squeeze=False, layout="constrained")
    for axes, picture in zip(panels[0], pictures):
        for pattern in looks.methods:
            found = sorted(errors.get((picture, pattern), {}).items())
            axes.plot([n for n, _ in found], [e for _, e in found], color=looks[pattern].colour, marker=looks[pattern].marker, markersize=5, label=pattern)
        axes.set_xscale("log", base=2)
        axes.set_yscale("log")
        axes.xaxis.set_major_formatter(plt.FuncFormatter(lambda value, _: f"{value:g}"))
        axes.set_title(picture)
        axes.set_xlabel("samples a pixel")
    panels[0, 0].set_ylabel("RMSE at edges")
    panels[0, 0].legend(fontsize=8)
    figure.suptitle(title_of(errors), x=0.01, ha="left")
    many = max(r["reference_subpixels"] for r in records)
    text = (
        f"The root of the mean square of what linear channels differ by from a picture of {many} samples a pixel, over the pixels at "
        "its edges: those that differ from a neighbour by more than 32 of 255."
    )
    return Chart("sampling-edges", title_of(errors), text, figure)
