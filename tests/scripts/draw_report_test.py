"""The parts of the experiments' page, on runs that are made up."""

import json
import pathlib
import random
import sys
import tempfile
import unittest
import unittest.mock

HERE = pathlib.Path(__file__).resolve().parent
SCRIPTS = HERE.parent.parent / "scripts"
sys.dont_write_bytecode = True
sys.path[:0] = [str(SCRIPTS), str(HERE)]

import made_reports as made  # noqa: E402
from report_page import chart_frames, chart_timeline, factors, headline, layout, noise, page, panel, size  # noqa: E402
from report_page.chart_bars import bars_chart  # noqa: E402
from report_page.chart_published import published_chart  # noqa: E402
from report_page.chart_speed_error import speed_error_chart  # noqa: E402
from report_page.chart_sweep import sweep_charts  # noqa: E402
from report_page.chart_threads import borders_of, threads_chart  # noqa: E402
from report_page.charts import charts_of  # noqa: E402
from report_page.panel import Panel, Point  # noqa: E402
from report_page.runs import RunError, read_run  # noqa: E402


def rows_of(*given):
    draw = random.Random(0)
    return [made.row(f, "fps", 1 + i, draw) for i, f in enumerate(given)]


def data_of(chart, name):
    return next((d["values"] for d in chart.spec["data"] if d["name"] == name), [])


