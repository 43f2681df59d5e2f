#include "tracer/scene/scene_file.h"

#include <fmt/format.h>

#include <fstream>
#include <numbers>
#include <sstream>

#include "tracer/scene/scene_file_objects.h"
#include "tracer/scene/scene_file_values.h"
#include "tracer/settings.h"

namespace raysweep {

namespace {

/// TOML has no control characters but these, yet not every version of toml++ survives others.
bool is_control(char c) {
  const auto code = static_cast<unsigned char>(c);  // of UTF-8, whether or not this machine's char has a sign
  return (code < ' ' && c != '\t' && c != '\n' && c != '\r') || code == 127;
}

/// `a.b.c.d` is a table in a table in a table: without a limit a file of some kilobytes nests until the stack
/// overflows. Scenes nest three deep. Counts dots outside of quotes and comments, up to what can end a key.
void refuse_what_crashes_the_parser(const std::string& text, const std::string& file) {
  constexpr int deepest = 32;
  int line = 1, dots = 0;
  char previous = '\n', quote = 0;
  bool comment = false;
  for (const char c : text) {
    if (is_control(c)) throw SceneError(fmt::format("{}:{}: not TOML: a control character", file, line));
    if (c == '#' && !quote) comment = true;
    if (c == '\n') comment = false;
    if (comment) continue;
    const bool escaped = quote == '"' && previous == '\\';
    if ((c == '"' || c == '\'') && (!quote || (c == quote && !escaped))) quote = quote ? '\0' : c;
    if (c == '\n') {
      ++line;
      quote = 0;  // strings of more lines than one are no keys
    }
    if (!quote && std::string_view("\n,=[]{}").find(c) != std::string_view::npos) dots = 0;
    if (!quote && c == '.' && previous != '.' && ++dots > deepest) {
      throw SceneError(
          fmt::format("{}:{}: more than {} dots where one key or value can be; scenes nest three "
                      "deep",
                      file, line, deepest));
    }
    previous = escaped ? '\0' : c;
  }
}

toml::table read_toml(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream buffer;
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error) || !in || (buffer << in.rdbuf(), !in.good())) {
    throw SceneError(fmt::format("{}: no scene file that can be read", file));
  }
  const std::string text = std::move(buffer).str();
  refuse_what_crashes_the_parser(text, file);
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& problem) {
    throw SceneError(
        fmt::format("{}:{}: not TOML: {}", file, problem.source().begin.line, problem.description()));
  }
}

Material read_material(const SceneTable& table) {
  table.check_keys({}, {"colour", "ambient", "diffuse", "specular", "k_ambient", "k_diffuse", "k_specular",
                        "exponent", "k_reflect", "k_refract", "filter", "ior", "fresnel", "priority"});
  Material m;
  if (const auto colour = table.colour("colour")) m.ambient = m.diffuse = *colour;
  m.ambient = table.colour("ambient").value_or(m.ambient);
  m.diffuse = table.colour("diffuse").value_or(m.diffuse);
  m.specular = table.colour("specular").value_or(m.specular);
  m.k_ambient = table.number("k_ambient", light_range).value_or(m.k_ambient);
  m.k_diffuse = table.number("k_diffuse", light_range).value_or(m.k_diffuse);
  m.k_specular = table.number("k_specular", light_range).value_or(m.k_specular);
  m.exponent = table.number("exponent", light_range).value_or(m.exponent);
  m.k_reflect = table.number("k_reflect", light_range).value_or(m.k_reflect);
  m.k_refract = table.number("k_refract", light_range).value_or(m.k_refract);
  m.filter = table.colour("filter").value_or(m.filter);
  m.ior = table.number("ior", {1e-6, 1e6}).value_or(m.ior);
  m.fresnel = table.flag("fresnel").value_or(m.fresnel);
  m.priority = table.integer("priority", {-1e6, 1e6}).value_or(m.priority);
  if (const std::string problem = problem_of(m); !problem.empty())
    table.fail(table.node("filter") && problem.starts_with("filter") ? "filter" : "k_reflect", problem);
  return m;
}

