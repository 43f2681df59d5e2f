#include "tracer/scene/scene_file_objects.h"

#include <fmt/format.h>

#include "tracer/scene/chair.h"
#include "tracer/scene/scenes.h"
#include "tracer/scene/shapes.h"

namespace raysweep {

namespace {

/// The place of the material that `key` names; 0 where it is missing or unknown.
uint32_t material(const SceneTable& object, std::string_view key, const SceneObjects& objects) {
  const auto name = object.text(key);
  if (!name) return 0;
  if (const auto found = objects.materials.find(*name); found != objects.materials.end())
    return found->second;
  std::string known;
  for (const auto& [other, place] : objects.materials) known += (known.empty() ? "" : ", ") + other;
  object.fail(key, fmt::format("unknown {} \"{}\"; possible: {}", key, *name,
                               known.empty() ? "none, for there are no [materials.NAME]" : known));
  return 0;
}

Placement placement(const SceneTable& object) {
  return {object.number("scale", size_range).value_or(1), object.angles("rotate").value_or(Vec3d()),
          object.point("translate").value_or(Vec3d())};
}

/// Puts the meshes where the object says and adds them to the scene.
void add_placed(const SceneTable& object, std::vector<Mesh> meshes, const SceneObjects& objects) {
  const Placement place = placement(object);
  for (Mesh& mesh : meshes) {
    transform(mesh, place);
    const bool inside = std::ranges::all_of(mesh.vertices, [](const Vec3f& v) {
      return all_finite(v) && max_abs(Vec3d(v)) <= coordinate_range.high;
    });
    if (!inside) {
      object.fail("scale", fmt::format("scaled and moved, mesh \"{}\" reaches beyond {:.7g}", mesh.name,
                                       coordinate_range.high));
      return;
    }
    objects.scene.meshes.push_back(std::move(mesh));
  }
}

void add_sphere(const SceneTable& object, const SceneObjects& objects) {
  objects.scene.spheres.push_back({object.point("centre").value_or(Vec3d()),
                                   object.number("radius", size_range).value_or(1),
                                   material(object, "material", objects)});
}

void add_plane(const SceneTable& object, const SceneObjects& objects) {
  const Vec3d normal = object.direction("normal").value_or(Vec3d(0, 1, 0));
  const double offset = -dot(normal, object.point("point").value_or(Vec3d()));
  objects.scene.planes.push_back({normal, offset, material(object, "material", objects)});
}

void add_box(const SceneTable& object, const SceneObjects& objects) {
  const auto lower = object.point("lower"), upper = object.point("upper");
  const auto rotate = object.angles("rotate");
  Mesh mesh;
  mesh.name = "box";
  mesh.material = material(object, "material", objects);
  if (lower && upper) {
    const Vec3f a(*lower), b(*upper);  // as the mesh holds them
    if (!(a.x < b.x && a.y < b.y && a.z < b.z)) {
      object.fail("lower", "lower must be below upper on every axis, by more than floats round");
      return;
    }
    if (rotate) {
      const Vec3d half_size = 0.5 * (*upper - *lower), centre = 0.5 * (*lower + *upper);
      append_box(mesh, -half_size, half_size);
      transform(mesh, {.scale = 1, .rotate = *rotate, .translate = centre});
    } else {
      append_box(mesh, *lower, *upper);
    }
  }
  objects.scene.meshes.push_back(std::move(mesh));
}

/// Three indices below `vertex_count`.
std::optional<std::array<uint32_t, 3>> triangle_of(const toml::node& node, size_t vertex_count) {
  const toml::array* const list = node.as_array();
  if (!list || list->size() != 3) return std::nullopt;
  std::array<uint32_t, 3> corners{};
  for (size_t i = 0; i < 3; ++i) {
    const auto index = (*list)[i].value_exact<int64_t>();
    if (!index || *index < 0 || static_cast<uint64_t>(*index) >= vertex_count) return std::nullopt;
    corners[i] = static_cast<uint32_t>(*index);
  }
  return corners;
}

void add_triangles(const SceneTable& object, const SceneObjects& objects) {
  Mesh mesh;
  mesh.name = "triangles";
  mesh.material = material(object, "material", objects);
  for (const toml::node* const node : object.list("vertices", "a list of points [[x, y, z], …]")) {
    const auto vertex = vector_of(*node, coordinate_range);
    if (!vertex) {
      object.errors().add(*node,
                          fmt::format("vertex {} must be three numbers [x, y, z], each from {:.7g} to {:.7g}",
                                      mesh.vertices.size(), coordinate_range.low, coordinate_range.high));
    }
    mesh.vertices.emplace_back(vertex.value_or(Vec3d()));
  }
  size_t number = 0;
  for (const toml::node* const node : object.list("triangles", "a list of triangles [[a, b, c], …]")) {
    if (const auto corners = triangle_of(*node, mesh.vertices.size())) {
      mesh.triangles.push_back(*corners);
    } else {
      object.errors().add(*node, fmt::format("triangle {} must be the numbers of three of the {} vertices, "
                                             "counted from 0",
                                             number, mesh.vertices.size()));
    }
    ++number;
  }
  if (object.node("triangles") && number == 0) object.fail("triangles", "triangles must not be empty");
  objects.scene.meshes.push_back(std::move(mesh));
}

void add_mesh(const SceneTable& object, const SceneObjects& objects) {
  const bool own_materials = !object.node("material");
  const uint32_t given = material(object, "material", objects);
  const auto name = object.text("file");
  ImportedMeshes imported;
  if (name) {
    const std::filesystem::path file = objects.folder / *name;
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) {
      object.fail("file", fmt::format("there is no file {}", file.string()));
    } else {
      try {
        imported = load_meshes(file.string());
      } catch (const SceneError& problem) {
        object.fail("file", problem.what());
      }
    }
  }
  auto& materials = objects.scene.materials;
  const auto first = static_cast<uint32_t>(materials.size());
  if (own_materials) materials.insert(materials.end(), imported.materials.begin(), imported.materials.end());
  for (Mesh& mesh : imported.meshes) mesh.material = own_materials ? first + mesh.material : given;
  add_placed(object, std::move(imported.meshes), objects);
}

void add_chair(const SceneTable& object, const SceneObjects& objects) {
  Chair chair = make_chair();
  chair.frame.material = material(object, "material", objects);
  chair.seat.material =
      object.node("seat_material") ? material(object, "seat_material", objects) : chair.frame.material;
  std::vector<Mesh> meshes;
  meshes.push_back(std::move(chair.frame));
  meshes.push_back(std::move(chair.seat));
  add_placed(object, std::move(meshes), objects);
}

struct Shape {
  std::string_view name, what;
  SceneTable::Keys needed, optional;
  void (*add)(const SceneTable& object, const SceneObjects& objects);
};

/// The one list of shapes.
const std::vector<Shape>& shapes() {
  static const std::vector<Shape> list{
      {"sphere", "a sphere", {"centre", "radius", "material"}, {}, add_sphere},
      {"plane", "a plane", {"normal", "point", "material"}, {}, add_plane},
      {"box", "a box", {"lower", "upper", "material"}, {"rotate"}, add_box},
      {"triangles", "triangles", {"vertices", "triangles", "material"}, {}, add_triangles},
      {"mesh", "a mesh", {"file"}, {"material", "scale", "rotate", "translate"}, add_mesh},
      {"chair", "a chair", {"material"}, {"seat_material", "scale", "rotate", "translate"}, add_chair}};
  return list;
}

}  // namespace

void add_object(const toml::table& table, const SceneObjects& objects, SceneErrors& errors) {
  const SceneTable object(table, "an object", errors);
  const auto name = object.text("shape");
  std::string known;
  for (const Shape& shape : shapes()) {
    if (name == shape.name) {
      const SceneTable shaped(table, std::string(shape.what), errors);
      SceneTable::Keys optional = shape.optional;
      optional.emplace_back("shape");
      shaped.check_keys(shape.needed, optional);
      shape.add(shaped, objects);
      return;
    }
    known += fmt::format("{}{}", known.empty() ? "" : ", ", shape.name);
  }
  if (name) {
    object.fail("shape", fmt::format("unknown shape \"{}\"; possible: {}", *name, known));
  } else if (!object.node("shape")) {
    object.fail("shape", fmt::format("an object needs the key \"shape\"; possible: {}", known));
  }
}

}  // namespace raysweep
