"""What the records say, as sentences: which method is fastest, which is safest, what safety costs, where each breaks."""

import dataclasses

from study_charts.accuracy import Accuracy, class_of, extra_rays, false_hits, false_misses, gravity, missed_rays
from study_charts.chart_combined import adding_up, failing_more
from study_charts.kernels import Kernel
from study_charts.numbers import per_million, power, short

# A method counts as broken in a case where more than this share goes wrong.
BROKEN = 0.01


@dataclasses.dataclass(frozen=True)
class Answer:
    question: str
    sentences: list


def joined(names):
    names = list(names)
    return names[0] if len(names) == 1 else ", ".join(names[:-1]) + " and " + names[-1]


def time_text(ns):
    interval = f" ({short(ns.low)} to {short(ns.high)})" if ns.low is not None else ""
    return f"{short(ns.value)} ns a test{interval}"


def not_told_apart(kernels, precision, workload):
    """The base kernels whose rounds do not tell them from the fastest one: the interval of the ratio holds 1."""
    base = [k for k, _ in kernels.base(precision, workload)]
    same = []
    for kernel in base[1:]:
        ratio = kernels.ratio(kernel, base[0], workload)
        if ratio and (ratio.low is None or ratio.low <= 1):
            same.append(kernel)
    return same


def fastest(kernels):
    """A sentence a precision and workload of those that everybody asks for; packets are another question."""
    sentences = []
    workloads = [kernels.headline()] + [w for p in ("worst-case", "replay") for w in kernels.of_protocol(p)]
    for workload in dict.fromkeys(workloads):
        for precision in kernels.precisions:
            base = kernels.base(precision, workload)
            if not base:
                continue
            kernel, ns = base[0]
            sentence = f"{str(workload).capitalize()}, {precision}: {kernel.method}, {time_text(ns)}"
            same = not_told_apart(kernels, precision, workload)
            if same:
                sentence += f", not told apart from {joined(k.method for k in same)}"
            elif len(base) > 1:
                second = kernels.price(base[1][0], kernel, workload)
                sentence += f"; the next, {base[1][0].method}, takes {short(second.value)} % more" if second else ""
            sentences.append(sentence + ".")
    return sentences


def watertight_methods(accuracy, precision):
    """Methods of which no ray is seen to pass a mesh that it meets."""
    on_mesh = set(accuracy.mesh_cases)
    found = []
    for method in accuracy.methods:
        records = accuracy.of(method, precision, only=on_mesh.__contains__)
        if records and not any(r["missed_rays"] for r in records):
            found.append(method)
    return found


def broken_cells(accuracy, method, precision):
    records = accuracy.of(method, precision)
    return sum(gravity(r) > BROKEN for r in records), len(records)


def safest(accuracy):
    sentences = []
    for precision in accuracy.precisions:
        tight = watertight_methods(accuracy, precision)
        if tight:
            rays = accuracy.pooled(accuracy.of(tight[0], precision), missed_rays)
            verb = "lets" if len(tight) == 1 else "let"
            sentences.append(f"At edges and corners of meshes, {precision}: only {joined(tight)} {verb} no ray through ({per_million(rays)} of {rays.of:,} rays).")  # fmt: skip
        elif accuracy.mesh_cases:
            rates = {m: accuracy.pooled(accuracy.of(m, precision), missed_rays) for m in accuracy.methods}
            least = min(rates, key=lambda m: rates[m].share)
            sentences.append(f"At edges and corners of meshes, {precision}: every method lets rays through, {least} the fewest ({per_million(rates[least])}).")  # fmt: skip
        cells = {m: broken_cells(accuracy, m, precision) for m in accuracy.methods}
        fewest = min(cells.values())[0]
        best = [m for m in cells if cells[m][0] == fewest]
        worst = max(cells, key=lambda m: cells[m][0])
        sentences.append(
            f"In all cases, {precision}: {joined(best)} {'breaks' if len(best) == 1 else 'break'} in the fewest cells, {fewest} of "
            f"{cells[best[0]][1]} (a case at a difficulty); the most by {worst}, {cells[worst][0]}."
        )
    return sentences


def safest_method(accuracy, precision):
    """Among those that let no ray through a mesh, or among all if none is so, the one with the fewest broken cells."""
    choice = watertight_methods(accuracy, precision) or accuracy.methods
    return min(choice, key=lambda m: broken_cells(accuracy, m, precision)[0])


