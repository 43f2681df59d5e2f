// What scene files that are wrong are told, to the letter.
#include <algorithm>

#include "tests/tracer/scene_folder.h"

namespace raysweep {
namespace {

using SceneFileErrors = SceneFolder;

TEST_F(SceneFileErrors, all_are_told_at_once_in_the_order_of_their_lines) {
  EXPECT_EQ(
      errors("[[objects]]\nshape = 'sphere'\nradiuss = 1\ncentre = [0, 0]\nradius = 0\n"
             "[materials.glass]\ncolor = [1, 1, 1]\n"),
      "scene.toml:1: a sphere needs the key \"material\"\n"
      "scene.toml:3: unknown key \"radiuss\" in a sphere; possible: centre, radius, material, shape\n"
      "scene.toml:4: centre must be three numbers [x, y, z], each from -1e+12 to 1e+12\n"
      "scene.toml:5: radius must be a number from 1e-12 to 1e+12\n"
      "scene.toml:7: unknown key \"color\" in material \"glass\"; possible: colour, ambient, diffuse, "
      "specular, k_ambient, k_diffuse, k_specular, exponent, k_reflect, k_refract, filter, ior, fresnel, "
      "priority");
}

TEST_F(SceneFileErrors, at_the_top) {
  EXPECT_EQ(errors("title = 1\nbackground = [0, 0, -1]\nambient = [nan, 0, 0]\nlight = 1\nobjects = []\n"),
            "scene.toml:1: title must be a string in quotes\n"
            "scene.toml:2: background must be a colour [red, green, blue], each from 0 to 1000000\n"
            "scene.toml:3: ambient must be a colour [red, green, blue], each from 0 to 1000000\n"
            "scene.toml:4: unknown key \"light\" in a scene; possible: title, background, ambient, camera, "
            "materials, objects, lights\n"
            "scene.toml:5: a scene needs an object at least: [[objects]]");
  EXPECT_EQ(errors(""), "scene.toml:1: a scene needs an object at least: [[objects]]");
  EXPECT_EQ(errors("camera = 1\nmaterials = [1]\nobjects = 3\nlights = [1]\n"),
            "scene.toml:1: camera must be a table: [camera]\n"
            "scene.toml:2: materials must be a table: [materials.NAME]\n"
            "scene.toml:3: objects must be a list of tables: [[objects]]\n"
            "scene.toml:4: a light must be a table: [[lights]]");
  EXPECT_EQ(errors("objects = [1]\nmaterials.m = 2\n"),
            "scene.toml:1: an object must be a table: [[objects]]\n"
            "scene.toml:2: m must be a table: [materials.m]");
}

TEST_F(SceneFileErrors, of_the_camera) {
  const std::string rest = material + sphere;
  EXPECT_EQ(errors("[camera]\nfov = 3\n" + rest),
            "scene.toml:1: a camera needs the key \"position\"\n"
            "scene.toml:1: a camera needs the key \"target\"\n"
            "scene.toml:2: unknown key \"fov\" in a camera; possible: position, target, up, field_of_view");
  EXPECT_EQ(errors("[camera]\nposition = [1, 2, 3]\ntarget = [1, 2, 3]\nup = [0, 0, 0]\n" + rest),
            "scene.toml:3: target must be another point than position\n"
            "scene.toml:4: up must not be [0, 0, 0]: it tells a direction");
  EXPECT_EQ(errors("[camera]\nposition = [0, 0, 0]\ntarget = [0, 0, 3]\nup = [0, 0, -2]\n" + rest),
            "scene.toml:4: up must not be parallel to the direction from position to target");
  EXPECT_EQ(errors("[camera]\nposition = [0, 5, 0]\ntarget = [0, 0, 0]\n" + rest),
            "scene.toml:1: up must not be parallel to the direction from position to target");
  for (const char* angle : {"0", "180", "-1", "nan", "'40'"}) {
    EXPECT_EQ(errors("[camera]\nposition = [0, 0, 1]\ntarget = [0, 0, 0]\nfield_of_view = " +
                     std::string(angle) + "\n" + rest),
              "scene.toml:4: field_of_view must be a number above 0 and below 180");
  }
  EXPECT_EQ(errors(material + "[[objects]]\nshape = 'plane'\nnormal = [0, 1, 0]\npoint = [0, 0, 0]\n"
                              "material = 'm'\n"),
            "scene.toml:2: planes have no end to frame: add a [camera]");
}

TEST_F(SceneFileErrors, of_materials) {
  EXPECT_EQ(errors("[materials.m]\ncolour = 'red'\nk_diffuse = -1\nexponent = inf\nior = 0\nfresnel = 1\n"
                   "priority = 1.5\nfilter = [1, 1]\nk_refract = 1e7\nk_reflect = [1]\n" +
                   sphere),
            "scene.toml:2: colour must be a colour [red, green, blue], each from 0 to 1000000\n"
            "scene.toml:3: k_diffuse must be a number from 0 to 1000000\n"
            "scene.toml:4: exponent must be a number from 0 to 1000000\n"
            "scene.toml:5: ior must be a number from 1e-06 to 1000000\n"
            "scene.toml:6: fresnel must be true or false\n"
            "scene.toml:7: priority must be a whole number from -1000000 to 1000000\n"
            "scene.toml:8: filter must be a colour [red, green, blue], each from 0 to 1000000\n"
            "scene.toml:9: k_refract must be a number from 0 to 1000000\n"
            "scene.toml:10: k_reflect must be a number from 0 to 1000000");
  EXPECT_EQ(errors("[materials.m]\n[materials.m]\n" + sphere),
            "scene.toml:2: not TOML: Error while parsing table header: cannot redefine existing table "
            "'materials.m'");
}

TEST_F(SceneFileErrors, of_shapes_and_names_of_materials) {
  EXPECT_EQ(errors("[[objects]]\n[[objects]]\nshape = 'spere'\n[[objects]]\nshape = 1\n" + sphere),
            "scene.toml:1: an object needs the key \"shape\"; possible: sphere, plane, box, triangles, mesh, "
            "chair\n"
            "scene.toml:3: unknown shape \"spere\"; possible: sphere, plane, box, triangles, mesh, chair\n"
            "scene.toml:5: shape must be a string in quotes\n"
            "scene.toml:10: unknown material \"m\"; possible: none, for there are no [materials.NAME]");
  EXPECT_EQ(errors("[materials.b]\n[materials.a]\n" + sphere),
            "scene.toml:7: unknown material \"m\"; possible: a, b");
  EXPECT_EQ(errors(material + sphere +
                   "[[objects]]\nshape = 'plane'\nnormal = [0, 0.0, 0]\npoint = [0, 0, 1e31]\n"
                   "material = 1\n"),
            "scene.toml:9: normal must not be [0, 0, 0]: it tells a direction\n"
            "scene.toml:10: point must be three numbers [x, y, z], each from -1e+12 to 1e+12\n"
            "scene.toml:11: material must be a string in quotes");
  EXPECT_EQ(errors(material + "[[objects]]\nshape = 'box'\nlower = [0, 0, 1]\nupper = [1, 1, 1]\n"
                              "rotate = [0, 400, 0]\nmaterial = 'm'\n"),
            "scene.toml:4: lower must be below upper on every axis, by more than floats round\n"
            "scene.toml:6: rotate must be three angles [x, y, z] in degrees, each from -360 to 360");
  EXPECT_EQ(
      errors(material + "[[objects]]\nshape = 'chair'\nmaterial = 'm'\nseat_material = 'n'\nscale = 0\n"),
      "scene.toml:5: unknown seat_material \"n\"; possible: m\n"
      "scene.toml:6: scale must be a number from 1e-12 to 1e+12");
  EXPECT_EQ(errors(material + "[[objects]]\nshape = 'chair'\nmaterial = 'm'\nscale = 1e12\n"
                              "translate = [0, 1e12, 0]\n"),
            "scene.toml:5: scaled and moved, mesh \"chair frame\" reaches beyond 1e+12");
}

TEST_F(SceneFileErrors, of_materials_that_would_make_light) {
  EXPECT_EQ(errors("[materials.m]\nk_refract = 0.6\nk_reflect = 0.5\n" + sphere),
            "scene.toml:3: k_reflect + k_refract must not exceed 1");
  EXPECT_EQ(errors("[materials.m]\nk_refract = 0.6\nfilter = [1, 1, 2]\n" + sphere),
            "scene.toml:3: filter must not exceed 1 in any channel");
}

TEST_F(SceneFileErrors, of_triangles) {
  const std::string start = material + "[[objects]]\nshape = 'triangles'\nmaterial = 'm'\n";
  EXPECT_EQ(
      errors(start + "vertices = [[0, 0, 0],\n[1, 0],\n[0, inf, 0]]\ntriangles = [[0, 1, 2],\n[0, 1, 3],\n"
                     "[0, -1, 2],\n[0, 1.0, 2], 7]\n"),
      "scene.toml:6: vertex 1 must be three numbers [x, y, z], each from -1e+12 to 1e+12\n"
      "scene.toml:7: vertex 2 must be three numbers [x, y, z], each from -1e+12 to 1e+12\n"
      "scene.toml:9: triangle 1 must be the numbers of three of the 3 vertices, counted from 0\n"
      "scene.toml:10: triangle 2 must be the numbers of three of the 3 vertices, counted from 0\n"
      "scene.toml:11: triangle 3 must be the numbers of three of the 3 vertices, counted from 0\n"
      "scene.toml:11: triangle 4 must be the numbers of three of the 3 vertices, counted from 0");
  EXPECT_EQ(errors(start + "vertices = 3\ntriangles = []\n"),
            "scene.toml:5: vertices must be a list of points [[x, y, z], …]\n"
            "scene.toml:6: triangles must not be empty");
}

TEST_F(SceneFileErrors, of_lights) {
  EXPECT_EQ(errors(material + sphere + "[[lights]]\ncolour = [1, 1]\nintensity = -1\n"),
            "scene.toml:7: a light needs the key \"position\"\n"
            "scene.toml:8: colour must be a colour [red, green, blue], each from 0 to 1000000\n"
            "scene.toml:9: intensity must be a number from 0 to 1000000");
  std::string lights;
  for (int i = 0; i < 64; ++i) lights += "[[lights]]\nposition = [1, 2, 3]\n";
  EXPECT_EQ(load(material + sphere + lights).lights.size(), 64u);
  EXPECT_EQ(errors(material + sphere + lights + "[[lights]]\nposition = [1, 2, 3]\n"),
            "scene.toml:135: 65 lights are too many: 64 are possible");
}

TEST_F(SceneFileErrors, of_files) {
  EXPECT_EQ(errors_of((folder / "none.toml").string()), "none.toml: no scene file that can be read");
  std::filesystem::create_directory(folder / "folder.toml");
  EXPECT_EQ(errors_of((folder / "folder.toml").string()), "folder.toml: no scene file that can be read");
  EXPECT_EQ(errors("a = [1,\n2\n"),
            "scene.toml:2: not TOML: Error while parsing array: encountered end-of-file");
  EXPECT_EQ(
      errors("[[objects]]\nshape = 'mesh'\nfile = 'none.obj'\n[[objects]]\nshape = 'mesh'\nfile = '.'\n"),
      "scene.toml:3: there is no file none.obj\nscene.toml:6: there is no file .");
  (void)write("bad.xyz", "nothing\n");
  const std::string said = errors("[[objects]]\nshape = 'mesh'\nfile = 'bad.xyz'\n");
  EXPECT_TRUE(said.starts_with("scene.toml:3: bad.xyz: ")) << said;
  EXPECT_EQ(said.find('\n'), std::string::npos);
}

TEST_F(SceneFileErrors, stay_on_one_line_and_end_after_a_hundred) {
  EXPECT_EQ(errors("\"a\\nb\" = 1\n" + material + sphere),
            "scene.toml:1: unknown key \"a b\" in a scene; possible: title, background, ambient, camera, "
            "materials, objects, lights");
  std::string bad = "vertices = [\n";
  for (int i = 0; i < 1000; ++i) bad += "0,\n";
  const std::string said = errors(material + "[[objects]]\nshape = 'triangles'\nmaterial = 'm'\n" + bad +
                                  "]\ntriangles = [[0, 1, 2]]\n");
  EXPECT_EQ(std::ranges::count(said, '\n'), 100);
  EXPECT_TRUE(said.ends_with("\nscene.toml:106: and 900 more errors from here on")) << said;
}

TEST_F(SceneFileErrors, control_characters_are_refused) {
  EXPECT_EQ(errors("\n[[\abjects]]\n"), "scene.toml:2: not TOML: a control character");
  EXPECT_EQ(errors(std::string("a = 1\n\n\0", 8)), "scene.toml:3: not TOML: a control character");
}

TEST_F(SceneFileErrors, keys_and_lists_that_nest_endlessly_do_not_overflow_the_stack) {
  const std::string too_many =
      "scene.toml:2: more than 32 dots where one key or value can be; scenes nest three deep";
  std::string key = "a", quoted = "','", list;
  for (int i = 0; i < 100000; ++i) {
    key += ".a";
    quoted += ".\",\\\",\"";
    list += '[';
  }
  EXPECT_EQ(errors("title = 'a.b'\n" + key + " = 1\n"), too_many);
  EXPECT_EQ(errors("title = 'a.b'\n" + quoted + " = 1\n"), too_many);
  EXPECT_NE(errors("a = " + list).find("scene.toml:1: not TOML: "), std::string::npos);
}

}  // namespace
}  // namespace raysweep
