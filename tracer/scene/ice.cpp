#include "tracer/scene/ice.h"

#include "tracer/scene/rounded_box.h"

namespace raysweep {

namespace {

enum : uint32_t { ice, air, liquid, slate, wall, red, yellow, blue };

/// Lights are seen on the ice alone; what is inside has nothing to shade.
Material clear(double ior, const Colour& filter, int priority) {
  return {.k_ambient = 0,
          .k_diffuse = 0,
          .k_specular = 0,
          .k_refract = 0.97,
          .filter = filter,
          .ior = ior,
          .fresnel = true,
          .priority = priority};
}

Material matt(const Colour& colour, double k_reflect, double k_specular = 0.2) {
  return {.ambient = colour,
          .diffuse = colour,
          .specular = {1, 1, 1},
          .k_ambient = 0.2,
          .k_diffuse = 0.8,
          .k_specular = k_specular,
          .exponent = 60,
          .k_reflect = k_reflect};
}

/// Shallow hollows as melting leaves them: a few waves that do not repeat over the block.
double melt(const Vec3d& p) {
  return 0.011 * std::sin(5.3 * p.x + 2.1 * p.y) * std::sin(4.1 * p.z - 3.3 * p.y + 0.7) +
         0.008 * std::sin(7.9 * p.y + 1.3) * std::sin(6.7 * p.x - 5.9 * p.z);
}

Mesh block(const char* name, const RoundedBox& shape, uint32_t material) {
  Mesh mesh;
  mesh.name = name;
  mesh.material = material;
  append_rounded_box(mesh, shape);
  return mesh;
}

/// Bubbles rise in strings while water freezes, and gather around the middle, where it freezes last.
void add_bubbles(Scene& scene) {
  constexpr int count = 46;
  for (int i = 0; i < count; ++i) {
    // Three additive recurrences of the plastic number's family (Roberts 2018) spread points evenly.
    const auto fraction = [i](double step) { return std::fmod(0.5 + step * i, 1.0); };
    const double u = fraction(0.8191725134), v = fraction(0.6710436067), w = fraction(0.5497004779);
    // In the walls: between the hollow and the faces.
    const double side = i % 2 == 0 ? -1 : 1;
    const Vec3d at = i % 4 < 2 ? Vec3d(side * (0.47 + 0.06 * w), 0.2 + 0.8 * u, 0.85 * v - 0.42)
                               : Vec3d(0.95 * u - 0.47, 0.09 + 0.09 * w + 0.1 * v * w, 0.8 * v - 0.4);
    scene.spheres.push_back({at, 0.006 + 0.016 * w * w, air});
  }
}

}  // namespace

Scene make_ice(int light_count) {
  Scene scene;
  scene.name = "ice";
  scene.materials.resize(8);
  scene.materials[ice] = clear(1.31, {0.95, 0.985, 1.0}, 0);
  scene.materials[ice].k_ambient = 0.01;
  scene.materials[ice].k_specular = 0.7;
  scene.materials[ice].exponent = 300;
  scene.materials[air] = clear(1.0, {1, 1, 1}, 1);
  scene.materials[liquid] = clear(1.333, {0.98, 0.50, 0.22}, 2);
  scene.materials[slate] = matt({0.42, 0.43, 0.45}, 0.16, 0);
  scene.materials[wall] = matt({0.62, 0.76, 0.90}, 0, 0);
  scene.materials[red] = matt({0.80, 0.10, 0.07}, 0.05);
  scene.materials[yellow] = matt({0.95, 0.62, 0.08}, 0.05);
  scene.materials[blue] = matt({0.06, 0.22, 0.60}, 0.1);

  scene.planes = {{{0, 1, 0}, 0, slate}, {{0, 0, 1}, 3.5, wall}};
  scene.meshes = {block("ice", {{-0.6, 0.002, -0.55}, {0.6, 1.2, 0.55}, 0.11, 2, 3, melt}, ice),
                  block("hollow", {{-0.4, 0.22, -0.36}, {0.4, 1.0, 0.36}, 0.10, 2, 3, {}}, air),
                  // A little larger than the hollow that holds it: where both overlap, priority decides, and
                  // no gap is left.
                  block("liquid", {{-0.402, 0.218, -0.362}, {0.402, 0.68, 0.362}, 0.1, 2, 3, {}}, liquid)};
  add_bubbles(scene);
  scene.spheres.insert(scene.spheres.end(), {{{-0.95, 0.3, -0.9}, 0.3, red},
                                             {{0.95, 0.22, -0.75}, 0.22, yellow},
                                             {{0.15, 0.35, -1.7}, 0.35, blue}});
  scene.background = {0.55, 0.66, 0.78};
  scene.camera = {.position = {-1.25, 1.5, 3.3}, .target = {0.02, 0.52, 0}, .half_angle = 0.27};
  scene.lights = light_dome(light_count, {0, 0.5, 0}, 5);
  return scene;
}

}  // namespace raysweep
