// Bad input gets a sentence that says what and where, exit code 2, and nothing written.
#include <gtest/gtest.h>

#include "tests/program/program.h"

namespace raysweep {
namespace {

class BadInput : public testing::Test {
 public:
  TemporaryFolder folder;

  /// `render` with these options is refused, for a reason that contains `sentence`.
  void expect_no_picture(std::vector<std::string> options, const std::string& sentence) const {
    options.insert(options.begin(), {"render", "--out", folder.file("picture.png")});
    expect_refused(options, sentence);
  }

  /// `run` of a config with this text is refused.
  void expect_no_run(const std::string& text, const std::string& sentence,
                     std::vector<std::string> options = {}) const {
    options.insert(options.begin(), {"run", folder.write("sweep.toml", "experiment = \"x\"\n" + text),
                                     "--out", folder.file("out")});
    expect_refused(options, sentence);
  }

  void expect_refused(const std::vector<std::string>& arguments, const std::string& sentence) const {
    const size_t before = folder.entries();
    const ProgramResult result = run_program(arguments);
    EXPECT_EQ(result.exit_code, 2) << result.err;
    EXPECT_NE(result.err.find(sentence), std::string::npos)
        << "said: " << result.err << "\nnot:  " << sentence;
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(folder.entries(), before) << "something was written";
  }