class WithFolder(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def run_of(self, experiment, kind, rows, **members):
        return read_run(made.write(self.folder / experiment, made.report(experiment, kind, rows, **members)))


class Factors(unittest.TestCase):
    def test_a_factor_that_follows_from_others_tells_nothing(self):
        rows = rows_of(
            {"mode": "low", "width": 512, "threads": 1, "pin": "-"},
            {"mode": "low", "width": 512, "threads": 2, "pin": "none"},
            {"mode": "hard", "width": 1024, "threads": 1, "pin": "-"},
        )
        self.assertEqual(factors.telling(rows), ["mode", "threads"])
        self.assertEqual(factors.telling(rows, apart=("threads",)), ["mode"])

    def test_values_stand_in_the_order_of_their_numbers_where_all_are_numbers(self):
        self.assertEqual(factors.in_order(["12/thread", "2/thread", "1/thread"]), ["1/thread", "2/thread", "12/thread"])
        self.assertEqual(factors.in_order(["rows", "16"]), ["rows", "16"])

    def test_a_label_leaves_out_what_has_no_value(self):
        self.assertEqual(
            factors.label({"scheduler": "serial", "runtime": "-", "threads": "1"}, ["scheduler", "runtime", "threads"]), "serial, threads 1"
        )

    def test_the_innermost_factor_is_lines_and_the_others_are_panels(self):
        rows = rows_of(*({"mode": m, "scheduler": s, "threads": n} for m in ("low", "hard") for s in ("a", "b") for n in (1, 2)))
        found = layout.layout_of(rows, apart=("threads",))
        self.assertEqual(([title for title, _ in found.panels], found.series), (["low", "hard"], ["a", "b"]))

    def test_more_names_than_colours_are_panels_of_their_own(self):
        rows = rows_of(*({"scheduler": f"s{i}", "threads": n} for i in range(9) for n in (1, 2)))
        found = layout.layout_of(rows, apart=("threads",))
        self.assertEqual((len(found.panels), found.series), (9, ["this run"]))

    def test_settings_that_advance_together_are_no_axis(self):
        together = rows_of(*({"subpixels": n, "depth": n, "lights": 1} for n in (1, 2, 4)))
        self.assertEqual(layout.longest_line(together, "subpixels"), 0)
        alone = rows_of(*({"subpixels": n, "scheduler": s, "pin": s} for n in (1, 2, 4) for s in ("a", "b")))
        self.assertEqual(layout.longest_line(alone, "subpixels"), 3)


class Panels(unittest.TestCase):
    def test_borders_stand_behind_the_last_core_and_the_last_processor(self):
        self.assertEqual([(b.x, b.text) for b in borders_of(6, 12, 24)], [(6.5, "hyper-threads"), (12.5, "oversubscribed")])
        self.assertEqual([b.x for b in borders_of(2, 2, 4)], [2.5])
        self.assertEqual(borders_of(6, 12, 6), [])

    def test_series_stand_beside_each_other_and_never_past_their_neighbours_x(self):
        points = [Point(s, x, 1.0) for s in "abcdefgh" for x in range(1, 25)]
        moved, _ = panel.dodge(Panel("", "", "", points), list("abcdefgh"))
        gap = 250 / (24 * (1 + 2 * panel.MARGIN))
        self.assertEqual(len(set(moved.values())), 8)
        self.assertLess(max(moved.values()) - min(moved.values()), gap)

    def test_an_axis_holds_every_sample_and_both_ends_of_intervals(self):
        low, high = panel.y_domain(Panel("", "", "", [Point("a", 1, 5.0, 4.0, 9.0, samples=[(0, 11.0)])], from_zero=False))
        self.assertTrue(low < 4 and high > 11)

    def test_bounds_do_not_stretch_the_axis(self):
        bounds = [panel.Bound("linear", [(1, 1), (24, 24)])]
        self.assertLess(panel.y_domain(Panel("", "", "", [Point("a", 1, 1.0), Point("a", 24, 2.0)], bounds))[1], 3)


class Runs(WithFolder):
    def test_frames_of_copies_of_twins_and_of_launches_that_failed_are_left_out(self):
        records = [
            {"kind": "picture", "cell": "c", "valid": True, "processes": 1, "frame_seconds": [1.0, 2.0]},
            {"kind": "picture", "cell": "c", "valid": True, "processes": 2, "frame_seconds": [[3.0], [4.0]]},
            {"kind": "picture", "cell": "c", "valid": True, "processes": 1, "twin": 1, "frame_seconds": [5.0]},
            {"kind": "picture", "cell": "c", "valid": False, "processes": 1, "frame_seconds": [6.0]},
        ]  # fmt: skip
        run = read_run(made.write(self.folder, made.report("x", "picture", []), records))
        self.assertEqual(run.frames, [("c", 1.0), ("c", 2.0)])

    def test_what_is_no_run_is_said_in_a_sentence_with_its_place(self):
        with self.assertRaisesRegex(RunError, "has no report.json, which `raysweep report .*` writes"):
            read_run(self.folder)
        made.write(self.folder, made.report("x", "picture", []) | {"schema": 9})
        with self.assertRaisesRegex(RunError, "report.json: schema 9; this page reads schema 1"):
            read_run(self.folder)
        (self.folder / "report.json").write_text("nonsense", encoding="utf-8")
        with self.assertRaisesRegex(RunError, "report.json: cannot be read"):
            read_run(self.folder)


class Charts(WithFolder):
    def test_names_are_not_joined_by_lines(self):
        run = made.kernel_run(self.folder)
        text = json.dumps(bars_chart(read_run(run)).spec)
        self.assertNotIn('"type": "line"', text)
        self.assertNotIn('"type": "area"', text)

    def test_the_points_of_a_chart_are_the_values_of_the_report(self):
        run = read_run(made.threads_run(self.folder))
        chart = threads_chart(run)
        drawn = {(p["s"], p["x"], p["y"], p["low"], p["high"]) for p in data_of(chart, "points0")}
        kept = [r for r in run.report["rows"] if r["factors"]["scheduler"] != "serial"]
        told = {
            (r["factors"]["mode"], float(r["factors"]["threads"]), *(float(f"{r['values']['fps'][e]:.6g}") for e in ("value", "low", "high")))
            for r in kept
        }
        self.assertEqual(drawn, told)

    def test_every_sample_is_drawn(self):
        run = read_run(made.threads_run(self.folder))
        count = sum(len(r["samples"]["fps"]) for r in run.report["rows"] if r["factors"]["scheduler"] != "serial")
        self.assertEqual(len(data_of(threads_chart(run), "samples0")), count)

    def test_the_bound_by_the_items_costs_is_the_speedup_over_the_quality(self):
        run = read_run(made.threads_run(self.folder))
        tick = next(p for p in data_of(threads_chart(run), "ticks1") if p["x"] == 6)
        self.assertAlmostEqual(tick["y"], 6 * 0.97 / 0.93, places=4)

    def test_printed_and_our_numbers_are_drawn_as_the_report_normalised_them(self):
        run = read_run(made.sweep_run(self.folder, "m11-t8", "leaf", "morozov2011_table8_bvh_leaf_fps.csv", [4, 64, 16384]))
        chart = published_chart(run)
        cells = [c for c in run.report["published"]["rows"] if c["factors"]["mode"] == "low"]
        drawn = {(p["s"], p["x"]): p["y"] for p in data_of(chart, "points0")}
        for cell in cells:
            x = float(cell["factors"]["leaf"])
            self.assertAlmostEqual(drawn["printed", x], cell["printed_normalised"], places=5)
            if cell["ours_normalised"]:
                self.assertAlmostEqual(drawn["here", x], cell["ours_normalised"]["value"], places=5)
        self.assertEqual(sum(series == "here" for series, _ in drawn), 3)

    def test_a_printed_number_is_drawn_once_however_many_of_ours_stand_beside_it(self):
        cells = []
        for n, printed in ((1, "5.0"), (2, "9.0")):
            for k, core in enumerate(("scalar", "wide")):
                ours = made.estimate(6.0 * n + k)
                cells.append(
                    {
                        "factors": {"depth": str(n), "core": core, "mode": "low"},
                        "printed": printed,
                        "printed_normalised": None,
                        "ours": ours,
                        "ours_normalised": None,
                    }
                )
        table = {"file": "f", "quantity": "fps", "normalise": "none", "rows_are": ["depth"], "machine": {"cores": 6, "pus": 12}, "rows": cells}
        chart = published_chart(self.run_of("x", "picture", [], published=table))
        drawn = sorted((p["s"], p["x"], p["y"]) for p in data_of(chart, "points0"))
        self.assertEqual(
            drawn,
            [("here, scalar", 1, 6), ("here, scalar", 2, 12), ("here, wide", 1, 7), ("here, wide", 2, 13), ("printed", 1, 5), ("printed", 2, 9)],
        )

    def test_chunks_a_thread_are_an_axis_of_numbers(self):
        run = read_run(
            made.sweep_run(
                self.folder, "m11-t9", "chunk", "morozov2011_table9_chunks_per_thread_fps.csv", ["1/thread", "3/thread", "12/thread"], "{}/thread"
            )
        )
        chart = sweep_charts(run)[0]
        self.assertEqual(sorted({p["x"] for p in data_of(chart, "points0")}), [1, 3, 12])
        self.assertIn("chunks a thread", json.dumps(chart.spec))

    def test_too_many_samples_are_left_out_and_said(self):
        rows = [r | {"samples": {"fps": r["samples"]["fps"] * 200}} for r in rows_of(*({"depth": n} for n in (1, 2, 4, 8)))]
        chart = sweep_charts(self.run_of("x", "picture", rows))[0]
        self.assertEqual(data_of(chart, "samples0"), [])
        self.assertIn("The 5,600 samples stand in records.jsonl", chart.text)

    def test_speed_meets_accuracy_formula_by_formula(self):
        chart = speed_error_chart(read_run(made.kernel_run(self.folder / "k")), read_run(made.accuracy_run(self.folder / "a")))
        points = {p["s"]: (p["x"], p["y"]) for p in data_of(chart, "points0")}
        # In float, at the hardest of three difficulties.
        self.assertEqual(points["wald"], (32, 1.5 * 4 * 100))

    def test_a_long_trace_keeps_its_workers_time_when_short_chunks_become_one_bar(self):
        bars = [{"r": "worker 0", "from": i * 0.1, "to": i * 0.1 + 0.1, "n": 1, "tip": []} for i in range(chart_timeline.MOST_BARS + 1)]
        few = chart_timeline.merged(bars)
        self.assertLess(len(few), 1500)
        self.assertEqual(sum(b["n"] for b in few), len(bars))
        self.assertAlmostEqual(sum(b["to"] - b["from"] for b in few), 0.1 * len(bars))

    def test_a_distribution_ends_at_all_frames_however_many_there_are(self):
        for count in (1, 2, 119, 120, 121, 1000, 1001):
            points = chart_frames.steps_of("a", [float(i) for i in range(count)])
            self.assertEqual((points[-1].x, points[-1].y), ((count - 1) * 1e3, 1.0))
            self.assertLessEqual(len(points), chart_frames.MOST_POINTS + 1)

    def test_a_run_without_rows_has_no_chart_and_fails_nowhere(self):
        for kind in ("picture", "kernel", "accuracy", "pixels"):
            self.assertEqual(charts_of(self.run_of(kind, kind, [])), [])

    def test_a_row_without_values_is_no_point(self):
        rows = rows_of(*({"scheduler": "a", "threads": n} for n in (1, 2, 4)))
        rows[1]["values"]["fps"] = {"value": None, "low": None, "high": None, "count": 0}
        chart = threads_chart(self.run_of("x", "picture", rows))
        self.assertEqual([p["x"] for p in data_of(chart, "points0")], [1, 4])


class Answers(WithFolder):
    def answers(self, claims):
        return headline.answers_of(self.run_of("x", "picture", [], claims=claims), "x")

    def test_the_headline_counts_each_verdict(self):
        found = self.answers(made.claims())
        self.assertEqual(headline.counted(found), "3 claims of 1 experiment: 1 reproduced, 1 not reproduced, 1 cannot be tested here.")
        self.assertEqual(
            headline.counted_in_source(found), "In the sources themselves: 1 holds in the source, 1 contradicted by its own table, 1 not in a table."
        )

    def test_a_summary_names_the_group_that_does_not_hold(self):
        groups = [made.group(1.25, True, 1.24, 1.26, {"mode": "low"}), made.group(1.5, False, 1.4, 1.6, {"mode": "hard"})]
        claim = made.claims()[0] | {"ours": made.side("not reproduced", groups)}
        answer = self.answers([claim])[0]
        self.assertEqual(answer.summary(answer.our_groups), "Of 2, 1 holds, 1 does not; mode hard: 1.5 [1.4, 1.6], expected 1.2 to 1.3")

    def test_what_was_measured_but_not_decided_says_so_and_nothing_of_why_it_would_differ(self):
        groups = [made.group(1.25, None, problem="fewer than 6 rounds: no interval")]
        claim = made.claims()[1] | {"ours": made.side("cannot be tested here", groups)}
        answers = self.answers([claim, made.claims()[2]])
        self.assertEqual(answers[0].summary(answers[0].our_groups), "1.25, expected 1.2 to 1.3; fewer than 6 rounds: no interval")
        self.assertEqual([a.shown_why for a in answers], ["", ""])
        self.assertIn("2 cannot be tested here (1 of these measured, but undecided)", headline.counted(answers))

    def test_ranges_are_told_by_the_ends_that_they_have(self):
        self.assertEqual([headline.range_text(*r) for r in ((1, 2), (1, None), (None, 0.1), (3, 3))], ["1 to 2", "≥ 1", "≤ 0.1", "3"])

    def test_runs_of_the_same_experiment_have_anchors_of_their_own(self):
        runs = [self.run_of(name, "picture", []) for name in ("a", "b")] + [self.run_of("a", "picture", [])] * 2
        self.assertEqual(headline.anchors_of(runs), ["a", "b", "a--2", "a--3"])

    def test_notes_are_counted_without_their_numbers(self):
        rows = rows_of({"threads": 1}, {"threads": 2})
        rows[0]["notes"], rows[1]["notes"] = ["drifts by −2.8 % over the run: too narrow"], ["drifts by +4 % over the run", "oversubscribed"]
        self.assertEqual(noise.notes_of(self.run_of("x", "picture", rows)), [("drifts by … over the run", 2), ("oversubscribed", 1)])

    def test_a_noise_floor_is_told_in_per_cent(self):
        self.assertEqual(noise.noise_text(self.run_of("x", "picture", [], noise_floor=0.0953)), "10 %")
        self.assertEqual(noise.noise_text(self.run_of("y", "picture", [], noise_floor=None)), "not told")

    def test_the_page_begins_with_the_machine_and_its_least_and_largest_noise(self):
        runs = [self.run_of(n, "picture", [], noise_floor=f) for n, f in (("a", 0.0953), ("b", None), ("c", 0.01))]
        self.assertIn("differed by 1 % (c) to 10 % (a):", noise.measured_on(runs))
        self.assertIn("differed by 10 %:", noise.measured_on(runs[:1]))
        self.assertTrue(noise.measured_on(runs[1:2]).endswith("; its noise was not."))
        self.assertIn(noise.measured_on(runs), page.page(runs, [[], [], []], "", []))


class Page(WithFolder):
    def test_tables_that_do_not_fit_are_named_and_smaller_ones_stay(self):
        long = made.table() | {"name": "long", "rows": [["x" * 100, "1"]] * 100}
        section = page.sections_of([self.run_of("x", "picture", [], tables=[long, made.table()])], [[]])
        kept = size.fitting_tables(section, 1000)[0]
        self.assertEqual(([t.name for t in kept.tables], kept.left_out), (["scaling"], ["x/tables/long.csv"]))

    def test_charts_with_most_samples_lose_them_first_and_their_estimates_never(self):
        def spec(count):
            return {"data": [{"name": "points0", "values": [1, 2]}, {"name": "samples0", "values": list(range(count))}]}

        specs = {"few": spec(10), "many": spec(1000), "none": spec(0)}
        kept, slimmed = size.fitting_specs(specs, 500)
        self.assertEqual(slimmed, ["many"])
        self.assertEqual((kept["few"], kept["none"]), (specs["few"], specs["none"]))
        self.assertEqual([d["values"] for d in kept["many"]["data"]], [[1, 2], []])
        self.assertEqual(size.fitting_specs(specs, 100_000), (specs, []))

    def test_the_page_stays_small_whatever_else_it_has_to_say(self):
        long = made.table() | {"name": "long", "rows": [["x" * 100, "1"]] * 1000}
        claims = [dict(c, id=f"{c['id']}{i}", why="y" * 3000) for i in range(40) for c in made.claims()]
        run = self.run_of("x", "picture", [], tables=[long], claims=claims)
        small = page.page([run], [[]], "", [])
        self.assertIn("x" * 100, small)
        with unittest.mock.patch.object(page, "PAGE_BYTES", len(small.encode()) - 1000):
            smaller = page.page([run], [[]], "", [])
        self.assertNotIn("x" * 100, smaller)
        self.assertIn("x/tables/long.csv", smaller)

    def test_machines_that_differ_in_load_alone_are_one(self):
        runs = []
        for name, load in (("a", 0.1), ("b", 1.9)):
            self.run_of(name, "picture", [])
            (self.folder / name / "machine.json").write_text(json.dumps(made.MACHINE | {"load": load}), encoding="utf-8")
            runs.append(read_run(self.folder / name))
        self.assertEqual([len(m.sections) for m in page.machines_of(page.sections_of(runs, [[], []]))], [2])

    def test_no_text_of_a_run_is_markup(self):
        run = self.run_of("x", "picture", [], claims=made.claims(), question="</script><b>?")
        text = page.page([run], [[]], "", [])
        self.assertNotIn("<b>?", text)
        self.assertNotIn("<at>", text)
        self.assertIn("it peaks &lt;at&gt; the end", text)
        self.assertNotIn("</script>", size.embedded({"question": "</script>"}))


if __name__ == "__main__":
    unittest.main()
