// A config's text as a TOML document, with what --set changes in it.
#pragma once

#include <toml++/toml.h>

#include <string>
#include <vector>

namespace raysweep {

/// Parses `text` and applies the `overrides`, each `KEY=VALUE`: the value as TOML if it is any, as a string
/// otherwise; a bare factor is one of [sweep]. Nodes remember where they came from. Throws RequestError where
/// a text is no TOML.
[[nodiscard]] toml::table read_toml(const std::string& text, const std::string& file,
                                    const std::vector<std::string>& overrides);

/// The document with what was changed in it.
[[nodiscard]] std::string to_text(const toml::table& root);

}  // namespace raysweep
