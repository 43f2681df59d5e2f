// Each verb, as a user calls it.
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "tests/program/program.h"

namespace raysweep {
namespace {

nlohmann::json json_of(const std::vector<std::string>& arguments) {
  const ProgramResult result = run_program(arguments);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out, nullptr, false);
  EXPECT_FALSE(json.is_discarded()) << "more than one JSON document on standard output: " << result.out;
  return json;
}

TEST(list, names_everything_with_what_is_missing_and_why) {
  for (const char* what : {"schedulers", "runtimes", "scenes", "modes", "methods", "patterns", "cores",
                           "accels", "precisions", "pins", "isas", "cases", "experiments"}) {
    const auto list = json_of({"list", what, "--json"});
    ASSERT_FALSE(list.empty()) << what;
    for (const auto& entry : list) {
      EXPECT_FALSE(entry.at("name").get<std::string>().empty());
      EXPECT_EQ(entry.at("available").get<bool>(), entry.at("reason").get<std::string>().empty());
    }
    EXPECT_FALSE(run_program({"list", what}).out.empty());
  }
  const auto scenes = json_of({"list", "scenes", "--json"});
  EXPECT_EQ(scenes[0]["name"], "chair-ball");
  EXPECT_EQ(scenes[0]["triangles"], 10817);
}

TEST(list, every_experiment_opens_with_its_question) {
  for (const auto& experiment : json_of({"list", "experiments", "--json"}))
    EXPECT_TRUE(experiment["summary"].get<std::string>().ends_with("?")) << experiment;
}

TEST(render, writes_the_picture_and_tells_its_numbers) {
  const TemporaryFolder folder;
  const auto r = json_of({"render", "--scene", "studio", "--width", "64", "--height", "48", "--depth", "3",
                          "--threads", "2", "--json", "--out", folder.file("p.png")});
  EXPECT_EQ(r["width"], 64);
  EXPECT_EQ(r["rays"]["primary"], 64 * 48);
  EXPECT_GT(r["rays"]["shadow"], 0);
  EXPECT_EQ(r["image_hash"].get<std::string>().size(), 32u);
  EXPECT_GT(r["fps"], 0);
  EXPECT_TRUE(read_file(folder.file("p.png")).starts_with("\x89PNG"));
  EXPECT_EQ(folder.entries(), 1u);
}

TEST(render, a_double_reference_tells_how_far_a_float_picture_is_off) {
  const TemporaryFolder folder;
  const std::string reference = folder.file("reference.exr");
  const std::vector<std::string> picture{"render",   "--scene", "ice",     "--width", "40",
                                         "--height", "32",      "--depth", "6",       "--json"};
  const auto render = [&](std::vector<std::string> more) {
    more.insert(more.begin(), picture.begin(), picture.end());
    return json_of(more);
  };
  EXPECT_FALSE(render({"--precision", "double", "--out", reference}).contains("difference"));
  const auto same =
      render({"--precision", "double", "--reference", reference, "--out", folder.file("a.exr")});
  EXPECT_EQ(same["difference"]["rmse"], 0);
  EXPECT_EQ(same["difference"]["differing_hits"], 0);
  EXPECT_EQ(read_file(reference), read_file(folder.file("a.exr"))) << "byte for byte";
  const auto rough = render({"--reference", reference, "--out", folder.file("b.png")});
  EXPECT_GT(rough["difference"]["rmse"], 0);
  EXPECT_EQ(rough["difference"]["non_finite"], 0);
  EXPECT_GT(rough["rays"]["refracted"], 100);
  EXPECT_GT(rough["peak_memory_bytes"], 1000000);
  const auto text = run_program({"render", "--scene", "ice", "--width", "40", "--height", "32", "--depth",
                                 "6", "--reference", reference, "--out", folder.file("b.png")});
  for (const char* part :
       {"refracted; ", "Mrays/s", "built in", "of memory", "depth limit: ", "against the reference: "})
    EXPECT_NE(text.out.find(part), std::string::npos) << text.out;
}

TEST(render, says_what_it_left_out) {
  const TemporaryFolder folder;
  const std::vector<std::string> picture{
      "render",  "--scene", "ice",        "--width", "16",    "--height",          "12",
      "--depth", "1024",    "--branches", "200",     "--out", folder.file("p.png")};
  const ProgramResult limited = run_program(picture);
  EXPECT_NE(limited.out.find("by the limit of rays a sample; no channel of any sample lacks more than"),
            std::string::npos)
      << limited.out;
  std::vector<std::string> with_tolerance = picture;
  with_tolerance.insert(with_tolerance.end(), {"--pixel-tolerance", "0.05", "--json"});
  const auto r = json_of(with_tolerance);
  EXPECT_GT(r["left_out"]["by_tolerance"], 0);
  EXPECT_EQ(r["left_out"]["lost_media"], 0);
}

TEST(render, a_scene_file_has_its_own_lights_and_the_first_of_them) {
  const TemporaryFolder folder;
  const std::string file =
      folder.write("s.toml",
                   "[camera]\nposition = [0, 2, 5]\ntarget = [0, 0, 0]\n[materials.a]\ncolour = [1, 1, 1]\n"
                   "[[objects]]\nshape = \"sphere\"\ncentre = [0, 0, 0]\nradius = 1\nmaterial = \"a\"\n"
                   "[[lights]]\nposition = [0, 9, 9]\n[[lights]]\nposition = [1, 9, 9]\n");
  const auto shadow_rays = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"render", "--scene", file, "--width", "16", "--height", "16", "--json",
                               "--out", folder.file("p.png")});
    return json_of(more)["rays"]["shadow"].get<int>();
  };
  const int two = shadow_rays({});
  EXPECT_GT(two, 50);
  EXPECT_LT(shadow_rays({"--lights", "1"}), two);
  EXPECT_EQ(shadow_rays({"--lights", "0"}), 0);
  EXPECT_EQ(shadow_rays({"--lights", "scene"}), two);
}

