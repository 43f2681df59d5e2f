"""How charts look: one colour and marker a method, and files whose bytes the input decides."""

import dataclasses

import matplotlib

matplotlib.use("agg")
import matplotlib.pyplot as plt  # noqa: E402  the backend comes first
from matplotlib.ticker import FuncFormatter  # noqa: E402

from study_charts.colours import COLOURS, INK, PAPER, RAIL  # noqa: E402
from study_charts.numbers import power  # noqa: E402

MARKERS = "osD^vPXp<>h*d8H"
DOTS_PER_INCH = 110

SETTINGS = {
    "svg.hashsalt": "raysweep",
    "svg.fonttype": "none",
    "font.family": "DejaVu Sans",
    "font.size": 9,
    "axes.titlesize": 9.5,
    "axes.titlelocation": "left",
    "axes.labelsize": 9,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "axes.linewidth": 0.7,
    "axes.facecolor": "none",
    "figure.facecolor": PAPER,
    "savefig.facecolor": PAPER,
    "figure.titlesize": 12,
    "figure.titleweight": "bold",
    "grid.color": RAIL,
    "grid.linewidth": 0.7,
    "legend.frameon": False,
    "lines.linewidth": 1.3,
    "xtick.labelsize": 8,
    "ytick.labelsize": 8,
} | {
    key: INK
    for key in ("text.color", "axes.labelcolor", "axes.titlecolor", "axes.edgecolor", "xtick.color", "ytick.color", "legend.labelcolor")
}


@dataclasses.dataclass(frozen=True)
class Look:
    colour: str
    marker: str


class Looks:
    """One look a method, by its place in the study's list: no two methods have the same."""

    def __init__(self, methods):
        self._looks = {m: Look(COLOURS[i % len(COLOURS)], MARKERS[i % len(MARKERS)]) for i, m in enumerate(methods)}

    def __getitem__(self, method):
        return self._looks[method]

    @property
    def methods(self):
        return list(self._looks)

    def handle(self, axes, method, **more):
        """An entry for a legend."""
        look = self[method]
        return axes.plot([], [], color=look.colour, marker=look.marker, markersize=6, label=method, **more)[0]


@dataclasses.dataclass(frozen=True)
class Chart:
    """One picture of the report. `title` states what is seen, `text` how to read it."""

    name: str
    title: str
    text: str
    figure: object


def start():
    """Makes these settings those of all pictures that follow."""
    plt.rcdefaults()
    plt.rcParams.update(SETTINGS)


def powers_on(axis):
    """Labels of a logarithmic axis as the text writes numbers."""
    axis.set_major_formatter(FuncFormatter(lambda value, _: power(value)))
    axis.set_minor_formatter(FuncFormatter(lambda value, _: ""))


def thinned(labels, most):
    """At most `most` of the labels, evenly chosen, the first and last always; the others are empty."""
    if len(labels) <= most:
        return labels
    step = -(-(len(labels) - 1) // (most - 1))
    kept = {i for i in range(0, len(labels), step) if len(labels) - 1 - i >= step} | {len(labels) - 1}
    return [label if i in kept else "" for i, label in enumerate(labels)]


def save(chart, folder):
    """Writes NAME.svg and NAME.png; the same picture gives the same bytes. Returns the text of the SVG."""
    file = folder / f"{chart.name}.svg"
    chart.figure.canvas.draw()
    chart.figure.set_layout_engine("none")
    frame = chart.figure.get_tightbbox(chart.figure.canvas.get_renderer()).padded(0.08)
    chart.figure.savefig(file, metadata={"Date": None, "Creator": None}, bbox_inches=frame)
    chart.figure.savefig(folder / f"{chart.name}.png", dpi=DOTS_PER_INCH, metadata={"Software": None}, bbox_inches=frame)
    plt.close(chart.figure)
    return file.read_text(encoding="utf-8")
