// Mesh files through Assimp.
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/core.h>

#include <assimp/Importer.hpp>

#include "tracer/scene/scenes.h"

namespace raysweep {

namespace {

Mesh convert(const aiMesh& source, const std::string& file) {
  Mesh mesh;
  mesh.name = source.mName.C_Str();
  for (unsigned i = 0; i < source.mNumVertices; ++i) {
    const aiVector3D& v = source.mVertices[i];
    mesh.vertices.emplace_back(v.x, v.y, v.z);
    if (!all_finite(mesh.vertices.back())) {
      throw SceneError(fmt::format("{}: vertex {} of mesh \"{}\" is not finite ({}, {}, {}); every coordinate must be "
                                   "a finite number",
                                   file, i, mesh.name, v.x, v.y, v.z));
    }
  }
  for (unsigned i = 0; i < source.mNumFaces; ++i) {
    const aiFace& face = source.mFaces[i];
    if (face.mNumIndices != 3) continue;  // points and lines have no surface
    for (unsigned k = 0; k < 3; ++k) {
      if (face.mIndices[k] >= source.mNumVertices) {
        throw SceneError(fmt::format("{}: face {} of mesh \"{}\" names vertex {}, but the mesh has {} vertices", file,
                                     i, mesh.name, face.mIndices[k], source.mNumVertices));
      }
    }
    mesh.triangles.push_back({face.mIndices[0], face.mIndices[1], face.mIndices[2]});
  }
  return mesh;
}

}  // namespace

std::vector<Mesh> load_meshes(const std::string& file) {
  Assimp::Importer importer;
  // PreTransformVertices places every mesh where its file's scene graph puts it.
  const aiScene* scene =
      importer.ReadFile(file, aiProcess_Triangulate | aiProcess_PreTransformVertices | aiProcess_JoinIdenticalVertices);
  if (!scene) throw SceneError(fmt::format("{}: cannot be read as a mesh: {}", file, importer.GetErrorString()));
  std::vector<Mesh> meshes;
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) {
    Mesh mesh = convert(*scene->mMeshes[i], file);
    if (!mesh.triangles.empty()) meshes.push_back(std::move(mesh));
  }
  if (meshes.empty()) throw SceneError(file + ": holds no triangles");
  return meshes;
}

std::string why_no_mesh_files() { return {}; }

}  // namespace raysweep