#if RAYSWEEP_HAS_ASSIMP
TEST(render, any_mesh_format_gives_the_same_picture) {
  const TemporaryFolder folder;
  // A pyramid, in three formats.
  const std::string obj =
      folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nv 0.3 1 0.3\nf 1 2 4\nf 2 3 4\nf 3 1 4\nf 1 3 2\n");
  const std::string ply = folder.write("a.ply",
                                       "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty "
                                       "float y\nproperty float z\nelement face 4\n"
                                       "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 "
                                       "0 1\n0.3 1 0.3\n3 0 1 3\n3 1 2 3\n3 2 0 3\n3 0 2 1\n");
  std::string stl = "solid a\n";
  for (const char* facet :
       {"0 0 0|1 0 0|0.3 1 0.3", "1 0 0|0 0 1|0.3 1 0.3", "0 0 1|0 0 0|0.3 1 0.3", "0 0 0|0 0 1|1 0 0"}) {
    std::string corners = facet;
    stl += "facet normal 0 0 0\nouter loop\n";
    size_t at = 0;
    for (size_t bar; at <= corners.size(); at = bar + 1) {
      bar = std::min(corners.find('|', at), corners.size());
      stl += "vertex " + corners.substr(at, bar - at) + "\n";
    }
    stl += "endloop\nendfacet\n";
  }
  stl = folder.write("a.stl", stl + "endsolid a\n");
  // glTF with its buffer inside: four positions, twelve 16-bit indices.
  const std::string gltf = folder.write(
      "a.gltf", R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
"buffers":[{"byteLength":72,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAAAAAAIA/mpmZPgAAgD+amZk+AAABAAMAAQACAAMAAgAAAAMAAAACAAEA"}],
"bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24}],
"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,1]},{"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}]})");
  std::set<std::string> hashes;
  for (const std::string& file : {obj, ply, stl, gltf}) {
    const auto r = json_of({"render", "--scene", file, "--width", "40", "--height", "30", "--json", "--out",
                            folder.file("p.png")});
    hashes.insert(r["image_hash"]);
    EXPECT_GT(r["rays"]["shadow"], 40) << file << " is not in the picture";
  }
  EXPECT_EQ(hashes.size(), 1u);
}
#endif

