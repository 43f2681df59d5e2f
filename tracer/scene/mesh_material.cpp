#include "tracer/scene/mesh_material.h"

#include <assimp/GltfMaterial.h>

#include <optional>
#include <string_view>

#include "tracer/scene/scenes.h"

namespace raysweep {

namespace {

/// The parameters of both are what the macros AI_MATKEY_… stand for.
std::optional<double> number(const aiMaterial& source, const char* key, unsigned type, unsigned index) {
  float value = 0;
  if (source.Get(key, type, index, value) != aiReturn_SUCCESS || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// A number that is a share: 0 to 1.
std::optional<double> share(const aiMaterial& source, const char* key, unsigned type, unsigned index) {
  const std::optional<double> value = number(source, key, type, index);
  return value ? std::optional(std::clamp(*value, 0.0, 1.0)) : std::nullopt;
}

std::optional<Colour> colour(const aiMaterial& source, const char* key, unsigned type, unsigned index) {
  aiColor3D value;
  if (source.Get(key, type, index, value) != aiReturn_SUCCESS) return std::nullopt;
  const Colour told(value.r, value.g, value.b);
  if (!all_finite(told)) return std::nullopt;
  return min(max(told, Colour(0, 0, 0)), Colour(1, 1, 1));
}

/// Black where it would make a colour meaningless is how formats say "not told".
std::optional<Colour> not_black(const std::optional<Colour>& colour) {
  return colour && max_abs(*colour) > 0 ? colour : std::nullopt;
}

/// Assimp invents a material where a file has none: a named one, a nameless one of one colour (PLY, OFF), or,
/// for glTF, a nameless one with that format's defaults, which are a mirror's.
bool is_invented(const aiMaterial& source) {
  const aiString written = source.GetName();
  const std::string_view name = written.C_Str();
  if (!name.empty()) return name == AI_DEFAULT_MATERIAL_NAME;
  const auto base = colour(source, AI_MATKEY_BASE_COLOR);
  if (!base) return !number(source, AI_MATKEY_SHININESS);
  return base == Colour(1, 1, 1) && number(source, AI_MATKEY_METALLIC_FACTOR) == 1 &&
         number(source, AI_MATKEY_ROUGHNESS_FACTOR) == 1 && !source.GetTextureCount(aiTextureType_BASE_COLOR);
}

/// A rough metal mirrors nothing sharply. Where a texture tells of metal and roughness, the factors alone
/// mean nothing.
double mirrored(const aiMaterial& source) {
  if (const auto told = share(source, AI_MATKEY_REFLECTIVITY)) {
    return *told * max_abs(colour(source, AI_MATKEY_COLOR_REFLECTIVE).value_or(Colour(1, 1, 1)));
  }
  if (source.GetTextureCount(aiTextureType_METALNESS) || source.GetTextureCount(aiTextureType_UNKNOWN))
    return 0;
  return share(source, AI_MATKEY_METALLIC_FACTOR).value_or(0) *
         (1 - share(source, AI_MATKEY_ROUGHNESS_FACTOR).value_or(0));
}

/// glTF's alpha counts only where the material is said to blend.
double opacity(const aiMaterial& source) {
  aiString alpha_mode;
  if (source.Get(AI_MATKEY_GLTF_ALPHAMODE, alpha_mode) == aiReturn_SUCCESS &&
      std::string_view(alpha_mode.C_Str()) != "BLEND")
    return 1;
  return share(source, AI_MATKEY_OPACITY).value_or(1);
}

void take_local_model(Material& material, const aiMaterial& source) {
  auto diffuse = colour(source, AI_MATKEY_COLOR_DIFFUSE);
  if (!diffuse) diffuse = colour(source, AI_MATKEY_BASE_COLOR);
  if (diffuse) {
    material.diffuse = *diffuse;
    material.k_diffuse = 1;
  }
  material.ambient = not_black(colour(source, AI_MATKEY_COLOR_AMBIENT)).value_or(material.diffuse);
  if (const auto specular = colour(source, AI_MATKEY_COLOR_SPECULAR)) {
    material.specular = *specular;
    material.k_specular = 1;
  }
  if (const auto shininess = number(source, AI_MATKEY_SHININESS)) {
    constexpr double sharpest = 1e4;  // the largest that renderers write; a highlight narrower than a pixel
    if (*shininess > 0) {
      material.exponent = std::min(*shininess, sharpest);
    } else {
      material.k_specular = 0;  // Assimp's word for "no highlight"
    }
  }
}

}  // namespace

Material take_over(const aiMaterial& source) {
  Material material = plain_surface();
  if (is_invented(source)) return material;
  take_local_model(material, source);

  const double transmission = share(source, AI_MATKEY_TRANSMISSION_FACTOR).value_or(0);
  const double opaque = opacity(source) * (1 - transmission);
  material.k_refract = 1 - opaque;
  material.k_reflect = std::min(mirrored(source), opaque);  // no more than is left
  // What is mirrored or passes through is no longer there to be scattered.
  material.k_ambient *= opaque * (1 - material.k_reflect);
  material.k_diffuse *= opaque * (1 - material.k_reflect);
  material.k_specular *= opaque;

  const std::optional<double> ior = number(source, AI_MATKEY_REFRACTI);
  if (ior && *ior >= 0.1 && *ior <= 10) material.ior = *ior;
  // Formats that transmit tint what passes with their base colour; those that blend have a colour for it.
  const Colour tint = transmission > 0 ? material.diffuse : Colour(1, 1, 1);
  material.filter = not_black(colour(source, AI_MATKEY_COLOR_TRANSPARENT)).value_or(tint);
  return material;
}

}  // namespace raysweep
