"""Names beside points, placed so that none covers another or a point."""

from study_charts.colours import INK, PAPER

# Where a label may stand about its point, in points of the page: the first that is free is taken.
PLACES = [(7, 0, "left", "center"), (-7, 0, "right", "center"), (0, 7, "center", "bottom"), (0, -7, "center", "top")]
PLACES += [(x * 9, y * d, "left" if x > 0 else "right", "center") for d in (9, 17, 26, 36) for x in (1, -1) for y in (1, -1)]


def place_labels(axes, points, size=7):
    """Labels `points`, (x, y, name) in data coordinates, the most remote names first; those without place are left out.

    Returns the names that are left out.
    """
    figure = axes.figure
    renderer = figure.canvas.get_renderer()
    at = [axes.transData.transform((x, y)) for x, y, _ in points]
    taken, left_out = [], []
    frame = axes.get_window_extent(renderer)
    radius = 3.5 * figure.dpi / 72
    for (x, y, name) in points:
        for dx, dy, horizontal, vertical in PLACES:
            text = axes.annotate(
                name, (x, y), (dx, dy), textcoords="offset points", ha=horizontal, va=vertical, fontsize=size, color=INK,
                annotation_clip=False, zorder=4, bbox={"facecolor": PAPER, "alpha": 0.75, "pad": 0.3, "linewidth": 0},
                arrowprops={"arrowstyle": "-", "color": INK, "linewidth": 0.4, "shrinkA": 0, "shrinkB": 2} if abs(dy) > 7 else None,
            )  # fmt: skip
            box = text.get_window_extent(renderer).padded(1.5)
            inside = frame.x0 - 2 <= box.x0 and box.x1 <= frame.x1 + 40 and frame.y0 <= box.y0 and box.y1 <= frame.y1 + 2
            free = not any(box.overlaps(other) for other in taken)
            clear = not any(
                box.x0 - radius < px < box.x1 + radius and box.y0 - radius < py < box.y1 + radius
                for (px, py), point in zip(at, points)
                if point[:2] != (x, y)
            )
            if inside and free and clear:
                taken.append(box)
                break
            text.remove()
        else:
            left_out.append(name)
    return left_out
