#include "results/statistics/scaling_laws.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "results/published.h"
#include "results/tables/scaling_laws_tables.h"
#include "results/tables/tables.h"
#include "tests/results/make_record.h"

namespace raysweep {
namespace {

double usl(double fps_of_one, double sigma, double kappa, double n) {
  return fps_of_one * n / (1 + sigma * (n - 1) + kappa * n * (n - 1));
}

std::vector<ScalingPoint> curve(double sigma, double kappa, int most = 8) {
  std::vector<ScalingPoint> points;
  for (int n = 1; n <= most; ++n) points.push_back({n, usl(5, sigma, kappa, n)});
  return points;
}

/// Karp & Flatt 1990, example in the text: the serial share of Amdahl's law comes back.
TEST(karp_flatt, gives_back_amdahls_serial_share) {
  for (const int p : {2, 4, 64}) EXPECT_NEAR(*karp_flatt(1 / (0.1 + 0.9 / p), p), 0.1, 1e-12) << p;
  EXPECT_LT(*karp_flatt(4.4, 4), 0) << "superlinear";
  EXPECT_FALSE(karp_flatt(1.0, 1));
  const auto e = karp_flatt(Estimate{2, Estimate::Bounds{1.6, 3.2}, 7}, 4);
  EXPECT_NEAR(e->value, (0.5 - 0.25) / 0.75, 1e-12);
  EXPECT_NEAR(e->interval->low, (1 / 3.2 - 0.25) / 0.75, 1e-12) << "more speedup, less of a share";
  EXPECT_NEAR(e->interval->high, (1 / 1.6 - 0.25) / 0.75, 1e-12);
}

TEST(scaling_laws, exact_curves_give_back_their_parameters) {
  const std::pair<double, double> parameters[] = {{0.05, 0.002}, {0.3, 0}, {0, 0.01}, {-0.02, 0.003}};
  for (const auto& [sigma, kappa] : parameters) {
    const ScalingLaws laws = fit_scaling_laws(curve(sigma, kappa), 8);
    EXPECT_NEAR(laws.usl->fps_of_one, 5, 1e-8);
    EXPECT_NEAR(laws.usl->serial_share.value, sigma, 1e-8);
    EXPECT_NEAR(laws.usl->coherence->value, kappa, 1e-8);
    EXPECT_NEAR(laws.usl->serial_share.interval->high, sigma, 1e-6);
    EXPECT_EQ(laws.usl->superlinear, sigma < 0) << sigma;
  }
  EXPECT_NEAR(fit_scaling_laws(curve(0.3, 0), 8).amdahl->serial_share.value, 0.3, 1e-8);
}

TEST(scaling_laws, the_peak_is_marked_where_it_was_not_measured) {
  const auto inside = fit_scaling_laws(curve(0.1, 0.05), 8).usl,
             beyond = fit_scaling_laws(curve(0.1, 0.001), 8).usl;
  EXPECT_NEAR(*inside->peak_threads, std::sqrt(0.9 / 0.05), 1e-6);
  EXPECT_FALSE(inside->extrapolated);
  EXPECT_NEAR(*beyond->peak_threads, 30, 1e-4);
  EXPECT_TRUE(beyond->extrapolated);
  EXPECT_FALSE(fit_scaling_laws(curve(0.1, -0.001), 8).usl->peak_threads);
}

TEST(scaling_laws, hyper_threads_are_another_regime) {
  auto points = curve(0.05, 0.002);
  for (int n = 9; n <= 16; ++n) points.push_back({n, 1});
  EXPECT_NEAR(fit_scaling_laws(points, 8).usl->serial_share.value, 0.05, 1e-8);
}

TEST(scaling_laws, fewer_than_six_thread_counts_are_refused_with_the_reason) {
  EXPECT_EQ(fit_scaling_laws(curve(0.1, 0, 5), 8).refused,
            "not fitted: 5 thread counts up to 8 cores, 6 are needed");
  EXPECT_EQ(fit_scaling_laws(curve(0.1, 0, 8), 1).refused,
            "not fitted: 1 thread count up to 1 cores, 6 are needed");
  auto twice = curve(0.1, 0, 5);
  twice.push_back(twice.back());
  EXPECT_FALSE(fit_scaling_laws(twice, 8).usl) << "the same count again is none more";
}

/// Morozov 2011, table 3, up to the six cores of its machine. Expected: Python 3.11, SciPy 1.10.1,
/// curve_fit(lambda N, l, s, k: l + log(N) - log(1 + s*(N-1) + k*N*(N-1)), N, log(X), p0=(log(X[0]), .01,
/// .001), xtol=1e-14, ftol=1e-14), intervals by stats.t.ppf(.975, 3)*sqrt(diag(cov)); Amdahl likewise without
/// k, t.ppf(.975, 4).
struct Expected {
  const char* mode;
  double fps_of_one, sigma, sigma_low, sigma_high, kappa, kappa_low, kappa_high;
  double amdahl, amdahl_low, amdahl_high;
};
const Expected morozov[] = {
    {"low", 6.893610509369124, 0.012589422991232953, -0.00904836399487292, 0.03422720997733883,
     -0.0011780772681111976, -0.0046797918742271884, 0.0023236373380047933, 0.005525493936561972,
     0.0009448253280520931, 0.01010616254507185},
    {"very_hard", 0.2721251878757145, -0.0037115867800350307, -0.009824462300114422, 0.0024012887400443597,
     0.0012609211275309735, 0.00027024491041228375, 0.002251597344649663, 0.0038481202312724274,
     0.001030017241710254, 0.006666223220834601}};

TEST(scaling_laws, of_morozov_2011_are_those_of_scipy) {
  const auto modes = published_fps(std::filesystem::path(RAYSWEEP_SOURCE_DIR) /
                                   "results/published/morozov2011_table3_openmp_fps.csv");
  for (const Expected& e : morozov) {
    const auto mode = std::ranges::find(modes, e.mode, &PublishedFps::mode);
    ASSERT_NE(mode, modes.end());
    std::vector<ScalingPoint> points;
    for (const auto& [threads, fps] : mode->by_threads) points.push_back({threads, fps});
    const ScalingLaws laws = fit_scaling_laws(points, 6);
    EXPECT_EQ(laws.points, 6);
    EXPECT_NEAR(laws.usl->fps_of_one, e.fps_of_one, 1e-6);
    const auto near = [](const Estimate& got, double value, double low, double high) {
      EXPECT_NEAR(got.value, value, 1e-7);
      EXPECT_NEAR(got.interval->low, low, 1e-6);
      EXPECT_NEAR(got.interval->high, high, 1e-6);
    };
    near(laws.usl->serial_share, e.sigma, e.sigma_low, e.sigma_high);
    near(*laws.usl->coherence, e.kappa, e.kappa_low, e.kappa_high);
    near(laws.amdahl->serial_share, e.amdahl, e.amdahl_low, e.amdahl_high);
    EXPECT_FALSE(laws.usl->superlinear) << "a parameter below 0 whose interval holds 0 shows nothing";
    EXPECT_EQ(laws.usl->peak_threads.has_value(), e.kappa_low > 0);
  }
}

std::vector<CellRow> rows_of(int most_threads, int cores, double kappa = 0.001) {
  std::vector<Record> records, planned;
  for (int round = 0; round < 7; ++round) {
    records.push_back(make_record("serial", 1, round, 1));
    for (int n = 1; n <= most_threads; ++n)
      records.push_back(make_record("omp_static", n, round, 1 / usl(1, 0.1, kappa, n)));
  }
  for (Record& r : records) r.machine = {"host", "cpu", 2 * cores, cores, 0};
  for (const Record& r : records) {
    if (r.round == 0) planned.push_back(r);
  }
  return summarise(records, planned, 0.5);
}

TEST(scaling_laws_table, has_karp_flatt_by_threads_and_the_laws_once) {
  const Table table = scaling_laws_table(rows_of(7, 6));
  ASSERT_EQ(table.rows.size(), 7u) << "serial alone is no group";
  EXPECT_EQ(table.columns[3].title, "Karp–Flatt");
  EXPECT_EQ(table.rows[0][3], "–");
  EXPECT_EQ(table.rows[1][3], "10.2 % [10.2, 10.2]") << "σ + κ·p";
  EXPECT_EQ(table.rows[0][5], "10.0 % [10.0, 10.0]");
  EXPECT_EQ(table.rows[0][6], "0.001 [0.001, 0.001]");
  EXPECT_EQ(table.rows[0][7], "30 threads (extrapolated)");
  EXPECT_EQ(table.rows[1][5], "");
  EXPECT_EQ(scaling_laws_data(rows_of(7, 6)).rows.size(), 7u);
}

TEST(scaling_laws_table, says_why_there_is_no_law_and_when_a_curve_is_superlinear) {
  EXPECT_EQ(scaling_laws_table(rows_of(7, 2)).rows[0].back(),
            "not fitted: 2 thread counts up to 2 cores, 6 are needed");
  EXPECT_EQ(scaling_laws_table(rows_of(7, 6, -0.001)).rows[0].back(), "USL: superlinear (κ is negative)");
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(tables, are_written_the_same_each_time_with_frames_and_laws) {
  const auto folder = std::filesystem::temp_directory_path() / ("raysweep_laws_" + std::to_string(getpid()));
  write_tables(rows_of(3, 2), {"test", "title"}, folder / "a");
  write_tables(rows_of(3, 2), {"test", "title"}, folder / "b");
  for (const char* file : {"scaling.md", "frames.md", "frames.csv", "laws.md", "laws.csv"}) {
    EXPECT_FALSE(text_of(folder / "a" / file).empty()) << file;
    EXPECT_EQ(text_of(folder / "a" / file), text_of(folder / "b" / file)) << file;
  }
  write_tables(rows_of(1, 2), {"test", "title"}, folder / "c");
  EXPECT_FALSE(std::filesystem::exists(folder / "c/laws.md")) << "one thread count";
  std::filesystem::remove_all(folder);
}

TEST(scaling_laws_table, is_shown_where_a_law_was_fitted) {
  const auto shown = [](const std::vector<CellRow>& rows) {
    return tables_as_text(rows, {"test", "title"}).find("Karp–Flatt") != std::string::npos;
  };
  EXPECT_TRUE(shown(rows_of(6, 6)));
  EXPECT_FALSE(shown(rows_of(6, 2)));
}

}  // namespace
}  // namespace raysweep