def cost_of_safety(accuracy, kernels):
    """The safest against the fastest method, of both precisions; and what double costs and brings."""
    sentences, workload = [], kernels.headline()
    for precision in kernels.precisions:
        base = [k for k, _ in kernels.base(precision, workload)]
        if precision not in accuracy.precisions or not base:
            continue
        safe = Kernel(safest_method(accuracy, precision), "base", precision)
        price = kernels.price(safe, base[0], workload)
        if safe == base[0]:
            same = not_told_apart(kernels, precision, workload)
            told = f", not told apart from {joined(k.method for k in same)}" if same else ""
            sentences.append(f"Nothing, {precision}: {safe.method} is the safest and the fastest{told} ({workload}).")
        elif price:
            sentences.append(f"{precision.capitalize()}: {safe.method} takes {percent_text(price)} more time than {base[0].method}, the fastest ({workload}).")  # fmt: skip
        else:
            sentences.append(f"{precision.capitalize()}: {safe.method} was not timed together with {base[0].method}.")
    return sentences + double_instead(accuracy, kernels, workload)


def double_instead(accuracy, kernels, workload):
    """Whether double closes meshes, and at what price."""
    if not {"float", "double"} <= set(accuracy.precisions) or not accuracy.mesh_cases:
        return []
    gained = [m for m in watertight_methods(accuracy, "double") if m not in watertight_methods(accuracy, "float")]
    prices = sorted(p.value for m in kernels.methods if (p := kernels.price(Kernel(m, "base", "double"), Kernel(m, "base", "float"), workload)))
    if not prices:
        return []
    brought = f"makes {joined(gained)} watertight" if gained else "makes no method watertight that is not so in float"
    return [f"Double instead of float {brought}; it costs {short(prices[0])} to {short(prices[-1])} %, {short(prices[len(prices) // 2])} % in the middle."]


def percent_text(price):
    interval = f" ({short(price.low)} to {short(price.high)})" if price.low is not None else ""
    return f"{short(price.value)} %{interval}"


def breaks(accuracy, precision):
    """Where more than one per cent goes wrong: cases in which all methods break, or none, then of each method the others."""
    found = {
        case: {m: accuracy.first_failure(m, precision, case, BROKEN) for m in accuracy.methods if accuracy.find(m, precision, case, accuracy.levels(case)[0][0])}
        for case in accuracy.cases
    }  # fmt: skip
    found = {case: firsts for case, firsts in found.items() if firsts}
    never = [case for case, firsts in found.items() if all(first is None for first in firsts.values())]
    always = [case for case, firsts in found.items() if all(first is not None for first in firsts.values())]
    sentences = [f"{precision.capitalize()}: every method holds in {', '.join(never) or 'no case'}, and every one breaks in {', '.join(always) or 'none'}."]  # fmt: skip
    between = {case: firsts for case, firsts in found.items() if case not in never + always}
    for method in accuracy.methods if between else []:
        where = [f"{case} from {power(firsts[method])}" for case, firsts in between.items() if firsts.get(method) is not None]
        sentences.append(f"{method}, {precision}, of the other {len(between)}: {', '.join(where) or 'holds in all'}.")
    return sentences


def combinations(accuracy, kernels):
    """What variants with several changes do; nothing without any."""
    sentences = adding_up(kernels) if kernels else []
    failing = failing_more(accuracy) if accuracy else None
    return sentences + ([failing] if failing else [])


def answers(accuracy, kernels):
    """All that can be answered; `accuracy` and `kernels` may be None. What is missing is said in place of its answer."""
    no_time = ["No kernel run was given: nothing is known of time."]
    no_cases = ["No accuracy run was given: nothing is known of failures."]
    cost = cost_of_safety(accuracy, kernels) if accuracy and kernels else ["It needs an accuracy run and a kernel run."]
    broken = [sentence for p in accuracy.precisions for sentence in breaks(accuracy, p)] if accuracy else no_cases
    combined = combinations(accuracy, kernels)
    return [
        Answer("Which method is fastest?", fastest(kernels) if kernels else no_time),
        Answer("Which is safest?", safest(accuracy) if accuracy else no_cases),
        Answer("What does safety cost?", cost or ["No safe method was timed."]),
        Answer(f"Where does each break? (more than {100 * BROKEN:g} % of the rays pass a mesh, or of the hits or misses are wrong elsewhere)", broken),
    ] + ([Answer("Do changes add up?", combined)] if combined else [])


def class_rows(accuracy):
    """A row a method and precision: false misses, false hits, missed and extra rays of each class; the table under the charts."""
    measures = {"false misses": false_misses, "false hits": false_hits, "missed rays": missed_rays, "extra": extra_rays}
    columns = [(c, name) for c in accuracy.classes for name in measures]
    rows = []
    for precision in accuracy.precisions:
        for method in accuracy.methods:
            rates = []
            for class_id, name in columns:
                records = accuracy.of(method, precision, only=lambda case, c=class_id: class_of(case) == c)
                rates.append(Accuracy.pooled(records, measures[name]))
            rows.append((method, precision, rates))
    kept = [i for i in range(len(columns)) if any(rates[i] for _, _, rates in rows)]
    return [columns[i] for i in kept], [(m, p, [rates[i] for i in kept]) for m, p, rates in rows]
