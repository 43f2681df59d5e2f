"""The charts and the report of the intersection study, on records that are made up."""

import math
import pathlib
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
SCRIPTS = HERE.parent.parent / "scripts"
sys.dont_write_bytecode = True
sys.path[:0] = [str(SCRIPTS), str(HERE)]

import made_records as made  # noqa: E402
from study_charts import answers, chart_difficulty, chart_map, chart_pixels, chart_price, chart_sampling, chart_speed, numbers, runs  # noqa: E402
from study_charts.accuracy import NO_HIT, Accuracy, false_misses, t_error  # noqa: E402
from study_charts.chart_cost import error_point, front_of, points_of  # noqa: E402
from study_charts.colours import DARK  # noqa: E402
from study_charts.inline import Inline  # noqa: E402
from study_charts.kernels import Kernel, Kernels, Workload  # noqa: E402
from study_charts.numbers import Rate  # noqa: E402
from study_charts.style import Looks, thinned  # noqa: E402


class Numbers(unittest.TestCase):
    def test_no_failure_in_n_tries_is_drawn_at_three_over_n(self):
        self.assertEqual(Rate(0, 1000).upper, 0.003)
        self.assertEqual(Rate(0, 1000).interval, (0.0, 0.003))
        self.assertEqual(Rate(0, 2).upper, 1.0)
        self.assertEqual(numbers.per_million(Rate(0, 20000)), "≤ 150 per million")

    def test_an_interval_holds_its_rate_and_stays_between_0_and_1(self):
        for count, of in ((1, 10), (10, 10), (5, 1000), (999, 1000)):
            low, high = Rate(count, of).interval
            self.assertTrue(0 <= low <= count / of <= high <= 1, (count, of))

    def test_the_ends_of_an_interval_are_as_unlikely_as_wilson_says(self):
        """Seen from either end, the share is 1.96 standard deviations away."""
        for end in Rate(1, 10).interval:
            self.assertAlmostEqual(abs(0.1 - end) / math.sqrt(end * (1 - end) / 10), numbers.Z_95)

    def test_a_median_has_an_interval_from_six_samples_on(self):
        self.assertIsNone(numbers.estimate_median([1, 2, 3, 4, 5]).low)
        estimate = numbers.estimate_median([6, 1, 5, 2, 4, 3])
        self.assertEqual((estimate.low, estimate.value, estimate.high), (1, 3.5, 6))
        self.assertEqual(numbers.median_interval_rank(9), 1)

    def test_nothing_on_a_front_is_beaten_and_all_else_is(self):
        points = [(1, 9), (2, 5), (2, 6), (3, 5), (4, 1), (5, 2)]
        self.assertEqual([points[i] for i in numbers.pareto_front(points)], [(1, 9), (2, 5), (4, 1)])

    def test_a_difficulty_is_written_as_short_as_a_tick_has_place(self):
        self.assertEqual([numbers.power(v) for v in (1e-6, 0.5, 0, 4096, 1e10, 2e-4)], ["10⁻⁶", "0.5", "0", "4096", "10¹⁰", "2·10⁻⁴"])

    def test_thinned_labels_keep_both_ends(self):
        self.assertEqual(thinned(list("abcdefg"), 3), ["a", "", "", "d", "", "", "g"])
        self.assertEqual(thinned(list("ab"), 3), ["a", "b"])