  void expect_bad_mesh(const std::string& name, const std::string& text, const std::string& sentence) const {
    const std::string mesh = folder.write(name, text);
    expect_no_picture({"--scene", mesh}, sentence);
    expect_no_run("[scene]\nfile = \"" + name + "\"\n", sentence);
  }
};

TEST_F(BadInput, no_such_scene) {
  expect_no_picture({"--scene", "chair-bell"},
                    "no scene \"chair-bell\": it is neither built in (those are: chair-ball, studio, ");
  expect_no_run("[scene]\nname = \"chair-bell\"\n", "sweep.toml:2: no scene \"chair-bell\"");
}

TEST_F(BadInput, a_scene_file_with_errors_tells_them_all) {
  const std::string scene = folder.write(
      "s.toml", "[[objects]]\nshape = \"sphere\"\ncentre = [0, 0]\nradius = -1\nmaterial = \"glas\"\n");
  for (const char* sentence : {"s.toml:3: ", "s.toml:4: ", "s.toml:5: "}) {
    expect_no_picture({"--scene", scene}, sentence);
    expect_no_run("[scene]\nfile = \"s.toml\"\n", sentence);
  }
}

TEST_F(BadInput, more_lights_than_a_scene_file_has) {
  const std::string scene = folder.write("s.toml",
                                         "[camera]\nposition = [0, 2, 5]\ntarget = [0, 0, 0]\n[materials.a]\n"
                                         "[[objects]]\nshape = \"sphere\"\ncentre = [0, 0, 0]\nradius = 1\n"
                                         "material = \"a\"\n");
  expect_no_picture({"--scene", scene, "--lights", "2"}, "has 0 lights, 2 were asked for");
  expect_no_run("[scene]\nfile = \"s.toml\"\nmodes = [\"hard\"]\n", "has 0 lights, 2 were asked for");
}

TEST_F(BadInput, references_that_are_none) {
  expect_no_picture({"--reference", folder.file("none.exr")}, "none.exr");
  expect_no_picture({"--reference", folder.write("a.exr", "no picture")}, "a.exr");
  ASSERT_EQ(run_program({"render", "--width", "8", "--height", "8", "--out", folder.file("r.exr")}).exit_code,
            0);
  expect_no_picture({"--width", "9", "--height", "8", "--reference", folder.file("r.exr")},
                    "is 8 × 8, the picture 9 × 8; they must be equal");
  const std::string reference = folder.file("r.exr"), before = read_file(reference);
  expect_refused({"render", "--width", "8", "--height", "8", "--reference", reference, "--out", reference},
                 "is the reference itself, which would be lost");
  EXPECT_EQ(read_file(reference), before);
}

TEST_F(BadInput, tolerances_and_branches_out_of_range) {
  expect_no_picture({"--pixel-tolerance", "nan"},
                    "pixel_tolerance = nan is not possible: a number from 0 to 1");
  expect_no_picture({"--pixel-tolerance", "-0.1"}, "pixel_tolerance = -0.1 is not possible");
  expect_no_picture({"--branches", "0"}, "branches = 0 is out of range: a whole number from 1 to 1048576");
}

#if RAYSWEEP_HAS_ASSIMP
TEST_F(BadInput, a_mesh_that_is_none) {
  expect_bad_mesh("a.obj", "this is no mesh\n", "a.obj: ");
  expect_bad_mesh("b.xyz", "v 0 0 0\n", "b.xyz: cannot be read as a mesh");
  expect_bad_mesh("c.ply", "ply\nformat ascii 1.0\nelement vertex 3\n", "c.ply: ");
}

TEST_F(BadInput, a_mesh_that_ends_too_early) {
  expect_bad_mesh("a.ply",
                  "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
                  "float z\nend_header\n0 0 0\n1",
                  "a.ply: ");
  expect_bad_mesh("b.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex", "b.stl: ");
  expect_bad_mesh("c.gltf", "{\"asset\":{\"version\":\"2.0\"},\"scene\":0", "c.gltf: ");
}

TEST_F(BadInput, an_empty_mesh) {
  expect_bad_mesh("a.obj", "", "a.obj: ");
  expect_bad_mesh("b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "b.obj: ");
  expect_bad_mesh("c.stl", "", "c.stl: ");
}

TEST_F(BadInput, a_mesh_with_nan_or_infinity) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  expect_bad_mesh("a.ply", ply + "0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n", "is not finite");
  expect_bad_mesh("b.ply", ply + "0 0 0\n1 0 inf\n0 1 0\n3 0 1 2\n", "is not finite");
  expect_bad_mesh("c.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n", "c.obj: ");
}

TEST_F(BadInput, a_mesh_with_indices_out_of_range) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n";
  expect_bad_mesh("a.ply", ply + "3 0 1 3\n", "a.ply: ");
  expect_bad_mesh("b.ply", ply + "3 0 1 -1\n", "b.ply: ");
  expect_bad_mesh("c.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", "c.obj: ");
}
#endif

TEST_F(BadInput, unknown_keys_options_and_verbs) {
  expect_no_run("sped = 1\n", "sweep.toml:2: unknown key \"sped\"; possible: experiment");
  expect_no_run("", "--set sped=1:1: unknown key \"sped\"", {"--set", "sped=1"});
  expect_no_picture({"--dpeth", "3"}, "--dpeth");
  expect_refused({"rnu"}, "unknown verb \"rnu\"; possible: run, render, list");
  expect_refused({}, "subcommand");
  expect_refused({"list", "shedulers"}, "shedulers");
}

TEST_F(BadInput, thread_counts_that_cannot_be) {
  for (const char* threads : {"0", "-1", "1000000000"}) {
    expect_no_picture(
        {"--scheduler", "thread_static", "--threads", threads},
        std::string("threads = ") + threads + " is out of range: a whole number from 1 to 1024 is possible");
    expect_no_run(std::string("[sweep]\nthreads = ") + threads + "\n",
                  std::string("sweep.toml:3: threads = ") + threads + " is out of range");
  }
}

TEST_F(BadInput, numbers_out_of_range) {
  expect_no_picture({"--width", "0"},
                    "width = 0 is out of range: a whole number from 1 to 32768 is possible");
  expect_no_picture({"--height", "-5"}, "height = -5 is out of range");
  expect_no_picture({"--depth", "1025"}, "depth = 1025 is out of range");
  expect_no_picture({"--subpixels", "many"}, "subpixels = many is not a whole number");
  expect_no_picture({"--lights", "65"},
                    "lights = 65 is out of range: a whole number from 0 to 64 is possible");
  expect_no_picture({"--frames", "0"}, "--frames");
  expect_no_run("[sweep]\nwidth = 0\n", "sweep.toml:3: width = 0 is out of range");
}

TEST_F(BadInput, an_output_that_cannot_be_written) {
  const std::string file = folder.write("a_file", "");
  expect_refused({"render", "--out", file + "/picture.png"}, "there is no folder");
  expect_refused({"render", "--out", "/proc/picture.png"}, "/proc/picture.png: cannot be written");
  expect_refused({"render", "--out", folder.file("picture.jpg")}, "pictures are written as .png");
  const std::string config = folder.write("sweep.toml", "experiment = \"x\"\n");
  expect_refused({"run", config, "--out", file}, "choose another folder with --out");
  expect_refused({"run", config, "--out", file + "/run"}, "choose another folder with --out");
  expect_refused({"run", config, "--out", "/proc/run"}, "choose another folder with --out");
}

TEST_F(BadInput, experiments_and_runs_that_are_not_there) {
  expect_refused({"run", folder.file("none.toml")}, "no such experiment: name a TOML file");
  expect_refused({"report", folder.file("none")}, "no run is here");
  expect_refused({"run", folder.write("sweep.toml", "experiment = \"x\"\n"), "--resume"},
                 "--resume goes on with the run in --out");
}

TEST_F(BadInput, every_config_is_checked_before_anything_runs) {
  const std::string good = folder.write("good.toml", "experiment = \"good\"\n"),
                    bad = folder.write("bad.toml", "experiment = \"bad\"\nx = 1\n");
  expect_refused({"run", good, bad, "--out", folder.file("out")}, "bad.toml:2: unknown key \"x\"");
}

TEST_F(BadInput, a_launch_without_a_cell) {
  expect_refused({"launch", "--cell", "nonsense"}, "--cell must be a JSON object");
  expect_refused({"launch", "--cell", "{}"}, "--cell must be a JSON object");
}

}  // namespace
}  // namespace raysweep
