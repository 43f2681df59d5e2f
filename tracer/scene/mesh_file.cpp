// Mesh files through Assimp.
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/core.h>

#include <assimp/Importer.hpp>
#include <fstream>
#include <map>
#include <span>

#include "tracer/scene/mesh_material.h"
#include "tracer/scene/scenes.h"

namespace raysweep {

namespace {

/// Throws for what no later step may see: vertices that are not finite, indices that point outside.
void check(const aiMesh& mesh, const std::string& file) {
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    const aiVector3D& v = mesh.mVertices[i];
    if (!all_finite(Vec3f(v.x, v.y, v.z))) {
      throw SceneError(
          fmt::format("{}: vertex {} of mesh \"{}\" is not finite ({}, {}, {}); every coordinate must be "
                      "a finite number",
                      file, i, mesh.mName.C_Str(), v.x, v.y, v.z));
    }
  }
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
    for (const unsigned index : std::span(mesh.mFaces[i].mIndices, mesh.mFaces[i].mNumIndices)) {
      if (index >= mesh.mNumVertices) {
        throw SceneError(
            fmt::format("{}: face {} of mesh \"{}\" names vertex {}, but the mesh has {} vertices", file, i,
                        mesh.mName.C_Str(), static_cast<int>(index), mesh.mNumVertices));
      }
    }
  }
}

Mesh convert(const aiMesh& source) {
  Mesh mesh;
  mesh.name = source.mName.C_Str();
  for (const aiVector3D& v : std::span(source.mVertices, source.mNumVertices))
    mesh.vertices.emplace_back(v.x, v.y, v.z);
  for (const aiFace& face : std::span(source.mFaces, source.mNumFaces)) {
    if (face.mNumIndices != 3) continue;  // points and lines have no surface
    mesh.triangles.push_back({face.mIndices[0], face.mIndices[1], face.mIndices[2]});
  }
  return mesh;
}

Material material_of(const aiScene& scene, unsigned index) {
  const bool there = index < scene.mNumMaterials && scene.mMaterials[index];
  return there ? take_over(*scene.mMaterials[index]) : plain_surface();
}

/// Assimp 5.2 reads on for ever where a PLY header has no end.
void refuse_endless_ply_header(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::string line;
  if (!std::getline(in, line) || !line.starts_with("ply")) return;
  while (std::getline(in, line)) {
    if (line.starts_with("end_header")) return;
  }
  throw SceneError(file + ": cannot be read as a mesh: its PLY header has no end_header");
}

}  // namespace

ImportedMeshes load_meshes(const std::string& file) {
  refuse_endless_ply_header(file);
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(file, 0);
  if (!scene)
    throw SceneError(fmt::format("{}: cannot be read as a mesh: {}", file, importer.GetErrorString()));
  for (const aiMesh* mesh : std::span(scene->mMeshes, scene->mNumMeshes)) check(*mesh, file);
  // After the check: these steps follow indices. PreTransformVertices places every mesh where the file's
  // scene graph puts it.
  scene = importer.ApplyPostProcessing(aiProcess_Triangulate | aiProcess_PreTransformVertices);
  if (!scene)
    throw SceneError(fmt::format("{}: cannot be triangulated: {}", file, importer.GetErrorString()));
  ImportedMeshes imported;
  std::map<unsigned, uint32_t> taken;  // Assimp's index of a material to ours
  for (const aiMesh* source : std::span(scene->mMeshes, scene->mNumMeshes)) {
    check(*source, file);  // a transformation may overflow
    Mesh mesh = convert(*source);
    if (mesh.triangles.empty()) continue;
    const auto [place, is_new] =
        taken.try_emplace(source->mMaterialIndex, static_cast<uint32_t>(imported.materials.size()));
    if (is_new) imported.materials.push_back(material_of(*scene, source->mMaterialIndex));
    mesh.material = place->second;
    imported.meshes.push_back(std::move(mesh));
  }
  if (imported.meshes.empty()) throw SceneError(file + ": holds no triangles");
  return imported;
}

std::string why_no_mesh_files() { return {}; }

}  // namespace raysweep