Camera read_camera(const SceneTable& table) {
  table.check_keys({"position", "target"}, {"up", "field_of_view"});
  Camera camera;
  const auto position = table.point("position"), target = table.point("target");
  camera.position = position.value_or(camera.position);
  camera.target = target.value_or(camera.target);
  const auto up = table.node("up") ? table.direction("up") : std::optional(camera.up);
  camera.up = up.value_or(camera.up);
  const double field_of_view = table.number("field_of_view", {0, 180, true}).value_or(40);
  camera.half_angle = field_of_view / 2 * (std::numbers::pi / 180);
  if (position && target) {
    constexpr double nearest = 1e-100;   // the square of what is nearer is 0 soon
    constexpr double least_sine = 1e-9;  // leaves half of a double's digits for the direction to the right
    const Vec3d forward = camera.target - camera.position;
    if (length(forward) < nearest) {
      table.fail("target", "target must be another point than position");
    } else if (up && length(cross(normalize(forward), camera.up)) < least_sine) {
      table.fail("up", "up must not be parallel to the direction from position to target");
    }
  }
  return camera;
}

Light read_light(const SceneTable& table) {
  table.check_keys({"position"}, {"colour", "intensity"});
  return {table.point("position").value_or(Vec3d()), table.colour("colour").value_or(Colour(1, 1, 1)) *
                                                         table.number("intensity", light_range).value_or(1)};
}

/// Walks the document from top to bottom.
class SceneReader {
 public:
  SceneReader(const toml::table& root, std::string file)
      : file_(std::move(file)), errors_(file_), root_(root, "a scene", errors_) {}

  Scene read() {
    root_.check_keys({}, {"title", "background", "ambient", "camera", "materials", "objects", "lights"});
    scene_.name = root_.text("title").value_or(file_);
    scene_.background = root_.colour("background").value_or(scene_.background);
    scene_.ambient = root_.colour("ambient").value_or(scene_.ambient);
    read_materials();
    read_objects();
    read_lights();
    read_or_frame_camera();
    errors_.throw_any();
    return std::move(scene_);
  }

 private:
  const toml::table* as_table(const toml::node& node, std::string_view name, std::string_view written) {
    if (!node.is_table()) errors_.add(node, fmt::format("{} must be a table: {}", name, written));
    return node.as_table();
  }

  void read_materials() {
    const toml::node* const node = root_.node("materials");
    const toml::table* const all = node ? as_table(*node, "materials", "[materials.NAME]") : nullptr;
    if (!all) return;
    for (const auto& [name, value] : *all) {
      materials_.emplace(name.str(), static_cast<uint32_t>(scene_.materials.size()));
      const auto* const table = as_table(value, name.str(), fmt::format("[materials.{}]", name.str()));
      scene_.materials.push_back(
          table ? read_material({*table, fmt::format("material \"{}\"", name.str()), errors_}) : Material());
    }
  }

  void read_objects() {
    const SceneObjects objects{scene_, materials_, std::filesystem::path(file_).parent_path()};
    const auto list = root_.list("objects", "a list of tables: [[objects]]");
    for (const toml::node* const node : list) {
      if (const auto* const table = as_table(*node, "an object", "[[objects]]"))
        add_object(*table, objects, errors_);
    }
    const toml::node* const node = root_.node("objects");
    if (list.empty() && (!node || node->is_array()))
      root_.fail("objects", "a scene needs an object at least: [[objects]]");
  }

  void read_lights() {
    const auto list = root_.list("lights", "a list of tables: [[lights]]");
    for (const toml::node* const node : list) {
      if (const auto* const table = as_table(*node, "a light", "[[lights]]"))
        scene_.lights.push_back(read_light({*table, "a light", errors_}));
    }
    const auto most = static_cast<size_t>(lights_range.high);
    if (list.size() > most)
      errors_.add(*list[most], fmt::format("{} lights are too many: {} are possible", list.size(), most));
  }

  void read_or_frame_camera() {
    if (const toml::node* const node = root_.node("camera")) {
      if (const auto* const table = as_table(*node, "camera", "[camera]"))
        scene_.camera = read_camera({*table, "a camera", errors_});
      return;
    }
    Box<double> box;
    for (const Mesh& mesh : scene_.meshes) box.include(bounds_of(mesh));
    for (const Sphere& s : scene_.spheres) {
      const Vec3d radius(s.radius, s.radius, s.radius);
      box.include(s.centre - radius);
      box.include(s.centre + radius);
    }
    if (box.lower().x <= box.upper().x) {
      scene_.camera = framing_camera(box);
    } else if (!scene_.planes.empty()) {
      root_.fail("objects", "planes have no end to frame: add a [camera]");
    }
  }

  const std::string file_;
  SceneErrors errors_;
  const SceneTable root_;
  Scene scene_;
  std::map<std::string, uint32_t, std::less<>> materials_;  // names to places in `scene_.materials`
};

}  // namespace

Scene load_scene_file(const std::string& file) {
  const toml::table root = read_toml(file);
  return SceneReader(root, file).read();
}

}  // namespace raysweep