class Records(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def lines(self, text):
        (self.folder / "records.jsonl").write_text(text, encoding="utf-8")
        return runs.read_run(self.folder)

    def test_a_last_line_without_its_end_is_left_out(self):
        self.assertEqual(len(self.lines('{"kind":"atlas","schema":1}\n{"kind":"atl').records), 1)

    def test_what_is_no_run_is_said_in_a_sentence_with_its_place(self):
        for text, words in (
            ("", "has no record"),
            ("nonsense\n", ":1: is no record"),
            ('{"schema":1}\n', ":1: is no record"),
            ('{"kind":"atlas","schema":2}\n', ":1: atlas of schema 2; these charts read schema 1"),
            ('{"kind":"accuracy","schema":1}\n', ":1: accuracy of schema 1; these charts read schema 3"),
            ('{"kind":"kernel","schema":4}\n', ":1: kernel of schema 4; these charts read schema 1, 2, 3"),
            ('{"kind":"kernel","schema":2,"kernel":"branches"}\n', ':1: kernel "branches"; these charts are of intersection'),
            ('{"kind":"soup","schema":1}\n', 'unknown kind "soup"; these charts read: accuracy'),
            ('{"kind":"atlas","schema":1}\n{"kind":"kernel","schema":1}\n', "2 kinds: atlas, kernel"),
        ):
            with self.assertRaisesRegex(runs.RunError, words):
                self.lines(text)


class AccuracyTest(unittest.TestCase):
    def test_a_cell_without_any_hit_has_an_infinite_error_and_one_without_any_due_has_none(self):
        lost = made.accuracy_record(false_misses=1000, t_error=made.NO_ERROR)
        self.assertEqual(t_error(lost), NO_HIT)
        self.assertIsNone(t_error(made.accuracy_record(hits=0, t_error=made.NO_ERROR)))
        self.assertEqual(error_point([lost, lost, made.accuracy_record()])[0], NO_HIT)

    def test_rates_of_a_class_are_of_all_its_tries_together(self):
        records = [made.accuracy_record(false_misses=10, hits=100), made.accuracy_record(false_misses=0, hits=900)]
        self.assertEqual(Accuracy.pooled(records, false_misses), Rate(10, 1000))

    def test_the_first_failure_is_at_the_easiest_level_that_fails(self):
        levels = [(0, 1.0, 0), (1, 0.1, 5), (2, 0.01, 500)]
        accuracy = Accuracy([made.accuracy_record(case="S1", mesh_rays=0, level=n, difficulty=d, false_misses=f) for n, d, f in levels])
        self.assertEqual(accuracy.first_failure("wald", "float", "S1"), 0.1)
        self.assertEqual(accuracy.first_failure("wald", "float", "S1", above=0.01), 0.01)

    def test_a_mesh_breaks_where_rays_pass_it_not_where_they_hit_the_neighbour(self):
        accuracy = Accuracy([made.accuracy_record(method="a", false_misses=900), made.accuracy_record(method="b", missed_rays=900)])
        self.assertIsNone(accuracy.first_failure("a", "float", "W1", above=0.01))
        self.assertEqual(accuracy.first_failure("b", "float", "W1", above=0.01), 1.0)

    def test_a_number_that_is_not_finite_is_a_failure(self):
        accuracy = Accuracy([made.accuracy_record(nonfinite=1)])
        self.assertEqual(accuracy.first_failure("wald", "float", "W1"), 1.0)

    def test_a_method_with_one_missed_ray_is_not_watertight(self):
        records = [made.accuracy_record(method="a"), made.accuracy_record(method="b", missed_rays=1)]
        self.assertEqual(answers.watertight_methods(Accuracy(records), "float"), ["a"])

    def test_a_line_stands_out_where_it_leaves_the_middle(self):
        lines = {"a": [1.0, 1.0], "b": [1.1, 1.2], "c": [1.0, 50.0], "d": [1.0, NO_HIT], "e": [None, 1.0]}
        self.assertEqual(chart_difficulty.standing_out(lines), ["d", "c"])


class KernelTest(unittest.TestCase):
    def kernels(self, **ns):
        """Six rounds of each method; ns by method, the n-th round being n % slower for all."""
        return Kernels([
            made.kernel_record(method=method, round=n, seconds=made.seconds_of(value * (1 + n / 100)))
            for method, value in ns.items() for n in range(6)
        ])  # fmt: skip

    def test_a_round_is_the_median_of_its_samples_over_tests_and_passes(self):
        kernels = Kernels([made.kernel_record(tests=1000, iterations=10, seconds=[1.0, 5e-5, 1e-9])])
        self.assertAlmostEqual(kernels.ns(Kernel("wald", "base", "float"), Workload("random")).value, 5.0)

    def test_a_price_is_of_the_same_rounds_so_that_a_drift_of_all_does_not_matter(self):
        price = self.kernels(slow=11, fast=10).price(Kernel("slow", "base", "float"), Kernel("fast", "base", "float"), Workload("random"))
        for value in (price.value, price.low, price.high):
            self.assertAlmostEqual(value, 10.0)

    def test_rounds_that_are_not_valid_do_not_count(self):
        kernels = Kernels([made.kernel_record(), made.kernel_record(round=1, valid=False, seconds=[9.0])])
        self.assertAlmostEqual(kernels.ns(Kernel("wald", "base", "float"), Workload("random")).value, 5.0)
        self.assertEqual(kernels.invalid_count, 1)

    def test_a_parameter_that_is_not_a_number_is_none(self):
        kernels = Kernels([made.kernel_record(parameter=float("nan")), made.kernel_record(parameter=None)])
        self.assertEqual(kernels.workloads, [Workload("random")])

    def test_methods_whose_rounds_overlap_are_not_told_apart(self):
        records = [
            made.kernel_record(method=m, round=n, seconds=made.seconds_of(v + (n % 2 if m == "b" else 0)))
            for m, v in (("a", 10), ("b", 9.8), ("c", 20)) for n in range(8)
        ]  # fmt: skip
        kernels = Kernels(records)
        self.assertEqual([k.method for k in answers.not_told_apart(kernels, "float", Workload("random"))], ["b"])

    def test_the_price_of_a_fix_is_of_the_dear_value_whichever_is_the_base(self):
        fix = next(f for f in chart_price.FIXES if f.factor == "reciprocal")
        newton = made.VARIANT | {"reciprocal": "newton"}
        pair = [made.kernel_record(seconds=made.seconds_of(12)), made.kernel_record(change="reciprocal=newton", variant=newton, seconds=made.seconds_of(10))]  # fmt: skip
        other = [made.kernel_record(variant=newton, seconds=made.seconds_of(10)), made.kernel_record(change="reciprocal=exact", seconds=made.seconds_of(12))]  # fmt: skip
        for records in (pair, other):
            prices = chart_price.factor_prices(Kernels(records), Workload("random"), fix)
            self.assertEqual([round(p.percent.value, 6) for p in prices], [20.0])

    def test_errors_of_sampling_are_told_apart_from_those_of_rounding(self):
        sampled, rounded = list(made.sampling_records()), list(made.pixel_records())
        errors = chart_sampling.edge_errors(sampled + rounded)
        self.assertEqual(sorted(errors), [("chair", "circle"), ("chair", "grid"), ("ice", "circle"), ("ice", "grid")])
        self.assertAlmostEqual(errors["ice", "circle"][4], 0.05)
        self.assertEqual(chart_sampling.wins(errors, "circle", "grid"), (8, 8))
        self.assertEqual(chart_sampling.wins(errors, "grid", "circle"), (0, 8))
        self.assertIsNone(chart_sampling.sampling_chart(rounded))
        self.assertEqual(chart_pixels.pixel_charts(sampled, Looks(made.METHODS)), [])

    def test_the_worst_case_is_of_kernels_without_early_outs_where_there_are_any(self):
        at_all_hits = [made.kernel_record(protocol="worst-case", parameter=1.0, seconds=made.seconds_of(9))]
        without = made.VARIANT | {"early_out": "no"}
        slower = made.kernel_record(protocol="worst-case", parameter=0.5, change="early_out=no", variant=without, seconds=made.seconds_of(7))
        groups = chart_speed.groups_of(Kernels([*at_all_hits, slower]), None)
        bars = {title: [bar.value for bar in bars] for (title, _), bars in groups.items() if title.startswith("no early out")}
        self.assertEqual(
            {title: [round(value, 6) for value in values] for title, values in bars.items()},
            {"no early out, float, worst-case 0.5": [7.0], "no early out, float, worst-case 1": [9.0]},
        )

    def test_errors_are_means_in_millionths_of_the_nearest_to_an_ordinary_case(self):
        far = made.accuracy_record(case="F1", mesh_rays=0, t_error=made.error(16.0), weight_error=made.error(32.0))
        accuracy = Accuracy([made.accuracy_record(), far])
        of_t, of_weights = (chart_speed.error_bars(accuracy, "float", error)[0].value for error in ("t_error", "weight_error"))
        self.assertAlmostEqual(of_t, 8 * 2.0**-23 * 1e6)
        self.assertAlmostEqual(of_weights, 16 * 2.0**-23 * 1e6)

    def test_bars_stand_from_the_fastest_to_the_slowest(self):
        kernels = self.kernels(b=3, a=2, c=5)
        bars = chart_speed.time_bars(kernels, Workload("random"), lambda k, r: True)
        self.assertEqual([bar.name for bar in bars], ["a", "b", "c"])

    def test_a_front_holds_what_is_fast_or_right(self):
        kernels = self.kernels(fast=1, right=2, neither=3)
        accuracy = Accuracy([made.accuracy_record(method=m, t_error=made.error(e)) for m, e in (("fast", 9.0), ("right", 1.0), ("neither", 5.0))])  # fmt: skip
        front = front_of(points_of(accuracy, kernels, Workload("random"), "W", error_point))
        self.assertEqual([p.kernel.method for p in front], ["fast", "right"])


class MapTest(unittest.TestCase):
    def test_triangles_are_counted_in_the_cells_where_they_lie(self):
        record = {"x": [1.0, 0.01], "y": [1.0, 100.0], "hits": [[10, 10], [10, 10]], "false_misses": [[0, 5], [0, 0]]}
        scene = {"x": [0.01, 0.012, 1.0, 0.01, 1e9], "y": [1.0, 1.1, 1.0, 100.0, 1.0]}
        self.assertEqual(chart_map.share_beyond(record, scene), 0.4)


class Look(unittest.TestCase):
    def test_no_two_methods_look_alike(self):
        looks = Looks(made.METHODS)
        self.assertEqual(len({looks[m] for m in made.METHODS}), len(made.METHODS))

    def test_an_inline_picture_has_ids_of_its_own_and_the_pages_colours(self):
        inline = Inline()
        svg = '<?xml?><svg width="9pt" height="9pt"><g id="a"><path id="m" style="fill: #1b1f24"/><use href="#m"/></g></svg>'
        self.assertEqual(inline.picture(svg, "p"), '<svg class="chart"><g><path id="p-m" class="s0"/><use href="#p-m"/></g></svg>')
        self.assertEqual(inline.style(), ".s0{fill:var(--c1b1f24)}")
        self.assertIn("#1b1f24", DARK)


class Answers(unittest.TestCase):
    def test_the_answers_name_the_fastest_the_safest_and_the_price(self):
        accuracy = Accuracy([made.accuracy_record(method="quick_one", missed_rays=100, false_misses=100), made.accuracy_record(method="tight_one")])  # fmt: skip
        kernels = Kernels([
            made.kernel_record(method=m, round=n, seconds=made.seconds_of(v)) for m, v in (("quick_one", 4), ("tight_one", 5)) for n in range(6)
        ])  # fmt: skip
        fastest, safest, cost, breaks = (answer.sentences for answer in answers.answers(accuracy, kernels))
        self.assertIn("quick_one, 4 ns a test", fastest[0])
        self.assertIn("only tight_one lets no ray through", safest[0])
        self.assertIn("tight_one takes 25 % (25 to 25) more time than quick_one", cost[0])
        self.assertEqual(breaks[0], "Float: every method holds in no case, and every one breaks in none.")
        self.assertEqual(breaks[1:], ["quick_one, float, of the other 1: W1 from 1.", "tight_one, float, of the other 1: holds in all."])

    def test_safety_that_costs_nothing_is_told_with_those_that_are_not_slower(self):
        accuracy = Accuracy([made.accuracy_record(method="tight"), made.accuracy_record(method="leaks", missed_rays=9)])
        for unsteady, words in ((4.8, ""), (5.5, ", not told apart from leaks")):
            tight = [4.8] * 5 + [unsteady] * 3
            rounds = [("tight", n, ns) for n, ns in enumerate(tight)] + [("leaks", n, 5.0) for n in range(8)]
            kernels = Kernels([made.kernel_record(method=m, round=n, seconds=made.seconds_of(ns)) for m, n, ns in rounds])
            self.assertEqual(answers.cost_of_safety(accuracy, kernels), [f"Nothing, float: tight is the safest and the fastest{words} (random rays)."])

    def test_a_watertight_method_is_safer_than_one_that_breaks_less_often(self):
        broken = [made.accuracy_record(method="tight", case=c, mesh_rays=0, false_misses=500) for c in ("S1", "S2")]
        meshes = [made.accuracy_record(method="tight"), made.accuracy_record(method="leaks", missed_rays=500)]
        self.assertEqual(answers.safest_method(Accuracy(broken + meshes), "float"), "tight")

    def test_what_was_not_given_is_said(self):
        words = [answer.sentences[0] for answer in answers.answers(None, None)]
        self.assertIn("No kernel run was given", words[0])
        self.assertIn("No accuracy run was given", words[1])


if __name__ == "__main__":
    unittest.main()
