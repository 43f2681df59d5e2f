#include "tests/tracer/scene_folder.h"
#include "tracer/scene/scenes.h"

namespace raysweep {
namespace {

class MeshMaterials : public SceneFolder {
 public:
  void SetUp() override {
    // A build without Assimp reads no mesh files, and says so.
    if (!why_no_mesh_files().empty()) GTEST_SKIP() << why_no_mesh_files();
  }

  /// The material of a triangle whose MTL says this.
  [[nodiscard]] Material from_mtl(const std::string& text) const {
    (void)write("a.mtl", "newmtl m\n" + text);
    const ImportedMeshes imported =
        load_meshes(write("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n"));
    return imported.materials.at(imported.meshes.at(0).material);
  }

  /// The material of a triangle whose glTF has these `materials`.
  [[nodiscard]] Material from_gltf(const std::string& materials) const {
    const std::string attribute = materials.empty() ? "" : R"(, "material": 0)";
    const ImportedMeshes imported = load_meshes(write("a.gltf", R"({"asset": {"version": "2.0"}, "scene": 0,
      "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
      "meshes": [{"primitives": [{"attributes": {"POSITION": 0})" + attribute +
                                                                    R"(}]}],
      "buffers": [{"byteLength": 36, "uri":
        "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],
      "bufferViews": [{"buffer": 0, "byteLength": 36}],
      "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                     "min": [0, 0, 0], "max": [1, 1, 0]}])" + materials +
                                                                    "}"));
    return imported.materials.at(imported.meshes.at(0).material);
  }
};

void expect_near(const Colour& a, const Colour& b) { EXPECT_LT(max_abs(a - b), 1e-6) << a.x << a.y << a.z; }

void expect_same(const Material& a, const Material& b) {
  EXPECT_EQ(a.ambient, b.ambient);
  EXPECT_EQ(a.diffuse, b.diffuse);
  EXPECT_EQ(a.specular, b.specular);
  EXPECT_EQ(a.k_ambient, b.k_ambient);
  EXPECT_EQ(a.k_diffuse, b.k_diffuse);
  EXPECT_EQ(a.k_specular, b.k_specular);
  EXPECT_EQ(a.exponent, b.exponent);
  EXPECT_EQ(a.k_reflect, b.k_reflect);
  EXPECT_EQ(a.k_refract, b.k_refract);
  EXPECT_EQ(a.ior, b.ior);
}

TEST_F(MeshMaterials, mtl_tells_the_local_model) {
  const Material m = from_mtl("Ka 0.1 0.2 0.3\nKd 0.4 0.5 0.6\nKs 0.7 0.8 0.9\nNs 77\nNi 1.3\n");
  expect_near(m.ambient, {0.1, 0.2, 0.3});
  expect_near(m.diffuse, {0.4, 0.5, 0.6});
  expect_near(m.specular, {0.7, 0.8, 0.9});
  EXPECT_EQ(m.exponent, 77);
  EXPECT_EQ(m.k_ambient, plain_surface().k_ambient);
  EXPECT_EQ(m.k_diffuse, 1);
  EXPECT_EQ(m.k_specular, 1);
  EXPECT_EQ(m.k_reflect, 0);
  EXPECT_EQ(m.k_refract, 0);
  EXPECT_NEAR(m.ior, 1.3, 1e-6);
}

TEST_F(MeshMaterials, mtl_tells_what_passes_through) {
  const Material m = from_mtl("Kd 1 0 0\nKs 1 1 1\nNs 10\nd 0.25\nTf 0.5 0.6 0.7\nNi 1.5\n");
  EXPECT_EQ(m.k_refract, 0.75);
  EXPECT_EQ(m.k_ambient, 0.25 * plain_surface().k_ambient);
  EXPECT_EQ(m.k_diffuse, 0.25);
  EXPECT_EQ(m.k_specular, 0.25);
  expect_near(m.filter, {0.5, 0.6, 0.7});
  EXPECT_EQ(m.ior, 1.5);
}

TEST_F(MeshMaterials, what_mtl_does_not_tell_is_a_plain_choice) {
  const Material m = from_mtl("Kd 0.4 0.5 0.6\n");
  EXPECT_EQ(m.ambient, m.diffuse);
  EXPECT_EQ(m.k_specular, 0) << "Ns 0: no highlight";
  EXPECT_EQ(m.filter, Colour(1, 1, 1));
}

TEST_F(MeshMaterials, absurd_values_are_clamped_or_left_out) {
  const Material m =
      from_mtl("Ka -1 nan 3\nKd -1 0.5 1e30\nKs nan nan nan\nNs 1e30\nd -3\nNi 0\nTf inf 1 1\n");
  EXPECT_EQ(m.diffuse, Colour(0, 0.5, 1));
  EXPECT_EQ(m.exponent, 1e4);
  EXPECT_EQ(m.k_refract, 1);
  EXPECT_EQ(m.ior, 1.5);
  for (const Colour& c : {m.ambient, m.diffuse, m.specular, m.filter}) {
    EXPECT_TRUE(all_finite(c));
    EXPECT_EQ(c, min(max(c, Colour(0, 0, 0)), Colour(1, 1, 1)));
  }
}

TEST_F(MeshMaterials, a_file_without_any_gets_the_plain_surface) {
  const ImportedMeshes obj = load_meshes(write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  ASSERT_EQ(obj.materials.size(), 1u);
  expect_same(obj.materials[0], plain_surface());
  const ImportedMeshes ply = load_meshes(
      write("a.ply",
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
            "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
            "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"));
  expect_same(ply.materials.at(0), plain_surface());
  const ImportedMeshes stl =
      load_meshes(write("a.stl",
                        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
                        "endloop\nendfacet\nendsolid a\n"));
  expect_same(stl.materials.at(0), plain_surface());
  expect_same(from_gltf(""), plain_surface());
}

TEST_F(MeshMaterials, a_missing_mtl_is_no_error) {
  const ImportedMeshes imported =
      load_meshes(write("a.obj", "mtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n"));
  EXPECT_LT(imported.meshes.at(0).material, imported.materials.size());
}

TEST_F(MeshMaterials, gltf_tells_colour_metal_and_transmission) {
  const Material metal = from_gltf(R"(, "materials": [{"name": "a", "pbrMetallicRoughness":
      {"baseColorFactor": [0.5, 0.25, 1, 0.5], "metallicFactor": 0.5, "roughnessFactor": 0}}])");
  EXPECT_EQ(metal.diffuse, Colour(0.5, 0.25, 1));
  EXPECT_EQ(metal.ambient, metal.diffuse);
  EXPECT_EQ(metal.k_reflect, 0.5);
  EXPECT_EQ(metal.k_diffuse, 0.5) << "what is mirrored is not scattered";
  EXPECT_EQ(metal.k_refract, 0) << "alpha counts only where the material blends";
  const Material glass = from_gltf(R"(, "materials": [{"name": "a", "pbrMetallicRoughness":
      {"baseColorFactor": [0.5, 0.25, 1, 1], "metallicFactor": 0},
      "extensions": {"KHR_materials_transmission": {"transmissionFactor": 0.75}}}],
      "extensionsUsed": ["KHR_materials_transmission"])");
  EXPECT_EQ(glass.k_refract, 0.75);
  EXPECT_EQ(glass.filter, Colour(0.5, 0.25, 1));
  const Material veil = from_gltf(R"(, "materials": [{"name": "a", "alphaMode": "BLEND",
      "pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 0.25], "metallicFactor": 0}}])");
  EXPECT_EQ(veil.k_refract, 0.75);
  EXPECT_EQ(veil.filter, Colour(1, 1, 1));
}

TEST_F(MeshMaterials, one_material_for_each_that_is_used) {
  (void)write("a.mtl", "newmtl a\nKd 1 0 0\nnewmtl unused\nKd 0 1 0\nnewmtl b\nKd 0 0 1\n");
  const ImportedMeshes imported = load_meshes(write(
      "a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl b\nf 1 2 3\nusemtl a\nf 3 2 1\nf 1 3 2\n"));
  ASSERT_EQ(imported.meshes.size(), 2u);
  EXPECT_EQ(imported.materials.size(), 2u);
  for (const Mesh& mesh : imported.meshes) {
    const Colour& colour = imported.materials.at(mesh.material).diffuse;
    EXPECT_EQ(colour, mesh.triangles.size() == 2 ? Colour(1, 0, 0) : Colour(0, 0, 1));
  }
}

TEST_F(MeshMaterials, in_scene_files_meshes_lie_beside_them_and_bring_their_own_or_take_the_given) {
  std::filesystem::create_directory(folder / "meshes");
  (void)write("meshes/a.mtl", "newmtl a\nKd 1 0 0\n");
  (void)write("meshes/a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n");
  const Scene scene = load(
      "[materials.m]\n[materials.n]\n[[objects]]\nshape = 'mesh'\nfile = 'meshes/a.obj'\n"
      "[[objects]]\nshape = 'mesh'\nfile = 'meshes/a.obj'\nmaterial = 'n'\nscale = 2\n"
      "rotate = [0, 0, 90]\ntranslate = [0, 0, 5]\n");
  ASSERT_EQ(scene.meshes.size(), 2u);
  EXPECT_EQ(scene.materials.size(), 3u);
  EXPECT_EQ(scene.meshes[0].material, 2u);
  EXPECT_EQ(scene.materials[2].diffuse, Colour(1, 0, 0));
  EXPECT_EQ(scene.meshes[1].material, 1u);
  EXPECT_NEAR(length(scene.meshes[1].vertices.at(1) - Vec3f(0, 2, 5)), 0, 1e-6);
}

}  // namespace
}  // namespace raysweep
