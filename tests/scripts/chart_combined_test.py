"""What the intersection study says of changes that are combined, on records that are made up."""

import math
import pathlib
import sys
import unittest

HERE = pathlib.Path(__file__).resolve().parent
SCRIPTS = HERE.parent.parent / "scripts"
sys.dont_write_bytecode = True
sys.path[:0] = [str(SCRIPTS), str(HERE)]

import made_records as made  # noqa: E402
from study_charts import chart_combined, numbers  # noqa: E402
from study_charts.accuracy import Accuracy  # noqa: E402
from study_charts.chart_cost import error_point, points_of  # noqa: E402
from study_charts.kernels import Kernel, Kernels, Workload  # noqa: E402


class CombinedTest(unittest.TestCase):
    def records(self, **ns):
        """Kernels of one method by their change."""
        return [made.kernel_record(change=change, seconds=made.seconds_of(value)) for change, value in ns.items()]

    def test_changes_are_of_the_formula_or_of_its_form(self):
        kernel = Kernel("wald", "rays=8,division=late,edges=strict,isa=avx2", "float")
        self.assertEqual((kernel.factors, kernel.form), (("division=late", "edges=strict"), ("rays=8", "isa=avx2")))
        star = ("base", "division=late", "rays=8", "triangles=8,layout=soa", "rays=8,isa=avx2")
        self.assertFalse(any(Kernel("wald", change, "float").combines for change in star))
        self.assertTrue(all(Kernel("wald", change, "float").combines for change in ("division=late,edges=strict", "rays=8,edges=strict")))

    def test_what_is_expected_is_the_product_of_single_changes_of_the_same_form(self):
        kernels = Kernels(self.records(**{
            "base": 10, "division=late": 8, "edges=strict": 5, "division=late,edges=strict": 6,
            "rays=8": 2, "rays=8,division=late": 1, "rays=8,edges=strict": 2, "rays=8,division=late,edges=strict": 1,
            "order=distance_first,edges=strict": 3,
        }))  # fmt: skip
        found = chart_combined.combined_on(kernels, Workload("random"))
        self.assertEqual([round(v.expected, 9) for v in found], [0.4, 0.5])
        self.assertEqual([round(v.found, 9) for v in found], [0.6, 0.5])
        self.assertEqual([round(v.gap, 9) for v in found], [1.5, 1.0])
        self.assertEqual([v.noise for v in found], [math.inf, math.inf], "one round has no interval")
        self.assertEqual(list(chart_combined.groups_of(kernels)), [((), "wald"), (("rays=8",), "wald")])

    def test_noise_of_ratios_adds_up_in_squares(self):
        ratio = numbers.Estimate(1.0, math.exp(-0.03), math.exp(0.03))
        other = numbers.Estimate(1.0, math.exp(-0.04), math.exp(0.04))
        self.assertAlmostEqual(chart_combined.noise_of([ratio, other]), math.exp(0.05))
        self.assertEqual(chart_combined.form_text(("rays=8", "isa=avx2")), "8 rays at once, avx2")

    def test_combined_kernels_are_none_of_the_star(self):
        kernels = Kernels(self.records(**{"base": 10, "division=late": 8, "division=late,edges=strict": 6}))
        self.assertEqual([k.change for k in kernels.kernels()], ["base", "division=late"])

    def test_a_combination_fails_more_where_no_single_change_comes_near(self):
        cells = {"base": 0, "division=late": 10, "edges=strict": 0, "division=late,edges=strict": 500}
        records = [made.accuracy_record(case="S1", mesh_rays=0, change=c, false_misses=n) for c, n in cells.items()]
        self.assertEqual(chart_combined.failing_more(Accuracy(records))[:24], "Failures: in 1 of 1 cell")
        self.assertIsNone(chart_combined.failing_more(Accuracy(records[:3])))

    def test_combined_changes_are_no_marks_of_time_against_failures(self):
        changes = ("base", "division=late", "division=late,edges=strict")
        kernels = Kernels(self.records(**dict.fromkeys(changes, 10)))
        accuracy = Accuracy([made.accuracy_record(change=change) for change in changes])
        points = points_of(accuracy, kernels, Workload("random"), "W", error_point)
        self.assertEqual([p.kernel.change for p in points], ["base", "division=late"])


if __name__ == "__main__":
    unittest.main()