TEST(run, measures_checks_and_tells) {
  const TemporaryFolder folder;
  const std::string config =
      folder.write("sweep.toml",
                   "experiment = \"x\"\n[scene]\nmodes = [\"low\", \"middle\"]\n[sweep]\nscheduler = "
                   "[\"thread_static\"]\nthreads = [1, 2]\n"
                   "item = \"tiles:8\"\nwidth = 48\nheight = 32\n[measure]\nlaunches = 2\nseconds = 0.01\n");
  const auto all = json_of({"run", config, "--json", "--out", folder.file("out")});
  ASSERT_EQ(all.size(), 1u);
  EXPECT_TRUE(all[0]["complete"]);
  // Two modes of serial, 1 thread, 2 threads and co-run (where there are two processors), and a twin; twice.
  EXPECT_EQ(all[0]["launches"], 2 * (2 * 4 + 1));
  EXPECT_EQ(all[0]["rows"].size(), 6u);
  for (const char* file : {"config.toml", "plan.json", "machine.json", "records.jsonl", "tables/scaling.md",
                           "tables/scaling.csv", "tables/fps-thread_static.csv"}) {
    EXPECT_FALSE(read_file(folder.file(std::string("out/") + file)).empty()) << file;
  }
  std::istringstream records(read_file(folder.file("out/records.jsonl")));
  for (std::string line; std::getline(records, line);) {
    const auto r = nlohmann::json::parse(line);
    EXPECT_TRUE(r["valid"]);
    EXPECT_EQ(r["threads_seen"], r["threads"]);
    EXPECT_GT(r["rays"]["primary"], 0);
    EXPECT_FALSE(r["warmup_seconds"].empty());
  }
  const std::string before = read_file(folder.file("out/tables/scaling.csv"));
  std::filesystem::remove_all(folder.file("out/tables"));
  const ProgramResult report = run_program({"report", folder.file("out")});
  EXPECT_EQ(report.exit_code, 0);
  EXPECT_EQ(read_file(folder.file("out/tables/scaling.csv")), before) << "byte for byte from the records";
}

TEST(run, a_dry_run_prints_the_cells_and_writes_nothing) {
  const TemporaryFolder folder;
  const std::string config = folder.write(
      "sweep.toml", "experiment = \"x\"\n[sweep]\nscheduler = \"thread_static\"\nthreads = [1, 2]\n");
  const ProgramResult result = run_program({"run", config, "--dry-run", "--out", folder.file("out"), "--set",
                                            "measure.launches=3", "--seed", "9"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.out.find("each launched 3 times"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("seed 9"), std::string::npos);
  EXPECT_NE(result.out.find(" for the first rounds of all cells"), std::string::npos);
  EXPECT_EQ(folder.entries(), 1u);
  const auto json = json_of({"run", config, "--dry-run", "--json"});
  EXPECT_GT(json[0]["estimate_seconds"], 7 * 0.3 * 5) << "seven times five cells, 0.3 s each at least";
}

TEST(topology, shows_this_machine_and_others) {
  EXPECT_GT(json_of({"topology", "--json"})["pus"], 0);
  setenv("HWLOC_SYNTHETIC", "pack:1 core:6 pu:2", 1);
  const auto machine = json_of({"topology", "--json"});
  const ProgramResult text = run_program({"topology", "--threads", "13"});
  unsetenv("HWLOC_SYNTHETIC");
  EXPECT_EQ(machine["cores"], 6);
  EXPECT_EQ(machine["pus"], 12);
  EXPECT_EQ(machine["smt"], true);
  EXPECT_NE(text.out.find("1 more than there are processors (oversubscribed)"), std::string::npos)
      << text.out;
}

TEST(version, is_told) { EXPECT_EQ(run_program({"--version"}).exit_code, 0); }

}  // namespace
}  // namespace raysweep
